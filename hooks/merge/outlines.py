"""YAML, CMake, Markdown and messages as blocks: keys, commands, sections, members."""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Sequence

import yaml

from .blocks import Block, Span, arrange, nested, squeezed, unicode
from .lines import split

COMMENT = "#"


def yaml_blocks(text: str) -> list[Block]:
    """Return the keys of a document, each with those below it.

    Raises:
        ValueError: it is not YAML.

    """
    try:
        list(yaml.compose_all(unicode(text), yaml.SafeLoader))
        inside = _inside_of_values(text)
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from error
    lines = split(text)
    spans = _keys(lines, 0, len(lines), inside)
    return arrange(lines, spans, 0, len(lines), COMMENT)


def _inside_of_values(text: str) -> set[int]:
    """Return the lines that go on with a value: nothing there is a key or a comment."""
    found: set[int] = set()
    for event in yaml.parse(unicode(text), yaml.SafeLoader):
        if isinstance(event, yaml.ScalarEvent):
            start, end = _index(event.start_mark), _index(event.end_mark)
            value = text[start:end]
            if event.style in ("|", ">"):
                header = value.split("\n")[0].split("#")[0]
                value = value.rstrip(" ").removesuffix("\n") if "+" in header else value.rstrip()
            first = text.count("\n", 0, start)
            found.update(range(first + 1, first + 1 + value.count("\n")))
    return found


_KEY = re.compile(
    r"""(?P<margin>\s*)(?P<key>"[^"]*"|'[^']*'|[^\s#'"\[{-][^#]*?):(\s+(?P<value>.*))?$"""
)


def _keys(lines: Sequence[str], start: int, end: int, inside: set[int]) -> list[Span]:
    found = [
        i
        for i in range(start, end)
        if i in inside or (lines[i].strip() and not _is_comment(lines[i]))
    ]
    if not found:
        return []
    margin = _margin(lines[found[0]])
    heads = [i for i in found if i not in inside and _margin(lines[i]) <= margin]
    spans = []
    for i, head in enumerate(heads):
        until = heads[i + 1] if i + 1 < len(heads) else end
        last = max(k for k in found if head <= k < until) + 1
        match = _KEY.match(lines[head].rstrip("\n"))
        value = (match["value"] or "").strip() if match else "-"
        key = match["key"].strip("\"'") if match else squeezed("".join(lines[head:last]))
        if match and last > head + 1 and (not value or value.startswith("#")):
            inner = tuple(_keys(lines, head + 1, last, inside))
            spans.append(Span(key, head, last, (head + 1, last), inner))
        else:
            spans.append(Span(key, head, last))
    return spans


def _margin(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def _is_comment(line: str) -> bool:
    return line.lstrip().startswith(COMMENT)


_COMMAND = re.compile(
    r"""(?P<comment> \#\[\[.*?\]\] | \#[^\n]* )
      | (?P<bracket> \[(?P<mark>=*)\[.*?\](?P=mark)\] )
      | (?P<string> "(?: \\. | [^"\\] )*" )
      | (?P<name> [A-Za-z_]\w* )(?= \s*\( )
      | (?P<sign> [()] )""",
    re.VERBOSE | re.DOTALL,
)


def cmake_blocks(text: str) -> list[Block]:
    """Return the commands of a file, each known by its name and its first argument.

    Raises:
        ValueError: its parentheses, or its conditions, do not match.

    """
    lines = split(text)
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
            first = re.match(r"\w+\s*\(\s*([^\s)]*)", command)
            key = f"{name.lower()} {first[1] if first else ''}".strip()
            if name.lower() in ("if", "elseif"):
                key = squeezed(command)
            ends = text.count("\n", 0, match.end()) + 1
            spans.append(Span(key, text.count("\n", 0, start), ends))
    if depth:
        raise ValueError("a parenthesis that nothing closes")
    return arrange(lines, nested(spans, _role), 0, len(lines), COMMENT)


_STATEMENTS = ("if", "foreach", "while", "function", "macro", "block")


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
    heads = []
    fenced = False
    for index, line in enumerate(lines):
        fenced ^= line.lstrip().startswith("```")
        if not fenced and re.match(r"#{1,6} ", line):
            heads.append(index)
    blocks = [Block("start", lines[: heads[0] if heads else len(lines)])] if lines else []
    for i, head in enumerate(heads):
        end = heads[i + 1] if i + 1 < len(heads) else len(lines)
        blocks.append(Block(squeezed(lines[head]), lines[head:end]))
    seen: dict[str, int] = {}
    for block in blocks:
        seen[block.key] = seen.get(block.key, 0) + 1
        block.key += f" #{seen[block.key]}" if seen[block.key] > 1 else ""
    return [block for block in blocks if block.lines]


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
    return arrange(lines, spans, 0, len(lines), COMMENT)


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
        if isinstance(event, yaml.ScalarEvent):
            start, end = _index(event.start_mark), _index(event.end_mark)
            found += _comments(text[at:start])
            if event.style in ("|", ">"):
                found += _comments(text[start:end].split("\n")[0])
            tag = resolve(yaml.ScalarNode, event.value, event.implicit)  # type: ignore[no-untyped-call]
            facts += [tag, event.value]
            at = end
        found.append(facts)
    return [*found, *_comments(text[at:])]


def _index(mark: object) -> int:
    """Return which character a mark of the parser stands for, in a text it has been given."""
    return int(getattr(mark, "index", 0))


def _comments(text: str) -> list[str]:
    """Return the comments between two values."""
    return [squeezed(words) for words in re.findall(r"(?:^|(?<=\s))#([^\n]*)", text)]


_CMAKE_EXACT = re.compile(
    r"""(?P<exact> \#?\[(?P<mark>=*)\[.*?\](?P=mark)\] | "(?: \\. | [^"\\] )*" ) | \#[^\n]*""",
    re.VERBOSE | re.DOTALL,
)


def same_cmake(one: str, other: str) -> bool:
    """Say whether two texts differ in blanks alone, but for those of an argument."""
    return squeezed(one, _CMAKE_EXACT) == squeezed(other, _CMAKE_EXACT)


_CODE = re.compile(r"(?P<exact>^[ ]*```.*?^[ ]*```|`[^`\n]+`)", re.DOTALL | re.MULTILINE)


def same_markdown(one: str, other: str) -> bool:
    """Say whether two texts differ in blanks alone, but for those of code."""
    return squeezed(one, _CODE) == squeezed(other, _CODE)
