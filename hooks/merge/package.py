"""Merge three versions of a package, file by file."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from types import MappingProxyType

from . import lines
from .languages import PYTHON, language
from .merging import Version, Way, conflict, merge
from .python_blocks import definitions
from .renaming import Renaming
from .tree import LINK, File, Tree, encode

BOM = "\ufeff"
_OF_BEFORE = ("removed", "gone")
"""What is said of a file by its path of before."""


@dataclass
class Result:
    """A merged package, and what there is to say of it."""

    tree: Tree = field(default_factory=dict)
    conflicts: dict[str, dict[int, bytes]] = field(default_factory=dict)
    """By path, the versions that git keeps of a conflict."""
    moved: dict[str, str] = field(default_factory=dict)
    """Where files of before the update are after it, if elsewhere."""
    origins: dict[str, str] = field(default_factory=dict)
    """By path, the generated file that the developer has moved there."""
    left: list[str] = field(default_factory=list)
    """The developer's files that left, by their paths of before."""
    carried: dict[str, tuple[list[str], dict[int, tuple[str, ...]]]] = field(default_factory=dict)
    """By path of before, the files that have lines of it now, and by number what of each."""
    back: dict[str, list[str]] = field(default_factory=dict)
    """By path, the parts that the developer had deleted from the file of another ROS."""
    removed: dict[str, list[str]] = field(default_factory=dict)
    """By path of before, the edited parts that left a file with their interface (decision 23)."""
    missing: dict[str, list[str]] = field(default_factory=dict)
    """By path, the parts of the new version that the developer has deleted; "" is all of it."""
    own: dict[str, list[str]] = field(default_factory=dict)
    """By path, the parts that both sides have made, of which the developer's stay."""
    gone: dict[str, list[str]] = field(default_factory=dict)
    """By path of before, the parts that neither side has; the developer may have comments."""
    reworded: dict[str, list[str]] = field(default_factory=dict)
    """By path, new comments, tables and diagrams where the developer has deleted the old ones."""
    rejected: Tree = field(default_factory=dict)
    """Of the files in conflict, what was not merged, as a patch."""
    settled: Tree = field(default_factory=dict)
    """Of the files in conflict, the developer's side."""


def merge_package(
    mine: Tree,
    old: Tree,
    new: Tree,
    renaming: Renaming,
    is_kept: Callable[[str], bool],
    ways: Mapping[str, Way] = MappingProxyType({}),
    of_people: bool = False,
) -> Result:
    """Merge; `is_kept` says of a path that the developer's file stays as it is.

    `ways` says of some paths how they are merged, where not by block. `of_people`: the new version
    is another developer's.
    """
    sources = {renaming.path(path): path for path in (*old, *mine)}
    ours, base = ({renaming.path(p): file for p, file in tree.items()} for tree in (mine, old))
    package = _Package(ours, base, {**new}, renaming, sources, ways, of_people)
    package.follow_moves()
    for path in sorted({*ours, *base, *new}):
        package.file(path, is_kept(path))
    result = package.result
    for path, source in sources.items():
        if path != source and path in result.tree and source in mine:
            result.moved[source] = path
    return result


