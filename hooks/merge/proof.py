"""Find every line of the developer again, in the function, list or section it was written in."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from difflib import SequenceMatcher

from .blocks import Block, is_comment, walk
from .languages import PYTHON, TEXT, Language, language
from .lines import MARKS, plain, split
from .matching import identify, match, opened, tell_apart, wrap
from .merging import readable
from .package import Result
from .renaming import Renaming
from .tree import File, Tree

_SCOPES = dict[str, list[str]]


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
    proof = Proof()
    origins = {renaming.path(path): path for path in old}
    for path, file in mine.items():
        target = renaming.path(path)
        origin = result.origins.get(target) or origins.get(target, path)
        paths = (path, origin, target)
        made = (new or {}).get(target)
        _prove_file(proof, paths, file, old.get(origin), made, result, found, renaming, of_people)
    return proof


def _prove_file(
    proof: Proof,
    paths: tuple[str, str, str],
    mine: File,
    base: File | None,
    made: File | None,
    result: Result,
    tree: Tree,
    renaming: Renaming,
    of_people: bool,
) -> None:
    path, origin, target = paths
    found = tree.get(target)
    if base and mine.data == base.data:
        return
    if mine.text is None:
        if found is None and path not in result.left:
            proof.lost.append((target, "the file"))
        return
    ours, old = plain(mine.text), (base.text if base else None) or ""
    known = language(path, mine.text)
    if not readable(known, [ours]):
        known = TEXT
    before, after = (_blocks(known, text, origin, renaming) for text in (old, ours))
    theirs = _blocks(known, made.text, "", Renaming()) if made and made.text else []
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
    behind = [(path, number, own[number - 1]) for number in renaming.behind(origin, ours) or ()]
    proof.left += behind
    proof.total += len(lines) + len(behind)
    if path in result.left or path in result.carried:
        targets, carried = result.carried.get(path, ([], {}))
        text = "".join(tree[one].written for one in targets if one in tree)
        for _, line, number in lines:
            if all(part in text for part in carried.get(number, ("\0",))):
                proof.in_place += 1
            else:
                proof.left.append((path, number, line))
        return
    sides = [*_sides(plain(found.written))] if found else []
    text = "".join(line for side, line in sides if side != "new")
    shown = Counter(known.key(line) for side, line in sides if side == "mine")
    there = _blocks(known, text, "", Renaming())
    there = identify(there, before, after)
    removed = result.removed.get(path, [])
    gone = _imported(known, before) - _imported(known, theirs) if theirs else set[str]()
    generated = {*split(old), *gone}
    _read_back(proof, (path, target), known, lines, there, shown, generated, removed, of_people)
    changed = found is not None and target not in result.conflicts and text != ours
    if changed and not readable(known, [text]):
        proof.lost.append((target, "cannot be read any more"))


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


def _read_back(
    proof: Proof,
    paths: tuple[str, str],
    known: Language,
    lines: list[tuple[str, str, int]],
    found: list[Block],
    shown: Counter[str],
    made: set[str],
    removed: list[str],
    of_people: bool,
) -> None:
    """Look for lines in their blocks; a conflict shows those in `shown`, `made` is generated."""

    def place(scope: str) -> str:
        """Return a scope; of people, the block alone, and of a namespace that is opened again."""
        return scope.rpartition(" > ")[2].removeprefix("{ ") if of_people else scope

    counts: dict[str, Counter[str]] = {}
    scopes = _scopes(found)
    around = {scope.rpartition(" > ")[0] for scope in scopes}
    rest = {
        scope: iter([known.key(line) for line in inside])
        for scope, inside in scopes.items()
        if not (of_people or scope in around or scope.endswith("> comment"))
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
            proof.in_place += 1
        elif shown[known.key(line)]:
            shown[known.key(line)] -= 1
            proof.in_place += 1
        elif any(name in scope for name in removed) or (removed and _may_leave(scope, line, made)):
            proof.left.append((paths[0], number, line))
        else:
            proof.lost.append((paths[1], line.strip()))


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


def _developer_lines(
    known: Language, mine: list[Block], old: list[Block]
) -> Iterator[tuple[str, str, int]]:
    """Yield the lines that the developer wrote, each with the blocks it is in and its number.

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
        keys = list(map(known.key, base)), list(map(known.key, inside))
        matcher = SequenceMatcher(None, keys[0], keys[1], autojunk=False)
        for tag, start, end, first, last in matcher.get_opcodes():
            if tag in ("insert", "replace"):
                if known.same("".join(base[start:end]), "".join(inside[first:last])):
                    continue
                for at in range(first, last):
                    if inside[at].strip():
                        yield scope, inside[at], numbers[scope][at]


def _blocks(known: Language, text: str, path: str, renaming: Renaming) -> list[Block]:
    try:
        return renaming.blocks(known, path, text)
    except (ValueError, RecursionError):
        return [Block("text", split(renaming.text(path, text)))]


def _scopes(blocks: list[Block]) -> _SCOPES:
    scopes: _SCOPES = {}
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
