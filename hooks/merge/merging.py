"""Merge three versions of a file by block, and inside of a block by line.

A block stays with its name. What the spec no longer has leaves, what is new comes where the new
version has it, and a block of the developer's own stays after the block it followed.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from ..changes import GONE
from . import lines, outlines, python_blocks
from .blocks import Block, is_comment, walk
from .languages import CPP, MARKDOWN, PYTHON, TEXT, YAML, Language, language
from .lines import Conflict, Merged
from .matching import BothAroundError, align

_LOOSE = re.compile(
    r"then$|comment |header|docstring|empty|text|start|#(?!#* )|from |import |name |using |.* =$"
)
"""Blocks that are known by what they say, or that nobody misses."""
_IMPORTED = re.compile(r"^\s*from \S+ import|[\s,]")
"""What is no part of a name that is imported: it may have an import of its own."""
_ABOVE = re.compile(r"(?:\s*\n)?")
"""Empty lines above a block."""
_UNNAMED = re.compile(r"from |import |install |list ")
"""Blocks of which there may be several with one key."""


@dataclass
class Outcome:
    """What the merge of a file gave; the parts are those of a `Result`, of one file."""

    merged: Merged = field(default_factory=list)
    removed: list[str] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    own: list[str] = field(default_factory=list)
    gone: list[str] = field(default_factory=list)
    reworded: list[str] = field(default_factory=list)

    @property
    def conflict(self) -> bool:
        """Say whether the developer must choose."""
        return lines.conflicts(self.merged)


@dataclass(frozen=True)
class Version:
    """A version of a file: its text, and how to read the blocks of it."""

    text: str
    read: Callable[[Language], list[Block]]


def merge(
    path: str, mine: Version, old: Version | None, new: Version, of_people: bool = False
) -> Outcome:
    """Merge two descendants of `old`; blocks where all three can be read so, else lines.

    There is no `old` where both sides have made the file. `of_people`: both sides are developers',
    so that neither gives way to the other.
    """
    if mine.text == new.text or (old and mine.text == old.text):
        return Outcome(lines.split(new.text))
    known = language(path, new.text)
    is_same = old is not None and new.text == old.text
    if known not in (TEXT, MARKDOWN) or old is not None:
        try:
            merger = _Merger(known, of_people)
            base = old.read(known) if old else []
            sides = align(mine.read(known), base, new.read(known), of_people)
            outcome = merger.outcome
            outcome.merged = [mine.text] if is_same else merger.sequence(*sides)
            if readable(known, outcome.merged):
                outcome.missing = [] if of_people else [*_deleted(*sides)]
                return outcome
        except BothAroundError:
            outcome = by_line(path, mine, old, new, of_people)
            return outcome if outcome.conflict else conflict(path, mine, old, new)
        except (ValueError, RecursionError):
            pass
    return by_line(path, mine, old, new, of_people)


def by_line(
    path: str, mine: Version, old: Version | None, new: Version, of_people: bool = False
) -> Outcome:
    """Merge a file whose blocks cannot be read, or not all of them."""
    if old is None:
        return conflict(path, mine, old, new)
    known = language(path, new.text)
    ours, base, theirs = (lines.split(version.text) for version in (mine, old, new))

    def same(one: str, other: str) -> bool:
        depths = {lines.depth(lines.split(text)) for text in (one, other)}
        return (len(depths) == 1 or known not in (PYTHON, YAML)) and known.same(one, other)

    outcome = Outcome(lines.merge_lines(ours, base, theirs, known.key, same, of_people))
    could_be_read = readable(known, [mine.text])
    is_clear = known not in (CPP, PYTHON) or (of_people and could_be_read)
    is_clear = is_clear or _names(known, old) == _names(known, new)  # else whose is a body?
    is_read = outcome.conflict or not could_be_read or readable(known, outcome.merged)
    return outcome if is_clear and is_read else conflict(path, mine, old, new)


def conflict(
    path: str, mine: Version, old: Version | None, new: Version, of_people: bool = False
) -> Outcome:
    """Leave all of a file to the developer."""
    return Outcome(_disputed(mine.text, old.text if old else "", new.text))


def _disputed(*texts: str) -> Merged:
    return [Conflict(*map(lines.split, texts))]


Way = Callable[[str, Version, "Version | None", Version, bool], Outcome]
"""How a file is merged: by block, by line, or by the developer."""


def readable(known: Language, merged: Merged) -> bool:
    """Say whether a merge is of its language, whichever side of its conflicts is chosen.

    It may be that of a block, which is as deep as what it stands in.
    """
    try:
        for side in ("mine", "new"):
            known.blocks(textwrap.dedent("".join(lines.settled(merged, side))))
    except (ValueError, RecursionError):
        return False
    return True


def _names(known: Language, version: Version) -> set[str]:
    """Return the names of the blocks of a version; none where it cannot be read."""
    try:
        return {name for name, _ in walk(version.read(known))}
    except (ValueError, RecursionError):
        return set()


def _deleted(mine: Sequence[Block], old: Sequence[Block], new: Sequence[Block]) -> Iterator[str]:
    """Yield the parts that the developer has deleted: functions, elements, keys, sections."""
    ours, base = ({block.key: block for block in side} for side in (mine, old))
    for block in new:
        if block.key in ours and block.key in base:
            inner = (ours[block.key], base[block.key], block)
            yield from _deleted(*(found.children for found in inner))
        elif block.key in base and not _LOOSE.match(block.key):
            yield block_name(block.key)


class _Merger:
    def __init__(self, known: Language, of_people: bool) -> None:
        self.language, self.of_people, self.outcome = known, of_people, Outcome()

    def sequence(
        self, mine: Sequence[Block], old: Sequence[Block], new: Sequence[Block]
    ) -> Merged:
        """Merge the blocks of a file, a class, an element."""
        ours, base, theirs = ({block.key: block for block in side} for side in (mine, old, new))
        merged: list[str | Conflict] = []
        last = ""
        for key in _order(list(ours), list(base), list(theirs)):
            end = len(merged)
            if key in ours and key in theirs:
                merged += self.block(ours[key], base.get(key), theirs[key])
            elif key in ours and key in base:
                merged += (self.left if base[key].lines else self.emptied)(ours[key], base[key])
            elif key in ours:
                merged += self.alone(ours[key], base, theirs)
            elif key not in base:
                merged += lines.split(theirs[key].text)
            elif key not in theirs:
                self.outcome.gone.append(block_name(key))
            elif self.of_people and not self.is_same(theirs[key], base[key]):
                merged += _disputed("", base[key].text, theirs[key].text)
            elif self.language is PYTHON and key.startswith("from "):
                names = python_blocks.joined_import("", base[key].text, theirs[key].text)
                merged += lines.split(names or "")
            else:
                self.outcome.reworded += lines.split(theirs[key].text)
            both = [
                one for one in merged[end - 1 : end + 1] if isinstance(one, str) and one.strip()
            ]
            if is_comment(last) and last not in theirs and len(both) == 2:
                merged.insert(end, "\n")  # or the comment would be about what follows it now
            last = key if merged[end:] else last
        return merged

    def alone(self, mine: Block, old: dict[str, Block], new: dict[str, Block]) -> Merged:
        """Return what the developer alone has; of one more import of a module, what stays.

        An import may be in an `if TYPE_CHECKING`, which leaves when it is all in there.
        """
        name = mine.key.partition(" #")[0]
        if self.language is PYTHON and name.startswith("from ") and name in old and name in new:
            made = new[name].text
            left = python_blocks.joined_import(mine.text, old[name].text + made, made)
            return lines.split(mine.text if left is None else left)
        if self.language is PYTHON and mine.children and not name.startswith("from "):
            inner = [line for child in mine.children for line in self.alone(child, old, new)]
            text = lines.text([*mine.lines, *inner, *mine.tail])
            if text == mine.text or readable(PYTHON, [text]):
                return lines.split(text)
            if not lines.text(inner).strip():
                self.outcome.removed.append(block_name(mine.key))
                return []
        return lines.split(mine.text)

    def left(self, mine: Block, old: Block) -> Merged:
        """Take out a block that the new version has no longer."""
        texts = [_IMPORTED.sub("", block.text) for block in (mine, old)]
        is_name = mine.key.startswith("name ") and texts[0] == texts[1]
        if is_name or self.is_same(mine, old):
            return []
        if self.of_people:
            return _disputed(mine.text, old.text, "")
        self.outcome.removed.append(block_name(mine.key))
        return []

    def block(self, mine: Block, old: Block | None, new: Block) -> Merged:
        """Merge one block; where there was none before, both stay, or what has one name once.

        Decision 30: of one name the developer's stays.
        """
        if old is None:
            old = Block(mine.key, mine.lines, [], mine.tail)
            if not (mine.children and new.children):
                if self.is_same(mine, new):
                    return lines.split(mine.text)
                if _UNNAMED.match(mine.key):
                    return lines.split(new.text + mine.text)
                if self.of_people:
                    return _disputed(mine.text, "", new.text)
                self.outcome.own.append(block_name(mine.key))
                return lines.split(mine.text)
            new = Block(new.key, mine.lines, new.children, mine.tail)
        if self.is_same(new, old):
            return lines.split(new.text if mine.text == old.text else mine.text)
        is_import = self.language is PYTHON and mine.key.startswith("from ") and not mine.children
        is_joined = is_import and mine.text.count("\n") == 1
        if self.is_same(mine, old) and not is_joined:
            return lines.split(_framed(mine.text, old.text, new.text))
        names = python_blocks.joined_import(mine.text, old.text, new.text) if is_import else None
        if names is not None:
            return lines.split(names)
        is_leaf = not new.children and new.lines and new.lines != old.lines
        if not mine.children or is_leaf:
            sides = [block.text for block in (mine, old, new)]
            merged = self.lines(*map(lines.split, sides))
            return merged if self.is_sound(merged, mine.text) else _disputed(*sides)
        head = self.lines(mine.lines, old.lines, new.lines)
        inner = self.sequence(mine.children, old.children, new.children)
        if self.language is PYTHON and mine.key.startswith("from "):
            inner = python_blocks.with_imports(inner)
        return [*head, *inner, *self.lines(mine.tail, old.tail, new.tail)]

    def emptied(self, mine: Block, old: Block) -> Merged:
        """Take out of a container of the developer's what leaves, which is all that is generated.

        In Python one that is empty cannot stay. A generated comment above it leaves, too.
        """
        made = {line for _, line in walk(old.children) if line.strip()}
        head = [line for line in mine.lines if line not in made]
        mine = Block(mine.key, head, mine.children, mine.tail)
        merged = self.block(mine, old, Block(mine.key, []))
        if self.language is PYTHON and not readable(PYTHON, [lines.text(merged)]):
            return self.left(mine, old)
        return merged

    def lines(self, mine: lines.Lines, old: lines.Lines, new: lines.Lines) -> Merged:
        """Merge lines; in a conflict without comments and the like that the developer deleted."""
        known = self.language
        if known is MARKDOWN:
            ours, base = outlines.joined_rows(mine, old, new)
            mine, old = [ours.get(row, row) for row in mine], [base.get(row, row) for row in old]
        merged = lines.merge_lines(mine, old, new, known.key, known.same, self.of_people)
        if self.of_people or not lines.conflicts(merged):
            return merged
        sides = (mine, old, new)
        had, made, came = ([*zip(known.asides(side), side, strict=True)] for side in sides)
        gone = {kind for kind, _ in made} - {"", *(kind for kind, _ in had)}
        old, new = ([line for kind, line in told if kind not in gone] for told in (made, came))
        bare = lines.merge_lines(mine, old, new, known.key, known.same)
        if lines.conflicts(bare) or not self.is_sound(bare, "".join(sides[0])):
            return merged
        self.outcome.reworded += [line for kind, line in came if kind in gone]
        return bare

    def is_sound(self, merged: Merged, mine: str) -> bool:
        """Say whether lines of a block can be read, if the developer's can."""
        return readable(self.language, merged) or not readable(self.language, [mine])

    def is_same(self, one: Block, other: Block) -> bool:
        return one.text == other.text or self.language.same(one.text, other.text)