@dataclass
class _Package:
    """Three versions by the paths of after the update; `source` has those of before it."""

    mine: Tree
    old: Tree
    new: Tree
    renaming: Renaming
    source: Mapping[str, str]
    ways: Mapping[str, Way]
    of_people: bool
    result: Result = field(default_factory=Result)

    def follow_moves(self) -> None:
        """Find the files that the developer has moved; a link may lead there."""
        away = [path for path in self.old if path in self.new and path not in self.mine]
        own = [path for path in self.mine if path not in self.old and path not in self.new]
        for path, file in self.mine.items():
            target = _target(path, file)
            for one in (path, *(one for one in away if target and one.startswith(f"{path}/"))):
                led = target + one.removeprefix(path)
                if led in own and one in self.old and one in self.new:
                    self._follow(one, led)
                    own.remove(led)
        away = [path for path in away if path in self.old]
        for path, target in moves(self.old, self.mine, away, own).items():
            self._follow(path, target)

    def _follow(self, path: str, target: str) -> None:
        """Take the developer's file at `target` for the one that the model makes at `path`."""
        for tree in (self.old, self.new):
            tree[target] = tree.pop(path)
        self.result.origins[target] = self.source[path]

    def file(self, path: str, is_kept: bool) -> None:
        mine, old, new = (tree.get(path) for tree in (self.mine, self.old, self.new))
        result = self.result
        if self.of_people and old and (mine is None) != (new is None):
            self._deleted(path, old, mine, new)
        elif mine and old and not (new or is_kept):
            self._leaves(self.source[path], mine, old)
        elif mine and (is_kept or not new):
            source, text = self.source[path], mine.text
            data = mine.data if text is None else encode(self.renaming.text(source, text))
            result.tree[path] = replace(mine, data=data)
        elif mine and new:
            result.tree[path] = self._merged(path, mine, old, new)
        elif new and old and not is_kept:
            result.missing[path] = [""]
        elif new:
            result.tree[path] = new

    def _deleted(self, path: str, old: File, mine: File | None, new: File | None) -> None:
        """Leave a file out that one developer has deleted, unless the other has edited it."""
        file = mine or new
        if file and file != old:
            self.result.conflicts[path] = _stages(old, mine, new)
            self.result.tree[path] = self.result.settled[path] = file

    def _leaves(self, source: str, mine: File, old: File) -> None:
        """Note that a file leaves, which was the developer's too if edited."""
        one, other = mine.text, old.text
        if mine.data != old.data and (
            one is None or other is None or not language(source, one).same(one, other)
        ):
            self.result.left.append(source)

    def _merged(self, path: str, mine: File, old: File | None, new: File) -> File:
        mode = mine.mode if old is None or mine.mode != old.mode else new.mode
        files = (mine, old or File(b""), new)
        texts = [file.text for file in files if file.text is not None]
        if len(texts) < len(files):
            return self._opaque(path, mine, old, new)
        source = self.source[path]
        origin = self.result.origins.get(path, source)
        forms = [_form(text) for text in texts]
        ours, base, theirs = (
            text.removeprefix(mark).replace(ends, "\n")
            for text, (mark, ends) in zip(texts, forms, strict=True)
        )
        mark, ends = forms[2] if old and forms[0] == forms[1] else forms[0]
        versions = (
            self._version(origin, ours),
            self._version(origin, base) if old else None,
            Version(theirs, lambda known: known.blocks(theirs)),
        )
        is_stuck = self.renaming.behind(origin, ours) is None
        way = conflict if is_stuck else self.ways.get(path, merge)
        outcome = way(path, *versions, self.of_people)
        if outcome.conflict and self.of_people and way is merge:
            # What a developer puts around code, the merge follows on the one side alone.
            other = merge(path, *versions[::-1], True)
            outcome = outcome if other.conflict else other
        if language(path, theirs) is PYTHON and ours != versions[0].text:
            outcome.own += _met(ours, versions[0].text)
        for name in ("removed", "missing", "own", "gone", "reworded"):
            if parts := getattr(outcome, name):
                getattr(self.result, name)[source if name in _OF_BEFORE else path] = parts
        if outcome.conflict:
            self.result.conflicts[path] = _stages(old, mine, new)
            self.result.rejected[path] = File(encode(lines.rejected(path, outcome.merged)))
            settled = "".join(lines.settled(outcome.merged)).replace("\n", ends)
            self.result.settled[path] = File(encode(mark + settled), mode)
        return File(encode(mark + lines.text(outcome.merged).replace("\n", ends)), mode)

    def _version(self, path: str, text: str) -> Version:
        """Return a version of before the update, with what a rename has exchanged."""
        return Version(
            self.renaming.text(path, text), lambda known: self.renaming.blocks(known, path, text)
        )

    def _opaque(self, path: str, mine: File, old: File | None, new: File) -> File:
        """Choose between versions that are links, or no text."""
        if mine in (old, new):
            return new
        if mine.mode == LINK and not self.of_people:
            self.result.missing[path] = [""]
        elif new != old:
            self.result.conflicts[path] = _stages(old, mine, new)
        return mine


def _met(before: str, after: str) -> list[str]:
    """Return what a rename gives the name of another function, which hides it or is hidden."""
    had: dict[str, set[str]] = {}
    for name, now in zip(definitions(before), definitions(after), strict=False):
        had.setdefault(now, set()).add(name)
    return [now.rpartition(".")[2] for now, names in had.items() if len(names) > 1]


def _stages(*versions: File | None) -> dict[int, bytes]:
    """Return the base, the developer's and the new version of a file as git numbers them."""
    return {number: file.data for number, file in enumerate(versions, 1) if file}


def _form(text: str) -> tuple[str, str]:
    """Return how a text is written: the mark of its encoding, if any, and the ends of lines."""
    is_windows = 0 < text.count("\n") == text.count("\r\n")
    return BOM if text.startswith(BOM) else "", "\r\n" if is_windows else "\n"


def moves(old: Tree, mine: Tree, away: Iterable[str], own: Collection[str]) -> dict[str, str]:
    """Return which files of `old` that are `away` are which of the developer's `own`.

    Those that are most like them; of another name, where none has the same one.
    """
    likely = [
        (PurePosixPath(target).name == PurePosixPath(path).name, alike, path, target)
        for path in away
        for target in own
        if PurePosixPath(target).suffix == PurePosixPath(path).suffix
        and (alike := _likeness(old[path], mine[target])) > lines.ALIKE
    ]
    found: dict[str, str] = {}
    for *_, path, target in sorted(likely, reverse=True):
        if path not in found and target not in found.values():
            found[path] = target
    return found


def _likeness(one: File, other: File) -> float:
    """Return which part of the lines of a file another one has."""
    if one.text is None or other.text is None:
        return float(one == other)
    have = {line.strip() for line in other.text.splitlines()}
    wanted = [line.strip() for line in one.text.splitlines() if line.strip()]
    return sum(line in have for line in wanted) / len(wanted) if wanted else 0.0


def _target(path: str, file: File) -> str:
    """Return where in the package a link leads; nothing of a file."""
    if file.mode != LINK:
        return ""
    return posixpath.normpath(posixpath.join(posixpath.dirname(path), os.fsdecode(file.data)))
