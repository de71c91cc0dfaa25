"""YAML, CMake, Markdown and messages as blocks: keys, commands, sections, members."""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Iterator, Sequence

import yaml

from ..data import LOADER
from .blocks import Block, Span, arrange, nested, numbered, squeezed, unicode
from .lines import margin, split

_FLAGS = re.VERBOSE | re.DOTALL
SKIPPED = r"""(?P<exact> \#?\[(?P<mark>=*)\[.*?\](?P=mark)\] | "(?: \\. | [^"\\] )*" )
  | (?P<comment> \#[^\n]* )"""
"""What holds no command of CMake: texts, whose blanks count, and comments."""
_CMAKE_EXACT = re.compile(SKIPPED, _FLAGS)
_COMMAND = re.compile(
    rf"{SKIPPED} | \\. | (?P<name> [A-Za-z_]\w* )(?= \s*\( ) | (?P<sign> [()] )", _FLAGS
)
_BESIDE = re.compile(rf"{SKIPPED} | \s* (?P<sign> [()] ) \s*", _FLAGS)
"""A parenthesis of a command, with the blanks beside it."""
_CMAKE_COMMENTS = re.compile(r"#\[(=*)\[.*?\]\1\]|#[^\n]*", re.DOTALL)
_LISTS = (
    "(?:ament|catkin)_package|generate_messages|generate_dynamic_reconfigure_options"
    r"|ament_export_\w+"
)
"""Commands that a file has once: their first argument, which a formatter moves, is an item."""
_STATEMENTS = ("if", "foreach", "while", "function", "macro", "block")
_FENCE = re.compile(r"[ >*-]*(`{3,}(?=[^`]*$)|~{3,})(.*)")
_TITLE = re.compile(r" {0,3}[^\s#>|<`~=*+-]")
"""What a heading may begin with that a line of `=` or `-` below it makes one."""
_CODE = re.compile(
    r"(?P<exact>^[ ]*(?P<mark>`{3,}|~{3,}).*?^[ ]*(?P=mark)|`[^`\n]+`)", re.DOTALL | re.MULTILINE
)


def yaml_blocks(text: str) -> list[Block]:
    """Return the keys of a document, each with those below it."""
    try:
        nodes = list(yaml.compose_all(unicode(text), LOADER))
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from error
    lines = split(text)
    ends = ((node, _ends(text, node)) for node in nodes if node)  # before `---` or `...`
    spans = [span for node, end in ends for span in _keys(text, lines, node, end)]
    return arrange(lines, spans)


def _keys(text: str, lines: Sequence[str], node: yaml.Node, until: int) -> Iterator[Span]:
    """Yield what a mapping or a sequence holds, up to a line; nothing of one in braces."""
    if not isinstance(node, yaml.CollectionNode) or node.flow_style:
        return
    is_map = isinstance(node, yaml.MappingNode)
    entries = node.value if is_map else [(item, item) for item in node.value]
    starts = [text.count("\n", 0, key.start_mark.index) for key, _ in entries]
    if any(one >= other for one, other in itertools.pairwise(starts)):
        return  # a member is an alias, of which the parser says where the anchor is
    for (key, value), start, end in zip(entries, starts, [*starts[1:], until], strict=True):
        column = margin(lines[start])
        is_here = value.start_mark.index >= key.start_mark.index  # no alias of another
        # In a text a number sign begins no comment.
        written = _ends(text, value) if isinstance(value, yaml.ScalarNode) else start
        while not (line := lines[end - 1].lstrip()) or (
            line.startswith("#") and end > written and margin(lines[end - 1]) <= column
        ):
            end -= 1
        inner = [*_keys(text, lines, value, end)] if is_here else []
        is_named = is_map and isinstance(key, yaml.ScalarNode)
        name = key.value if is_named else squeezed("".join(lines[start:end]))
        if not is_map and (first := _first_entry(text, value, bool(inner))):
            name = squeezed(first)
            inner = inner[1:]
        if inner and inner[0].start > start:
            yield Span(name, start, end, (start + 1, end), tuple(inner))
        else:
            yield Span(name, start, end)


