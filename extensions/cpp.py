"""Filters that write C++: guards, includes, types, comments, lines that fit."""

from __future__ import annotations

import itertools
import re
import textwrap

_LIMIT = 100  # of cpplint and uncrustify
_NO_LIMIT = "  // NOLINT(whitespace/line_length)"
# A list whose sign of equality has a line of its own, as the name of its member fills one.
_LIST = re.compile(r"^(  [\w:<>]+ \w{97,} = \{\n(?:    .*\n)+)  \};", re.MULTILINE)


def cpp_guard(file: str) -> str:
    """Return the include guard of a header: `all_kinds/goal.hpp` gives `ALL_KINDS__GOAL_HPP_`."""
    return re.sub(r"[^A-Z0-9]", "_", file.upper().replace("/", "__")) + "_"


def cpp_type(type_: str, ros: int = 2) -> str:
    """Return the C++ name of a ROS type or of the type of a parameter."""
    if type_.endswith("[]"):
        return f"std::vector<{cpp_type(type_[:-2])}>"
    if "/" in type_:
        package, folder, name = type_.split("/")
        return f"{package}::{name}" if ros == 1 else f"{package}::{folder}::{name}"
    return {"int": "std::int64_t", "string": "std::string"}.get(type_, type_)


def cpp_header(type_: str, ros: int) -> str:
    """Return the header of a ROS type, named as the generators of ROS name it."""
    package, folder, name = type_.split("/")
    if ros == 1:
        return f"{package}/{name}{'Action' if folder == 'action' else ''}.h"
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()
    return f"{package}/{folder}/{name}.hpp"


def cpp_comment(text: str) -> str:
    """Return lines of comments with none that goes on in the next: a last backslash gets a dot.

    What cpplint has rules for stands there in small letters, where it breaks them.
    """
    text = re.sub(r"^( *// )TODO|NOLINT(?=\w*\()", _in_small_letters, text, flags=re.MULTILINE)
    return re.sub(r"(\\|\?\?/)$", r"\1.", text, flags=re.MULTILINE)


def _in_small_letters(match: re.Match[str]) -> str:
    return match[0].lower()


def fit(text: str) -> str:
    """Return code whose lines too long for long names are broken as uncrustify breaks them.

    It would break guards and includes, too, which cpplint wants whole: comments keep it away.
    """
    written = _LIST.sub(r"\1    };", text).split("\n")
    lines = [
        part
        for line, before in zip(written, ["", *written], strict=False)
        for part in _broken(line, before.endswith(" ="))
    ]
    found: list[str] = []
    for is_directive, group in itertools.groupby(lines, lambda line: line.startswith("#")):
        run = list(group)
        if not is_directive:
            found += map(_marked, run)
        elif all(len(line) <= _LIMIT for line in run):
            found += run
        else:
            found += ["// *INDENT-OFF*", *run, "// *INDENT-ON*"]
    return "\n".join(found)


def _marked(line: str) -> str:
    """Return a line that cpplint accepts: a long one has a mark, or ends in an address."""
    fits = (
        len(line) <= _LIMIT
        or line.endswith(_NO_LIMIT)
        or re.fullmatch(r" *//.*https?://\S*", line)
    )
    return line if fits else line + _NO_LIMIT


def _broken(line: str, is_value: bool = False) -> list[str]:
    """Return the lines that a line is broken into; `is_value`: it follows a sign of equality."""
    code = line.lstrip()
    if len(line) <= _LIMIT or code.startswith("#") or line.endswith(_NO_LIMIT):
        return [line]
    indent = len(line) - len(code)
    if match := re.match("//+ ", code):
        return textwrap.wrap(
            code[match.end() :],
            _LIMIT,
            initial_indent=" " * indent + match[0],
            subsequent_indent=" " * indent + match[0],
            break_long_words=False,
            break_on_hyphens=False,
        )
    if match := re.fullmatch(r"((?!using|return|const|explicit)[\w:<>]+) (\w+(;| =.*))", code):
        parts = _member(match[1], match[2], _LIMIT - indent)
    elif match := re.fullmatch(r"([\w:<> ]+ \w+\([^()]*\)[ \w]*) \{([^{};]+;)\}", code):
        parts = [(0, match[1]), (0, "{"), (2, match[2]), (0, "}")]
    elif match := re.fullmatch(r"([^=\"(]+ =) (.+)", code):
        value = " " * (indent + 2) + match[2]
        return [*_broken(line[: indent + match.end(1)]), *_broken(value, is_value=True)]
    elif parts := _long_names(code, _LIMIT - indent):
        return [" " * (indent + more) + text for more, text in parts]
    else:
        parts = _parts(code, is_value)
    if len(parts) == 1:
        return [line]
    first, *rest = [" " * (indent + more) + text for more, text in parts]
    return [*_broken(first, is_value), *(part for text in rest for part in _broken(text))]


