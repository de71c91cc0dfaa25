"""Write the spec a package starts with, every tag and attribute taken from the dictionary."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import replace
from string import Template
from xml.sax.saxutils import quoteattr

from .dictionary import DEPEND, DEPEND_KIND, PACKAGE, Attribute, Component, Dictionary, Interface
from .literals import spelled
from .ros import DEPENDENCY_KINDS

SCHEMA = "ros_package.xsd"
"""The file beside a spec by which editors complete it; see `hooks.schema`."""
XSD = "http://www.w3.org/2001/XMLSchema"
HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>',
    f'<?xml-model href="{SCHEMA}" schematypens="{XSD}"?>',
)
"""The first lines of a spec."""
_WIDTH = 96
KIND_OF_DEPENDENCY = Attribute(
    DEPEND_KIND, choices=dict.fromkeys(DEPENDENCY_KINDS, []), optional=True
)
"""The one attribute that a dependency may have."""


def skeleton(dictionary: Dictionary, sources: Mapping[str, str]) -> str:
    """Return the XML of a small spec that works, with the rest of the kinds as comments.

    `$word` in an example of the package's attributes stands for what `sources` has for the word.
    """
    package = [
        replace(one, example=Template(str(one.example)).safe_substitute(sources))
        for one in dictionary.package.values()
    ]
    lines = [
        *HEAD,
        *_comment(
            "This file describes the package: change it, commit, run copier update.", "", package
        ),
        *_tag(PACKAGE, package, "", ">"),
    ]
    told: list[Interface] = []
    for component in dictionary.needed:
        lines += _component(component, dictionary, told)
    hint = "A package that no interface above names:"
    lines += ["", *_comment(hint, "  ", [KIND_OF_DEPENDENCY])]
    lines += [f"  <!-- <{DEPEND}>package_name</{DEPEND}> -->"]
    for component in dictionary.components.values():
        if component.is_optional:
            attributes = component.attributes.values()
            lines += ["", *_comment(_title(component, dictionary), "  ", attributes)]
            lines += _tag(component.tag, attributes, "  <!-- ", "/> -->")
    return "\n".join([*lines, f"</{PACKAGE}>", ""])


def _title(component: Component, dictionary: Dictionary) -> str:
    """Return the tag of a component; of one that others take, also by what these do so."""
    takers = [
        f"each <{other.tag}> that has <{kind.kind}>"
        for other in dictionary.components.values()
        for kind in other.interfaces.values()
        if kind.taken == component.tag
    ]
    said = f": what stands in it is in {', '.join(takers)}" if takers else ""
    return f"{component.tag}{said}"


def _component(component: Component, dictionary: Dictionary, told: list[Interface]) -> list[str]:
    return [
        *_comment(component.tag, "  ", component.attributes.values()),
        *_tag(component.tag, component.attributes.values(), "  ", ">"),
        *_kinds(component, dictionary, "    ", told),
        f"  </{component.tag}>",
    ]


def _kinds(
    owner: Component | Interface, dictionary: Dictionary, indent: str, told: list[Interface]
) -> list[str]:
    """Write an example of each kind, after a comment; what `told` has already, says no more."""
    lines: list[str] = []
    others: list[str] = []
    for kind in owner.interfaces.values():
        title = f"{kind.kind}: {kind.doc}" if kind.doc else kind.kind
        is_told = kind in told
        comment = [] if is_told else _comment(title, indent, kind.attributes.values())
        told.append(kind)
        if kind.kind in dictionary.skeleton:
            inside = _kinds(kind, dictionary, indent + "  ", told)
            lines += [*comment, *_example(kind, indent, inside)]
        elif not is_told:
            example = _example(kind, indent, _examples(kind, indent + "  "), "<!-- ")
            example[-1] += " -->"
            others += ["", *comment, *example]
    if others:
        hint = "The other interface kinds, to uncomment where needed."
        lines += ["", *_comment(hint, indent)]
    return [*lines, *others]


def _examples(owner: Interface, indent: str) -> list[str]:
    """Write an example of each kind inside of an interface, without comments."""
    return [
        line
        for kind in owner.interfaces.values()
        for number in range(max(1, kind.least))
        for line in _example(_numbered(kind, number), indent, _examples(kind, indent + "  "))
    ]


def _numbered(kind: Interface, number: int) -> Interface:
    """Return a kind whose example has a name of its own, where there are several."""
    if not number or not kind.naming:
        return kind
    name = kind.attributes[kind.naming]
    other = replace(name, example=f"{name.example}_{number + 1}")
    return replace(kind, attributes={**kind.attributes, kind.naming: other})


def _example(kind: Interface, indent: str, inside: list[str], start: str = "") -> list[str]:
    """Write one element; `start` is what begins a comment, where it is one."""
    attributes = kind.attributes.values()
    if not inside:
        return _tag(kind.kind, attributes, indent + start, "/>")
    first = _tag(kind.kind, attributes, indent + start, ">")
    return [*first, *inside, f"{indent}</{kind.kind}>"]


def _comment(title: str, indent: str, attributes: Iterable[Attribute] = ()) -> list[str]:
    """Write a comment: a title, and below it what each attribute means."""
    shown = [attribute for attribute in attributes if not attribute.ignored]
    width = max((len(attribute.name) for attribute in shown), default=0) + 2
    lines = [f"{indent}<!-- {_inside(title)}"]
    for attribute in shown:
        lines += textwrap.wrap(
            attribute.name.ljust(width) + _inside(meaning(attribute)),
            _WIDTH,
            initial_indent=indent + " " * 7,
            subsequent_indent=indent + " " * (7 + width),
            break_long_words=False,
        )
    lines[-1] += " -->"
    return lines


def meaning(attribute: Attribute) -> str:
    """Return what an attribute means, which words it may be, and what it is without a value."""
    words = [attribute.doc] if attribute.doc else []
    if attribute.choices:
        words.append("one of " + ", ".join(attribute.choices))
    if attribute.refers_to:
        words.append(f"the name of a {attribute.refers_to}")
    if attribute.same_as:
        words.append(f"default {attribute.same_as}")
    elif attribute.optional:
        default = attribute.default
        words.append("optional" if default in (None, "") else f"default {spelled(default)}")
    return "; ".join(words)


def _inside(text: str) -> str:
    """Make a text fit for a comment, where XML allows no double hyphen."""
    return text.replace("--", "- -")


def _tag(tag: str, attributes: Iterable[Attribute], indent: str, end: str) -> list[str]:
    """Write a tag with an example for each attribute."""
    examples = {}
    for attribute in attributes:
        example = str(attribute.example)
        if (example or not attribute.optional) and not attribute.ignored:
            examples[attribute.name] = example or attribute.name
    return tag_lines(tag, examples, indent, end)


def tag_lines(tag: str, attributes: Mapping[str, str], indent: str, end: str) -> list[str]:
    """Write a tag with its attributes, one a line if they are long."""
    parts = [f"{name}={quoteattr(value)}" for name, value in attributes.items()]
    line = f"{indent}<{' '.join([tag, *parts])}{end}"
    if len(line) <= _WIDTH + 4 or not parts:
        return [line]
    gap = " " * (len(indent) + len(tag) + 2)
    first, *others = parts
    lines = [f"{indent}<{tag} {first}", *(gap + part for part in others)]
    lines[-1] += end
    return lines
