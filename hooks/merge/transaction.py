"""All or nothing: a snapshot before the first write, and its way back."""

from __future__ import annotations

import os
import uuid
import weakref
from dataclasses import dataclass
from pathlib import Path

from . import git
from .package import Result
from .tree import SUBMODULE, File, Tree, paths, read, read_paths, remove, write

REJECTED = ".rej"
TOKEN = "ros_package_update"


@dataclass(frozen=True)
class Snapshot:
    """A package before Copier writes: its files, and git's index, byte by byte."""

    package: Path
    files: Tree
    all_paths: frozenset[str]
    index: File | None
    index_time: int
    """When git has written it, in ns: git looks into files that are not older than its index."""
    modes: dict[str, str]

    def restore(self) -> None:
        """Bring everything back."""
        self.put(Result(self.files), set(), True)

    def put(self, result: Result, touched: set[str], inline: bool) -> None:
        """Put a merged package in the place of what Copier has made of it."""
        wanted = dict(result.tree)
        if not inline:
            wanted |= result.settled
            wanted |= {path + REJECTED: file for path, file in result.rejected.items()}
        added = set(paths(self.package)) - self.all_paths
        for path in [*added, *self.files]:  # a file may be where a folder was added
            if path not in wanted and path not in touched:
                remove(self.package, path)
        for path, file in wanted.items():
            if read(self.package / path) != file:
                write(self.package / path, file)
        if self.index:
            index = git.own_file(self.package, "index")
            write(index, self.index)
            os.utime(index, ns=(self.index_time, self.index_time))
        for path, versions in result.conflicts.items() if inline else ():
            if path in wanted:
                git.mark_conflict(self.package, path, wanted[path].mode, versions)


def take(package: Path) -> Snapshot:
    """Take a snapshot of the files that git has."""
    modes = git.tracked(package)
    plain = [path for path, mode in modes.items() if mode != SUBMODULE]
    index = git.own_file(package, "index")
    return Snapshot(
        package,
        read_paths(package, plain),
        frozenset(paths(package)),
        read(index),
        index.stat().st_mtime_ns if index.exists() else 0,
        modes,
    )


class Guard:
    """Brings a snapshot back unless told that all is well, even when Copier itself fails.

    It acts at the latest when the process ends. A token in git's folder says whose turn it is: an
    update that has been followed by another one, or by a commit, has nothing to bring back.
    """

    def __init__(self, snapshot: Snapshot) -> None:
        package = snapshot.package
        self._token = git.own_file(package, TOKEN)
        text = f"{uuid.uuid4().hex} {git.last_commit(package)}"
        self._token.write_text(text, encoding="utf-8")
        self._undo = weakref.finalize(self, _undo, snapshot, self._token, text)

    def undo(self) -> None:
        """Bring the snapshot back now."""
        self._undo()

    def release(self) -> None:
        """Keep what there is."""
        self._undo.detach()
        self._token.unlink(missing_ok=True)


def _undo(snapshot: Snapshot, token: Path, text: str) -> None:
    if token.exists() and token.read_text(encoding="utf-8") == text:
        if text.endswith(f" {git.last_commit(snapshot.package)}"):
            snapshot.restore()
        token.unlink()
