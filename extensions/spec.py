"""The bridge from Copier to the hook: which spec a package has, and its context.

Copier renders a package several times in one update, each time with the template of one
version. So this file keeps no state, and loads the hook of its own template each time.
"""

from __future__ import annotations

import functools
import getpass
import importlib
import importlib.util
import os
import re
import subprocess
import sys
import uuid
from collections.abc import Callable, Mapping
from datetime import date
from pathlib import Path
from types import ModuleType
from typing import Any

import yaml
from copier.errors import UserMessageError
from jinja2 import Environment, pass_context
from jinja2.ext import Extension
from jinja2.runtime import Context

SUFFIX = ".ros_package"


class SpecExtension(Extension):
    """Give `copier.yml` the functions that turn a spec into the recorded context."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.root = Path(environment.loader.searchpath[0])  # type: ignore[union-attr]
        self.hooks = _load_hooks(self.root)
        environment.globals |= {
            "read_spec": pass_context(self._reporting(self.read_spec)),
            "spec_changed": pass_context(self._reporting(self.spec_changed)),
            "spec_text": pass_context(self._reporting(self.spec_text)),
            "has_spec": pass_context(self._reporting(self.has_spec)),
            "package_name": pass_context(self._reporting(self.package_name)),
            "spec_renames": pass_context(self._reporting(self.spec_renames)),
            "update_summary": pass_context(self._reporting(self.update_summary)),
            "can_ask": sys.stdin.isatty,
            "ros_distros": list(self.hooks.ros.DISTROS),
            "default_ros_distro": self.default_ros_distro,
        }

    def read_spec(self, context: Context, spec_file: str) -> dict[str, Any]:
        """Return the context of the package's spec, or of a starter where there is none."""
        model = self._model(context)
        xml, shown, own = self._source(context, spec_file)
        values = dict(model.context(xml, shown, str(context["ros_distro"])))
        if own:
            self._check_file_name(own, model.name(values))
        return values

    def spec_changed(self, context: Context, spec_file: str, spec: Any) -> str:
        """Say "changed" when the spec in the package no longer gives the recorded `spec`.

        Copier's own renders in temporary folders get `spec` as data: nothing is read then.
        """
        if self._is_given(context):
            self._model(context)  # for its filters
            return ""
        return "" if spec == self.read_spec(context, spec_file) else "changed"

    def spec_text(self, context: Context, spec_file: str) -> str:
        """Return the XML to write into a new package. It is never written again."""
        if self._is_given(context):
            return ""
        xml, *_ = self._source(context, spec_file)
        return xml.decode("utf-8-sig")

    def has_spec(self, context: Context) -> bool:
        """Say whether the destination holds a spec already."""
        return bool(_specs(_destination(context)))

    def package_name(self, context: Context, spec: dict[str, Any]) -> str:
        """Return the name of the package, by whatever attribute the model's specs give it."""
        return str(self._model(context).name(spec))

    def spec_renames(self, context: Context, spec: dict[str, Any]) -> list[dict[str, str]]:
        """Return what was renamed since the package's last commit; see `hooks.changes`."""
        dictionary = self._model(context).dictionary
        return list(self.hooks.changes.renames(_committed_spec(context), spec, dictionary))

    def update_summary(self, context: Context, spec: dict[str, Any]) -> dict[str, Any]:
        """Return what an update did: `changes` in words, and `files` by what became of them."""
        dictionary = self._model(context).dictionary
        changes = self.hooks.changes.changes(_committed_spec(context), spec, dictionary)
        return {"changes": list(changes), **_changed_files(_destination(context))}

    def default_ros_distro(self) -> str:
        """Return the distribution of the environment where it is one of ours."""
        distro = os.environ.get("ROS_DISTRO", "")
        ros = self.hooks.ros
        return distro if distro in ros.DISTROS else str(ros.DEFAULT_DISTRO)

    def _source(self, context: Context, spec_file: str) -> tuple[bytes, str, Path | None]:
        """Return the XML that counts, its name for messages, and the package's own file."""
        package = _destination(context)
        found = _specs(package)
        if len(found) > 1:
            names = ", ".join(path.name for path in found)
            self._fail(f"{_shown(package)}: one spec is allowed, found {names}")
        if spec_file:
            file = Path(spec_file).expanduser()
            if not file.is_file():
                self._fail(f"{spec_file}: no such file; spec_file must name the XML of a package")
            if found and file.read_bytes() != found[0].read_bytes():
                self._fail(
                    f"{_shown(found[0])} is the spec of this package; change that file,"
                    f" or copy {spec_file} over it, and leave spec_file out"
                )
        elif found:
            file = found[0]
        elif (package / context["_copier_conf"]["answers_file"]).exists():
            self._fail(
                f"{_shown(package)}: the package has lost its spec (*{SUFFIX});"
                f" bring it back, for instance with git checkout HEAD -- '*{SUFFIX}'"
            )
        else:
            starter = self._model(context).starter(_sources(package, self.hooks))
            return starter.encode(), "starter spec", None
        xml = file.read_bytes()
        try:
            xml.decode("utf-8-sig")
        except UnicodeDecodeError:
            self._fail(f"{_shown(file)}:1: not UTF-8 text; save the spec as UTF-8")
        return xml, _shown(file), found[0] if found else None

    def _check_file_name(self, file: Path, name: str) -> None:
        """Insist on `<package>.ros_package`: templates could not find it by another name."""
        if file.stem != name:
            self._fail(
                f'{_shown(file)}: the package is called "{name}", so its spec is'
                f" {name}{SUFFIX}; rename the file"
            )

    def _model(self, context: Context) -> Any:
        """Load the model in use, and make its functions filters of this render."""
        folder = self.root / str(context.get("model") or "")
        model = self.hooks.model.Model(folder, self.root)
        for name, function in model.functions.items():
            self.environment.filters[name] = self._reporting(function)
        return model

    def _reporting(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Make every fault of a spec or a model a message of Copier's, without traceback."""

        @functools.wraps(function)
        def call(*arguments: Any, **options: Any) -> Any:
            try:
                return function(*arguments, **options)
            except self.hooks.faults.SpecError as error:
                raise UserMessageError(str(error)) from error

        return call

    def _fail(self, message: str) -> None:
        raise self.hooks.faults.SpecError(message)

    @staticmethod
    def _is_given(context: Context) -> bool:
        return "spec" in context["_copier_conf"]["data"]


def _load_hooks(root: Path) -> ModuleType:
    """Load the template's own `hooks` under a name of its own, beside other versions."""
    name = f"hooks_{uuid.uuid4().hex}"
    spec = importlib.util.spec_from_file_location(
        name, root / "hooks" / "__init__.py", submodule_search_locations=[str(root / "hooks")]
    )
    assert spec
    assert spec.loader
    package = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(package)
    for module in ("changes", "faults", "formats", "model", "ros"):
        importlib.import_module(f"{name}.{module}")
    return package


def _destination(context: Context) -> Path:
    return Path(context["_copier_conf"]["dst_path"]).absolute()


def _specs(package: Path) -> list[Path]:
    return sorted(package.glob(f"*{SUFFIX}"))


def _git(folder: Path, *arguments: str) -> str:
    command = ["git", *arguments]
    result = subprocess.run(command, cwd=folder, capture_output=True, check=False)
    return result.stdout.decode(errors="replace")


def _committed_spec(context: Context) -> dict[str, Any]:
    """Return the context recorded in the package's last commit."""
    name = context["_copier_conf"]["answers_file"]
    answers = yaml.safe_load(_git(_destination(context), "show", f"HEAD:./{name}"))
    return dict((answers or {}).get("spec") or {})


def _changed_files(package: Path) -> dict[str, Any]:
    """Return the files that differ from the last commit: merged, added, removed, in conflict."""
    files: dict[str, list[str]] = {"merged": [], "added": [], "removed": [], "conflicts": []}
    top = Path(_git(package, "rev-parse", "--show-toplevel").strip() or package)
    status = _git(package, "status", "--porcelain", "--no-renames", "-z", "-uall", ".")
    for entry in filter(None, status.split("\0")):
        state, path = entry[:2], top / entry[3:]
        name = os.path.relpath(path, package)
        if "D" in state and not path.exists():
            files["removed"].append(name)
        elif "U" in state or (path.is_file() and b"<<<<<<< before updating" in path.read_bytes()):
            files["conflicts"].append(name)
        else:
            files["added" if state == "??" else "merged"].append(name)
    return {**files, "commit": _git(package, "rev-parse", "--short", "HEAD").strip()}


def _shown(path: Path) -> str:
    """Name a file as the user would, seen from the working directory."""
    shown = os.path.relpath(path)
    return str(path) if shown.startswith("..") else shown


def _sources(package: Path, hooks: ModuleType) -> Mapping[str, str]:
    """Say what a new package is called and whose it is: its folder, git's configuration."""
    name = re.sub(r"[^a-z0-9]+", "_", package.name.lower()).strip("_")
    name = name if re.match(r"[a-z]", name) else f"pkg_{name}".rstrip("_")
    try:
        hooks.formats.package_name(name)
    except ValueError:
        name += "_pkg"
    login = getpass.getuser()
    email = _git_config("user.email")
    try:
        hooks.formats.email(email)
    except ValueError:
        email = f"{re.sub(r'[^a-z0-9]', '', login.lower()) or 'user'}@todo.todo"
    return {
        "folder": name,
        "user": _git_config("user.name") or login,
        "email": email,
        "year": str(date.today().year),
    }


def _git_config(key: str) -> str:
    return _git(Path.cwd(), "config", "--get", key).strip()
