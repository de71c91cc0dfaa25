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
    """A fault of the spec or the model; the text names file, line, fault and remedy.

    Its first line ends with an id, by which docs/messages.md has the cause (decision 143).
    """

    def __init__(self, text: str, id_: str) -> None:
        first, *rest = text.split("\n", 1)
        super().__init__("\n".join([with_id(first, id_), *rest]))
        self.text, self.id = text, id_


class UnrenderedError(SpecError):
    """A version of a template makes no package: it is no longer there, or has a fault."""


def with_id(text: str, id_: str) -> str:
    """Return a text that ends with its id: that of a note, or of one of several faults."""
    return f"{text} [{id_}]"


def refused(error: ValueError, place: str = "") -> SpecError:
    """Return what a function of a model refuses by `ValueError(text, id)`, or by a text alone."""
    text, id_ = error.args if len(error.args) == 2 else (error, "refused-by-model")
    return SpecError(": ".join(filter(None, (place, str(text)))), str(id_))


def shown(text: str, longest: int = _LONGEST) -> str:
    """Return a text fit for a message: not too long, and with nothing that a terminal obeys."""
    short = text if len(text) <= longest else f"{text[:longest]}..."
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in short)


def quoted(text: str) -> str:
    """Return a text of the user's in quotes, fit for a message."""
    return f'"{shown(text)}"'


def first_of(faults: Sequence[SpecError]) -> SpecError:
    """Return one fault with a line for each, but for those that are too many to read."""
    more = [f"... and {len(faults) - _MOST} more"] if len(faults) > _MOST else []
    lines = [faults[0].text, *map(str, faults[1:_MOST]), *more]
    return SpecError("\n".join(lines), faults[0].id)


def allowed(word: str, words: Iterable[str], meant: str = "") -> str:
    """Say which `words` are allowed in place of `word`, first what is meant, or the nearest."""
    known = list(words)
    first = f"did you mean {quoted(meant)}? " if meant else nearest(word, known)
    return first + (f"allowed: {', '.join(known)}" if known else "none is allowed")


def closest(word: str, words: Iterable[str], likeness: float = 0.6) -> str:
    """Return the one of the `words` that is spelled most like `word`; nothing if none is."""
    spelled = {known.lower(): known for known in words}
    near = difflib.get_close_matches(word[:_LONGEST].lower(), spelled, 1, likeness)
    return spelled[near[0]] if near else ""


def nearest(word: str, words: Iterable[str]) -> str:
    """Ask whether one of the `words` is meant by `word`, where one is near; a blank follows.

    A word that is a part of several may mean each: `client` is in `serviceClient`, too.
    """
    known, word = list(words), word[:_LONGEST].lower()
    parts = [w for w in known if len(word) >= _SHORTEST_PART and word in w.lower()]
    if 1 < len(parts) <= _MOST_PARTS and not closest(word, known, _SLIP):
        return f"did you mean {', '.join(map(quoted, parts[:-1]))} or {quoted(parts[-1])}? "
    near = closest(word, known)
    return f"did you mean {quoted(near)}? " if near else ""
