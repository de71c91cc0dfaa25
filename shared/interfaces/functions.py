"""What templates need to write messages, services and actions. Each function is a filter."""

from __future__ import annotations

import re
from typing import Any


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the package of a field's type."""
    base = _base(str(attributes.get("type", "")))
    if base in ("time", "duration"):
        return [] if ros_distro == "noetic" else ["builtin_interfaces"]
    return [base.split("/")[0]] if "/" in base else []


def check_interface(kind: str, attributes: dict[str, Any], ros_distro: str) -> None:
    """Refuse a field or a constant that the ROS cannot have."""
    if kind not in ("field", "constant"):
        return
    type_ = str(attributes.get("type", ""))
    ros = 1 if ros_distro == "noetic" else 2
    if ros == 1:
        _check_type(type_)
    for key in ("default", "value"):
        value = attributes.get(key)
        for item in value if isinstance(value, list) else [value]:
            _check_byte(type_, item, ros)
            if isinstance(item, str):  # only ROS 2 has defaults; in ROS 1 they are comments
                _check_text(item, isinstance(value, list), 2 if key == "default" else ros)


def _base(type_: str) -> str:
    return re.split(r"[<\[]", type_)[0]


def _check_type(type_: str) -> None:
    if "<=" in type_:
        what = f"type: ROS 1 has no bounds, as in {type_}; leave them out"
        raise ValueError(what, "not-in-ros")
    if _base(type_) == "wstring":
        what = "type: ROS 1 has no wstring; the nearest it has is string"
        raise ValueError(what, "not-in-ros")


def _check_byte(type_: str, value: Any, ros: int) -> None:
    """Refuse what is no byte: rosidl has them from 0 on, genmsg with a sign."""
    lowest, highest = (-128, 127) if ros == 1 else (0, 255)
    number = int(value, 0) if isinstance(value, str) and _base(type_) == "byte" else value
    if _base(type_) == "byte" and number is not None and not lowest <= number <= highest:
        what = f"{number} is no byte of ROS {ros}; allowed: {lowest} to {highest}"
        raise ValueError(what, "out-of-range")


def _check_text(text: str, in_list: bool, ros: int) -> None:
    """Refuse what genmsg, rosidl or the code they make would change."""
    refused = {"a line break": r"[\n\r]", "a trigraph of C": r"\?\?[=/'()!<>-]"}
    if ros == 1:
        refused |= {"a backslash": r"\\", "a blank at an end": r"^\s|\s$"}
    elif in_list:
        refused |= {"a sign beyond U+FFFF in a list": r"[^\0-\uffff]"}
    else:
        refused |= {"a backslash before a quote or another": r'\\["\\]'}
    for what, pattern in refused.items():
        if re.search(pattern, text):
            what = f"{text!r} has {what}, which ROS {ros} would change; drop it"
            raise ValueError(what, "changed-by-ros")


