"""Files of YAML whose keys a new version puts below others, or no longer: ROS 2's parameters.

The developer's file gets the depth of the new version before it is merged, its values and comments
with it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import yaml

from ..data import LOADER
from .blocks import unicode
from .languages import YAML, language
from .lines import margin, split
from .tree import File, Tree

Shift = Callable[[str], str]


def shifts(old: Tree, new: Tree, path_of: Callable[[str], str]) -> dict[str, Shift]:
    """Return what gives a file the depth of the new version, by the paths of the old one."""
    found: dict[str, Shift] = {}
    for path, file in old.items():
        other = new.get(path_of(path), File(b""))
        before, after = file.text or "", other.text or ""
        if language(path, before) is YAML and before and after:
            above, below = _above(before), _above(after)
            if above and not below:
                found[path] = _raise(split(before)[above[0] : above[-1] + 1])
            elif below and not above:
                lines = split(after)
                head = split(before)[: below[0]]
                found[path] = _lower(lines[below[0] : below[-1] + 1], head, _column(after))
    return found


def _raise(above: Sequence[str]) -> Shift:
    def shift(text: str) -> str:
        lines, found = split(text), _above(text)
        if not found or lines[found[0] : found[-1] + 1] != list(above):
            return text
        column = _column(text)
        rest = [line[min(column, margin(line)) :] for line in lines[found[-1] + 1 :]]
        return "".join([*lines[: found[0]], *rest])

    return shift


def _lower(above: Sequence[str], head: Sequence[str], column: int) -> Shift:
    def shift(text: str) -> str:
        node = _compose(text)
        if node is None or node.flow_style:
            return text
        lines, first = split(text), node.start_mark.line
        at = first
        while at and lines[at - 1].startswith("#") and lines[at - 1] not in head[-1:]:
            at -= 1
        rest = [" " * column + line if line.strip() else line for line in lines[at:]]
        return "".join([*lines[:at], *above, *rest])

    return shift


def _compose(text: str) -> yaml.MappingNode | None:
    try:
        node = yaml.compose(unicode(text), LOADER)
    except yaml.YAMLError:
        return None
    return node if isinstance(node, yaml.MappingNode) and node.value else None


def _above(text: str) -> list[int]:
    """Return the lines of the keys that stand above all others, each alone on its line."""
    found: list[int] = []
    node = _compose(text)
    while node and not node.flow_style and len(node.value) == 1:
        key, value = node.value[0]
        if not isinstance(value, yaml.MappingNode) or value.flow_style or not value.value:
            break
        found.append(key.start_mark.line)
        node = value
    is_close = not found or found == list(range(found[0], found[-1] + 1))
    return found if is_close else []


def _column(text: str) -> int:
    """Return where the keys begin that stand below those."""
    node = _compose(text)
    for _ in _above(text):
        node = node.value[0][1]  # type: ignore[union-attr]
    return node.start_mark.column if node else 0
