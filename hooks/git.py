"""Run git, whatever the user's configuration says."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping
from pathlib import Path

_NEUTRAL = (
    "core.quotePath=false",
    "core.fsmonitor=false",
    f"core.hooksPath={os.devnull}",
    "log.showSignature=false",
)


def git(
    folder: Path,
    *arguments: str,
    given: bytes = b"",
    check: bool = True,
    environment: Mapping[str, str] | None = None,
) -> str:
    """Run git in a folder and return what it says; an empty text where it fails unchecked.

    Raises:
        RuntimeError: git failed.
        OSError: there is no git, or no such folder.

    """
    settings = [word for setting in _NEUTRAL for word in ("-c", setting)]
    command = ["git", *settings, *arguments]
    variables = {**os.environ, **(environment or {})}
    try:
        result = subprocess.run(
            command, cwd=folder, capture_output=True, input=given, check=False, env=variables
        )
    except OSError:
        if check:
            raise
        return ""
    if result.returncode and check:
        said = result.stderr.decode(errors="replace").strip()
        raise RuntimeError(f"git {' '.join(arguments)}: {said}")
    return os.fsdecode(result.stdout) if not result.returncode else ""
