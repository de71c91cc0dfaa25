"""A file as blocks: callbacks, elements, keys, each with a name that tells it from all others.

A language module has `blocks(text)`, which raises ValueError where a text is not of the language.
The texts of the blocks, one after the other, are the text of the file. Decision 26: blocks are
told apart by their names, for generated callbacks look alike.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from .lines import Lines

THEN = "then"
"""What the first branch of a condition is called."""
NO_COMMENT = re.compile(r"(?!)")
_QUOTED = re.compile(
    r"""(?P<exact> "(?: \\. | [^"\\] )*"
      | (?: (?<!\w) | (?<=\b[bfruBFRU]) ) '(?: \\. | '' | [^'\\] )*' )""",
    re.VERBOSE | re.DOTALL,
)
"""What is between quotes; an apostrophe is none."""
_SINGLE = re.compile(r"^'([^\"']*)'$")
"""A text in quotes that means the same in the other sort of them."""
_PRIVATE = {code: code - 0xDC80 + 0xE080 for code in range(0xDC80, 0xDD00)}


@dataclass
class Block:
    """Some lines with a name; a container has other blocks between its head and its tail.

    One without any line stands for a container that the developer has put around others.
    """

    key: str
    lines: Lines
    children: list[Block] = field(default_factory=list)
    tail: Lines = field(default_factory=list)

    @property
    def text(self) -> str:
        """Return all of its lines."""
        inner = "".join(child.text for child in self.children)
        return "".join(self.lines) + inner + "".join(self.tail)

    def copy(self) -> Block:
        """Return a block that can be changed alone."""
        children = [child.copy() for child in self.children]
        return Block(self.key, list(self.lines), children, list(self.tail))


@dataclass(frozen=True)
class Span:
    """Where an item stands: lines `start` to `end`, the first counted 0, the last not included."""

    key: str
    start: int
    end: int
    body: tuple[int, int] | None = None
    """Of a container: the lines between its head and its tail."""
    items: tuple[Span, ...] = ()


def nested(spans: Iterable[Span], role: Callable[[Span], tuple[str, str]]) -> list[Span]:
    """Put what stands between the beginning and the end of a condition inside of one item.

    `role` says of an item which statement it belongs to, and whether it is the `start`, another
    `branch` or the `end` of that; of any other item, an empty text. Each branch is an item, too.
    It raises ValueError where something ends that has not begun, or does not end.
    """
    found: list[Span] = []
    open_: list[tuple[str, list[Span]]] = [("", found)]
    for span in spans:
        statement, part = role(span)
        if part == "start":
            open_.append((statement, [span]))
            continue
        if part and open_[-1][0] != statement:
            raise ValueError(f"line {span.start + 1}: {span.key}, without its beginning")
        open_[-1][1].append(span)
        if part == "end":
            inside = open_.pop()[1]
            open_[-1][1].append(_condition(inside, [role(one)[1] == "branch" for one in inside]))
    if len(open_) > 1:
        raise ValueError(f"line {open_[-1][1][0].start + 1}: {open_[-1][1][0].key}, without end")
    return found


def _condition(spans: list[Span], is_branch: list[bool]) -> Span:
    """Make one item of those from a beginning to its end."""
    first, last = spans[0], spans[-1]
    if any(one.end > other.start for one, other in pairwise(spans)):
        return Span(first.key, first.start, last.end)
    heads = [0, *(i for i, found in enumerate(is_branch) if found), len(spans) - 1]
    branches = []
    for at, until in pairwise(heads):
        body = (spans[at].end, spans[until].start)
        start, key = (spans[at].start, spans[at].key) if at else (body[0], THEN)
        branches.append(Span(key, start, body[1], body, tuple(spans[at + 1 : until])))
    return Span(first.key, first.start, last.end, (first.end, last.start), tuple(branches))


def is_condition(block: Block) -> bool:
    """Say whether a block has branches."""
    return bool(block.children) and block.children[0].key == THEN


def arrange(
    lines: Sequence[str],
    spans: Iterable[Span],
    comments: re.Pattern[str] = NO_COMMENT,
    within: tuple[int, int] | None = None,
) -> list[Block]:
    """Make blocks of lines, of all or those `within`; what stands above an item belongs to it.

    A comment that an empty line parts from what follows is a block of its own; of `comments`,
    which have an end of their own, none is parted by an empty line inside.
    """
    blocks: list[Block] = []
    start, end = within or (0, len(lines))
    at = start
    for span in (*_joined(spans), None):
        above = _paragraphs(lines[at : span.start if span else end], comments)
        close = above.pop() if span and above and above[-1][-1].strip() else []
        blocks += [_comment(part, at == start and not i) for i, part in enumerate(above)]
        if span:
            first, last = body = span.body or (span.end, span.end)
            inner = arrange(lines, span.items, comments, body)
            head = [*close, *lines[span.start : first]]
            blocks.append(Block(span.key, head, inner, [*lines[last : span.end]]))
            at = span.end
    return numbered(_close_gaps(blocks))


