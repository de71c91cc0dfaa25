"""The dictionary of a model: which tags and attributes its specs may use.

The form is that of Figure 4 of the paper; an attribute or an interface kind may also be a
mapping, which says more than a name. docs/designers describes it.
"""

from __future__ import annotations

import operator
import re
import types
import typing
from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from .collisions import Scope
from .faults import SpecError, allowed, closest
from .formats import FORMATS
from .literals import spelled
from .located import Located, load_located, plain
from .words import meanings

PACKAGE = "package"
DEPEND = "depend"
DEPEND_KIND = "kind"
WAS = "was"
RESERVED_KEYS = frozenset(
    {"ros", "kinds", "declared", "depends", "other_depends", "notes", "schema"}
)
"""The keys of the context that the hook itself adds to the attributes of the package."""
COMPONENT_KEYS = frozenset({"tag", "class_name"})
"""The keys that the hook itself adds to the attributes of a component (decision 7)."""
NUMBERS = ("number", "int", "double", "literal")
"""The formats that limits are for."""
HIDDEN_KEYS = frozenset(dir(dict))
"""The attributes that Jinja takes for methods of the context: `node.items`."""


@dataclass(frozen=True)
class Attribute:
    """One attribute of a tag, and what its value must be."""

    name: str
    doc: str = ""
    elsewhere: Mapping[str, str | None] = field(default_factory=dict)
    """What people write for it who know other tools, and what they mean if not its name alone."""
    optional: bool = False
    default: Any = None
    same_as: str | None = None
    format: str = "text"
    of: str | None = None
    several: bool = False
    """It is a list of what `of` says."""
    can_be_empty: bool = False
    """It may be a list without values."""
    among: str | None = None
    """The attribute that lists the values it may have."""
    refers_to: str | None = None
    """The tag of the elements one of which it names."""
    whose: Mapping[str, list[str]] = field(default_factory=dict)
    """What these must say in other attributes."""
    gives: Mapping[str, str] = field(default_factory=dict)
    """The formats of what these say in other attributes, or in each value of a list."""
    as_written: bool = False
    choices: Mapping[str, list[str]] = field(default_factory=dict)
    pattern: str | None = None
    above: float | None = None
    minimum: float | str | None = None
    maximum: float | str | None = None
    when: Mapping[str, list[Any]] = field(default_factory=dict)
    unique: bool | str = False
    declares: str | None = None
    reserved: list[str] = field(default_factory=list)
    ignored: bool = False
    example: Any = ""

    def beyond(self, value: float, values: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
        """Yield the limits that a number does not keep, of which one may be another's value."""
        for word, limit, holds in (
            ("above", self.above, operator.gt),
            ("at least", self.minimum, operator.ge),
            ("at most", self.maximum, operator.le),
        ):
            bound = values.get(limit) if isinstance(limit, str) else limit
            if bound is not None and not holds(value, bound):
                yield word, bound


NAME_BEFORE = Attribute(
    WAS, "the name before, so that the code of a renamed one is kept", optional=True
)
"""The attribute that the package, every component and every interface with a name may have."""


@dataclass(frozen=True)
class Interface:
    """One interface kind: its attributes, what it is for, the kinds inside of it (decision 79)."""

    kind: str
    attributes: Mapping[str, Attribute]
    doc: str = ""
    elsewhere: list[str] = field(default_factory=list)
    """What people write for it who know other tools."""
    requires: list[str] = field(default_factory=list)
    """Attributes of its owner, of which one must be given."""
    once: bool = False
    least: int = 0
    """How many of them must be in what may hold them."""
    most: int | None = None
    """How many of them may be in it."""
    takes: bool = False
    """Its owner has what stands in the element that it refers to (decision 134)."""
    interfaces: Mapping[str, Interface] = field(default_factory=dict)

    @property
    def naming(self) -> str | None:
        """The attribute that names one: the first, but none where there is one at most."""
        return None if self.once else naming(self.attributes)

    @property
    def taken(self) -> str | None:
        """The tag of what it takes, if it does."""
        return self.attributes[self.naming].refers_to if self.takes and self.naming else None

    @property
    def can_be_renamed(self) -> bool:
        """It has a name of its own, so that it may say which it had before."""
        return not self.once and not self.takes

    @property
    def key(self) -> str:
        """Where the context keeps the interfaces of this kind: `publishers`."""
        return self.kind if self.once else self.kind + "s"

    def of(self, owner: Mapping[str, Any]) -> list[Any]:
        """Return the interfaces of this kind that an owner has in the context."""
        found = owner.get(self.key) or []
        return [found] if isinstance(found, Mapping) else list(found)


@dataclass(frozen=True)
class Component:
    """One component tag, such as the paper's node: its attributes and interface kinds."""

    tag: str
    attributes: Mapping[str, Attribute]
    interfaces: Mapping[str, Interface]
    is_plain: bool = False
    """It says more of the package, and has no interface."""
    is_optional: bool = False
    """A package needs none, as of those that are plain."""
    is_shared: bool = False
    """It holds what others take: its interface is said of these."""

    @property
    def naming(self) -> str:
        """The attribute that names one."""
        return naming(self.attributes)

    @property
    def can_be_renamed(self) -> bool:
        """It makes something that has its name."""
        return not self.is_plain or self.is_shared

    @property
    def key(self) -> str:
        """Where the context keeps the components of this tag: `nodes`."""
        return self.tag + "s"

    def of(self, package: Mapping[str, Any]) -> list[Any]:
        """Return the components of this tag that a package has in the context."""
        return list(package.get(self.key, []))


def naming(attributes: Iterable[str]) -> str:
    """Return the attribute that names what has these: the first."""
    return next(iter(attributes))


def nested(interfaces: Mapping[str, Interface]) -> Iterator[Interface]:
    """Yield interface kinds, each followed by those inside of it."""
    for interface in interfaces.values():
        yield interface
        yield from nested(interface.interfaces)


def _kinds(owner: Component | Interface) -> list[str]:
    return [each.kind for each in nested(owner.interfaces)]


@dataclass(frozen=True)
class Dictionary:
    """All a model allows in a spec."""

    package: Mapping[str, Attribute]
    components: Mapping[str, Component]
    aliases: Mapping[str, str]
    skeleton: list[str]
    scopes: list[Scope]
    holders: list[str]
    """What the logic calls the objects whose members interfaces name."""
    files: list[str]
    """Where all of this is said, below the root: each dictionary after those that it includes."""

    @property
    def needed(self) -> list[Component]:
        """The components of which a package has one at least."""
        return [each for each in self.components.values() if not each.is_optional]

    @property
    def naming(self) -> str:
        """The attribute that names a package."""
        return naming(self.package)

    @property
    def kinds(self) -> list[Interface]:
        """The interface kinds of all components, each followed by those inside of it."""
        return [kind for each in self.components.values() for kind in nested(each.interfaces)]

    @property
    def tags(self) -> list[str]:
        """The tags of components and, after each, of what may stand inside of it; each once."""
        components = self.components.values()
        return [*dict.fromkeys(tag for each in components for tag in (each.tag, *_kinds(each)))]


_KEYS = {
    *("package_attributes", "aliases", "skeleton", "optional", "names", "holders"),
    *("definitions", "include"),
}
_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_DECLARED = ("msg", "srv", "action")


def load(file: Path, root: Path) -> Dictionary:
    """Read a `dictionary.yaml`; what it includes is looked for below `root`.

    Raises:
        SpecError: the file is not YAML or says what no dictionary can say.

    """
    name = _name(file, root)
    for texts, known in _known:  # of another folder of this version
        if known.files[-1] == name and all(_has(root / each, texts[each]) for each in texts):
            return known
    texts = {}
    content = _read(name, root, texts)
    read = _Reader(name).dictionary(content, [*texts])
    _known.append((texts, read))
    return read


_known: list[tuple[dict[str, bytes], Dictionary]] = []
"""What was read, with the texts of the files."""


def _name(file: Path, root: Path) -> str:
    """Return the name of a file in messages and in `Dictionary.files`."""
    return file.relative_to(root).as_posix() if file.is_relative_to(root) else str(file)


def _has(file: Path, text: bytes) -> bool:
    return file.is_file() and file.read_bytes() == text


def _read(name: str, root: Path, texts: dict[str, bytes], within: tuple[str, ...] = ()) -> Any:
    """Return what a dictionary says, added to what those that it includes say; note its text.

    Decision 89: with a key that took the place of the included one, all of it had to be repeated.
    """
    content = load_located(root / name, name)
    if not isinstance(content, dict):
        what = "must be a mapping with package_attributes and <tag>_interface"
        raise SpecError(f"{name}: {what}", "wrong-shape")
    included: dict[str, Any] = {}
    names = content.pop("include", None) or []
    for other in names if isinstance(names, list) else [names]:
        place = getattr(other, "place", name)
        if not (root / str(other)).is_file():
            what = f"{other}: no such file; a model needs it"
            raise SpecError(f"{place}: include: {what}", "no-such-file")
        inner = _name(root / str(other), root)
        if inner in (*within, name):
            what = f"{other} includes this file itself; drop one"
            raise SpecError(f"{place}: include: {what}", "circular-include")
        included = _added(included, _read(inner, root, texts, (*within, name)))
    texts[name] = (root / name).read_bytes()
    return _added(included, content)


def _added(first: Any, second: Any) -> Any:
    """Return both, of mappings and lists; of what can only be one thing, the second."""
    if isinstance(first, dict) and isinstance(second, dict):
        common = {key: _added(first[key], second[key]) for key in first.keys() & second.keys()}
        own = {key: key for key in second}  # which knows its place
        return {own.get(key, key): each for key, each in {**first, **second, **common}.items()}
    if isinstance(first, list) and isinstance(second, list):
        return [*first, *(item for item in second if item not in first)]
    return second


class _Reader:
    """Reads what a dictionary says, and keeps where it does so (decision 99)."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.places: dict[str, str] = {}
        """The file and line of each thing that a message may name."""

    def dictionary(self, content: Any, files: list[str]) -> Dictionary:
        own = {
            key for key in content if re.fullmatch(r"(?!package_)\w+_(attributes|interface)", key)
        }
        tags = list(dict.fromkeys(key.rpartition("_")[0] for key in content if key in own))
        for key in sorted(content, key=lambda key: key.line):
            self.places.setdefault(key.rpartition("_")[0], key.place)
        self.places |= {key: key.place for key in content}
        forms = {"<component>_attributes", "<component>_interface"}
        self.check_keys("", content, _KEYS | own, own | _KEYS | forms)
        self.check_halves(content, tags)
        optional = content.get("optional") or []
        self.check_shape("optional", "optional", optional, list[str])
        for tag in optional:
            self.check_word(tag, "optional", "component tag", tags)
        components = {
            tag: Component(
                tag,
                self.attributes(tag, content.get(f"{tag}_attributes") or [Located("name")]),
                self.interfaces(f"{tag}_interface", content.get(f"{tag}_interface")),
                is_plain=f"{tag}_interface" not in content,
                is_optional=f"{tag}_interface" not in content or tag in optional,
            )
            for tag in map(str, tags)
        }
        package = self.attributes(PACKAGE, content.get("package_attributes") or [Located("name")])
        kinds = [*dict.fromkeys(kind for each in components.values() for kind in _kinds(each))]
        owners = {PACKAGE, *components, *kinds}
        skeleton = content.get("skeleton") or []
        self.check_shape("skeleton", "skeleton", skeleton, list[str])
        for kind in skeleton:
            self.check_word(kind, "skeleton", "interface kind", kinds)
        holders = content.get("holders") or []
        self.check_shape("holders", "holders", holders, list[str])
        aliases = content.get("aliases") or {}
        self.check_shape("aliases", "aliases", aliases, Mapping[str, str])
        for alias, tag in aliases.items():
            self.check_word(tag, f"aliases: {alias}", "component tag", [*components, DEPEND])
            if alias in (*components, DEPEND):
                what = f'"{alias}" is a tag itself; choose another'
                raise self.fault(alias, "aliases", what, "reserved-name")
        names = content.get("names") or {}
        self.check_shape("names", "names", names, Mapping[str, Any])
        scopes = [self.scope(label, item, owners) for label, item in names.items()]
        self.check_hidden(PACKAGE, package, {c.key for c in components.values()} | RESERVED_KEYS)
        for component in components.values():
            keys = frozenset() if component.is_plain else COMPONENT_KEYS
            self.check_inside(component.tag, component, keys)
        self.check_references(package, components)
        components = self.shared(components)
        said = (plain(aliases), plain(skeleton), scopes, plain(holders))
        return Dictionary(package, components, *said, files)

    def check_halves(self, content: Mapping[str, Any], tags: list[str]) -> None:
        """Refuse attributes of a tag that is spelled like another, which has none.

        Either may be as it is by itself: one says more of the package, the other has a name alone.
        """
        lacking = [tag for tag in (PACKAGE, *tags) if f"{tag}_attributes" not in content]
        for tag in tags:
            if f"{tag}_interface" not in content and (near := closest(tag, lacking)):
                lacks, more, neither = f"{near}_attributes", "", "not"
                if near != PACKAGE:
                    more, neither = f', or "{tag}_interface" for "{near}_interface"', "neither"
                what = f'there is no {lacks}; did you mean "{lacks}"{more}? if {neither}, add it'
                raise self.fault("", f"{tag}_attributes", what, "missing-key")

    def check_references(
        self, package: Mapping[str, Attribute], components: Mapping[str, Component]
    ) -> None:
        """Insist that what an attribute refers to are elements with a name."""
        kinds: list[tuple[str, Component | Interface]] = [*components.items()]
        for component in components.values():
            kinds += [(each.kind, each) for each in nested(component.interfaces)]
        tags = list(dict.fromkeys(tag for tag, kind in kinds if kind.naming))
        for owner, known in [(PACKAGE, package), *((tag, kind.attributes) for tag, kind in kinds)]:
            for name, attribute in known.items():
                if not (tag := attribute.refers_to):
                    continue
                label = f"{owner} {name}"
                self.check_word("", label, "tag to refer to", tags, tag)
                meant = [each for other, kind in kinds if other == tag for each in kind.attributes]
                for key in (*attribute.whose, *attribute.gives):
                    self.check_word("", label, f"attribute of <{tag}>", meant, key)
                for format_ in attribute.gives.values():
                    self.check_word("", label, "format", FORMATS, format_)

    def shared(self, components: dict[str, Component]) -> dict[str, Component]:
        """Return the components; those that others take may hold what these may hold."""
        found = dict(components)
        for component in components.values():
            held = {name: kind for name, kind in component.interfaces.items() if not kind.takes}
            for kind in nested(component.interfaces):
                if kind.takes and kind is not component.interfaces.get(kind.kind):
                    what = "only a kind of a component takes"
                    raise self.fault("", kind.kind, what, "wrong-takes")
                if kind.takes and not kind.taken:
                    what = "what a kind takes is named by refers_to of its first attribute"
                    raise self.fault("", kind.kind, what, "wrong-takes")
                if not (tag := kind.taken):
                    continue
                if tag not in components or not components[tag].is_plain:
                    what = f"takes <{tag}>, which has an interface of its own"
                    only = f"it needs {tag}_attributes alone"
                    raise self.fault("", kind.kind, f"{what}; {only}", "wrong-takes")
                for each in held.values():
                    self.check_hidden(each.kind, each.attributes, {tag})
                kinds = {**held, **found[tag].interfaces}
                found[tag] = replace(components[tag], interfaces=kinds, is_shared=True)
        return found

    def attributes(self, owner: str, items: Any) -> dict[str, Attribute]:
        if not isinstance(items, list):
            raise self.fault("", owner, "the attributes must be a list", "wrong-shape")
        found: dict[str, tuple[Located, Attribute]] = {}
        for item in items:
            named = {item: {}} if isinstance(item, str) else item
            if not isinstance(named, dict):
                what = f"{item!r} must be a name or a mapping"
                raise self.fault("", owner, what, "wrong-shape")
            for name, options in named.items():
                self.check_name(name, owner)
                if name in found and found[name][0].file == name.file:
                    line = found[name][0].line
                    what = f'attribute "{name}" is there twice, first at line {line}; keep one'
                    raise self.fault(name, owner, what, "key-twice")
                found[str(name)] = name, self.attribute(f"{owner} {name}", name, options or {})
        attributes = {name: attribute for name, (_, attribute) in found.items()}
        for number, (name, (key, attribute)) in enumerate(found.items()):
            label, others = f"{owner} {name}", list(attributes)
            for option in ("of", "same_as", "among"):
                if other := getattr(attribute, option):
                    self.check_word(
                        key, f"{label}: {option}", "attribute above it", others[:number], other
                    )
            limits = [
                each for each in (attribute.minimum, attribute.maximum) if isinstance(each, str)
            ]
            for other in (*limits, *attribute.when):
                self.check_word(key, label, f"attribute of <{owner}>", others, other)
            for other, words in attribute.when.items():
                for word in words if attributes[other].choices else ():
                    what = f'word of "{other}"'
                    self.check_word(key, f"{label}: when", what, attributes[other].choices, word)
        return attributes

    def attribute(self, label: str, name: Located, options: Any) -> Attribute:
        self.places[label] = name.place
        if not isinstance(options, dict):
            what = f"{options!r} must be a mapping of what it is"
            raise self.fault(name, label, what, "wrong-shape")
        self.check_keys(label, options, set(_SHAPES) - {"name"})
        for key in ("choices", "elsewhere"):
            if isinstance(words := options.get(key), list):
                self.check_shape(name, f"{label}: {key}", words, list[str | float | bool | None])
                options = {**options, key: dict.fromkeys(words)}
        choices = options.get("choices")
        if isinstance(choices, dict):
            if not choices or any(isinstance(word, bool | None) for word in choices):
                what = "must be words, in quotes where YAML reads something else"
                raise self.fault(name, label, f'choices {what}, such as "on"', "wrong-shape")
            choices = {
                spelled(word): [] if each is None else each for word, each in choices.items()
            }
            options = {**options, "choices": choices}
        for key, value in options.items():
            more = "a list, or " if key in ("choices", "elsewhere") else ""
            self.check_shape(key, f"{label}: {key}", value, _SHAPES[key], more)
        given = {"optional": bool({"default", "same_as"} & set(options)), **plain(options)}
        attribute = Attribute(str(name), **given)
        formats = [*FORMATS, "literal"]
        self.check_word(name, f"{label}: format", "format", formats, attribute.format)
        if attribute.format == "literal" and not attribute.of:
            what = "a literal needs of: the attribute that names its type"
            raise self.fault(name, label, what, "missing-key")
        for key in ("whose", "gives"):
            if options.get(key) and not attribute.refers_to:
                raise self.fault(name, label, f"{key} needs refers_to", "missing-key")
        limits = {"above", "minimum", "maximum"} & set(options)
        if limits and attribute.format not in NUMBERS:
            what = f"{min(limits)} needs a format of numbers: {', '.join(NUMBERS)}"
            raise self.fault(name, label, what, "missing-key")
        if attribute.declares:
            self.check_word(
                name, f"{label}: declares", "kind of type", _DECLARED, attribute.declares
            )
        if attribute.pattern:
            self.check_pattern(name, f"{label}: pattern", attribute.pattern)
        for key in ("default", "example"):
            self.check_value(name, f"{label}: {key}", attribute, getattr(attribute, key))
        return attribute

    def check_value(self, at: Located, label: str, attribute: Attribute, value: Any) -> None:
        """Insist that the default or the example is what a spec could say."""
        if value in (None, "") or attribute.format == "literal":
            return
        self.check_shape(at, label, value, str | float | bool)
        text = spelled(value)
        if "$" in text:
            return
        if attribute.choices:
            known = [word for one, more in attribute.choices.items() for word in (one, *more)]
            self.check_word(at, label, "choice", known, text)
            return
        try:
            meant = FORMATS[attribute.format](text)
        except SpecError as error:
            raise self.fault(at, label, error.text, error.id) from None
        if attribute.pattern and not re.fullmatch(attribute.pattern, text):
            what = f'"{text}" does not match the pattern {attribute.pattern}'
            raise self.fault(at, label, what, "pattern-mismatch")
        if isinstance(meant, float):
            for word, bound in attribute.beyond(meant, {}):
                raise self.fault(at, label, f"{meant} must be {word} {bound}", "out-of-range")
        if meant in attribute.reserved:
            raise self.fault(at, label, f'"{text}" is reserved; choose another', "reserved-name")
        if isinstance(meant, bool) and meant is not value:
            what = f"write {spelled(meant)}, without quotes"
            raise self.fault(at, label, what, "wrong-shape")

    def interfaces(self, owner: str, items: Any) -> dict[str, Interface]:
        if not isinstance(items or {}, dict):
            what = f"{items!r} must be a mapping of interface kinds"
            raise self.fault("", owner, what, "wrong-shape")
        return {str(kind): self.interface(kind, item) for kind, item in (items or {}).items()}

    def interface(self, kind: Located, item: Any) -> Interface:
        """Read an interface kind, which is a list of attributes or a mapping that has one."""
        self.check_name(kind, "interface kinds")
        self.places[kind] = kind.place
        item = {"attributes": item} if isinstance(item, list) else item
        if not isinstance(item, dict) or not set(item) <= {*_INTERFACE_KEYS}:
            keys = ", ".join(_INTERFACE_KEYS)
            what = f"must be a list of attributes, or a mapping of {keys}"
            raise self.fault(kind, kind, what, "wrong-shape")
        inside = self.interfaces(kind, item.get("interface"))
        attributes = self.attributes(kind, item.get("attributes", []))
        options = {key: item[key] for key in _INTERFACE_KEYS[1:-1] if key in item}
        if isinstance(options.get("requires"), str):
            options["requires"] = [options["requires"]]
        for key, value in options.items():
            self.check_shape(kind, f"{kind}: {key}", value, _INTERFACE_SHAPES[key])
        return Interface(str(kind), attributes, interfaces=inside, **plain(options))

    def scope(self, label: Located, item: Any, known: Set[str]) -> Scope:
        """Read where names land: a mapping from tags to the names that they make there."""
        place = f"names: {label}"
        own = ("in", "ignore_case", "ros", "parts", "because", "reserved")
        if not isinstance(item, dict) or not all(
            isinstance(forms, list) for key, forms in item.items() if key not in own[:5]
        ):
            what = "must be a mapping with lists of names, or in and a tag"
            raise self.fault(label, place, what, "wrong-shape")
        made_by = {tag: forms for tag, forms in item.items() if tag not in own}
        owners = item.get("in", Located(PACKAGE))
        owners = owners if isinstance(owners, list) else [owners]
        for word, forms in item.items():
            if word not in own[:5]:
                self.check_shape(word, f"{place}: {word}", forms, list[str])
        self.check_shape(label, f"{place}: in", owners, list[str])
        self.check_keys(place, {**made_by, **dict.fromkeys(owners)}, known)
        if item.get("ros") not in (None, 1, 2) or item.get("ignore_case") not in (
            None,
            True,
            False,
        ):
            what = "ros must be 1 or 2, ignore_case true or false"
            raise self.fault(label, place, what, "wrong-shape")
        for word in item.get("reserved", []):
            if word.startswith("a "):
                self.check_word(word, place, "meaning of words", meanings())
            else:
                self.check_pattern(word, place, re.sub(r"\{\w[^{}]*\}", "x", word))
        for key in ("parts", "because"):
            self.check_shape(label, f"{place}: {key}", item.get(key, ""), str)
        options = {key: item[key] for key in own[1:] if key in item}
        made = plain({"label": label, "owners": owners, "made_by": made_by, **options})
        return Scope(**made, said_at=label.place)

    def check_inside(
        self, owner: str, kind: Component | Interface, keys: Set[str] = frozenset()
    ) -> None:
        """Check what stands inside of a component or an interface against its attributes."""
        inside = kind.interfaces.values()
        self.check_hidden(owner, kind.attributes, {each.key for each in inside} | keys)
        for each in inside:
            for name in set(each.requires) - set(kind.attributes):
                hint = f"<{owner}>; {allowed(name, kind.attributes)}"
                what = f'requires "{name}", which is no attribute of {hint}'
                raise self.fault("", each.kind, what, "unknown-word")
            if not each.attributes and not each.once:
                what = "has no attributes to tell one from another; it needs once"
                raise self.fault("", each.kind, what, "missing-key")
            self.check_inside(each.kind, each)

    def check_hidden(
        self, owner: str, attributes: Mapping[str, Attribute], keys: Set[str]
    ) -> None:
        """Refuse an attribute that would hide a key the context needs, or that Jinja hides."""
        for name in (keys | HIDDEN_KEYS | {WAS}) & set(attributes):
            what = f'the context needs the key "{name}"; rename it'
            raise self.fault("", owner, what, "reserved-name")

    def check_keys(
        self, label: str, mapping: Mapping[str, Any], known: Set[str], told: Set[str] | None = None
    ) -> None:
        for key in mapping:
            if key not in known:
                hint = allowed(key, sorted(told or known))
                raise self.fault(key, label, f'unknown key "{key}"; {hint}', "unknown-key")

    def check_name(self, name: str, label: str) -> None:
        if not isinstance(name, Located) or not _NAME.fullmatch(name):
            what = f"{name!r} is no name; allowed: letters, digits and underscores, a letter first"
            raise self.fault(name, label, what, "invalid-name")

    def check_word(
        self, at: str, label: str, what: str, known: Iterable[str], word: str | None = None
    ) -> None:
        word = str(at) if word is None else word
        if word not in known:
            what = f'unknown {what} "{word}"; {allowed(word, known)}'
            raise self.fault(at, label, what, "unknown-word")

    def check_pattern(self, at: str, label: str, pattern: str) -> None:
        try:
            re.compile(pattern)
        except re.error as error:
            what = f"{pattern!r} is no regular expression: {error}"
            raise self.fault(at, label, what, "not-a-pattern") from None

    def check_shape(self, at: str, label: str, value: Any, shape: Any, more: str = "") -> None:
        if not _fits(value, shape):
            raise self.fault(at, label, f"{value!r} must be {more}{_shown(shape)}", "wrong-shape")

    def fault(self, at: Any, label: str, what: str, id_: str) -> SpecError:
        """Return a fault, with the place of a text or of what the label names."""
        place = getattr(at, "place", None) or self.places.get(label, self.file)
        return SpecError(": ".join(filter(None, (place, label, what))), id_)


_INTERFACE_KEYS = (
    "attributes",
    "doc",
    "elsewhere",
    "requires",
    "once",
    "least",
    "most",
    "takes",
    "interface",
)
_SHAPES = typing.get_type_hints(Attribute)
_INTERFACE_SHAPES = typing.get_type_hints(Interface)
_WORDS = {
    str: "a text",
    bool: "true or false",
    int: "a whole number",
    float: "a number",
    list: "a list",
    Mapping: "a mapping",
}


def _fits(value: Any, shape: Any) -> bool:
    """Tell whether a value of YAML is of a type."""
    if shape in (str, bool):  # nearly all: `typing` takes its time
        return isinstance(value, shape)
    origin, parts = typing.get_origin(shape), typing.get_args(shape)
    if shape is Any:
        return True
    if origin in (typing.Union, types.UnionType):
        return any(_fits(value, part) for part in parts)
    if origin is list:
        return isinstance(value, list) and all(_fits(item, parts[0]) for item in value)
    if origin is Mapping:
        pairs = value.items() if isinstance(value, dict) else [(None, None)]
        return all(_fits(key, parts[0]) and _fits(item, parts[1]) for key, item in pairs)
    if shape is float:
        return isinstance(value, int | float) and not isinstance(value, bool)
    return isinstance(value, shape)


def _shown(shape: Any) -> str:
    """Say what a value must be."""
    parts = typing.get_args(shape)
    if typing.get_origin(shape) in (typing.Union, types.UnionType):
        return " or ".join(_shown(part) for part in parts if part is not types.NoneType)
    last: Any = parts[-1] if parts else None
    inside = {str: " of texts", list: " to lists"}.get(typing.get_origin(last) or last, "")
    return _WORDS[typing.get_origin(shape) or shape] + inside
