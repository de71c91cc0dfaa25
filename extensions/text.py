"""Filters that make any text of a spec safe for the place where it lands."""

from __future__ import annotations

import json
import re
from typing import Any
from unicodedata import east_asian_width
from xml.sax.saxutils import escape, quoteattr

from packaging.licenses import InvalidLicenseExpression, canonicalize_license_expression
from yaml import Dumper, dump

try:
    from yaml import CDumper  # which PyYAML has where libyaml is
except ImportError:
    CDumper = Dumper  # type: ignore[assignment,misc]

_YAML_VALUES = ("false", "n", "no", "null", "off", "on", "true", "y", "yes")


def one_line(text: str) -> str:
    """Return the text with every run of blanks and line breaks made one space."""
    return " ".join(text.split())


def wrap(text: str, prefix: str = "", width: int = 99) -> str:
    """Return the text in lines of at most `width` columns, each after `prefix`.

    Wide characters (Unicode TR 11) count as two columns, as linters count them. A word that is
    longer than a line is divided, unless it is an address, which linters let pass.
    """
    lines: list[str] = []
    line = prefix
    room = width - _columns(prefix)
    for word in one_line(text).split(" "):
        for part in _parts(word, room):
            if line != prefix and _columns(f"{line} {part}") > width:
                lines.append(line)
                line = prefix
            line += part if line == prefix else f" {part}"
    return "\n".join([*lines, line]).rstrip()


def _parts(word: str, room: int) -> list[str]:
    """Return the parts of a word, of at most `room` columns."""
    if re.search("https?://", word):
        return [word]
    parts = [""]
    for letter in word:
        if _columns(parts[-1] + letter) > room:
            parts.append("")
        parts[-1] += letter
    return parts


def _columns(text: str) -> int:
    if text.isascii():
        return len(text)
    return sum(1 + (east_asian_width(letter) in "WF") for letter in text)


def xml(text: str) -> str:
    """Return the text for the inside of an XML element."""
    return escape(text)


def xml_attribute(text: str) -> str:
    """Return the text as the value of an XML attribute, in quotes."""
    return quoteattr(text)


def markdown(text: str) -> str:
    """Return the text for one cell of a Markdown table, with nothing of it markup."""
    return re.sub(r"([\\`*_{}\[\]<>#|&~$])", r"\\\1", one_line(text))


def mermaid(text: str) -> str:
    """Return the text as a quoted label of a Mermaid diagram."""
    label = one_line(text).replace("#", "#35;").replace('"', "#quot;")
    return '"' + label.replace("<", "#lt;").replace(">", "#gt;") + '"'


def yaml(value: Any) -> str:
    """Return a value as YAML, which is JSON but for floats: 1e+22 needs a dot there."""
    if isinstance(value, list):
        return f"[{', '.join(yaml(item) for item in value)}]"
    text = json.dumps(value, ensure_ascii=False)
    text = re.sub(r"[\x7f-\x9f\u2028\u2029\ufeff]", lambda sign: f"\\u{ord(sign[0]):04x}", text)
    return re.sub(r"^(-?\d+)e", r"\1.0e", text) if isinstance(value, float) else text


def answers(values: Any) -> str:
    """Return the answers of Copier as its filter `to_yaml` does, in a tenth of the time.

    libyaml 0.2.5 writes some letters as escapes that PyYAML writes as they are.
    """
    options: dict[str, Any] = {"allow_unicode": True, "default_flow_style": None, "width": 100}
    text = str(dump(values, Dumper=CDumper, **options))
    is_same = text.isascii() and "\\" not in text
    return text if is_same else str(dump(values, Dumper=Dumper, **options))


def yaml_key(name: str) -> str:
    """Return a name as a key in YAML: in quotes where YAML 1.1 takes the word for a value."""
    return f"'{name}'" if name.lower() in _YAML_VALUES else name


def plain(number: float) -> str:
    """Return a number without the dot where it is whole: `10.0` gives `10`."""
    return str(int(number)) if number == int(number) else str(number)


def is_spdx(text: str) -> bool:
    """Say whether a licence is an SPDX expression."""
    try:
        canonicalize_license_expression(text)
    except InvalidLicenseExpression:
        return False
    return True
