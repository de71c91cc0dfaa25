"""What an update has to say, line by line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from . import git
from .package import Result
from .proof import Proof
from .tree import Tree


@dataclass(frozen=True)
class Report:
    """The lines of the summary, the proof last; and the files in conflict."""

    lines: list[str]
    conflicts: list[str]


def report(
    package: Path,
    before: Tree,
    after: Tree,
    result: Result,
    changes: list[str],
    uses: Iterable[str],
    proof: Proof,
) -> Report:
    """Say what became of the files of a package, `before` and `after` an update."""
    conflicts = sorted(result.conflicts)
    files = [*_files(package, before, after, result), *_removed(package, before, after, result)]
    others = [f"missing   {path}{part and ': '}{part}" for path, part in _missing(result)]
    others += [f"still     {use}" for use in uses]
    others += [f"CONFLICT  {path}" for path in conflicts]
    if not changes and not files and not conflicts:
        others.append("Nothing has changed.")
    return Report([*changes, *files, *others, proof.sentence], conflicts)


def _files(package: Path, before: Tree, after: Tree, result: Result) -> Iterator[str]:
    sources = {new: old for old, new in result.moved.items()}
    for path, file in sorted(after.items()):
        if path in result.conflicts:
            continue
        old = before.get(sources.get(path, path))
        if path in sources:
            yield f"moved     {sources[path]} -> {path}"
        elif old is None:
            commit = git.commit_that_had(package, path)
            yield f"added     {path}" + (
                f"      (as it was: git show {commit}:./{path})" if commit else ""
            )
        elif old != file:
            yield f"merged    {path}"


def _removed(package: Path, before: Tree, after: Tree, result: Result) -> Iterator[str]:
    commit = git.last_commit(package)
    parts = [(path, "") for path in before if path not in result.moved and path not in after]
    parts += [(path, part) for path, names in result.removed.items() for part in names]
    for path, part in sorted(parts):
        if part or not (package / path).exists():
            what = f"{part} from {path}" if part else path
            yield f"removed   {what}      (see it again: git show {commit}:./{path})"


def _missing(result: Result) -> list[tuple[str, str]]:
    return [(path, part) for path, parts in sorted(result.missing.items()) for part in parts]