def _first_entry(text: str, member: yaml.Node, is_nested: bool) -> str:
    """Return what a member of a list is known by: its first line, without the comment on it.

    Nothing where the first entry of a nested one is longer.
    """
    entry = member.value[0] if is_nested else member
    parts = entry if isinstance(entry, tuple) else (entry,)
    start = text.rfind("\n", 0, member.start_mark.index) + 1
    until = max(part.end_mark.index for part in parts)
    rest = re.split(r"\s#|\n", text[until:])[0]  # of an alias
    return "" if "\n" in text[start:until] else text[start:until] + rest


def cmake_blocks(text: str) -> list[Block]:
    """Return the commands of a file, each known by its name and its first argument."""
    spans: list[Span] = []
    depth, start, name = 0, 0, ""
    for match in _COMMAND.finditer(text):
        if match["name"] and not depth:
            start, name = match.start(), match["name"]
        depth += (match["sign"] == "(") - (match["sign"] == ")")
        if depth < 0:
            raise ValueError("a parenthesis that nothing opens")
        if match["sign"] == ")" and not depth:
            command = text[start : match.end()]
            key = name.lower()
            if not re.fullmatch(_LISTS, key):
                first = re.match(r"\w+\s*\(\s*([^\s)]*)", command)
                key = f"{key} {first[1] if first else ''}".rstrip()
            if name.lower() in ("if", "elseif"):
                key = cmake_key(command)
            at, rest = text[:start].count("\n"), command.count("\n")
            spans.append(Span(key, at, at + rest + 1))
    if depth:
        raise ValueError("a parenthesis that nothing closes")
    return arrange(split(text), nested(spans, _role), _CMAKE_COMMENTS)


def _role(span: Span) -> tuple[str, str]:
    """Say which statement a command begins, goes on with or ends."""
    name = re.match(r"\w*", span.key)[0].lower()  # type: ignore[index]
    if name in _STATEMENTS:
        return name, "start"
    if name in ("else", "elseif"):
        return "if", "branch"
    statement = name.removeprefix("end")
    return (statement, "end") if name != statement in _STATEMENTS else ("", "")


def markdown_blocks(text: str) -> list[Block]:
    """Return the sections of a text, each known by its heading."""
    lines = split(text)
    heads = {0: "start"}
    until = ""
    for index, line in enumerate(lines):
        fence = _FENCE.match(line)
        if until:
            is_end = bool(fence and fence[1].startswith(until) and not fence[2].strip())
            until = "" if is_end or (until == "-->" and until in line) else until
        elif fence:
            until = fence[1]
        elif "<!--" in line and "-->" not in line.rpartition("<!--")[2]:
            until = "-->"
        elif re.match(r"#{1,6} ", line):
            heads[index] = squeezed(line)
        elif index and re.match(r" {0,3}(=+|-+)\s*$", line) and _TITLE.match(lines[index - 1]):
            level = "#" if "=" in line else "##"
            heads[index - 1] = squeezed(f"{level} {lines[index - 1]}")
    ends = [*heads, len(lines)][1:]
    blocks = [Block(heads[at], lines[at:end]) for at, end in zip(heads, ends, strict=True)]
    return [block for block in numbered(blocks) if block.lines]


def message_blocks(text: str) -> list[Block]:
    """Return the members of a message, service or action, those after a `---` inside of it."""
    lines = split(text)
    parts = [0, *(i for i, line in enumerate(lines) if re.match(r"---\s*$", line)), len(lines)]
    spans: list[Span] = []
    for number, (start, end) in enumerate(itertools.pairwise(parts)):
        words = [(i, lines[i].split("#")[0].split()) for i in range(start + bool(number), end)]
        names = [(i, re.split("[=<]", found[1])[0]) for i, found in words if found[1:]]
        members = [Span(f"{number} {name}", i, i + 1) for i, name in names]
        if number:
            members = [Span("---", start, end, (start + 1, end), tuple(members))]
        spans += members
    return arrange(lines, spans)


def same_yaml(one: str, other: str) -> bool:
    """Say whether two texts differ in form alone: their values, their comments are the same."""
    try:
        return _meaning(one) == _meaning(other)
    except yaml.YAMLError:
        return squeezed(one) == squeezed(other)


