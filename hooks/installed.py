"""Notes on types that their packages lack. None of it is recorded.

The packages are those installed on this machine; where one is not, those that come with ROS are
known by `types.yaml`.
"""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from .advice import elements
from .dictionary import Dictionary
from .faults import with_id
from .formats import TYPES, split_type
from .in_code import TYPES_OF_ROS, with_capital

_PATHS = {
    1: {"CMAKE_PREFIX_PATH": "share", "ROS_PACKAGE_PATH": ""},
    2: {"AMENT_PREFIX_PATH": "share"},
}
"""The variables that name where packages are installed, and the folder of packages in each."""
_SUFFIXES = {
    "srv": "(Request|Response)$",
    "action": "(Action)?(Goal|Result|Feedback)$|Action$",
}
"""What names of classes have after that of the type."""


def missing_types(
    context: Mapping[str, Any], dictionary: Dictionary, environment: Mapping[str, str]
) -> list[str]:
    """Return a note for each type that its package does not have.

    Of a package that is not installed, for one that looks like a slip.
    """
    folders = [
        Path(prefix, inside)
        for variable, inside in _PATHS[context["ros"]].items()
        for prefix in environment.get(variable, "").split(os.pathsep)
        if prefix
    ]
    notes = []
    for package, folder, name in sorted(set(_types(context, dictionary))):
        installed = [place / package for place in folders if (place / package).is_dir()]
        known = {known for place in installed for known in _names(place, folder)}
        if known and name not in known:
            near = difflib.get_close_matches(name, known, 1)
            meant = f"; is {near[0]} meant?" if near else ""
            note = f"{package} in {installed[0].parent} has no {folder}/{name}{meant}"
            notes.append(with_id(note, "unknown-type"))
        elif not installed:
            notes += [with_id(note, "unknown-type") for note in _slips(package, folder, name)]
    return notes


def _slips(package: str, folder: str, name: str) -> Iterator[str]:
    """Ask about a type, or a package, that is nearly one of ROS's own."""
    if package not in TYPES_OF_ROS and f"{package}s" in TYPES_OF_ROS:
        yield f"no package {package} comes with ROS; is {package}s meant?"
    known = TYPES_OF_ROS.get(package, {}).get(folder, [])
    in_code = re.sub(_SUFFIXES.get(folder, "$"), "", name) or name
    meant = [each for each in (in_code, with_capital(name.lower())) if each in known]
    near = meant or difflib.get_close_matches(name, known, 1)
    if known and name not in known and near:
        yield f"{package} has no {folder}/{name} in any ROS known here; is {near[0]} meant?"
    elif not known and in_code != name:
        yield f"{package}/{folder}/{name} looks like a class of code; is {in_code} meant?"


def _types(context: Mapping[str, Any], dictionary: Dictionary) -> Iterator[tuple[str, str, str]]:
    for _, _, kind, values in elements(context, dictionary):
        for attribute in kind.attributes.values():
            value = values.get(attribute.name)
            if attribute.format in TYPES and value and (type_ := split_type(value)):
                yield type_


def _names(package: Path, folder: str) -> Iterator[str]:
    """Yield the names of the types in a folder of a package; genaction makes messages alone."""
    for file in (package / folder).glob("*"):
        yield file.stem
    if folder == "action":
        for file in (package / "msg").glob("*Action.msg"):
            yield file.stem.removesuffix("Action")
