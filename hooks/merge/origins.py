"""Where the names of a file come from: from the package itself, or from elsewhere.

It is not how a name looks that tells (decision 28). In doubt it is from elsewhere.
"""

from __future__ import annotations

import ast
import contextlib
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import takewhile

from .languages import CPP, PYTHON, Language
from .python_blocks import last_line, nodes
from .receivers import Lent, is_class, last_word, lent_in_cpp, lent_in_python, type_words
from .scopes import Code, code
from .tokens import BEFORE_TYPE, Word

SELF = ("self", "cls", "this")
Names = Collection[str]
Classes = Mapping[str, set[str]]
"""Classes, each with the words that it has."""


@dataclass
class Origins:
    """What the code of a file says of its names."""

    ours: set[str] = field(default_factory=set)
    modules: set[str] = field(default_factory=set)
    """Those of ours that an import of a whole module gives."""
    foreign: set[str] = field(default_factory=set)
    holders: dict[str, set[str] | None] = field(default_factory=dict)
    """Names of objects whose classes are of the package, with the words that these have: none are
    any."""
    known_holders: Names = ()
    """Names that such objects have in any file, as the dictionary says."""
    lent: Lent = field(default_factory=lambda: Lent(()))
    """Where these are of another class, as the code says."""
    keywords: set[tuple[int, str]] = field(default_factory=set)
    """The arguments of these classes, each with its line."""
    from_imports: set[int] = field(default_factory=set)
    """The lines of imports whose names are members of a module."""
    imports: dict[int, bool] = field(default_factory=dict)
    """By line of an import, the first counted 0, whether it is of the package."""

    types: set[str] = field(default_factory=set)
    """Names of the package that another class of the developer's may use, too."""
    within: dict[int, set[str]] = field(default_factory=dict)
    """By line of a class, the words that it has of the package's, `super` where all bases are."""
    classes: dict[str, set[str]] = field(default_factory=dict)
    """Those of the package, and what is related to them, with their words."""

    def relate(self, found: Iterable[Class], classes: Classes, names: Names = ()) -> set[str]:
        """Take what a file says of classes; return those that are related to the package's.

        These have `names`, too: all that stand by themselves are exchanged.
        """
        known = [*found]
        self.classes = {name: {*words, *names} for name, words in related(known, classes).items()}
        for name, bases, lines in known:
            words = self.classes.get(name, set())
            outer = {"super"} if words and "" not in bases else set()
            self.within |= dict.fromkeys(lines, words | outer)
        return {*self.classes}

    def hold(self, name: str, classes: Names) -> None:
        """Note that objects of some classes of the package have a name."""
        if (words := self.holders.setdefault(name, set())) is not None:
            words.update(*(self.classes[each] for each in classes))

    def is_holder(self, name: str, line: int) -> bool:
        """Say whether an object is of a class of the package, in a line."""
        is_known = name in self.holders or name.strip("_") in self.known_holders
        return is_known and not self._is_lent(name, line)

    def _is_lent(self, name: str, line: int) -> bool:
        return line in self.lent.get(name, ())

    def is_argument(self, word: Word) -> bool:
        """Say whether a word names a field where an object of these classes is made."""
        is_named = word.after == "=" and not word.chain
        return is_named and (word.line, word.text) in self.keywords

    def has(self, word: Word, known: Names) -> bool:
        """Say whether a word is a name of the package; `known` are those that are, by themselves.

        A member is one where the object, the module, the namespace before it is.
        """
        if word.line in self.imports:
            return self.imports[word.line]
        if self.is_argument(word):
            return True
        if word.before[1] == "->" and word.chain[-1:] in BEFORE_TYPE and word.text in self.types:
            word = word._replace(chain=())
        within = self.within.get(word.line)
        is_super = word.chain == ("super", ")") and "super" in (within or ())
        if is_super or (word.before[1] == "def" and not word.chain):
            word = word._replace(chain=SELF[:1])
        if (word.chain or (word.text,))[0] in self.foreign:
            return False
        if within == set() and (not word.chain or word.chain[-1] in SELF):
            is_space = word.after == "::" and word.text in self.ours
            return not word.chain and (is_space or word.text in self.types)
        if not word.chain:
            return word.text in self.ours or word.text in known
        holder = word.chain[-1]
        if holder == ")":
            return self._has_returned(word.chain, word.line)
        if holder in SELF:
            return word.text in known or word.text in (within or ())
        if all(part in known or part in self.ours for part in word.chain):
            return word.text in self.classes.get(holder, {word.text})
        first, *others = word.chain
        is_own = not others or (
            len(others) == 1 and (first in SELF or self.is_holder(first, word.line))
        )
        is_logic = first in self.holders and others == ["impl"]  # of a harness of tests
        words = self.holders.get(holder)
        is_member = words is None or word.text in words
        if is_logic:
            return word.text in self.ours
        return is_own and is_member and self.is_holder(holder, word.line)

    def _has_returned(self, chain: tuple[str, ...], line: int) -> bool:
        """Say whether calls, one of what another has returned, give a harness of tests or data."""
        first, *calls = chain
        if chain == (_CYCLE, ")"):
            return first not in self.foreign
        is_each = all(re.fullmatch(rf"{_CYCLE}|in_\w+", name) for name in calls[::2])
        is_harness = first in self.holders and not self._is_lent(first, line)
        return is_harness and {*calls[1::2]} == {")"} and is_each


