"""Faults in a spec or in a model, said so that a user can mend them."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class SpecError(Exception):
    """A fault of the spec or the model; the text names file, line, fault and remedy."""


def allowed(word: str, words: Iterable[str]) -> str:
    """Say which `words` are allowed in place of `word`, the nearest one first."""
    known = list(words)
    near = difflib.get_close_matches(word.lower(), {known_word.lower() for known_word in known}, 1)
    hint = next((f'did you mean "{w}"? ' for w in known if [w.lower()] == near), "")
    return hint + (f"allowed: {', '.join(known)}" if known else "none is allowed")
