"""C++ as blocks: functions, classes, includes, other declarations.

No compiler's view: a declaration ends at its semicolon or at the brace that closes its body, and
is known by the name before its first parenthesis. That is enough to tell one from another.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from dataclasses import dataclass

from .blocks import Block, Span, arrange, nested, squeezed
from .lines import split

COMMENT = "//"
_TOKEN = re.compile(
    r"""
    (?P<comment> //[^\n]* | /\*.*?\*/ )
  | (?P<directive> ^[ \t]*\#(?: \\\n | [^\n] )* )
  | (?P<raw> \bu?8?[uUL]?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)" )
  | (?P<string> "(?: \\. | [^"\\\n] )*" )
  | (?P<number> (?<![\w']) \d[\w.']* )
  | (?P<character> '(?: \\. | [^'\\\n] )+' )
  | (?P<word> [A-Za-z_]\w* )
  | (?P<blank> \s+ )
  | (?P<sign> :: | . )
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
_OPEN, _CLOSE = "([{", ")]}"
_ACCESS = ("public", "private", "protected", "signals", "slots")


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    line: int
    last: int
    """The lines it begins and ends on, the first counted 0."""


def blocks(text: str) -> list[Block]:
    """Return the blocks of a source or header; those of a class or namespace are inside of it.

    So are those of an `#if`, but for the one that keeps a header from being included twice.

    Raises:
        ValueError: its braces, or its conditions, do not match.

    """
    lines = split(text)
    tokens = [token for token in tokenize(text) if token.kind not in ("blank", "comment")]
    nested([_directive(token) for token in tokens if token.kind == "directive"], _role)
    spans, rest = _scope(tokens, 0)
    if rest < len(tokens):
        raise ValueError(f"line {tokens[rest].line + 1}: a brace that nothing opens")
    return arrange(lines, spans, 0, len(lines), COMMENT)


def _directive(token: _Token) -> Span:
    return Span(squeezed(token.text), token.line, token.last + 1)


def _role(span: Span) -> tuple[str, str]:
    """Say whether a directive begins a condition, goes on with it or ends it."""
    match = re.match(r"#\s*(\w+)", span.key)
    part = _ROLES.get(match[1], "") if match else ""
    return ("if", part) if part else ("", "")


_ROLES = dict.fromkeys(("if", "ifdef", "ifndef"), "start")
_ROLES |= dict.fromkeys(("elif", "elifdef", "elifndef", "else"), "branch") | {"endif": "end"}


def _with_conditions(spans: list[Span]) -> list[Span]:
    """Put what stands in a condition inside of it; what a guard of a header holds stays."""
    heads = [span.key.split() for span in spans[:2]]
    if len(heads) < 2 or heads[0][:1] + heads[1] != ["#ifndef", "#define", *heads[0][1:]]:
        return nested(spans, _role)
    depth = 0
    for at, span in enumerate(spans):
        part = _role(span)[1]
        depth += (part == "start") - (part == "end")
        if not depth:
            inside, rest = spans[1:at], spans[at + 1 :]
            return [spans[0], *nested(inside, _role), span, *nested(rest, _role)]
    return nested(spans, _role)


def same(one: str, other: str) -> bool:
    """Say whether two texts differ in form alone: in blanks, in where a comment is wrapped."""
    return _words(one) == _words(other)


@functools.lru_cache(maxsize=2048)
def _words(text: str) -> list[str]:
    words: list[str] = []
    for token in tokenize(text):
        if token.kind == "comment":
            words += re.sub(r"^\s*(//[/!<]*|/\*+|\*+/|\*)", "", token.text, flags=re.M).split()
        elif token.kind == "directive":
            words += token.text.split()
        elif token.kind != "blank":
            words.append(token.text)
    return words


def tokenize(text: str) -> Iterator[_Token]:
    """Yield the tokens of a text, all of it."""
    line = 0
    for match in _TOKEN.finditer(text):
        last = line + match[0].count("\n")
        yield _Token(match.lastgroup or "sign", match[0], line, last)
        line = last


def _scope(tokens: list[_Token], at: int) -> tuple[list[Span], int]:
    """Return the items from a token on, and where the scope ends."""
    spans = []
    while at < len(tokens) and tokens[at].text != "}":
        token = tokens[at]
        if token.kind == "directive":
            spans.append(_directive(token))
            at += 1
        elif token.text in _ACCESS and at + 1 < len(tokens) and tokens[at + 1].text == ":":
            spans.append(Span(f"{token.text}:", token.line, tokens[at + 1].last + 1))
            at += 2
        else:
            span, at = _item(tokens, at)
            spans.append(span)
    return _with_conditions(spans), at


def _item(tokens: list[_Token], start: int) -> tuple[Span, int]:
    """Return the declaration or definition that starts at a token, and where the next starts."""
    at = start
    body: tuple[int, int] | None = None
    items: tuple[Span, ...] = ()
    while at < len(tokens):
        text = tokens[at].text
        if text == ";":
            at += 1
            break
        if text == "}":
            break
        if text == "{" and _holds_items(tokens[start:at]):
            inner, end = _scope(tokens, at + 1)
            if end == len(tokens):
                raise ValueError(f"line {tokens[at].line + 1}: a brace that nothing closes")
            if tokens[end].line > tokens[at].last + 1:
                body, items = (tokens[at].last + 1, tokens[end].line), tuple(inner)
            at = end + 1
            if tokens[start].text == "namespace" or tokens[start].text == "extern":
                break
        elif text in _OPEN:
            at = _closing(tokens, at) + 1
            if text == "{" and not _goes_on(tokens, start, at):
                break
        else:
            at += 1
    key = _key(tokens[start:at])
    return Span(key, tokens[start].line, tokens[at - 1].last + 1, body, items), at


def _goes_on(tokens: list[_Token], start: int, at: int) -> bool:
    """Say whether a declaration goes on after a closing brace, as in `int x{1};`."""
    return at < len(tokens) and tokens[at].text in (";", ",", "{", "=", "(", ".")


def _holds_items(tokens: list[_Token]) -> bool:
    words = [token.text for token in tokens if token.text in _HOLDERS]
    signs = {token.text for token in tokens} & {"(", "="}
    return bool(words) and "enum" not in [token.text for token in tokens] and not signs


_HOLDERS = ("namespace", "class", "struct", "extern")


def _closing(tokens: list[_Token], at: int) -> int:
    depth = 0
    for index in range(at, len(tokens)):
        depth += (tokens[index].text in _OPEN) - (tokens[index].text in _CLOSE)
        if not depth:
            return index
    raise ValueError(f"line {tokens[at].line + 1}: {tokens[at].text} that nothing closes")


def _key(tokens: list[_Token]) -> str:
    texts = [token.text for token in tokens if token.kind != "directive"]
    if texts[:1] == ["template"]:
        texts = _without_template(texts)
    ends = [i for i, text in enumerate(texts) if text in "{;="]
    head = texts[: ends[0]] if ends else texts
    if "(" in head:
        at = head.index("(")
        name = head[:at][-1:]
        while len(head[:at]) > len(name) and (
            head[at - len(name) - 1] in ("::", "~") or name[0] in ("::", "~")
        ):
            name.insert(0, head[at - len(name) - 1])
        if "operator" in head[:at]:
            name = head[head.index("operator") : at]
        if name and name[0].isupper() and name[0].upper() == name[0] and "::" not in name:
            return squeezed(" ".join(head))
        return "".join(name) + "()"
    for word in (*_HOLDERS, "enum", "using", "typedef"):
        if word in head:
            return squeezed(" ".join(head if word != "class" else head[head.index(word) :][:2]))
    names = [text for text in head if re.fullmatch(r"[A-Za-z_]\w*", text)]
    return f"variable {names[-1]}" if names else squeezed(" ".join(texts)) or "empty"


def _without_template(texts: list[str]) -> list[str]:
    depth = 0
    for index, text in enumerate(texts):
        depth += (text == "<") - (text == ">")
        if text == ">" and not depth:
            return texts[index + 1 :]
    return texts
