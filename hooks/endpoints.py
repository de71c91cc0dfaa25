"""Where interfaces are in the ROS graph: names of topics, services and actions, and their types.

An interface is there where its dictionary gives it a name of the format `ros_name` and a type of
a message, service or action.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .collisions import Checked
from .data import load_data
from .dictionary import Dictionary, Interface
from .parse import Element

_GRAPHS = {
    "message_type": "topic",
    "stamped_type": "topic",
    "service_type": "service",
    "action_type": "action",
}
_BUILT_IN: Mapping[str, Sequence[str]] = load_data("ros.yaml")["built_in"]


@dataclass(frozen=True)
class Endpoint:
    """A place in the ROS graph, of a component that runs without a namespace."""

    graph: str
    name: str
    type: str


def endpoint(owner: str, interface: Interface, item: Mapping[str, Any]) -> Endpoint | None:
    """Return where an interface is in the ROS graph, or nothing where it is not in it."""
    found = {a.format: item[a.name] for a in interface.attributes.values() if a.name in item}
    graph = next((format_ for format_ in _GRAPHS if found.get(format_)), None)
    if not graph or not found.get("ros_name"):
        return None
    return Endpoint(_GRAPHS[graph], _resolved(found["ros_name"], owner), found[graph])


def clashes(
    elements: Sequence[Checked], dictionary: Dictionary
) -> Iterator[tuple[Element, str, str]]:
    """Yield each interface whose name has another type in its own component, the fault, its id.

    No ROS allows it; between components that is but a note (decision 78).
    """
    types: dict[tuple[str, str, str], str] = {}
    for item in elements:
        component = list(item.owners.values())[1]
        kind = dictionary.components[component.tag]
        if item.tag not in kind.interfaces:  # it stands within another interface
            continue
        owner = str(component.values[kind.naming])
        found = endpoint(owner, kind.interfaces[item.tag], item.values)
        if not found:
            continue
        built_in = _BUILT_IN.get(found.name.replace(f"/{owner}/", "~/", 1), [found.type])
        first = types.setdefault((found.graph, found.name, owner), found.type)
        if found.type not in built_in:
            fault = f"{' or '.join(built_in)} in every {kind.tag}"
        elif found.type != first:
            fault = f"{first} in this {kind.tag} already"
        else:
            continue
        what = f"{found.graph} {found.name} is of type {fault}; choose another name"
        yield item.element, what, "type-clash"


def _resolved(name: str, owner: str) -> str:
    """Return a name as ROS resolves it where the component runs without a namespace."""
    if name.startswith("~/"):
        return f"/{owner}/{name[2:]}"
    return f"/{name.removeprefix('/')}"
