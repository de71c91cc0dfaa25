"""Which language a file is in, and what its merge needs of a language."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePosixPath

from . import cpp_blocks, outlines, python_blocks, xml_blocks
from .blocks import Block, checked, comments, squeezed
from .lines import margin, split


@dataclass(frozen=True)
class Language:
    """How a text becomes blocks, and which of its differences are but of form."""

    blocks: Callable[[str], list[Block]]
    same: Callable[[str, str], bool]
    key: Callable[[str], str]
    """What two lines have in common that differ in form alone."""
    asides: Callable[[list[str]], list[str]] = lambda lines: ["" for _ in lines]
    """Of each line what it belongs to that a developer may do without, such as a comment."""


def _lines(text: str) -> list[Block]:
    return [Block("text", split(text))] if text else []


def _by(meaning: Callable[[str], object]) -> Callable[[str, str], bool]:
    return lambda one, other: meaning(one) == meaning(other)


def _margin_counts(line: str) -> str:
    return line[: margin(line)] + squeezed(line)


TEXT = Language(_lines, operator.eq, str.rstrip)
PYTHON = Language(
    checked(python_blocks.blocks), python_blocks.same, _margin_counts, python_blocks.asides
)
CPP = Language(checked(cpp_blocks.blocks), _by(cpp_blocks.meaning), squeezed, comments("//"))
XML = Language(checked(xml_blocks.blocks), _by(xml_blocks.meaning), squeezed)
YAML = Language(checked(outlines.yaml_blocks), outlines.same_yaml, _margin_counts, comments("#"))
CMAKE = Language(
    checked(outlines.cmake_blocks), _by(outlines.cmake_meaning), outlines.cmake_key, comments("#")
)
MARKDOWN = Language(
    checked(outlines.markdown_blocks),
    _by(outlines.markdown_meaning),
    lambda line: outlines.row(line).rstrip(),
    outlines.asides,
)
MESSAGE = Language(checked(outlines.message_blocks), operator.eq, str.rstrip)

_SUFFIXES = {
    PYTHON: ".py .cfg .pyi",
    CPP: ".cpp .hpp .h .hh .hxx .c .cc .cxx .ipp .tpp",
    XML: ".xml .launch .test .urdf .xacro .xsd .ros_package",
    YAML: ".yaml .yml",
    CMAKE: ".cmake",
    MARKDOWN: ".md",
    MESSAGE: ".msg .srv .action",
}


def language(path: str, text: str) -> Language:
    """Return the language of a file, `TEXT` where it is none of ours."""
    file = PurePosixPath(path)
    if file.name == "CMakeLists.txt":
        return CMAKE
    if file.name == "setup.cfg":
        return TEXT
    for found, suffixes in _SUFFIXES.items():
        if file.suffix in suffixes.split():
            return found
    return PYTHON if re.match(r"#!.*\bpython", text) else TEXT
