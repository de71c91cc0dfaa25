"""The files of a package, or of a render, in memory."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

LINK = "120000"
SUBMODULE = "160000"
PLAIN = "100644"
EXECUTABLE = "100755"
TOO_LARGE = 5_000_000
"""Larger files, in bytes, are data: no model writes them, and they are not merged.

An update is refused where a generated file has grown beyond it.
"""


@dataclass(frozen=True)
class File:
    """What a path holds: some bytes, or where a link leads; and its mode, as git writes it."""

    data: bytes
    mode: str = PLAIN

    @property
    def text(self) -> str | None:
        """Return its text, other encodings' bytes included; None of a link or of binary data."""
        if self.mode == LINK or b"\0" in self.data:
            return None
        return self.data.decode(errors="surrogateescape")

    @property
    def written(self) -> str:
        """Return its text; an empty one of what has none."""
        return self.text or ""


Tree = dict[str, File]


def encode(text: str) -> bytes:
    """Return the bytes that `File.text` was made from."""
    return text.encode(errors="surrogateescape")


def is_too_large(file: Path) -> bool:
    """Say whether something is a file that is not merged because of its size."""
    is_plain = os.path.isfile(file) and not os.path.islink(file)
    return is_plain and os.path.getsize(file) > TOO_LARGE


def read(file: Path) -> File | None:
    """Read a file or a link; None of anything else."""
    if os.path.islink(file):
        return File(os.fsencode(os.readlink(file)), LINK)
    if not os.path.isfile(file) or is_too_large(file):
        return None
    return File(file.read_bytes(), EXECUTABLE if file.stat().st_mode & stat.S_IXUSR else PLAIN)


def read_paths(folder: Path, paths: Iterable[str]) -> Tree:
    """Read some files of a folder; those that are not there are left out."""
    found = ((path, read(folder / path)) for path in paths)
    return {path: file for path, file in found if file}


def read_folder(folder: Path) -> Tree:
    """Read all files of a folder."""
    return read_paths(folder, paths(folder))


def paths(folder: Path) -> Iterator[str]:
    """Yield the path of every file and link, but for those of repositories inside."""
    for place, folders, files in os.walk(folder):
        links = [name for name in folders if (Path(place) / name).is_symlink()]
        inside = Path(place) != folder and ".git" in (*folders, *files)
        folders[:] = [] if inside else [name for name in folders if name != ".git"]
        for name in [] if inside else (*files, *links):
            path = (Path(place) / name).relative_to(folder)
            if path.parts[0] != ".git":
                yield path.as_posix()


def write(file: Path, content: File) -> None:
    """Write a file or a link in place of what is there; never through a link."""
    file.parent.mkdir(parents=True, exist_ok=True)
    if file.is_symlink() or content.mode == LINK:
        file.unlink(missing_ok=True)
    if content.mode == LINK:
        os.symlink(os.fsdecode(content.data), file)
        return
    file.write_bytes(content.data)
    mode = file.stat().st_mode
    file.chmod(mode | 0o111 if content.mode == EXECUTABLE else mode & ~0o111)


def remove(folder: Path, path: str) -> None:
    """Remove a file, and the folders that it leaves empty."""
    (folder / path).unlink(missing_ok=True)
    for parent in (folder / path).parents:
        if parent == folder or not parent.is_dir() or any(parent.iterdir()):
            break
        parent.rmdir()
