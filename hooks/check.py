"""Check a parsed spec against a dictionary, and give its values their types."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from . import in_code
from .collisions import Checked, Filters, collisions
from .dictionary import (
    DEPEND,
    DEPEND_KIND,
    NAME_BEFORE,
    PACKAGE,
    WAS,
    Attribute,
    Component,
    Dictionary,
    Interface,
    naming,
    nested,
)
from .endpoints import clashes
from .faults import SpecError, allowed, closest, first_of, quoted, shown
from .formats import BLANKS, FORMATS, FORMATS_OF_ROS, TYPES, comparable, dependency, split_type
from .literals import literal, spelled
from .names import class_name
from .parse import Element
from .ros import DEPENDENCY_KINDS, DISTROS, lacks

Values = dict[str, Any]
_MOST_TAGS = 5
"""How many tags a message names that have an attribute, or may stand in another."""


@dataclass
class CheckedSpec:
    """The values of the package, what it says it depends on, and all its elements."""

    file: str
    package: Values = field(default_factory=dict)
    depends: list[tuple[str, str]] = field(default_factory=list)
    """Each package, after the kind of dependency that it is; nothing for one of the usual kind."""
    declared: set[str] = field(default_factory=set)
    """The types that the spec itself declares: `msg/PointArray`."""
    types: list[tuple[Element, str, tuple[str, str, str]]] = field(default_factory=list)
    """Each type that the spec names: by which element and attribute; its parts."""
    elements: list[Checked] = field(default_factory=list)
    shared: list[Checked] = field(default_factory=list)
    """What stands in elements that others take; `elements` has it where it is taken."""
    unused: list[tuple[Element, str]] = field(default_factory=list)
    """Those of them that none takes, each with the tags that could."""

    @property
    def name(self) -> str:
        """The name of the package."""
        return str(self.package[naming(self.package)])

    def place(self, element: Element) -> str:
        """Name an element for a message."""
        used = f" (used at line {element.taker.line})" if element.taker else ""
        return f"{self.own_place(element)}{used}"

    def own_place(self, element: Element) -> str:
        """Name an element for a message on the element alone, whatever takes it."""
        return f"{element.file or self.file}:{element.line}: {element.label}"

    @property
    def components(self) -> list[Checked]:
        """The components that make something, in the order of the file."""
        alone = [element for element in self.elements if len(element.owners) == 1]
        return [element for element in alone if "tag" in element.values]

    @property
    def interfaces(self) -> list[Checked]:
        """The elements inside of components, at any depth, in the order of the file."""
        return [element for element in self.elements if len(element.owners) > 1]


def check(
    root: Element, dictionary: Dictionary, filters: Filters, file: str, distro: str = ""
) -> CheckedSpec:
    """Check the whole spec; `file` is its name in messages, `filters` are those of templates.

    Without a generation of ROS, names that only one of them refuses pass.

    Raises:
        SpecError: one line for every fault found, in the order of the file.

    """
    ros = DISTROS.get(distro)
    checker = _Checker(dictionary, file, distro)
    checker.check_package(root)
    if not checker.faults:
        checker.check_own_types()
        checker.check_references()
        for found in collisions(checker.spec.elements, dictionary.scopes, filters, ros):
            checker.fault(*found)
        for found in clashes(checker.spec.interfaces, dictionary):
            checker.fault(*found)
    if checker.faults:
        faults = sorted(checker.faults, key=lambda fault: fault[0])
        raise first_of([fault for _, fault in faults])
    return checker.spec


class _Checker:
    def __init__(self, dictionary: Dictionary, file: str, distro: str) -> None:
        self.dictionary = dictionary
        self.formats = {**FORMATS, **FORMATS_OF_ROS.get(DISTROS.get(distro, 0), {})}
        self.lacks, self.distro = lacks(distro), distro
        self.spec = CheckedSpec(file)
        self.faults: list[tuple[int, SpecError]] = []
        self.owners: dict[tuple[Any, ...], Element] = {}
        self.holders: dict[Element, str] = {}
        """By element with a type, the declared type that it is a part of, or nothing."""
        self.declaring = ""
        self.told: set[tuple[int, str]] = set()
        self.hints: dict[tuple[str, ...], str] = {}
        """What is said of a tag among the tags that are known."""
        self.is_sharing = False
        """Whether what is being checked stands in an element that others take."""
        self.shared: dict[tuple[str, str], Element] = {}
        """The elements that others take, by tag and name."""
        self.taken: set[Element] = set()
        """Those that one takes."""

    def check_package(self, element: Element) -> None:
        if element.tag != PACKAGE:
            what = f"a spec starts with <{PACKAGE}>, not <{shown(element.tag)}>"
            self.fault(element, what, "wrong-root")
            return
        components = self.dictionary.components
        known = self.dictionary.package
        name = naming(known)
        if name not in element.attributes and name in element.content:
            what = f'a spec has attributes, as <{PACKAGE} {name}="...">, not elements'
            self.fault(element, f"{what} as a package.xml of ROS", "wrong-root")
            return
        values = self.values(element, known, [*components, DEPEND], True)
        package = self.checked(PACKAGE, element, values)
        values |= {component.key: [] for component in components.values()}
        unknown = False
        children = [
            (self.dictionary.aliases.get(each.tag, each.tag), each) for each in element.children
        ]
        shared = {tag for tag, component in components.items() if component.is_shared}
        shared_ones: list[tuple[Component, Element, Values]] = []
        for tag, child in sorted(children, key=lambda pair: pair[0] not in shared):
            if tag == DEPEND:
                self.check_depend(child)
            elif tag in shared:
                shared_ones.append(
                    (
                        components[tag],
                        child,
                        self.shared_component(child, components[tag], package),
                    )
                )
            elif tag in components:
                component = self.component(child, components[tag], package)
                values[components[tag].key].append(component)
            else:
                unknown = True
                self.unknown_tag(child, [*components, DEPEND], self.dictionary.package)
        for kind, child, found in shared_ones:
            if child in self.taken:
                values[kind.key].append(found)
            else:
                self.spec.unused.append((child, self.takers(kind.tag)))
        needed = self.dictionary.needed
        if needed and not any(values[component.key] for component in needed) and not unknown:
            tags = _tags(component.tag for component in needed)
            self.fault(element, f"has no {tags}; it needs one at least", "missing-tag")
        self.spec.package = values

    def component(self, element: Element, component: Component, package: Checked) -> Values:
        self.declaring = ""
        has_name = component.can_be_renamed
        attributes, inside = component.attributes, component.interfaces
        values = given = self.values(element, attributes, inside, has_name, (component.tag,))
        if has_name:
            name = class_name(str(given.get(component.naming, "")))
            tag = {} if component.is_shared else {"tag": component.tag}
            values = {**tag, **given, "class_name": name}
        owner = self.checked(component.tag, element, {**values}, package)
        self.is_sharing = component.is_shared
        return values | self.interfaces(element, component, given, (package, owner))

    def shared_component(self, element: Element, component: Component, package: Checked) -> Values:
        """Return the values of an element that others take, and keep it for these."""
        values = self.component(element, component, package)
        self.is_sharing = False
        self.shared.setdefault((component.tag, str(values[component.naming])), element)
        return values

    def takers(self, tag: str) -> str:
        """Name the tags that take an element of a tag."""
        components = self.dictionary.components.values()
        kinds = [kind for each in components for kind in each.interfaces.values()]
        return " or ".join(dict.fromkeys(f"<{kind.kind}>" for kind in kinds if kind.taken == tag))

    def children(self, element: Element, kind: Component | Interface) -> Iterator[Element]:
        """Yield what stands in an element; after one that takes another, what stands in that."""
        taken = set()
        for child in element.children:
            yield child
            inner = kind.interfaces.get(child.tag)
            if inner and inner.taken:
                name = child.attributes.get(str(inner.naming), "")
                found = self.shared.get((inner.taken, name))
                if found and found not in taken:
                    taken.add(found)
                    yield from (each.taken_by(child) for each in found.children)
        self.taken |= taken

    def interfaces(
        self,
        element: Element,
        kind: Component | Interface,
        given: Values,
        owners: tuple[Checked, ...],
    ) -> Values:
        """Return what stands inside of an element, which is one of `kind` with values `given`."""
        values: Values = {each.key: None if each.once else [] for each in kind.interfaces.values()}
        unknown = False
        for child in self.children(element, kind):
            if child.tag not in kind.interfaces:
                unknown = True
                self.unknown_tag(child, list(kind.interfaces), kind.attributes)
                continue
            inner = kind.interfaces[child.tag]
            scope = (element, inner.kind)
            attributes, inside = inner.attributes, inner.interfaces
            found = self.values(child, attributes, inside, inner.can_be_renamed, scope)
            requires = [] if self.is_sharing else inner.requires
            if requires and not any(_is_said(name, element, given) for name in requires):
                what = f"its <{element.tag}> at line {element.line} must have the attribute"
                needed = (f'"{name}"{_doc(kind.attributes[name])}' for name in requires)
                instead = _instead(inner, kind.interfaces)
                what = f"{what} {' or '.join(needed)}{instead}"
                self.fault(child, what, "owner-lacks-attribute")
            item = self.checked(inner.kind, child, {**found}, *owners)
            found |= self.interfaces(child, inner, found, (*owners, item))
            if child.taker and not element.taker:  # it says where it was taken from
                taker = kind.interfaces[child.taker.tag]
                found[str(taker.taken)] = child.taker.attributes[str(taker.naming)]
            if not inner.once:
                values[inner.key].append(found)
                continue
            first = self.owners.setdefault((element, inner.kind), child)
            if first is not child:
                what = f"there is one at {first.where}; put all into one"
                self.fault(child, what, "only-one")
            values[inner.key] = found
        for inner in () if unknown else kind.interfaces.values():
            self.check_number(element, inner, len(inner.of(values)))
        return values

    def check_number(self, element: Element, kind: Interface, number: int) -> None:
        """Insist that an element holds as many of a kind as it must, and may."""
        if number < kind.least:
            what = f"has {number} <{kind.kind}>; it needs {kind.least} at least"
            self.fault(element, what, "too-few")
        elif kind.most is not None and number > kind.most:
            what = f"has {number} <{kind.kind}>; it may have {kind.most} at most"
            self.fault(element, what, "too-many")

    def check_own_types(self) -> None:
        """Insist that a type of the package itself is one that the spec declares."""
        owners = [(each.tag, each.attributes) for each in self.dictionary.components.values()]
        owners += [(each.kind, each.attributes) for each in self.dictionary.kinds]
        tags = {
            attribute.declares: tag
            for tag, attributes in owners
            for attribute in attributes.values()
            if attribute.declares
        }
        if not tags:
            return
        package = self.spec.name
        parts: dict[str, set[str]] = {}
        for element, name, (owner, folder, word) in self.spec.types:
            own, holder = f"{folder}/{word}", self.holders[element]
            if owner not in ("", package):
                continue
            if holder:
                parts.setdefault(holder, set()).add(own)
            if holder in _reached(parts, own):
                fault = f"{quoted(word)} would contain itself"
                what = f"{name}: {fault}; choose another type"
                self.fault(element, what, "recursive-type")
            elif own not in self.spec.declared:
                known = sorted(
                    declared.split("/")[1]
                    for declared in self.spec.declared
                    if declared.startswith(f"{folder}/")
                )
                fault = f"{quoted(word)} is not declared in this package"
                hint = allowed(word, known, in_code.field(word))
                if not known and folder in tags:
                    added = f"add <{tags[folder]} name={quoted(word)}>"
                    hint = hint.replace("none is allowed", added)
                what = f"{name}: {fault}; {hint}"
                self.fault(element, what, "undeclared-type")

    def check_references(self) -> None:
        """Insist that what refers to an element names one (decision 113)."""
        for item in self.spec.elements:
            kinds = self.kinds(item)
            known = kinds[-1].attributes if kinds else self.dictionary.package
            for name, attribute in known.items():
                tag, value = attribute.refers_to, item.values.get(name)
                if not tag or value in (None, ""):
                    continue
                package, *around = item.owners.values() or [item]
                holders = [
                    owner
                    for owner, kind in zip(around, kinds, strict=False)
                    if tag in [each.kind for each in nested(kind.interfaces)]
                ]
                home = [package, *holders][-1]
                meant = {
                    str(each.values[str(self.kinds(each)[-1].naming)]): each
                    for each in self.spec.elements
                    if each.tag == tag and any(owner is home for owner in each.owners.values())
                    if all(each.values.get(key) in words for key, words in attribute.whose.items())
                }
                names = list(meant)
                if value in meant:
                    for key, format_ in attribute.gives.items():
                        self.check_given(
                            meant[value], key, format_, f"{name} of {item.element.label}"
                        )
                else:
                    fault = f"{quoted(str(value))} is no <{tag}> of this <{home.tag}>"
                    for key, words in attribute.whose.items():
                        fault += f" whose {key} is {' or '.join(words)}"
                    what = f"{name}: {fault}; {allowed(str(value), names)}"
                    self.fault(item.element, what, "unknown-reference")

    def check_given(self, item: Checked, name: str, format_: str, use: str) -> None:
        """Insist that a value, or each of a list of them, is what the use of it needs."""
        value = item.values.get(name)
        given = value if isinstance(value, list) else [] if value is None else [value]
        try:
            for each in given:
                self.formats[format_](each)
            _insist_once(given)
        except SpecError as error:
            self.fault(item.element, f"{name}, which is {use}: {error.text}", error.id)

    def kinds(self, item: Checked) -> list[Component | Interface]:
        """Return what the dictionary says of an element, after what it stands in."""
        found: list[Component | Interface] = []
        for tag in [*item.owners, item.tag][1:]:
            found.append(found[-1].interfaces[tag] if found else self.dictionary.components[tag])
        return found

    def checked(self, tag: str, element: Element, values: Values, *owners: Checked) -> Checked:
        """Keep an element for the checks of the whole."""
        item = Checked(tag, element, values, {owner.tag: owner for owner in owners})
        (self.spec.shared if self.is_sharing else self.spec.elements).append(item)
        return item

    def check_depend(self, element: Element) -> None:
        kind = element.attributes.get(DEPEND_KIND, "")
        if set(element.attributes) - {DEPEND_KIND} or element.children:
            form = f'<{DEPEND}>std_msgs</{DEPEND}>, with {DEPEND_KIND}="exec" and the like'
            self.fault(element, f"takes a package name: {form}", "wrong-depend")
            return
        if DEPEND_KIND in element.attributes and kind not in DEPENDENCY_KINDS:
            fault = f"unknown {quoted(kind)}; {allowed(kind, DEPENDENCY_KINDS)}"
            self.fault(element, f"{DEPEND_KIND}: {fault}", "unknown-choice")
        try:
            self.spec.depends.append((kind, dependency(element.text)))
        except SpecError as error:
            self.fault(element, error.text, error.id)

    def values(
        self,
        element: Element,
        known: Mapping[str, Attribute],
        inside: Iterable[str],
        has_name: bool,
        scope: tuple[Any, ...] = (),
    ) -> Values:
        """Return the values of one element, in which the tags `inside` may stand.

        `has_name`: it may say its name of before. `scope` is where those that name it are unique.
        """
        told = set()
        """Attributes that are there by another name."""
        if element.text:
            meant, hint = _instead_of_text(element, known, inside)
            told.add(meant)
            what = f"text is not allowed here: {quoted(element.text)}; {hint}"
            self.fault(element, what, "text-not-allowed")
        known = {**known, WAS: NAME_BEFORE} if has_name else known
        for name in element.attributes:
            if name not in known:
                meant, hint = _meant(name, known) or _meant_choice(name, known) or ("", "")
                hint = hint or self.belongs(name, known)
                told.add(meant or closest(name, known))
                what = f"unknown attribute {quoted(name)}; {hint}"
                self.fault(element, what, "unknown-attribute")
        values: Values = {}
        for name, attribute in known.items():
            given = element.attributes.get(name)
            if attribute.ignored or (given is None and name == WAS):
                continue
            default = values.get(attribute.same_as) if attribute.same_as else attribute.default
            values[name] = default if given is None else None
            if any(_misplaced(attribute, values)):
                values[name] = None  # a default, too, has a meaning beside others alone
            if given is None and not attribute.optional and name not in told:
                what = f'attribute "{name}" is missing{_doc(attribute)}'
                self.fault(element, what, "missing-attribute")
            elif given is not None and not self.is_misplaced(element, attribute, values):
                try:
                    values[name] = value = _value(attribute, given, values, self.formats, known)
                    if attribute.choices and value in self.lacks:
                        what = f"{self.distro.capitalize()} has no {quoted(value)}"
                        raise SpecError(f"{what}; {self.lacks[value]}", "not-in-distro")
                    is_type = attribute.format in TYPES and not self.is_sharing
                    if is_type and (parts := split_type(value)):
                        self.spec.types.append((element, name, parts))
                        self.holders[element] = self.declaring
                    if name == WAS and value == values.get(naming(known)):
                        what = f"{quoted(value)} is the name it has; drop it"
                        raise SpecError(what, "names-itself")
                    if attribute.declares:
                        self.declaring = f"{attribute.declares}/{value}"
                        self.spec.declared.add(self.declaring)
                    if attribute.unique and scope:
                        self.check_unique(element, attribute, values[name], scope)
                except SpecError as error:
                    self.fault(element, f"{name}: {error.text}", error.id)
        wrong: set[Any] = set()
        for name, attribute in known.items():
            if values.get(name) is not None:
                is_bounded = not wrong & {attribute.minimum, attribute.maximum}
                bounds = (_out_of_bounds,) if is_bounded else ()
                for rule in (_misplaced, *bounds, _unlisted):
                    for fault in rule(attribute, values):
                        self.fault(element, *fault)
                        wrong.add(name)
        return values

    def is_misplaced(self, element: Element, attribute: Attribute, values: Values) -> bool:
        """Report an attribute that has no meaning beside those before it; its text may be any."""
        faults = [*_misplaced(attribute, values)]
        for fault in faults:
            self.fault(element, *fault)
        return bool(faults)

    def check_unique(
        self, element: Element, attribute: Attribute, value: str, scope: tuple[Any, ...]
    ) -> None:
        group = attribute.unique if isinstance(attribute.unique, str) else scope[-1]
        key = (*scope[:-1], group, comparable(attribute.format, value))
        first = self.owners.setdefault(key, element)
        if first is not element:
            other = first.attributes.get(attribute.name, value)
            by = f" by {quoted(other)}" if other != value else ""
            taken = f"already taken{by} at {first.where}"
            what = f"{quoted(value)} is {taken}; each must have its own"
            raise SpecError(what, "already-taken")

    def belongs(self, name: str, known: Mapping[str, Attribute]) -> str:
        """Say of what a name is an attribute, or that it is a tag; else what is allowed."""
        components = self.dictionary.components
        owners = {PACKAGE: self.dictionary.package}
        owners |= {tag: component.attributes for tag, component in components.items()}
        owners |= {kind.kind: kind.attributes for kind in self.dictionary.kinds}
        homes = [tag for tag, attributes in owners.items() if name in attributes]
        if 0 < len(homes) <= _MOST_TAGS:
            return f"it belongs to {_tags(homes)}; allowed: {', '.join(known)}"
        if homes := self.homes(name):
            return f"it is an element: <{name}> inside {_tags(homes)}"
        return allowed(name, known)

    def homes(self, tag: str) -> list[str]:
        """Return the tags in which an element may stand."""
        components = self.dictionary.components
        if tag in {DEPEND, *components}:
            return [PACKAGE]
        return list(
            dict.fromkeys(
                owner
                for name, component in components.items()
                for owner, kinds in _holders(name, component)
                if tag in kinds
            )
        )

    def unknown_tag(
        self, element: Element, known: list[str], attributes: Mapping[str, Attribute]
    ) -> None:
        """Report an element that may not stand in another, which has these attributes."""
        key = (element.tag, *known)
        if key not in self.hints:
            self.hints[key] = self.instead_of_tag(element.tag, known, attributes)
        what = f"<{shown(element.tag)}> is not known here; {self.hints[key]}"
        self.fault(element, what, "unknown-tag")

    def instead_of_tag(
        self, tag: str, known: list[str], attributes: Mapping[str, Attribute]
    ) -> str:
        """Say what a tag is for, or which are known."""
        homes = self.homes(tag)
        homes = [home for home in homes if home in known] or homes
        kinds = {kind.kind for kind in self.dictionary.kinds if tag in kind.elsewhere}
        meant = [f'"{kind}"' for kind in known if kind in kinds]
        kind_of_dependency = tag.removesuffix(f"_{DEPEND}")
        if meant:
            return f"did you mean {' or '.join(meant)}? allowed: {', '.join(known)}"
        if homes:
            return f"it belongs inside {_tags(homes)}; {allowed(tag, known)}"
        if tag in attributes:
            return f'did you mean {tag}="..."?'
        if hint := _meant(tag, attributes):
            return hint[1]
        if DEPEND in known and kind_of_dependency in DEPENDENCY_KINDS:
            return f'did you mean <{DEPEND} {DEPEND_KIND}="{kind_of_dependency}">?'
        return allowed(tag, known)

    def fault(self, element: Element, message: str, id_: str) -> None:
        """Keep a fault; that of an element is said once, however many take it."""
        is_told = (element.place[1], message) in self.told
        if is_told:
            return
        self.told.add((element.place[1], message))
        fault = SpecError(f"{self.spec.place(element)}: {message}", id_)
        self.faults.append((element.place[1], fault))


def _meant(name: str, known: Mapping[str, Attribute]) -> tuple[str, str] | None:
    """Return the attribute for which another tool has a name, and what is meant by that."""
    for attribute in known.values():
        for word, meant in attribute.elsewhere.items():
            if _plain(word) == _plain(name):
                written = meant or f'{attribute.name}="..."'
                return attribute.name, f"did you mean {written}?"
    return None


def _meant_choice(name: str, known: Mapping[str, Attribute]) -> tuple[str, str] | None:
    """Return the attribute of which a name is a choice, and that: `reliable="true"`."""
    for attribute in known.values():
        for choice, others in attribute.choices.items():
            if _plain(name) in map(_plain, (choice, *others)):
                return attribute.name, f'did you mean {attribute.name}="{choice}"?'
    return None


def _instead_of_text(
    element: Element, known: Mapping[str, Attribute], inside: Iterable[str]
) -> tuple[str, str]:
    """Return the attribute that a text in an element is for, if one alone, and what it takes."""
    if re.match("//|#|/[*]|--", element.text):
        return "", "a comment is <!-- ... -->"
    needed = (each for each in known.values() if not each.optional and not each.ignored)
    lacking = [each for each in needed if each.name not in element.attributes]
    if len(lacking) == 1 and element.text in (lacking[0].choices or [element.text]):
        return lacking[0].name, f'did you mean {lacking[0].name}="..."?'
    tags = list(inside)
    elements = f"; elements: {', '.join(tags)}" if 0 < len(tags) <= _MOST_TAGS else ""
    return "", f"it takes attributes: {', '.join(known)}{elements}"


def _meant_by(text: str, attribute: Attribute, known: Mapping[str, Attribute]) -> str | None:
    """Return what is meant by a text that is no word of an attribute, but of one beside it."""
    if meant := attribute.elsewhere.get(text):
        return f"did you mean {meant}?"
    for other in known.values():
        is_count = other.optional and other.format == "int" and text.isdecimal()
        for word, others in other.choices.items():
            if text in (word, *others):
                return f'did you mean {other.name}="{word}"?'
        if is_count:
            return f'did you mean {other.name}="{text}"?'
    return None


def _tags(names: Iterable[str]) -> str:
    return " or ".join(f"<{name}>" for name in names)


def _plain(name: str) -> str:
    return re.sub("[_-]", "", name).lower()


def _reached(parts: Mapping[str, set[str]], start: str) -> set[str]:
    """Return a type and all that it contains."""
    found, left = {start}, [start]
    while left:
        new = parts.get(left.pop(), set()) - found
        found |= new
        left += new
    return found


def _is_said(name: str, element: Element, given: Values) -> bool:
    """Tell whether an attribute is given, and not false; a wrong one is told of elsewhere."""
    return (name in element.attributes or given[name] is not None) and given[name] is not False


def _instead(kind: Interface, kinds: Mapping[str, Interface]) -> str:
    """Name the kind that requires nothing, of two such as `dynParameter` and `parameter`."""
    word = kind.kind.lower()
    names = [each.kind for each in kinds.values() if not each.requires]
    near = [n for n in names if n.lower().endswith(word) or word.endswith(n.lower())]
    return f", or use <{near[0]}>" if near else ""


def _holders(tag: str, kind: Component | Interface) -> Iterator[tuple[str, Iterable[str]]]:
    """Yield a tag and those below it, each with the kinds that may stand inside."""
    yield tag, kind.interfaces
    for each in nested(kind.interfaces):
        yield each.kind, each.interfaces


def _value(
    attribute: Attribute,
    text: str,
    values: Values,
    formats: Mapping[str, Callable[[str], Any]],
    known: Mapping[str, Attribute],
) -> Any:
    """Return the value that a text gives; `values` are those of the attributes before it."""
    if attribute.choices:
        for word, others in attribute.choices.items():
            if text.strip(BLANKS) in (word, *others):
                return word
        hint = _meant_by(text.strip(BLANKS), attribute, known)
        held = in_code.choice(text, attribute.choices)
        what = f"unknown {quoted(text)}; {hint or allowed(text, attribute.choices, held)}"
        raise SpecError(what, "unknown-choice")
    if attribute.pattern and not re.fullmatch(attribute.pattern, text):
        what = f"{quoted(text)} does not match the pattern {attribute.pattern}"
        raise SpecError(what, "pattern-mismatch")
    if attribute.format == "literal":
        type_name = values.get(attribute.of or "")
        if type_name is None:
            return None
        value = literal(text, type_name + "[]" * attribute.several)
        if value == [] and not attribute.can_be_empty:
            instead = "drop the attribute" if attribute.optional else "write what is in it"
            raise SpecError(f"a list must not be empty; {instead}", "empty-value")
        lists = any(other.among == attribute.name for other in known.values())
        _insist_once(value if lists and isinstance(value, list) else [])
        return text if attribute.as_written else value
    value = formats[attribute.format](text)
    if not attribute.optional and value == "" and attribute.format not in ("raw", "string"):
        raise SpecError("must not be empty", "empty-value")
    if value in attribute.reserved:
        raise SpecError(f"{quoted(value)} is reserved; choose another", "reserved-name")
    return value


def _insist_once(values: list[Any]) -> None:
    for each, number in Counter(values).items():
        if number > 1:
            raise SpecError(f"{quoted(spelled(each))} is there twice; drop one", "already-taken")


def _misplaced(attribute: Attribute, values: Values) -> Iterator[tuple[str, str]]:
    """Say that an attribute has no meaning beside the values of others, with the id of that."""
    for other, choices in attribute.when.items():
        if values.get(other) not in (None, *choices):
            what = f'has no meaning where {other} is "{values[other]}"'
            yield f'attribute "{attribute.name}" {what}; drop it', "attribute-without-meaning"


def _out_of_bounds(attribute: Attribute, values: Values) -> Iterator[tuple[str, str]]:
    """Say what a number must be; a bound may be the value of another attribute."""
    value = values[attribute.name]
    for each in value if isinstance(value, list) else [value]:
        if isinstance(each, int | float) and not isinstance(each, bool):
            for word, bound in attribute.beyond(each, values):
                yield f"{attribute.name}: {each} must be {word} {bound}", "out-of-range"


def _unlisted(attribute: Attribute, values: Values) -> Iterator[tuple[str, str]]:
    """Say that a value is none of those that another attribute lists."""
    value, known = values[attribute.name], values.get(attribute.among or "")
    if known is not None and value not in known:
        hint = allowed(str(value), [spelled(each) for each in known])
        what = f"{attribute.name}: {quoted(spelled(value))} is none of {attribute.among}; {hint}"
        yield what, "not-among"


def _doc(attribute: Attribute) -> str:
    return f" ({attribute.doc})" if attribute.doc else ""
