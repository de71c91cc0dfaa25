"""Notes on interfaces that contradict each other within a package. Nothing here refuses a spec.

Which side of a place in the ROS graph an interface is on does not matter here: all that share a
name must share the type.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping
from typing import Any

from .dictionary import Component, Dictionary, Interface
from .endpoints import Endpoint, endpoint
from .faults import with_id

_SHORTEST = 4
"""The shortest word in which one letter more, less or other is taken for a slip."""
_MOST_COMPARED = 300
"""How many names are compared, each with each other; no package has as many."""


def contradictions(context: Mapping[str, Any], dictionary: Dictionary) -> list[str]:
    """Return a note for each name with two types, and each pair of names that look like one."""
    groups: dict[tuple[str, str], dict[str, str]] = {}
    for owner, found in _endpoints(context, dictionary):
        types = groups.setdefault((found.graph, found.name), {})
        types.setdefault(found.type, owner)
    notes = []
    for (graph, name), types in groups.items():
        if len(types) > 1:
            uses = ", ".join(f"{type_name} in {owner}" for type_name, owner in types.items())
            note = f"{graph} {name} has more than one type: {uses}; they cannot connect"
            notes.append(with_id(note, "type-clash"))
    some = list(groups)[:_MOST_COMPARED]
    for (graph, one), (other_graph, other) in itertools.combinations(some, 2):
        if graph != other_graph:
            continue
        same_type = groups[graph, one].keys() & groups[graph, other].keys()
        is_case = one.lower() == other.lower()
        if is_case or (same_type and _differ_by_a_letter(one, other)):
            how = "case" if is_case else "a letter"
            note = f"{graph}s {one} and {other} differ only by {how}; is one a slip?"
            notes.append(with_id(note, "similar-names"))
    return notes


def elements(
    context: Mapping[str, Any], dictionary: Dictionary
) -> Iterator[tuple[Component, str, Component | Interface, Mapping[str, Any]]]:
    """Yield components and all interfaces: the component, its name, what it is, its values.

    What components take from others is among theirs.
    """
    for component in dictionary.components.values():
        for values in () if component.is_shared else context[component.key]:
            owner = str(values[component.naming])
            yield component, owner, component, values
            for interface, item in _inside(component, values):
                yield component, owner, interface, item


def _endpoints(
    context: Mapping[str, Any], dictionary: Dictionary
) -> Iterator[tuple[str, Endpoint]]:
    """Yield what is in the ROS graph, each after the component it belongs to."""
    for component, owner, kind, item in elements(context, dictionary):
        if isinstance(kind, Interface) and (found := endpoint(owner, kind, item)):
            yield f"{component.tag} {owner}", found


def _inside(
    kind: Component | Interface, values: Mapping[str, Any]
) -> Iterator[tuple[Interface, Mapping[str, Any]]]:
    """Yield the interfaces inside of a component or an interface, at any depth."""
    for interface in kind.interfaces.values():
        for item in interface.of(values):
            yield interface, item
            yield from _inside(interface, item)


def _differ_by_a_letter(one: str, other: str) -> bool:
    """Say whether one word of a name has a letter more, less or other, or two in other order.

    Numbers and words of few letters tell names apart on purpose: `arm_1`, `pos_x`, `left`.
    """
    words, others = (re.split(r"([/_]|\d+)", name) for name in (one, other))
    if len(words) != len(others):
        return False
    pairs = [(a, b) for a, b in zip(words, others, strict=True) if a != b]
    if len(pairs) != 1 or min(map(len, pairs[0])) < _SHORTEST:
        return False
    short, long = sorted(pairs[0], key=len)
    if not (short + long).isalpha():
        return False
    start = next((i for i, (a, b) in enumerate(zip(short, long, strict=False)) if a != b), None)
    start = len(short) if start is None else start
    if len(short) == len(long):
        swapped = short[start : start + 2] == long[start : start + 2][::-1]
        rest = 2 if swapped else 1
        return short[start + rest :] == long[start + rest :]
    return short[start:] == long[start + 1 :]