@functools.lru_cache(maxsize=2048)
def _meaning(text: str) -> list[object]:
    text = unicode(text)
    resolve = yaml.SafeLoader("").resolve
    found: list[object] = []
    at = 0
    for event in yaml.parse(text, yaml.SafeLoader):
        facts: list[object] = [type(event), getattr(event, "anchor", None)]
        facts.append(getattr(event, "tag", None))
        if isinstance(event, yaml.DocumentStartEvent):
            facts += [event.explicit, event.version]
        if isinstance(event, yaml.ScalarEvent):
            marks = (event.start_mark, event.end_mark)
            start, end = (mark.index for mark in marks)  # type: ignore[union-attr]
            found += _comments(text[at:start])
            if event.style in ("|", ">"):
                found += _comments(text[start:end].split("\n")[0])
            tag = resolve(yaml.ScalarNode, event.value, event.implicit)  # type: ignore[no-untyped-call]
            facts += [tag, event.value]
            at = end
        found.append(facts)
    return [*found, *_comments(text[at:])]


def _ends(text: str, node: yaml.Node) -> int:
    """Return how many lines there are up to the end of a node."""
    return len(split(text[: node.end_mark.index]))


def _comments(text: str) -> list[str]:
    """Return the comments between two values."""
    return [squeezed(words) for words in re.findall(r"(?:^|(?<=\s))#([^\n]*)", text)]


def cmake_key(text: str) -> str:
    """Return commands without blanks around their words, their names in small letters."""
    return squeezed(_lower(text))


def _lower(text: str) -> str:
    return _COMMAND.sub(lambda match: match[0].lower() if match["name"] else match[0], text)


def cmake_meaning(text: str) -> str:
    """Return a text without what is but form: capitals of commands, blanks between words."""
    tight = _BESIDE.sub(lambda match: match["sign"] or match[0], _lower(text))
    return squeezed(tight, _CMAKE_EXACT)


def markdown_meaning(text: str) -> str:
    """Return a text without what is but form: that of tables, blanks, but for those of code."""
    return squeezed("".join(map(row, split(text))), _CODE)


def asides(lines: Sequence[str]) -> list[str]:
    """Say of each line whether it is of a diagram or example between fences, a table, a list."""
    kinds = {"|": "table", "- ": "list"}
    found = [next((k for s, k in kinds.items() if line.startswith(s)), "") for line in lines]
    text = "".join(lines)
    for match in _CODE.finditer(text):
        if match["mark"]:
            start = text[: match.start()].count("\n")
            for at in range(start, start + match[0].count("\n") + 1):
                found[at] = "fence"
    return found


def row(line: str) -> str:
    """Return a line; one of a table without what a formatter aligns it by."""
    if not line.startswith("|"):
        return line
    rule = re.sub("-+", "-", line) if re.fullmatch(r"[|:\s-]+", line) else line
    return re.sub(r"[ \t]*(\||$)[ \t]*", r"\1", rule)


def joined_rows(*sides: Sequence[str]) -> tuple[dict[str, str], dict[str, str]]:
    """Merge by cell what both sides have made of the rows of tables, each of other cells.

    `sides` are the developer's, the old and the new version of a section. Returns what becomes
    of the developer's rows, and of the old ones.
    """
    joined: dict[str, str] = {}
    came: dict[str, str] = {}
    mine, old, new = map(_rows, sides)
    for key in mine.keys() & old.keys() & new.keys():
        rows = [side[key] for side in (mine, old, new)]
        cells = [*map(_cells, rows)]
        found = [*map(_joined_cell, *cells)] if len({*map(len, cells)}) == 1 else [None]
        text = "" if None in found else "|".join(map(str, found))
        if row(text) not in ("", row(rows[2])):
            joined[rows[0]], came[rows[1]] = text, rows[2]
    return joined, came


def _rows(lines: Sequence[str]) -> dict[str, str]:
    """Return the rows of tables by their first cells, but for those that several have."""
    found: dict[str, list[str]] = {}
    for line in lines:
        if line.startswith("|"):
            found.setdefault(_cells(line)[1].strip(), []).append(line)
    return {key: rows[0] for key, rows in found.items() if not rows[1:]}


def _cells(row: str) -> list[str]:
    return re.split(r"(?<!\\)\|", row)


def _joined_cell(mine: str, old: str, new: str) -> str | None:
    """Return a cell of which one side, if any, has made something; none where both have."""
    if new.strip() in (mine.strip(), old.strip()):
        return mine
    return new if mine.strip() == old.strip() else None
