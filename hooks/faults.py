"""Faults in a spec or in a model, said so that a user can mend them."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence

_LONGEST = 60
_MOST = 20
_SHORTEST_PART = 3
_MOST_PARTS = 3
_SLIP = 0.8
"""How like a word is that was meant and misspelt, of 1."""


class SpecError(Exception):
    """A fault of the spec or the model; the text names file, line, fault and remedy."""


class UnrenderedError(SpecError):
    """A version of a template makes no package: it is no longer there, or has a fault."""


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
    """Ask whether one of the `words` is meant by `word`, where one is near; a blank follows.

    A word that is a part of several may mean each: `client` is in `serviceClient`, too.
    """
    known, word = list(words), word[:_LONGEST].lower()
    parts = [w for w in known if len(word) >= _SHORTEST_PART and word in w.lower()]
    spelled = {known_word.lower(): known_word for known_word in known}
    if 1 < len(parts) <= _MOST_PARTS and not difflib.get_close_matches(word, spelled, 1, _SLIP):
        return f"did you mean {', '.join(map(quoted, parts[:-1]))} or {quoted(parts[-1])}? "
    near = difflib.get_close_matches(word, spelled, 1)
    return f"did you mean {quoted(spelled[near[0]])}? " if near else ""
