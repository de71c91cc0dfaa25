"""Filters that write Python: types, values, texts, imports."""

from __future__ import annotations

import builtins
import re
import sys
from typing import Any
from unicodedata import east_asian_width

WIDTH = 99


def python_type(type_: str) -> str:
    """Return the Python name of a ROS type or of the type of a parameter.

    Decision 35: of a ROS type with its package, as types of two packages may have one name.
    """
    if type_.endswith("[]"):
        return f"Sequence[{python_type(type_[:-2])}]"
    names = {"double": "float", "string": "str"}
    return names.get(type_, type_.replace("/", "."))


def rclpy_type(type_: str) -> str:
    """Return what rclpy calls the type of a parameter: `double[]` gives `DOUBLE_ARRAY`."""
    return type_.upper().replace("INT", "INTEGER").replace("[]", "_ARRAY")


def python_module(type_: str, ros: int = 2) -> str:
    """Return the module of a ROS type: `std_msgs/msg/String` gives `std_msgs.msg`.

    In ROS 1 actions are messages.
    """
    module = ".".join(type_.split("/")[:-1])
    return module.replace(".action", ".msg") if ros == 1 else module


def python_part(type_: str, part: str, ros: int) -> str:
    """Return the Python name of a part of a service or an action, such as its `Request`."""
    name = type_.split("/")[-1]
    return f"{python_module(type_, ros)}.{name}{'' if ros == 1 else '.'}{part}"


def ros1_action(type_: str) -> str:
    """Return the Python name of the message that ROS 1 makes of an action."""
    package, _, name = type_.split("/")
    return f"{package}.msg.{name}Action"


def rospy_name(name: str) -> str:
    """Return a name as rospy resolves it right: it takes `~/pose` for `/pose`, but not `~pose`."""
    return name.replace("~/", "~", 1)


def ros1_module(type_: str) -> str:
    """Return the module of a type in ROS 1, where actions are messages."""
    return python_module(type_).replace(".action", ".msg")


def python_value(value: Any, indent: int, used: int = 0) -> str:
    """Return a value of a parameter as a literal; the arguments are those of `python_text`."""
    if isinstance(value, str):
        return python_text(value, indent, used)
    if not isinstance(value, list):
        return repr(value).replace("e+", "e")
    items = [python_value(item, indent + 4, 1) for item in value]
    line = f"({', '.join(items)}{',' if len(items) == 1 else ''})"
    if "\n" not in line and indent + used + len(line) <= WIDTH:
        return line
    margin = " " * (indent + 4)
    return "(\n" + "".join(f"{margin}{item},\n" for item in items) + " " * indent + ")"


def zero_value(type_: str) -> Any:
    """Return the value of a type that stands for none: false, 0, an empty text or list."""
    return {"bool": False, "int": 0, "double": 0.0, "string": ""}.get(type_, [])


def other_values(
    type_: str, value: Any = None, low: Any = None, high: Any = None, known: Any = None
) -> list[Any]:
    """Return values of a type other than this one, for tests: within the bounds, or of `known`.

    Each bound is among them; without it, a value far away.
    """
    if type_.endswith("[]"):
        return [[other_values(type_[:-2], *(value or ())[:1])[0]]]
    if known:
        found = [*known]
    elif type_ in ("bool", "string"):
        found = [True, False] if type_ == "bool" else ["other", "another"]
    else:
        start = value or 0
        far = [] if abs(start) >= 1e18 else [low or start - 10**6, high or start + 10**6]
        found = [
            int(each) if type_ == "int" else float(each)
            for each in (low, 0, 1, *far, high)
            if each is not None and (low is None or low <= each) and (high is None or each <= high)
        ]
    others = [
        each
        for each in dict.fromkeys(found)
        if each != (zero_value(type_) if value is None else value)
    ]
    return others or (found if value is None else [])


def refused_values(type_: str, low: Any = None, high: Any = None, known: Any = None) -> list[Any]:
    """Return values that a parameter refuses, for tests: of another type, out of its bounds."""
    found: list[Any] = ["wrong" if type_.startswith("bool") else True]
    found += [[*found]] if type_.endswith("[]") else []
    for bound, sign in ((low, -1), (high, 1)):
        step = 1 if type_ == "int" else 1e-4 * max(1.0, abs(bound or 0.0))
        if bound is not None and abs(bound) < 2**63 - 1:
            found.append(bound + sign * step)
    if known:
        found.append("none of them" if type_ == "string" else max(known) + 1)
    return found


def python_text(text: str, indent: int, used: int = 0) -> str:
    """Return a text as a string literal, split where a line would be too long.

    Args:
        text: any text.
        indent: the columns before the line the literal stands on.
        used: the columns on that line that other code takes.

    """
    if indent + used + _columns(text) <= WIDTH:
        return _literal(text)
    room = WIDTH - indent - 4
    lines = [""]
    for word in re.findall(r"\s*\S+|\s+$", text):
        for piece in [word] if _columns(word) <= room else word:
            if lines[-1] and _columns(lines[-1] + piece) > room:
                lines.append("")
            lines[-1] += piece
    margin = "\n" + " " * (indent + 4)
    return "(" + "".join(margin + _literal(line) for line in lines) + "\n" + " " * indent + ")"


def _literal(text: str) -> str:
    """Return a text in the quotes that escape less of it, as ruff has them."""
    if '"' not in text or text.count("'") <= text.count('"'):
        return repr(text)
    return '"' + repr(text)[1:-1].replace(r"\'", "'").replace('"', r"\"") + '"'


def _columns(text: str) -> int:
    """Return how wide a literal is, with wide characters as ruff counts them."""
    return sum(1 + (east_asian_width(letter) in "WF") for letter in _literal(text))


def is_builtin(name: str) -> bool:
    """Say whether a name is that of a function or class that Python has by itself."""
    return hasattr(builtins, name)


def cfg_value(value: Any) -> str:
    """Return a value as a literal for a line of its own in a .cfg file."""
    return python_value(value, 4, 1)


def sort_imports(text: str) -> str:
    """Return import statements, each once, in the order and groups ament_flake8 wants."""
    statements = set(re.findall(r"^\S.*\n(?:[ )].*\n)*", text.strip() + "\n", re.MULTILINE))
    modules = {statement: statement.split()[1] for statement in statements}
    in_order = sorted(statements, key=lambda s: (modules[s].lower(), s.startswith("from"), s))
    standard = [s for s in in_order if modules[s].split(".")[0] in sys.stdlib_module_names]
    others = [s for s in in_order if s not in standard]
    groups = [map(_unfolded, group) for group in (standard, others) if group]
    return "\n".join("".join(group) for group in groups)


def _unfolded(statement: str) -> str:
    """Give each name a line of its own where an import is too long for one."""
    if len(statement) <= WIDTH or "(" in statement:
        return statement
    head, _, names = statement.strip().partition(" import ")
    lines = "".join(f"    {name},\n" for name in names.split(", "))
    return f"{head} import (\n{lines})\n"