def members(spec: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the fields of all messages, services and actions."""
    parts = [*spec["messages"]]
    for interface in (*spec["services"], *spec["actions"]):
        parts += [part for part in interface.values() if isinstance(part, dict)]
    return [field for part in parts for field in part["fields"]]


def definitions(spec: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the messages, services and actions of the package itself."""
    return [*spec["messages"], *spec["services"], *spec["actions"]]


def defined_with(spec: dict[str, Any]) -> list[str]:
    """Return the packages whose messages the definitions contain, sorted."""
    bases = {_base(field["type"]) for field in members(spec)}
    found = {base.split("/")[0] for base in bases if "/" in base}
    if spec["ros"] == 1 and spec["actions"]:
        found |= {"actionlib_msgs", "std_msgs"}  # in the messages made of an action
    if spec["ros"] == 2 and bases & {"time", "duration"}:
        found.add("builtin_interfaces")
    return sorted(found - {spec["name"]})


def definition_files(spec: dict[str, Any]) -> list[str]:
    """Return the files of all interfaces, sorted."""
    folders = {"msg": "messages", "srv": "services", "action": "actions"}
    return sorted(
        f"{folder}/{interface['name']}.{folder}"
        for folder, key in folders.items()
        for interface in spec[key]
    )


def paragraphs(text: str) -> list[str]:
    """Return what stands between the empty lines of a text."""
    return re.split(r"\n\s*\n", text)


def comment(text: str) -> str:
    r"""Return a text as it can stand in a comment of an interface.

    What rosidl and genmsg generate repeats it in comments and strings of C, C++ and Python, where
    `\`, C's trigraph for it, `/*` and `*/` mean something.
    """
    text = text.replace("\\", "/").replace("??/", "?? /")
    return re.sub(r"(?<=\*)(?=/)|(?<=/)(?=\*)", " ", text)


def told_apart(constant: dict[str, Any], name: str, earlier: list[dict[str, Any] | None]) -> str:
    """Return the description of a constant, with one line more if a part above has the same.

    rosidl 4.9 takes constants that are alike for those of the first part, and C does not compile
    (ros2/rosidl#616); what tells them apart is their comment.
    """
    above = [one for part in earlier if part for one in part["constants"]]
    keys = ("type", "name", "description")
    is_alike = any(all(one[key] == constant[key] for key in keys) for one in above)
    told = str(constant["description"])
    return f"Of the {name}\n{told}".rstrip() if is_alike else told


def written_type(type_: str, spec: dict[str, Any]) -> str:
    """Return a type as the interfaces of a package write it."""
    base, rest = _base(type_), type_[len(_base(type_)) :]
    if spec["ros"] == 2 and base in ("time", "duration"):
        base = f"builtin_interfaces/{base.capitalize()}"
    elif "/" in base:
        package, _, name = base.split("/")
        # In ROS 1 a plain Header is that of std_msgs.
        is_own = package == spec["name"] and (spec["ros"] == 2 or name != "Header")
        base = name if is_own else f"{package}/{name}"
    return base + rest


def written_value(value: Any) -> str:
    """Return a default as rosidl reads it."""
    if isinstance(value, list):
        items = (_quoted(v, True) if isinstance(v, str) else written_value(v) for v in value)
        return f"[{', '.join(items)}]"
    if isinstance(value, bool):
        return str(value).lower()
    return _quoted(value, False) if isinstance(value, str) else str(value)


def shown_value(value: Any) -> str:
    """Return a value for people: a text as it is, in quotes."""
    if isinstance(value, list):
        return f"[{', '.join(map(shown_value, value))}]"
    return f'"{value}"' if isinstance(value, str) else written_value(value)


def shown_constant(constant: dict[str, Any]) -> str:
    """Return the value of a constant for people."""
    is_text = constant["type"] in ("string", "wstring")
    return shown_value(constant["value"]) if is_text else written_constant(constant, 2)


def written_constant(constant: dict[str, Any], ros: int) -> str:
    """Return the value of a constant as rosidl or genmsg reads it.

    In ROS 1 the text counts, not the value: the checksum of a message is made of it (decision 83).
    """
    text, type_ = str(constant["value"]), constant["type"]
    if type_ in ("string", "wstring"):
        return text if ros == 1 else _quoted(text, False)
    word = text.strip()
    if type_ == "bool" and (ros == 2 or word not in ("True", "False", "0", "1")):
        is_true = word.lower() in ("true", "1", "yes", "on")
        return written_value(is_true) if ros == 2 else str(is_true)
    return str(int(word, 0)) if re.match("[+-]?0[a-z]", word, re.IGNORECASE) else word


def _quoted(text: str, in_list: bool) -> str:
    r"""Return a text in quotes, with `\x23` for signs that mean something to rosidl.

    It reads a text two times; the items of a list, which it takes for Python's, once.
    """

    def escaped(sign: re.Match[str]) -> str:
        code = ord(sign[0])
        form = f"\\x{code:02x}" if code < 128 else f"\\u{code:04x}"
        return form if in_list else f"\\{form}"

    if in_list:
        return f'"{re.sub(_ODD_IN_LIST, escaped, text)}"'
    escaped_text = re.sub(_ODD, escaped, text).replace('"', '\\"')
    return f'"{escaped_text}"'


# rosidl drops blanks and quotes around the items of a list.
_ODD = r"[#=\\\t]"
_ODD_IN_LIST = _ODD + r"""|"|^[ ']|[^ -~]| $"""
