"""The steps of an update: what is refused before it, its beginning and its end.

`hooks.merge`, which a first copy does not need, is imported where it is used.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .model import Model
from .package import Package
from .run import Copy, Run, old_copies

if TYPE_CHECKING:
    from .merge.render import Renderer
    from .merge.report import Report
    from .merge.update import Update


class Steps:
    """One update, recopy or copy; `copy` makes a package by Copier."""

    def __init__(self, copy: Copy) -> None:
        self._copy = copy
        self._update: Update | None = None
        self._joining: Update | None = None
        self._report: Report | None = None
        self.theirs = ""
        """Whose files a copy merges into the package, if it does."""

    def check(
        self, run: Run, model: Model, xml: bytes, shown: str, spec: Mapping[str, Any]
    ) -> None:
        """Refuse what could not be undone or ended, before anything is written.

        Raises:
            SpecError: something is in the way; the message has the remedy.

        """
        folder, is_made = run.package.folder, run.package.is_made
        if run.pretend or not os.path.exists(folder):
            return
        from .merge import preflight

        answers, renderer = {**run.answers, "spec": spec}, self._renderer(run)
        if not is_made:
            preflight.refuse_copy(folder, answers, renderer, run.overwrite or run.can_ask)
        elif preflight.is_joining(folder, run.package.answers_file):
            self._joining, self.theirs = self._new(run, run.package), "the other branch's"
            preflight.refuse_join(folder, answers, renderer)
        else:
            places, moved = model.places(xml, shown), _moved_files(model, spec)
            preflight.check(folder, places, answers, model.dictionary, renderer, moved)
            if self._is_other_model(run):
                self._joining, self.theirs = self._new(run, run.package), "the model's"

    def begin(self, run: Run) -> None:
        """Take the snapshot that a failing update brings back."""
        if run.pretend:
            return
        from .merge.render import keep_old_copy

        self._update = self._new(run, run.package)
        for old in old_copies if not run.exclude else ():  # Copier excludes files of it, too
            keep_old_copy(old, run.package.folder.name)
        old_copies.clear()

    def finish(self, run: Run, model: Model, spec: Mapping[str, Any]) -> None:
        """Merge, in place of what Copier has merged, and prove it."""
        if self._update:
            self._report = self._finish(self._update, run, model, spec)

    def finish_join(self, run: Run, model: Model, spec: Mapping[str, Any]) -> None:
        """Join two branches, or move to another model, in place of a copy."""
        if self._joining:
            self._report = self._finish(self._joining, run, model, spec)

    def report(self, run: Run, model: Model, spec: Mapping[str, Any]) -> Report | None:
        """Return what the update has to say.

        Where Copier pretends, it renders nothing: a copy of the package is updated in its place.
        """
        if not run.pretend:
            return self._report
        with tempfile.TemporaryDirectory() as folder:
            clone = run.package.clone(Path(folder))
            return self._finish(self._new(run, clone), run, model, spec)

    def _new(self, run: Run, package: Package) -> Update:
        from .merge.update import Update

        return Update(package.folder, package.answers_file, run.quiet)

    def _finish(self, update: Update, run: Run, model: Model, spec: Mapping[str, Any]) -> Report:
        return update.finish(
            {**run.answers, "spec": spec},
            self._renderer(run),
            model.dictionary,
            _moved_files(model, spec),
            run.inline,
            run.given,
        )

    def _renderer(self, run: Run) -> Renderer:
        from .merge.render import Renderer

        commit, package = run.answers.get("_commit"), run.package
        return Renderer(
            self._copy,
            run.template,
            run.source,
            commit and str(commit),
            package.folder.name,
            package.answers_file,
        )

    def _is_other_model(self, run: Run) -> bool:
        """Say whether a copy is to move a package to another template (decision 110)."""
        from .merge.render import recorded_answers

        recorded = recorded_answers(run.package.folder, run.package.answers_file)
        return recorded.get("_src_path") != run.answers.get("_src_path")


def _moved_files(model: Model, spec: Mapping[str, Any]) -> dict[str, str]:
    from .merge.moves import moved_files

    return moved_files(spec, model)
