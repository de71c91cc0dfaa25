"""What the folder of a package says: its spec, its name, whose it is."""

from __future__ import annotations

import codecs
import getpass
import os
import re
import shlex
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

from . import faults, formats
from .data import load_yaml
from .faults import SpecError
from .git import git

SUFFIX = ".ros_package"


class Package:
    """A package in a folder, which may be empty yet."""

    def __init__(self, folder: Path, answers_file: str) -> None:
        """Name the folder, and the file in it where Copier keeps the answers."""
        self.folder = folder.absolute()
        self.answers_file = answers_file

    @property
    def specs(self) -> list[Path]:
        """The specs in the folder; a package has one, a new one none."""
        for place in (*reversed(self.folder.parents), self.folder):
            if os.path.lexists(place) and not place.is_dir():
                what = f"{shown(place)}: not a folder; choose another for the package"
                raise SpecError(what, "not-a-folder")
        try:
            return sorted(self.folder.glob(f"*{SUFFIX}"))
        except OSError as error:
            raise SpecError(f"{shown(self.folder)}: {error.strerror}", "cannot-be-read") from None

    @property
    def is_made(self) -> bool:
        """Whether the folder holds a package already."""
        return os.path.exists(self.folder / self.answers_file)  # where no file can be, too

    def spec_file(self, given: str) -> Path | None:
        """Return the file of the spec that counts; None for a new package without one.

        `given` is the file that the user names, which a package with a spec does not need.

        Raises:
            SpecError: there is more than one, none where there was one, or another one is given.

        """
        found = self.specs
        if len(found) > 1:
            names = ", ".join(path.name for path in found)
            what = f"{shown(self.folder)}: one spec is allowed, found {names}"
            raise SpecError(what, "several-specs")
        if given and found:
            other = b"" if Path(given).is_dir() else _text(read(given))
            if other != _text(read(found[0])):
                copy = f" or copy {given} over it," if other.lstrip().startswith(b"<") else ""
                raise SpecError(
                    f"{shown(found[0])} is the spec of this package; change that file,"
                    f"{copy} and leave spec_file out",
                    "other-spec",
                )
        if re.match(r"\w+://", given):
            what = f"{given}: an address is not read; download the file, and name that"
            raise SpecError(what, "no-such-file")
        if given:
            return Path(given)
        if not found and self.is_made:
            lost = f"the package has lost its spec (*{SUFFIX}); {self._remedy()}"
            raise SpecError(f"{shown(self.folder)}: {lost}", "lost-spec")
        return found[0] if found else None

    def answers(self) -> dict[str, Any]:
        """Return the answers that Copier has recorded; none for a new package."""
        file = self.folder / self.answers_file
        found = load_yaml(file.read_bytes()) if os.path.isfile(file) else None
        return found if isinstance(found, dict) else {}

    def _remedy(self) -> str:
        """Say which command brings a lost spec back from git, where it is there."""
        log = ("log", "-1", "--diff-filter=AMR", "--format=%h")
        commit = git(self.folder, *log, "--", f":(glob)*{SUFFIX}", check=False).strip()
        if not commit:
            return "git does not have it either; write it again"
        folder = shlex.quote(shown(self.folder))
        return f"git -C {folder} checkout {commit} -- ':(glob)*{SUFFIX}' brings it back"

    def check_file_name(self, name: str) -> None:
        """Insist on `<package>.ros_package`: templates find it by that name alone (decision 6)."""
        for file in self.specs:
            if file.stem != name:
                raise SpecError(
                    f'{shown(file)}: the package is called "{name}", so its spec is'
                    f" {name}{SUFFIX}; rename the file",
                    "wrong-spec-name",
                )

    def clone(self, folder: Path) -> Package:
        """Clone the package's repository into an empty folder; return the package there."""
        top = Path(git(self.folder, "rev-parse", "--show-toplevel").rstrip("\n"))
        git(top, "clone", "--quiet", "--shared", str(top), str(folder))
        return Package(folder / self.folder.resolve().relative_to(top), self.answers_file)

    def about(self) -> dict[str, str]:
        """Say what a new package is called and whose it is: its folder, git's configuration.

        It goes into the text of a first spec, never into the context (decision 2).
        """
        name = re.sub(r"[^a-z0-9]+", "_", self.folder.name.lower()).strip("_")
        name = name if re.match(r"[a-z]", name) else f"pkg_{name}".rstrip("_")
        name = name[: formats.LONGEST_NAME]
        login = _login()
        someone = f"{re.sub(r'[^a-z0-9]', '', login.lower()) or 'user'}@todo.todo"
        return {
            "folder": _valid(formats.FORMATS["package_name"], name, f"{name}_pkg"),
            "user": _setting("user.name") or login,
            "email": _valid(formats.email, _setting("user.email"), someone),
            "year": str(date.today().year),
        }


def read(file: Path | str) -> bytes:
    """Return the content of a spec.

    Raises:
        SpecError: there is no such file, or it is no file that can be read.

    """
    name = faults.shown(str(file))
    try:
        path = Path(file).expanduser()
        if not path.exists():
            what = f"{name}: no such file; spec_file must name the XML of a package"
            raise SpecError(what, "no-such-file")
        if not path.is_file():
            inside = [f"did you mean {name}/{each.name}?" for each in path.glob(f"*{SUFFIX}")]
            hint = inside[0] if inside else "spec_file must name the XML of a package"
            what = f"{name}: not a file; {hint}"
            raise SpecError(what, "no-such-file")
        return path.read_bytes()
    except (OSError, RuntimeError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise SpecError(f"{name}: cannot be read: {reason}", "cannot-be-read") from None


def _text(xml: bytes) -> bytes:
    return xml.removeprefix(codecs.BOM_UTF8).replace(b"\r\n", b"\n")


def shown(path: Path) -> str:
    """Name a file as the user would, seen from the working directory."""
    here = Path.cwd()
    return str(path.relative_to(here) if path.is_relative_to(here) else path)


def _login() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):  # a user without a name, as in some containers
        return "user"


def _valid(parse: Callable[[str], str], text: str, other: str) -> str:
    try:
        return parse(text)
    except SpecError:
        return other


def _setting(key: str) -> str:
    value = git(Path.cwd(), "config", "--get", key, check=False).strip()
    return os.fsencode(value).decode(errors="replace")
