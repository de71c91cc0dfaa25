"""Compare two contexts: what came, left, changed, and what was renamed."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from .dictionary import PACKAGE, WAS, Attribute, Component, Dictionary, Interface
from .faults import SpecError, allowed
from .names import class_name

Values = Mapping[str, Any]


def changes(old: Values, new: Values, dictionary: Dictionary) -> Iterator[str]:
    """Say in a line what came (+), left (-), changed (~) or was renamed (>)."""
    for pair in _pairs(old, new, dictionary):
        if pair.before is None:
            yield f"+ {pair.label}"
        elif pair.after is None:
            yield f"- {pair.label}"
        else:
            if pair.was != pair.name and pair.is_renamed:
                yield f"> {pair.label}, was {pair.was}"
            yield from _attributes(pair.label, pair.before, pair.after, pair.attributes)


@dataclass(frozen=True)
class Mark:
    """A name that was exchanged for a mark, so that a render shows what depends on it.

    The mark is `zq<number>x`, the number being its place in the list of marks. Of an interface,
    `owner` is the number of its component's mark.
    """

    before: str
    after: str
    level: str
    owner: int | None = None
    is_gone: bool = False
    """It left, and another one has its name now; `after` is then a name that nothing has."""


GONE = "__gone"


def marked(old: Values, new: Values, dictionary: Dictionary) -> tuple[dict[str, Any], list[Mark]]:
    """Return the old context with marks for the names that changed; and the marks.

    A component whose interface was renamed has a mark too. No marks: nothing was renamed.
    """
    context = copy.deepcopy(dict(old))
    marks: list[Mark] = []
    owner: _Pair | None = None
    number: int | None = None
    pairs = list(_pairs(context, new, dictionary))
    taken = {(pair.level, pair.name) for pair in pairs if pair.is_renamed}
    for pair in pairs:
        if pair.level == "component":
            owner, number = pair, None
        is_gone = pair.after is None and (pair.level, pair.name) in taken
        if not pair.is_renamed and not is_gone:
            continue
        if pair.level == "interface" and owner and number is None:
            number = _mark(owner, marks, None)
        found = _mark(pair, marks, number if pair.level == "interface" else None)
        if pair.level == "component":
            number = found
    return context, marks


def _mark(pair: _Pair, marks: list[Mark], owner: int | None) -> int:
    name = pair.was or pair.name
    prefix = name[: len(name) - len(name.lstrip("~/"))]
    is_gone = pair.after is None
    after = pair.name + GONE if is_gone else pair.name
    marks.append(Mark(name, after, pair.level, owner, is_gone))
    item: Any = pair.before
    mark = f"zq{len(marks) - 1}x"
    item[next(iter(pair.attributes))] = prefix + mark
    if "class_name" in item:
        item["class_name"] = class_name(mark)
    return len(marks) - 1


def check_names_before(old: Values, new: Values, dictionary: Dictionary, file: str) -> None:
    """Insist that every `was` names something, and no two the same.

    Raises:
        SpecError: one does not; `file` is the name of the spec in messages.

    """
    for pair in _pairs(old, new, dictionary):
        was = (pair.after or {}).get(WAS)
        if was is None or pair.is_renamed or was == pair.name:
            continue
        if pair.before is not None and pair.before.get(WAS) == was:
            continue  # carried out by an earlier update
        others = [name for name in pair.others if name != pair.name]
        raise SpecError(
            f'{file}: {pair.label}: was="{was}": the last update knew no such'
            f" {pair.label.split()[0]}, or it has gone to another; {allowed(str(was), others)}"
        )


@dataclass(frozen=True)
class _Pair:
    """An item of the old context and the same item of the new one, where there is one."""

    before: Values | None
    after: Values | None
    attributes: Mapping[str, Attribute]
    others: tuple[str, ...] = ()
    label: str = PACKAGE
    level: str = "interface"

    @property
    def was(self) -> str | None:
        return _name(self.before, self.attributes) if self.before and self.after else None

    @property
    def name(self) -> str:
        return _name(self.after or self.before or {}, self.attributes)

    @property
    def is_renamed(self) -> bool:
        return self.was is not None and self.was != self.name


def _pairs(old: Values, new: Values, dictionary: Dictionary) -> Iterator[_Pair]:
    """Pair the packages, components, and inside of those that stayed, interfaces."""
    name, was = _name(old, dictionary.package), str(new.get(WAS))
    package = _Pair(old, new, dictionary.package, (name,), level=PACKAGE)
    if package.is_renamed and was != name:  # another package, as far as anybody has said
        same = {**new, next(iter(dictionary.package)): name}
        package = replace(package, after=same)
    yield package
    for component in dictionary.components.values():
        for pair in _partners(old, new, component):
            yield replace(pair, label=f"{component.tag} {pair.name}", level="component")
            if pair.before is not None and pair.after is not None:
                for kind in component.interfaces.values():
                    for inner in _partners(pair.before, pair.after, kind):
                        label = f"{kind.kind} {inner.name} on {pair.name}"
                        yield replace(inner, label=label)


def _partners(old: Values, new: Values, kind: Component | Interface) -> Iterator[_Pair]:
    """Pair what has the same name, or had it before; None where there is no partner.

    A `was` counts once: the context that an update has recorded has it already.
    """
    left = {_name(item, kind.attributes): item for item in old.get(kind.key, [])}
    known = tuple(left)
    items = list(new.get(kind.key, []))
    partners: dict[int, Values | None] = {}
    for number, item in enumerate(items):
        name, was = _name(item, kind.attributes), item.get(WAS)
        if was in left and was != name and (left.get(name) or {}).get(WAS) != was:
            partners[number] = left.pop(str(was))
    for number, item in enumerate(items):
        name = _name(item, kind.attributes)
        yield _Pair(partners.get(number) or left.pop(name, None), item, kind.attributes, known)
    for item in left.values():
        yield _Pair(item, None, kind.attributes, known)


def _attributes(
    label: str, before: Values, after: Values, attributes: Mapping[str, Attribute]
) -> Iterator[str]:
    """Compare the values of two items, but for their names."""
    for name in list(attributes)[1:]:
        if name in before and before[name] != after.get(name):
            yield f"~ {label}: {name} {_shown(before[name])} -> {_shown(after.get(name))}"


def _shown(value: Any) -> str:
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    text = " ".join(str(value).split())
    return f'"{text[:37]}..."' if len(text) > 40 else text or '""'


def _name(item: Values, attributes: Mapping[str, Attribute]) -> str:
    """Return the value that names an item: its first attribute, as the dictionary has them."""
    return str(item.get(next(iter(attributes), "")))
