"""XML as blocks: elements, each known by its tag and what names it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from xml.parsers import expat

from .blocks import Block, Span, arrange, squeezed
from .lines import split

MARKUP = re.compile(
    r"""(?P<other> <!--.*?--> | <\?.*?\?> | <!\[CDATA\[.*?\]\]>
      | <!DOCTYPE[^>[]*\[.*?\]\s*> | <![^>]*> )
      | (?P<close> </[^>]+> )
      | (?P<open> <(?P<tag>[^\s/>]+) (?P<attributes> (?: "[^"]*" | '[^']*' | [^>"'] )* ) > )""",
    re.VERBOSE | re.DOTALL,
)
ATTRIBUTE = re.compile(r"""(?P<name>[\w:.-]+)(?P<sign>\s*=\s*)(?P<value>"[^"]*"|'[^']*')""")
_FILE = re.compile(r"/([\w.-]+\.(?:yaml|xml|launch))\b")
COMMENTS = re.compile(r"<!--.*?-->", re.DOTALL)
_NAMING = ("name", "from", "file", "param", "id", "exec", "type", "if", "unless")
_EXACT = re.compile(
    r"""<!--.*?--> | (?P<exact> <!\[CDATA\[.*?\]\]> | (?<==)"[^"]*" | (?<==)'[^']*' )""",
    re.VERBOSE | re.DOTALL,
)
_BESIDE = re.compile(
    r"""<!--.*?--> | <!\[CDATA\[.*?\]\]> | \s*=\s*(?P<value> "[^"]*" | '[^']*' )
      | \s*(?P<end> /?> )\s*""",
    re.VERBOSE | re.DOTALL,
)
"""A value or the end of a tag, with the blanks beside it."""


def blocks(text: str) -> list[Block]:
    """Return the elements of a document; those inside of others are inside of them."""
    try:
        expat.ParserCreate().Parse(text.encode(errors="surrogateescape"), True)
    except expat.ExpatError as error:
        raise ValueError(str(error)) from error
    return arrange(split(text), _spans(text), COMMENTS)


def meaning(text: str) -> str:
    """Return a text without what is but form: blanks, but for those of a value."""
    tight = _BESIDE.sub(lambda m: f"={m['value']}" if m["value"] else m["end"] or m[0], text)
    return squeezed(tight, _EXACT)


_USES = ("build_depend", "build_export_depend", "exec_depend")


def is_same_dependency(one: Block, other: Block) -> bool:
    """Say whether elements name one package, in general and for a use: one may not have both."""
    (sort, _, name), (other_sort, _, its) = (each.key.partition(" ") for each in (one, other))
    sorts = {sort, other_sort}
    return name == its and "depend" in sorts and not sorts.isdisjoint(_USES)


Attribute = tuple[str, str, str]
"""The name of its element, its own, and its value.

An element of a package is known by that: it may have another name, and another package's the same
one.
"""


def attributes(text: str) -> Iterator[tuple[Attribute, int]]:
    """Yield the attributes of a text, each with the place of its value."""
    for match in MARKUP.finditer(text):
        if match["open"]:
            given, tag = _attributes(match["attributes"]), match["tag"]
            name = f"{tag} of {given['pkg']}" if "pkg" in given else _named(tag, given)
            for found in ATTRIBUTE.finditer(text, *match.span("attributes")):
                yield (name, found["name"], found["value"][1:-1]), found.start("value") + 1


def exchange(text: str, by: Callable[[Attribute], str]) -> str:
    """Return a text with the values of its attributes exchanged, as `by` says."""
    parts: list[str] = []
    at = 0
    for found, start in attributes(text):
        parts += [text[at:start], by(found)]
        at = start + len(found[2])
    return "".join(parts) + text[at:]


def _attributes(text: str) -> dict[str, str]:
    return {name: value[1:-1] for name, _, value in ATTRIBUTE.findall(text)}


def keys(text: str) -> set[str]:
    """Return what names the elements of a document, of several on a line, too."""
    return {key for span in _spans(text) for key in _keys(span)}


def _keys(span: Span) -> Iterator[str]:
    yield span.key
    for each in span.items:
        yield from _keys(each)


def _spans(text: str) -> list[Span]:
    top: list[Span] = []
    open_: list[tuple[re.Match[str], list[Span]]] = []
    for match in MARKUP.finditer(text):
        if match["open"]:
            open_.append((match, []))
        if match["close"] or (match["open"] and match["attributes"].rstrip().endswith("/")):
            start, inside = open_.pop()
            (open_[-1][1] if open_ else top).append(_span(text, start, match, inside))
    return top


def _span(text: str, start: re.Match[str], end: re.Match[str], inside: list[Span]) -> Span:
    """Return an element from its first tag to its last one, which may be the same."""
    first, last = _line(text, start.start()), _line(text, end.end()) + 1
    key = _key(start, text[start.end() : end.start()], bool(inside))
    body = (_line(text, start.end()) + 1, _line(text, end.start()))
    if inside and body[0] <= inside[0].start and body[0] < body[1] and inside[-1].end <= body[1]:
        return Span(key, first, last, body, tuple(inside))
    return Span(key, first, last)


def _key(start: re.Match[str], content: str, has_children: bool) -> str:
    """Name an element: `exec_depend rclpy`, `node reach`, `arg log_level`."""
    tag = start["tag"]
    name = _named(tag, _attributes(start["attributes"]))
    is_of_content = tag.endswith("depend") or tag == "url"
    if name != tag or has_children or not is_of_content:
        return name
    return f"{tag} {squeezed(content)}"


def _named(tag: str, attributes: Mapping[str, str]) -> str:
    if tag == "license":  # whose `file` may be told or not
        return tag
    name = next((attributes[each] for each in _NAMING if each in attributes), None)
    file = _FILE.search(name or "")  # which may be in another folder
    return tag if name is None else f"{tag} {file[1] if file else name}"


def _line(text: str, at: int) -> int:
    return text.count("\n", 0, at)