def _member(type_: str, rest: str, room: int) -> list[tuple[int, str]]:
    """Return the parts of a member that do not fit beside its type: a literal begins no line."""
    indent = 0 if type_.endswith(">") else 2
    name, sign, value = rest.partition(" =")
    if len(rest) + indent <= room or not sign or "(" in value:
        return [(0, type_), (indent, rest)]
    own_line = len(f"{name} =") + indent > room
    begin = [(indent, name), (2, "=")] if own_line else [(indent, f"{name} =")]
    value_indent = 2 if own_line else indent
    return [(0, type_), *begin, *([(value_indent, value.strip())] if value else [])]


def _long_names(code: str, room: int) -> list[tuple[int, str]]:
    """Return the parts of an alias or of a reference whose names alone are too long for a line."""
    if match := re.fullmatch(r"(using) (\w+) =", code):
        words, end = match.groups(), [(2, "=")]
    elif match := re.fullmatch(r"(const) (\w+) & (\w+;)", code):
        words, end = match.groups()[:2], [(0, f"& {match[3]}")]
        if len(f"{' '.join(words)} &") <= room:
            return [(0, f"{' '.join(words)} &"), (0, match[3])]
    else:
        return []
    is_short = len(" ".join(words)) <= room
    return [(0, each) for each in ([" ".join(words)] if is_short else words)] + end


def _parts(code: str, is_value: bool) -> list[tuple[int, str]]:
    """Return what a line is broken into, each with the columns that it is indented further."""
    if match := re.fullmatch(r"(\[\[maybe_unused\]\]) (.+)", code):
        return [(0, match[1]), (0, match[2])]
    if match := re.fullmatch(r"(if \()(.+ [!=]=) (.+\)) \{", code):
        return [(0, match[1]), (2, match[2]), (2, match[3]), (0, "{")]
    if match := re.fullmatch(r"((?:class|struct) \w+) (: .+)", code):
        return [(0, match[1]), (2, match[2])]
    if match := re.fullmatch(r"((?:: )?\w+,) (\w+(?:, \w+)*)", code):
        return [(0, match[1]), (0, match[2])]
    if match := re.fullmatch(r"(.+ &) (\w+\()", code):
        return [(0, match[1]), (0, match[2])]
    if arguments := _arguments(code):
        return [(0, arguments[0]), *((0 if is_value else 2, each) for each in arguments[1:])]
    if match := re.fullmatch(r"([^()]*<)((?:const )?[\w:]+>.*)", code):
        is_nested = match[1].count("<") > 1
        further = 0 if is_value else 2
        if is_nested and (is_value or not code.endswith("(")):
            further = 4
        return [(0, match[1]), (further, match[2])]
    if match := re.fullmatch(r"(.+::)(\w.*)", code):
        # Uncrustify counts one column less than cpplint, and would join the name of a function.
        begin = re.fullmatch(r"(\w+ )?\w+::\w+\(", code.removesuffix(")"))
        is_joined = begin and len(begin[0]) <= _LIMIT + 1
        return [(0, match[1] + (_NO_LIMIT if is_joined else "")), (0, match[2])]
    return [(0, code)]


def _arguments(code: str) -> list[str]:
    """Return code up to its arguments, and each of them; nothing if it has none."""
    ends: list[int] = []
    depth = 0
    for match in re.finditer(r'"(?:[^"\\]|\\.)*"|[^\s"]', code):
        depth -= match[0] in tuple(")]}")
        begins = (match[0], depth) == ("(", 0) and not ends and code[match.end() :][:1] != ")"
        if begins or (ends and (match[0], depth) == (",", 1)):
            ends.append(match.end())
        elif ends and (match[0], depth) == (")", 0):
            parts = zip([0, *ends], [*ends, len(code)], strict=True)
            return [code[start:end].strip() for start, end in parts]
        depth += match[0] in tuple("([{")
    return []


def sort_includes(text: str) -> str:
    """Return include lines, each once: those of C++ first, then the others, sorted."""
    lines = sorted(set(re.findall(r"^#include .+$", text, re.MULTILINE)))
    groups = ([s for s in lines if "<" in s], [s for s in lines if "<" not in s])
    return "\n\n".join("\n".join(group) for group in groups if group) + "\n"
