"""What files of parameters and launch files give nodes: parameters, other names of topics."""

from __future__ import annotations

import ast
import contextlib
import re
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import accumulate
from typing import NamedTuple
from xml.parsers import expat

import yaml

from . import python_blocks
from .depth import compose
from .languages import PYTHON, XML, YAML, Language
from .lines import split
from .xml_blocks import ATTRIBUTE, MARKUP

_OF_ROS2 = "ros__parameters"
_NAMING = {"param": "name", "remap": "from", "rosparam": "param"}
"""What has the name in an element of a launch file."""
EVERY = "**"
"""The name of all nodes."""
STARTED = ("exec", "executable", "type", "plugin")
"""What has the name of a program, or the class of a component, beside a package."""
_CDATA = re.compile(r"<!\[CDATA\[|\]\]>")
_NONE = (0, 0)
Place = tuple[int, int]
"""Where in a text something begins and ends."""


class Setting(NamedTuple):
    """A parameter or a topic of a node, where a file names it."""

    line: int
    """From 0."""
    node: str | None
    """The name of the node, or of its program; EVERY; None where the file names no node."""
    name: str
    """Groups of parameters with dots; empty where it is the node alone."""
    written: str
    place: Place = _NONE
    """Where it is written, perhaps in quotes."""
    program: str = ""
    """In a launch file, the program, or the class of the component."""
    is_topic: bool = False
    """It is that of a topic, a service or an action."""
    sign: str = "."
    """What stands between a group and the names in it."""


def settings(known: Language, text: str, packages: Collection[str]) -> Iterator[Setting]:
    """Yield what a file gives nodes; in launch files those of some packages."""
    with contextlib.suppress(ValueError, RecursionError, expat.ExpatError):
        if known is YAML:
            node = compose(text)
            yield from _of_yaml(node, ())
            yield from _of_launch(_in_yaml("", node), packages)
        elif known is XML:
            yield from _of_launch(_in_xml(text), packages)
        elif known is PYTHON:
            yield from _of_launch(_in_python(text), packages)


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


class _Element(NamedTuple):
    """An element of a launch file, in whichever language."""

    tag: str
    line: int
    given: dict[str, tuple[str, Place]]
    children: list[_Element]


def _of_launch(
    one: _Element,
    packages: Collection[str],
    node: Mapping[str, str] | None = None,
    groups: tuple[str, ...] = (),
) -> Iterator[Setting]:
    """Yield what an element gives `node`, which it is in, or is; in `groups` of parameters."""
    said = {key: value for key, (value, _) in one.given.items()}
    if "pkg" in said:
        node = said if said["pkg"] in packages else None
    naming = _NAMING.get(one.tag, "")
    if one.tag == "rosparam" and "ns" in said:
        groups += (said["ns"],)
    if naming in said:
        groups += (said[naming],)
    if naming in said and node:
        program = next((node[each] for each in STARTED if each in node), "")
        written, place = one.given[naming]
        name, sign = dotted(".".join(groups)), "/" if "type" in node else "."
        for known in {program, node.get("name", "")}:
            is_topic = one.tag == "remap"
            yield Setting(one.line, known, name, written, place, program, is_topic, sign)
    for child in one.children:
        yield from _of_launch(child, packages, node, groups)


def _in_xml(text: str) -> _Element:
    """Return all of a launch file in XML, which is well-formed."""
    expat.ParserCreate().Parse(text.encode(errors="surrogateescape"), True)
    open_ = [_Element("", 0, {}, [])]
    start = 0
    for match in MARKUP.finditer(text):
        if match["open"]:
            given = {
                each["name"]: (
                    each["value"][1:-1],
                    (each.start("value") + 1, each.end("value") - 1),
                )
                for each in ATTRIBUTE.finditer(text, *match.span("attributes"))
            }
            one = _Element(match["tag"], text.count("\n", 0, match.start()), given, [])
            open_[-1].children.append(one)
            open_.append(one)
            start = match.end()
        if match["close"] or (match["open"] and match["attributes"].endswith("/")):
            one = open_.pop()
            if one.tag == "rosparam" and match["close"]:  # it has a text in YAML
                inside = _CDATA.sub(lambda sign: " " * len(sign[0]), text[start : match.start()])
                one.children.extend(_keys(compose(inside), start, text.count("\n", 0, start)))
    return open_[0]


