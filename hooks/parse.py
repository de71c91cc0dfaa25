"""Read the XML of a spec into elements that know the line they stand on."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any
from xml.parsers import expat

import xmltodict

from .faults import SpecError


class Element(dict[str, Any]):
    """An XML element as xmltodict gives it, and where it starts in the file."""

    def __init__(self, content: Any = (), line: int = 0, index: int = 0) -> None:
        super().__init__(content)
        self.line = line
        self.index = index

    def __bool__(self) -> bool:
        """Be true without content too: xmltodict drops what is false."""
        return self.line > 0

    @property
    def attributes(self) -> dict[str, str]:
        """The XML attributes in the order of the file."""
        return {key[1:]: value for key, value in self.items() if key.startswith("@")}

    @property
    def text(self) -> str:
        """The text between the tags, stripped."""
        return str(self.get("#text", ""))

    @property
    def children(self) -> list[tuple[str, Element]]:
        """The elements inside, each with its tag, in the order of the file."""
        children = [(tag, child) for tag, found in self._tags() for child in found]
        return sorted(children, key=lambda child: child[1].index)

    def _tags(self) -> Iterator[tuple[str, list[Element]]]:
        return ((tag, found) for tag, found in self.items() if tag[0] not in "@#")


class _Expat:
    """Stand in for the expat module, to keep the parser that xmltodict makes."""

    def __init__(self) -> None:
        self.parser: Any = None

    def ParserCreate(self, *arguments: Any) -> Any:  # noqa: N802 (expat's own name)
        self.parser = expat.ParserCreate(*arguments)
        return self.parser

    def element(self, content: Any = ()) -> Element:
        if self.parser is None:  # xmltodict's own, made before it reads
            return Element(content)
        return Element(content, self.parser.CurrentLineNumber, self.parser.CurrentByteIndex)


def parse(xml: bytes, file: str | os.PathLike[str]) -> tuple[str, Element]:
    """Return the tag and the content of the outermost element.

    Raises:
        SpecError: the text is not well-formed XML, or it declares entities.

    """
    source = _Expat()
    try:
        document = xmltodict.parse(
            xml,
            expat=source,
            dict_constructor=source.element,  # type: ignore[arg-type]
            force_list=lambda path, key, value: key[0] not in "@#",
        )
    except expat.ExpatError as error:
        reason = expat.ErrorString(error.code)
        raise SpecError(
            f"{file}:{error.lineno}: not well-formed XML: {reason} (column {error.offset + 1})"
        ) from None
    except ValueError as error:
        line = source.parser.CurrentLineNumber
        raise SpecError(f"{file}:{line}: {error}; write the text itself") from None
    ((tag, (content,)),) = document.items()
    return tag, content
