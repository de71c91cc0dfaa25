"""C++ as blocks: functions, classes, includes, other declarations.

No compiler's view: a declaration ends at its semicolon or at the brace that closes its body, and
is known by its name. That is enough to tell one from another.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import accumulate

from .blocks import Block, Span, arrange, nested, squeezed
from .lines import split

TOKEN = re.compile(
    r"""
    (?P<comment> //(?: \\\n | [^\n] )* | /\*.*?\*/ )
  | (?P<directive> ^[ \t]*\#(?: \\\n | //(?: \\\n | [^\n] )* | /\*.*?\*/
      | "(?: \\. | [^"\\\n] )*" | [^\n] )* )
  | (?P<raw> \bu?8?[uUL]?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)" )
  | (?P<string> "(?: \\. | [^"\\\n] )*" )
  | (?P<number> (?<![\w']) \d[\w.']* )
  | (?P<character> '(?: \\. | [^'\\\n] )+' )
  | (?P<word> [A-Za-z_]\w* )
  | (?P<blank> \n | [^\S\n]+ )
  | (?P<sign> :: | -> | . )
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
_OPEN, _CLOSE = "([{", ")]}"
_ACCESS = ("public", "private", "protected", "signals", "Q_SIGNALS")
_COMMENTS = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_ROLES = dict.fromkeys(("if", "ifdef", "ifndef"), "start")
_ROLES |= dict.fromkeys(("elif", "elifdef", "elifndef", "else"), "branch") | {"endif": "end"}
_DEPTHS = {"start": 1, "end": -1}
_MACRO = re.compile(r"[A-Z][A-Z0-9]*_?[A-Z0-9_]+")
_AFTER_HEAD = ("const", "noexcept", "override", "final", "throw", "mutable", "volatile")
_HOLDERS = ("namespace", "class", "struct")
_ATTRIBUTE = re.compile(r"__\w+|alignas|noexcept|throw|decltype|requires|explicit")


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    line: int
    last: int
    """The lines it begins and ends on, the first counted 0."""


Tokens = list[_Token]


def blocks(text: str) -> list[Block]:
    """Return the blocks of a source or header; those of a class or namespace are inside of it.

    So are those of an `#if`, but for the one that keeps a header from being included twice.
    """
    tokens = [token for token in tokenize(text) if token.kind not in ("blank", "comment")]
    kept, at = _whole(tokens, 0)
    if at < len(tokens):
        raise ValueError(f"line {tokens[at].line + 1}: {tokens[at].text}, without its beginning")
    spans, at = _scope(kept, 0)
    if at < len(kept):
        raise ValueError(f"line {kept[at].line + 1}: a brace that nothing opens")
    return arrange(split(text), _with_conditions(spans), _COMMENTS)


def _directive(token: _Token) -> Span:
    key = re.sub(r"^#\s+", "#", squeezed(token.text))
    if not key.startswith("#define"):
        key = re.sub(r" ?(//|/\*).*", "", key)
    return Span(key, token.line, token.last + 1)


def _role(span: Span) -> tuple[str, str]:
    """Say whether a directive begins a condition, goes on with it or ends it."""
    return "if", _part(span.key)


def _part(directive: str) -> str:
    match = re.match(r"\s*#\s*(\w+)", directive)
    return _ROLES.get(match[1], "") if match else ""


def _whole(tokens: Tokens, at: int) -> tuple[Tokens, int]:
    """Return the tokens from one on to the end of a branch of a condition, and where that is.

    Of a condition that splits a statement, or braces, there is one branch, and the lines of the
    others belong to it. Of an `#if 0` there is nothing.
    """
    kept: Tokens = []
    while at < len(tokens) and _part(tokens[at].text) not in ("branch", "end"):
        if not _part(tokens[at].text):
            kept.append(tokens[at])
            at += 1
            continue
        branches: list[Tokens] = []
        while not branches or _part(tokens[at].text) == "branch":
            head = tokens[at]
            inside, at = _whole(tokens, at + 1)
            if at == len(tokens):
                raise ValueError(f"line {head.line + 1}: {head.text}, without end")
            branches.append([head, *([] if re.match(r"\s*#\s*if\s+0\s*$", head.text) else inside)])
        end, at = tokens[at], at + 1
        before = kept[-1].text if kept else ""
        after = tokens[at].text if at < len(tokens) else ""
        is_inside = re.fullmatch(r"[=,(?+|&]", before) or re.fullmatch(r"[{:=,;)]", after)
        if all(map(_balanced, branches)) and not is_inside:
            kept += [*(token for branch in branches for token in branch), end]
        elif one := next((branch[1:] for branch in branches if branch[1:]), []):
            one[0] = replace(one[0], line=branches[0][0].line)
            one[-1] = replace(one[-1], last=end.last)
            kept += one
    return kept, at


def _balanced(tokens: Tokens) -> bool:
    steps = ((token.text in _OPEN) - (token.text in _CLOSE) for token in tokens)
    depths = [*accumulate(steps, initial=0)]
    return min(depths) == depths[-1] == 0


