"""Read the XML of a spec into elements that know the line they stand on."""

from __future__ import annotations

from dataclasses import dataclass, field
from xml.parsers import expat

from .faults import SpecError, quoted, shown


@dataclass(eq=False)
class Element:
    """An XML element, and the line it starts on."""

    tag: str
    attributes: dict[str, str]
    line: int
    children: list[Element] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)

    @property
    def text(self) -> str:
        """The text between the tags, stripped."""
        return "".join(self.texts).strip()

    @property
    def label(self) -> str:
        """The element as the user wrote it, with its first attribute alone."""
        first = [f' {shown(name)}="{shown(value)}"' for name, value in self.attributes.items()][:1]
        return f"<{shown(self.tag)}{''.join(first)}>"


def parse(xml: bytes, file: str) -> Element:
    """Return the outermost element.

    Raises:
        SpecError: the text is not well-formed XML in UTF-8, or it declares entities.

    """
    root = Element("", {}, 0)
    path = [root]
    parser = expat.ParserCreate("UTF-8")

    def start(tag: str, attributes: dict[str, str]) -> None:
        path.append(Element(tag, attributes, parser.CurrentLineNumber))
        path[-2].children.append(path[-1])

    def declaration(version: str, encoding: str | None, standalone: int) -> None:
        if encoding and encoding.upper() not in ("UTF-8", "UTF8", "ASCII", "US-ASCII"):
            refuse(f"encoding {quoted(encoding)} is not read; save the spec as UTF-8 and say so")

    def doctype(name: str, system: str | None, public: str | None, internal: bool) -> None:
        if system:
            refuse(f"a DOCTYPE in another file, {quoted(system)}, is not read; drop it")

    def refuse(fault: str) -> None:
        raise SpecError(f"{file}:{parser.CurrentLineNumber}: {fault}")

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: path.pop()
    parser.CharacterDataHandler = lambda text: path[-1].texts.append(text)
    parser.XmlDeclHandler = declaration
    parser.EntityDeclHandler = lambda *_: refuse("entities are disabled; write the text itself")
    parser.StartDoctypeDeclHandler = doctype
    try:
        xml.decode("utf-8-sig")
        parser.Parse(xml, True)
    except UnicodeDecodeError:
        raise SpecError(f"{file}:1: not UTF-8 text; save the spec as UTF-8") from None
    except expat.ExpatError as error:
        reason = expat.ErrorString(error.code)
        raise SpecError(
            f"{file}:{error.lineno}: not well-formed XML: {reason} (column {error.offset + 1})"
        ) from None
    return root.children[0]
