"""Where a name such as `data` stands for an object of another class than the model's.

The class is in what declares or makes the object; where there is none, nobody can tell.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from .python_blocks import SCOPES, last_line
from .scopes import code, type_before

_NO_CLASS = {"Any", "Optional", "Union", "None", "Final", "ClassVar", "Annotated"}
"""Words of types in Python that are none of a class."""
_ENDLESS = 1 << 20


class _Binding(NamedTuple):
    """A name from a line on, in the lines of a scope; `is_ours` is None where nobody can tell."""

    name: str
    lines: range
    is_ours: bool | None


class Lent(dict[str, set[int]]):
    """The lines, from 0, where a name is an object of another class."""

    def __init__(self, bindings: Iterable[_Binding]) -> None:
        """Read bindings, the outer ones first; a later one takes the place of an earlier one."""
        super().__init__()
        for name, lines, is_ours in bindings:
            found = self.setdefault(name, set())
            if is_ours is False:
                found.update(lines)
            else:
                found.difference_update(lines)


def lent_in_python(tree: Sequence[ast.AST], ours: set[str], foreign: set[str]) -> Lent:
    """Read a module; `ours` are classes of the package, `foreign` what it imports of others."""
    found: list[tuple[int, int, _Binding]] = []
    scopes = [node for node in tree if isinstance(node, SCOPES)]

    def inner(line: int, kinds: tuple[type[ast.AST], ...]) -> tuple[int, range]:
        """Return the number of the innermost scope around a line, and its lines."""
        around = [
            (number, range(scope.lineno - 1, last_line(scope)))
            for number, scope in enumerate(scopes, 1)
            if scope.lineno <= line <= last_line(scope) and isinstance(scope, kinds)
        ]
        return around[-1] if around else (0, range(_ENDLESS))

    def bind(target: ast.expr, is_ours: bool | None, after: int) -> None:
        is_member = isinstance(target, ast.Attribute)
        number, lines = inner(target.lineno, (ast.ClassDef,) if is_member else SCOPES)
        lines = lines if is_member else range(after, lines.stop)
        found.append((number, target.lineno, _Binding(last_word(target), lines, is_ours)))

    for node in tree:
        if isinstance(node, ast.arg):
            is_ours = _is_type(node.annotation, ours) if node.annotation else None
            number, lines = inner(node.lineno, SCOPES)
            found.append((number, 0, _Binding(node.arg, lines, is_ours)))
        elif isinstance(node, ast.AnnAssign):
            bind(node.target, _is_type(node.annotation, ours), node.lineno - 1)
        elif isinstance(node, ast.Assign):
            for target in node.targets:
                bind(target, _is_made(node.value, ours, foreign), last_line(node))
        elif isinstance(node, ast.NamedExpr):
            bind(node.target, _is_made(node.value, ours, foreign), node.lineno - 1)
    return Lent(binding for *_, binding in sorted(found, key=lambda each: each[:2]))


def _is_type(annotation: ast.expr, ours: set[str]) -> bool | None:
    found = {*type_words(annotation)}
    if found & ours:
        return True
    return False if any(map(is_class, found - _NO_CLASS)) else None


def _is_made(value: ast.expr, ours: set[str], foreign: set[str]) -> bool | None:
    if {*type_words(value)} & ours:
        return True
    if not isinstance(value, ast.Call):
        return None
    first = value.func
    while isinstance(first, ast.Attribute):
        first = first.value
    is_other = is_class(last_word(value.func)) or last_word(first) in foreign
    return False if is_other else None


def is_class(word: str) -> bool:
    """Say whether a word is written as a class, and not as a variable of types."""
    return word[:1].isupper() and len(word) > 1


def last_word(node: ast.AST) -> str:
    """Return the last word of a name with dots."""
    return str(getattr(node, "attr", getattr(node, "id", "")))


def type_words(node: ast.expr) -> Iterator[str]:
    """Yield the words of a type, those in quotes too."""
    for inner in ast.walk(node):
        if isinstance(inner, ast.Constant):
            yield from re.findall(r"\w+", str(inner.value))
        elif name := last_word(inner):
            yield name


def lent_in_cpp(text: str, names: set[str], ours: set[str], spaces: set[str]) -> Lent:
    """Read a file of C++.

    Args:
        text: all of it.
        names: those of objects that are looked for, without the `_` of members.
        ours: classes of the package.
        spaces: its namespaces.

    """
    read = code(text)
    signs, lines = read.signs, read.lines
    generic = {*re.findall(r"\b(?:typename|class)(?:\s*\.\.\.)?\s+(\w+)\s*[,>=]", text)}

    def bindings() -> Iterator[tuple[bool, _Binding]]:
        for at, sign in enumerate(signs[:-1]):
            if sign.strip("_") in names and signs[at + 1] in (",", ")", ";", "=", "{", "("):
                type_ = type_before(signs, at)
                if not type_:
                    continue
                if type_[-1] == "auto":
                    type_ = [*_made(signs[at + 1 :])]
                is_member = read.scopes[read.around[at]].kind == "class"
                yield not is_member, _Binding(sign, scope(at, is_member), verdict(type_))

    def scope(at: int, is_member: bool) -> range:
        opener = read.around[at]
        end = len(signs) - 1 if opener is None else read.closed[opener]
        if opener is not None and signs[opener] == "(":
            body = next((i for i in range(end, len(signs)) if signs[i] in "{;"), end)
            end = read.closed[body] if signs[body] == "{" else end
        return range(lines[opener or 0] if is_member else lines[at], lines[end] + 1)

    def verdict(type_: list[str]) -> bool | None:
        if {*type_} & ours:
            return True
        is_other = is_class(type_[-1]) and type_[-1] not in generic if type_ else False
        is_other = is_other or (len(type_) > 1 and type_[0] not in (*spaces, "std", "auto"))
        return False if is_other else None

    return Lent(binding for _, binding in sorted(bindings(), key=lambda each: each[0]))


def _made(signs: Sequence[str]) -> Iterator[str]:
    """Yield the words of what `= Type{...}` makes, or of the first that is called."""
    for sign in signs[1:]:
        if sign in ("{", "(", ";", "."):
            return
        if re.fullmatch(r"[A-Za-z_]\w*", sign):
            yield sign
