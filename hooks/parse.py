"""Read the XML of a spec into elements that know the line they stand on."""

from __future__ import annotations

from dataclasses import dataclass, field
from xml.parsers import expat

from .faults import SpecError


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
        shown = [f' {name}="{value}"' for name, value in self.attributes.items()]
        return f"<{self.tag}{''.join(shown[:1])}>"


def parse(xml: bytes, file: str) -> Element:
    """Return the outermost element.

    Raises:
        SpecError: the text is not well-formed XML in UTF-8, or it declares entities.

    """
    root = Element("", {}, 0)
    path = [root]
    parser = expat.ParserCreate()

    def start(tag: str, attributes: dict[str, str]) -> None:
        path.append(Element(tag, attributes, parser.CurrentLineNumber))
        path[-2].children.append(path[-1])

    def entity(*_: object) -> None:
        line = parser.CurrentLineNumber
        raise SpecError(f"{file}:{line}: entities are disabled; write the text itself")

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: path.pop()
    parser.CharacterDataHandler = lambda text: path[-1].texts.append(text)
    parser.EntityDeclHandler = entity
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
    except ValueError as error:
        line = parser.CurrentLineNumber
        raise SpecError(f"{file}:{line}: {error}; write the text itself") from None
    return root.children[0]
