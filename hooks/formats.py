"""The formats a dictionary can ask of an attribute, each with what it makes of the text.

A format is a function from the text of the spec to a value of the context. It raises
`SpecError`, whose text says what is wrong and what is allowed.
"""

from __future__ import annotations

import math
import re
import sys
import unicodedata
from collections.abc import Callable, Iterable
from typing import Any

from packaging.licenses import InvalidLicenseExpression, canonicalize_license_expression

from . import in_code
from .data import load_data
from .faults import SpecError, allowed, quoted, shown
from .in_code import FOLDERS, PRIMITIVES
from .names import identifier as identifier_of
from .words import CPP_NAMES, DEVICES, KEYWORDS, MODULES, PACKAGES, meaning

_LICENSES = {name: spdx for spdx, names in load_data("licenses.yaml").items() for name in names}
_WITH_HEADER: dict[str, str] = load_data("ros.yaml")["with_header"]
BLANKS = " \t\r\n"
"""What is a blank in XML: around a word, it has no meaning."""
LONGEST_NAME = 100
_BIDIRECTIONAL = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")


def raw(value: str) -> str:
    """Any text as it stands, but for signs that are no text and would change what is read.

    Decision 12: YAML, compilers and reviewers each read something else.
    """
    for sign in value if not value.isprintable() else "":
        category = unicodedata.category(sign)
        if sign in _BIDIRECTIONAL or (
            category in ("Cc", "Cs", "Zl", "Zp") and sign not in "\t\n\r"
        ):
            what = f"U+{ord(sign):04X} is a control character; drop it"
            raise SpecError(what, "control-character")
        if sign in "\ufffe\uffff":  # which YAML does not read
            raise SpecError(f"U+{ord(sign):04X} is no character; drop it", "control-character")
    return value


def text(value: str) -> str:
    """Any text, without the blanks at its ends."""
    return raw(value).strip()


def _match(pattern: str, value: str, complaint: str, id_: str) -> re.Match[str]:
    match = re.fullmatch(pattern, value, re.ASCII)
    if not match:
        raise SpecError(f"{quoted(value)} is {complaint}", id_)
    if len(value) > LONGEST_NAME:
        what = f"{quoted(value)} is too long; allowed: {LONGEST_NAME} characters"
        raise SpecError(what, "too-long")
    return match


def _matching(pattern: str, complaint: str, id_: str) -> Callable[[str], str]:
    return lambda value: _match(pattern, value, complaint, id_)[0]


def _free(word: str, meanings: Iterable[str] = KEYWORDS) -> str:
    """Return a word that has none of the meanings already."""
    if found := meaning(word, meanings):
        raise SpecError(f'"{word}" is {found}; choose another', "reserved-name")
    return word


def _as_file(format_: Callable[[str], str]) -> Callable[[str], str]:
    """Return a format of names that files get: Windows has devices of some names."""

    def check(value: str) -> str:
        name = format_(value)
        _free(name.partition(".")[0].lower(), DEVICES)
        return name

    return check


def identifier(value: str) -> str:
    """A letter, then letters, digits and single underscores; no keyword."""
    complaint = "not a valid name; allowed: a letter, then letters, digits and single underscores"
    pattern = r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*_?"
    return _free(_match(pattern, value, complaint, "invalid-name")[0])


def dotted_name(value: str) -> str:
    """Identifiers with dots between them; ROS 1 writes a stroke for a dot."""
    word = "[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*"
    complaint = "not a valid name; allowed: a letter, then letters, digits and single underscores;"
    complaint += ' a "." between nested ones'
    return _match(rf"{word}([./]{word})*_?", value, complaint, "invalid-name")[0].replace("/", ".")


def grouped_name(value: str) -> str:
    """The same, and no keyword."""
    name = dotted_name(value)
    _free(identifier_of(name))
    return name


def package_name(value: str) -> str:
    """A package name of REP 144, which can be a module of Python and a namespace of C++."""
    complaint = "not a package name of REP 144; allowed: two or more of a-z, 0-9 and single"
    complaint += " underscores, a letter first"
    pattern = r"(?=..)[a-z][a-z0-9]*(_[a-z0-9]+)*"
    return _free(_match(pattern, value, complaint, "invalid-name")[0], PACKAGES)


dependency = _matching(
    r"[A-Za-z][A-Za-z0-9_.+-]*",
    'not a package name; allowed: one name of letters, digits and "_", a letter first',
    "invalid-name",
)
email = _matching(  # catkin_pkg's own expression
    r"[-a-zA-Z0-9_%+.]+@[-a-zA-Z0-9.]+\.[a-zA-Z]{2,}",
    "not a mail address; allowed: name@host.domain",
    "invalid-value",
)

