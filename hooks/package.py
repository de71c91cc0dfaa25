"""What the folder of a package and its git repository say: the spec, and what an update did."""

from __future__ import annotations

import getpass
import os
import re
import subprocess
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

import yaml

from . import formats
from .faults import SpecError

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
        return sorted(self.folder.glob(f"*{SUFFIX}"))

    def spec_file(self, given: str) -> Path | None:
        """Return the file of the spec that counts; None for a new package without one.

        `given` is the file that the user names, which a package with a spec does not need.

        Raises:
            SpecError: there is more than one, or none where there was one.

        """
        found = self.specs
        if len(found) > 1:
            names = ", ".join(path.name for path in found)
            raise SpecError(f"{shown(self.folder)}: one spec is allowed, found {names}")
        if given:
            file = Path(given).expanduser()
            if not file.is_file():
                raise SpecError(f"{given}: no such file; spec_file must name the XML of a package")
            if found and file.read_bytes() != found[0].read_bytes():
                raise SpecError(
                    f"{shown(found[0])} is the spec of this package; change that file,"
                    f" or copy {given} over it, and leave spec_file out"
                )
            return file
        if not found and (self.folder / self.answers_file).exists():
            raise SpecError(
                f"{shown(self.folder)}: the package has lost its spec (*{SUFFIX});"
                f" bring it back, for instance with git checkout HEAD -- '*{SUFFIX}'"
            )
        return found[0] if found else None

    def check_file_name(self, name: str) -> None:
        """Insist on `<package>.ros_package`: templates could not find it by another name."""
        for file in self.specs:
            if file.stem != name:
                raise SpecError(
                    f'{shown(file)}: the package is called "{name}", so its spec is'
                    f" {name}{SUFFIX}; rename the file"
                )

    def committed_spec(self) -> dict[str, Any]:
        """Return the context recorded in the last commit."""
        answers = yaml.safe_load(_git(self.folder, "show", f"HEAD:./{self.answers_file}"))
        return dict((answers or {}).get("spec") or {})

    def changed_files(self) -> dict[str, Any]:
        """Return the files that differ from the last commit, and that `commit`.

        The files are `merged`, `added`, `removed`, or with `conflicts`.
        """
        files: dict[str, list[str]] = {"merged": [], "added": [], "removed": [], "conflicts": []}
        top = Path(_git(self.folder, "rev-parse", "--show-toplevel").strip() or self.folder)
        status = _git(self.folder, "status", "--porcelain", "--no-renames", "-z", "-uall", ".")
        for entry in filter(None, status.split("\0")):
            state, path = entry[:2], top / entry[3:]
            name = os.path.relpath(path, self.folder)
            marks = b"<<<<<<< before updating"
            if "D" in state and not path.exists():
                files["removed"].append(name)
            elif "U" in state or (path.is_file() and marks in path.read_bytes()):
                files["conflicts"].append(name)
            else:
                files["added" if state == "??" else "merged"].append(name)
        return {**files, "commit": _git(self.folder, "rev-parse", "--short", "HEAD").strip()}

    def about(self) -> dict[str, str]:
        """Say what a new package is called and whose it is: its folder, git's configuration."""
        name = re.sub(r"[^a-z0-9]+", "_", self.folder.name.lower()).strip("_")
        name = name if re.match(r"[a-z]", name) else f"pkg_{name}".rstrip("_")
        login = getpass.getuser()
        someone = f"{re.sub(r'[^a-z0-9]', '', login.lower()) or 'user'}@todo.todo"
        return {
            "folder": _valid(formats.package_name, name, f"{name}_pkg"),
            "user": _setting("user.name") or login,
            "email": _valid(formats.email, _setting("user.email"), someone),
            "year": str(date.today().year),
        }


def shown(path: Path) -> str:
    """Name a file as the user would, seen from the working directory."""
    relative = os.path.relpath(path)
    return str(path) if relative.startswith("..") else relative


def _valid(parse: Callable[[str], str], text: str, other: str) -> str:
    try:
        return parse(text)
    except ValueError:
        return other


def _setting(key: str) -> str:
    return _git(Path.cwd(), "config", "--get", key).strip()


def _git(folder: Path, *arguments: str) -> str:
    command = ["git", *arguments]
    result = subprocess.run(command, cwd=folder, capture_output=True, check=False)
    return result.stdout.decode(errors="replace")
