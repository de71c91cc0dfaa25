"""What files say of the package where ROS, or Python, looks for something by its name.

Such a word is in a text, whose origin nobody can tell: it is the package beside it that says whose
it is. A program, a path below the share of the package, a module. Decision 155.
"""

from __future__ import annotations

import ast
import contextlib
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import yaml

from ..changes import Mark
from .depth import compose
from .languages import PYTHON, TEXT, XML, YAML, Language
from .python_blocks import nodes
from .receivers import last_word
from .settings import STARTED, Setting, dotted, places, settings, values
from .xml_blocks import Attribute

_PACKAGE = (
    r"package://|\$\(find(?:-pkg-\w+)? +|\b(?:get_package_\w+|FindPackage\w+)\([\"']"
    r"|\bpkg: *[\"']?|\b(?:pkg|package)=[\"']|\bros(?:2 )?(?:launch|run) +"
)
_LOADED = r"\b(?:import_module|patch|setattr)\([\"']"
_INSTALLED = r"[\"'][\w.-]+ *= *"
"""What stands before the module of a program in `setup.py`."""
_SHARE = (
    r"\$\(find(?:-pkg-share)? +{0}\)/|package://{0}/"
    r"|\b(?:find|get_package_share_directory|getPath)\([\"']{0}[\"']\) *\+ *[\"']/"
)
_FINDERS = (
    "get_package_share_directory",
    "get_package_share_path",
    "FindPackageShare",
    "get_path",
)
_SAME = ("Path", "PurePath", "PathJoinSubstitution", "str")
"""What makes a path of a path."""
_DOTTED = ("dotted_name", "grouped_name")
"""The formats of what launch files give values, in place of other names."""
_Edit = tuple[int, int, str, str]
"""Where a text is between quotes, what is in it, and what will be."""


def with_packages(path: str, text: str, packages: Mapping[str, str]) -> str:
    """Exchange the names of packages that need no origin; in an interface those of types."""
    is_interface = path.endswith((".msg", ".srv", ".action"))
    start = "^" if is_interface else rf"{_PACKAGE}|{_LOADED}|{_INSTALLED}(?=[\w.]+:)"
    pattern = rf"(?m)({start})({'|'.join(map(re.escape, packages))})(?![\w-])"
    return re.sub(pattern, lambda m: m[1] + packages[m[2]], text) if packages else text


class References(NamedTuple):
    """What becomes of the things of a package that have its name beside theirs."""

    package: str
    programs: Mapping[str, str]
    """Those of its nodes, and the classes of its components."""
    path: Callable[[str], str]
    """Returns where a file of the package is after the update."""
    names: Callable[[str], Mapping[str, str]]
    """Returns what becomes of the identifiers in a module of it."""
    given: Mapping[str, Sequence[Mark]]
    """By program, or class of a component, what is renamed of its parameters and topics."""

    def attribute(self, found: Attribute) -> str:
        """Return the value that an attribute of a file of XML has after the update."""
        element, name, value = found
        if name in STARTED and element.endswith(f" of {self.package}"):
            return self.programs.get(value, value)
        return self.exchanged(TEXT, value)

    def in_xml(self, text: str) -> str:
        """Return a file of XML with what nodes are given exchanged, and nothing else."""
        return edited(text, self._given(XML, text))

    def exchanged(self, known: Language, text: str) -> str:
        """Return a text that says what they are after the update."""
        if not self.package or self.package not in text:
            return text
        name = re.escape(self.package)
        share, file = _SHARE.format(name), r"([\w./-]*\w)"
        run, launch = (
            rf"(\bros(?:2 )?{command} +{name} +){file}" for command in ("run", "launch")
        )
        ways: list[tuple[str, Callable[[re.Match[str]], str]]] = [
            (rf"({share}){file}", lambda m: m[1] + self.path(m[2])),
            (rf"({_INSTALLED})({name}\.[\w.]+):(\w+)", self._installed),
            (rf"({_LOADED})({name}\.[\w.]+)", lambda m: m[1] + self._module(m[2])),
            (run, lambda m: m[1] + self.programs.get(m[2], m[2])),
            (launch, lambda m: m[1] + self.path(f"launch/{m[2]}").removeprefix("launch/")),
        ]
        for form, by in ways:
            text = re.sub(form, by, text)
        edits: Iterator[_Edit] = iter(())
        with contextlib.suppress(ValueError, RecursionError):
            if known is PYTHON:
                edits = _InPython(text, self).edits()
            elif known is YAML:
                edits = self._in_yaml(compose(text))
            text = edited(text, {*edits, *self._given(known, text)})
        return text

    def _given(self, known: Language, text: str) -> Iterator[_Edit]:
        for one in settings(known, text, {self.package}) if self.given else ():
            for mark in self.given.get(one.program, ()):
                if after := _renamed(one, mark):
                    yield (*one.place, one.written, after)

    def _installed(self, found: re.Match[str]) -> str:
        """Return a program that `setup.py` installs, and the module that it runs."""
        before, *names = found.groups()
        module, _, function = self._module(".".join(names)).rpartition(".")
        if module != names[0]:
            before = re.sub(r"[\w.-]+", lambda m: self.programs.get(m[0], m[0]), before, count=1)
        return f"{before}{module}:{function}"

    def _module(self, text: str) -> str:
        words = text.split(".")
        for end in range(1, len(words) + 1):
            file = "/".join(words[:end]) + ".py"
            if exact := self.names(file):
                new = self.path(file).removesuffix(".py").split("/")
                return ".".join(new + [exact.get(word, word) for word in words[end:]])
        return text

    def _in_yaml(self, node: yaml.Node | None) -> Iterator[_Edit]:
        if isinstance(node, yaml.SequenceNode):
            for item in node.value:
                yield from self._in_yaml(item)
        pairs = node.value if isinstance(node, yaml.MappingNode) else []
        is_ours = any((key.value, value.value) == ("pkg", self.package) for key, value in pairs)
        for key, value in pairs:
            if is_ours and key.value in STARTED and isinstance(value, yaml.ScalarNode):
                before, marks = value.value, (value.start_mark.index, value.end_mark.index)
                yield (*marks, before, self.programs.get(before, before))
            yield from self._in_yaml(value)


