"""The specs and models of a render, each read once."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from . import installed, package, questions, trees
from .faults import SpecError, with_id
from .model import Model
from .parse import Element
from .ros import DISTROS
from .run import Run


class Specs:
    """What a template makes of the spec of a run, and of its other answers.

    `use` is called with each model, before it reads a spec: templates may use its functions.
    `check` is called with a run, its model, the XML of the spec, the name of that in messages, and
    the new context, before anything is written.
    """

    def __init__(
        self,
        root: Path,
        use: Callable[[Model], None],
        check: Callable[[Run, Model, bytes, str, Mapping[str, Any]], None],
    ) -> None:
        self.root, self._use, self._check = root, use, check
        self._models: dict[Path, Model] = {}
        self._read: dict[Path, bytes] = {}
        self._contexts: dict[tuple[Path, bytes, str], dict[str, Any]] = {}
        self._left_out: list[str] = []
        self._tree: tuple[Mapping[str, Any] | None, trees.Tree] = (None, ("", {}, []))

    def distros(self, run: Run) -> list[str]:
        """Return the distributions to choose from."""
        return list(DISTROS)

    def check_answers(self, run: Run) -> str:
        """Check the answers that are given or recorded; return nothing.

        For one that is no choice Copier shows a traceback, or takes the default. The first
        questions call this: an update asks in the version before, too, where no spec is read
        (decision 85).
        """
        questions.check_template(self.root)
        if isinstance(run.given.get("spec"), str):  # Copier itself gives a mapping
            questions.check_options(["spec"], self.root)
        known = {"model": self._choices(), "ros_distro": list(DISTROS)}
        answers = {**run.package.answers(), **run.given}
        model = str(answers.get("model", ""))
        is_other = model not in ("", *known["model"])
        if is_other and (self.root / model / "copier.yml").is_file():
            how = f"copy it from its own address; {model}/README.md has the command"
            raise SpecError(f"model: {model} is a template by itself; {how}", "unknown-choice")
        questions.check_choices(answers, self.root, known)
        return ""

    def context(self, run: Run, spec_file: str) -> dict[str, Any]:
        """Return the context of the package's spec, or of a skeleton where there is none."""
        questions.check_options(map(str, run.given), self.root)
        model = self.model(run)
        xml, shown, root = self._xml(run, spec_file)
        self._read[run.package.folder] = xml
        key = (run.package.folder, xml, run.distro)
        if key not in self._contexts:  # Copier asks again when the recorded one is not valid
            values = dict(model.context(xml, shown, run.distro, root))
            run.package.check_file_name(model.name(values))
            self._check(run, model, xml, shown, values)
            self._contexts[key] = values
        return self._contexts[key]

    def changed(self, run: Run, spec_file: str, spec: Any) -> str:
        """Say "changed" when the spec in the package no longer gives the recorded `spec`."""
        self.model(run)
        return "" if run.is_inner or spec == self.context(run, spec_file) else "changed"

    def text(self, run: Run, spec_file: str) -> str:
        """Return the XML to write into a new package. It is never written again.

        It was read before the first file was written, in an order that each file system chooses.
        """
        if run.is_inner:
            return ""
        xml = self._read.get(run.package.folder) or self._xml(run, spec_file)[0]
        return xml.decode("utf-8-sig")

    def schema(self, run: Run) -> str:
        """Return the XML schema of the specs of the model, for editors."""
        return self.model(run).schema()

    def tree(self, run: Run, spec: Mapping[str, Any]) -> trees.Tree:
        """Return what a spec says; see `hooks.trees`. Each node's file may ask for it."""
        if self._tree[0] is not spec:
            self._tree = spec, self.model(run).tree(spec)
        return self._tree[1]

    def name(self, run: Run, spec: Mapping[str, Any]) -> str:
        """Return the name of the package, by whatever attribute the model's specs give it."""
        return self.model(run).name(spec)

    def chosen_package(
        self, run: Run, question: str, answer: str, own: str, spec: Mapping[str, Any]
    ) -> str:
        """Return the package that an answer names; the answer `own` is the package itself."""
        return questions.chosen_package(question, answer, own, self.name(run, spec))

    def notes(self, run: Run, spec: Mapping[str, Any]) -> list[str]:
        """Return the notes of the spec; and, not recorded, of its making and of this machine."""
        missing = installed.missing_types(spec, self.model(run).dictionary, os.environ)
        return [*spec["notes"], *self._left_out, *missing]

    def model(self, run: Run) -> Model:
        """Return the model: the template itself, or the one chosen in it.

        A package of the collection may follow a published model later; its choice stays recorded.
        """
        is_model = (self.root / "dictionary.yaml").exists()
        folder = self.root if is_model else self.root / run.model
        if folder not in self._models:
            self._models[folder] = Model(folder, self.root)
            self._use(self._models[folder])
        return self._models[folder]

    def _choices(self) -> list[str]:
        folders = sorted(file.parent for file in self.root.glob("*/dictionary.yaml"))
        return [folder.name for folder in folders if (folder / "copier.yml").exists()]

    def _xml(self, run: Run, spec_file: str) -> tuple[bytes, str, Element | None]:
        """Return the XML that counts, its name for messages, and what it is made of if of YAML."""
        model, file = self.model(run), run.package.spec_file(spec_file)
        if not file:
            return model.skeleton(run.package.about()).encode(), "skeleton spec", None
        shown = package.shown(file)
        if run.package.specs or not model.reads_yaml(file):
            return package.read(file), shown, None
        root, self._left_out = model.read_yaml(file, run.package.about())
        return trees.xml(root).encode(), shown, root


def template_notes(source: str) -> list[str]:
    """Say that an update will not find a template whose path is relative."""
    path = Path(source)
    if not source or path.is_absolute() or not path.is_dir():
        return []
    note = f"an update looks for {source} from within the package; copy from {path.absolute()}"
    return [with_id(note, "relative-template")]
