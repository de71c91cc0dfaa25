"""XML as blocks: elements, each known by its tag and what names it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from xml.parsers import expat

from .blocks import Block, Span, arrange, collapsed, one_sort, squeezed
from .lines import split

_MARKUP = re.compile(
    r"""(?P<other> <!--.*?--> | <\?.*?\?> | <!\[CDATA\[.*?\]\]> | <![^>]*> )
      | (?P<close> </[^>]+> )
      | (?P<open> <(?P<tag>[^\s/>]+) (?P<attributes> (?: "[^"]*" | '[^']*' | [^>"'] )* ) > )""",
    re.VERBOSE | re.DOTALL,
)
_ATTRIBUTE = re.compile(r"""([\w:.-]+)\s*=\s*(?:"([^"]*)"|'([^']*)')""")
_NAMING = ("name", "from", "file", "param", "id", "exec", "type", "if", "unless")


@dataclass
class _Element:
    tag: str
    attributes: dict[str, str]
    start: int
    inner: int
    """Where its content begins."""
    outer: int = 0
    """Where its content ends."""
    end: int = 0
    children: list[_Element] = field(default_factory=list)


_COMMENTS = re.compile(r"<!--.*?-->", re.DOTALL)


def blocks(text: str) -> list[Block]:
    """Return the elements of a document; those inside of others are inside of them.

    Raises:
        ValueError: it is not XML.

    """
    try:
        expat.ParserCreate().Parse(text.encode(errors="surrogateescape"), True)
    except expat.ExpatError as error:
        raise ValueError(str(error)) from error
    lines = split(text)
    spans = tuple(_span(text, element) for element in _elements(text))
    return arrange(lines, spans, 0, len(lines), _COMMENTS)


_EXACT = re.compile(
    r"""<!--.*?--> | (?P<exact> <!\[CDATA\[.*?\]\]> )
      | \s*=\s*(?P<value> "[^"]*" | '[^']*' )""",
    re.VERBOSE | re.DOTALL,
)


def same(one: str, other: str) -> bool:
    """Say whether two texts differ in form alone: in blanks, but for those of a value."""
    return _tight(one) == _tight(other)


def _tight(text: str) -> str:
    parts: list[str] = []
    at = 0
    for match in _EXACT.finditer(text):
        value = match["value"]
        inside = f"={one_sort(value)}" if value else match["exact"] or collapsed(match[0])
        parts += [_tight_signs(text[at : match.start()]), inside]
        at = match.end()
    return "".join([*parts, _tight_signs(text[at:])]).strip()


def _tight_signs(text: str) -> str:
    return re.sub(r"\s*(/?>)\s*", r"\1", collapsed(text))


def exchange(text: str, by: Callable[[str, str, str], str]) -> str:
    """Return a text with the value of each attribute exchanged.

    `by` is given the name of its element, its own, and its value. An element of a package is known
    by that: it may have another name, and another package's the same one.
    """

    def element(match: re.Match[str]) -> str:
        if not match["open"]:
            return match[0]
        attributes = _attributes(match["attributes"])
        name = _named(match["tag"], attributes)
        name = f"{match['tag']} of {attributes['pkg']}" if "pkg" in attributes else name

        def attribute(found: re.Match[str]) -> str:
            which = 3 if found[2] is None else 2
            head = found[0][: found.start(which) - found.start()]
            return f"{head}{by(name, found[1], found[which])}{found[0][-1]}"

        return f"<{match['tag']}{_ATTRIBUTE.sub(attribute, match['attributes'])}>"

    return _MARKUP.sub(element, text)


def _attributes(text: str) -> dict[str, str]:
    return {name: one or other for name, one, other in _ATTRIBUTE.findall(text)}


def _elements(text: str) -> list[_Element]:
    top = _Element("", {}, 0, 0)
    stack = [top]
    for match in _MARKUP.finditer(text):
        if match["open"]:
            attributes = match["attributes"]
            found = _attributes(attributes)
            element = _Element(match["tag"], found, match.start(), match.end())
            stack[-1].children.append(element)
            if attributes.rstrip().endswith("/"):
                element.outer = element.end = match.end()
            else:
                stack.append(element)
        elif match["close"]:
            element = stack.pop()
            element.outer, element.end = match.start(), match.end()
    return top.children


def _span(text: str, element: _Element) -> Span:
    first, last = _line(text, element.start), _line(text, element.end) + 1
    key = _key(text, element)
    body = (_line(text, element.inner) + 1, _line(text, element.outer))
    starts = [_line(text, child.start) for child in element.children]
    if element.children and body[0] <= starts[0] and body[0] < body[1]:
        inner = tuple(_span(text, child) for child in element.children)
        if inner[-1].end <= body[1]:
            return Span(key, first, last, body, inner)
    return Span(key, first, last)


def _key(text: str, element: _Element) -> str:
    """Name an element: `exec_depend rclpy`, `node reach`, `arg log_level`."""
    name = _named(element.tag, element.attributes)
    is_of_content = element.tag.endswith("depend") or element.tag == "url"
    if name != element.tag or element.children or not is_of_content:
        return name
    return f"{element.tag} {squeezed(text[element.inner : element.outer])}"


def _named(tag: str, attributes: Mapping[str, str]) -> str:
    found = (f"{tag} {attributes[name]}" for name in _NAMING if name in attributes)
    return next(found, tag)


def _line(text: str, at: int) -> int:
    return text.count("\n", 0, at)
