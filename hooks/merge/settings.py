"""What files of parameters and launch files give nodes: parameters, other names of topics."""

from __future__ import annotations

import ast
import contextlib
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple
from xml.parsers import expat

import yaml

from . import python_blocks
from .depth import compose
from .languages import PYTHON, XML, YAML, Language

_OF_ROS2 = "ros__parameters"
_NAMING = {"param": "name", "remap": "from", "rosparam": "param"}
"""What has the name in an element of a launch file."""
EVERY = "**"
"""The name of all nodes."""


class Setting(NamedTuple):
    """A parameter or a topic of a node, where a file names it."""

    line: int
    """From 0."""
    node: str | None
    """The name of the node, or of its program; EVERY; None where the file names no node."""
    name: str
    """Groups of parameters with dots; empty where it is the node alone."""
    written: str


def settings(known: Language, text: str, packages: Collection[str]) -> Iterator[Setting]:
    """Yield what a file gives nodes; in launch files those of some packages."""
    with contextlib.suppress(ValueError, RecursionError, expat.ExpatError):
        if known is YAML:
            yield from _of_yaml(compose(text), ())
        elif known is XML:
            yield from _of_xml(text, packages)
        elif known is PYTHON:
            for given, package, program in node_calls(text):
                if package in packages:
                    yield from _of_call(given, str(program.value))


def dotted(name: str) -> str:
    """Return the name of a parameter or a topic with dots between its groups, in whichever ROS."""
    return name.strip("~/").replace("/", ".")


def _of_yaml(node: yaml.Node | None, above: tuple[str, ...]) -> Iterator[Setting]:
    for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
        name = str(key.value)
        is_below = _OF_ROS2 in above
        at = above.index(_OF_ROS2) if is_below else min(len(above), 1)
        nodes = above[:at] or (None,)
        line = key.start_mark.line
        grouped = ".".join([*above[at + is_below :], name])
        yield Setting(line, _last(nodes[-1]), dotted(grouped), name)
        inner = value.value if isinstance(value, yaml.MappingNode) else []
        if any(not above or each.value == _OF_ROS2 for each, _ in inner):
            yield Setting(line, _last(name), "", name)
        inside = [*_of_yaml(value, (*above, name))]
        yield from inside
        if not above:  # the first key names a node, or a group of the one that loads the file
            for each in inside:
                yield each._replace(node=None, name=f"{name}.{each.name}")


def _last(name: str | None) -> str | None:
    return name and name.rpartition("/")[2]


def _of_xml(text: str, packages: Collection[str]) -> Iterator[Setting]:
    found: list[Setting] = []
    nodes: list[dict[str, str]] = []
    inside = ""
    parser = expat.ParserCreate()

    def give(line: int, name: str, written: str) -> None:
        if nodes and nodes[-1].get("pkg") in packages:
            for node in {nodes[-1].get(each, "") for each in ("exec", "type", "name")}:
                found.append(Setting(line, node, dotted(name), written))

    def start(tag: str, given: dict[str, str]) -> None:
        nonlocal inside
        inside = ""
        if tag == "node":
            nodes.append(given)
        if name := given.get(_NAMING.get(tag, ""), ""):
            give(parser.CurrentLineNumber - 1, name, name)

    def end(tag: str) -> None:
        if tag == "node":
            nodes.pop()
        elif tag == "rosparam":  # it has a text in YAML
            first = parser.CurrentLineNumber - 1 - inside.count("\n")
            for each in _of_yaml(compose(inside), ()):
                give(first + each.line, each.name, each.written)

    def keep(text: str) -> None:
        nonlocal inside
        inside += text

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler = keep
    parser.Parse(text.encode(errors="surrogateescape"), True)
    yield from found


def node_calls(text: str) -> Iterator[tuple[dict[str | None, ast.expr], str, ast.Constant]]:
    """Yield the arguments of calls like `Node(package=..., executable=...)`, and these two."""
    for call in python_blocks.nodes(text):
        given = {each.arg: each.value for each in getattr(call, "keywords", ())}
        match given:
            case {"package": ast.Constant(str(package)), "executable": ast.Constant() as program}:
                yield given, package, program


def _of_call(given: Mapping[str | None, ast.expr], node: str) -> Iterator[Setting]:
    """Yield what `Node(..., parameters=[], remappings=[])` gives a node."""
    for list_, type_ in (("parameters", ast.Dict), ("remappings", ast.Tuple)):
        for item in ast.walk(given[list_]) if list_ in given else ():
            if isinstance(item, type_):
                keys = item.keys if isinstance(item, ast.Dict) else item.elts[:1]
                for key in keys:
                    if isinstance(key, ast.Constant) and isinstance(key.value, str):
                        yield Setting(key.lineno - 1, node, dotted(key.value), key.value)
