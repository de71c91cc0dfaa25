"""What the templates of this model need to write interfaces. Each function is a filter."""

from __future__ import annotations

import json
import re
from typing import Any

# Signs that rosidl, genmsg or what they generate would take for something else in a text.
_ODD_SIGNS = re.compile(r"""["'#=\\]|\?\?|[^ -~]""")


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the package of a field's type."""
    type_ = str(attributes.get("type", ""))
    for key in ("default", "value"):
        _check_value(type_, attributes.get(key), ros_distro)
    if ros_distro == "noetic":
        _check_type(type_)
    base = _base(type_)
    if base in ("time", "duration"):
        return [] if ros_distro == "noetic" else ["builtin_interfaces"]
    return [base.split("/")[0]] if "/" in base else []


def _base(type_: str) -> str:
    return re.split(r"[<\[]", type_)[0]


def _check_type(type_: str) -> None:
    if "<=" in type_:
        raise ValueError(f"type: ROS 1 has no bounds, as in {type_}; leave them out")
    if _base(type_) == "wstring":
        raise ValueError("type: ROS 1 has no wstring; the nearest it has is string")


def _check_value(type_: str, value: Any, ros_distro: str) -> None:
    for item in value if isinstance(value, list) else [value]:
        if isinstance(item, str) and (sign := _ODD_SIGNS.search(item)):
            allowed = "allowed: printable ASCII but for \" ' # = \\ ??"
            raise ValueError(f"{sign[0]!r} cannot be written into an interface; {allowed}")
        if isinstance(item, str) and item != item.strip():
            raise ValueError(f"{item!r}: blanks at an end are lost in ROS 1; drop them")
        if _base(type_) == "byte" and ros_distro == "noetic" and item is not None and item > 127:
            raise ValueError(f"{item} is no byte of ROS 1; allowed: 0 to 127")


def members(spec: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the fields of all messages, services and actions."""
    parts = [*spec["messages"]]
    for interface in (*spec["services"], *spec["actions"]):
        parts += [part for part in interface.values() if isinstance(part, dict)]
    return [field for part in parts for field in part["fields"]]


def message_packages(spec: dict[str, Any]) -> list[str]:
    """Return the packages whose messages the interfaces contain, sorted."""
    bases = {_base(field["type"]) for field in members(spec)}
    found = {base.split("/")[0] for base in bases if "/" in base}
    if spec["ros"] == 1 and spec["actions"]:
        found |= {"actionlib_msgs", "std_msgs"}  # in the messages made of an action
    if spec["ros"] == 2 and bases & {"time", "duration"}:
        found.add("builtin_interfaces")
    return sorted(found - {spec["name"]})


def dependencies(spec: dict[str, Any]) -> list[str]:
    """Return what package.xml names beside the generators and what these need at run time."""
    own = {"ament_cmake", "catkin", "message_generation", "message_runtime"}
    own |= {"rosidl_default_generators", "rosidl_default_runtime"}
    found = {*spec["depends"], *message_packages(spec)}
    if spec["ros"] == 2 and spec["actions"]:
        found.add("action_msgs")
    return sorted(found - own)


def files(spec: dict[str, Any]) -> list[str]:
    """Return the files of all interfaces, sorted."""
    folders = {"msg": "messages", "srv": "services", "action": "actions"}
    return sorted(
        f"{folder}/{interface['name']}.{folder}"
        for folder, key in folders.items()
        for interface in spec[key]
    )


def comment(text: str) -> str:
    r"""Return a text as it can stand in a comment of an interface.

    What rosidl and genmsg generate repeats it in comments and strings of C, C++ and Python, where
    `\`, C's trigraph for it, `/*` and `*/` mean something.
    """
    text = text.replace("\\", "/").replace("??/", "?? /")
    return re.sub(r"(?<=\*)(?=/)|(?<=/)(?=\*)", " ", text)


def written_type(type_: str, spec: dict[str, Any]) -> str:
    """Return a type as the interfaces of a package write it."""
    base, rest = _base(type_), type_[len(_base(type_)) :]
    if spec["ros"] == 2 and base in ("time", "duration"):
        base = f"builtin_interfaces/{base.capitalize()}"
    elif "/" in base:
        package, _, name = base.split("/")
        base = name if package == spec["name"] else f"{package}/{name}"
    return base + rest


def written_value(value: Any, ros: int) -> str:
    """Return a default or the value of a constant as rosidl or genmsg reads it."""
    if isinstance(value, list):
        return f"[{', '.join(written_value(item, ros) for item in value)}]"
    if isinstance(value, bool):
        return str(value) if ros == 1 else str(value).lower()
    if isinstance(value, str):
        return value if ros == 1 else json.dumps(value)
    return str(value)


def cpp_header(name: str, folder: str, spec: dict[str, Any]) -> str:
    """Return the header of an interface in C++."""
    if spec["ros"] == 1:
        return f"{spec['name']}/{name}.h"
    words = re.sub("(.)([A-Z][a-z]+)", r"\1_\2", name)
    words = re.sub("([a-z0-9])([A-Z])", r"\1_\2", words)
    return f"{spec['name']}/{folder}/{words.lower()}.hpp"
