"""YAML, CMake and Markdown as blocks: keys, commands, sections."""

from __future__ import annotations

import re
from collections.abc import Sequence

import yaml

from .blocks import Block, Span, arrange, squeezed
from .lines import split

COMMENT = "#"


def yaml_blocks(text: str) -> list[Block]:
    """Return the keys of a document, each with those below it.

    Raises:
        ValueError: it is not YAML.

    """
    try:
        list(yaml.compose_all(text, yaml.SafeLoader))
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from error
    lines = split(text)
    return arrange(lines, _keys(lines, 0, len(lines)), 0, len(lines), COMMENT)


_KEY = re.compile(
    r"""(?P<margin>\s*)(?P<key>"[^"]*"|'[^']*'|[^\s#'"\[{-][^#]*?):(\s+(?P<value>.*))?$"""
)


def _keys(lines: Sequence[str], start: int, end: int) -> list[Span]:
    found = [i for i in range(start, end) if lines[i].strip() and not _is_comment(lines[i])]
    if not found:
        return []
    margin = _margin(lines[found[0]])
    heads = [i for i in found if _margin(lines[i]) <= margin]
    spans = []
    for i, head in enumerate(heads):
        until = heads[i + 1] if i + 1 < len(heads) else end
        last = max(k for k in found if head <= k < until) + 1
        match = _KEY.match(lines[head].rstrip("\n"))
        value = (match["value"] or "").strip() if match else "-"
        key = match["key"].strip("\"'") if match else squeezed("".join(lines[head:last]))
        if match and last > head + 1 and (not value or value.startswith("#")):
            inner = tuple(_keys(lines, head + 1, last))
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
        ValueError: its parentheses do not match.

    """
    lines = split(text)
    spans = []
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
    return arrange(lines, spans, 0, len(lines), COMMENT)


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


def same(one: str, other: str) -> bool:
    """Say whether two texts differ in blanks and quotes alone."""
    return squeezed(one) == squeezed(other)
