"""Compare two contexts: what came, left, changed, and what was renamed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from .dictionary import WAS, Attribute, Component, Dictionary, Interface

Values = Mapping[str, Any]


def changes(old: Values, new: Values, dictionary: Dictionary) -> Iterator[str]:
    """Say in a line what came (+), left (-), changed (~) or was renamed (>)."""
    yield from _attributes("package", old, new, dictionary.package)
    for pair in _pairs(old, new, dictionary):
        if pair.before is None:
            yield f"+ {pair.label}"
        elif pair.after is None:
            yield f"- {pair.label}"
        else:
            if pair.was != pair.name:
                yield f"> {pair.label}, was {pair.was}"
            yield from _attributes(pair.label, pair.before, pair.after, pair.attributes)


def renames(old: Values, new: Values, dictionary: Dictionary) -> list[dict[str, str]]:
    """Return what the spec says has been renamed.

    Each has its name `before` and `after`, and of the component it belongs to `owner_before` and
    `owner_after`.
    """
    found = []
    owner = None
    for pair in _pairs(old, new, dictionary):
        owner = pair if pair.is_component else owner
        if owner and owner.was and pair.was and pair.was != pair.name:
            found.append(
                {
                    "before": pair.was,
                    "after": pair.name,
                    "owner_before": owner.was,
                    "owner_after": owner.name,
                }
            )
    return found


@dataclass(frozen=True)
class _Pair:
    """An item of the old context and the same item of the new one, where there is one."""

    before: Values | None
    after: Values | None
    attributes: Mapping[str, Attribute]
    label: str = ""
    is_component: bool = False

    @property
    def was(self) -> str | None:
        return _name(self.before, self.attributes) if self.before and self.after else None

    @property
    def name(self) -> str:
        return _name(self.after or self.before or {}, self.attributes)


def _pairs(old: Values, new: Values, dictionary: Dictionary) -> Iterator[_Pair]:
    """Pair components, and inside of those that stayed, interfaces."""
    for component in dictionary.components.values():
        for pair in _partners(old, new, component):
            yield replace(pair, label=f"{component.tag} {pair.name}", is_component=True)
            if pair.before is not None and pair.after is not None:
                for kind in component.interfaces.values():
                    for inner in _partners(pair.before, pair.after, kind):
                        label = f"{kind.kind} {inner.name} on {pair.name}"
                        yield replace(inner, label=label)


def _partners(old: Values, new: Values, kind: Component | Interface) -> Iterator[_Pair]:
    """Pair what has the same name, or had it before; None where there is no partner."""
    left = {_name(item, kind.attributes): item for item in old.get(kind.key, [])}
    names = {_name(item, kind.attributes) for item in new.get(kind.key, [])}
    for item in new.get(kind.key, []):
        name, was = _name(item, kind.attributes), str(item.get(WAS))
        renamed = name not in left and was in left and was not in names
        yield _Pair(left.pop(was if renamed else name, None), item, kind.attributes)
    for item in left.values():
        yield _Pair(item, None, kind.attributes)


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
