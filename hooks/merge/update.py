"""The order of an update: a snapshot, Copier's own work, our merge in its place, the proof."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..changes import Contexts, changed_answers, changes, left
from ..dictionary import Dictionary
from ..faults import SpecError, UnrenderedError
from . import git
from .branches import Branches, Joined, Joiner, refuse, under_way, wrong_merge
from .package import Result
from .proof import Proof, places
from .render import Renderer, begin, recorded_answers
from .report import Report, left_behind, removed, report
from .transaction import Guard, Snapshot, take
from .tree import SUBMODULE, Tree, read_paths
from .uses import uses, uses_of_left
from .versions import Versions


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
        given: Iterable[str] = (),
    ) -> Report:
        """Merge, put in place, prove.

        The first four are those of a `Joiner`. `inline`: conflicts go between marks, else to files
        that end in .rej. `given` are the names of the answers that this update was given.
        It raises SpecError where a line of the developer's would not be in its place, or there
        could be no other update; nothing has changed.
        """
        about = (answers, renderer, dictionary, moved)
        joiner = Joiner(self.package, self.answers_file, *about)
        try:
            said = self._finish(joiner, inline, given)
        except BaseException:
            self.guard.undo()
            raise
        finally:
            begin()
        self.guard.release()
        return said

    def _finish(self, joiner: Joiner, inline: bool, given: Iterable[str]) -> Report:
        """Join branches, where there are two; else merge what the new version changes."""
        file = self.package / self.answers_file  # without it, there could be no other update
        if not file.exists() or "_src_path" not in file.read_text(encoding="utf-8"):
            what = "this version of the template does not write Copier's answers"
            raise SpecError(
                f"{self.answers_file}: {what}; take another one, by --vcs-ref", "no-answers"
            )
        files = self.snapshot.files.items()
        mine = {path: file for path, file in files if path != self.answers_file}
        branches = under_way(self.package, self.answers_file)
        with contextlib.suppress(UnrenderedError, OSError):  # a version that is no longer there
            branches = branches or wrong_merge(joiner, mine)
        if branches and branches.ours:
            joiner.check(branches, given)
            return self._joined(joiner, branches, joiner.join(branches, mine), inline)
        contexts = (self.answers.get("spec") or {}, joiner.answers["spec"])
        made = joiner.versions(mine, self.answers, contexts)
        notes = []
        if branches:  # each file on what it was made of
            before = joiner.made(branches.theirs)
            theirs = {path: file for path, file in before.items() if path in branches.files}
            rest = {path: file for path, file in made.old.items() if path not in branches.files}
            made = replace(made, old={**rest, **theirs})
            notes = [_noted(branches)]
        result, _ = made.merged()
        self.snapshot.put(result, {self.answers_file}, inline)
        found = read_paths(self.package, result.tree)
        proof = made.proof(result, found)
        self._insist(made, result, found, proof)
        said = [*notes, *changed_answers(self.answers, joiner.answers)]
        said += changes(*contexts, joiner.dictionary)
        still = self._still(contexts, joiner, made, found)
        return report(self.package, self.snapshot.files, found, result, said, still, proof)

    def _still(self, contexts: Contexts, joiner: Joiner, made: Versions, found: Tree) -> list[str]:
        """Return the uses of what was renamed, or left."""
        still = [*uses(made.mine, made.old, made.new, found, made.renaming)]
        gone = left(*contexts, joiner.dictionary)
        holders = joiner.dictionary.holders
        return still + [*uses_of_left(gone, made.old, made.new, found, holders)]

    def _insist(self, made: Versions, result: Result, found: Tree, proof: Proof) -> None:
        """Look once more, at what is on the disk now."""
        refuse(
            places(made.mine, proof.lost, made.renaming),
            "the update was undone, for it would have put lines of yours where you did not"
            " write them; take these lines out and commit; update; put them in again",
            "merge-not-proved",
        )
        refuse(
            (f"{path}: {what}" for path, what in made.wrong(result, found, proof)),
            "the update was undone, for these files would not be what both sides made of them;"
            " take your changes of them out and commit; update; put them in again",
            "merge-not-proved",
        )

    def _joined(self, joiner: Joiner, branches: Branches, joined: Joined, inline: bool) -> Report:
        """Put two joined branches in place; leave it to git to end what it has begun."""

        def kept(path: str) -> str:
            """Return what `git show` wants for a file of what was joined, or is joined again."""
            merge = branches.merge[:7]
            return f"{merge}:./{path}" if merge else git.keep(self.package, joined.own[path].data)

        result, (ours, theirs) = joined.result, joined.sides
        self.snapshot.put(result, {self.answers_file}, inline)
        found = read_paths(self.package, result.tree)
        if found != result.tree and inline:
            what = "the update was undone, for not all files could be written"
            raise SpecError(what, "not-written")
        if not branches.merge:
            paths = {p for p, mode in self.snapshot.modes.items() if mode != SUBMODULE}
            paths |= {*result.tree, self.answers_file}
            git.stage(self.package, paths - {*result.conflicts})
        said = [_noted(branches)] if branches.merge else []
        said += changed_answers(self.answers, joiner.answers)
        now: Contexts = (self.answers.get("spec") or {}, joiner.answers["spec"])
        contexts = now if branches.merge else joiner.contexts(ours.commit)
        said += changes(*contexts, joiner.dictionary)
        still = {
            line
            for side in joined.sides
            for line in self._still(joiner.contexts(side.commit), joiner, side.versions, found)
        }
        for name in ("moved", "removed", "missing", "own"):
            getattr(result, name).update(getattr(ours.result, name))
        other, before = theirs.commit[:7], theirs.versions.mine
        more = [*removed(other, self.package, before, theirs.result.tree, theirs.result)]
        more += left_behind(f"{other}:./{{}}".format, theirs.proof.left)
        more += left_behind(kept, joiner.own_lines(joined))
        one, two = ours.proof, theirs.proof
        proof = Proof(one.total + two.total, one.in_place + two.in_place, one.left + two.left)
        here = replace(proof, left=one.left)
        lines = report(
            self.package, ours.versions.mine, found, result, said, sorted(still), here, more
        )
        lines.lines[-1] = proof.sentence
        return lines


def _noted(branches: Branches) -> str:
    names = ", ".join(branches.files[:3]) + (" and more" if branches.files[3:] else "")
    cure = "joined again from its two sides" if branches.ours else "made of the spec before it"
    what = "has left files that were not made of the recorded spec"
    return f"! {branches.merge[:7]} {what}: {names}: {cure}"
