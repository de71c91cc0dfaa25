"""The words of code: not those of its strings, its comments or its prose."""

from __future__ import annotations

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
_FIELDS = re.compile(r"(\{\{|\}\}|\{(?:[^{}]|\{[^{}]*\})*\})")
"""What is code in an f-string; doubled braces are none."""
_PATTERNS = {PYTHON: _PYTHON, CPP: cpp_blocks.TOKEN, CMAKE: _CMAKE}
_INCLUDE = re.compile(r"\s*#\s*include\s*[\"<]")


class Word(NamedTuple):
    """A word of code, and what stands before it and after it on its way through a name."""

    text: str
    before: tuple[str, str]
    after: str
    chain: tuple[str, ...] = ()
    """The names before it, joined by signs: `a`, `b` of `a.b->word`, `a`, `)` of `a().word`."""
    line: int = 0
    """Counted from 0."""


By = Callable[[Word], str]
"""Says what a word becomes."""
_JOINTS = (".", "->", "::")
BEFORE_TYPE = ((")",), ("const",), ("noexcept",), ("mutable",))
"""What stands before the `->` of the type that a function returns."""


def exchange(known: Language, text: str, by: By, among: Container[str] | None = None) -> str:
    """Return a text with each word of its code exchanged; a text without code as it is.

    `by` says of a word, or of one that is `among` some, what it becomes.
    """
    pattern = _PATTERNS.get(known)
    code = {*in_quotes(text)} if known is PYTHON else set()

    def exchanged(part: str, line: int) -> str:
        parts: list[str] = []
        at = 0
        signs = ("", "")
        chain: tuple[str, ...] = ()
        called: list[tuple[str, ...]] = []
        for match in pattern.finditer(part) if pattern else ():
            kind, found = match.lastgroup, match[0]
            if kind == "blank":
                continue
            line += part.count("\n", at, match.start())
            if kind == "word":
                after = part[match.end() : match.end() + 80].lstrip()
                after = after[:2] if after[:2] in ("::", "==") else after[:1]
                is_type = signs[1] == "->" and after == "::" and chain[-1:] in BEFORE_TYPE
                chain = chain if signs[1] in _JOINTS and not is_type else ()
                if among is None or found in among:
                    found = by(Word(found, signs, after, chain, line))
                chain = (*chain, match[0]) if match[0] not in ("from", "import") else ()
            elif kind == "directive" and (head := _INCLUDE.match(found)):
                found = head[0] + _path(found[head.end() :], by, line)
            elif kind == "directive":
                margin, sign, rest = found.partition("#")
                found = margin + sign + exchanged(rest, line)
            elif kind == "string" and known is PYTHON and "f" in (match["prefix"] or "").lower():
                pieces = _FIELDS.split(found)
                pieces[1::2] = [exchanged(piece, line) for piece in pieces[1::2]]
                found = "".join(pieces)
            elif part is text and (line, _column(text, match.start())) in code:
                found = found[0] + exchanged(found[1:-1], line) + found[-1]
            parts += [part[at : match.start()], found]
            if match[0] == "(":
                called.append(chain)
            if match[0] in (")", "]"):
                chain = (*(called.pop() if called and match[0] == ")" else ()), match[0])
            elif kind not in ("word", "comment") and match[0] not in _JOINTS:
                chain = ()
            line += match[0].count("\n")
            at = match.end()
            if kind != "comment":
                signs = (signs[1], match[0])
        return "".join(parts) + part[at:]

    return exchanged(text, 0)


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


def _path(path: str, by: By, line: int) -> str:
    """Exchange the words of an included file's path; the first part is that of a package."""
    words = re.split(r"(\W)", path)
    for i, word in enumerate(words):
        if re.match(r"[A-Za-z_]\w*$", word):
            follows = words[i + 1] if i + 1 < len(words) else ""
            after, chain = "::" if follows == "/" else follows, (*filter(None, words[:i:2]),)
            words[i] = by(Word(word, ("#", "include"), after, chain, line))
    return "".join(words)


def words(known: Language, text: str) -> Iterator[Word]:
    """Yield the words of code in a text."""
    found: list[Word] = []

    def keep(word: Word) -> str:
        found.append(word)
        return word.text

    exchange(known, text, keep)
    yield from found