def edited(text: str, edits: Iterable[_Edit]) -> str:
    """Return a text with what is between quotes in some places exchanged."""
    for start, end, before, after in sorted({*edits}, reverse=True):
        if (written := text[start:end]).count(before) == 1:
            text = text[:start] + written.replace(before, after) + text[end:]
    return text


def _renamed(one: Setting, mark: Mark) -> str:
    """Return what is written for a parameter or a topic of which the mark is, else nothing."""
    before, after = mark.before, mark.after
    name = one.written.lstrip("~/")
    start = one.written.removesuffix(name)
    if one.is_topic == (mark.sort in _DOTTED) or not name:
        return ""
    if not one.is_topic:
        group = one.name.removesuffix(dotted(name))
        is_ours = one.name == before and start != "/" and after.startswith(group)
        return start + after.removeprefix(group).replace(".", one.sign) if is_ours else ""
    if one.written == before:
        return after
    old, new = (each.lstrip("~/") for each in (before, after))
    rest = name.removeprefix(old)
    is_part = rest[:1] == "/" and mark.sort == "action_type"  # its goal, its status
    is_ours = rest != name and (is_part or not rest)
    are_private = {"~" in each for each in (start, before, after)}
    return start + new + rest if is_ours and len(are_private) == 1 else ""


class _InPython:
    """The calls and paths of a launch file, or another module."""

    def __init__(self, text: str, about: References) -> None:
        self.about, self.tree = about, nodes(text)
        self.values, self.place = values(self.tree), places(text)

    def edits(self) -> Iterator[_Edit]:
        for node in self.tree:
            given = {each.arg: each.value for each in getattr(node, "keywords", ())}
            if self._is_package(given.get("package")):
                for each in map(given.get, STARTED):
                    yield from self._edit(each, self.about.programs.get(_said(each), ""))
            parts, below = _parts(node), self._below(node)
            if below and parts:
                (folder, _, name), (other, _, new) = (
                    each.rpartition("/") for each in (below, self.about.path(below))
                )
                after = _said(parts[-1]).removesuffix(name) + new
                yield from self._edit(parts[-1], after if folder == other else "")

    def _edit(self, node: ast.expr | None, after: str) -> Iterator[_Edit]:
        before = _said(node)
        if node and before and after not in ("", before):
            yield (*self.place(node), before, after)

    def _is_package(self, node: ast.expr | None) -> bool:
        value = self.values.get(node.id) if isinstance(node, ast.Name) else node
        return _said(value) == self.about.package

    def _below(self, node: ast.AST | None) -> str | None:
        """Return which path below the share of the package an expression is."""
        if isinstance(node, ast.Name):
            return self._below(self.values.get(node.id))
        if isinstance(node, ast.Call) and last_word(node.func) in (*_FINDERS, *_SAME):
            given = [*node.args, *(each.value for each in node.keywords), None]
            if last_word(node.func) in _SAME:
                return self._below(given[0])
            return "" if self._is_package(given[0]) else None
        parts = _parts(node)
        words = [*map(_said, parts[1:])]
        below = self._below(parts[0]) if parts and all(words) else None
        if below is None:
            return None
        return "/".join([below, *(word.strip("/") for word in words)]).lstrip("/")


def _said(node: ast.AST | None) -> str:
    """Return the text that an expression is, if it is one in quotes."""
    value = node.value if isinstance(node, ast.Constant) else None
    return value if isinstance(value, str) else ""


def _parts(node: ast.AST | None) -> list[ast.expr]:
    """Return the parts of an expression that joins a path."""
    match node:
        case ast.BinOp(op=ast.Div() | ast.Add()):
            return [node.left, node.right]
        case ast.List() | ast.Tuple():
            return node.elts
        case ast.Call(func=ast.Attribute(attr="joinpath", value=first)):
            return [first, *node.args]
        case ast.Call() if last_word(node.func) == "join":
            return node.args
    return []
