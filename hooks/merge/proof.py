"""Find every line of the developer again, in the function, list or section it was written in."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field

from .blocks import Block, is_comment, walk
from .languages import PYTHON, TEXT, Language, language
from .lines import MARKS, changed, plain, split
from .matching import identify, match, opened, tell_apart, wrap
from .merging import readable
from .outlines import joined_rows
from .package import Result
from .renaming import Renaming
from .tree import File, Tree

_Line = tuple[str, str, int]
"""The blocks that it is in, itself, and its number."""


@dataclass
class Proof:
    """What became of the developer's lines."""

    total: int = 0
    in_place: int = 0
    left: list[tuple[str, int, str]] = field(default_factory=list)
    """Lines that left with what the summary says was removed: path, number, text of before."""
    lost: list[tuple[str, str]] = field(default_factory=list)
    """What should not be: files, by their paths after the update, and lines of them."""

    @property
    def sentence(self) -> str:
        """Say it in a line."""
        said = f"{self.in_place} of {self.total} of your lines are in their place"
        return said + (f"; {len(self.left)} left with what was removed" if self.left else "")


def prove(
    mine: Tree,
    old: Tree,
    result: Result,
    found: Tree,
    renaming: Renaming,
    new: Tree | None = None,
    of_people: bool = False,
) -> Proof:
    """Look for the lines of `mine` in `found`, which is the package as it is on the disk.

    What is in a container of `new` is looked for there. `of_people`: another developer's is `new`,
    who may have put a block around theirs.
    """
    prover = _Prover(result, found, renaming, of_people)
    origins = {renaming.path(path): path for path in old}
    for path, file in mine.items():
        target = renaming.path(path)
        origin = result.origins.get(target) or origins.get(target, path)
        base, made = old.get(origin, File(b"")), (new or {}).get(target, File(b""))
        if file.data != base.data:
            prover.file(path, origin, target, file, base.written, made.written)
    return prover.proof


@dataclass
class _Prover:
    result: Result
    found: Tree
    renaming: Renaming
    of_people: bool
    proof: Proof = field(default_factory=Proof)

    def file(self, path: str, origin: str, target: str, mine: File, old: str, new: str) -> None:
        """Look for the lines of a file, which is at `target` now, and was made as `origin`."""
        result, proof, found = self.result, self.proof, self.found.get(target)
        if mine.text is None:
            if found is None and path not in result.left:
                proof.lost.append((target, "the file"))
            return
        ours = plain(mine.text)
        known = language(path, mine.text)
        if not readable(known, [ours]):
            known = TEXT
        before, after = (_blocks(known, text, origin, self.renaming) for text in (old, ours))
        theirs = _blocks(known, new, "", Renaming()) if new else []
        match(theirs, before)
        before, theirs = opened(after, before, theirs)
        after = identify(after, before, before)
        tell_apart(after, before, theirs)
        before, after = (wrap(side, theirs, before, is_between=True) for side in (before, after))
        own = split(ours)
        lines = [
            (scope, line, _number(own, number, line))
            for scope, line, number in _developer_lines(known, after, before)
        ]
        behind = self.renaming.behind(origin, ours) or ()
        proof.left += [(path, number, own[number - 1]) for number in behind]
        proof.total += len(lines) + len(behind)
        if path in result.left or path in result.carried:
            targets, carried = result.carried.get(path, ([], {}))
            text = "".join(self.found[one].written for one in targets if one in self.found)
            for _, line, number in lines:
                if all(part in text for part in carried.get(number, ("\0",))):
                    proof.in_place += 1
                else:
                    proof.left.append((path, number, line))
            return
        sides = [*_sides(plain(found.written))] if found else []
        text = "".join(line for side, line in sides if side != "new")
        shown = Counter(known.key(line) for side, line in sides if side == "mine")
        there = identify(_blocks(known, text, "", Renaming()), before, after)
        joined = _joined(after, before, theirs)
        lines = [
            (scope, row if (row := joined.get(line)) and row in text else line, number)
            for scope, line, number in lines
        ]
        gone = _imported(known, before) - _imported(known, theirs) if theirs else set[str]()
        removed, generated = result.removed.get(path, []), {*split(old), *gone}
        for scope, line, number in self._not_there(known, lines, there, generated):
            if shown[known.key(line)]:  # in a conflict
                shown[known.key(line)] -= 1
                proof.in_place += 1
            elif any(name in scope for name in removed) or (
                removed and _may_leave(scope, line, generated)
            ):
                proof.left.append((path, number, line))
            else:
                proof.lost.append((target, line.strip()))
        is_merged = found is not None and target not in result.conflicts and text != ours
        if is_merged and not readable(known, [text]):
            proof.lost.append((target, "cannot be read any more"))

    def _not_there(
        self, known: Language, lines: list[_Line], found: list[Block], made: set[str]
    ) -> Iterator[_Line]:
        """Yield those of some lines that are not in their blocks; `made` is generated."""

        def place(scope: str) -> str:
            """Return a scope; of people the block alone, and of a namespace opened again."""
            return scope.rpartition(" > ")[2].removeprefix("{ ") if self.of_people else scope

        counts: dict[str, Counter[str]] = {}
        scopes = _scopes(found)
        around = {scope.rpartition(" > ")[0] for scope in scopes}
        rest = {
            scope: iter([known.key(line) for line in inside])
            for scope, inside in scopes.items()
            if not (self.of_people or scope in around or scope.endswith("> comment"))
            and not _is_import(known, scope)
        }
        for scope, inside in scopes.items():
            pieces = counts.setdefault(place(scope), Counter())
            pieces.update(piece for line in inside for piece in _pieces(known, scope, line))
        for scope, line, number in lines:
            have = counts.get(place(scope), Counter())
            pieces = Counter(_pieces(known, scope, line))
            if _is_import(known, scope):  # of names that have left, none is to be imported
                pieces = Counter({name: n for name, n in pieces.items() if name not in made})
            # `in` reads on from where the line before was found: none has come before another one.
            if pieces <= have and (scope not in rest or known.key(line) in rest[scope]):
                have -= pieces
                self.proof.in_place += 1
            else:
                yield scope, line, number


