"""Merge three lists of lines.

Unlike git's, this merge lets changes touch: two insertions at one place are both kept, and a line
may change beside one that the other side changed. Only changes of the same lines conflict.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from difflib import SequenceMatcher
from io import StringIO
from itertools import pairwise
from os.path import commonprefix

Lines = list[str]
Key = Callable[[str], str]
Same = Callable[[str, str], bool]
FEW = 3
"""Lines in common that part a conflict in two."""
ALIKE = 0.6
"""How much two lines, blocks or files have in common of which one has become the other."""
MARKS = ("<<<<<<< before updating", "=======", ">>>>>>> after updating")


@dataclass(frozen=True)
class Conflict:
    """Lines that both sides changed, each in its own way."""

    mine: Lines
    old: Lines
    new: Lines


Merged = Sequence["str | Conflict"]
_Matches = list[tuple[int, int, int]]


@dataclass(frozen=True)
class _Change:
    """Lines `start` to `end` of the old version have become `lines`."""

    start: int
    end: int
    lines: Lines
    is_mine: bool


def split(text: str) -> Lines:
    """Split at newlines alone, and keep them."""
    return StringIO(text).readlines()


def margin(line: str) -> int:
    """Return how many blanks a line begins with."""
    return len(line) - len(line.lstrip(" \t"))


def depth(lines: Iterable[str]) -> int:
    """Return how many blanks the first line begins with that is not empty."""
    return next((margin(line) for line in lines if line.strip()), 0)


def plain(text: str) -> str:
    """Return a text with line ends of one sort, and without a mark of its encoding."""
    return text.removeprefix("\ufeff").replace("\r\n", "\n")


def merge_lines(
    mine: Lines, old: Lines, new: Lines, key: Key, same: Same, of_people: bool = False
) -> Merged:
    """Merge two descendants of `old`.

    Lines of one `key` count as one line: the developer's form of it stays. Where both sides
    changed lines and one of them changed nothing but their form, `same`, the other one counts.
    """

    def settle(group: list[_Change], start: int, end: int) -> Merged:
        """Return what changes that meet come to.

        Of lines that the new version inserts where the developer has them already, one is enough;
        what two developers have written in one place may have lines in common.
        """
        sides = [[one for one in group if one.is_mine is side] for side in (True, False)]
        ours, theirs = (_apply(side, stable, start, end) for side in sides)
        if not all(sides):
            return ours if sides[0] else theirs
        if list(map(key, ours)) == list(map(key, theirs)) or same("".join(ours), "".join(theirs)):
            return ours
        if start == end:  # both insertions stay, the model's first (decision 24)
            have = set() if of_people else {key(line) for line in ours}
            return [*_ended(line for line in theirs if key(line) not in have), *ours]
        before = "".join(old[start:end])
        if same("".join(ours), before):
            return theirs
        if same("".join(theirs), before):
            return ours
        return [Conflict(ours, old[start:end], theirs)]

    ours, theirs = (_matches(old, side, key) for side in (mine, new))
    sides = [
        [_Change(start, end, other[first:last], is_mine) for start, end, first, last in gaps]
        for other, gaps, is_mine in ((mine, _gaps(ours), True), (new, _gaps(theirs), False))
    ]
    changes = sorted(
        [*_parted(old, *sides), *_parted(old, *sides[::-1])],
        key=lambda change: (change.start, change.end, change.is_mine),
    )
    stable = _stable(old, (new, theirs), (mine, ours))
    merged: list[str | Conflict] = []
    at = 0
    while changes:
        start, end = changes[0].start, changes[0].end
        group = [changes.pop(0)]
        # They share a line, or insert at one place.
        while changes and (changes[0].start < end or changes[0].end == start):
            group.append(changes.pop(0))
            end = max(end, group[-1].end)
        merged += stable[at:start]
        merged += settle(group, start, end)
        at = end
    return [*merged, *stable[at:]]


def changed(old: Sequence[str], new: Sequence[str]) -> Iterator[tuple[int, int, int, int]]:
    """Yield what differs: from where to where in the old lines, and in the new ones."""
    return _gaps(SequenceMatcher(None, old, new, False).get_matching_blocks())


def _gaps(matches: Iterable[tuple[int, int, int]]) -> Iterator[tuple[int, int, int, int]]:
    """Yield what is between matches."""
    start = first = 0
    for end, last, size in matches:
        if start < end or first < last:
            yield start, end, first, last
        start, first = end + size, last + size


def _parted(
    old: Lines, changes: Iterable[_Change], others: Iterable[_Change]
) -> Iterator[_Change]:
    """Part what changes line by line where what the other side has changed begins or ends."""
    places = {place for other in others for place in (other.start, other.end)}
    for change in changes:
        start, end, lines = change.start, change.end, change.lines
        cuts = sorted(places & {*range(start + 1, end)})
        if not cuts or end - start != len(lines) or not all(map(_alike, old[start:end], lines)):
            yield change
            continue
        for first, last in pairwise([start, *cuts, end]):
            yield replace(change, start=first, end=last, lines=lines[first - start : last - start])


def _alike(one: str, other: str) -> bool:
    return SequenceMatcher(None, one, other, False).ratio() > ALIKE


def _matches(old: Lines, other: Lines, key: Key) -> _Matches:
    """Return the places and lengths of equal lines, as `SequenceMatcher.get_matching_blocks`.

    What both begin and end with matches first: or the brace that ends a function would match the
    first one in it.
    """
    ours, theirs = list(map(key, old)), list(map(key, other))
    end, last = _filled(ours), _filled(theirs)
    head = len(commonprefix([ours[:end], theirs[:last]]))
    tail = len(commonprefix([ours[head:end][::-1], theirs[head:last][::-1]]))
    inner = SequenceMatcher(None, ours[head : end - tail], theirs[head : last - tail], False)
    found = [(i + head, j + head, size) for i, j, size in inner.get_matching_blocks()[:-1]]
    found += [(end - tail, last - tail, tail)]
    found += [(end, last, min(len(ours) - end, len(theirs) - last))]
    return [(0, 0, head), *found, (len(ours), len(theirs), 0)]


def _filled(lines: Lines) -> int:
    """Return how many lines there are without the empty ones at the end."""
    return max((number for number, line in enumerate(lines, 1) if line.strip()), default=0)


def _stable(old: Lines, *sides: tuple[Lines, _Matches]) -> Lines:
    """Return the old lines, each in the form that the last side gave it which has another."""
    lines = list(old)
    for other, matches in sides:
        for start, first, size in matches:
            for i in range(size):
                if other[first + i] != old[start + i]:
                    lines[start + i] = other[first + i]
    return lines


def _apply(changes: list[_Change], stable: Lines, start: int, end: int) -> Lines:
    lines: Lines = []
    for change in changes:
        lines += stable[start : change.start] + change.lines
        start = change.end
    return lines + stable[start:end]


def _ended(lines: Iterable[str]) -> Lines:
    return [line if line.endswith("\n") else line + "\n" for line in lines]


def conflicts(merged: Merged) -> bool:
    """Say whether a merge has left a conflict."""
    return any(isinstance(part, Conflict) for part in merged)


def text(merged: Merged) -> str:
    """Write a merge, its conflicts between git's marks."""
    lines: Lines = []
    for part in merged:
        for piece in [part] if isinstance(part, str) else _apart(part):
            if isinstance(piece, str):
                lines.append(piece)
            else:
                first, middle, last = (f"{mark}\n" for mark in MARKS)
                lines += [first, *_ended(piece.mine), middle, *_ended(piece.new), last]
    return "".join(_ended_but_last(lines))


