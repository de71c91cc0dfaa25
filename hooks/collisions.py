"""The names that a spec has in a package: unique in their scope, and not reserved there.

Which names those are, the dictionary says under `names`; docs/designers describes it
(decision 11).
"""

from __future__ import annotations

import re
import string
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from .faults import SpecError, allowed, shown
from .parse import Element
from .words import DEVICES, meaning

_NO = ("None", "False")
"""What an attribute says, as text, that is not given or says no."""
Filters = Mapping[str, Callable[..., Any]]


@dataclass(frozen=True)
class Scope:
    """A place where names land, such as the files of the package or the members of a class."""

    label: str
    owners: Sequence[str]
    """The tags of what has such a place of its own."""
    made_by: Mapping[str, Sequence[str]]
    """The tag of an element, and forms of the names that it makes: `in_{name:identifier}`.

    One with a condition, `accept_{name} if {accept}`, makes none where that attribute says no.
    """
    reserved: Sequence[str] = ()
    """Forms or regular expressions of names, or meanings that `hooks.words` knows."""
    because: str = ""
    """Why names are reserved."""
    ignore_case: bool = False
    ros: int | None = None
    """The only generation of ROS in which there is such a place."""
    said_at: str = ""
    """The file and line of the dictionary."""
    parts: str = ""
    """What divides a name; no name may be what stands before it in another."""

    def place(self, item: Checked) -> Checked:
        """Return the innermost of what an element stands in that has such a place."""
        found = (item.owners[tag] for tag in reversed(item.owners) if tag in self.owners)
        return next(found, item)


@dataclass(frozen=True)
class Checked:
    """An element of the spec with its values, and those it stands in, outermost first, by tag."""

    tag: str
    element: Element
    values: Mapping[str, Any]
    owners: dict[str, Checked] = field(default_factory=dict)


def collisions(
    elements: Sequence[Checked], scopes: Sequence[Scope], filters: Filters, ros: int | None
) -> Iterator[tuple[Element, str, str]]:
    """Yield each element that makes a name it cannot, what is wrong with the name, and its id.

    What counts in one generation of ROS alone is left out where `ros` is not that one.
    """
    for scope in scopes:
        if scope.ros not in (None, ros):
            continue
        taken: dict[tuple[int, str], Element] = {}
        for item in elements:
            forms = scope.made_by.get(item.tag, ())
            reserved = [_made(form, item, filters, scope) for form in scope.reserved if forms]
            owner = scope.place(item).element
            for form in forms:
                form, _, condition = form.partition(" if ")
                if _made(condition, item, filters, scope) in _NO:
                    continue
                name = _made(form, item, filters, scope)
                why = next(filter(None, (_reservation(name, word, ros) for word in reserved)), "")
                key = name.lower() if scope.ignore_case else name
                first = taken.setdefault((id(owner), key), item.element)
                if why:
                    reason = f": {scope.because}" if scope.because and why == "reserved" else ""
                    what = f'"{shown(name)}" is {why} as {scope.label}{reason}; choose another'
                    yield item.element, what, "reserved-name"
                elif first is not item.element:
                    also = f"{first.label} at {first.where}"
                    what = f'makes the {scope.label} "{shown(name)}"'
                    yield item.element, f"{what}, as {also} does; rename one of them", "name-clash"
        for (place, name), element in taken.items() if scope.parts else ():
            above = [name[:end] for end in range(len(name)) if name[end] == scope.parts]
            for group in above:
                if other := taken.get((place, group)):
                    what = f'"{shown(group)}" is a {scope.label} itself, at {other.where}'
                    what += ", so that nothing can be below it; rename one of them"
                    yield element, what, "name-clash"


def _reservation(name: str, reserved: str, ros: int | None) -> str:
    if reserved.startswith("a "):
        words = name.lower().split("/") if reserved in DEVICES else [name]  # parts of a path
        found = [meaning(word, [reserved], [ros] if ros else []) for word in words]
        return f"{max(found)}, so reserved" if any(found) else ""
    return "reserved" if re.fullmatch(reserved, name) else ""


class _Form(string.Formatter):
    """Text with `{attribute}` in it, or `{attribute:filter}`."""

    def __init__(self, filters: Filters) -> None:
        self.filters = filters

    def format_field(self, value: Any, format_spec: str) -> str:
        if format_spec and format_spec not in self.filters:
            what = f'unknown filter "{format_spec}"; {allowed(format_spec, self.filters)}'
            raise ValueError(what)
        return str(self.filters[format_spec](value) if format_spec else value)


def _made(form: str, item: Checked, filters: Filters, scope: Scope) -> str:
    """Return the name that an element makes by a form.

    Raises:
        SpecError: the form names an attribute or a filter that there is not.

    """
    if "{" not in form:
        return form
    owners = {tag: owner.values for tag, owner in item.owners.items()}
    known = {**owners, **item.values}
    try:
        return _Form(filters).vformat(form, (), known)
    except (LookupError, ValueError, TypeError, AttributeError) as error:
        why = str(error)
        if isinstance(error, KeyError):
            word = str(error.args[0])
            owner = re.search(rf"{{(\w+)\[{re.escape(word)}\]", form)
            names = owners.get(owner[1], {}) if owner else known
            why = f'unknown attribute "{word}"; {allowed(word, names)}'
        where = f"{scope.said_at}: names: {scope.label}".lstrip(": ")
        what = f'{where}: "{form}" has no meaning: {why}'
        raise SpecError(what, "form-without-meaning") from None
