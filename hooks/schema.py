"""Write the XML schema (XSD 1.0) of a dictionary, by which editors complete and check a spec.

It accepts whatever the hook accepts, and leaves to the hook what a schema cannot say in short:
formats, names that are taken, how often there is something, what one attribute means for another
(decision 98).
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from xml.parsers import expat
from xml.sax.saxutils import escape, quoteattr

from .dictionary import DEPEND, NAME_BEFORE, PACKAGE, Attribute, Component, Dictionary, Interface
from .formats import BOOLEANS
from .literals import spelled
from .skeleton import KIND_OF_DEPENDENCY, SCHEMA, XSD, meaning

_HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<!-- Generated from the dictionary of the model: by it editors complete and check a spec. -->
"""
_BOOLEANS = "|".join(
    "".join(f"[{c}{c.upper()}]" if c.isalpha() else c for c in word) for word in BOOLEANS
)
_SIMPLE_TYPES = {
    "blank": """\
<!-- Blanks and comments, which an element of an empty type could not have inside. -->
<xs:simpleType name="blank">
  <xs:restriction base="xs:token"><xs:pattern value=""/></xs:restriction>
</xs:simpleType>
""",
    "bool": f"""\
<xs:simpleType name="bool">
  <xs:union memberTypes="xs:boolean">
    <xs:simpleType>
      <xs:restriction base="xs:token">
        <xs:pattern value="{_BOOLEANS}"/>
      </xs:restriction>
    </xs:simpleType>
  </xs:union>
</xs:simpleType>
""",
}


def names_schema(xml: bytes) -> bool:
    """Tell whether a spec, which is well-formed, names the schema beside it for editors."""
    names = re.compile(rf"""\bhref\s*=\s*["'](\./)?{re.escape(SCHEMA)}["']""")
    found = False

    def instruction(target: str, data: str) -> None:
        nonlocal found
        found |= target == "xml-model" and bool(names.search(data))

    parser = expat.ParserCreate()
    parser.ProcessingInstructionHandler = instruction
    parser.Parse(xml, True)
    return found


def schema(dictionary: Dictionary) -> str:
    """Return the schema of the specs that a dictionary allows."""
    types = _Types()
    components = dictionary.components
    tags = {**{tag: tag for tag in (*components, DEPEND)}, **dictionary.aliases}
    elements = [
        types.element(tag, components[meant], PACKAGE) if meant in components else _depend(tag)
        for tag, meant in tags.items()
    ]
    needs_one = not all(component.is_plain for component in components.values())
    attributes = [*dictionary.package.values(), NAME_BEFORE]
    package = _tag("complexType", _content(attributes, elements, least=int(needs_one)))
    text = _tag("element", package, name=PACKAGE) + types.text()
    for name, type_ in _SIMPLE_TYPES.items():
        text += type_ if re.search(f'(base|type)="{name}"', text) else ""
    return _HEAD + _tag("schema", text, **{"xmlns:xs": XSD})


class _Types:
    """The types of elements; those that say the same are one."""

    def __init__(self) -> None:
        self.contents = dict.fromkeys(_SIMPLE_TYPES, "")
        """What each says, by its name, in the order of the dictionary."""

    def text(self) -> str:
        named = [(name, content) for name, content in self.contents.items() if content]
        return "".join(_tag("complexType", content, name=name) for name, content in named)

    def element(self, tag: str, kind: Component | Interface, owner: str) -> str:
        """Return the element of a component or an interface kind, and keep its type."""
        name = tag if tag not in self.contents else f"{owner}.{tag}"
        self.contents[name] = ""
        elements = [self.element(each.kind, each, name) for each in kind.interfaces.values()]
        attributes = [*kind.attributes.values(), *([NAME_BEFORE] if kind.can_be_renamed else [])]
        content = _content(attributes, elements)
        same = [known for known, other in self.contents.items() if other == content]
        if not same:
            self.contents[name] = content
        doc = kind.doc if isinstance(kind, Interface) else ""
        return _tag("element", _note(doc), name=tag, type=(same or [name])[0])


def _depend(tag: str) -> str:
    """Return the element of a dependency."""
    type_ = _tag("complexType", _text("xs:token", [KIND_OF_DEPENDENCY]))
    return _tag("element", _note("a package that no interface names") + type_, name=tag)


def _content(attributes: Iterable[Attribute], elements: list[str], least: int = 0) -> str:
    """Return the content of a type: elements in any order, and attributes."""
    if not elements:
        return _text("blank", attributes)
    number = {"minOccurs": str(least)} if least != 1 else {}
    choice = _tag("choice", "".join(elements), **number, maxOccurs="unbounded")
    return choice + "".join(map(_attribute, attributes))


def _text(base: str, attributes: Iterable[Attribute]) -> str:
    """Return the content of a type with text of some type inside."""
    return _pair("simpleContent", "extension", base, "".join(map(_attribute, attributes)))


def _attribute(attribute: Attribute) -> str:
    if attribute.ignored:
        return _tag("attribute", name=attribute.name)
    options = {"name": attribute.name}
    if not attribute.optional:
        options["use"] = "required"
    elif attribute.default not in (None, "") and not attribute.same_as:
        options["default"] = spelled(attribute.default)
    inside = _note(meaning(attribute))
    if attribute.choices:
        words = [word for one, others in attribute.choices.items() for word in (one, *others)]
        values = "".join(_tag("enumeration", value=word) for word in words)
        inside += _pair("simpleType", "restriction", "xs:token", values.replace("\n", ""))
    elif attribute.format == "bool":
        options.update(type="bool")
    return _tag("attribute", inside, **options)


def _note(doc: str) -> str:
    note = f"<xs:documentation>{escape(doc)}</xs:documentation>"
    return f"<xs:annotation>{note}</xs:annotation>\n" if doc else ""


def _pair(outer: str, inner: str, base: str, inside: str) -> str:
    """Return an element with one inside that is based on a type."""
    start, end = f'<xs:{outer}><xs:{inner} base="{base}">', f"</xs:{inner}></xs:{outer}>"
    return f"{start}{_within(inside)}{end}\n"


def _tag(tag: str, inside: str = "", /, **attributes: str) -> str:
    """Return an element of the schema, in lines."""
    given = "".join(f" {key}={quoteattr(value)}" for key, value in attributes.items())
    if not inside:
        return f"<xs:{tag}{given}/>\n"
    return f"<xs:{tag}{given}>{_within(inside)}</xs:{tag}>\n"


def _within(inside: str) -> str:
    """Lay out what is within an element: a line of it on the line of the element."""
    return inside.strip() if inside.count("\n") < 2 else f"\n{_indented(inside)}"


def _indented(lines: str) -> str:
    return "  " + lines[:-1].replace("\n", "\n  ") + "\n" if lines else ""
