"""The words of code: not those of its strings, its comments or its prose."""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Container, Iterator
from typing import NamedTuple

from . import cpp_blocks
from .languages import CMAKE, CPP, PYTHON, Language
from .outlines import SKIPPED
from .python_blocks import in_quotes

_PYTHON = re.compile(
    r"""
    (?P<comment> \#[^\n]* )
  | (?P<string> (?P<prefix> \b[rRbBuUfF]{1,2} )?
        (?P<quotes> \"\"\" | ''' | " | ' ) (?: \\. | (?!(?P=quotes)). )*? (?P=quotes) )
  | (?P<word> [A-Za-z_]\w* )
  | (?P<sign> \S )
    """,
    re.VERBOSE | re.DOTALL,
)
_CMAKE = re.compile(
    rf"{SKIPPED} | (?P<word> [A-Za-z_]\w* ) | (?P<sign> \S )", re.VERBOSE | re.DOTALL
)
_NAME = re.compile(r"\w+")
_FIELDS = re.compile(r"(\{\{|\}\}|\{(?:[^{}]|\{[^{}]*\})*\})")
"""What is code in an f-string; doubled braces are none."""
_PATTERNS = {PYTHON: _PYTHON, CPP: cpp_blocks.TOKEN, CMAKE: _CMAKE}
_INCLUDE = re.compile(r"\s*#\s*include\s*[\"<]")


class Word(NamedTuple):
    """A word of code, and what stands before it and after it on its way through a name."""

    text: str
    before: tuple[str, str]
    after: str
    chain: tuple[str, ...]
    """The names before it, joined by signs: `a`, `b` of `a.b->word`, `a`, `)` of `a().word`."""
    line: int
    """Counted from 0."""
    at: int
    """Where it begins in the text."""


_JOINTS = (".", "->", "::")
BEFORE_TYPE = ((")",), ("const",), ("noexcept",), ("mutable",))
"""What stands before the `->` of the type that a function returns."""


def exchange(known: Language, text: str, by: Callable[[Word], str], among: Container[str]) -> str:
    """Return a text with each word of its code that is among some exchanged, as `by` says."""
    parts: list[str] = []
    at = 0
    for word in words(known, text, among):
        parts += [text[at : word.at], by(word)]
        at = word.at + len(word.text)
    return "".join(parts) + text[at:]


@functools.lru_cache(maxsize=512)
def all_words(known: Language, text: str) -> tuple[Word, ...]:
    """Return the words of code in a text; an update asks twice."""
    return (*words(known, text),)


def words(known: Language, text: str, among: Container[str] | None = None) -> Iterator[Word]:
    """Yield the words of code in a text, or those that are among some; none without code."""
    pattern = _PATTERNS.get(known)
    code = {*in_quotes(text)} if known is PYTHON else set()

    def within(start: int, end: int, line: int) -> Iterator[Word]:
        signs = ("", "")
        chain: tuple[str, ...] = ()
        called: list[tuple[str, ...]] = []
        at, is_whole = start, bool(code) and end - start == len(text)
        for match in pattern.finditer(text, start, end) if pattern else ():
            kind, found, (first, last) = match.lastgroup, match[0], match.span()
            if kind == "blank":
                continue
            line += text.count("\n", at, first)
            if kind == "word":
                after = text[last : min(last + 80, end)].lstrip()
                after = after[:2] if after[:2] in ("::", "==") else after[:1]
                is_type = signs[1] == "->" and after == "::" and chain[-1:] in BEFORE_TYPE
                chain = chain if signs[1] in _JOINTS and not is_type else ()
                if among is None or found in among:
                    yield Word(found, signs, after, chain, line, first)
                chain = (*chain, found) if found not in ("from", "import") else ()
            elif kind == "directive" and (head := _INCLUDE.match(found)):
                path = _path(text, first + head.end(), last, line)
                yield from (word for word in path if among is None or word.text in among)
            elif kind == "directive":
                yield from within(text.index("#", first) + 1, last, line)
            elif kind == "string" and known is PYTHON and "f" in (match["prefix"] or "").lower():
                for field in _FIELDS.finditer(text, first, last):
                    yield from within(*field.span(), line)
            elif is_whole and (line, _column(text, first)) in code:
                yield from within(first + 1, last - 1, line)
            if found == "(":
                called.append(chain)
            if found in (")", "]"):
                chain = (*(called.pop() if called and found == ")" else ()), found)
            elif kind not in ("word", "comment") and found not in _JOINTS:
                chain = ()
            at = first
            if kind != "comment":
                signs = (signs[1], found)

    return within(0, len(text), 0)


def _path(text: str, start: int, end: int, line: int) -> Iterator[Word]:
    """Yield the words of an included file's path; the first part is that of a package."""
    chain: tuple[str, ...] = ()
    for match in _NAME.finditer(text, start, end):
        after = text[match.end() : end][:1]
        after = "::" if after == "/" else after
        yield Word(match[0], ("#", "include"), after, chain, line, match.start())
        chain = (*chain, match[0])


def _column(text: str, at: int) -> int:
    """Return how many bytes of its line stand before a place in a text."""
    return len(text[text.rfind("\n", 0, at) + 1 : at].encode(errors="surrogatepass"))


def quoted(known: Language, text: str) -> set[int]:
    """Return the lines, from 0, that begin inside of a text in quotes."""
    found: set[int] = set()
    pattern = _PATTERNS.get(known)
    for match in pattern.finditer(text) if pattern else ():
        if match.lastgroup in ("string", "raw", "exact") and "\n" in match[0]:
            first = text.count("\n", 0, match.start())
            found |= {*range(first + 1, first + match[0].count("\n") + 1)}
    return found
