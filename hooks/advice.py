"""Notes on interfaces that contradict each other within a package. Nothing here refuses a spec.

An interface has a place in the ROS graph where its dictionary gives it a name of the format
`ros_name` and a type of a message, service or action. Which side of it an interface is on does
not matter here: all that share a name must share the type.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from .dictionary import Component, Dictionary, Interface

_GRAPHS = {"message_type": "topic", "service_type": "service", "action_type": "action"}
_SHORTEST = 4
"""The shortest word in which one letter more, less or other is taken for a slip."""
_MOST_COMPARED = 300
"""How many names are compared, each with each other; no package has as many."""


@dataclass(frozen=True)
class _Endpoint:
    graph: str
    name: str
    type: str
    owner: str


def contradictions(context: Mapping[str, Any], dictionary: Dictionary) -> list[str]:
    """Return a note for each name with two types, and each pair of names that look like one."""
    endpoints = list(_endpoints(context, dictionary))
    groups: dict[tuple[str, str], dict[str, str]] = {}
    for endpoint in endpoints:
        types = groups.setdefault((endpoint.graph, endpoint.name), {})
        types.setdefault(endpoint.type, endpoint.owner)
    notes = []
    for (graph, name), types in groups.items():
        if len(types) > 1:
            uses = ", ".join(f"{type_name} in {owner}" for type_name, owner in types.items())
            notes.append(f"{graph} {name} has more than one type: {uses}; they cannot connect")
    some = list(groups)[:_MOST_COMPARED]
    for (graph, one), (other_graph, other) in itertools.combinations(some, 2):
        if graph != other_graph:
            continue
        same_type = groups[graph, one].keys() & groups[graph, other].keys()
        if one.lower() == other.lower():
            notes.append(f"{graph}s {one} and {other} differ only by case; is one a slip?")
        elif same_type and _differ_by_a_letter(one, other):
            notes.append(f"{graph}s {one} and {other} differ only by a letter; is one a slip?")
    return notes


def _endpoints(context: Mapping[str, Any], dictionary: Dictionary) -> Iterator[_Endpoint]:
    for component in dictionary.components.values():
        for values in context[component.key]:
            for interface in component.interfaces.values():
                for item in values[interface.key]:
                    endpoint = _endpoint(component, values, interface, item)
                    if endpoint:
                        yield endpoint


def _endpoint(
    component: Component,
    values: Mapping[str, Any],
    interface: Interface,
    item: Mapping[str, Any],
) -> _Endpoint | None:
    """Return where an interface is in the ROS graph, or nothing where it is not in it."""
    found = {a.format: item[a.name] for a in interface.attributes.values() if a.name in item}
    graph = next((format_ for format_ in _GRAPHS if found.get(format_)), None)
    if not graph or not found.get("ros_name"):
        return None
    owner = str(values[next(iter(component.attributes))])
    name = _resolved(found["ros_name"], owner)
    return _Endpoint(_GRAPHS[graph], name, found[graph], f"{component.tag} {owner}")


def _resolved(name: str, owner: str) -> str:
    """Return a name as ROS resolves it where the component runs without a namespace."""
    if name.startswith("~/"):
        return f"/{owner}/{name[2:]}"
    return f"/{name.removeprefix('/')}"


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
