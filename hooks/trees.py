"""Specs as trees: made of a context or, by a model, of YAML; made into elements and into XML.

A tree is a tag, its attributes with their values, and what is inside: trees, or a text.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from string import Template
from typing import Any, TypeAlias
from xml.sax.saxutils import escape

from .dictionary import (
    DEPEND,
    DEPEND_KIND,
    PACKAGE,
    Attribute,
    Component,
    Dictionary,
    Interface,
)
from .faults import SpecError, refused
from .literals import spelled
from .located import Located, load_located
from .package import read, shown
from .parse import Element
from .skeleton import HEAD, tag_lines

Tree: TypeAlias = "tuple[str, Mapping[str, Any], list[Tree] | str]"
Reader: TypeAlias = "Callable[[list[str], Callable[[str], Any]], tuple[Tree, list[str]]]"
"""A function of a model: of the names of files and what loads one, a tree and notes."""
READER = "spec_from_yaml"
_SUFFIXES = (".yaml", ".yml", ".json")


def tree(context: Mapping[str, Any], dictionary: Dictionary) -> Tree:
    """Return what a spec must say to give a context: no default, and no name of before.

    What components take from others is said of each, as if it stood there.
    """
    others = context["other_depends"].items()
    depends: list[tuple[dict[str, str], str]] = [({}, name) for name in context["declared"]]
    depends += [({DEPEND_KIND: kind}, name) for kind, names in others for name in names]
    inside: list[Tree] = [(DEPEND, attributes, name) for attributes, name in depends]
    own = [each for each in dictionary.components.values() if not each.is_shared]
    for component in own:
        inside += [_tree(component.tag, component, item) for item in component.of(context)]
    return PACKAGE, _given(dictionary.package, context), inside


def _tree(tag: str, kind: Component | Interface, item: Mapping[str, Any]) -> Tree:
    kinds = [each for each in kind.interfaces.values() if not each.takes]
    inside = [_tree(each.kind, each, one) for each in kinds for one in each.of(item)]
    return tag, _given(kind.attributes, item), inside


def _given(attributes: Mapping[str, Attribute], values: Mapping[str, Any]) -> dict[str, Any]:
    given = {}
    for name, attribute in attributes.items():
        other = attribute.same_as
        default = values.get(other) if other else attribute.default
        if values.get(name) is not None and (values[name] != default or not attribute.optional):
            given[name] = values[name]
    return given


def is_yaml(file: Path) -> bool:
    """Tell whether a file, or a folder of files, is no XML but YAML: by its content."""
    if file.is_dir():
        return bool(_files(file))
    text = read(file).removeprefix(b"\xef\xbb\xbf").lstrip()
    if file.suffix in _SUFFIXES:
        return not text.startswith(b"<")
    try:
        return not text.startswith(b"<") and isinstance(load_located(file, str(file)), dict)
    except SpecError:
        return False


def _files(folder: Path) -> list[Path]:
    return sorted(file for file in folder.iterdir() if file.suffix in _SUFFIXES)


def read_yaml(
    given: Path, reader: Reader, dictionary: Dictionary, sources: Mapping[str, str]
) -> tuple[Element, list[str]]:
    """Return the elements that a model reads from a file, or from each file of a folder; notes.

    What the package must have, and they do not say, is that of a skeleton.

    Raises:
        SpecError: a file is not YAML, or the model refuses it.

    """
    files = _files(given) if given.is_dir() else [given]
    try:
        (tag, attributes, inside), notes = reader([shown(file) for file in files], _load)
    except SpecError as error:
        if isinstance(error.__cause__, ValueError):
            raise refused(error.__cause__) from error
        raise
    examples = {
        name: Template(str(attribute.example)).safe_substitute(sources)
        for name, attribute in dictionary.package.items()
        if not attribute.optional
    }
    return element((tag, {**examples, **attributes}, inside), itertools.count(1)), notes


def _load(file: str) -> Any:
    content = load_located(Path(file), file)
    try:
        json.dumps(content, default=str)
    except (ValueError, RecursionError):
        what = f"{file}: an alias stands for what it is in; write it out"
        raise SpecError(what, "recursive-alias") from None
    return content


def element(tree: Tree, numbers: Iterator[int]) -> Element:
    """Return a tree as an element, which stands where its tag does."""
    tag, attributes, inside = tree
    content: dict[str, Any] = {
        f"@{name}": _text(value) for name, value in attributes.items() if value is not None
    }
    at = tag if isinstance(tag, Located) else Located(tag)
    place = (at.line or 1, next(numbers))
    if isinstance(inside, str):
        content["#text"] = [inside]
    else:
        for each in inside:
            child = element(each, numbers)
            content.setdefault(child.tag, []).append(child)
    return Element(str(tag), content, place, at.file)


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False) if isinstance(value, list) else spelled(value)


def xml(root: Element) -> str:
    """Return the XML of elements."""
    return "\n".join([*HEAD, *_lines(root, ""), ""])


def _lines(element: Element, indent: str) -> list[str]:
    inside = [line for child in element.children for line in _lines(child, f"{indent}  ")]
    end = ">" if inside or element.text else "/>"
    first = tag_lines(element.tag, element.attributes, indent, end)
    if element.text:
        first[-1] += f"{escape(element.text)}</{element.tag}>"
    return [*first, *inside, f"{indent}</{element.tag}>"] if inside else first
