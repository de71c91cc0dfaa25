"""Python as blocks: functions, classes, imports, other statements."""

from __future__ import annotations

import ast
import functools
import inspect
import io
import textwrap
import tokenize
import warnings
from collections.abc import Sequence

from .blocks import Block, Span, arrange, squeezed, unicode
from .lines import split

COMMENT = "#"


def blocks(text: str) -> list[Block]:
    """Return the blocks of a module; those of a class, or of an `if` without `else`, are inside.

    Raises:
        ValueError: it is not Python.

    """
    lines = split(text)
    return arrange(lines, _spans(_parse(text).body, lines), 0, len(lines), COMMENT)


def same(one: str, other: str) -> bool:
    """Say whether two texts differ in form alone: their code, their comments are the same."""
    try:
        return _meaning(one) == _meaning(other)
    except ValueError:
        return "".join(one.split()) == "".join(other.split())


def _parse(text: str) -> ast.Module:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(unicode(text))
    except (SyntaxError, RecursionError, MemoryError) as error:
        raise ValueError(str(error)) from error


@functools.lru_cache(maxsize=2048)
def _meaning(text: str) -> tuple[str, list[str]]:
    dedented = textwrap.dedent(text)
    tree = _parse(dedented)
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
    spans = []
    for index, statement in enumerate(statements):
        start, end = _first(statement), statement.end_lineno or statement.lineno
        key = _key(statement, index)
        body = _body(statement)
        first = _first(body[0]) if body else 0
        if body and first > statement.lineno:
            while not lines[first - 2].strip() or lines[first - 2].lstrip().startswith(COMMENT):
                first -= 1
            items = tuple(_spans(body, lines))
            spans.append(Span(key, start - 1, end, (first - 1, end), items))
        else:
            spans.append(Span(key, start - 1, end))
    return spans


def _body(statement: ast.stmt) -> list[ast.stmt]:
    """Return the statements that a container holds."""
    if isinstance(statement, ast.If) and statement.orelse:
        return []
    return statement.body if isinstance(statement, ast.ClassDef | ast.If) else []


def _first(statement: ast.stmt) -> int:
    """Return the number of the first line of a statement, that of its decorators."""
    decorators: list[ast.expr] = getattr(statement, "decorator_list", [])
    return min([statement.lineno, *(decorator.lineno for decorator in decorators)])


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
    return squeezed(ast.unparse(statement))