def _joined(spans: Iterable[Span]) -> list[Span]:
    """Make one of items that share a line."""
    joined: list[Span] = []
    for span in spans:
        if joined and span.start < joined[-1].end:
            before = joined.pop()
            span = Span(before.key, before.start, max(before.end, span.end))
        joined.append(span)
    return joined


def _paragraphs(lines: Sequence[str], comments: re.Pattern[str]) -> list[Lines]:
    """Split the lines above an item after each empty line that follows a comment."""
    text = "".join(lines)
    inside: set[int] = set()
    for comment in comments.finditer(text):
        first = text.count("\n", 0, comment.start()) + 1
        inside |= {*range(first, first + comment[0].count("\n"))}
    parts: list[Lines] = [[]]
    for number, line in enumerate(lines):
        is_first = any(map(str.strip, parts[-1])) and not parts[-1][-1].strip()
        if line.strip() and is_first and number not in inside:
            parts.append([])
        parts[-1].append(line)
    return [part for part in parts if part]


def _comment(lines: Lines, is_first: bool) -> Block:
    words = " ".join(" ".join(lines).split())
    return Block("header" if is_first and words else f"comment {words}" if words else "", lines)


def is_comment(key: str) -> bool:
    """Say whether a block is a comment on its own; the first of a file is its header."""
    return key == "header" or key.startswith("comment ")


def _close_gaps(blocks: list[Block]) -> list[Block]:
    """Give empty lines to the block that follows them, or that they follow at the end."""
    closed: list[Block] = []
    gap: Lines = []
    for block in blocks:
        if not block.key:
            gap += block.lines
            continue
        block.lines = gap + block.lines
        gap = []
        while is_comment(block.key) and not block.lines[-1].strip():
            gap.insert(0, block.lines.pop())
        closed.append(block)
    if closed:
        last = closed[-1]
        (last.tail if last.children or last.tail else last.lines).extend(gap)
    elif gap:
        closed.append(Block("empty", gap))
    return closed


def numbered(blocks: list[Block]) -> list[Block]:
    """Tell blocks of one key apart."""
    seen: dict[str, int] = {}
    for block in blocks:
        count = seen[block.key] = seen.get(block.key, 0) + 1
        if count > 1:
            block.key += f" #{count}"
    return blocks


def every(blocks: Iterable[Block]) -> Iterator[Block]:
    """Yield blocks, each before those inside of it."""
    for block in blocks:
        yield block
        yield from every(block.children)


def walk(blocks: Iterable[Block], scope: tuple[str, ...] = ()) -> Iterator[tuple[str, str]]:
    """Yield every line with the names of the blocks that it is in."""
    for block in blocks:
        here = (*scope, block.key)
        name = " > ".join(here)
        yield from ((name, line) for line in block.lines)
        yield from walk(block.children, here)
        yield from ((name, line) for line in block.tail)


def checked(blocks: Callable[[str], list[Block]]) -> Callable[[str], list[Block]]:
    """Insist that the blocks are the whole text; the merge and the proof read the same texts."""

    @functools.lru_cache(maxsize=512)
    def check(text: str) -> tuple[Block, ...]:
        found = blocks(text)
        if "".join(block.text for block in found) != text:
            raise ValueError("the blocks are not the text")
        return tuple(found)

    return lambda text: [block.copy() for block in check(text)]


@functools.lru_cache(maxsize=8192)
def squeezed(text: str, quoted: re.Pattern[str] = _QUOTED) -> str:
    """Return a text without the blanks around its words, and with one sort of quotes.

    What a pattern finds and calls `exact` keeps its blanks, for they belong to a value.
    """
    parts: list[str] = []
    at = 0
    for match in quoted.finditer(text):
        is_exact = match["exact"] is not None
        inside = _SINGLE.sub(r'"\1"', match[0]) if is_exact else collapsed(match[0]).strip()
        parts += [collapsed(text[at : match.start()]), inside]
        at = match.end()
    return "".join([*parts, collapsed(text[at:])]).strip()


def comments(sign: str) -> Callable[[Sequence[str]], list[str]]:
    """Return what says of each line whether it is a comment, which begins with a sign."""
    return lambda lines: ["comment" * line.lstrip().startswith(sign) for line in lines]


def collapsed(text: str) -> str:
    """Return a text with one blank where there are several."""
    return re.sub(r"\s+", " ", text)


def unicode(text: str) -> str:
    """Return a text for parsers: private characters stand for the bytes of other encodings."""
    return text.translate(_PRIVATE)
