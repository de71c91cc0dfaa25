"""The order of an update: a snapshot, Copier's own work, our merge in its place, the proof."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..changes import changes
from ..dictionary import Dictionary
from ..faults import SpecError
from . import git
from .package import Result, merge_package
from .proof import Proof, prove, uses
from .renaming import Renaming, plan_renames
from .render import Renderer, recorded_answers
from .transaction import Guard, Snapshot, take
from .tree import Tree, read_paths


@dataclass
class Report:
    """What an update has to say, line by line."""

    lines: list[str] = field(default_factory=list)
    conflicts: list[str] = field(default_factory=list)


class Update:
    """One update, from before Copier's first write to the last line of its summary."""

    def __init__(self, package: Path, answers_file: str) -> None:
        """Take the snapshot; whatever fails from now on brings it back."""
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
            moved: the new paths of files that the new version of the model calls otherwise.
            inline: whether conflicts go between marks, else to files that end in .rej.

        Raises:
            SpecError: a line of the developer's would not be in its place; nothing has changed.

        """
        try:
            report = self._finish(answers, renderer, dictionary, moved, inline)
        except BaseException:
            self.guard.undo()
            raise
        self.guard.release()
        return report

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
        renaming.moved = {
            path: target
            for path, target in moved.items()
            if target in new.tree and path not in new.tree
        }
        trees = (mine, old.tree, new.tree, renaming, new.is_kept)
        result = merge_package(*trees)
        doubtful = prove(mine, old.tree, result, result.tree, renaming).lost
        if doubtful:
            result = merge_package(*trees, unmerged={path for path, _ in doubtful})
        self.snapshot.put(result, {self.answers_file}, inline)
        found = read_paths(self.package, result.tree)
        proof = prove(mine, old.tree, result, found, renaming)
        if proof.lost:
            raise SpecError(
                "the update was undone, for it would have put lines of yours where you did not"
                " write them:" + "".join(f"\n  {path}: {line}" for path, line in proof.lost[:20])
            )
        said = changes(self.answers.get("spec") or {}, spec, dictionary)
        return self._report([*said], result, proof, new.tree, found, renaming)

    def _report(
        self,
        said: list[str],
        result: Result,
        proof: Proof,
        new: Tree,
        found: Tree,
        renaming: Renaming,
    ) -> Report:
        commit = git.last_commit(self.package)
        files = self.snapshot.files
        lines = list(said)
        sources = {after: before for before, after in result.moved.items()}
        for path, file in sorted(found.items()):
            before = files.get(sources.get(path, path))
            if path in result.conflicts:
                continue
            if path in sources:
                lines.append(f"moved     {sources[path]} -> {path}")
            elif before is None:
                lines.append(f"added     {path}{self._seen_before(path)}")
            elif before != file:
                lines.append(f"merged    {path}")
        gone = sorted(set(files) - set(found) - set(result.moved) - {self.answers_file})
        for path in gone:
            if path in files and not (self.package / path).exists():
                lines.append(f"removed   {path}      (see it again: git show {commit}:./{path})")
        for path, parts in sorted(result.removed.items()):
            lines += [
                f"removed   {part} from {path}      (see it again: git show {commit}:./{path})"
                for part in parts
            ]
        nothing = len(lines) == len(said)
        lines += [f"missing   {path}{part and ': '}{part}" for path, part in _missing(result)]
        lines += [f"still     {use}" for use in uses(files, new, found, renaming)]
        conflicts = sorted(result.conflicts)
        lines += [f"CONFLICT  {path}" for path in conflicts]
        if nothing and not conflicts and not said:
            lines.append("Nothing has changed.")
        return Report([*lines, proof.sentence], conflicts)

    def _seen_before(self, path: str) -> str:
        """Name the commit that had a file which comes again."""
        commit = git.commit_that_had(self.package, path)
        return f"      (as it was: git show {commit}:./{path})" if commit else ""


def _missing(result: Result) -> list[tuple[str, str]]:
    return [(path, part) for path, parts in sorted(result.missing.items()) for part in parts]
