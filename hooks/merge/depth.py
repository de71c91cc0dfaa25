"""Files of YAML whose keys a new version puts below others, or no longer: ROS 2's parameters.

The developer's file gets the depth of the new version before it is merged, its values and comments
with it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import PurePosixPath

import yaml

from ..data import LOADER
from .blocks import unicode
from .languages import YAML, language
from .lines import margin, split
from .tree import File, Tree

Shift = Callable[[str], "tuple[str, list[int]] | None"]
"""Returns a text, and the numbers of the lines that cannot come along, from 1.

Nothing where it does not see what belongs to the node.
"""


def shifts(old: Tree, new: Tree, path_of: Callable[[str], str]) -> dict[str, Shift]:
    """Return what gives a file the depth of the new version, by the paths of the old one."""
    found: dict[str, Shift] = {}
    for path, file in old.items():
        other = new.get(path_of(path), File(b""))
        before, after = file.written, other.written
        if language(path, before) is YAML and before and after:
            above, below = map(_close, (before, after))
            if above and not below:
                first, last = above[0][0], above[-1][0]
                found[path] = _raise(split(before)[first : last + 1], path)
            elif below and not above:
                first, (last, column) = below[0][0], below[-1]
                head = [line for line in split(before)[:first] if line.strip()]
                found[path] = _lower(split(after)[first : last + 1], head, column)
    return found


def _raise(above: Sequence[str], path: str) -> Shift:
    first, *others = map(_key, above)
    names = [_names(first, path), *([key] for key in others)]

    def shift(text: str) -> tuple[str, list[int]] | None:
        if not all(key in text for key in others):
            return text, []
        lines, beside = split(text), _beside(text, names[0])
        places = [number for number in range(len(lines)) if number not in beside]
        kept = "".join(lines[number] for number in places)
        nodes = _above(kept)[: len(above)]
        head = [places[number] for number, _ in nodes]
        if not head or [_key(lines[number]) for number in head[1:]] != others:
            return None
        column = nodes[-1][1]
        rest = [lines[number] for number in places if number > head[0] and number not in head]
        own = {  # another key than these, or something behind it
            number
            for number, keys in zip(head, names, strict=True)
            if _key(lines[number]) not in keys or not lines[number].rstrip().endswith(":")
        }
        behind = [number + 1 for number in sorted(beside | own) if lines[number].strip()]
        start = [lines[number] for number in places if number < head[0]]
        return "".join([*start, *(line[min(column, margin(line)) :] for line in rest)]), behind

    return shift


def _names(key: str, path: str) -> list[str]:
    """Return a key, and others that mean the same in the file of one node: those with its name."""
    parts = PurePosixPath(path).with_suffix("").parts
    ends = ["/".join(parts[start:]) for start in range(len(parts))]
    return [key, *(f"{before}{end}" for before in (f"{key}/", "/", "") for end in ends)]


def _key(line: str) -> str:
    """Return the key that a line has, and no value."""
    found = re.fullmatch(r"""\s*(["']?)(.+?)\1\s*:\s*(#.*)?""", line.rstrip())
    return found[2] if found else ""


def _beside(text: str, names: Sequence[str]) -> set[int]:
    """Return the lines, from 0, of what is beside the first of some keys that a text has."""
    node = compose(text)
    if node is None or node.flow_style:
        return set()
    lines = split(text)
    at = [key.start_mark.line for key, _ in node.value]
    own = [line for name in names for line in at if _key(lines[line]) == name][:1]
    starts = [*at, len(lines)]
    for place in range(1, len(at)):
        while lines[starts[place] - 1].startswith("#"):
            starts[place] -= 1
    spans = zip(at, pairwise(starts), strict=True)
    return {n for key, span in spans if own and key not in own for n in range(*span)}


def _lower(above: Sequence[str], head: Sequence[str], column: int) -> Shift:
    def shift(text: str) -> tuple[str, list[int]] | None:
        node = compose(text)
        if node is None:
            return text, []
        if node.flow_style:
            return None
        lines, at = split(text), node.start_mark.line
        while at and re.match(r"#|\s*$", lines[at - 1]) and lines[at - 1] not in head:
            at -= 1
        while not lines[at].strip():
            at += 1
        rest = [" " * column + line if line.strip() else line for line in lines[at:]]
        return "".join([*lines[:at], *above, *rest]), []

    return shift


def compose(text: str) -> yaml.MappingNode | None:
    """Read a mapping of YAML; None where a text is none, or is empty."""
    try:
        node = yaml.compose(unicode(text), LOADER)
    except yaml.YAMLError:
        return None
    return node if isinstance(node, yaml.MappingNode) and node.value else None


def _close(text: str) -> list[tuple[int, int]]:
    """Return the keys above all others, as `_above`, where nothing stands between them."""
    found = _above(text)
    return found if all(below[0] == above[0] + 1 for above, below in pairwise(found)) else []


def _above(text: str) -> list[tuple[int, int]]:
    """Return the keys that stand above all others, each alone on its line.

    Of each, its line and the column of those below it.
    """
    found: list[tuple[int, int]] = []
    node = compose(text)
    while node and not node.flow_style and len(node.value) == 1:
        key, value = node.value[0]
        if not isinstance(value, yaml.MappingNode) or value.flow_style or not value.value:
            break
        found.append((key.start_mark.line, value.start_mark.column))
        node = value
    return found
