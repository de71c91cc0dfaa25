"""The dictionary of a model: which tags and attributes its specs may use.

The form is that of Figure 4 of the paper; an attribute or an interface kind may also be a
mapping, which says more than a name. docs/designers describes it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import yaml

from .collisions import Scope
from .data import load_yaml
from .faults import SpecError, allowed
from .formats import FORMATS

PACKAGE = "package"
DEPEND = "depend"
DEPEND_KIND = "kind"
WAS = "was"
RESERVED_KEYS = frozenset({"ros", "kinds", "declared", "depends", "other_depends", "notes"})
"""The keys of the context that the hook itself adds to the attributes of the package."""
COMPONENT_KEYS = frozenset({"tag", "class_name"})
"""The keys that the hook itself adds to the attributes of a component."""


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
    as_written: bool = False
    choices: Mapping[str, list[str]] = field(default_factory=dict)
    pattern: str | None = None
    above: float | None = None
    minimum: float | str | None = None
    maximum: float | str | None = None
    when: Mapping[str, list[str]] = field(default_factory=dict)
    unique: bool | str = False
    declares: str | None = None
    reserved: list[str] = field(default_factory=list)
    ignored: bool = False
    example: Any = ""


NAME_BEFORE = Attribute(WAS, "the name before, so that the code of a renamed one is kept")
"""The attribute that the package, every component and every interface with a name may have."""


@dataclass(frozen=True)
class Interface:
    """One interface kind: its attributes, what it is for, and the kinds inside of it."""

    kind: str
    attributes: Mapping[str, Attribute]
    doc: str = ""
    requires: str | None = None
    once: bool = False
    interfaces: Mapping[str, Interface] = field(default_factory=dict)

    @property
    def naming(self) -> str | None:
        """The attribute that names one: the first, but none where there is one at most."""
        return None if self.once else next(iter(self.attributes))

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
    """It says more of the package, and has no interface: the package needs none."""

    @property
    def naming(self) -> str | None:
        """The attribute that names one: the first."""
        return next(iter(self.attributes))

    @property
    def key(self) -> str:
        """Where the context keeps the components of this tag: `nodes`."""
        return self.tag + "s"

    def of(self, package: Mapping[str, Any]) -> list[Any]:
        """Return the components of this tag that a package has in the context."""
        return list(package.get(self.key, []))


def nested(interfaces: Mapping[str, Interface]) -> Iterator[Interface]:
    """Yield interface kinds, each followed by those inside of it."""
    for interface in interfaces.values():
        yield interface
        yield from nested(interface.interfaces)


@dataclass(frozen=True)
class Dictionary:
    """All a model allows in a spec."""

    package: Mapping[str, Attribute]
    components: Mapping[str, Component]
    aliases: Mapping[str, str]
    skeleton: list[str]
    scopes: list[Scope]
    files: list[Path]
    """Where all of this is said: each dictionary after those that it includes."""


_KEYS = {"package_attributes", "aliases", "skeleton", "names", "definitions", "include"}


def load(file: Path, root: Path) -> Dictionary:
    """Read a `dictionary.yaml`; what it includes is looked for below `root`.

    Raises:
        SpecError: the file is not YAML or says what no dictionary can say.

    """
    files: list[Path] = []
    content = _read(file, root, files)
    names = content.get("names") or {}
    own = {key for key in content if re.fullmatch(r"(?!package_)\w+_(attributes|interface)", key)}
    tags = list(dict.fromkeys(key.rpartition("_")[0] for key in content if key in own))
    forms = {"<component>_attributes", "<component>_interface"}
    _check_keys(str(file), content, _KEYS | own, own | _KEYS | forms)
    dictionary = Dictionary(
        _attributes(f"{file}: {PACKAGE}", content.get("package_attributes") or ["name"]),
        {
            tag: Component(
                tag,
                _attributes(f"{file}: {tag}", content.get(f"{tag}_attributes") or ["name"]),
                _interfaces(str(file), content.get(f"{tag}_interface")),
                is_plain=f"{tag}_interface" not in content,
            )
            for tag in tags
        },
        content.get("aliases") or {},
        content.get("skeleton") or [],
        [_scope(f"{file}: names: {label}", label, item) for label, item in names.items()],
        files,
    )
    components = dictionary.components.values()
    owners = {PACKAGE, *dictionary.components}
    owners |= {each.kind for component in components for each in nested(component.interfaces)}
    for scope in dictionary.scopes:
        place = f"{file}: names: {scope.label}"
        _check_keys(place, {**dict.fromkeys(scope.owners), **scope.made_by}, owners)
    _check_hidden(file, PACKAGE, dictionary.package, {c.key for c in components} | RESERVED_KEYS)
    for component in components:
        keys = frozenset() if component.is_plain else COMPONENT_KEYS
        _check_inside(file, component.tag, component, keys)
    return dictionary


def _read(file: Path, root: Path, files: list[Path]) -> dict[str, Any]:
    """Return what a dictionary says, added to what those that it includes say; note its file."""
    content = _mapping(file)
    included: dict[str, Any] = {}
    names = content.pop("include", None) or []
    for name in names if isinstance(names, list) else [names]:
        included = _added(included, _read(root / str(name), root, files))
    files.append(file)
    return dict(_added(included, content))


def _added(first: Any, second: Any) -> Any:
    """Return both, of mappings and lists; of what can only be one thing, the second."""
    if isinstance(first, dict) and isinstance(second, dict):
        common = {key: _added(first[key], second[key]) for key in first.keys() & second.keys()}
        return {**first, **second, **common}
    if isinstance(first, list) and isinstance(second, list):
        return [*first, *(item for item in second if item not in first)]
    return second


def _mapping(file: Path) -> dict[str, Any]:
    try:
        content = load_yaml(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise SpecError(f"{file}: no such file; a model needs it") from None
    except yaml.YAMLError as error:
        raise SpecError(f"{file}: not YAML: {error}") from None
    if not isinstance(content, dict):
        raise SpecError(f"{file}: must be a mapping with package_attributes and <tag>_interface")
    return content


def _interfaces(file: str, items: Any) -> dict[str, Interface]:
    if not isinstance(items or {}, dict):
        raise SpecError(f"{file}: {items!r} must be a mapping of interface kinds")
    return {kind: _interface(file, kind, item) for kind, item in (items or {}).items()}


_INTERFACE_KEYS = ("attributes", "doc", "requires", "once", "interface")


def _interface(file: str, kind: str, item: Any) -> Interface:
    """Read an interface kind, which is a list of attributes or a mapping that has one."""
    place = f"{file}: {kind}"
    item = {"attributes": item} if isinstance(item, list) else item
    if not isinstance(item, dict) or not set(item) <= {*_INTERFACE_KEYS}:
        keys = ", ".join(_INTERFACE_KEYS)
        raise SpecError(f"{place}: must be a list of attributes, or a mapping of {keys}")
    inside = _interfaces(file, item.get("interface"))
    attributes = _attributes(place, item.get("attributes", []))
    options = {key: item[key] for key in ("doc", "requires", "once") if key in item}
    return Interface(kind, attributes, interfaces=inside, **options)


def _scope(place: str, label: str, item: Any) -> Scope:
    """Read where names land, which is a mapping from tags to the names that they make there."""
    own = ("in", "ignore_case", "ros", "parts", "reserved")
    if not isinstance(item, dict) or not all(
        isinstance(forms, list) for key, forms in item.items() if key not in own[:4]
    ):
        raise SpecError(f"{place}: must be a mapping with lists of names, or in and a tag")
    made_by = {tag: forms for tag, forms in item.items() if tag not in own}
    owners = item.get("in", PACKAGE)
    owners = owners if isinstance(owners, list) else [owners]
    options = {key: item[key] for key in own[1:] if key in item}
    return Scope(label, owners, made_by, **options)


def _attributes(place: str, items: Any) -> dict[str, Attribute]:
    if not isinstance(items, list):
        raise SpecError(f"{place}: the attributes must be a list")
    attributes: dict[str, Attribute] = {}
    for item in items:
        item = {item: {}} if isinstance(item, str) else item
        if not isinstance(item, dict):
            raise SpecError(f"{place}: {item!r} must be a name or a mapping")
        for name, options in item.items():
            attributes[name] = _attribute(f"{place} {name}", name, dict(options or {}))
    return attributes


def _attribute(place: str, name: str, options: dict[str, Any]) -> Attribute:
    _check_keys(place, options, {item.name for item in fields(Attribute)} - {"name"})
    formats = [*FORMATS, "literal"]
    if options.get("format", "text") not in formats:
        word = str(options["format"])
        raise SpecError(f'{place}: unknown format "{word}"; {allowed(word, formats)}')
    if "choices" in options:
        choices = options["choices"]
        choices = dict.fromkeys(choices) if isinstance(choices, list) else choices
        options["choices"] = {str(word): [*(others or ())] for word, others in choices.items()}
    if isinstance(options.get("elsewhere"), list):
        options["elsewhere"] = dict.fromkeys(options["elsewhere"])
    return Attribute(name, **{"optional": bool({"default", "same_as"} & set(options)), **options})


def _check_keys(
    place: str, mapping: Mapping[str, Any], known: set[str], told: set[str] | None = None
) -> None:
    for key in mapping:
        if key not in known:
            hint = allowed(str(key), sorted(told or known))
            raise SpecError(f'{place}: unknown key "{key}"; {hint}')


def _check_inside(
    file: Path, owner: str, kind: Component | Interface, keys: Set[str] = frozenset()
) -> None:
    """Check what stands inside of a component or an interface against its attributes."""
    inside = kind.interfaces.values()
    _check_hidden(file, owner, kind.attributes, {each.key for each in inside} | keys)
    for each in inside:
        if each.requires and each.requires not in kind.attributes:
            hint = f"<{owner}>; {allowed(each.requires, kind.attributes)}"
            word = f'requires "{each.requires}", which is no attribute of'
            raise SpecError(f"{file}: {each.kind}: {word} {hint}")
        if not each.attributes and not each.once:
            word = "has no attributes to tell one from another; it needs once"
            raise SpecError(f"{file}: {each.kind}: {word}")
        _check_inside(file, each.kind, each)


def _check_hidden(
    file: Path, owner: str, attributes: Mapping[str, Attribute], keys: Set[str]
) -> None:
    """Refuse an attribute that would hide a key the context needs."""
    for name in keys & set(attributes):
        raise SpecError(f'{file}: {owner}: the context needs the key "{name}"; rename it')
