"""Python compiled once, and executed for each of the folders that a version is cloned to."""

from __future__ import annotations

from types import CodeType

_known: dict[str, CodeType] = {}


def compiled(text: str, file: str) -> CodeType:
    """Return the code of a text that this file has.

    Raises:
        SyntaxError: it is no Python.

    """
    if text not in _known:
        _known[text] = compile(text, file, "exec")
    return located(_known[text], file)


def located(code: CodeType, file: str) -> CodeType:
    """Return code whose faults name this file, and not the one that it was compiled from."""
    if code.co_filename == file:
        return code
    constants = (
        located(each, file) if isinstance(each, CodeType) else each for each in code.co_consts
    )
    return code.replace(co_filename=file, co_consts=tuple(constants))
