"""Python as blocks: functions, classes, imports, other statements."""

from __future__ import annotations

import ast
import contextlib
import functools
import inspect
import io
import re
import textwrap
import tokenize
import warnings
from collections.abc import Iterator, Sequence
from typing import cast

from .blocks import THEN, Block, Span, arrange, comments, squeezed, unicode
from .lines import Merged, split

_ENDS = ("", " pass\n", "\nclass _: pass\n")
"""What makes code of a text: nothing, or it is a head without its body, or decorators alone."""
_WIDTH = 100
"""Of a line with its end, as the linters of ROS allow it."""
_CONTAINERS = (ast.ClassDef, ast.If, ast.Try, ast.With)
SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
_Part = tuple[str, int, list[ast.stmt]]


def blocks(text: str) -> list[Block]:
    """Return the blocks of a module; those of a class, `if`, `try` or `with` are inside."""
    lines = split(text)
    module = cast(ast.Module, nodes(text)[0])
    return arrange(lines, _spans(module.body, lines))


def same(one: str, other: str) -> bool:
    """Say whether two texts differ in form alone: their code, their comments are the same."""
    for end in _ENDS if one != other and _words(one) == _words(other) else ():
        with contextlib.suppress(ValueError):
            return _meaning(one, end) == _meaning(other, end)
    return "".join(one.split()) == "".join(other.split())


def _words(text: str) -> list[str]:
    """Return what no formatter changes: the words, but for the prefixes of strings."""
    return [word for word in re.findall(r"[^\W\d]\w*", text.lower()) if len(word) > 2]


@functools.lru_cache(maxsize=512)
def nodes(text: str) -> tuple[ast.AST, ...]:
    """Return the nodes of a module, itself the first; ValueError if that is no Python."""
    return (*ast.walk(parse(text)),)


def definitions(text: str) -> Iterator[str]:
    """Yield the names of the classes, functions and variables of a module; none of no Python.

    Those in a class come after its name; `*` is what a variable of the module may have.
    """
    with contextlib.suppress(ValueError):
        yield from _defined(nodes(text)[0])


def _defined(node: ast.AST, owner: str = "") -> Iterator[str]:
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, SCOPES):
            yield owner + inner.name
            is_class = isinstance(inner, ast.ClassDef)
            yield from _defined(inner, f"{owner}{inner.name}.") if is_class else ()
        elif isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store):
            yield owner + inner.id
            yield from [] if owner else [f"{inner.id}.*"]
        elif isinstance(inner, ast.stmt | ast.excepthandler | ast.Tuple):
            yield from _defined(inner, owner)


def imports(text: str, folder: Sequence[str]) -> Iterator[tuple[int, str, str]]:
    """Yield the modules that a file in a folder may import, and what it imports of them.

    Each with its line, from 0, and with the name that the file has of it, which whole modules
    have not; none of no Python.
    """
    with contextlib.suppress(ValueError):
        for node in nodes(text):
            if isinstance(node, ast.Import):
                yield from ((node.lineno - 1, "", alias.name) for alias in node.names)
            elif isinstance(node, ast.ImportFrom):
                at, module = node.lineno - 1, module_of(node, folder)
                yield at, "", module
                yield from ((at, a.asname or a.name, f"{module}.{a.name}") for a in node.names)


def in_quotes(text: str) -> Iterator[tuple[int, int]]:
    """Yield where quotes have code: types, the names of `__all__`. Lines, from 0, and bytes."""
    with contextlib.suppress(ValueError):
        for node in nodes(text):
            names = [*getattr(node, "targets", ()), getattr(node, "target", None)]
            is_all = any(getattr(name, "id", "") == "__all__" for name in names)
            fields = ("annotation", "returns", *(["value"] if is_all else ()))
            for part in filter(None, (getattr(node, each, None) for each in fields)):
                yield from ((each.lineno - 1, each.col_offset) for each in _quoted(part))


def _quoted(node: ast.AST) -> Iterator[ast.Constant]:
    if isinstance(node, ast.Constant):
        yield node
    elif not (isinstance(node, ast.Subscript) and "'Literal'" in ast.dump(node.value)):
        for inner in ast.iter_child_nodes(node):
            yield from _quoted(inner)


def module_of(node: ast.ImportFrom, folder: Sequence[str]) -> str:
    """Return the module that a file in a folder imports names of."""
    above = folder[: len(folder) + 1 - node.level] if node.level else ()
    return ".".join([*above, *filter(None, [node.module])])


