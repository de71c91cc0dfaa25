"""Read the XML of a spec into elements that know the line they stand on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, NoReturn
from xml.parsers import expat

import xmltodict

from .faults import SpecError, quoted, shown
from .formats import BLANKS
from .slips import slip

Place = tuple[int, int]
"""The line where an element starts, and its number in the order of the file."""

_NOT_CLOSED = (expat.errors.XML_ERROR_NO_ELEMENTS, expat.errors.XML_ERROR_TAG_MISMATCH)


@dataclass(eq=False)
class Element:
    """An XML element as xmltodict gives it, and where it starts."""

    tag: str
    content: Mapping[str, Any]
    place: Place
    file: str = ""
    """The file where it stands, if a spec has several."""
    taker: Element | None = None
    """What takes it from another element, for one that stands elsewhere, too."""

    @property
    def line(self) -> int:
        """The line on which the element starts."""
        return self.place[0]

    @property
    def where(self) -> str:
        """The line for a message, with that of what takes the element."""
        return f"line {self.line}" + (f", used at line {self.taker.line}" if self.taker else "")

    @property
    def attributes(self) -> dict[str, str]:
        """The XML attributes in the order of the file."""
        return {key[1:]: value for key, value in self.content.items() if key[0] == "@"}

    @property
    def children(self) -> list[Element]:
        """The elements inside, in the order of the file."""
        tags = (found for key, found in self.content.items() if key[0] not in "@#")
        children = sorted((child for found in tags for child in found), key=lambda c: c.place[1])
        return [child.taken_by(self.taker) for child in children] if self.taker else children

    def taken_by(self, taker: Element | None) -> Element:
        """Return the element as another one takes it, apart from what it is where it stands."""
        return replace(self, taker=taker)

    @property
    def text(self) -> str:
        """The text between the tags, stripped."""
        return "".join(self.content.get("#text", ())).strip(BLANKS)

    @property
    def label(self) -> str:
        """The element as the user wrote it, with its first attribute alone."""
        first = [f' {shown(name)}="{shown(value)}"' for name, value in self.attributes.items()][:1]
        return f"<{shown(self.tag)}{''.join(first)}>"


def parse(xml: bytes, file: str) -> Element:
    """Return the outermost element.

    Raises:
        SpecError: the text is not well-formed XML in UTF-8, or it declares entities or a DTD file.

    """
    places = iter(_places(xml, file))

    def element(path: Any, key: str, value: Any) -> tuple[str, Any]:
        return key, value if key[0] in "@#" else Element(key, value or {}, next(places))

    document = xmltodict.parse(
        xml, postprocessor=element, force_list=True, force_cdata=True, strip_whitespace=False
    )
    ((root,),) = document.values()
    return root  # type: ignore[no-any-return]


def _places(xml: bytes, file: str) -> list[Place]:
    """Return the place of each element, in the order they end: what xmltodict does not tell.

    Decision 10: a first pass of expat, which also refuses what no spec has.
    """
    parser = expat.ParserCreate("UTF-8")
    count = 0
    begun: list[tuple[str, Place]] = []
    ended: list[Place] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        begun.append((tag, (parser.CurrentLineNumber, count)))

    def declaration(version: str, encoding: str | None, standalone: int) -> None:
        if encoding and encoding.upper() != "UTF-8":
            what = f"encoding {quoted(encoding)} is not read; save the spec as UTF-8"
            what += ', and write encoding="UTF-8"'
            refuse(what, "not-utf-8")

    def doctype(name: str, system: str | None, public: str | None, internal: bool) -> None:
        if system:
            elsewhere()

    def elsewhere() -> NoReturn:
        refuse("a DOCTYPE with parts in another file is not read; drop it", "declaration-not-read")

    def entity(*_: object) -> NoReturn:
        refuse("entities are disabled; write the text itself", "declaration-not-read")

    def refuse(fault: str, id_: str) -> NoReturn:
        raise SpecError(f"{file}:{parser.CurrentLineNumber}: {fault}", id_)

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: ended.append(begun.pop()[1])
    parser.XmlDeclHandler = declaration
    parser.EntityDeclHandler = entity
    parser.NotStandaloneHandler = elsewhere
    parser.StartDoctypeDeclHandler = doctype
    _check_text(xml, file)
    try:
        parser.Parse(xml, True)
    except expat.ExpatError as error:
        known = expat.ErrorString(error.code)
        reason = f"{known} (column {error.offset + 1})"
        if begun and known in _NOT_CLOSED:
            tag, (line, _) = begun[-1]
            reason = f"<{shown(tag)}> of line {line} is not closed"
        else:
            at = len(xml[: parser.ErrorByteIndex].decode("utf-8-sig", "replace"))
            reason = slip(known, xml.decode("utf-8-sig"), at) or reason
        what = f"not well-formed XML: {reason}"
        raise SpecError(f"{file}:{error.lineno}: {what}", "not-well-formed") from None
    return ended


def _check_text(xml: bytes, file: str) -> None:
    """Refuse what is no UTF-8: UTF-16, too, which may be both, and which expat reads unasked."""
    before, nul, _ = xml.partition(b"\0")
    is_wide = bool(nul) and len(before) < 2
    try:
        xml.decode("utf-8-sig")
    except UnicodeDecodeError:
        is_wide = True
    if is_wide:
        raise SpecError(f"{file}:1: not UTF-8 text; save the spec as UTF-8", "not-utf-8")
    if nul:
        line = before.count(b"\n") + 1
        what = "not well-formed XML: U+0000 is no blank and no text; drop it"
        raise SpecError(f"{file}:{line}: {what}", "not-well-formed")
