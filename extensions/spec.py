"""The bridge from Copier to the hook: the one file that knows Copier (decision 137).

Copier renders a package several times in one update, each time with the template of one
version. So an instance of the extension belongs to one of these renders, and this module, which
is loaded with the hook of its version, keeps nothing.
"""

from __future__ import annotations

import contextlib
import functools
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import copier
from copier.errors import CopierError, UserMessageError
from jinja2 import Environment, UndefinedError, pass_context
from jinja2.ext import Extension
from jinja2.runtime import Context

hooks: Any = import_module(f"{str(__package__).removesuffix('extensions')}hooks")

if TYPE_CHECKING:
    from hooks.faults import SpecError
    from hooks.merge.report import Report
    from hooks.model import Model
    from hooks.run import Run
    from hooks.specs import Specs
    from hooks.steps import Steps

NEWEST_COPIER = (9, 19)
"""The newest Copier that the tests run with (decision 97)."""


class SpecExtension(Extension):
    """Give `copier.yml` the functions that turn a spec into the recorded context."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.root = Path(environment.loader.searchpath[0])  # type: ignore[union-attr]
        self.steps: Steps = hooks.steps.Steps(self._copy)
        self.specs: Specs = hooks.specs.Specs(self.root, self._use, self.steps.check)
        functions: dict[str, Callable[..., Any]] = {
            "ros_distros": self.specs.distros,
            "check_answers": self.specs.check_answers,
            "read_spec": self.specs.context,
            "spec_changed": self.specs.changed,
            "spec_text": self.specs.text,
            "spec_schema": self.specs.schema,
            "spec_tree": self.specs.tree,
            "has_spec": lambda run: bool(run.package.specs),
            "has_file": lambda run, name: os.path.exists(run.package.folder / name),
            "package_name": self.specs.name,
            "chosen_package": self.specs.chosen_package,
            "notes": self.specs.notes,
            "template_notes": lambda run: hooks.specs.template_notes(run.source),
            "begin_update": self._begin,
            "finish_update": self._finish,
            "joined": lambda run: self.steps.theirs,
            "finish_join": self._finish_join,
            "update_report": self._report,
        }
        for name, function in functions.items():
            environment.globals[name] = pass_context(self._reporting(self._given_run(function)))
        environment.globals |= {
            "can_ask": _can_ask,
            "default_ros_distro": lambda: hooks.ros.default_distro(os.environ),
        }
        environment.handle_exception = self._say_where  # type: ignore[method-assign]
        loader: Any = environment.loader
        loader.get_source = self._reading(loader.get_source)
        self._register(hooks.model.public_functions(hooks.names))
        self._register({"is_lacking": hooks.ros.is_lacking})
        for name in ("python", "cpp", "qos", "text"):
            module = import_module(f"{__package__}.{name}")
            self._register(hooks.model.public_functions(module))

    # What the conditions of `hooks/copier.yml` call is always false: there is nothing to run
    # after the call itself (decision 22).

    def _begin(self, run: Run) -> bool:
        if not _is_render(run.package.folder):
            hooks.run.updating[:] = [run.package.folder]
            self.steps.begin(run)
        return False

    def _finish(self, run: Run, spec: Mapping[str, Any]) -> bool:
        self.steps.finish(run, self.specs.model(run), spec)
        return False

    def _finish_join(self, run: Run, spec: Mapping[str, Any]) -> bool:
        if _is_render(run.package.folder, "old") and not run.pretend:
            hooks.run.old_copies[:] = [run]
        self.steps.finish_join(run, self.specs.model(run), spec)
        return False

    def _report(self, run: Run, spec: Mapping[str, Any]) -> Report | None:
        return self.steps.report(run, self.specs.model(run), spec)

    def _given_run(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Call a function of the hook with what Copier tells of its run, in place of a context."""

        @functools.wraps(function)
        def call(context: Context, *arguments: Any) -> Any:
            self._check_copier(copier.__version__)
            return function(self._run(context), *arguments)

        return call

    def _run(self, context: Context) -> Run:
        conf = context["_copier_conf"]
        folder = Path(conf["dst_path"]).absolute()
        if _is_render(folder) and "spec" not in conf["data"] and hooks.run.updating:
            folder = hooks.run.updating[0]
        package = hooks.package.Package(folder, str(conf["answers_file"]))
        run: Run = hooks.run.Run(
            template=self.root,
            package=package,
            given=conf["data"],
            answers=context["_copier_answers"],
            model=str(context.get("model") or ""),
            distro=str(context.get("ros_distro") or ""),
            pretend=bool(conf.get("pretend")),
            exclude=conf.get("exclude") or (),
            overwrite=bool(conf.get("overwrite")),
            quiet=bool(conf.get("quiet")),
            inline=conf.get("conflict", "inline") == "inline",
            can_ask=_can_ask(),
        )
        return run

    def _check_copier(self, version: str) -> None:
        """Refuse a Copier that may treat packages in another way, before it writes anything."""
        major, minor = (int(number) for number in version.split(".")[:2])
        if (major, minor) > NEWEST_COPIER and "UNTESTED_COPIER" not in os.environ:
            newest = ".".join(map(str, NEWEST_COPIER))
            raise hooks.faults.SpecError(
                f"Copier {version} is newer than {newest}, the newest that this version of the"
                " model is tested with; install that, as by"
                f' pipx install --force "copier=={newest}.*", or set UNTESTED_COPIER=1 to try',
                "newer-copier",
            )

    def _copy(
        self,
        source: str,
        folder: Path,
        answers: Mapping[str, Any],
        answers_file: str,
        version: str | None,
        without: str,
    ) -> Callable[[Path], bool]:
        """Make a package; see `hooks.run.Copy`."""
        try:
            with _without_index():
                worker = copier.run_copy(
                    source,
                    folder,
                    data=dict(answers),
                    answers_file=answers_file,
                    vcs_ref=version,
                    exclude=[without],
                    defaults=True,
                    unsafe=True,
                    quiet=True,
                )
        except CopierError as error:
            fault: Any = error.__cause__  # of the hook of whatever version
            if not hasattr(fault, "id"):
                fault = hooks.faults.SpecError(str(error), "not-rendered")
            raise hooks.faults.UnrenderedError(fault.text, fault.id) from error
        return worker.match_skip

    def _use(self, model: Model) -> None:
        """Let templates use the functions of a model, and names of files its tags."""
        self._register(model.functions)
        self.environment.globals["known_tags"] = model.dictionary.tags

    def _register(self, functions: Mapping[str, Callable[..., Any]]) -> None:
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
            except hooks.faults.SpecError as error:
                raise self._message(error) from error

        return call

    def _reading(self, read: Callable[..., Any]) -> Callable[..., Any]:
        """Name the template that is no UTF-8, which Jinja and Copier do not."""

        @functools.wraps(read)
        def call(environment: Environment, name: str) -> Any:
            try:
                return read(environment, name)
            except UnicodeDecodeError as error:
                line = error.object[: error.start].count(b"\n") + 1
                what = f"{name}:{line}: not UTF-8 text; save it as UTF-8"
                fault = hooks.faults.SpecError(what, "not-utf-8")
                raise self._message(fault) from fault

        return call

    def _message(self, fault: SpecError) -> UserMessageError:
        """Say a fault without the folder of the model: Copier's clone is gone when it is read."""
        said = str(fault)
        for folder in (self.root, Path(__file__).parents[1]):
            said = said.replace(f"{folder}{os.sep}", "")
        return UserMessageError(said)

    def _say_where(self, source: str | None = None) -> NoReturn:
        """Make a fault of a template a message of Copier's, with file and line (decision 100)."""
        templates, spec_error = hooks.templates, hooks.faults.SpecError
        try:
            Environment.handle_exception(self.environment, source)
        except CopierError as error:  # of a function that the template calls, or a part of it
            place, is_file = templates.place(error, self.root, is_told=True)
            fault = error.__cause__
            if is_file and isinstance(fault, spec_error):
                fault = spec_error(f"{fault.text} (in {place})", fault.id)
                raise self._message(fault) from fault
            raise
        except Exception as error:
            # Copier has an UndefinedError of its own, for answers that are unset.
            is_own = isinstance(error, UndefinedError) and type(error) is not UndefinedError
            place, is_file = templates.place(error, self.root)
            if is_own or not place:
                raise
            where = place if is_file else templates.found(place, self.root) or f'"{place}"'
            fault = spec_error(f"{where}: {templates.what(error)}", "template-fails")
            raise self._message(fault) from fault


@contextlib.contextmanager
def _without_index() -> Iterator[None]:
    """Keep Copier from looking for the index of git, which a temporary folder does not have.

    Copier (9.19) runs git for each file that it writes, to learn whether core.fileMode is false
    (decision 123).
    """
    copier_main: Any = sys.modules.get("copier._main")
    found = getattr(copier_main, "is_git_available", None)
    if found:
        copier_main.is_git_available = lambda: False
    try:
        yield
    finally:
        if found:
            copier_main.is_git_available = found


def _is_render(folder: Path, which: str = "old|new") -> bool:
    """Say whether a folder is one of the temporary ones in which Copier renders in an update.

    Its next one asks there, too, after the first stage of migrations (copier-org/copier#2376,
    decision 139).
    """
    return any(re.match(rf"copier\._main\.({which})_copy\.", part) for part in folder.parts)


def _can_ask() -> bool:
    """Say whether there is a terminal: without one, defaults count (decision 5)."""
    return bool(sys.stdin and not sys.stdin.closed and sys.stdin.isatty())
