"""Check a parsed spec against a dictionary, and give its values their types."""

from __future__ import annotations

import operator
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .dictionary import DEPEND, NAME_BEFORE, PACKAGE, WAS, Attribute, Component, Dictionary
from .faults import SpecError, allowed
from .formats import FORMATS, as_class_name, as_identifier, dependency, literal
from .parse import Element

Values = dict[str, Any]


@dataclass(frozen=True)
class Used:
    """An interface of the spec, kept to say whom a later fault is about."""

    kind: str
    values: Values
    place: str


def check(
    tag: str, element: Element, dictionary: Dictionary, file: str
) -> tuple[Values, list[str], list[Used]]:
    """Return the values of the spec, what it depends on, and its interfaces one by one.

    Raises:
        SpecError: one line for every fault found, in the order of the file.

    """
    checker = _Checker(dictionary, file)
    package = checker.package(tag, element)
    if checker.faults:
        raise SpecError(
            "\n".join(text for _, text in sorted(checker.faults, key=lambda fault: fault[0]))
        )
    return package, checker.depends, checker.used


class _Checker:
    def __init__(self, dictionary: Dictionary, file: str) -> None:
        self.dictionary = dictionary
        self.file = file
        self.faults: list[tuple[int, str]] = []
        self.depends: list[str] = []
        self.used: list[Used] = []
        self.seen: dict[tuple[Any, ...], Element] = {}

    def package(self, tag: str, element: Element) -> Values:
        if tag != PACKAGE:
            self.fault(element, f"<{tag}>", f"a spec starts with <{PACKAGE}>, not <{tag}>")
            return {}
        components = self.dictionary.components
        values = self.attributes(tag, element, self.dictionary.package, ())
        values |= {component.key: [] for component in components.values()}
        for child_tag, child in element.children:
            name = self.dictionary.aliases.get(child_tag, child_tag)
            if name == DEPEND:
                self.depend(child)
            elif name in components:
                component = components[name]
                values[component.key].append(self.component(child_tag, child, component))
            else:
                self.unknown_tag(child_tag, child, [*components, DEPEND])
        if not any(values[component.key] for component in components.values()):
            tags = " or ".join(f"<{name}>" for name in components)
            self.fault(element, self.label(tag, element), f"has no {tags}; it needs one at least")
        return values

    def component(self, tag: str, element: Element, component: Component) -> Values:
        values: Values = {"tag": component.tag}
        given = self.attributes(tag, element, component.attributes, (component.tag,))
        values |= {**given, "class_name": as_class_name(str(next(iter(given.values()), "")))}
        values |= {interface.key: [] for interface in component.interfaces.values()}
        for kind, child in element.children:
            if kind not in component.interfaces:
                self.unknown_tag(kind, child, list(component.interfaces))
                continue
            interface = component.interfaces[kind]
            found = self.attributes(kind, child, interface.attributes, (element.index, kind))
            needed = interface.requires
            if needed and needed not in element.attributes and given.get(needed) is None:
                what = f'its <{tag}> at line {element.line} must have the attribute "{needed}"'
                what += _doc(component.attributes[needed])
                self.fault(child, self.label(kind, child), what)
            for nested_tag, nested in child.children:
                self.unknown_tag(nested_tag, nested, [])
            values[interface.key].append(found)
            self.used.append(
                Used(kind, found, f"{self.file}:{child.line}: {self.label(kind, child)}")
            )
        return values

    def depend(self, element: Element) -> None:
        label = f"<{DEPEND}>"
        if element.attributes or element.children:
            self.fault(
                element, label, f"takes a package name alone: <{DEPEND}>std_msgs</{DEPEND}>"
            )
        try:
            self.depends.append(dependency(element.text))
        except ValueError as error:
            self.fault(element, label, str(error))

    def attributes(
        self, tag: str, element: Element, known: Mapping[str, Attribute], scope: tuple[Any, ...]
    ) -> Values:
        """Check the attributes of one element; `scope` is where its values must be unique."""
        label = self.label(tag, element)
        if element.text:
            self.fault(element, label, f'text is not allowed here: "{element.text[:40]}"')
        if tag != PACKAGE:
            known = {**known, WAS: NAME_BEFORE}
        for name in element.attributes:
            if name not in known:
                self.fault(element, label, f'unknown attribute "{name}"; {allowed(name, known)}')
        values: Values = {}
        for name, attribute in known.items():
            if attribute.ignored:
                continue
            given = element.attributes.get(name)
            if given is None and name == WAS:
                continue
            if given is None:
                if not attribute.optional:
                    self.fault(element, label, f'attribute "{name}" is missing{_doc(attribute)}')
                values[name] = attribute.default
                continue
            try:
                values[name] = _value(attribute, given, values)
            except ValueError as error:
                self.fault(element, label, f"{name}: {error}")
                values[name] = None
                continue
            if attribute.unique:
                self.unique(element, label, attribute, values[name], scope)
        self.limits(element, label, known, values)
        return values

    def unique(
        self,
        element: Element,
        label: str,
        attribute: Attribute,
        value: str,
        scope: tuple[Any, ...],
    ) -> None:
        word = as_identifier(value)
        if attribute.format == "component_name":
            word = word.replace("_", "").lower()
        group = attribute.unique if isinstance(attribute.unique, str) else scope[-1]
        first = self.seen.setdefault((*scope[:-1], group, word), element)
        if first is not element:
            what = f'"{value}" is already taken at line {first.line}'
            self.fault(element, label, f"{attribute.name}: {what}; each must have its own")

    def limits(
        self, element: Element, label: str, known: Mapping[str, Attribute], values: Values
    ) -> None:
        """Check what a number may be, once all the values of the element are known."""
        for name, attribute in known.items():
            value = values.get(name)
            if value is None:
                continue
            for other, choices in attribute.when.items():
                if values.get(other) not in (None, *choices):
                    what = f'has no meaning where {other} is "{values[other]}"'
                    self.fault(element, label, f'attribute "{name}" {what}; drop it')
            if isinstance(value, bool) or not isinstance(value, int | float):
                continue
            limits = [
                ("above", attribute.above, operator.gt),
                ("at least", attribute.minimum, operator.ge),
                ("at most", attribute.maximum, operator.le),
            ]
            for word, limit, holds in limits:
                bound = values.get(limit) if isinstance(limit, str) else limit
                if bound is not None and not holds(value, bound):
                    self.fault(element, label, f"{name}: {value} must be {word} {bound}")

    def unknown_tag(self, tag: str, element: Element, known: list[str]) -> None:
        homes = [
            PACKAGE if tag in {DEPEND, *self.dictionary.components} else component.tag
            for component in self.dictionary.components.values()
            if tag in {DEPEND, *self.dictionary.components, *component.interfaces}
        ]
        where = f"it belongs inside <{homes[0]}>" if homes else allowed(tag, known)
        self.fault(element, self.label(tag, element), f"<{tag}> is not known here; {where}")

    def fault(self, element: Element, label: str, message: str) -> None:
        self.faults.append((element.line, f"{self.file}:{element.line}: {label}: {message}"))

    @staticmethod
    def label(tag: str, element: Element) -> str:
        """Show an element by its first attribute, as the user wrote it."""
        shown = "".join(
            f' {name}="{value}"' for name, value in list(element.attributes.items())[:1]
        )
        return f"<{tag}{shown}>"


def _value(attribute: Attribute, text: str, values: Values) -> Any:
    if attribute.choices:
        for word, others in attribute.choices.items():
            if text.strip() in (word, *others):
                return word
        raise ValueError(f'unknown "{text}"; {allowed(text, attribute.choices)}')
    if attribute.pattern and not re.fullmatch(attribute.pattern, text):
        raise ValueError(f'"{text}" does not match the pattern {attribute.pattern}')
    if attribute.format == "literal":
        type_name = values.get(attribute.of or "")
        return None if type_name is None else literal(text, type_name)
    value = FORMATS[attribute.format](text)
    if not attribute.optional and value == "" and attribute.format == "text":
        raise ValueError("must not be empty")
    if value in attribute.reserved:
        raise ValueError(f'"{value}" is reserved; choose another')
    return value


def _doc(attribute: Attribute) -> str:
    return f" ({attribute.doc})" if attribute.doc else ""
