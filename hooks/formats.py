"""The formats a dictionary can ask of an attribute, each with what it makes of the text.

A format is a function from the text of the spec to a value of the context. It raises
`ValueError`, whose text says what is wrong and what is allowed.
"""

from __future__ import annotations

import keyword
import math
import re
from collections.abc import Callable
from typing import Any

import yaml
from packaging.licenses import InvalidLicenseExpression, canonicalize_license_expression

CPP_KEYWORDS = frozenset(
    """
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t
    char32_t class co_await co_return co_yield compl concept const const_cast consteval constexpr
    constinit continue decltype default delete do double dynamic_cast else enum explicit export
    extern false final float for friend goto if inline int long mutable namespace new noexcept not
    not_eq nullptr operator or or_eq override private protected public register reinterpret_cast
    requires return short signed sizeof static static_assert static_cast struct switch template
    this thread_local throw true try typedef typeid typename union unsigned using virtual void
    volatile wchar_t while xor xor_eq
    """.split()
)
"""The keywords of C++20 and its two identifiers with special meaning."""


def text(value: str) -> str:
    """Any text, without the blanks at its ends."""
    return value.strip()


def raw(value: str) -> str:
    """Any text, as it stands."""
    return value


def _no_keyword(word: str) -> None:
    languages = [
        name
        for name, found in (
            ("Python", keyword.iskeyword(word)),
            ("C++", word in CPP_KEYWORDS),
        )
        if found
    ]
    if languages:
        raise ValueError(f'"{word}" is a keyword of {" and ".join(languages)}; choose another')


def identifier(value: str) -> str:
    """A letter, then letters, digits and single underscores; no keyword."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*_?", value):
        raise ValueError(
            f'"{value}" is not a valid name; allowed: a letter, then letters, digits and'
            " single underscores"
        )
    _no_keyword(value)
    return value


def component_name(value: str) -> str:
    """An identifier that names files and classes, so two must differ by more than case and _."""
    return identifier(value)


def package_name(value: str) -> str:
    """A package name of REP 144: two or more of a-z, 0-9 and _, a letter first."""
    if not re.fullmatch(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", value) or len(value) < 2:
        raise ValueError(
            f'"{value}" is not a package name of REP 144; allowed: two or more of a-z, 0-9 and'
            " single underscores, a letter first"
        )
    _no_keyword(value)
    return value


def dependency(value: str) -> str:
    """The name of another package or a rosdep key."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_.+-]*", value):
        raise ValueError(
            f'"{value}" is not a package name; allowed: letters, digits and "_", a letter first'
        )
    return value


def ros_name(value: str) -> str:
    """A name in the ROS graph: relative, absolute (/a/b) or private (~/a, or ROS 1's ~a)."""
    prefix, name = re.fullmatch(r"(~/?|/)?(.*)", value, re.DOTALL).groups(default="")  # type: ignore[union-attr]
    if not re.fullmatch(r"[A-Za-z]\w*(/[A-Za-z]\w*)*", name, re.ASCII) or "__" in name:
        raise ValueError(
            f'"{value}" is not a valid ROS name; allowed: letters, digits, single underscores'
            ' and "/" between words that start with a letter, after "/" or "~/" if at all'
        )
    _no_keyword(name.replace("/", "_"))
    return ("~/" if prefix.startswith("~") else prefix) + name


def _interface_type(folder: str, example: str) -> Callable[[str], str]:
    def parse(value: str) -> str:
        word = r"[A-Za-z]\w*"
        match = re.fullmatch(rf"({word})(::|/)(?:{folder}\2)?({word})", value, re.ASCII)
        if not match:
            raise ValueError(
                f'"{value}" is not a type; allowed: package::Type, package/Type,'
                f" package/{folder}/Type, such as {example}"
            )
        return f"{match[1]}/{folder}/{match[3]}"

    parse.__doc__ = f"A type of a package's {folder} folder, such as {example}."
    return parse


def number(value: str) -> float:
    """A finite number."""
    try:
        result = float(value)
    except ValueError:
        result = math.nan
    if not math.isfinite(result) or "_" in value:
        raise ValueError(f'"{value}" is not a number; allowed: a finite number, such as 12.5')
    return result


