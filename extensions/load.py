"""The door by which Copier comes in: it executes this file for each render, in another folder.

All other Python of the template is loaded from a copy that lasts: once in an update that renders
one version several times, and with the byte code that Python keeps beside it (decision 4).
"""

from __future__ import annotations

import atexit
import contextlib
import hashlib
import os
import py_compile
import shutil
import sys
import tempfile
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from types import ModuleType

from jinja2 import Environment, FileSystemBytecodeCache
from jinja2.ext import Extension

_FOLDERS = ("hooks", "extensions")


class AllExtensions(Extension):
    """All extensions of the template, as one."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        package = _load(Path(__file__).parents[1])
        self._all: list[Extension] = [
            getattr(import_module(f"{package}.extensions.{name}"), f"{name.title()}Extension")(
                environment
            )
            for name in ("compiled", "spec", "paths", "layout")
        ]

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:
        """Let each extension rewrite a template before it is compiled."""
        for extension in self._all:
            source = extension.preprocess(source, name, filename)
        return source


def _load(root: Path) -> str:
    """Return the name of the package that has the Python of a template; its content names it.

    Decision 3: an update runs two versions in one process.
    """
    files = {
        file.relative_to(root).as_posix(): file.read_bytes()
        for folder in _FOLDERS
        for file in sorted((root / folder).rglob("*"))
        if file.suffix in (".py", ".yaml")
    }
    digest = hashlib.sha1()
    for name, content in files.items():
        digest.update(f"{name} {len(content)}\n".encode() + content)
    package = f"template_{digest.hexdigest()}"
    if package not in sys.modules:
        sys.modules[package] = ModuleType(package)
        sys.modules[package].__path__ = [str(_copied(files, _place() / package))]
    return package


def _place() -> Path:
    """Return Jinja's folder for byte code, which is private; or one that goes with the process."""
    with contextlib.suppress(OSError, RuntimeError):
        return Path(FileSystemBytecodeCache().directory)
    folder = tempfile.mkdtemp(prefix="template.")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)


def _copied(files: Mapping[str, bytes], folder: Path) -> Path:
    """Write the files that are not in the folder, each whole or not at all; return the folder."""
    for name, content in files.items():
        file = folder / name
        if not file.exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            handle, written = tempfile.mkstemp(dir=file.parent)
            with os.fdopen(handle, "wb") as stream:
                stream.write(content)
            os.replace(written, file)
            if file.suffix == ".py":  # PYTHONDONTWRITEBYTECODE is for folders of the user's
                py_compile.compile(str(file))
    return folder
