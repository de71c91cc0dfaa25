"""The formats a dictionary can ask of an attribute, each with what it makes of the text.

A format is a function from the text of the spec to a value of the context. It raises
`ValueError`, whose text says what is wrong and what is allowed.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import yaml
from packaging.licenses import InvalidLicenseExpression, canonicalize_license_expression

from .data import load_data
from .faults import quoted
from .names import identifier as identifier_of
from .words import CPP_NAMES, KEYWORDS, PACKAGES, meaning

_LICENSES = {name: spdx for spdx, names in load_data("licenses.yaml").items() for name in names}
_LONGEST_NAME = 100
_LONGEST_LIST = 100_000
_BIDIRECTIONAL = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")


def raw(value: str) -> str:
    """Any text as it stands, but for signs that are no text and would change what is read."""
    for sign in value if not value.isprintable() else "":
        category = unicodedata.category(sign)
        if sign in _BIDIRECTIONAL or (
            category in ("Cc", "Cs", "Zl", "Zp") and sign not in "\t\n\r"
        ):
            raise ValueError(f"U+{ord(sign):04X} is a control character; drop it")
    return value


def text(value: str) -> str:
    """Any text, without the blanks at its ends."""
    return raw(value).strip()


def _match(pattern: str, value: str, complaint: str) -> re.Match[str]:
    match = re.fullmatch(pattern, value, re.ASCII)
    if not match:
        raise ValueError(f"{quoted(value)} is {complaint}")
    if len(value) > _LONGEST_NAME:
        raise ValueError(f"{quoted(value)} is too long; allowed: {_LONGEST_NAME} characters")
    return match


def _matching(pattern: str, complaint: str) -> Callable[[str], str]:
    return lambda value: _match(pattern, value, complaint)[0]


def _free(word: str, meanings: Iterable[str] = KEYWORDS) -> str:
    """Return a word that has none of the meanings already."""
    if found := meaning(word, meanings):
        raise ValueError(f'"{word}" is {found}; choose another')
    return word


def identifier(value: str) -> str:
    """A letter, then letters, digits and single underscores; no keyword."""
    complaint = "not a valid name; allowed: a letter, then letters, digits and single underscores"
    return _free(_match(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*_?", value, complaint)[0])


def package_name(value: str) -> str:
    """A package name of REP 144, which can be a module of Python and a namespace of C++."""
    complaint = "not a package name of REP 144; allowed: two or more of a-z, 0-9 and single"
    complaint += " underscores, a letter first"
    return _free(_match(r"(?=..)[a-z][a-z0-9]*(_[a-z0-9]+)*", value, complaint)[0], PACKAGES)


dependency = _matching(
    r"[A-Za-z][A-Za-z0-9_.+-]*",
    'not a package name; allowed: letters, digits and "_", a letter first',
)
email = _matching(  # catkin_pkg's own expression
    r"[-a-zA-Z0-9_%+.]+@[-a-zA-Z0-9.]+\.[a-zA-Z]{2,}",
    "not a mail address; allowed: name@host.domain",
)


def ros_name(value: str) -> str:
    """A name in the ROS graph: relative, absolute (/a/b) or private (~/a, or ROS 1's ~a)."""
    complaint = (
        "not a valid ROS name; allowed: letters, digits, single underscores"
        ' and "/" between words that start with a letter, after "/" or "~/" if at all'
    )
    word = r"[A-Za-z]\w*"
    prefix, name = _match(rf"(?!.*__)(~/?|/|)({word}(?:/{word})*)", value, complaint).groups()
    _free(name.replace("/", "_"))
    return ("~/" if prefix.startswith("~") else prefix) + name


def _type(folder: str, example: str) -> Callable[[str], str]:
    """Return the format of a type in a folder of a package; it gives `package/folder/Type`."""
    forms = f"package::Type, package/Type, package/{folder}/Type, such as {example}"

    def parse(value: str) -> str:
        pattern = rf"([A-Za-z]\w*)(::|/)(?:{folder}\2)?([A-Za-z]\w*)"
        match = _match(pattern, value, f"not a type; allowed: {forms}")
        package = _free(match[1], (*CPP_NAMES, "a module of Python"))
        return f"{package}/{folder}/{_free(match[3], CPP_NAMES)}"

    return parse


def number(value: str) -> float:
    """A finite number."""
    try:
        result = float(value)
    except ValueError:
        result = math.nan
    if not math.isfinite(result) or "_" in value:
        raise ValueError(
            f"{quoted(value)} is not a number; allowed: a finite number, such as 12.5"
        )
    return result


def boolean(value: str) -> bool:
    """True or false, in one of the usual spellings."""
    spellings = ["true", "1", "yes", "on", "false", "0", "no", "off"]
    word = value.strip().lower()
    if word not in spellings:
        raise ValueError(f"{quoted(value)} is not a bool; allowed: {', '.join(spellings)}")
    return spellings.index(word) < 4


def integer(value: str) -> int:
    """A whole number of 64 bits."""
    complaint = "not an int; allowed: a whole number, such as -3"
    result = int(_match(r"\s*[+-]?[0-9]+\s*", value, complaint)[0])
    if not -(2**63) <= result < 2**63:
        raise ValueError(f'"{value}" does not fit 64 bits; allowed: {-(2**63)} to {2**63 - 1}')
    return result


def license_name(value: str) -> str:
    """The SPDX expression of a licence where there is one, else the text as it stands."""
    name = text(value)
    try:
        return str(canonicalize_license_expression(name))
    except InvalidLicenseExpression:
        key = re.sub(r"^https?://(www\.)?|(\.(txt|html|en\.html))?$", "", name.lower())
        return str(_LICENSES.get(key, name))


FORMATS: dict[str, Callable[[str], Any]] = {
    "text": text,
    "raw": raw,
    "identifier": identifier,
    "component_name": identifier,
    "package_name": package_name,
    "dependency": dependency,
    "ros_name": ros_name,
    "message_type": _type("msg", "std_msgs/String"),
    "service_type": _type("srv", "std_srvs/Trigger"),
    "action_type": _type("action", "test_msgs/Fibonacci"),
    "number": number,
    "bool": boolean,
    "int": integer,
    "double": number,
    "string": raw,
    "email": email,
    "license": license_name,
}
"""The names a dictionary may write after `format:`."""


def literal(value: str, type_name: str) -> Any:
    """Return the value that `value` writes, of the type `bool`, `int`, `double`, `string`.

    With `[]` after the type, a list written as `[a, b]`.

    Raises:
        ValueError: the text is not a value of that type.

    """
    element_type, is_list = re.fullmatch(r"(\w+)(\[\])?", type_name).groups()  # type: ignore[union-attr]
    if not is_list:
        return FORMATS[element_type](value)
    if len(value) > _LONGEST_LIST:
        raise ValueError(
            f"a list of {len(value)} characters is too long; allowed: {_LONGEST_LIST}"
        )
    try:
        items = list(_items(value))
    except (yaml.YAMLError, ValueError, OverflowError):
        form = "allowed: a list such as [first, second]"
        raise ValueError(f"{quoted(value)} is not a {type_name}; {form}") from None
    if not items:
        raise ValueError(
            "a list must not be empty, for ROS 2 could not tell the type of its values"
        )
    return [FORMATS[element_type](item) for item in items]


def _items(value: str) -> Iterator[str]:
    """Yield the values of one YAML list, which has no other inside."""
    events = yaml.parse(value, Loader=yaml.SafeLoader)
    kinds = [yaml.StreamStartEvent, yaml.DocumentStartEvent, yaml.SequenceStartEvent]
    if not all(isinstance(next(events), kind) for kind in kinds):
        raise ValueError
    for event in events:
        if isinstance(event, yaml.SequenceEndEvent):
            break
        if not isinstance(event, yaml.ScalarEvent):
            raise ValueError
        yield event.value
    if not isinstance(next(events), yaml.DocumentEndEvent) or not isinstance(
        next(events), yaml.StreamEndEvent
    ):
        raise ValueError


_COMPARED: dict[str, Callable[[str], str]] = {
    # An identifier used for file and class names; unique ignoring case and underscores.
    "component_name": lambda name: name.replace("_", "").lower(),
}


def comparable(format_name: str, value: str) -> str:
    """Return that in which two values of a format differ where each must be unique."""
    return _COMPARED.get(format_name, identifier_of)(value)
