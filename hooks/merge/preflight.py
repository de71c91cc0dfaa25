"""Refuse what an update could not undo: what git does not have, links out of the package."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from ..changes import check_names_before, marked
from ..dictionary import Dictionary
from ..faults import SpecError
from .git import changed, is_repository, tracked, untracked
from .renaming import plan_renames
from .render import Renderer, recorded_answers
from .transaction import is_guarded
from .tree import LINK, SUBMODULE


def check(
    package: Path,
    spec_file: str,
    new_answers: Mapping[str, Any],
    dictionary: Dictionary,
    renderer: Renderer,
) -> None:
    """Check that a package can be updated or made again; `spec_file` is for messages.

    The new version is rendered where that is needed: to see which files it would write, and, with
    no guard that brings the package back, to see that it can be rendered at all.

    Raises:
        SpecError: it cannot; the message has the remedy.

    """
    spec = new_answers["spec"]
    answers = recorded_answers(package, renderer.answers_file)
    recorded = answers.get("spec") or {}
    if answers:
        check_names_before(recorded, spec, dictionary, spec_file)
    modes = tracked(package) if is_repository(package) else {}
    renamed = any(mark.before != mark.after for mark in marked(recorded, spec, dictionary)[1])
    at_risk = not modes or bool(untracked(package)) or LINK in modes.values()
    touched = {renderer.answers_file}
    moves: dict[str, str] = {}
    if at_risk or renamed or not is_guarded(package):
        touched |= set(renderer.fresh(new_answers).tree)
    if answers and (at_risk or renamed):
        old = renderer.recorded(answers)
        touched |= set(old.tree)
        renaming = plan_renames(answers, spec, dictionary, old.tree, modes, renderer)
        moves = {path: renaming.path(path) for path in modes}
        moves = {path: after for path, after in moves.items() if after != path}
    refuse(package, touched | set(moves.values()), moves)


def refuse(package: Path, paths: Iterable[str], moves: dict[str, str]) -> None:
    """Insist that git can bring back each of the `paths`, which an update may touch.

    `moves` are the files that a rename gives another path.

    Raises:
        SpecError: it could not; the message has the remedy.

    """
    paths = sorted(set(paths))
    if not is_repository(package):
        raise SpecError(
            f"{package}: not in a git repository, so an update could not be undone;"
            " git init, git add and git commit it first"
        )
    modes = tracked(package)
    for path in paths:
        _refuse_links(package, path, set(modes))
    _refuse_untracked(package, paths)
    edited = sorted(set(changed(package)) & set(paths))
    if edited:
        raise SpecError(f"{_some(edited)}: changed since the last commit; commit or stash first")
    for path in paths:
        if any(modes.get(parent) == SUBMODULE for parent in _parents(path)):
            raise SpecError(f"{path}: belongs to a submodule; give the submodule another place")
    for before, after in moves.items():
        if before in modes and after in modes and after not in moves:
            raise SpecError(
                f"{after}: {before} is to have this name; give {after} another one and commit"
            )


def _refuse_untracked(package: Path, paths: Iterable[str]) -> None:
    others = untracked(package)
    folders = tuple(path for path in others if path.endswith("/"))
    missing = [path for path in paths if path in set(others) or path.startswith(folders)]
    if missing:
        raise SpecError(
            f"{_some(missing)}: not in git (ignored, or never added), and the update would write"
            " over it; git add -f it and commit, or move it away"
        )


def _refuse_links(package: Path, path: str, known: set[str]) -> None:
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
                " put the file itself in its place and commit"
            )


def _parents(path: str) -> list[str]:
    return [parent.as_posix() for parent in Path(path).parents if parent.as_posix() != "."]


def _some(paths: list[str]) -> str:
    more = f" and {len(paths) - 3} more" if len(paths) > 3 else ""
    return ", ".join(paths[:3]) + more
