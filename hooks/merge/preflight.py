"""Refuse what an update could not undo: what git does not have, links out of the package.

What refuses raises SpecError, whose message has the remedy.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Container, Iterable, Mapping
from pathlib import Path
from typing import Any

from packaging.version import InvalidVersion, Version

from ..changes import check_names_before
from ..dictionary import Dictionary
from ..faults import SpecError
from ..package import SUFFIX
from .branches import under_way
from .git import changed, is_repository, tracked, untracked
from .renaming import plan_moves, render_marked
from .render import Renderer, recorded_answers
from .tree import SUBMODULE, TOO_LARGE, is_too_large, read_paths


def check(
    package: Path,
    places: Mapping[str, str],
    new_answers: Mapping[str, Any],
    dictionary: Dictionary,
    renderer: Renderer,
    moved: Mapping[str, str],
) -> None:
    """Check that a package can be updated or made again.

    `places` has where the elements of the spec are, as `Model.places` gives it.
    `moved` has the new paths of files that the new version of the model renames.
    Both versions are rendered to see which files they write, and that they can be rendered at all;
    the merge needs these renders, too.
    """
    spec = new_answers["spec"]
    answers = recorded_answers(package, renderer.answers_file)
    recorded = answers.get("spec") or {}
    if answers:
        refuse_version_of_others(answers, renderer)
        check_names_before(recorded, spec, dictionary, places)
    modes = modes_in_git(package)
    refuse_names(modes)
    touched = {renderer.answers_file, *renderer.fresh(new_answers).tree}
    refuse_places(package, touched)
    moves: dict[str, str] = {}
    if answers:
        old = renderer.recorded(answers)
        touched |= set(old.tree)
        _refuse_large(package, old.tree)
        marked = render_marked(answers, (recorded, spec), dictionary, renderer)
        renaming = plan_moves(old.tree, *marked, modes)
        renaming.follow(moved, old.tree, renderer.fresh(new_answers).tree)
        moves = {path: after for path in modes if (after := renaming.path(path)) != path}
    refuse(package, modes, touched | set(moves.values()), moves)


def refuse_version_of_others(answers: Mapping[str, Any], renderer: Renderer) -> None:
    """Insist that a version with a local part, as of a house, is followed by such a one.

    Else a tag of upstream's has got where Copier looks (decision 112).
    """
    before, after = str(answers.get("_commit")), str(renderer.commit)
    with contextlib.suppress(InvalidVersion):
        is_other = Version(before).local and not Version(after).local
        if is_other and answers.get("_src_path") == renderer.url:
            raise SpecError(
                f"{after} is a version without a house, and {before} made this package; delete the"
                f" tag {after} from {renderer.url}, or give another one by --vcs-ref",
                "version-without-house",
            )


def is_joining(package: Path, answers_file: str) -> bool:
    """Say whether git has begun to join two branches here, and left the package unfinished."""
    return is_repository(package) and bool(changed(package) and under_way(package, answers_file))


def refuse_join(package: Path, answers: Mapping[str, Any], renderer: Renderer) -> None:
    """Insist that git has what is written over when two branches are joined."""
    paths = sorted({renderer.answers_file, *renderer.fresh(answers).tree})
    modes = tracked(package)
    refuse_names(modes)
    refuse_places(package, paths)
    _refuse_unknown(package, paths, modes)


def refuse_copy(
    package: Path, answers: Mapping[str, Any], renderer: Renderer, may_replace: bool
) -> None:
    """Insist that Copier can write a package into a folder, without a question if it cannot ask.

    It would end at the first file that could not be written, or would be replaced.
    """
    if all(entry.suffix == SUFFIX or entry.name == ".git" for entry in package.iterdir()):
        return
    made = renderer.fresh(answers)
    refuse_places(package, made.tree)
    if may_replace:
        return
    there = read_paths(package, [path for path in made.tree if not made.is_kept(path)])
    other = [path for path, file in sorted(there.items()) if file.data != made.tree[path].data]
    if other:
        names = ", ".join(other[:5]) + (" and more" if other[5:] else "")
        cure = "move them away, or let --overwrite replace them"
        what = f"{package}: {names} would be replaced, and Copier cannot ask; {cure}"
        raise SpecError(what, "would-be-replaced")


def modes_in_git(package: Path) -> dict[str, str]:
    """Return the mode of each file that git has; insist that there is a repository."""
    if not is_repository(package):
        raise SpecError(
            f"{package}: not in a git repository, so an update could not be undone;"
            " git init, git add and git commit it first",
            "no-repository",
        )
    return tracked(package)


def refuse(
    package: Path, modes: Mapping[str, str], paths: Iterable[str], moves: Mapping[str, str]
) -> None:
    """Insist that git can bring back each of the `paths`, which an update may touch.

    `modes` has the files of git; `moves` are those that a rename gives another path.
    """
    paths = sorted(set(paths))
    _refuse_unknown(package, paths, modes)
    edited = sorted(set(changed(package)) & set(paths))
    if edited:
        what = f"{_some(edited)}: changed since the last commit; commit or stash first"
        raise SpecError(what, "not-committed")
    for path in paths:
        if any(modes.get(parent) == SUBMODULE for parent in _parents(path)):
            what = f"{path}: belongs to a submodule; give the submodule another place"
            raise SpecError(what, "in-a-submodule")
    for before, after in moves.items():
        if before in modes and after in modes and after not in moves:
            raise SpecError(
                f"{after}: {before} is to have this name; give {after} another one and commit",
                "path-taken",
            )


def refuse_names(paths: Iterable[str]) -> None:
    """Insist that Copier can read the names of files."""
    for path in paths:
        if any("\udc80" <= letter <= "\udcff" for letter in path):
            shown = os.fsencode(path).decode(errors="backslashreplace")
            what = f"{shown}: a name that is not UTF-8; give it another one and commit"
            raise SpecError(what, "not-utf-8")


def refuse_places(package: Path, paths: Iterable[str]) -> None:
    """Insist that each of the `paths` can be written: no file is where a folder has to be.

    Nor may one be too large, for the snapshot and the merge would be without it.
    """
    for path in sorted(paths):
        for parent in _parents(path):
            if (package / parent).is_file():
                raise SpecError(
                    f"{parent}: a file, and {path} needs a folder of this name; give the file"
                    " another name and commit",
                    "path-taken",
                )
        if (package / path).is_dir():
            raise SpecError(
                f"{path}: a folder, and a generated file has this name; give the folder another"
                " name and commit",
                "path-taken",
            )
    _refuse_large(package, paths)


def _refuse_large(package: Path, paths: Iterable[str]) -> None:
    for path in sorted(paths):
        if is_too_large(package / path):
            raise SpecError(
                f"{path}: larger than {TOO_LARGE // 1_000_000} MB, which is too large to merge;"
                " put its data in a file of your own and commit",
                "too-large",
            )


def _refuse_unknown(package: Path, paths: Iterable[str], known: Container[str]) -> None:
    """Insist that git has what is written over, be it through a link."""
    for path in paths:
        _refuse_links(package, path, known)
    others = {*untracked(package)}
    folders = tuple(path for path in others if path.endswith("/"))
    missing = [path for path in paths if path in others or path.startswith(folders)]
    if missing:
        raise SpecError(
            f"{_some(missing)}: not in git (ignored, or never added), and the update would write"
            " over it; git add -f it and commit, or move it away",
            "not-in-git",
        )


def _refuse_links(package: Path, path: str, known: Container[str]) -> None:
    for part in (path, *_parents(path)):
        link = package / part
        if not link.is_symlink():
            continue
        target = link.resolve()
        inside = target.is_relative_to(package.resolve())
        if not inside or (
            target.is_file() and target.relative_to(package.resolve()).as_posix() not in known
        ):
            raise SpecError(
                f"{part}: a link to {target}, which git does not have in this package;"
                " put the file itself in its place and commit",
                "link-out-of-package",
            )


def _parents(path: str) -> list[str]:
    return [parent.as_posix() for parent in Path(path).parents if parent.as_posix() != "."]


def _some(paths: list[str]) -> str:
    more = f" and {len(paths) - 3} more" if len(paths) > 3 else ""
    return ", ".join(paths[:3]) + more