def _joined(*sides: list[Block]) -> dict[str, str]:
    """Return what becomes of rows of tables that both sides have changed."""
    found: dict[str, str] = {}
    mine, old, new = ({block.key: block.lines for block in side} for side in sides)
    for key in mine.keys() & old.keys() & new.keys():
        found |= joined_rows(mine[key], old[key], new[key])[0]
    return found


def _number(lines: list[str], number: int, line: str) -> int:
    """Return the number of a line that has perhaps another one after the update."""
    alike = [i for i, found in enumerate(lines) if found.strip() == line.strip()]
    return 1 + min(alike, key=lambda i: abs(i - number), default=number)


def places(mine: Tree, lost: list[tuple[str, str]], renaming: Renaming) -> Iterator[str]:
    """Say of lines that would be lost where the developer has them."""
    for target, line in lost:
        path = next((path for path in mine if renaming.path(path) == target), target)
        text = mine[path].text if path in mine else None
        lines = split(renaming.text(path, plain(text or "")))
        numbers = [str(n) for n, found in enumerate(lines, 1) if found.strip() == line]
        yield ":".join([path, *numbers[:1], f" {line}"])


def _is_import(known: Language, scope: str) -> bool:
    return known is PYTHON and scope.rpartition(" > ")[2].startswith("from ")


def _pieces(known: Language, scope: str, line: str) -> list[str]:
    """Return a line as it is compared: of an import, the names, which one may lay out."""
    if _is_import(known, scope):
        return re.findall(r"#.*|\w+(?: as \w+)?", re.sub(r"^\s*from \S+ import", "", line))
    return [known.key(line)]


def _imported(known: Language, blocks: list[Block]) -> set[str]:
    """Return the names that a file imports."""
    lines = ((scope, line) for scope, line in _walk(blocks) if _is_import(known, scope))
    return {piece for scope, line in lines for piece in _pieces(known, scope, line)}


def _may_leave(scope: str, line: str, made: set[str]) -> bool:
    """Say whether a line may leave with what it is not in: an import, a generated comment."""
    is_comment = line.strip().startswith(("//", "#"))
    return scope.rpartition(" > ")[2].startswith("from ") or (is_comment and line in made)


def _developer_lines(known: Language, mine: list[Block], old: list[Block]) -> Iterator[_Line]:
    """Yield the lines that the developer wrote.

    What a formatter made of generated lines is not the developer's.
    """
    before = _scopes(wrap(old, mine, old))
    numbers: dict[str, list[int]] = {}
    for number, (scope, _) in enumerate(_walk(mine)):
        numbers.setdefault(scope, []).append(number)
    for scope, inside in _scopes(mine).items():
        base = before.get(scope, [])
        if base and known.same("".join(inside), "".join(base)):
            continue
        keys = ([*map(known.key, lines)] for lines in (base, inside))
        for start, end, first, last in changed(*keys):
            if not known.same("".join(base[start:end]), "".join(inside[first:last])):
                for at in range(first, last):
                    if inside[at].strip():
                        yield scope, inside[at], numbers[scope][at]


def _blocks(known: Language, text: str, path: str, renaming: Renaming) -> list[Block]:
    try:
        return renaming.blocks(known, path, text)
    except (ValueError, RecursionError):
        return [Block("text", split(renaming.text(path, text)))]


def _scopes(blocks: list[Block]) -> dict[str, list[str]]:
    scopes: dict[str, list[str]] = {}
    for scope, line in _walk(blocks):
        scopes.setdefault(scope, []).append(line)
    return scopes


def _walk(blocks: list[Block]) -> Iterator[tuple[str, str]]:
    """Yield every line with the blocks it is in; a comment may become the first of a file.

    The names of an import may share a line in another version.
    """
    for scope, line in walk(blocks):
        around, _, last = scope.rpartition(" > ")
        scope = f"{around} > comment" if is_comment(last) else scope
        yield around if last.startswith("name ") else scope, line


def _sides(text: str) -> Iterator[tuple[str, str]]:
    """Yield the lines of a file, each with the side of a conflict that it is on."""
    sides = ("both", "mine", "new")
    at = 0
    for line in split(text):
        if line.rstrip() == MARKS[at]:  # one that nothing opens is the developer's
            at = (at + 1) % len(MARKS)
        else:
            yield sides[at], line