version = _matching(
    r"(0|[1-9][0-9]*)\.(0|[1-9][0-9]*)\.(0|[1-9][0-9]*)",
    "not a version; allowed: three numbers, such as 1.2.0",
    "invalid-value",
)
url = _matching(
    r"https?://[^\s<>\"']+",
    "not an address of the web; allowed: https://host/path, without blanks and quotes",
    "invalid-value",
)
file_name = _matching(
    r"[A-Za-z0-9_][A-Za-z0-9_.-]*",
    'not a file name; allowed: letters, digits, "_", "." and "-", no "." or "-" first',
    "invalid-name",
)


def relative_name(value: str) -> str:
    """A name in the ROS graph that begins with a word."""
    if (word := value.lstrip("~/")) != value:
        what = f"{quoted(value)} is not relative; did you mean {quoted(word)}?"
        raise SpecError(what, "invalid-name")
    return ros_name(value)


def ros_name(value: str) -> str:
    """A name in the ROS graph: relative, absolute (/a/b) or private (~/a, or ROS 1's ~a)."""
    complaint = (
        "not a valid ROS name; allowed: letters, digits, single underscores"
        ' and "/" between words that start with a letter, after "/" or "~/" if at all'
    )
    word = r"[A-Za-z]\w*"
    pattern = rf"(?!.*__)(~/?|/|)({word}(?:/{word})*)"
    prefix, name = _match(pattern, value, complaint, "invalid-name").groups()
    _free(name.replace("/", "_"))
    return ("~/" if prefix.startswith("~") else prefix) + name


def _topic(pattern: str) -> Callable[[str], str]:
    """A name that a node takes for that of a topic: another than one of the spec."""
    complaint = "not the name of a topic; allowed: what the ROS graph has, such as /scan"
    return _matching(pattern, complaint, "invalid-name")


def with_capital(type_: str) -> str:
    """Return what a type that begins with a small letter is for: `std_msgs/uint8`, for `UInt8`.

    Nothing where it begins with a capital.
    """
    name = re.split("[/:]", type_)[-1]
    return type_.removesuffix(name) + in_code.with_capital(name) if name[0].islower() else ""


def check_capital(type_: str) -> None:
    """Insist that the name of a type begins with a capital."""
    if meant := with_capital(type_):
        rule = f"a type begins with a capital; did you mean {quoted(meant)}?"
        raise SpecError(f"{quoted(type_)}: {rule}", "type-without-capital")


def _as_in_code(value: str, folder: str) -> str:
    """Say what a type is that is written as in code, as its file, or as a list."""
    words = in_code.words(value)
    others = [word for word in words if word in FOLDERS and word != folder]
    words = [word for word in words if word not in FOLDERS]
    if others and len(words) == 2:
        return f"the type of {FOLDERS[others[0]]}, where that of {FOLDERS[folder]} belongs;"
    why = "not a type; "
    if words in ([package] for package in in_code.TYPES_OF_ROS):
        return f"{why}it names a package alone;"
    if words:
        words[-1] = in_code.with_capital(words[-1])
    if len(words) == 1:
        why += "it lacks its package; "
        words = [*in_code.packages(words[0], folder), *words]
    why += f'did you mean "{shown("::".join(words))}"?' if len(words) == 2 else ""
    return why.rstrip()


def _type(folder: str, example: str) -> Callable[[str], str]:
    """Return the format of a type in a folder of a package; it gives `package/folder/Type`."""
    forms = f"package::Type, package/Type, package/{folder}/Type, such as {example}"

    def parse(value: str) -> str:
        pattern = rf"([A-Za-z]\w*)(::|/)(?:{folder}\2)?([A-Za-z]\w*)"
        complaint = f"{_as_in_code(value, folder)} allowed: {forms}"
        match = _match(pattern, value, complaint, "invalid-type")
        package = _free(match[1], (*CPP_NAMES, *MODULES))
        if in_code.is_of_code(value):
            raise SpecError(f"{quoted(value)} is {complaint}", "invalid-type")
        if meaning(match[3], CPP_NAMES):
            check_capital(value)
        return f"{package}/{folder}/{_free(match[3], CPP_NAMES)}"

    return parse


