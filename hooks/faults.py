"""Faults in a spec or in a model, said so that a user can mend them."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence

_LONGEST = 60
_MOST = 20


class SpecError(Exception):
    """A fault of the spec or the model; the text names file, line, fault and remedy."""


def shown(text: str, longest: int = _LONGEST) -> str:
    """Return a text fit for a message: not too long, and with nothing that a terminal obeys."""
    short = text if len(text) <= longest else f"{text[:longest]}..."
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in short)


def quoted(text: str) -> str:
    """Return a text of the user's in quotes, fit for a message."""
    return f'"{shown(text)}"'


def first_of(faults: Sequence[str]) -> str:
    """Return a line for each fault, but for those that are too many to read."""
    more = [f"... and {len(faults) - _MOST} more"] if len(faults) > _MOST else []
    return "\n".join([*faults[:_MOST], *more])


def allowed(word: str, words: Iterable[str]) -> str:
    """Say which `words` are allowed in place of `word`, the nearest one first."""
    known = list(words)
    return nearest(word, known) + (f"allowed: {', '.join(known)}" if known else "none is allowed")


def nearest(word: str, words: Iterable[str]) -> str:
    """Ask whether one of the `words` is meant by `word`, where one is near; a blank follows."""
    known, word = list(words), word[:_LONGEST]
    near = difflib.get_close_matches(word.lower(), {known_word.lower() for known_word in known}, 1)
    return next((f'did you mean "{w}"? ' for w in known if [w.lower()] == near), "")
