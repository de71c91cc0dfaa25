"""What an update asks of git."""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

from ..git import git
from .tree import Tree, read_folder

_LONG = 20_000
"""Characters: a command line of Windows ends at 32,767."""


def is_repository(folder: Path) -> bool:
    """Say whether git has a work tree here."""
    return git(folder, "rev-parse", "--is-inside-work-tree", check=False).strip() == "true"


def tracked(folder: Path) -> dict[str, str]:
    """Return the mode of each file below a folder that git has, by its path from there."""
    entries = git(folder, "ls-files", "-s", "-z", ".").split("\0")[:-1]
    return {path: facts.split()[0] for facts, path in (one.split("\t", 1) for one in entries)}


def untracked(folder: Path) -> list[str]:
    """Return the files below a folder that git has not, the ignored ones too."""
    return [path for path in git(folder, "ls-files", "-o", "-z", ".").split("\0") if path]


def changed(folder: Path) -> list[str]:
    """Return the tracked files below a folder that differ from the last commit."""
    status = git(folder, "status", "--porcelain", "--no-renames", "-z", "-uno", ".")
    prefix = git(folder, "rev-parse", "--show-prefix").rstrip("\n")
    return [entry[3:].removeprefix(prefix) for entry in status.split("\0") if entry]


def committed(folder: Path, path: str, commit: str) -> bytes:
    """Return a file of a commit; nothing where it has none."""
    return os.fsencode(git(folder, "show", f"{commit}:./{path}", check=False))


def files_of(folder: Path, commit: str) -> Tree:
    """Return the files below a folder as a checkout of a commit would write them."""
    prefix = git(folder, "rev-parse", "--show-prefix").rstrip("\n")
    with tempfile.TemporaryDirectory(prefix="commit.") as place:
        index = {"GIT_INDEX_FILE": f"{place}/index"}
        git(folder, "read-tree", commit, environment=index)
        names = os.fsencode(git(folder, "ls-files", "-z", ".", environment=index))
        to = f"--prefix={place}/files/"
        git(folder, "checkout-index", "-z", "--stdin", to, given=names, environment=index)
        return read_folder(Path(place, "files", prefix))


def parents(folder: Path, commit: str) -> list[str]:
    """Return the commits that a commit follows."""
    return git(folder, "rev-parse", f"{commit}^@").split()


def merge_bases(folder: Path, one: str, other: str) -> list[str]:
    """Return the last commits that two have in common: several after criss-cross merges."""
    return git(folder, "merge-base", "--all", one, other, check=False).split()


def name_in(folder: Path, commit: str, path: str = "") -> str:
    """Return git's name of what a commit has at a path, or of all it has in the folder."""
    return git(folder, "rev-parse", "--verify", "-q", f"{commit}:./{path}", check=False).strip()


def last_making(folder: Path, path: str, commit: str) -> str:
    """Return the last commit, up to one, that merges or has changed a file."""
    options = ("--full-history", "--parents", "--topo-order", "-1")
    return git(folder, "rev-list", *options, commit, "--", path).partition(" ")[0].strip()


def changing(folder: Path, path: str, start: str, end: str) -> list[str]:
    """Return the commits of a branch that have changed a file since it began, the first first."""
    options = ("--reverse", "--first-parent")
    return git(folder, "rev-list", *options, f"{start}..{end}", "--", path).split()


def own_file(folder: Path, name: str) -> Path:
    """Return where git keeps a file or folder of its own, like MERGE_HEAD."""
    return folder / git(folder, "rev-parse", "--git-path", name).rstrip("\n")


def stage(folder: Path, paths: Iterable[str]) -> None:
    """Put files into the index as they are, or take those out that are not there."""
    git(folder, "update-index", "--add", "--remove", "-z", "--stdin", given=_records(paths))


def keep(folder: Path, data: bytes) -> str:
    """Keep a content in git; return its short name."""
    return git(folder, "rev-parse", "--short", _kept(folder, data)).strip()


def _kept(folder: Path, data: bytes) -> str:
    return git(folder, "hash-object", "-w", "--stdin", "--no-filters", given=data).strip()


def last_commit(folder: Path) -> str:
    """Return the short name of the last commit."""
    return git(folder, "rev-parse", "--short", "HEAD", check=False).strip()


def commit_that_had(folder: Path, path: str, word: str = "") -> str:
    """Return the last commit that had a file which git has no longer, or an empty text.

    With a `word`, the last one in which the file had this word, which it has no longer.
    """
    sought = f"-S{word}" if word else "--diff-filter=D"
    found = git(folder, "log", "-1", "--format=%h", sought, "--", path, check=False).strip()
    parents = git(folder, "rev-parse", "--short", f"{found}^", check=False) if found else ""
    return parents.strip()


def once_there(folder: Path, paths: Sequence[str], words: Sequence[str] = ()) -> set[str]:
    """Return those of some paths whose file a commit has deleted: a few more may be among them.

    With `words`, those of whose file a commit has changed a line that has one. Git is asked once
    for all, where a command line takes them.
    """
    if not paths or sum(map(len, [*paths, *words])) > _LONG:
        return {*paths}
    sought = "|".join(re.sub(r"[][\\.*^$+?{}|()]", r"\\\g<0>", word) for word in words)
    options = ["--text", f"-G{sought}"] if words else ["--diff-filter=D"]
    options += ["--no-renames", "--format=", "--name-only", "--relative", "-z"]
    found = git(folder, "log", *options, "--", *paths, check=False).split("\0")
    return {*filter(None, found)}


def mark_conflict(folder: Path, path: str, mode: str, versions: dict[int, bytes]) -> None:
    """Tell git of a conflict: the base is version 1, the developer's 2, the new one 3."""
    full = git(folder, "rev-parse", "--show-prefix").rstrip("\n") + path
    lines = [f"0 {'0' * 40}\t{full}"]
    for stage, data in versions.items():
        lines.append(f"{mode} {_kept(folder, data)} {stage}\t{full}")
    git(folder, "update-index", "-z", "--index-info", given=_records(lines))


def _records(lines: Iterable[str]) -> bytes:
    return os.fsencode("".join(line + "\0" for line in lines))
