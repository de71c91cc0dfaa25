"""What a model asks, as the options of `-d`: read from its copier.yml as Copier reads it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from .data import LOADER
from .faults import SpecError, allowed, first_of, quoted, shown
from .formats import package_name


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


def check_choices(
    answers: Mapping[str, Any], root: Path, known: Mapping[str, Sequence[str]]
) -> None:
    """Insist that each answer is one of the choices of its question.

    `known` has the choices of questions that make theirs when they are asked.

    Raises:
        SpecError: one is not.

    """
    for name, question in questions(root).items():
        choices = known.get(name) or _choices(question)
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
    documents = [
        each for file in sorted(root.glob("copier.y*ml")) for each in _documents(file, root)
    ]
    return {
        name: question
        for document in documents
        for name, question in document.items()
        if not name.startswith("_")
    }


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
