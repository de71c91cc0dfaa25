"""Complete a checked spec: the ROS it is for, and the packages it depends on."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .check import CheckedSpec, Values
from .faults import SpecError
from .ros import DISTROS, translate_dependency

Functions = dict[str, Callable[..., Any]]


def complete(spec: CheckedSpec, functions: Functions, distro: str) -> Values:
    """Return the context: the checked values, and what follows from them.

    `ros` is the generation (1 or 2), `kinds` the interface kinds in use, `depends` the packages
    needed, `notes` what the user should know.

    Raises:
        SpecError: a function of the model failed.

    """
    generation = DISTROS[distro]
    translated = [translate_dependency(name, generation) for name in spec.depends]
    found = {name for name, _ in translated if name}
    found |= _call(functions, "dependencies_from_template", "the package", distro)
    for item in spec.interfaces:
        arguments = (item.kind, item.values, distro)
        found |= _call(functions, "dependencies_from_interface", item.place, *arguments)
    own_name = next(iter(spec.package.values()))
    return {
        **spec.package,
        "ros": generation,
        "kinds": sorted({item.kind for item in spec.interfaces}),
        "depends": sorted(found - {own_name}),
        "notes": list(dict.fromkeys(note for _, note in translated if note)),
    }


def _call(functions: Functions, name: str, place: str, *arguments: Any) -> set[str]:
    if name not in functions:
        return set()
    try:
        result = functions[name](*arguments)
    except SpecError as error:
        if isinstance(error.__cause__, ValueError):  # the function refuses the spec
            raise SpecError(f"{place}: {error.__cause__} (said by {name})") from error
        raise SpecError(f"{error} (called for {place})") from error
    if not isinstance(result, list) or not all(isinstance(item, str) for item in result):
        raise SpecError(f"{name} for {place}: must return a list of package names, not {result!r}")
    return set(result)
