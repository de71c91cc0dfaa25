"""The order of an update: a snapshot, Copier's own work, our merge in its place, the proof."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from pathlib import Path
from typing import Any

from ..changes import changed_answers, changes, left
from ..dictionary import Dictionary
from ..faults import SpecError
from .builds import carry_build_files
from .launch import carry_launch_files
from .package import Result, merge_package
from .proof import places, prove, uses, uses_of_left
from .recount import recount
from .renaming import Renaming, plan_renames
from .render import Renderer, begin, recorded_answers
from .report import Report, report
from .transaction import Guard, Snapshot, take
from .tree import Tree, read_paths


class Update:
    """One update, from before Copier's first write to the last line of its summary."""

    def __init__(self, package: Path, answers_file: str, quiet: bool) -> None:
        """Take the snapshot; whatever fails from now on brings it back."""
        begin(quiet)
        self.package, self.answers_file = package, answers_file
        self.snapshot: Snapshot = take(package)
        self.guard = Guard(self.snapshot)
        self.answers = recorded_answers(package, answers_file)

    def finish(
        self,
        answers: Mapping[str, Any],
        renderer: Renderer,
        dictionary: Dictionary,
        moved: Mapping[str, str],
        inline: bool,
    ) -> Report:
        """Merge, put in place, prove.

        Args:
            answers: those of the new version, the context among them.
            renderer: renders the package.
            dictionary: what names the items of a context.
            moved: the new paths of files that the new version of the model renames.
            inline: whether conflicts go between marks, else to files that end in .rej.

        Raises:
            SpecError: a line of the developer's would not be in its place; nothing has changed.

        """
        try:
            said = self._finish(answers, renderer, dictionary, moved, inline)
        except BaseException:
            self.guard.undo()
            raise
        finally:
            begin()
        self.guard.release()
        return said

    def _finish(
        self,
        answers: Mapping[str, Any],
        renderer: Renderer,
        dictionary: Dictionary,
        moved: Mapping[str, str],
        inline: bool,
    ) -> Report:
        spec = answers["spec"]
        old, new = renderer.recorded(self.answers), renderer.fresh(answers)
        mine = {p: f for p, f in self.snapshot.files.items() if p != self.answers_file}
        renaming = plan_renames(self.answers, spec, dictionary, old.tree, mine, renderer)
        renaming.follow(moved, old.tree, new.tree)
        renaming.move(old.tree, new.tree)
        trees = (mine, old.tree, new.tree, renaming, new.is_kept)
        ros = [context.get("ros") for context in (self.answers.get("spec") or {}, spec)]

        to_ros = int(ros[1] or 0) if ros[0] != ros[1] else None
        result = join(*trees, to_ros)
        proof = prove(mine, old.tree, result, result.tree, renaming)
        doubtful = [*proof.lost, *recount(*trees, result, result.tree, proof.left)]
        if doubtful:
            result = join(*trees, to_ros, {path for path, _ in doubtful})
        self.snapshot.put(result, {self.answers_file}, inline)
        found = read_paths(self.package, result.tree)
        proof = prove(mine, old.tree, result, found, renaming)
        if lost := [*places(mine, proof.lost, renaming)]:
            raise SpecError(
                "the update was undone, for it would have put lines of yours where you did not"
                " write them; take these lines out and commit; update; put them in again:"
                + _listed(lost)
            )
        if wrong := recount(*trees, result, found, proof.left):
            raise SpecError(
                "the update was undone, for these files would not be what both sides made of them;"
                " take your changes of them out and commit; update; put them in again:"
                + _listed(f"{path}: {what}" for path, what in wrong)
            )
        said = [*changed_answers(self.answers, answers)]
        said += changes(self.answers.get("spec") or {}, spec, dictionary)
        still = [*uses(mine, old.tree, new.tree, found, renaming)]
        gone = left(self.answers.get("spec") or {}, spec, dictionary)
        still += uses_of_left(gone, old.tree, new.tree, found)
        return report(self.package, self.snapshot.files, found, result, said, still, proof)


def _listed(lines: Iterable[str]) -> str:
    return "".join(f"\n  {line}" for line in [*lines][:20]) + "\n"


def join(
    mine: Tree,
    old: Tree,
    new: Tree,
    renaming: Renaming,
    is_kept: Callable[[str], bool],
    to_ros: int | None = None,
    unmerged: Collection[str] = (),
) -> Result:
    """Merge a package; in a move to another ROS, `to_ros`, carry what other files have there."""
    result = merge_package(mine, old, new, renaming, is_kept, unmerged=unmerged)
    if to_ros is not None:
        carry_launch_files(mine, old, new, renaming, result, to_ros)
        carry_build_files(mine, old, new, renaming, result, to_ros)
    return result
