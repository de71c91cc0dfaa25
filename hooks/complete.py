"""Complete a checked spec: the ROS it is for, and the packages it depends on."""

from __future__ import annotations

import inspect
from collections import defaultdict
from collections.abc import Callable, Iterator
from typing import Any

from .check import CheckedSpec, Values
from .faults import SpecError, allowed, first_of, quoted, refused, with_id
from .formats import check_capital, dependency, with_capital
from .parse import Element
from .ros import DISTROS, lacking_kind, nearest_available, translate_dependency

Functions = dict[str, Callable[..., Any]]
_COVERED = ("exec", "test")
"""The kinds of dependencies that every usual one is, too."""


def complete(spec: CheckedSpec, functions: Functions, distro: str) -> Values:
    """Return the context: the checked values, and what follows from them.

    `ros` is the generation (1 or 2), `kinds` the interface kinds in use, `depends` the packages
    needed, `declared` those of them that the spec names itself, `other_depends` those of other
    kinds, by kind, `notes` what the user should know.

    Raises:
        SpecError: the distribution is unknown or lacks a package or type, or a function of the
            model failed or refused the spec.

    """
    if distro not in DISTROS:
        what = f"ros_distro: unknown {quoted(distro)}; {allowed(distro, DISTROS)}"
        raise SpecError(what, "unknown-choice")
    generation = DISTROS[distro]
    _check_kinds(spec)
    translated = [(kind, *translate_dependency(name, generation)) for kind, name in spec.depends]
    declared = {name for kind, name, _ in translated if name and not kind}
    found = set(declared)
    found |= _call(functions, "dependencies_from_template", "the package", distro)
    for component in spec.components:
        arguments = (component.tag, component.values, distro)
        place = spec.place(component.element)
        _result(functions, "check_component", place, *arguments)
        found |= _call(functions, "dependencies_from_component", place, *arguments)
    own_name = spec.name
    types: dict[Element, list[str]] = defaultdict(list)
    for element, _, parts in spec.types:
        types[element].append("/".join(parts))
    for item in spec.interfaces:
        place = spec.place(item.element)
        owners = {tag: owner.values for tag, owner in item.owners.items()}
        arguments = (item.tag, {**owners, **item.values}, distro)
        _result(functions, "check_interface", place, *arguments)
        needed = _call(functions, "dependencies_from_interface", place, *arguments)
        named = [name for name in types[item.element] if name.split("/")[0] in needed]
        for name in sorted(needed) + named:
            if nearest := nearest_available(name, generation):
                what = f"ROS {generation} has no {name}; the nearest it has is {nearest}"
                raise SpecError(f"{place}: {what}", "not-in-ros")
        if own_name in needed and not spec.declared:
            what = f"needs {own_name}, which is this package; name another"
            raise SpecError(f"{place}: {what}", "names-itself")
        found |= needed
    others: dict[str, set[str]] = defaultdict(set)
    for kind, package, _ in translated:
        if kind and package and not (kind in _COVERED and package in found):
            others[kind].add(package)
    notes = [note for *_, note in translated if note] + list(_small_types(spec, generation))
    for element, takers in spec.unused:
        note = f"{element.label} is not taken by any {takers}; nothing is made of it"
        notes.append(with_id(note, "not-taken"))
    return {
        **spec.package,
        "ros": generation,
        "kinds": sorted({item.tag for item in spec.interfaces}),
        "depends": sorted(found - {own_name}),
        "declared": sorted(declared - {own_name}),
        "other_depends": {kind: sorted(others[kind] - {own_name}) for kind in sorted(others)},
        "notes": list(dict.fromkeys(notes)),
    }


def _check_kinds(spec: CheckedSpec) -> None:
    """Refuse a service of a package that has messages alone, and the like."""
    faults = [
        SpecError(f"{spec.own_place(element)}: {name}: {lacking}", "wrong-kind-of-type")
        for element, name, (package, kind, _) in spec.types
        if (lacking := lacking_kind(package, kind))
    ]
    if faults:
        raise first_of(_each_once(faults))


def _small_types(spec: CheckedSpec, generation: int) -> Iterator[str]:
    """Refuse types that begin with a small letter in ROS 2; note them in ROS 1, which has some."""
    faults = []
    for element, name, _ in spec.types:
        type_ = element.attributes[name]
        try:
            check_capital(type_)
        except SpecError as error:
            place = f"{spec.own_place(element)}: {name}"
            faults.append(SpecError(f"{place}: {error.text}", error.id))
            meant = quoted(with_capital(type_))
            note = f"{quoted(type_)} begins with a small letter; is {meant} meant?"
            yield with_id(f"{element.label}: {note}", error.id)
    if faults and generation == 2:
        raise first_of(_each_once(faults))


def _each_once(faults: list[SpecError]) -> list[SpecError]:
    return [*{fault.text: fault for fault in faults}.values()]


def _result(functions: Functions, name: str, place: str, *arguments: Any) -> Any:
    try:
        return functions[name](*arguments) if name in functions else None
    except SpecError as error:
        if isinstance(error.__cause__, ValueError):  # the function refuses the spec
            raise refused(error.__cause__, place) from error
        raise SpecError(f"{error.text} (called for {place})", error.id) from error


def _call(functions: Functions, name: str, place: str, *arguments: Any) -> set[str]:
    if name not in functions:
        return set()
    result = _result(functions, name, place, *arguments)
    code = inspect.unwrap(functions[name]).__code__
    where = f"{code.co_filename}:{code.co_firstlineno}: {name} for {place}"
    if not isinstance(result, list) or not all(isinstance(item, str) for item in result):
        what = f"must return a list of package names, not {result!r}"
        raise SpecError(f"{where}: {what}", "function-fails")
    for item in result:
        try:
            dependency(item)
        except SpecError as error:
            raise SpecError(f"{where}: {error.text}", "function-fails") from None
    return set(result)
