"""Faults of templates, told with the file and the line where Jinja reports them (decision 100)."""

from __future__ import annotations

import glob
import traceback
from pathlib import Path

from jinja2 import TemplateError, TemplateNotFound, TemplateSyntaxError

_CODE = Path(__file__).parents[1]
"""Where the hook and the extensions are loaded from."""


def place(error: Exception, root: Path, is_told: bool = False) -> tuple[str, bool]:
    """Return the template and the line of a fault, or a text without a file; and whether a file.

    Nothing for a fault of the hook or the extensions, which needs its traceback; unless it
    `is_told` in words for users.
    """
    frames = [(f.filename, f.lineno) for f in traceback.extract_tb(error.__traceback__)]
    if not is_told and not isinstance(error, TemplateError) and frames:
        last = Path(frames[-1][0])
        if last.suffix == ".py" and any(map(last.is_relative_to, (root, _CODE))):
            return "", False
    if isinstance(error, TemplateSyntaxError):
        frames.append((error.filename or "", error.lineno))
    for file, line in reversed(frames):
        if Path(file).is_relative_to(root) and not file.endswith(".py"):
            return f"{Path(file).relative_to(root)}:{line}", True
        if file.startswith('"'):
            return file[1:-1], False
    return "", False


def found(text: str, root: Path) -> str:
    """Name the template whose name a text is a part of, or the line of a setting."""
    for path in sorted(root.rglob(f"{glob.escape(text)}*")):
        return str(path.relative_to(root))
    for path in sorted(root.rglob("copier.y*ml")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if text in line:
                return f"{path.relative_to(root)}:{number}"
    return ""


def what(error: Exception) -> str:
    """Say in a line what a fault of a template is."""
    if isinstance(error, TemplateNotFound):
        return f'no such template "{error.name}"'
    text = " ".join(str(error).split())
    return text if isinstance(error, TemplateError) else f"{type(error).__name__}: {text}"
