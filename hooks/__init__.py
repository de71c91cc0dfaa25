"""From a spec to the context its templates see: parse, check, complete.

Only `merge`, which updates and recopies run, uses Copier. Tags and attributes are in the
dictionary of a model; the hook itself has but `package`, `depend` and `was`. Every fault a user
can cause is a `SpecError`, whose text is all the user needs to see. The decisions that comments
name are in docs/decisions of the collection.
"""

from . import changes, faults, installed, model, names, package, questions, ros, trees

__all__ = [
    "changes",
    "faults",
    "installed",
    "model",
    "names",
    "package",
    "questions",
    "ros",
    "trees",
]
