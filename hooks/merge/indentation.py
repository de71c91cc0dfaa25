"""The model's versions of a file, indented as the developer's before a merge (decision 152)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace

from .languages import CPP, PYTHON, YAML, language
from .lines import margin, plain, split
from .tree import File, Tree, encode

_FEW = 2
"""So many lines of one depth say how the developer indents it."""


def indented(mine: Tree, old: Tree, new: Tree, path_of: Callable[[str], str]) -> tuple[Tree, Tree]:
    """Return the old and the new version in the developer's indentation; `path_of` the new path.

    Python and YAML with two indentations are something else, or nothing.
    """
    made = dict(old), dict(new)
    for path, file in mine.items():
        before = old.get(path, file)
        if file.data == before.data or language(path, before.written) not in (PYTHON, YAML, CPP):
            continue
        if unit := _unit(file.written, before.written):
            for tree, name in zip(made, (path, path_of(path)), strict=True):
                if name in tree:
                    tree[name] = _indented(tree[name], *unit)
    return made


def _unit(mine: str, old: str) -> tuple[str, str] | None:
    """Return what one step of the old version is, and what of the developer's, if another."""
    ours, base = map(_margins, (mine, old))
    votes = Counter((base[line], ours[line]) for line in base.keys() & ours.keys())
    steps = {before: after for (before, after), _ in votes.most_common()[::-1]}
    before = min(filter(None, steps), key=len, default="")
    after = steps.get(before, "")
    if not after or before == after or steps.get(""):
        return None
    counts = Counter(base[line] for line in base.keys() & ours.keys())
    is_step = all(
        step == after * (len(blanks) // len(before))
        for blanks, step in steps.items()
        if len(blanks) % len(before) == 0 and counts[blanks] >= _FEW
    )
    return (before, after) if is_step else None


def _margins(text: str) -> dict[str, str]:
    """Return the blanks before each line that a text has once."""
    lines = [line for line in split(plain(text)) if line.strip()]
    said = Counter(line.strip() for line in lines)
    return {line.strip(): line[: margin(line)] for line in lines if said[line.strip()] == 1}


def _indented(file: File, before: str, after: str) -> File:
    def step(blanks: re.Match[str]) -> str:
        count, rest = divmod(len(blanks[0]), len(before))
        return after * count + " " * rest

    return replace(file, data=encode(re.sub(r"(?m)^ +(?=\S)", step, file.written)))
