"""Merge three versions of a package, file by file."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from types import MappingProxyType

from . import lines
from .languages import language
from .merging import Version, Way, conflict, merge
from .renaming import Renaming
from .tree import LINK, File, Tree, encode

BOM = "\ufeff"
ALIKE = 0.6
"""Which part of its lines a file that has been moved still has."""


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
    """By path of before, the edited parts that left a file."""
    missing: dict[str, list[str]] = field(default_factory=dict)
    """By path, the parts of the new version that the developer has deleted; "" is all of it."""
    own: dict[str, list[str]] = field(default_factory=dict)
    """By path, the parts that both sides have made, of which the developer's stay."""
    gone: dict[str, list[str]] = field(default_factory=dict)
    """By path of before, the parts that neither side has any longer."""
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
    return _Package(mine, old, new, renaming, is_kept, ways, of_people).result


class _Package:
    def __init__(
        self,
        mine: Tree,
        old: Tree,
        new: Tree,
        renaming: Renaming,
        is_kept: Callable[[str], bool],
        ways: Mapping[str, Way],
        of_people: bool,
    ) -> None:
        self.new, self.renaming, self.result = new, renaming, Result()
        self.ways, self.of_people = ways, of_people
        self.source = {renaming.path(path): path for path in old} | {
            renaming.path(path): path for path in mine
        }
        self.old = {renaming.path(path): file for path, file in old.items()}
        self.mine = {renaming.path(path): file for path, file in mine.items()}
        self.origin = self.result.origins
        self._follow_moves()
        for path in sorted({*self.mine, *self.old, *new}):
            self._file(path, is_kept(path))
        for path, source in self.source.items():
            if path != source and path in self.result.tree and source in mine:
                self.result.moved[source] = path

    def _follow_moves(self) -> None:
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
        likely = [
            (PurePosixPath(target).name == PurePosixPath(path).name, alike, path, target)
            for path in away
            for target in own
            if PurePosixPath(target).suffix == PurePosixPath(path).suffix
            and (alike := likeness(self.old[path], self.mine[target])) > ALIKE
        ]
        for *_, path, target in sorted(likely, reverse=True):
            if path in self.old and target in own:
                self._follow(path, target)
                own.remove(target)

    def _follow(self, path: str, target: str) -> None:
        """Take the developer's file at `target` for the one that the model makes at `path`."""
        self.old[target] = self.old.pop(path)
        self.new = {**self.new, target: self.new[path]}
        del self.new[path]
        self.origin[target] = self.source[path]

    def _file(self, path: str, is_kept: bool) -> None:
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
            stages = {1: old, 2: mine, 3: new}
            self.result.conflicts[path] = {n: one.data for n, one in stages.items() if one}
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
        origin = self.origin.get(path, source)
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
        for name, key in (
            ("removed", source),
            ("missing", path),
            ("own", path),
            ("gone", source),
            ("reworded", path),
        ):
            if parts := getattr(outcome, name):
                getattr(self.result, name)[key] = parts
        if outcome.conflict:
            stages = {2: mine.data, 3: new.data} | ({1: old.data} if old else {})
            self.result.conflicts[path] = stages
            self.result.rejected[path] = File(encode(lines.rejected(path, outcome.merged)))
            settled = "".join(lines.settled(outcome.merged)).replace("\n", ends)
            self.result.settled[path] = File(encode(mark + settled), mode)
        return File(encode(mark + outcome.text.replace("\n", ends)), mode)

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
            versions = {2: mine.data, 3: new.data} | ({1: old.data} if old else {})
            self.result.conflicts[path] = versions
        return mine


def _form(text: str) -> tuple[str, str]:
    """Return how a text is written: the mark of its encoding, if any, and the ends of lines."""
    is_windows = 0 < text.count("\n") == text.count("\r\n")
    return BOM if text.startswith(BOM) else "", "\r\n" if is_windows else "\n"


def likeness(one: File, other: File) -> float:
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
