"""The bridge from Copier to the hook: the context of a spec, and filters for the templates.

Copier renders a package several times in one update, each time with the template of one
version. So an instance of the extension belongs to one of these versions, and has the hook of its
own template. This module keeps nothing.
"""

from __future__ import annotations

import functools
import glob
import hashlib
import importlib
import importlib.util
import os
import sys
import tempfile
import traceback
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

import copier
from copier.errors import CopierError, UserMessageError
from jinja2 import (
    Environment,
    TemplateError,
    TemplateNotFound,
    TemplateSyntaxError,
    UndefinedError,
    pass_context,
)
from jinja2.ext import Extension
from jinja2.runtime import Context

NEWEST_COPIER = (9, 19)
"""The newest Copier that the tests run with (decision 97)."""


class SpecExtension(Extension):
    """Give `copier.yml` the functions that turn a spec into the recorded context."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.root = Path(environment.loader.searchpath[0])  # type: ignore[union-attr]
        self.hooks = _load_hooks(self.root)
        self.models: dict[Path, Any] = {}
        self.specs: dict[Path, bytes] = {}
        self.contexts: dict[tuple[Path, bytes, str], dict[str, Any]] = {}
        self.left_out: list[str] = []
        self.update: Any = None
        self.joining: Any = None
        self.theirs = ""
        self.report: Any = None
        for function in (
            self.ros_distros,
            self.check_answers,
            self.read_spec,
            self.spec_changed,
            self.spec_text,
            self.spec_schema,
            self.spec_tree,
            self.has_spec,
            self.has_file,
            self.package_name,
            self.chosen_package,
            self.notes,
            self.template_notes,
            self.begin_update,
            self.finish_update,
            self.joined,
            self.finish_join,
            self.update_report,
        ):
            environment.globals[function.__name__] = pass_context(self._reporting(function))
        environment.globals |= {
            "can_ask": _can_ask,
            "default_ros_distro": lambda: self.hooks.ros.default_distro(os.environ),
        }
        environment.handle_exception = self._say_where  # type: ignore[method-assign]
        self._register(self.hooks.model.public_functions(self.hooks.names))
        for name in ("python", "cpp", "qos", "text"):
            self._register(self.hooks.model.load_functions(self.root / f"extensions/{name}.py"))

    def ros_distros(self, context: Context) -> list[str]:
        """Return the distributions to choose from."""
        self.check_answers(context)
        return list(self.hooks.ros.DISTROS)

    def check_answers(self, context: Context) -> str:
        """Check the answers that are given or recorded; return nothing.

        For one that is no choice Copier shows a traceback, or takes the default. The first
        question with choices calls this: an update asks in the version before, too, where no
        spec is read (decision 85).
        """
        _check_copier(copier.__version__)
        data = context["_copier_conf"]["data"]
        if isinstance(data.get("spec"), str):  # Copier itself gives a mapping
            self.hooks.questions.check_options(["spec"], self.root)
        known = {"model": self._models(), "ros_distro": list(self.hooks.ros.DISTROS)}
        self.hooks.questions.check_choices(self._answers(context), self.root, known)
        return ""

    def _answers(self, context: Context) -> dict[str, Any]:
        """Return the answers that are recorded, and over them those that `-d` gives."""
        return {**self._package(context).answers(), **context["_copier_conf"]["data"]}

    def read_spec(self, context: Context, spec_file: str) -> dict[str, Any]:
        """Return the context of the package's spec, or of a skeleton where there is none."""
        given = map(str, context["_copier_conf"]["data"])
        self.hooks.questions.check_options(given, self.root)
        model, package = self._model(context), self._package(context)
        self._register(model.functions)
        xml, shown, root = self._spec(context, spec_file)
        self.specs[package.folder] = xml
        key = (package.folder, xml, str(context["ros_distro"]))
        if key not in self.contexts:  # Copier asks again when the recorded one is not valid
            values = dict(model.context(xml, shown, str(context["ros_distro"]), root))
            package.check_file_name(model.name(values))
            self._check_update(context, values, shown)
            self.contexts[key] = values
        return self.contexts[key]

    def spec_changed(self, context: Context, spec_file: str, spec: Any) -> str:
        """Say "changed" when the spec in the package no longer gives the recorded `spec`.

        Copier's own renders in temporary folders get `spec` as data: nothing is read then.
        """
        self._register(self._model(context).functions)
        if self._is_given(context) or spec == self.read_spec(context, spec_file):
            return ""
        return "changed"

    def spec_text(self, context: Context, spec_file: str) -> str:
        """Return the XML to write into a new package. It is never written again.

        It was read before the first file was written, in an order that each file system chooses.
        """
        if self._is_given(context):
            return ""
        folder = self._package(context).folder
        xml = self.specs[folder] if folder in self.specs else self._spec(context, spec_file)[0]
        return xml.decode("utf-8-sig")

    def spec_schema(self, context: Context) -> str:
        """Return the XML schema of the specs of the model, for editors."""
        return str(self._model(context).schema())

    def spec_tree(self, context: Context, spec: dict[str, Any]) -> Any:
        """Return what a spec says; see `hooks.trees`."""
        return self._model(context).tree(spec)

    def has_spec(self, context: Context) -> bool:
        """Say whether the destination holds a spec already."""
        return bool(self._package(context).specs)

    def has_file(self, context: Context, name: str) -> bool:
        """Say whether the destination holds a file or folder."""
        return bool((self._package(context).folder / name).exists())

    def package_name(self, context: Context, spec: dict[str, Any]) -> str:
        """Return the name of the package, by whatever attribute the model's specs give it."""
        return str(self._model(context).name(spec))

    def chosen_package(
        self, context: Context, question: str, answer: str, own: str, spec: dict[str, Any]
    ) -> str:
        """Return the package that an answer names; the answer `own` is the package itself."""
        name = self.package_name(context, spec)
        return str(self.hooks.questions.chosen_package(question, answer, own, name))

    def notes(self, context: Context, spec: dict[str, Any]) -> list[str]:
        """Return the notes of the spec; and, not recorded, of its making and of this machine."""
        dictionary = self._model(context).dictionary
        missing = self.hooks.installed.missing_types(spec, dictionary, os.environ)
        return [*spec["notes"], *self.left_out, *missing]

    def template_notes(self, context: Context) -> list[str]:
        """Say that an update will not find a template whose path is relative."""
        source = str(context["_copier_answers"].get("_src_path") or "")
        path = Path(source)
        if not source or path.is_absolute() or not path.is_dir():
            return []
        return [
            f"an update looks for {source} from within the package; copy from {path.absolute()}"
        ]

    def begin_update(self, context: Context) -> bool:
        """Take the snapshot that a failing update brings back. Always false: there is no task."""
        if not context["_copier_conf"]["pretend"]:
            package = self._package(context)
            self.update = self._new_update(context, package)
        return False

    def finish_update(self, context: Context, spec: dict[str, Any]) -> bool:
        """Merge, in place of what Copier has merged, and prove it. Always false, as above."""
        if self.update:
            self.report = self._finish(self.update, context, spec)
        return False

    def joined(self, _context: Context) -> str:
        """Return whose files a copy merges into the package, if it does."""
        return self.theirs

    def finish_join(self, context: Context, spec: dict[str, Any]) -> bool:
        """Join two branches, or move to another model, in place of a copy. Always false, too."""
        if self.joining:
            self.report = self._finish(self.joining, context, spec)
        return False

    def update_report(self, context: Context, spec: dict[str, Any]) -> Any:
        """Return what the update has to say: `lines`, and the files in conflict.

        Where Copier pretends, it renders nothing: a copy of the package is updated in its place.
        """
        if not context["_copier_conf"]["pretend"]:
            return self.report
        with tempfile.TemporaryDirectory() as folder:
            clone = self._package(context).clone(Path(folder))
            update = self._new_update(context, clone)
            return self._finish(update, context, spec)

    def _new_update(self, context: Context, package: Any) -> Any:
        quiet = bool(context["_copier_conf"]["quiet"])
        return self._merge("update").Update(package.folder, package.answers_file, quiet)

    def _finish(self, update: Any, context: Context, spec: dict[str, Any]) -> Any:
        return update.finish(
            {**context["_copier_answers"], "spec": spec},
            self._renderer(context),
            self._model(context).dictionary,
            self._moved_files(context, spec),
            context["_copier_conf"]["conflict"] == "inline",
            context["_copier_conf"]["data"],
        )

    def _moved_files(self, context: Context, spec: dict[str, Any]) -> Any:
        dictionary = self._model(context).dictionary
        return self._merge("moves").moved_files(spec, dictionary)

    def _renderer(self, context: Context) -> Any:
        package, answers = self._package(context), context["_copier_answers"]
        return self._merge("render").Renderer(
            Path(context["_copier_conf"]["src_path"]),
            answers.get("_src_path"),
            answers.get("_commit"),
            package.folder.name,
            package.answers_file,
        )

    def _check_update(self, context: Context, values: dict[str, Any], shown: str) -> None:
        """Refuse what could not be undone or ended, before anything is written."""
        package, conf = self._package(context), context["_copier_conf"]
        answers = package.folder / package.answers_file
        if conf["pretend"]:
            return
        if not answers.exists() and package.folder.exists():
            if not (conf["overwrite"] or _can_ask()):
                given = {**context["_copier_answers"], "spec": values}
                renderer = self._renderer(context)
                self._merge("preflight").refuse_questions(package.folder, given, renderer)
        elif answers.exists() and self._joins(package):
            self.joining, self.theirs = self._new_update(context, package), "the other branch's"
            given = {**context["_copier_answers"], "spec": values}
            self._merge("preflight").refuse_join(package.folder, given, self._renderer(context))
        elif answers.exists():
            model = self._model(context)
            self._merge("preflight").check(
                package.folder,
                model.places(self.specs[package.folder], shown),
                {**context["_copier_answers"], "spec": values},
                model.dictionary,
                self._renderer(context),
                self._moved_files(context, values),
            )
            if self._is_other_model(package, context):
                self.joining, self.theirs = self._new_update(context, package), "the model's"

    def _is_other_model(self, package: Any, context: Context) -> bool:
        """Say whether a copy is to move a package to another template (decision 110)."""
        recorded = self._merge("render").recorded_answers(package.folder, package.answers_file)
        return bool(recorded.get("_src_path") != context["_copier_answers"].get("_src_path"))

    def _joins(self, package: Any) -> bool:
        return bool(self._merge("preflight").is_joining(package.folder, package.answers_file))

    def _merge(self, name: str) -> Any:
        """Load a module of `hooks.merge`, which no render needs."""
        return importlib.import_module(f"{self.hooks.__name__}.merge.{name}")

    def _package(self, context: Context) -> Any:
        conf = context["_copier_conf"]
        return self.hooks.package.Package(Path(conf["dst_path"]), str(conf["answers_file"]))

    def _spec(self, context: Context, spec_file: str) -> tuple[bytes, str, Any]:
        """Return the XML that counts, its name for messages, and what it is made of if of YAML."""
        package, model = self._package(context), self._model(context)
        file = package.spec_file(spec_file)
        if not file:
            return model.skeleton(package.about()).encode(), "skeleton spec", None
        shown = self.hooks.package.shown(file)
        if package.specs or not model.reads_yaml(file):
            return self.hooks.package.read(file), shown, None
        root, self.left_out = model.read_yaml(file, package.about())
        return self.hooks.trees.xml(root).encode(), shown, root

    def _model(self, context: Context) -> Any:
        folder = self._folder(context)
        if folder not in self.models:
            model = self.models[folder] = self.hooks.model.Model(folder, self.root)
            self.environment.globals["known_tags"] = model.dictionary.tags
        return self.models[folder]

    def _folder(self, context: Context) -> Path:
        """Return the folder of the model: of the template itself, or the one chosen in it.

        A package of the collection may follow a published model later; its choice stays recorded.
        """
        if (self.root / "dictionary.yaml").exists():
            return self.root
        return self.root / str(context.get("model") or "")

    def _models(self) -> list[str]:
        folders = sorted(file.parent for file in self.root.glob("*/dictionary.yaml"))
        return [folder.name for folder in folders if (folder / "copier.yml").exists()]

    def _register(self, functions: dict[str, Callable[..., Any]]) -> None:
        """Make functions filters of this render, and those called `is_x` tests."""
        for name, function in functions.items():
            self.environment.filters[name] = self._reporting(function)
            if name.startswith("is_"):
                self.environment.tests[name.removeprefix("is_")] = self._reporting(function)

    def _reporting(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Make every fault of a spec or a model a message of Copier's, without traceback."""

        @functools.wraps(function)
        def call(*arguments: Any, **options: Any) -> Any:
            try:
                return function(*arguments, **options)
            except self.hooks.faults.SpecError as error:
                raise UserMessageError(str(error)) from error

        return call

    def _say_where(self, source: str | None = None) -> NoReturn:
        """Make a fault of a template a message of Copier's, with file and line (decision 100)."""
        try:
            Environment.handle_exception(self.environment, source)
        except CopierError as error:  # of a function that the template calls, or a part of it
            place, is_file = self._place(error)
            if is_file and isinstance(error, UserMessageError):
                raise UserMessageError(f"{error} (in {place})") from error
            raise
        except Exception as error:
            # Copier has an UndefinedError of its own, for answers that are unset.
            is_own = isinstance(error, UndefinedError) and type(error) is not UndefinedError
            place, is_file = self._place(error)
            if is_own or not place:
                raise
            where = place if is_file else self._found(place) or f'"{place}"'
            raise UserMessageError(f"{where}: {_what(error)}") from error

    def _place(self, error: Exception) -> tuple[str, bool]:
        """Return the template and the line of a fault, or a text without a file.

        Nothing for one of the hook or the extensions, which needs its traceback.
        """
        frames = [(f.filename, f.lineno) for f in traceback.extract_tb(error.__traceback__)]
        if not isinstance(error, TemplateError | CopierError) and frames:
            last = Path(frames[-1][0])
            if last.suffix == ".py" and last.is_relative_to(self.root):
                return "", False
        if isinstance(error, TemplateSyntaxError):
            frames.append((error.filename or "", error.lineno))
        for file, line in reversed(frames):
            if Path(file).is_relative_to(self.root) and not file.endswith(".py"):
                return f"{Path(file).relative_to(self.root)}:{line}", True
            if file.startswith('"'):
                return file[1:-1], False
        return "", False

    def _found(self, text: str) -> str:
        """Name the template whose name a text is a part of, or the line of a setting."""
        for path in sorted(self.root.rglob(f"{glob.escape(text)}*")):
            return str(path.relative_to(self.root))
        for path in sorted(self.root.rglob("copier.y*ml")):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if text in line:
                    return f"{path.relative_to(self.root)}:{number}"
        return ""

    @staticmethod
    def _is_given(context: Context) -> bool:
        return "spec" in context["_copier_conf"]["data"]


def _check_copier(version: str) -> None:
    """Refuse a Copier that may treat packages in another way, before it writes anything."""
    major, minor = (int(number) for number in version.split(".")[:2])
    if (major, minor) > NEWEST_COPIER and "UNTESTED_COPIER" not in os.environ:
        newest = ".".join(map(str, NEWEST_COPIER))
        raise UserMessageError(
            f"Copier {version} is newer than {newest}, the newest that this version of the model"
            f' is tested with; install that, as by pipx install --force "copier=={newest}.*",'
            " or set UNTESTED_COPIER=1 to try"
        )


def _what(error: Exception) -> str:
    """Say in a line what a fault of a template is."""
    if isinstance(error, TemplateNotFound):
        return f'no such template "{error.name}"'
    text = " ".join(str(error).split())
    return text if isinstance(error, TemplateError) else f"{type(error).__name__}: {text}"


def _can_ask() -> bool:
    """Say whether there is a terminal: without one, defaults count (decision 5)."""
    return bool(sys.stdin and not sys.stdin.closed and sys.stdin.isatty())


def _load_hooks(root: Path) -> ModuleType:
    """Load the template's own `hooks` beside other versions, each once: its content names it.

    Decision 3: an update runs two versions in one process.
    """
    folder = root / "hooks"
    name = f"hooks_{_digest(folder)}"
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    assert spec
    assert spec.loader
    if name not in sys.modules:
        sys.modules[name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[name])
    # A folder goes with the render that it was cloned for; modules may be loaded later.
    for package in ("", ".merge"):
        if module := sys.modules.get(name + package):
            places = {str(folder / package.strip(".")): None, **dict.fromkeys(module.__path__)}
            module.__path__ = list(filter(os.path.exists, places))
    return sys.modules[name]


def _digest(folder: Path) -> str:
    digest = hashlib.sha1()
    for file in sorted(path for path in folder.rglob("*") if path.suffix in (".py", ".yaml")):
        digest.update(f"{file.relative_to(folder)}\n".encode() + file.read_bytes())
    return digest.hexdigest()
