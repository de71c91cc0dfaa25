"""Lines of Python that long names make too long, folded as ruff folds them."""

from __future__ import annotations

import ast
import functools
import io
import re
import textwrap
import tokenize
from collections import deque
from collections.abc import Iterator

from jinja2 import Environment
from jinja2.ext import Extension

_WIDTH = 99
_STEP = 4
_NO_LIMIT = "  # noqa: E501"
_SIGN = re.compile(r"""'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|#.*|\b(?:and|for|or)\b|\S""")
_EMPTY = re.compile(r"([(\[{])\n *([)\]}])")
_OPENING, _CLOSING = tuple("([{"), tuple(")]}")


class LayoutExtension(Extension):
    """Fold what templates of Python files give, whatever they include (decision 60)."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        environment.filters["fold_python"] = fold_python

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:
        """Put a template of a Python file into the filter, unless another has its frame."""
        if not (name or "").endswith(".py.jinja") or "{% extends" in source:
            return source
        return "{% filter fold_python %}" + source + "{% endfilter %}"


@functools.lru_cache(maxsize=512)  # an update renders most files alike, before and after
def fold_python(text: str) -> str:
    """Return Python whose lines have at most 99 columns; what cannot be folded says so to linters.

    Lines that fit stay as they are, but for brackets that a loop of the template has left empty.
    """
    text = _EMPTY.sub(r"\1\2", text)
    if all(len(line) <= _WIDTH for line in text.split("\n")):
        return text
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(text).readline))
    except (tokenize.TokenError, SyntaxError):
        return text
    rows = text.split("\n")
    found: list[str] = []
    done = 0
    for token in tokens:
        (first, _), (last, _) = token.start, token.end
        if token.type != tokenize.STRING or not token.line.lstrip().startswith('"""'):
            continue
        found += _code(rows[done : first - 1])
        found += _docstring(rows[first - 1 : last])
        done = last
    folded = "\n".join(found + _code(rows[done:]))
    return folded if _means_the_same(text, folded) else text


def _means_the_same(text: str, other: str) -> bool:
    """Tell whether Python makes the same of both, docstrings apart; not so where it makes none."""
    try:
        return _is_same(ast.parse(text), ast.parse(other))
    except SyntaxError:
        return False


def _is_same(one: object, other: object) -> bool:
    """Compare two nodes of syntax trees, or what is in their fields."""
    match one, other:
        case ast.Expr(ast.Constant(str())), ast.Expr(ast.Constant(str())):
            return True
        case ast.AST(), ast.AST():
            fields = ((getattr(one, name), getattr(other, name, None)) for name in one._fields)
            return type(one) is type(other) and all(_is_same(*field) for field in fields)
        case list(), list():
            return len(one) == len(other) and all(map(_is_same, one, other))
    return one == other


def _docstring(rows: list[str]) -> list[str]:
    """Shorten the sentence that sums up, which must stand on one line, and wrap the others."""
    summary = 0 if rows[0].strip() != '"""' else 1
    found: list[str] = []
    for number, row in enumerate(rows):
        if number == summary:
            while len(row) > _WIDTH and (match := re.fullmatch(r"(.*\w)[,:;] .*?\.?(\"*)", row)):
                row = f"{match[1]}.{match[2]}"
            found.append(row)
        else:
            found += _wrapped(row)
    if any(len(row) > _WIDTH for row in found) and not found[-1].endswith(_NO_LIMIT):
        found[-1] += _NO_LIMIT
    return found


def _wrapped(row: str, mark: str = "") -> list[str]:
    if len(row) <= _WIDTH:
        return [row]
    margin = " " * _indent(row) + mark
    wrapper = textwrap.TextWrapper(_WIDTH, break_long_words=False, break_on_hyphens=False)
    wrapper.initial_indent = wrapper.subsequent_indent = margin
    return wrapper.wrap(row[len(margin) :])


def _code(rows: list[str]) -> list[str]:
    """Fold the lines between docstrings."""
    found: list[str] = []
    rest = deque(rows)
    depth = 0
    while rest:
        row = rest.popleft()
        code, indent = row.strip(), _indent(row)
        change = _balance(code)
        if len(row) <= _WIDTH or code.endswith(_NO_LIMIT):
            found.append(row)
        elif code.startswith("#"):
            found += map(_marked, _wrapped(row, "# "))
        elif lines := _annotated(code, indent, rest):
            rest.extendleft(reversed(lines))
            continue
        elif change > 0 and (wrapped := _in_parentheses(code, indent, rest)):
            rest.extendleft(reversed(wrapped))
            continue
        elif change:
            found.append(_marked(row))
        else:
            found += [_marked(line) for line in _folded(code, indent, depth > 0)]
        depth += change
    return found


def _annotated(code: str, indent: int, rest: deque[str]) -> list[str]:
    """Return the lines of an assignment whose annotation is folded, for its value cannot begin.

    Nothing where it can. A value of one item is joined from the `rest` where it then fits.
    """
    margin = " " * indent
    match = re.fullmatch(r"(\w+: \w+\[)(.+)\] = ([(\[{].*)", code)
    if not match or match.start(3) + indent < _WIDTH:
        return []
    value = match[3]
    if value in _OPENING and rest and rest[1].strip() in _CLOSING:
        joined = value + rest[0].strip() + rest[1].strip()
        if len(f"{margin}] = {joined}") <= _WIDTH:
            value = joined
            rest.popleft()
            rest.popleft()
    return [margin + match[1], f"{margin}    {match[2]}", f"{margin}] = {value}"]