def boolean(value: str) -> bool:
    """True or false, in one of the usual spellings."""
    spellings = {
        **dict.fromkeys(("true", "1", "yes", "on"), True),
        **dict.fromkeys(("false", "0", "no", "off"), False),
    }
    try:
        return spellings[value.strip().lower()]
    except KeyError:
        raise ValueError(f'"{value}" is not a bool; allowed: {", ".join(spellings)}') from None


def integer(value: str) -> int:
    """A whole number of 64 bits."""
    if not re.fullmatch(r"\s*[+-]?[0-9]+\s*", value, re.ASCII):
        raise ValueError(f'"{value}" is not an int; allowed: a whole number, such as -3')
    if not -(2**63) <= int(value) < 2**63:
        raise ValueError(f'"{value}" does not fit 64 bits; allowed: {-(2**63)} to {2**63 - 1}')
    return int(value)


def email(value: str) -> str:
    """A mail address as package.xml accepts it (catkin_pkg's own expression)."""
    if not re.fullmatch(r"[-a-zA-Z0-9_%+.]+@[-a-zA-Z0-9.]+\.[a-zA-Z]{2,}", value, re.ASCII):
        raise ValueError(f'"{value}" is not a mail address; allowed: name@host.domain')
    return value


_LICENSES = {
    "apache": "Apache-2.0",
    "apache 2": "Apache-2.0",
    "apache 2.0": "Apache-2.0",
    "apache license 2.0": "Apache-2.0",
    "apache license, version 2.0": "Apache-2.0",
    "boost software license 1.0": "BSL-1.0",
    "bsd": "BSD-3-Clause",
    "bsd license": "BSD-3-Clause",
    "gnu.org/licenses/agpl": "AGPL-3.0-only",
    "gnu.org/licenses/agpl-3.0": "AGPL-3.0-only",
    "gnu.org/licenses/gpl": "GPL-3.0-only",
    "gnu.org/licenses/gpl-3.0": "GPL-3.0-only",
    "gnu.org/licenses/lgpl": "LGPL-3.0-only",
    "gnu.org/licenses/lgpl-3.0": "LGPL-3.0-only",
    "gnu.org/licenses/old-licenses/gpl-2.0": "GPL-2.0-only",
    "gnu.org/licenses/old-licenses/lgpl-2.1": "LGPL-2.1-only",
    "gpl": "GPL-3.0-only",
    "gplv2": "GPL-2.0-only",
    "gplv3": "GPL-3.0-only",
    "lgpl": "LGPL-3.0-only",
    "lgplv2.1": "LGPL-2.1-only",
    "lgplv3": "LGPL-3.0-only",
    "mit license": "MIT",
    "mozilla public license 2.0": "MPL-2.0",
    "opensource.org/licenses/mit": "MIT",
    "opensource.org/licenses/bsd-3-clause": "BSD-3-Clause",
    "apache.org/licenses/license-2.0": "Apache-2.0",
    "public domain": "Unlicense",
}


def license_name(value: str) -> str:
    """The SPDX expression of a licence where there is one, else the text as it stands."""
    name = value.strip()
    try:
        return str(canonicalize_license_expression(name))
    except InvalidLicenseExpression:
        key = re.sub(r"^https?://(www\.)?|(\.(txt|html|en\.html))?$", "", name.lower())
        return _LICENSES.get(key, name)


FORMATS: dict[str, Callable[[str], Any]] = {
    "text": text,
    "raw": raw,
    "identifier": identifier,
    "component_name": component_name,
    "package_name": package_name,
    "dependency": dependency,
    "ros_name": ros_name,
    "message_type": _interface_type("msg", "std_msgs/String"),
    "service_type": _interface_type("srv", "std_srvs/Trigger"),
    "action_type": _interface_type("action", "test_msgs/Fibonacci"),
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
    try:
        items = yaml.load(value, Loader=yaml.BaseLoader)
    except yaml.YAMLError:
        items = None
    if not isinstance(items, list) or not items or not all(isinstance(i, str) for i in items):
        raise ValueError(
            f'"{value}" is not a {type_name}; allowed: a list such as [first, second]'
        )
    return [FORMATS[element_type](item) for item in items]


def as_identifier(name: str) -> str:
    """Return a ROS name as one word for use inside an identifier: `~/a/b` gives `a_b`."""
    return name.lstrip("~/").replace("/", "_")


def as_class_name(name: str) -> str:
    """Return the name of a class for a name: `contact_evaluate` gives `ContactEvaluate`."""
    return "".join(word[0].upper() + word[1:] for word in re.split(r"[_/~]+", name) if word)