def origins(
    known: Language, text: str, roots: Names, names: Names, classes: Classes, holders: Names = ()
) -> Origins:
    """Read where the names of a file come from.

    Args:
        known: the language of the text.
        text: all of a file.
        roots: the package's own modules, or folders of headers.
        names: what is looked for.
        classes: the classes of the package, and those of the developer's that are related to them.
        holders: what the dictionary says that objects of these classes are called.

    """
    found = Origins(known_holders=holders)
    if known is PYTHON:
        with contextlib.suppress(ValueError):
            _python(found, nodes(text), roots, names, classes)
    elif known is CPP:
        _cpp(found, text, roots, names, classes)
    return found


def _python(
    found: Origins, tree: Sequence[ast.AST], roots: Names, names: Names, classes: Classes
) -> None:
    _imports(found, tree, roots, names)
    found.types = found.ours
    ours = found.relate(_python_classes(tree, found.foreign), classes) - found.foreign
    found.lent = lent_in_python(tree, ours, found.foreign)
    for target, value in _bindings(tree):
        word, made = last_word(value), {*type_words(value)} & ours
        if made:
            found.hold(target, made)
        elif isinstance(value, ast.Name | ast.Attribute) and (
            found.is_holder(word, value.lineno - 1) or word == _CYCLE
        ):
            found.holders[target] = found.holders.get(word)
    found.keywords = _keywords(found, tree, ours)


def _imports(found: Origins, tree: Iterable[ast.AST], roots: Names, names: Names) -> None:
    for node in tree:
        if isinstance(node, ast.ImportFrom):
            module = node.module or ""
            is_ours = bool(node.level) or module.split(".")[0] in roots or module == _HARNESS
            bound = {alias.asname or alias.name for alias in node.names}
            (found.ours if is_ours else found.foreign).update(bound)
            found.ours |= {*names} if is_ours and "*" in bound else set()
            lines = range(node.lineno - 1, last_line(node))
            found.imports |= dict.fromkeys(lines, is_ours)
            found.from_imports |= {*lines}
        elif isinstance(node, ast.Import):
            for alias in node.names:
                parts, line = alias.name.split("."), node.lineno - 1
                is_ours = parts[0] in roots
                bound = {alias.asname} if alias.asname else {*parts}
                (found.ours if is_ours else found.foreign).update(bound)
                found.modules |= bound if is_ours else set()
                found.imports[line] = is_ours or found.imports.get(line, False)
    found.foreign -= found.ours