_FIELD_TYPE = r"([\w:/]+)(?:<=([0-9]+))?(?:\[(<=)?([0-9]*)\])?"
_SYNONYMS = {
    "Header": "std_msgs/msg/Header",
    "builtin_interfaces/msg/Time": "time",
    "builtin_interfaces/msg/Duration": "duration",
}
_BIGGEST_SIZE = 2**31 - 1


def _name(
    pattern: str, complaint: str, meanings: Iterable[str] = KEYWORDS
) -> Callable[[str], str]:
    matching = _matching(pattern, complaint, "invalid-name")
    return lambda value: _free(matching(value), meanings)


# genmsg takes all names that are identifiers, rosidl those of its style.
_WORD = r"[A-Za-z]\w*"
_LETTERS = "allowed: letters, digits and underscores, a letter first"
interface_name = _name(_WORD, f"not a name of a type; {_LETTERS}")
# Decision 81: keywords of IDL are names of fields, those of Python and C++ are not.
field_name = _name(_WORD, f"not a field name; {_LETTERS}", KEYWORDS[1:])
constant_name = _name(_WORD, f"not a constant name; {_LETTERS}", KEYWORDS[1:])
_interface_name = _name(
    "[A-Z][A-Za-z0-9]*", "not a name of a type; allowed: letters and digits, a capital first"
)


def stamped_type(value: str) -> str:
    """The type of a message with a header, as far as is known."""
    found = _type("msg", "geometry_msgs/PointStamped")(value)
    package, _, name = found.split("/")
    if not re.fullmatch(_WITH_HEADER.get(package, ".*"), name):
        what = f"{quoted(value)} has no header, and so no stamp; choose a type with one"
        raise SpecError(what, "type-without-stamp")
    return found


def _field_in_code(value: str) -> str:
    meant = in_code.field(value)
    return f"did you mean {quoted(meant)}? " if meant else ""


def field_type(value: str) -> str:
    """The type of a field: primitive, `Type` of the package itself, or as a message type.

    A string may have a bound (`string<=10`), and every type may be an array: `T[3]`, `T[]`,
    `T[<=3]`. Time, duration and header have one form for both ROS, that of ROS 1.
    """
    forms = "allowed: a primitive type, Type, package::Type; [], [3] or [<=3] after it"
    id_ = "invalid-type"
    match = _match(_FIELD_TYPE, value, f"not a field type; {_field_in_code(value)}{forms}", id_)
    base, bound, limit, size = match.groups()
    for number_ in filter(None, (bound, size)):
        if not 0 < int(number_) <= _BIGGEST_SIZE:
            raise SpecError(f"{quoted(value)}: a size must be from 1 to {_BIGGEST_SIZE}", id_)
    if limit and not size:
        raise SpecError(f"{quoted(value)} is not a field type; {forms}", id_)
    if bound and base not in ("string", "wstring"):
        raise SpecError(f"{quoted(value)}: only a string has a bound; {forms}", id_)
    if in_code.is_of_code(base):
        raise SpecError(f"{quoted(base)} is no type of ROS; {_field_in_code(base)}{forms}", id_)
    if base not in (*PRIMITIVES, *_SYNONYMS):
        base = _message(base)
    base = _SYNONYMS.get(base, base)
    bound = f"<={int(bound)}" if bound else ""
    size = f"[{limit or ''}{int(size) if size else ''}]" if "[" in value else ""
    return f"{base}{bound}{size}"


def _message(type_: str) -> str:
    """Return a message type; one of the package itself has no package."""
    if "/" in type_ or ":" in type_:
        return _type("msg", "std_msgs/String")(type_)
    if not re.match("[A-Z]", type_):
        what = f"{quoted(type_)} is no primitive type; {allowed(type_, PRIMITIVES)}"
        raise SpecError(what, "invalid-type")
    return interface_name(type_)


def split_type(value: str) -> tuple[str, str, str] | None:
    """Return the package, folder and name of a type; no package where it is the spec's own.

    None for a primitive type.
    """
    base = re.split(r"[<\[]", value)[0]
    if base in PRIMITIVES:
        return None
    package, folder, name = base.split("/") if "/" in base else ("", "msg", base)
    return package, folder, name


def number(value: str) -> float:
    """A finite number."""
    try:
        result = float(value)
    except ValueError:
        result = math.nan
    if not math.isfinite(result) or "_" in value:
        point = re.sub(r"^\s*([+-]?\d+),(\d+)\s*$", r"\1.\2", value)
        hint = f"did you mean {quoted(point)}? " if point != value else ""
        form = "allowed: a finite number without a unit, such as 12.5"
        raise SpecError(f"{quoted(value)} is not a number; {hint}{form}", "invalid-value")
    return result


