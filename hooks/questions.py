"""What a model asks, as the options of `-d`: read from its copier.yml as Copier reads it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from .data import LOADER
from .faults import SpecError, allowed, first_of, quoted, shown
from .formats import package_name

_TYPES = ("bool", "float", "int", "json", "path", "str", "yaml")
"""The types of questions that Copier has."""


def check_options(given: Iterable[str], root: Path) -> None:
    """Insist that each option given is a question of the template in a folder.

    Names that begin with _ are Copier's own.

    Raises:
        SpecError: there is no such question: Copier would ignore the option (decision 14).

    """
    known = questions(root)
    options = [name for name, question in known.items() if _is_asked(question)]
    unknown = [name for name in given if name not in options and not name.startswith("_")]
    if unknown:
        raise first_of(
            [
                SpecError(
                    f"-d {shown(each)}: no such option; {allowed(each, options)}", "unknown-option"
                )
                for each in unknown
            ]
        )


def check_template(root: Path) -> None:
    """Insist that Copier can ask and render, where it would say so in a traceback alone.

    Raises:
        SpecError: the template's folder is not there, or a type or a default is not allowed.

    """
    settings = _content(root)
    folder = str(settings.get("_subdirectory") or ".")
    if "{" not in folder and not (root / folder).is_dir():
        folders = [each.name for each in sorted(root.glob("[!.]*")) if each.is_dir()]
        what = f"_subdirectory: no folder {quoted(folder)}; {allowed(folder, folders)}"
        raise SpecError(f"{_place(root, '_subdirectory')}: {what}", "no-such-file")
    for name, question in questions(root).items():
        if not isinstance(question, dict):
            continue
        type_, default = str(question.get("type", "str")), str(question.get("default") or "")
        choices, what = _choices(question), ""
        if "{" not in type_ and type_ not in _TYPES:
            what = f'unknown type "{type_}"; {allowed(type_, _TYPES)}'
        elif choices and default not in ("", *choices) and "{" not in "".join([default, *choices]):
            what = f'default: unknown choice "{default}"; {allowed(default, choices)}'
        if what:
            raise SpecError(f"{_place(root, name)}: {name}: {what}", "unknown-word")


def check_choices(
    answers: Mapping[str, Any], root: Path, known: Mapping[str, Sequence[str]]
) -> None:
    """Insist that each answer is one of the choices of its question.

    `known` has the choices of questions that make theirs when they are asked.

    Raises:
        SpecError: one is not.

    """
    for name, question in questions(root).items():
        choices = _choices(question) or known.get(name)
        if name in answers and choices and str(answers[name]) not in choices:
            answer = str(answers[name])
            what = f"{name}: unknown {quoted(answer)}; {allowed(answer, choices)}"
            raise SpecError(what, "unknown-choice")


def chosen_package(question: str, answer: str, own: str, name: str) -> str:
    """Return the package that an answer names; the answer `own` is the package `name` itself.

    Raises:
        SpecError: it is no name of a package, or that of this package.

    """
    if answer == own:
        return name
    try:
        chosen = package_name(answer)
    except SpecError as error:
        raise SpecError(f"{question}: {error.text}; or {own}", error.id) from None
    if chosen == name:
        what = f"{question}: {quoted(name)} is this package; say {own}, or name another"
        raise SpecError(what, "names-itself")
    return chosen


def _choices(question: Any) -> list[str]:
    """Return the choices that a question lists; none where they are more than words."""
    if not isinstance(question, dict) or question.get("multiselect"):
        return []
    listed = question.get("choices") or []
    found = list(listed.values()) if isinstance(listed, dict) else listed
    if not isinstance(found, list) or any(isinstance(each, list | dict) for each in found):
        return []
    return list(map(str, found))


def questions(root: Path) -> dict[str, Any]:
    """Return the questions of a template by name, in their order."""
    content = _content(root)
    return {name: question for name, question in content.items() if name[0] != "_"}


def _content(root: Path) -> dict[str, Any]:
    """Return what the copier.yml of a template says: the last of each key counts."""
    files = sorted(root.glob("copier.y*ml"))
    documents = [each for file in files for each in _documents(file, root)]
    return {key: value for document in documents for key, value in document.items()}


def _place(root: Path, key: str) -> str:
    """Return the line of a key in the copier.yml of a template, which may include others."""
    file = min(root.glob("copier.y*ml"))
    lines = file.read_text(encoding="utf-8").splitlines()
    found = [number for number, line in enumerate(lines, 1) if line.startswith(f"{key}:")]
    return f"{file.name}:{found[-1]}" if found else file.name


def _is_asked(question: Any) -> bool:
    return not isinstance(question, dict) or False not in (
        question.get("ask"),
        question.get("when"),
    )


def _documents(file: Path, root: Path) -> Iterator[dict[str, Any]]:
    """Yield the mappings of a YAML file; a document may be `!include` and other files."""

    class Loader(LOADER):  # type: ignore[misc, valid-type]
        pass

    def include(loader: yaml.SafeLoader, files: yaml.ScalarNode) -> list[dict[str, Any]]:
        return [each for found in root.glob(files.value) for each in _documents(found, root)]

    Loader.add_constructor("!include", include)
    for document in yaml.load_all(file.read_bytes(), Loader):
        yield from document if isinstance(document, list) else [document or {}]