def _with_conditions(spans: list[Span]) -> list[Span]:
    """Put what stands in a condition inside of it; what a guard of a header holds stays."""
    heads = [span.key.split()[:2] for span in spans]
    for start, (one, other) in enumerate(zip(heads, heads[1:], strict=False)):
        if one[:1] + other != ["#ifndef", "#define", *one[1:]]:
            continue
        depths = accumulate(_DEPTHS.get(_part(span.key), 0) for span in spans[start:])
        end = start + next((i for i, depth in enumerate(depths) if not depth), 0)
        if end > start + 2:  # else it is the default of a macro
            words = (spans[at] for at in (start, start + 1, end))  # known without the macro's name
            first, second, last = (replace(one, key=one.key.split()[0]) for one in words)
            parts = (spans[:start], spans[start + 2 : end], spans[end + 1 :])
            before, inside, rest = (nested(part, _role) for part in parts)
            return [*before, first, second, *inside, last, *rest]
    return nested(spans, _role)


@functools.lru_cache(maxsize=2048)
def meaning(text: str) -> list[str]:
    """Return a text without what is but form: blanks, and where a comment is wrapped."""
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
    for match in TOKEN.finditer(text):
        last = line + match[0].count("\n")
        yield _Token(match.lastgroup or "sign", match[0], line, last)
        line = last


def _scope(tokens: Tokens, at: int) -> tuple[list[Span], int]:
    """Return the items from a token on, and where the scope ends."""
    spans: list[Span] = []
    while at < len(tokens) and tokens[at].text != "}":
        token = tokens[at]
        texts = [token.text for token in tokens[at : at + 3]]
        if token.kind == "directive":
            spans.append(_directive(token))
            at += 1
        elif token.text in _ACCESS and ":" in texts:
            colon = at + texts.index(":")
            spans.append(Span(f"{token.text}:", token.line, tokens[colon].last + 1))
            at = colon + 1
        elif end := _macro(tokens, at):
            span, at = _with_macro(tokens, at, end)
            spans.append(span)
        else:
            span, at = _item(tokens, at)
            if span.key.startswith("namespace "):
                spans = _reopened(spans, span)
            else:
                spans.append(span)
    return spans, at


def _reopened(spans: list[Span], other: Span) -> list[Span]:
    """Return items and a namespace; of one that is closed and opened again it makes one item."""
    at = max((i for i, span in enumerate(spans) if span.key == other.key), default=len(spans))
    if at == len(spans) or any(_part(span.key) for span in spans[at:]):
        return [*spans, other]
    one = spans[at]
    if one.body and other.body:
        between = Span(f"{{ {one.key}", one.body[1], other.body[0])
        items = (*one.items, between, *other.items)
        body = (one.body[0], other.body[1])
        return [*spans[:at], Span(one.key, one.start, other.end, body, items)]
    is_beside = at == len(spans) - 1
    return [*spans[:at], Span(one.key, one.start, other.end)] if is_beside else [*spans, other]


def _with_macro(tokens: Tokens, at: int, end: int) -> tuple[Span, int]:
    """Return a macro and what it is about: what begins on the next line, if anything does."""
    start, last = tokens[at].line, tokens[end - 1].last
    after = tokens[end] if end < len(tokens) and tokens[end].line == last + 1 else None
    if after and _part(after.text) == "start":  # a condition
        return replace(_directive(after), start=start), end + 1
    is_word = after and after.kind == "word" and after.text not in (*_ACCESS, *_HOLDERS)
    if is_word and not _macro(tokens, end):
        span, at = _item(tokens, end)
        return replace(span, start=start), at
    key = squeezed(" ".join(token.text for token in tokens[at:end]))
    return Span(key, start, last + 1), end


def _macro(tokens: Tokens, at: int) -> int:
    """Return where a macro ends that is alone on its line, without semicolon; else 0."""
    end = at + 1
    if not _MACRO.fullmatch(tokens[at].text):
        return 0
    if end < len(tokens) and tokens[end].text == "(":
        end = _closing(tokens, end) + 1
    elif "_" not in tokens[at].text:
        return 0
    if end == len(tokens) or tokens[end].text == "}" or tokens[end].kind == "directive":
        return end
    after = tokens[end]
    is_word = after.kind == "word" and after.text not in _AFTER_HEAD
    return end if is_word and after.line > tokens[end - 1].last else 0


def _item(tokens: Tokens, start: int) -> tuple[Span, int]:
    """Return the declaration or definition that starts at a token, and where the next starts."""
    at = start
    body: tuple[int, int] | None = None
    items: tuple[Span, ...] = ()
    conditions = 0
    while at < len(tokens):
        text = tokens[at].text
        part = _part(tokens[at].text)
        if text == "}" or (part in ("branch", "end") and not conditions):
            break
        conditions += (part == "start") - (part == "end")
        if text == ";":
            at += 1
            break
        if text == "{" and _holds_items(tokens[start:at]):
            inner, end = _scope(tokens, at + 1)
            if end == len(tokens):
                raise ValueError(f"line {tokens[at].line + 1}: a brace that nothing closes")
            body, items = _inside(inner, tokens[at].last + 1, tokens[end].line)
            at = end + 1
            if tokens[start].text in ("namespace", "inline", "extern"):
                break
        elif text in _OPEN:
            at = _closing(tokens, at) + 1
            after = tokens[at].text if at < len(tokens) else ""
            if text == "{" and after not in (";", ",", "{", "=", "(", "."):  # as in `int x{1};`
                break
        else:
            at += 1
    key, end = _key(tokens[start:at]), tokens[at - 1].last + 1
    return Span(key, tokens[start].line, end, body, items), at