def double(value: str) -> float:
    """A finite number of 64 bits that the YAML parser of ROS 2 does not take for a text."""
    result = number(value)
    if 0 < abs(result) < sys.float_info.min:
        what = f"{quoted(value)} is too small; allowed: 0, or at least {sys.float_info.min}"
        raise SpecError(what, "out-of-range")
    return result


BOOLEANS = ("true", "1", "yes", "on", "false", "0", "no", "off")
"""The spellings of true, and then as many of false; capitals or not."""


def boolean(value: str) -> bool:
    """True or false, in one of the usual spellings."""
    word = value.strip(BLANKS).lower()
    if word not in BOOLEANS:
        what = f"{quoted(value)} is not a bool; allowed: {', '.join(BOOLEANS)}"
        raise SpecError(what, "invalid-value")
    return BOOLEANS.index(word) < 4


def whole(value: str) -> int:
    """A whole number of any size; with a zero before it one of base 16, 8 or 2, as `0xff`."""
    complaint = "not an int; allowed: a whole number, such as -3 or 0xff"
    digits = "0[xX][0-9a-fA-F]+|0[oO][0-7]+|0[bB][01]+|[0-9]+"
    sign, word = _match(rf"\s*([+-]?)({digits})\s*", value, complaint, "invalid-value").groups()
    if re.fullmatch("0[0-9]+", word):
        octal = f", or 0o{word.lstrip('0')} if it is octal" if re.fullmatch("[0-7]+", word) else ""
        what = (
            f"{quoted(value)} begins with 0, which C and YAML read in base 8, messages in base 10"
        )
        raise SpecError(f"{what}; write {sign}{int(word)}{octal}", "leading-zero")
    return int(sign + word, 0)


def integer(value: str) -> int:
    """A whole number of 64 bits."""
    result = whole(value)
    if not -(2**63) <= result < 2**63:
        what = f'"{value}" does not fit 64 bits; allowed: {-(2**63)} to {2**63 - 1}'
        raise SpecError(what, "out-of-range")
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
    "component_name": _as_file(identifier),
    "grouped_name": grouped_name,
    "dotted_name": dotted_name,
    "package_name": _as_file(package_name),
    "dependency": dependency,
    "relative_name": relative_name,
    "ros_name": ros_name,
    "topic_name": _topic(r"[~/A-Za-z][\w/]*"),
    "message_type": _type("msg", "std_msgs/String"),
    "stamped_type": stamped_type,
    "service_type": _type("srv", "std_srvs/Trigger"),
    "action_type": _type("action", "tf2_msgs/LookupTransform"),
    "interface_name": _as_file(interface_name),
    "field_name": field_name,
    "constant_name": constant_name,
    "field_type": field_type,
    "number": number,
    "bool": boolean,
    "int": integer,
    "double": double,
    "string": raw,
    "email": email,
    "license": license_name,
    "version": version,
    "url": url,
    "file_name": _as_file(file_name),
}
"""The names a dictionary may write after `format:`."""
_TOKEN = r"([A-Za-z_]|\{[A-Za-z_]\w*\})(\w|\{[A-Za-z_]\w*\})*"
FORMATS_OF_ROS: dict[int, dict[str, Callable[[str], Any]]] = {
    2: {
        "topic_name": _topic(rf"~|(~?/)?{_TOKEN}(/{_TOKEN})*"),
        "interface_name": _as_file(_interface_name),
        "field_name": _name(
            "[a-z][a-z0-9]*(_[a-z0-9]+)*",
            "not a field name; allowed: a-z, 0-9 and single underscores, a letter first",
        ),
        "constant_name": _name(
            "[A-Z][A-Z0-9]*(_[A-Z0-9]+)*",
            "not a constant name; allowed: A-Z, 0-9 and single underscores, a letter first",
        ),
    },
}
"""The formats that are stricter in a generation of ROS."""
TYPES = ("message_type", "stamped_type", "service_type", "action_type", "field_type")
"""The formats of types, which may be types that the spec itself declares."""


_COMPARED: dict[str, Callable[[str], str]] = {
    # An identifier used for file and class names; unique ignoring case and underscores.
    "component_name": lambda name: name.replace("_", "").lower(),
    "interface_name": str.lower,
}


def comparable(format_name: str, value: str) -> str:
    """Return that in which two values of a format differ where each must be unique."""
    return _COMPARED.get(format_name, identifier_of)(value)
