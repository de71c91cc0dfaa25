"""From a spec to the context its templates see: parse, check, complete.

Nothing here knows Copier but `merge`, which an update needs and a render does not. Nothing names
a tag or an attribute: those stand in the dictionary of a model. Every fault a user can cause is a
`SpecError`, whose text is all the user needs to see.
"""

from . import changes, faults, model, names, package, ros

__all__ = ["changes", "faults", "model", "names", "package", "ros"]
