"""What the scopes of code declare: of two things with one name, which one a place means.

In C++ a name is looked for as a compiler does it, in the innermost scope first.
"""

from __future__ import annotations

import ast
import functools
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from pathlib import PurePosixPath
from typing import NamedTuple

from .cpp_blocks import tokenize
from .lines import split
from .python_blocks import SCOPES, module_of, nodes

Path = tuple[str, ...]
Declared = set[tuple[Path, str]]
"""Names, each with the scopes that it is in, the outer ones first."""
MARK = "\ua78f"
"""What ends a name while it is told to be the developer's: a letter that nobody writes."""
_KINDS = ("class", "struct", "union", "enum")
_NO_TYPE = {"return", "new", "delete", "throw", "case", "goto", "operator", "class", "struct"}


class Scope(NamedTuple):
    """What a bracket opens."""

    path: Path
    """Its names, after those that it is in; an empty one where it has none."""
    kind: str
    """`namespace`, `class` or `enum`; empty where it is of a function."""
    bases: set[str]
    start: int
    """The first sign of what says so."""


@dataclass(frozen=True)
class Code:
    """The words and signs of C++, by their numbers."""

    signs: list[str]
    lines: list[int]
    closed: dict[int, int]
    """Where each bracket closes; the last one where none does."""
    around: dict[int, int | None]
    """The bracket that each is in."""

    @functools.cached_property
    def scopes(self) -> dict[int | None, Scope]:
        """The scopes by their brackets, that of the file by None."""
        found: dict[int | None, Scope] = {None: Scope((), "namespace", set(), 0)}
        start = 0
        for at, sign in enumerate(self.signs):
            if sign in ("{", "("):
                outer = found[self.around[at]]
                names, kind, bases = _opened(self.signs[start : at + 1], outer.kind, at)
                found[at] = Scope((*outer.path, *names), kind, bases, start)
            if sign in ("{", "}", ";"):
                start = at + 1
        return found


@functools.lru_cache(maxsize=64)
def code(text: str) -> Code:
    """Read a file of C++, but for brackets of arrays."""
    tokens = [one for one in tokenize(text) if one.kind in ("word", "sign")]
    signs = [one.text for one in tokens]
    open_: list[int] = []
    closed = dict.fromkeys(range(len(tokens)), len(tokens) - 1)
    around: dict[int, int | None] = {}
    for at, sign in enumerate(signs):
        if sign in ("}", ")") and open_:
            closed[open_.pop()] = at
        around[at] = open_[-1] if open_ else None
        if sign in ("{", "("):
            open_.append(at)
    return Code(signs, [one.line for one in tokens], closed, around)


def type_before(signs: Sequence[str], at: int) -> list[str]:
    """Return the words of the type before a name, if there is one: its arguments, then its own."""
    at -= 1
    while at > 0 and signs[at] in ("&", "*", "const"):
        at -= 1
    inner: list[str] = []
    if signs[at] == ">":
        depth = 0
        while at >= 0:
            depth += {">": 1, "<": -1}.get(signs[at], 0)
            inner += [signs[at]] if re.fullmatch(r"\w+", signs[at]) else []
            at -= 1
            if not depth:
                break
    words: list[str] = []
    while at >= 0 and re.fullmatch(r"[A-Za-z_]\w*", signs[at]):
        words.insert(0, signs[at])
        if at < 1 or signs[at - 1] != "::":
            break
        at -= 2
    return [] if not words or words[-1] in _NO_TYPE else [*inner, *words]