def _keywords(found: Origins, tree: Iterable[ast.AST], classes: set[str]) -> set[tuple[int, str]]:
    """Return the keywords of calls and patterns of some classes, but for those in doubt."""
    ours: set[tuple[int, str]] = set()
    others: set[tuple[int, str]] = set()
    for node in tree:
        if isinstance(node, ast.Call):
            function, first = node.func, node.args[0] if node.args else node.func
            names = [(word.lineno, word.arg or "") for word in node.keywords]
        elif isinstance(node, ast.MatchClass):
            function = first = node.cls
            names = [(p.lineno, n) for p, n in zip(node.kwd_patterns, node.kwd_attrs, strict=True)]
        else:
            continue
        is_changed = last_word(function) in _OF_FIELDS and (
            found.is_holder(last_word(first), first.lineno - 1)
            or bool({*type_words(first)} & classes)
        )
        is_made = last_word(function) in classes and not {*type_words(function)} & found.foreign
        keywords = ours if is_made or is_changed else others
        keywords |= {(line - 1, name) for line, name in names}
    return ours - others


_TYPES = (ast.Name, ast.Attribute, ast.Subscript, ast.BinOp)
"""What is written in place of a class: itself, `Optional[...]`, `... | None`."""
_HARNESS = "support.harness"
"""The module of a package's tests that has the two below."""
_CYCLE = "run_cycle"
"""What runs a cycle in tests, and returns its data."""
_FAKE = "fake"
"""What makes an object of its first argument, a class, in tests."""
_OF_FIELDS = ("replace", _CYCLE)
"""Functions whose keywords are fields of their first argument: of dataclasses, in tests."""


Class = tuple[str, set[str], range]
"""A class: its name, what it derives from, "" being of others, and its lines.

Another name of a class has none, and is of that one.
"""


def related(found: Iterable[Class], classes: Classes) -> dict[str, set[str]]:
    """Return these classes, and those that derive from one, or the other way, with their words."""
    known = [*found]
    own = {name for name, *_ in known}
    pairs = [(name, base) for name, bases, _ in known for base in sorted(bases)]
    kin = {**classes}
    for steps in (pairs, [pair[::-1] for pair in pairs]):
        size = 0
        while size < len(kin):
            size = len(kin)
            for name, other in steps:
                if other in kin and name in own:
                    kin.setdefault(name, kin[other])
    return kin


def classes_in(known: Language, text: str, roots: Names = ()) -> list[Class]:
    """Return the classes of a file."""
    found = Origins()
    if known is PYTHON:
        with contextlib.suppress(ValueError):
            _imports(found, nodes(text), roots, ())
            return [*_python_classes(nodes(text), found.foreign)]
    return [*_cpp_classes(code(text), roots)] if known is CPP else []


def _python_classes(tree: Iterable[ast.AST], foreign: set[str]) -> Iterator[Class]:
    for node in tree:
        if isinstance(node, ast.ClassDef):
            bases = [{*type_words(base)} for base in node.bases]
            bases = [{""} if base & foreign else base for base in bases]
            yield node.name, set().union(*bases), range(node.lineno - 1, last_line(node))
        elif isinstance(node, ast.Assign | ast.AnnAssign) and isinstance(node.value, _TYPES):
            targets = [node.target] if isinstance(node, ast.AnnAssign) else node.targets
            for target in targets if any(map(is_class, type_words(node.value))) else ():
                yield last_word(target), {*type_words(node.value)}, range(0)


def _cpp_classes(read: Code, roots: Names) -> Iterator[Class]:
    """Yield the classes of a file, and what it defines of them out of their bodies."""
    within = read.scopes
    for number, sign in enumerate(read.signs):
        if sign in ("using", "typedef"):
            after = [*takewhile(";".__ne__, read.signs[number + 1 :])]
            words, is_given = [*filter(str.isidentifier, after)], after[1:2] == ["="]
            for name in words[:1] if is_given else words[-1:] if sign == "typedef" else ():
                yield name, {*words} - {name}, range(0)
    for at, (path, kind, bases, start) in within.items():
        chains = [base.removeprefix("::").split("::") for base in bases]
        bases = {chain[-1] if chain[0] in (*roots, chain[-1]) else "" for chain in chains}
        if at is None or kind == "namespace" or read.signs[at] == "(":
            continue
        names = path[len(within[read.around[at]].path) :]
        for name in names[-1:] if kind else names[:-1][-1:]:
            yield name, bases, range(read.lines[start], read.lines[read.closed[at]] + 1)


