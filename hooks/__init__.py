"""From a spec to the context its templates see: parse, check, complete.

Nothing here knows Copier: `extensions/spec.py` does, alone. Tags and attributes are in the
dictionary of a model; the hook itself has but `package`, `depend` and `was`. Every fault a user
can cause is a `SpecError`, whose text is all the user needs to see. The decisions that comments
name are in docs/decisions of the collection.
"""

from . import faults, model, names, package, ros, run, specs, steps, templates

__all__ = ["faults", "model", "names", "package", "ros", "run", "specs", "steps", "templates"]