def _opened(head: list[str], around: str, at: int) -> tuple[Path, str, set[str]]:
    """Return the names, the kind and the bases of what the last sign, a bracket, opens."""
    head, sign = head[:-1], head[-1]
    if sign == "(":
        return _chain(head, len(head))[:-1] if around else (), "", set()
    if "namespace" in head:
        words = [word for word in head[head.index("namespace") + 1 :] if word.isidentifier()]
        return (*words,) or ("",), "namespace", set()
    at_kind = max((i for i, word in enumerate(head) if word in _KINDS), default=len(head))
    rest = head[at_kind + 1 :]
    if at_kind < len(head) and {"(", "="}.isdisjoint(rest) and rest.count("<") == rest.count(">"):
        end = next((i for i, word in enumerate(rest) if word in (":", "<")), len(rest))
        words = [word for word in rest[:end] if word != "final"]
        kind = "enum" if "enum" in head else "class"
        return (
            _chain(words, len(words)) or ("",),
            kind,
            {*" ".join(rest[end:]).replace(" :: ", "::").split()},
        )
    open_ = [i for i, word in enumerate(head) if word == "("] if around else []
    names = [_chain(head, i) for i in open_ if head[:i].count("<") == head[:i].count(">")][:1]
    return (*(name for chain in names for name in chain[:-1]), str(at)), "", set()


def _chain(signs: list[str], end: int) -> Path:
    """Return the words that end before a sign, joined by `::`."""
    at = end - 1
    while at > 1 and signs[at - 1] == "::" and signs[at - 2].isidentifier():
        at -= 2
    return (*signs[max(at, 0) : end : 2],)


def declared(text: str, names: Collection[str], spaces: Collection[str] = ()) -> Declared:
    """Return which of some names a file declares: types, and what its namespaces have.

    Of `spaces`, which only namespaces and types have.
    """
    both = {*names, *spaces}
    if not any(name in text for name in both):
        return set()
    read = code(text)
    opened = ((path[:-1], path[-1]) for path, kind, *_ in read.scopes.values() if kind and path)
    found = {each for each in _declared(read) if each[1] in names}
    return found | {each for each in opened if each[1] in both}


def _declared(read: Code) -> Iterator[tuple[Path, str]]:
    signs, is_given = ["", "", *read.signs, ""], False
    for at, sign in enumerate(read.signs):
        friend, before, _, after = signs[at : at + 4]
        is_given = sign == "=" or (is_given and sign not in ("{", "}", ";"))
        path, kind, *_ = read.scopes[read.around[at]]
        is_type = before in _KINDS and after == ";" and friend != "friend"
        if is_type or (before, after) == ("using", "="):
            yield path, sign
        elif kind == "enum" and before in ("{", ","):
            yield path, sign
            yield path[:-1], sign
        elif kind == "namespace" and not is_given and after in ("(", "=", ";", "{", "["):
            yield from [(path, sign)] if type_before(read.signs, at) else []


def is_shared(found: tuple[Path, str]) -> bool:
    """Say whether other files see it, too."""
    return all(map(str.isidentifier, found[0]))


def marked_in_cpp(text: str, own: Declared, old: Declared, names: Collection[str]) -> str:
    """Return a file with a mark behind each of some names that is the developer's.

    `own` and `old` are what the package has declared, the developer's and the model's.
    """
    if not own:
        return text
    read = code(text)
    signs, within = read.signs, read.scopes
    aliases: dict[str, Path] = {}
    near: Declared = set()  # what `using` lets stand alone, by the scope that it is in
    for at, sign in enumerate(signs):
        words = [*takewhile(";".__ne__, signs[at + 1 :])] if sign in ("using", "namespace") else []
        whole = (*(word for word in words if word.isidentifier() and word != "namespace"),)
        if sign == "namespace" and words[1:2] == ["="]:
            aliases[whole[0]] = whole[1:]
        elif sign == "using" and whole and "=" not in words:
            here = within[read.around[at]].path
            ends = ((each[0] if "namespace" in words else (*each[0], each[1])) for each in own)
            pairs = zip(own, ends, strict=True)
            near |= {(here, name) for (_, name), end in pairs if end[-len(whole) :] == whole}

    def is_own(at: int) -> bool:
        before = signs[max(at - 2, 0) : at]
        if before[-1:] in (["."], ["->"]):
            return False
        chain = _chain(signs, at + 1)[:-1]
        path = within[read.around[at]].path
        is_near = any((path[:end], signs[at]) in near for end in range(len(path) + 1))
        if not chain and (is_near or before == [">", "::"]):
            return any(signs[at] == name for _, name in own)
        chain = (*aliases.get(chain[0], chain[:1]), *chain[1:]) if chain else ()
        for end in range(len(path), -1, -1):
            places = {((*path[:end], *inner, *chain), signs[at]) for inner in ((), ("",))}
            if places & (own | old):
                return bool(places & own)
        return False

    parts: list[str] = []
    number = 0
    for token in tokenize(text):
        is_sign = token.kind in ("word", "sign")
        parts += [token.text, MARK * (is_sign and token.text in names and is_own(number))]
        number += is_sign
    return "".join(parts)