def _bindings(tree: Iterable[ast.AST]) -> Iterator[tuple[str, ast.expr]]:
    """Yield the names of arguments and variables, each with its type or its value."""
    for node in tree:
        if isinstance(node, ast.arg) and node.annotation:
            yield node.arg, node.annotation
        elif isinstance(node, ast.AnnAssign):
            yield last_word(node.target), node.annotation
        elif isinstance(node, ast.Assign):
            value = _maker(node.value)
            yield from ((last_word(target), value) for target in node.targets if value)
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and any(
            last_word(_maker(each) or each) == "fixture" for each in node.decorator_list
        ):
            given = (n.value for n in ast.walk(node) if isinstance(n, ast.Return | ast.Yield))
            yield from ((node.name, value) for value in map(_maker, given) if value)


def _maker(value: ast.expr | None) -> ast.expr | None:
    """Return what makes an object, or has it; nothing of another expression."""
    if isinstance(value, ast.Call):
        is_fake = last_word(value.func) == _FAKE and value.args
        return value.args[0] if is_fake else value.func
    return value if isinstance(value, ast.Name | ast.Attribute) else None


_INCLUDE = re.compile(r'(?m)^[ \t]*#[ \t]*include[ \t]*[<"](\w+|\.\.?)/')
_USING = re.compile(r"\busing\s+(?:(namespace)\s+)?(?:(\w+)\s*=\s*)?(?:::)?(\w+)(?:::(\w+))*\s*;")
_ALIAS = re.compile(r"\bnamespace\s+(\w+)\s*=\s*(?:::)?(\w+)")


def _cpp(found: Origins, text: str, roots: Names, names: Names, classes: Classes) -> None:
    spaces = "|".join(map(re.escape, roots)) or "(?!)"
    is_user = any(root in {*roots, ".", ".."} for root in _INCLUDE.findall(text))
    is_user = is_user or bool(
        re.search(rf"\bnamespace\s+(?:{spaces})\b|(?<![\w:])(?:{spaces})::", text)
    )
    for kind, alias, root, last in _USING.findall(text):
        if root not in {*roots, *classes, *names, "std"}:
            is_user = is_user and not kind
            found.foreign |= {alias or last} - {""}
    if is_user:
        found.ours |= {*names}
        found.ours |= {name for name, root in _ALIAS.findall(text) if root in {*roots, *names}}
    found.types = {*classes} | {*roots}
    kin = found.relate(_cpp_classes(code(text), roots), classes, names)
    found.ours |= kin if is_user else set()
    types = "|".join(map(re.escape, kin - found.foreign)) or "(?!)"
    ours = rf"(?<![\w:])(?:(?:::)?(?:{spaces})::){'?' * is_user}({types})\b"
    declared = rf"{ours}[\s&*>)]*(?:const\b)?[\s&*]*\b(\w+)\b(?!\s*::)"
    made = rf"\bauto\b[\s&*]*(\w+)\s*=[^;=]*?{ours}"
    for type_, name in [*re.findall(declared, text), *(m[::-1] for m in re.findall(made, text))]:
        found.hold(name, [type_])
    for name, other in re.findall(r"\bauto\b[\s&*]*(\w+)\s*=[\s&*]*(\w+)\s*;", text):
        if found.is_holder(other, -1):
            found.holders[name] = found.holders.get(other)
    objects = {*found.known_holders, *found.holders}
    found.lent = lent_in_cpp(text, objects, kin - found.foreign, {*roots})
    for match in re.finditer(rf"{ours}\s*\w*\s*\{{[^{{}}]*\}}", text):
        for name in re.finditer(r"[{,]\s*\.(\w+)\s*=", match[0]):
            line = text.count("\n", 0, match.start() + name.start(1))
            found.keywords.add((line, name[1]))
