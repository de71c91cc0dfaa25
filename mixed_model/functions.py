"""A package of nodes in two languages: which model makes each node, and what it needs."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

_ROOT = next(
    folder for folder in Path(__file__).parents if (folder / "cpp_model/functions.py").exists()
)
_SHARED = next(folder for folder in Path(__file__).parents if (folder / "shared").exists())
_COMMON = runpy.run_path(str(_SHARED / "shared/functions.py"))
_DEFINITIONS = runpy.run_path(str(_SHARED / "shared/interfaces/functions.py"))
_MODELS = {
    language: runpy.run_path(str(_ROOT / f"{language}_model/functions.py"))
    for language in ("python", "cpp")
}


def dependencies_from_template(ros_distro: str) -> list[str]:
    """Return the packages every package of this model needs: those that its nodes need."""
    return []


def dependencies_from_component(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that a node in its language, or a definition, needs."""
    language = attributes.get("language")
    model = _MODELS[language]["dependencies_from_template"](ros_distro) if language else []
    return [*model, *_COMMON["dependencies_from_component"](kind, attributes, ros_distro)]


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that one interface needs in the language of its node, if it has one."""
    model = _MODELS[attributes.get("node", {}).get("language", "cpp")]
    return list(model["dependencies_from_interface"](kind, attributes, ros_distro))


def parts(spec: dict[str, Any], language: str, ros_distro: str) -> list[dict[str, Any]]:
    """Return the spec of the nodes of one language, as its model sees it; none without nodes.

    What <depend> adds is for both languages. Decision 88: nothing of it is recorded.
    """
    nodes = [node for node in spec["nodes"] if node["language"] == language]
    if not nodes:
        return []
    own = set(spec["declared"]).union(*(_packages(node, ros_distro) for node in nodes))
    kinds = sorted({kind for kind, _ in _interfaces(nodes)})
    depends = [name for name in spec["depends"] if name in own]
    groups = _COMMON["used_by"](spec["groups"], nodes)
    return [{**spec, "nodes": nodes, "groups": groups, "kinds": kinds, "depends": depends}]


def for_cmake(spec: dict[str, Any], ros_distro: str) -> dict[str, Any]:
    """Return what CMake must know of a spec: the nodes in C++ and all that makes code."""
    depends = {name for name in spec["depends"] if name == "dynamic_reconfigure"}
    depends.update(_DEFINITIONS["defined_with"](spec))
    part: dict[str, Any] = {**spec, "nodes": []}
    for part in parts(spec, "cpp", ros_distro):
        depends |= set(part["depends"])
    return {**part, "kinds": spec["kinds"], "depends": sorted(depends)}


def logic_file(node: dict[str, Any], package: str) -> str:
    """Return where the logic of a node stands."""
    return str(_MODELS[node["language"]]["logic_file"](node, package))


def cfg_name(node: dict[str, Any]) -> str:
    """Return what dynamic_reconfigure calls the parameters of a node."""
    return str(_MODELS[node["language"]]["cfg_name"](node))


def lines_with(text: str, *endings: str) -> str:
    """Return the lines of a text that end in one of the endings."""
    return "".join(line for line in text.splitlines(True) if line.rstrip().endswith(endings))


def sort_lines(text: str) -> str:
    """Return the lines of a text, each once and sorted, without empty ones."""
    return "".join(sorted({line for line in text.splitlines(True) if line.strip()}))


def _packages(node: dict[str, Any], ros_distro: str) -> set[str]:
    """Return the packages that a node needs with its interfaces."""
    packages = dependencies_from_component("node", node, ros_distro)
    for kind, item in _interfaces([node]):
        packages += dependencies_from_interface(kind, {**item, "node": node}, ros_distro)
    return set(packages)


def _interfaces(nodes: list[dict[str, Any]]) -> list[tuple[str, dict[str, Any]]]:
    """Return the interfaces of nodes, each with its kind."""
    return [
        (key.removesuffix("s"), item)
        for node in nodes
        for key, items in node.items()
        if isinstance(items, list)
        for item in items
    ]
