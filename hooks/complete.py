"""Complete a checked spec: the ROS it is for, and the packages it depends on."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .check import CheckedSpec, Values
from .faults import SpecError, allowed, quoted
from .ros import DISTROS, nearest_available, translate_dependency

Functions = dict[str, Callable[..., Any]]


def complete(spec: CheckedSpec, functions: Functions, distro: str) -> Values:
    """Return the context: the checked values, and what follows from them.

    `ros` is the generation (1 or 2), `kinds` the interface kinds in use, `depends` the packages
    needed, `notes` what the user should know.

    Raises:
        SpecError: the distribution is unknown or lacks a package or type, or a function of the
            model failed or refused the spec.

    """
    if distro not in DISTROS:
        raise SpecError(f"ros_distro: unknown {quoted(distro)}; {allowed(distro, DISTROS)}")
    generation = DISTROS[distro]
    translated = [translate_dependency(name, generation) for name in spec.depends]
    found = {name for name, _ in translated if name}
    found |= _call(functions, "dependencies_from_template", "the package", distro)
    own_name = str(next(iter(spec.package.values())))
    for item in spec.interfaces:
        place = spec.place(item.element)
        arguments = (item.tag, item.values, distro)
        needed = _call(functions, "dependencies_from_interface", place, *arguments)
        types = [str(value) for value in item.values.values() if str(value).count("/") == 2]
        for name in sorted(needed) + [name for name in types if name.split("/")[0] in needed]:
            if nearest := nearest_available(name, generation):
                what = f"ROS {generation} has no {name}; the nearest it has is {nearest}"
                raise SpecError(f"{place}: {what}")
        if own_name in needed:
            raise SpecError(f"{place}: needs {own_name}, which is this package; name another")
        found |= needed
    return {
        **spec.package,
        "ros": generation,
        "kinds": sorted({item.tag for item in spec.interfaces}),
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
