"""What files say of the package where ROS, or Python, looks for something by its name.

Such a word is in a text, whose origin nobody can tell: it is the package beside it that says whose
it is. A program, a path below the share of the package, a module. Decision 155.
"""

from __future__ import annotations

import ast
import contextlib
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from itertools import accumulate
from typing import NamedTuple

import yaml

from .depth import compose
from .languages import PYTHON, TEXT, YAML, Language
from .lines import split
from .python_blocks import nodes
from .receivers import last_word
from .xml_blocks import Attribute

STARTED = ("exec", "executable", "type", "plugin")
"""What has the name of a program, or the class of a component, beside a package."""
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

    def attribute(self, found: Attribute) -> str:
        """Return the value that an attribute of a file of XML has after the update."""
        element, name, value = found
        if name in STARTED and element.endswith(f" of {self.package}"):
            return self.programs.get(value, value)
        return self.exchanged(TEXT, value)

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
            (rf"({_INSTALLED})({name}\.[\w.]+)(?=:)", self._installed),
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
            for start, end, before, after in sorted({*edits}, reverse=True):
                if (written := text[start:end]).count(before) == 1:
                    text = text[:start] + written.replace(before, after) + text[end:]
        return text

    def _installed(self, found: re.Match[str]) -> str:
        """Return a program that `setup.py` installs, and the module that it runs."""
        before, module = found.groups()
        new = self._module(module)
        if new != module:
            before = re.sub(r"[\w.-]+", lambda m: self.programs.get(m[0], m[0]), before, count=1)
        return before + new

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


class _InPython:
    """The calls and paths of a launch file, or another module."""

    def __init__(self, text: str, about: References) -> None:
        self.about, self.tree = about, nodes(text)
        starts = accumulate(map(len, split(text)), initial=0)
        self.lines = [*zip(split(text), starts, strict=False)]
        often: Counter[str] = Counter()
        given: dict[str, list[ast.expr]] = {}
        for node in self.tree:
            if isinstance(node, ast.arg):
                often[node.arg] += 1
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                often[node.id] += 1
            elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                given.setdefault(node.targets[0].id, []).append(node.value)
        self.values = {
            name: values[0]
            for name, values in given.items()
            if len(values) == often[name] and len({*map(ast.dump, values)}) == 1
        }

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
            start = self._place(node.lineno, node.col_offset)
            end = self._place(node.end_lineno or 1, node.end_col_offset or 0)
            yield start, end, before, after

    def _place(self, line: int, column: int) -> int:
        """Return where in the text a place is, whose column counts bytes."""
        written, start = self.lines[line - 1]
        before = written.encode(errors="surrogatepass")[:column]
        return start + len(before.decode(errors="surrogatepass"))

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
