"""The dictionary of a model: which tags and attributes its specs may use.

The form is that of Figure 4 of the paper; an attribute or an interface kind may also be a
mapping, which says more than a name. docs/designers describes it.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import yaml

from .collisions import Scope
from .faults import SpecError, allowed
from .formats import FORMATS

PACKAGE = "package"
DEPEND = "depend"
WAS = "was"
RESERVED_KEYS = frozenset({"ros", "kinds", "depends", "notes"})
"""The keys of the context that the hook itself adds to the attributes of the package."""
COMPONENT_KEYS = frozenset({"tag", "class_name"})
"""The keys that the hook itself adds to the attributes of a component."""


@dataclass(frozen=True)
class Attribute:
    """One attribute of a tag, and what its value must be."""

    name: str
    doc: str = ""
    optional: bool = False
    default: Any = None
    format: str = "text"
    of: str | None = None
    choices: Mapping[str, list[str]] = field(default_factory=dict)
    pattern: str | None = None
    above: float | None = None
    minimum: float | str | None = None
    maximum: float | str | None = None
    when: Mapping[str, list[str]] = field(default_factory=dict)
    unique: bool | str = False
    reserved: list[str] = field(default_factory=list)
    ignored: bool = False
    example: Any = ""


NAME_BEFORE = Attribute(WAS, "the name before, so that the code of a renamed one is kept")
"""The attribute that the package, every component and every interface may have."""


@dataclass(frozen=True)
class Interface:
    """One interface kind: its attributes and what it is for."""

    kind: str
    attributes: Mapping[str, Attribute]
    doc: str = ""
    requires: str | None = None

    @property
    def key(self) -> str:
        """Where the context keeps the interfaces of this kind: `publishers`."""
        return self.kind + "s"


@dataclass(frozen=True)
class Component:
    """One component tag, such as the paper's node: its attributes and interface kinds."""

    tag: str
    attributes: Mapping[str, Attribute]
    interfaces: Mapping[str, Interface]

    @property
    def key(self) -> str:
        """Where the context keeps the components of this tag: `nodes`."""
        return self.tag + "s"


@dataclass(frozen=True)
class Dictionary:
    """All a model allows in a spec."""

    package: Mapping[str, Attribute]
    components: Mapping[str, Component]
    aliases: Mapping[str, str]
    skeleton: list[str]
    scopes: list[Scope]


_KEYS = {"package_attributes", "aliases", "skeleton", "names", "definitions", "include"}


def load(file: Path, root: Path) -> Dictionary:
    """Read a `dictionary.yaml`; what it includes is looked for below `root`.

    Raises:
        SpecError: the file is not YAML or says what no dictionary can say.

    """
    content = _read(file)
    names = content.get("names") or {}
    while isinstance(content.get("include"), str):
        included = _read(root / content.pop("include"))
        names = {**included.get("names", {}), **names}
        content = {**included, **content}
    tags = [key.removesuffix("_interface") for key in content if key.endswith("_interface")]
    own = {f"{tag}_{part}" for tag in tags for part in ("attributes", "interface")}
    forms = {"<component>_attributes", "<component>_interface"}
    _check_keys(str(file), content, _KEYS | own, own | _KEYS | forms)
    dictionary = Dictionary(
        _attributes(f"{file}: {PACKAGE}", content.get("package_attributes") or ["name"]),
        {
            tag: Component(
                tag,
                _attributes(f"{file}: {tag}", content.get(f"{tag}_attributes") or ["name"]),
                {
                    kind: _interface(f"{file}: {kind}", kind, item)
                    for kind, item in (content[f"{tag}_interface"] or {}).items()
                },
            )
            for tag in tags
        },
        content.get("aliases") or {},
        content.get("skeleton") or [],
        [_scope(f"{file}: names: {label}", label, item) for label, item in names.items()],
    )
    components = dictionary.components.values()
    owners = {PACKAGE, *dictionary.components}
    kinds = {kind for component in components for kind in component.interfaces}
    for scope in dictionary.scopes:
        place = f"{file}: names: {scope.label}"
        _check_keys(place, {scope.owner: ()}, owners)
        _check_keys(place, scope.made_by, owners | kinds)
    _check_hidden(file, PACKAGE, dictionary.package, {c.key for c in components} | RESERVED_KEYS)
    for component in components:
        keys = {interface.key for interface in component.interfaces.values()} | COMPONENT_KEYS
        _check_hidden(file, component.tag, component.attributes, keys)
        for kind in component.interfaces.values():
            if kind.requires and kind.requires not in component.attributes:
                hint = f"<{component.tag}>; {allowed(kind.requires, component.attributes)}"
                word = f'requires "{kind.requires}", which is no attribute of'
                raise SpecError(f"{file}: {kind.kind}: {word} {hint}")
    return dictionary


def _read(file: Path) -> dict[str, Any]:
    try:
        content = yaml.safe_load(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise SpecError(f"{file}: no such file; a model needs it") from None
    except yaml.YAMLError as error:
        raise SpecError(f"{file}: not YAML: {error}") from None
    if not isinstance(content, dict):
        raise SpecError(f"{file}: must be a mapping with package_attributes and <tag>_interface")
    return content


def _interface(place: str, kind: str, item: Any) -> Interface:
    """Read an interface kind, which is a list of attributes or a mapping that has one."""
    item = {"attributes": item} if isinstance(item, list) else item
    if not isinstance(item, dict) or not set(item) <= {"attributes", "doc", "requires"}:
        raise SpecError(f"{place}: must be a list of attributes, or attributes, doc and requires")
    return Interface(
        kind, **{**item, "attributes": _attributes(place, item.get("attributes", []))}
    )


def _scope(place: str, label: str, item: Any) -> Scope:
    """Read where names land, which is a mapping from tags to the names that they make there."""
    if not isinstance(item, dict) or not all(
        isinstance(forms, list) for key, forms in item.items() if key != "in"
    ):
        raise SpecError(f"{place}: must be a mapping with lists of names, or in and a tag")
    made_by = {tag: forms for tag, forms in item.items() if tag not in ("in", "reserved")}
    return Scope(label, item.get("in", PACKAGE), made_by, item.get("reserved", []))


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
    return Attribute(name, **{"optional": "default" in options, **options})


def _check_keys(
    place: str, mapping: Mapping[str, Any], known: set[str], told: set[str] | None = None
) -> None:
    for key in mapping:
        if key not in known:
            hint = allowed(str(key), sorted(told or known))
            raise SpecError(f'{place}: unknown key "{key}"; {hint}')


def _check_hidden(
    file: Path, owner: str, attributes: Mapping[str, Attribute], keys: Set[str]
) -> None:
    """Refuse an attribute that would hide a key the context needs."""
    for name in keys & set(attributes):
        raise SpecError(f'{file}: {owner}: the context needs the key "{name}"; rename it')