def parse(text: str) -> ast.Module:
    """Read Python; ValueError if it is no Python."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(unicode(text))
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise ValueError(str(error)) from error


@functools.lru_cache(maxsize=2048)
def _meaning(text: str, end: str) -> tuple[str, list[str]]:
    dedented = textwrap.dedent(text)
    dedented = dedented.rstrip() + end if end else dedented
    tree = parse(dedented)
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and _is_text(node.value):
            node.value.value = inspect.cleandoc(node.value.value).strip()  # type: ignore[attr-defined]
    return ast.dump(tree), _comments(dedented)


def _comments(text: str) -> list[str]:
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(text).readline))
    except (tokenize.TokenError, SyntaxError) as error:
        raise ValueError(str(error)) from error
    return [token.string.strip("# \t") for token in tokens if token.type == tokenize.COMMENT]


def _spans(statements: Sequence[ast.stmt], lines: Sequence[str]) -> list[Span]:
    spans: list[Span] = []
    for index, statement in enumerate(statements):
        start, end = _first(statement) - 1, last_line(statement)
        key = _key(statement, index)
        if isinstance(statement, ast.ImportFrom) and (names := _names(statement)):
            spans.append(_import(key, start, end, names, spans))
            continue
        parts = _parts(statement, lines) if isinstance(statement, _CONTAINERS) else []
        heads = [*(line for _, line, _ in parts[1:]), end]
        branches = []
        for (name, line, body), until in zip(parts, heads, strict=bool(parts)):
            first = _first(body[0]) - 1
            while first > line and not lines[first - 1].split("#")[0].strip():
                first -= 1
            items = tuple(_spans(body, lines))
            branches.append(Span(name, line, until, (first, until), items))
        if any(one.body and one.body[0] <= one.start for one in branches) or not branches:
            spans.append(Span(key, start, end))
        elif len(branches) == 1:
            spans.append(Span(key, start, end, branches[0].body, branches[0].items))
        else:
            inside = branches[0].body or (start, end)
            branches[0] = Span(THEN, inside[0], inside[1], inside, branches[0].items)
            spans.append(Span(key, start, end, (inside[0], end), tuple(branches)))
    return spans


def _names(statement: ast.ImportFrom) -> tuple[Span, ...]:
    """Return what an import names, where each name has a line, or an import, of its own."""
    lines = [statement.lineno, *(name.lineno for name in statement.names), last_line(statement)]
    if lines != sorted({*lines}) and not (len(statement.names) == 1 and lines[0] == lines[-1]):
        return ()
    return tuple(
        Span(f"name {name.name}", name.lineno - 1, last_line(name)) for name in statement.names
    )


def _import(key: str, start: int, end: int, names: tuple[Span, ...], spans: list[Span]) -> Span:
    """Return an import with its names; those of one name each, one below the other, are one."""
    if end > start + 1:
        return Span(key, start, end, (names[0].start, names[-1].end), names)
    if spans and spans[-1].key == key and spans[-1].body == (spans[-1].start, start):
        before = spans.pop()
        start, names = before.start, (*before.items, *names)
    return Span(key, start, end, (start, end), names)


def joined_import(mine: str, old: str, new: str) -> str | None:
    """Merge the names that an import has in three versions, laid out as in the developer's.

    None where one of them is no single import of names, or has comments between these. The
    developer may have none, an empty text.
    """
    sides = _imported(mine or old, old, new)
    if not sides:
        return None
    (mine_head, ours, own), (old_head, base, was), (new_head, theirs, now) = sides
    ours = ours if mine else []
    head = new_head if mine_head == old_head else mine_head
    comment = now if own == was else own
    gone = {*base} - {*theirs}
    names = [name for name in ours if name.split()[0] not in gone]
    names += [name for name in theirs if name not in base and name not in ours]
    if names == ours and comment == own and head == mine_head:
        return mine
    if ours == sorted(ours, key=str.lower):
        names.sort(key=str.lower)
    if not names:
        return ""
    line = f"{head}{', '.join(names)}{comment}\n"
    gap = re.match(r"(?:\s*\n)?", mine or old)[0]  # type: ignore[index]
    if "\n" not in mine.strip() and len(line) <= _WIDTH:
        return gap + line
    indent = head[: -len(head.lstrip())]
    inside = "".join(f"{indent}    {name},\n" for name in names)
    is_first = "#" in (mine or old).strip().partition("\n")[0]
    first, last = (comment, "") if is_first else ("", comment)
    return f"{gap}{head}({first}\n{inside}{indent}){last}\n"


def is_same_import(one: Block, other: Block) -> bool:
    """Say whether two imports are of a module that has another place, and of the same names.

    Not of messages: those of one name are others in each package.
    """
    sides = _imported(one.text, other.text) if one.key.startswith("from ") else []
    if not sides:
        return False
    (head, ours, _), (before, theirs, _) = sides
    modules = [text.split()[1].rpartition(".")[2] for text in (head, before)]
    is_module = modules[0] == modules[1] and modules[0] not in ("msg", "srv", "action")
    return is_module and ({*ours} >= {*theirs} or {*ours} <= {*theirs})


def _imported(*texts: str) -> list[tuple[str, list[str], str]]:
    """Return what stands before the names of imports, the names, and the comments at an end.

    Nothing where one of them is no single import of names, or has comments between these.
    """
    imports: list[tuple[str, list[str], str]] = []
    with contextlib.suppress(ValueError):
        for text in texts:
            statements = parse(textwrap.dedent(text)).body
            comments = re.findall(r"#.*", text)
            between = "".join(text.rstrip("\n").split("\n")[1:-1])
            found = [each for each in statements if isinstance(each, ast.ImportFrom)]
            head = re.match(r"(?:\s*\n)?([ \t]*from\s+\S+\s+import\s)", text)
            if not head or found != statements or len(comments) > 1 or "#" in between:
                return []
            names = [ast.unparse(alias) for each in found for alias in each.names]
            imports.append((head[1], names, "".join(f"  {each}" for each in comments)))
    return imports if len(imports) == len(texts) else []


def with_imports(merged: Merged) -> Merged:
    """Give each name an import of its own, where others have one."""
    heads = (re.match(r"\s*from \S+ import ", each) for each in merged if isinstance(each, str))
    head = next((found[0] for found in heads if found), None)
    if head is None:
        return merged
    return [
        re.sub(r"^\s*(\w+),$", rf"{head}\1", each) if isinstance(each, str) else each
        for each in merged
    ]


def asides(lines: Sequence[str]) -> list[str]:
    """Say of each line of a block whether it is a comment, or of a docstring."""
    found = comments("#")(lines)
    with contextlib.suppress(ValueError):
        for node in parse(textwrap.dedent("".join(lines))).body:
            first = node.body[0] if isinstance(node, SCOPES) else node
            if isinstance(first, ast.Expr) and _is_text(first.value):
                for at in range(first.lineno - 1, last_line(first)):
                    found[at] = "docstring"
    return found


def _parts(statement: ast.stmt, lines: Sequence[str]) -> list[_Part]:
    """Return what a container holds: the name, the line before and the statements of each part."""
    parts: list[_Part] = [(THEN, statement.lineno - 1, getattr(statement, "body", []))]
    for handler in getattr(statement, "handlers", []):
        what = f"except {ast.unparse(handler.type)}" if handler.type else "except"
        parts.append((what, handler.lineno - 1, handler.body))
    for name in ("orelse", "finalbody"):
        body = getattr(statement, name, [])
        line = _first(body[0]) - 1 if body else 0
        if body and lines[line].lstrip().startswith("elif"):
            (_, _, inner), *others = _parts(body[0], lines)
            parts += [(f"elif {ast.unparse(body[0].test)}", line, inner), *others]
        elif body:
            word = {"orelse": "else", "finalbody": "finally"}[name]
            while not re.match(rf"\s*{word}\s*:", lines[line]):
                line -= 1
            parts.append((word, line, body))
    return parts


def _first(statement: ast.stmt) -> int:
    """Return the number of the first line of a statement, that of its decorators."""
    decorators: list[ast.expr] = getattr(statement, "decorator_list", [])
    return min([statement.lineno, *(decorator.lineno for decorator in decorators)])


def last_line(node: ast.stmt | ast.alias) -> int:
    """Return the number of the last line of a node that was read."""
    return cast(int, node.end_lineno)


def _is_text(value: ast.expr) -> bool:
    return isinstance(value, ast.Constant) and isinstance(value.value, str)


def _key(statement: ast.stmt, index: int) -> str:
    if isinstance(statement, ast.FunctionDef | ast.AsyncFunctionDef):
        return f"def {statement.name}"
    if isinstance(statement, ast.ClassDef):
        return f"class {statement.name}"
    if isinstance(statement, ast.ImportFrom):
        return f"from {'.' * statement.level}{statement.module or ''}"
    if isinstance(statement, ast.Assign) and len(statement.targets) == 1:
        return f"{ast.unparse(statement.targets[0])} ="
    if isinstance(statement, ast.AnnAssign):
        return f"{ast.unparse(statement.target)} ="
    if index == 0 and isinstance(statement, ast.Expr) and _is_text(statement.value):
        return "docstring"
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call):
        call = statement.value
        first = next((a.value for a in call.args if isinstance(a, ast.Constant)), "")
        return f"{ast.unparse(call.func)}({first!s})"
    if isinstance(statement, ast.If):
        return f"if {ast.unparse(statement.test)}"
    if isinstance(statement, ast.Try | ast.With):
        return squeezed(ast.unparse(statement).split("\n")[0].rstrip(":"))
    return squeezed(ast.unparse(statement))