def _keys(node: yaml.Node | None, at: int, line: int) -> Iterator[_Element]:
    """Yield the parameters of a mapping in a text that begins at a place, in a line."""
    for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
        place = (at + key.start_mark.index, at + key.end_mark.index)
        given = {"name": (str(key.value), place)}
        yield _Element("param", line + key.start_mark.line, given, [*_keys(value, at, line)])


def _in_yaml(tag: str, node: yaml.Node | None) -> _Element:
    """Return an element of a launch file in YAML, or all of it."""
    one = _Element(tag, node.start_mark.line if node else 0, {}, [])
    for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
        if isinstance(value, yaml.ScalarNode):
            one.given[key.value] = (value.value, (value.start_mark.index, value.end_mark.index))
        else:
            items = value.value if isinstance(value, yaml.SequenceNode) else [value]
            one.children.extend(_in_yaml(key.value, item) for item in items)
    return one


def _in_python(text: str) -> _Element:
    """Return the nodes of a launch file in Python."""
    tree, place = python_blocks.nodes(text), places(text)
    known = values(tree)
    often = Counter(node.id for node in tree if isinstance(node, ast.Name))

    def parts(node: ast.expr | None, tag: str) -> Iterator[_Element]:
        """Yield what a list has, also one whose name is read where it is used alone."""
        match node:
            case ast.Name(id=name) if often[name] == 2:  # here, and where it is given its value
                yield from parts(known.get(name), tag)
            case ast.BinOp(left=one, right=other) | ast.IfExp(body=one, orelse=other):
                yield from [*parts(one, tag), *parts(other, tag)]
            case ast.List(elts=items) | ast.Tuple(elts=items):
                if len(items) == 2 and isinstance(items[0], ast.Constant):  # of remappings
                    yield from named(items[0], tag, None)
                else:
                    yield from (each for item in items for each in parts(item, tag))
            case ast.Dict(keys=keys, values=inner) if tag == "param":
                for key, value in zip(keys, inner, strict=True):
                    yield from named(key, tag, value if isinstance(value, ast.Dict) else None)

    def named(key: ast.expr | None, tag: str, inner: ast.expr | None) -> Iterator[_Element]:
        if isinstance(key, ast.Constant) and isinstance(key.value, str):
            given = {_NAMING[tag]: (key.value, place(key))}
            yield _Element(tag, key.lineno - 1, given, [*parts(inner, tag)])

    top = _Element("", 0, {}, [])
    for given, package, program in node_calls(text):
        said = {"pkg": (package, _NONE), "exec": (str(program.value), _NONE)}
        inside = ((given.get("parameters"), "param"), (given.get("remappings"), "remap"))
        children = [each for node, tag in inside for each in parts(node, tag)]
        top.children.append(_Element("node", program.lineno - 1, said, children))
    return top


def node_calls(text: str) -> Iterator[tuple[dict[str | None, ast.expr], str, ast.Constant]]:
    """Yield the arguments of calls like `Node(package=..., executable=...)`, and these two."""
    tree = python_blocks.nodes(text)
    known = values(tree)
    for call in tree:
        given = {each.arg: each.value for each in getattr(call, "keywords", ())}
        package = given.get("package")
        program = given.get("executable", given.get("plugin"))
        if isinstance(package, ast.Name):
            package = known.get(package.id)
        match package, program:
            case ast.Constant(str(name)), ast.Constant():
                yield given, name, program


def values(tree: Sequence[ast.AST]) -> dict[str, ast.expr]:
    """Return what is given to each name of which every assignment says the same."""
    often: Counter[str] = Counter()
    given: dict[str, list[ast.expr]] = {}
    for node in tree:
        if isinstance(node, ast.arg):
            often[node.arg] += 1
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            often[node.id] += 1
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            given.setdefault(node.targets[0].id, []).append(node.value)
    return {
        name: found[0]
        for name, found in given.items()
        if len(found) == often[name] and len({*map(ast.dump, found)}) == 1
    }


def places(text: str) -> Callable[[ast.expr], Place]:
    """Return what says where in a text an expression is, whose columns count bytes."""
    lines = split(text)
    starts = [*accumulate(map(len, lines), initial=0)]

    def at(line: int, column: int) -> int:
        before = lines[line - 1].encode(errors="surrogatepass")[:column]
        return starts[line - 1] + len(before.decode(errors="surrogatepass"))

    return lambda node: (
        at(node.lineno, node.col_offset),
        at(node.end_lineno or 1, node.end_col_offset or 0),
    )