def with_ends(before: str, after: str) -> str:
    """Return exchanged C++ whose comments at the ends of namespaces say their names of `after`."""
    lines, read, other = split(after), code(before), code(after)
    for at, end in other.closed.items():
        scope = read.scopes.get(at)
        if scope is None or scope.kind != "namespace":
            continue
        new = other.scopes[at].path
        for start in range(len(new)):
            name = re.escape("::".join(scope.path[start:]))
            form = rf"(\}}\s*(?://|/\*)[^*]*?\bnamespace\s+){name}(?![\w:])"
            line = other.lines[end]
            lines[line] = re.sub(form, rf"\g<1>{'::'.join(new[start:])}", lines[line])
    return "".join(lines)


def marked_in_python(
    path: str,
    text: str,
    own: Collection[str],
    names: Collection[str],
    members: Collection[str],
    classes: Collection[str],
) -> str:
    """Return a file with a mark behind each of some names that is the developer's.

    `own` are the developer's modules and what these define, each in full; `members` are names
    that count behind another one alone; `classes` are the model's.
    """
    both = {*names, *members}
    full = {name for name in own if name.rpartition(".")[2] in both}
    full |= {name[:-1] + end for name in own if name.endswith(".*") for end in both}
    lines, folder = split(text), PurePosixPath(path).parent.parts
    whole = {*range(len(lines))}
    forms: list[tuple[str, set[int]]] = []

    def bind(name: str, path: str, within: set[int] = whole) -> None:
        """Note what a name stands for in some lines."""
        ends = (each.removeprefix(path) for each in full if f"{each}.".startswith(f"{path}."))
        forms.extend((name + end, within) for end in ends)

    for node in nodes(text):
        inside = _lines(node) & whole
        if isinstance(node, ast.ImportFrom):
            module = module_of(node, folder)
            forms += [("." * node.level + (node.module or ""), inside)] if module in full else []
            for alias in node.names:
                bind(alias.name, f"{module}.{alias.name}", inside)
                bind(alias.asname or alias.name, f"{module}.{alias.name}")
        elif isinstance(node, ast.Import):
            for alias in node.names:
                bind(alias.name, alias.name, inside)
                root = alias.name if alias.asname else alias.name.partition(".")[0]
                bind(alias.asname or root, root)
        elif isinstance(node, SCOPES) and node.name not in classes:
            inner = {each.name for each in node.body if isinstance(each, ast.ClassDef)} & {*names}
            if inner and isinstance(node, ast.ClassDef):
                ways = [(node.name, whole), ("self", inside), ("cls", inside)]
                forms += [(f"{way}.{name}", within) for way, within in ways for name in inner]
                methods = (each for each in node.body if isinstance(each, SCOPES[:2]))
                inside = inside.difference(*map(_lines, methods))  # which do not see its names
            forms += [(name, inside) for name in inner]
    forms = [(form, within) for form, within in forms if "." in form or form not in members]
    for form, within in sorted(forms, key=lambda each: each[0], reverse=True):
        pattern = re.compile(rf"(?<![\w.]){re.escape(form)}\b")
        for number in within:
            lines[number] = pattern.sub(rf"\g<0>{MARK}", lines[number])
    return "".join(lines)


def _lines(node: ast.AST) -> set[int]:
    return {*range(getattr(node, "lineno", 1) - 1, getattr(node, "end_lineno", 0))}