def _framed(mine: str, old: str, new: str) -> str:
    """Return what is new between the developer's empty lines, where it changes none of them."""
    above = [found[0] for text in (mine, old, new) if (found := _ABOVE.match(text))]
    below = [text[len(text.rstrip()) :] for text in (mine, old, new)]
    if above[1] == above[2]:
        new = above[0] + new.removeprefix(above[2])
    return new.removesuffix(below[2]) + below[0] if below[1] == below[2] else new


def _order(mine: list[str], old: list[str], new: list[str]) -> list[str]:
    """Return all names, in the new order but for what the developer has moved."""
    known = set(old)
    if [key for key in mine if key in known] == [key for key in old if key in set(mine)]:
        return _inserted(_inserted(new, mine), old)
    own = _moved(mine, old)
    moved = _moved(new, old) - own
    stay = [key for key in mine if key not in moved]
    stay = _inserted(stay, [key for key in new if key in known - own and key in mine])
    return _inserted(_inserted(stay, new), old)


def _moved(keys: list[str], old: list[str]) -> set[str]:
    """Return what is not where it was before, beside the rest."""
    both = {*keys} & {*old}
    before, after = ([key for key in each if key in both] for each in (old, keys))
    return {key for start, end, *_ in lines.changed(before, after) for key in before[start:end]}


def _inserted(keys: list[str], others: Iterable[str]) -> list[str]:
    """Put in what `others` has more, each after the one that it follows there."""
    result = list(keys)
    have = set(keys)
    at = 0
    for key in others:
        if key in have:
            at = result.index(key) + 1
        else:
            result.insert(at, key)
            at += 1
    return result


def block_name(key: str) -> str:
    """Name a block as a person would: `serve_load`, `exec_depend rclpy`."""
    name = re.sub(r"( #\d+)?$", "", key).replace(GONE, "")
    return name.removeprefix("def ").removeprefix("name ").removesuffix("()")