def _apart(conflict: Conflict) -> Merged:
    """Return what of a conflict both sides have, and between it where they differ."""
    mine, new = conflict.mine, conflict.new
    common = [
        (start, first, size)
        for start, first, size in SequenceMatcher(None, mine, new, False).get_matching_blocks()
        if sum(bool(re.search(r"\w", line)) for line in mine[start : start + size]) >= FEW
    ]
    pieces: list[str | Conflict] = []
    at = last = 0
    for start, first, size in [*common, (len(mine), len(new), 0)]:
        if at < start or last < first:
            pieces.append(Conflict(mine[at:start], [], new[last:first]))
        pieces += mine[start : start + size]
        at, last = start + size, first + size
    return pieces if conflicts(pieces) else [conflict]


def _ended_but_last(lines: Lines) -> Lines:
    return [*_ended(lines[:-1]), *lines[-1:]]


def settled(merged: Merged, side: str = "mine") -> Lines:
    """Return a merge with one side of each conflict, `mine` or `new`."""
    parts = ([part] if isinstance(part, str) else getattr(part, side) for part in merged)
    return _ended_but_last([line for part in parts for line in part])


def rejected(path: str, merged: Merged) -> str:
    """Write what a merge could not settle as a patch, for a `.rej` file."""
    patch = [f"diff a/{path} b/{path}\t(rejected hunks)\n"]
    at = 1
    for part in merged:
        if isinstance(part, str):
            at += 1
            continue
        patch.append(f"@@ -{at},{len(part.old)} +{at},{len(part.new)} @@\n")
        patch += [f"-{line}" for line in _ended(part.old)]
        patch += [f"+{line}" for line in _ended(part.new)]
        at += len(part.mine)
    return "".join(patch)
