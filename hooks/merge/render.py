"""Render a package afresh, in a temporary folder, from answers."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import copier
import yaml

from .git import committed
from .tree import Tree, read_folder


@dataclass(frozen=True)
class Render:
    """What a version of a template makes of answers."""

    tree: Tree
    is_kept: Callable[[str], bool]
    """Says of a path whether it is the developer's: written once, never again."""


def render(
    source: str, version: str | None, answers: Mapping[str, Any], name: str, answers_file: str
) -> Render:
    """Render a package that is called `name`; keys of `answers` that begin with _ are Copier's.

    Raises:
        copier.errors.CopierError: the template or the answers have a fault.

    """
    with tempfile.TemporaryDirectory(prefix="ros_package.") as folder:
        worker = copier.run_copy(
            source,
            Path(folder) / name,
            data={key: value for key, value in answers.items() if not key.startswith("_")},
            answers_file=answers_file,
            vcs_ref=version,
            defaults=True,
            unsafe=True,
            quiet=True,
        )
        tree = read_folder(Path(folder) / name)
        tree.pop(answers_file, None)
        kept = {path for path in tree if worker.match_skip(Path(path))}
    return Render(tree, kept.__contains__)


def render_recorded(answers: Mapping[str, Any], name: str, answers_file: str) -> Render:
    """Render what some recorded answers gave, with the version of the template they name."""
    return render(
        os.path.expanduser(str(answers["_src_path"])),
        answers.get("_commit"),
        answers,
        name,
        answers_file,
    )


def recorded_answers(package: Path, answers_file: str) -> dict[str, Any]:
    """Return the answers of the last commit."""
    answers = yaml.safe_load(committed(package, answers_file))
    return answers if isinstance(answers, dict) else {}