def _in_parentheses(code: str, indent: int, rest: deque[str]) -> list[str]:
    """Return the lines of an assignment whose value begins a line of its own.

    The lines after the first are taken from the `rest`. Nothing where it is no assignment, or
    where it would be too long even then.
    """
    target, sign, value = _assignment(code)
    inside = [" " * (indent + _STEP) + value]
    depth = _balance(code)
    for row in rest:
        depth += _balance(row)
        inside.append(" " * _STEP + row if row else row)
        if depth == 0:
            break
    margin = " " * indent
    begin = f"{margin}{target}{sign}("
    if len(begin) > _WIDTH or any(line.endswith(_NO_LIMIT) for line in _code(inside)):
        return []
    for _ in inside[1:]:
        rest.popleft()
    comma = "," if inside[-1].endswith(",") else ""
    inside[-1] = inside[-1].removesuffix(",")
    return [begin, *inside, f"{margin}){comma}"]


def _folded(code: str, indent: int, is_inside: bool) -> list[str]:
    """Return the lines of code that begins and ends at the same depth, after an indent."""
    margin = " " * indent
    if len(margin + code) <= _WIDTH:
        return [margin + code]
    if match := re.fullmatch(r"(from .* import )([^(]*)", code):
        names = [f"{margin}    {name}," for name in match[2].split(", ")]
        return [f"{margin}{match[1]}(", *names, f"{margin})"]
    for operator in ("or", "and", "+") if is_inside and _is_expression(code) else ():
        first, *terms = (term.strip() for term in _split(code, operator))
        if terms:
            lines = [first, *(f"{operator} {term}" for term in terms)]
            return [part for line in lines for part in _folded(line, indent, False)]
    pair = _pair(code, first=code.startswith("def "))
    if value := _value_in_parentheses(code, indent, is_inside, pair):
        return value
    if pair is None:
        return [margin + code]
    start, end = pair
    body = code[start + 1 : end].strip()
    is_display = not re.search(r"[\w)\]]$", code[:start])
    inside = _body(body, indent + _STEP, is_display)
    return [margin + code[: start + 1], *inside, margin + code[end:]]


def _value_in_parentheses(
    code: str, indent: int, is_inside: bool, pair: tuple[int, int] | None
) -> list[str]:
    """Return the lines of an assignment that no brackets of its value can fold."""
    target, sign, value = _assignment(code)
    comma = "," if is_inside and value.endswith(",") else ""
    value = value.removesuffix(comma)
    margin = " " * indent
    begin = f"{margin}{target}{sign}("
    can_fold = pair is not None and len(target) < pair[0] < _WIDTH - indent
    fits = pair is not None or indent + _STEP + len(value) <= _WIDTH
    if can_fold or not fits or len(begin) > _WIDTH:
        return []
    return [begin, *_folded(value, indent + _STEP, False), f"{margin}){comma}"]


def _body(body: str, indent: int, is_display: bool) -> list[str]:
    """Return the lines of what stands in brackets: of a list, tuple or dictionary one an item."""
    margin = " " * indent
    if len(margin + body) <= _WIDTH and not is_display:
        return [margin + body]
    items = _split(body, ",")
    if len(items) > 1 or is_display:
        return [line for item in items for line in _folded(f"{item.strip()},", indent, True)]
    return _folded(body, indent, True)


def _signs(code: str) -> Iterator[tuple[str, int, int]]:
    """Yield each sign outside of texts and comments, its place and the depth it stands at."""
    depth = 0
    for match in _SIGN.finditer(code):
        depth -= match[0] in _CLOSING
        yield match[0], match.start(), depth
        depth += match[0] in _OPENING


def _balance(code: str) -> int:
    """Return how many brackets code opens more than it closes."""
    signs = [sign for sign, _, _ in _signs(code)]
    return sum((sign in _OPENING) - (sign in _CLOSING) for sign in signs)


def _pair(code: str, first: bool) -> tuple[int, int] | None:
    """Return the places of the last outer brackets with something in them, or of the first."""
    pairs: list[tuple[int, int]] = []
    start = 0
    for sign, place, depth in _signs(code):
        if depth == 0 and sign in _OPENING:
            start = place
        elif depth == 0 and sign in _CLOSING and place > start + 1:
            pairs.append((start, place))
    return (pairs[0] if first else pairs[-1]) if pairs else None


def _split(code: str, separator: str) -> list[str]:
    """Return the parts of code between separators that stand in no brackets."""
    places = [place for sign, place, depth in _signs(code) if depth == 0 and sign == separator]
    ends = [*places, len(code)]
    starts = [0, *(place + len(separator) for place in places)]
    parts = [code[start:end] for start, end in zip(starts, ends, strict=True)]
    return parts if parts[-1].strip() else parts[:-1]


def _is_expression(code: str) -> bool:
    """Tell whether code in brackets is one expression: no named argument, pair or loop."""
    return not any(depth == 0 and sign in ("=", ":", "for") for sign, _, depth in _signs(code))


def _assignment(code: str) -> tuple[str, str, str]:
    """Return the target, the sign and the value of an assignment or of a named argument."""
    for sign, place, depth in _signs(code):
        is_alone = code[place - 1] not in "=!<>+-" and code[place + 1 : place + 2] != "="
        if (sign, depth) == ("=", 0) and is_alone:
            spaced = code[place - 1] == " "
            target = code[: place - spaced]
            return target, " = " if spaced else "=", code[place + 1 + spaced :]
    return code, "", ""


def _marked(row: str) -> str:
    """Return a line that linters accept: a long one has a mark, or is a comment of one word."""
    return row if len(row) <= _WIDTH or re.fullmatch(r" *# \S+", row) else row + _NO_LIMIT


def _indent(row: str) -> int:
    return len(row) - len(row.lstrip())
