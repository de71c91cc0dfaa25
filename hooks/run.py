"""What the hook is told of a run: where it writes, how, and with which answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .package import Package

updating: list[Path] = []
"""The package whose update has begun, at most one (decision 139)."""
old_copies: list[Run] = []
"""What Copier has made of the version before for an update, at most one (decision 154)."""


@dataclass(frozen=True)
class Run:
    """A copy, an update, or one of the renders in temporary folders that these consist of."""

    template: Path
    """The folder of the template, as long as this run lasts."""
    package: Package
    given: Mapping[str, Any]
    """Answers that the user gives, by -d; to an inner render, all answers."""
    answers: Mapping[str, Any]
    """What is going to be recorded; keys that begin with _ tell the template and its version."""
    model: str
    distro: str
    pretend: bool
    overwrite: bool
    quiet: bool
    inline: bool
    """Conflicts go between marks; else to files that end in .rej."""
    can_ask: bool
    exclude: Sequence[str] = ()
    """What the user has Copier leave out."""

    @property
    def is_inner(self) -> bool:
        """Whether the spec is an answer already, so that no file may be read (decision 2)."""
        return "spec" in self.given

    @property
    def source(self) -> str:
        """The address of the template as it is recorded; an empty text where it has none."""
        return str(self.answers.get("_src_path") or "")


Copy = Callable[[str, Path, Mapping[str, Any], str, str | None, str], Callable[[Path], bool]]
"""Makes a package: from a source, in a folder, of answers, with an answers file, at a version, and
without the files of a pattern.

It is in a temporary folder (decision 123). It returns what says of a
path whether it is the developer's: written once, never again. It raises `UnrenderedError` where
the template or the answers have a fault.
"""
