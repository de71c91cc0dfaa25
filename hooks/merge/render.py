"""Render a package afresh, in a temporary folder, from answers."""

from __future__ import annotations

import contextlib
import functools
import json
import os
import shutil
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from ..data import load_yaml
from ..run import Copy, Run
from .git import committed
from .tree import Tree, read_folder


@dataclass(frozen=True)
class Render:
    """What a version of a template makes of answers."""

    tree: Tree
    is_written_once: Callable[[str], bool]

    def is_kept(self, path: str) -> bool:
        """Say whether a file is the developer's: written once, never again."""
        return path in self.tree and self.is_written_once(path)


@dataclass
class _Work:
    """What an update has rendered: it asks for the same before and after Copier's own work."""

    quiet: bool = True
    known: dict[str, Render] = field(default_factory=dict)
    copies: dict[Path, tempfile.TemporaryDirectory[str]] = field(default_factory=dict)
    """Of the folders of templates."""
    old_copy: tuple[Mapping[str, Any], Tree] = field(default_factory=lambda: ({}, {}))
    """Answers, and what Copier has made of them itself."""
    taken: float = 0.0
    """Seconds."""

    @contextlib.contextmanager
    def shown(self) -> Iterator[None]:
        """Say on standard error that it renders, once all renders take longer than SILENT."""
        start = time.monotonic()
        line = f"Rendering the package for the merge ({len(self.known) + 1})"
        say = threading.Timer(max(0.0, SILENT - self.taken), print, [line], {"file": sys.stderr})
        if not self.quiet:
            say.start()
        try:
            yield
        finally:
            say.cancel()
            self.taken += time.monotonic() - start


SILENT = 2.0  # s
_work = _Work()


def begin(quiet: bool = True) -> None:
    """Forget what has been rendered, when an update begins and ends."""
    global _work
    for copy in _work.copies.values():
        copy.cleanup()
    _work = _Work(quiet)


def keep_old_copy(run: Run, name: str) -> None:
    """Keep what Copier has made of the version before, for a package whose folder has this name.

    Not if a file has the name of Copier's folder.
    """
    folder = run.package.folder
    tree = read_folder(folder)
    tree.pop(run.package.answers_file, None)
    other = str(folder) if folder.name == name else folder.name
    if tree and not any(other in path or other.encode() in tree[path].data for path in tree):
        _work.old_copy = dict(run.answers), tree


@dataclass(frozen=True)
class Renderer:
    """Renders a package with the template that Copier uses now, or with a recorded version.

    `copy` makes a package; `folder` is where Copier has put the template, `url` and `commit` are
    what its answers record of it; `name` is the folder of the package. Keys of answers that begin
    with _ are Copier's.
    """

    copy: Copy
    folder: Path
    url: str
    commit: str | None
    name: str
    answers_file: str

    def fresh(self, answers: Mapping[str, Any]) -> Render:
        """Render with the template of now; UnrenderedError if it, or the answers, have a fault."""
        version = f"{self.url} {self.commit}" if self.commit else str(self.folder)
        known, tree = _work.old_copy
        if known != answers:
            return self._once(version, answers, lambda: self._render_copy(answers))
        render = lambda: self._render_copy(answers, without="*")  # noqa: E731
        empty = functools.cache(lambda: self._once(f"{version}, no file", answers, render))
        return Render(tree, lambda path: empty().is_written_once(path))

    def _once(
        self, version: str, answers: Mapping[str, Any], render: Callable[[], Render]
    ) -> Render:
        about = [version, self.name, self.answers_file, answers]
        key = json.dumps(about, sort_keys=True, default=str)
        if key not in _work.known:
            with _work.shown():
                _work.known[key] = render()
        return _work.known[key]

    def _render_copy(self, answers: Mapping[str, Any], without: str = "") -> Render:
        if self.folder not in _work.copies:
            # Copier clones a repository, which takes longer than all the rest.
            folder = _work.copies[self.folder] = tempfile.TemporaryDirectory(prefix="template.")
            shutil.copytree(
                self.folder,
                Path(folder.name) / self.folder.name,
                symlinks=True,
                ignore=shutil.ignore_patterns(".git"),
                copy_function=_link_or_copy,
            )
        copy = Path(_work.copies[self.folder].name) / self.folder.name
        return self._render(str(copy), None, answers, without)

    def recorded(self, answers: Mapping[str, Any]) -> Render:
        """Render with the version that the answers name, which raises as above."""
        url, commit = str(answers["_src_path"]), answers.get("_commit")
        if (url, commit) == (self.url, self.commit):
            return self.fresh(answers)
        source, version = os.path.expanduser(url), f"{url} {commit}"
        return self._once(version, answers, lambda: self._render(source, commit, answers))

    def _render(
        self, source: str, version: str | None, answers: Mapping[str, Any], without: str = ""
    ) -> Render:
        with tempfile.TemporaryDirectory(prefix="ros_package.") as folder:
            target = Path(folder) / self.name
            data = {key: value for key, value in answers.items() if not key.startswith("_")}
            about = (self.answers_file, version, without or self.answers_file)
            is_kept = self.copy(source, target, data, *about)
            return Render(read_folder(target), functools.cache(lambda path: is_kept(Path(path))))


def _link_or_copy(source: str, target: str) -> None:
    with contextlib.suppress(OSError):
        os.link(source, target)
        return
    shutil.copy2(source, target)


def recorded_answers(package: Path, answers_file: str, commit: str = "HEAD") -> dict[str, Any]:
    """Return the answers that a commit has; none where they are no YAML, as in a conflict."""
    return dict(_answers(committed(package, answers_file, commit)))


@functools.lru_cache(maxsize=4)
def _answers(text: bytes) -> Mapping[str, Any]:
    try:
        answers = load_yaml(text)
    except yaml.YAMLError:
        return {}
    return answers if isinstance(answers, dict) else {}