def _inside(
    spans: list[Span], first: int, last: int
) -> tuple[tuple[int, int] | None, tuple[Span, ...]]:
    """Return the lines and items between two braces: none where one of these shares its line.

    Of the one container whose braces are in the same lines, it is what that one has inside.
    """
    if len(spans) == 1 and spans[0].body and (spans[0].start < first or spans[0].end > last):
        return spans[0].body, spans[0].items
    try:
        inner = _with_conditions(spans)
    except ValueError:  # a condition that is not whole in here
        return None, ()
    if first > last or any(span.start < first or span.end > last for span in inner):
        return None, ()
    return (first, last), tuple(inner)


def _holds_items(tokens: Tokens) -> bool:
    *head, end = _head([token.text for token in tokens])
    if end in ("{", "=") or "enum" in head or "()" in head:
        return False
    return any(word in head for word in _HOLDERS) or ("extern" in head and head[-1][0] == '"')


def _closing(tokens: Tokens, at: int) -> int:
    depth = 0
    for index in range(at, len(tokens)):
        depth += (tokens[index].text in _OPEN) - (tokens[index].text in _CLOSE)
        if not depth:
            return index
    raise ValueError(f"line {tokens[at].line + 1}: {tokens[at].text} that nothing closes")


def _head(texts: list[str]) -> list[str]:
    """Return the words of a declaration without attributes, and the sign that ends these.

    Pairs of brackets are words, round ones without what is in them.
    """
    head: list[str] = []
    at = 0
    while at < len(texts):
        text = texts[at]
        if text in ("{", ";", "=", ":"):
            return [*head, text]
        if text == "operator":
            end = texts.index("(", at + 2) if "(" in texts[at + 2 :] else len(texts)
            head.append("".join(texts[at:end]))
            at = end
            continue
        end = _past(texts, at)
        if text == "template" and end < len(texts):
            end = _past(texts, end)
        elif text == "(" and not _is_attribute(head, texts[end : end + 1]):
            head.append("()")
        elif text == "(":
            head.pop()
        elif text == "<":
            head.append("".join(texts[at:end]))
        elif text != "[":
            head.append(text)
        at = end
    return [*head, ""]


def _is_attribute(head: list[str], after: list[str]) -> bool:
    """Say whether the last word of a head, with brackets, is no name, as in `API(1) void f()`."""
    name = head[-1] if head else ""
    if not _MACRO.fullmatch(name):
        return bool(_ATTRIBUTE.fullmatch(name))
    is_word = bool(after and re.match(r"[A-Za-z_~]|::", after[0]) and after[0] not in _AFTER_HEAD)
    return is_word or "()" in head


def _past(texts: list[str], at: int) -> int:
    """Return what follows a bracket, or another word."""
    open_: list[str] = []
    for index in range(at, len(texts)):
        text = texts[index]
        if text in ("(", "[", "{") or (text == "<" and open_[-1:] in ([], ["<"])):
            open_.append(text)
        elif text in (")", "]", "}"):
            while open_ and open_.pop() == "<":
                pass
        elif text == ">" and open_[-1:] == ["<"]:
            open_.pop()
        if not open_:
            return index + 1
    return len(texts)


def _key(tokens: Tokens) -> str:
    texts = [token.text for token in tokens if token.kind != "directive"]
    *head, sign = _head(texts)
    plain = squeezed(" ".join(texts[: texts.index(sign)] if sign else texts)) or "empty"
    if "()" in head[1:]:
        at = len(head) - 1 - head[::-1].index("()")
        name = head[at - 1 : at]
        for part in reversed(head[: at - 1]):
            if name[0] not in ("::", "~") and part not in ("::", "~"):
                break
            name.insert(0, part)
        if _MACRO.fullmatch(name[-1]) and len(name) == 1:
            return plain
        return "::".join("".join(name).split("::")[-2:]) + "()"  # with or without its namespace
    if "class" in head or "struct" in head:
        words = [word for word in head if word != "final"]
        places = [i for i, word in enumerate(words) if not word.startswith(("<", '"'))]
        kind = "class" if "class" in head else "struct"
        return f"{kind} {''.join(words[places[-1] :])}"
    if any(word in head for word in ("namespace", "extern", "enum", "using", "typedef")):
        return plain
    names = [word for word in head if re.fullmatch(r"[A-Za-z_]\w*", word)]
    return f"variable {names[-1]}" if names else plain
