"""Complete a checked spec: the ROS it is for, and the packages it depends on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from .check import Used, Values
from .faults import SpecError
from .ros import DISTROS, translate_dependency

Functions = dict[str, Callable[..., Any]]


def complete(
    package: Values,
    depends: Iterable[str],
    used: Iterable[Used],
    functions: Functions,
    distro: str,
) -> Values:
    """Return the context: the checked values, and what follows from them.

    `ros` is the generation (1 or 2), `kinds` the interface kinds in use, `depends` the packages
    needed, `notes` what the user should know.

    Raises:
        SpecError: a function of the model failed.

    """
    used = list(used)
    generation = DISTROS[distro]
    found: set[str] = set()
    notes: list[str] = []
    for depend in depends:
        name, note = translate_dependency(depend, generation)
        found |= {name} if name else set()
        if note and note not in notes:
            notes.append(note)
    if "dependencies_from_template" in functions:
        found |= _call(functions, "dependencies_from_template", "the package", distro)
    if "dependencies_from_interface" in functions:
        for interface in used:
            found |= _call(
                functions,
                "dependencies_from_interface",
                interface.place,
                interface.kind,
                interface.values,
                distro,
            )
    own_name = next(iter(package.values()))
    return {
        **package,
        "ros": generation,
        "kinds": sorted({interface.kind for interface in used}),
        "depends": sorted(found - {own_name}),
        "notes": notes,
    }


def _call(functions: Functions, name: str, place: str, *arguments: Any) -> set[str]:
    try:
        result = functions[name](*arguments)
    except SpecError as error:
        if isinstance(error.__cause__, ValueError):  # the function refuses the spec
            raise SpecError(f"{place}: {error.__cause__} (said by {name})") from error
        raise SpecError(f"{error} (called for {place})") from error
    if not isinstance(result, list) or not all(isinstance(item, str) for item in result):
        raise SpecError(f"{name} for {place}: must return a list of package names, not {result!r}")
    return set(result)
