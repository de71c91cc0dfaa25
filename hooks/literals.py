"""Values that a spec writes as text, of the type that another attribute names."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any

import yaml

from .faults import SpecError, quoted
from .formats import boolean, double, integer, number, raw, whole

_LONGEST_LIST = 100_000
_EXAMPLES = {
    "bool": "true, false",
    **dict.fromkeys(("double", "float32", "float64"), "0.5, 1"),
    **dict.fromkeys(("string", "wstring"), "first, second"),
}
"""What a list may hold, for those that are not of whole numbers."""
_FLOAT32_MAX = 3.4028234663852886e38


def literal(value: str, type_name: str) -> Any:
    """Return the value that `value` writes, of the type `bool`, `int`, `double`, `string`.

    Or of a primitive type of fields, such as `uint8`. With `[]` after the type, or `[3]` or
    `[<=3]`, a list written as `[a, b]`.

    Raises:
        SpecError: the text is not a value of that type, or no text is.

    """
    form = r"([^<\[]*)(?:<=(\d+))?(\[(<=)?(\d*)\])?"
    base, bound, is_list, limit, size = re.fullmatch(form, type_name).groups()  # type: ignore[union-attr]
    if base not in LITERALS:
        raise SpecError(f"no text is a value of {type_name}; drop it", "attribute-without-meaning")

    def parse(text: str) -> Any:
        found = LITERALS[base](text)
        if bound and len(found) > int(bound):
            raise SpecError(f"{quoted(text)} is too long for a {base}<={bound}", "too-long")
        return found

    if not is_list:
        return parse(value)
    if len(value) > _LONGEST_LIST:
        raise SpecError(
            f"a list of {len(value)} characters is too long; allowed: {_LONGEST_LIST}", "too-long"
        )
    try:
        items = list(_items(value))
    except (yaml.YAMLError, ValueError, OverflowError):
        article = "an" if base.startswith("int") else "a"
        example = f"allowed: a list such as [{_EXAMPLES.get(base, '1, 2')}]"
        what = f"{quoted(value)} is not {article} {type_name}; {example}"
        raise SpecError(what, "invalid-value") from None
    if size and (len(items) > int(size) if limit else len(items) != int(size)):
        raise SpecError(f"{len(items)} values do not fit {type_name}", "invalid-value")
    return [parse(item) for item in items]


def spelled(value: Any) -> str:
    """Return a value as a spec would write it: `true`, `12`, any text as it stands."""
    if isinstance(value, bool):
        return str(value).lower()
    whole_number = isinstance(value, float) and value.is_integer()
    return str(int(value) if whole_number else value)


def _between(type_name: str, lowest: int, highest: int) -> Callable[[str], int]:
    def parse(text: str) -> int:
        value = whole(text)
        if not lowest <= value <= highest:
            what = f"{value} is no {type_name}; allowed: {lowest} to {highest}"
            raise SpecError(what, "out-of-range")
        return value

    return parse


def _float32(text: str) -> float:
    value = number(text)
    if abs(value) > _FLOAT32_MAX:
        what = f"{text} is no float32; allowed: up to {_FLOAT32_MAX:.4g}"
        raise SpecError(what, "out-of-range")
    return value


LITERALS: dict[str, Callable[[str], Any]] = {
    "bool": boolean,
    "int": integer,
    "double": double,
    "float32": _float32,
    "float64": number,
    "byte": _between("byte", -128, 255),  # with a sign in ROS 1, without in ROS 2
    "char": _between("char", 0, 255),
    "string": raw,
    "wstring": raw,
}
"""The types of which a text can be a value."""
for _bits in (8, 16, 32, 64):
    _half = 2 ** (_bits - 1)
    LITERALS[f"int{_bits}"] = _between(f"int{_bits}", -_half, _half - 1)
    LITERALS[f"uint{_bits}"] = _between(f"uint{_bits}", 0, 2 * _half - 1)


def _items(value: str) -> Iterator[str]:
    """Yield the values of one YAML list, which has no other inside."""
    events = yaml.parse(value)
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
