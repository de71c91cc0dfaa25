"""What the templates of this model need to write C++. Each function is a filter."""

from __future__ import annotations

import itertools
import re
import textwrap
from typing import Any
from unicodedata import east_asian_width

WIDTH = 99
_LIMIT = 100  # of cpplint and uncrustify
_NO_LIMIT = "  // NOLINT(whitespace/line_length)"

# Words that the header made by dynamic_reconfigure needs for itself.
_RESERVED = ("config", "groups", "name", "params", "state", "val")


def dependencies_from_template(ros_distro: str) -> list[str]:
    """Return the packages every package of this model needs."""
    if ros_distro == "noetic":
        return ["roscpp", "rosgraph_msgs", "roslaunch"]
    return [
        "launch_ros",
        "launch_xml",
        "lifecycle_msgs",
        "rcl_interfaces",
        "rclcpp",
        "rclcpp_components",
        "rclcpp_lifecycle",
    ]


def dependencies_from_component(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that a node needs besides those of its interfaces."""
    return ["diagnostic_msgs"] if attributes["diagnostics"] else []


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that one interface needs: that of its type, and that of its kind."""
    ros1 = ros_distro == "noetic"
    name = attributes.get("name", "")
    if ros1 and kind == "dynParameter" and name in _RESERVED:
        raise ValueError(f'dynamic_reconfigure cannot make a parameter "{name}"; choose another')
    if ros1 and kind == "dynParameter":
        _check_32_bits(attributes)
    if ros_distro == "humble":
        _check_qos_of_humble(attributes)
    tf2_msgs = [] if ros1 else ["tf2_msgs"]
    packages = {
        "actionServer": ["actionlib" if ros1 else "rclcpp_action"],
        "actionClient": ["actionlib", "actionlib_msgs"] if ros1 else ["rclcpp_action"],
        "dynParameter": ["dynamic_reconfigure"] if ros1 else [],
        "listener": ["geometry_msgs", "tf2", "tf2_ros", *tf2_msgs],
        "broadcaster": ["geometry_msgs", "tf2_ros", *tf2_msgs],
    }.get(kind, [])
    type_ = attributes.get("type", "")
    return [*packages, type_.split("/")[0]] if "/" in type_ else packages


def _check_32_bits(attributes: dict[str, Any]) -> None:
    for name in ("value", "min", "max"):
        value = attributes[name]
        if isinstance(value, int) and not -(2**31) <= value < 2**31:
            raise ValueError(f"{name}: {value} does not fit the 32 bits of dynamic_reconfigure")


def _check_qos_of_humble(attributes: dict[str, Any]) -> None:
    for name in ("qos", "reliability", "durability"):
        if attributes.get(name) == "best_available":
            raise ValueError(f'{name}: Humble has no "best_available"; ROS 2 has it since Iron')


def added_packages(spec: dict[str, Any]) -> list[str]:
    """Return the packages that only <depend> names; others than libraries may be among them."""
    names = {
        "actionlib",
        "actionlib_msgs",
        "diagnostic_msgs",
        "dynamic_reconfigure",
        "launch_ros",
        "launch_xml",
        "lifecycle_msgs",
        "rcl_interfaces",
        "rclcpp",
        "rclcpp_action",
        "rclcpp_components",
        "rclcpp_lifecycle",
        "roscpp",
        "rosgraph_msgs",
        "tf2",
        "tf2_msgs",
        "tf2_ros",
    }
    for node in spec["nodes"]:
        names.update(message_packages(node))
    return [
        package
        for package in spec["depends"]
        if package not in names and re.fullmatch(r"\w+", package)
    ]


def other_packages(spec: dict[str, Any]) -> list[str]:
    """Return those of the added packages that CMake may not find: system packages, say.

    In ROS 1 every package has a CMake configuration; in ROS 2 those for Python alone have none.
    """
    sure = r"\w+_\w+|actionlib|nodelet|pluginlib|ros\w+|tf2?|urdf"
    if spec["ros"] == 2:
        sure = r"\w+_(interfaces|msgs|srvs)"
    added = [package for package in added_packages(spec) if not re.fullmatch(sure, package)]
    return sorted({*added, *build_packages(spec)})


def build_packages(spec: dict[str, Any]) -> list[str]:
    """Return those packages that are needed to build alone, as CMake may know them."""
    names = spec["other_depends"].get("build", [])
    return [name for name in names if name not in spec["depends"] and re.fullmatch(r"\w+", name)]


def required_packages(spec: dict[str, Any]) -> list[str]:
    """Return those of the dependencies that CMake must find."""
    return [
        package
        for package in spec["depends"]
        if package not in other_packages(spec)
        and re.fullmatch(r"\w+", package)
        and not package.startswith("launch")
    ]


def exported_packages(spec: dict[str, Any]) -> list[str]:
    """Return the dependencies that the headers of the package show, sorted."""
    shown = {package for node in spec["nodes"] for package in message_packages(node)}
    added = set(added_packages(spec)) - set(other_packages(spec))
    if any(node["client_library"] for node in spec["nodes"]):
        shown.add("rclcpp_lifecycle")
    return sorted(shown | added)


def message_packages(node: dict[str, Any]) -> list[str]:
    """Return the packages whose messages the interface of a node shows, sorted."""
    packages = {
        item["type"].split("/")[0]
        for items in node.values()
        if isinstance(items, list)
        for item in items
        if "/" in item.get("type", "")
    }
    if node["listeners"] or node["broadcasters"]:
        packages.add("geometry_msgs")
    return sorted(packages)


def ros1_handle(name: str) -> str:
    """Return the node handle for a name: roscpp refuses `~/name` and wants another handle."""
    return "private_" if name.startswith("~") else "node_"


def ros1_name(name: str) -> str:
    """Return a name as its node handle takes it."""
    return name.removeprefix("~/")


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


def cpp_value(value: Any, indent: int, used: int = 0) -> str:
    """Return a value of a parameter as an initializer; the arguments are those of `cpp_text`."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return cpp_text(value, indent, used)
    if not isinstance(value, list):
        # The number itself would be one too large, before the sign is applied.
        return "-9223372036854775807 - 1" if value == -(2**63) else repr(value)
    items = [cpp_value(item, indent, 3) for item in value]
    line = "{" + ", ".join(items) + "}"
    if "\n" not in line and indent + used + len(line) <= WIDTH:
        return line
    margin = "\n" + " " * (indent + 2)
    lines = (item if item.startswith("\n") else margin + item for item in items)
    return "{" + ",".join(lines) + "\n" + " " * indent + "}"


def cpp_text(text: str, indent: int, used: int = 0) -> str:
    """Return a text as a string literal, split where a line would be too long.

    Args:
        text: any text.
        indent: the columns before the line the literal stands on.
        used: the columns on that line that other code takes.

    """
    literal = f'"{cpp_escape(text)}"'
    if indent + used + _columns(text) + 2 <= WIDTH:
        return literal
    room = WIDTH - 6 - indent
    lines = [""]
    for word in re.findall(r"\s*\S+|\s+$", text):
        for piece in [word] if _columns(word) <= room else word:
            if lines[-1] and _columns(lines[-1] + piece) > room:
                lines.append("")
            lines[-1] += piece
    margin = "\n" + " " * (indent + 2)
    return "".join(f'{margin}"{cpp_escape(line)}"' for line in lines)


def _columns(text: str) -> int:
    """Return how wide a text is within a literal, with wide characters as cpplint counts them."""
    return sum(1 + (east_asian_width(letter) in "WF") for letter in cpp_escape(text))


def cpp_escape(text: str) -> str:
    """Return the text for the inside of a string literal, whatever stands in it."""
    names = {"\n": r"\n", "\t": r"\t", "\r": r"\r", '"': r"\"", "\\": r"\\"}
    letters = (
        names.get(letter) or (letter if letter.isprintable() else _octal(letter))
        for letter in text
    )
    return "".join(letters).replace("??", r"?\?")


def cpp_comment(text: str) -> str:
    """Return lines of comments with none that goes on in the next: a last backslash gets a dot.

    What cpplint has rules for stands there in small letters, where it breaks them.
    """
    text = re.sub(r"^( *// )TODO|NOLINT(?=\w*\()", _in_small_letters, text, flags=re.MULTILINE)
    return re.sub(r"(\\|\?\?/)$", r"\1.", text, flags=re.MULTILINE)


def _in_small_letters(match: re.Match[str]) -> str:
    return match[0].lower()


def launched(node: dict[str, Any]) -> list[str]:
    """Return the names by which the launch file starts a node."""
    return [instance["name"] for instance in node["instances"]] or [node["name"]]


def logic_file(node: dict[str, Any], package: str) -> str:
    """Return where the logic of a node stands."""
    return f"src/{node['name']}_impl.cpp"


def cfg_name(node: dict[str, Any]) -> str:
    """Return what dynamic_reconfigure calls the parameters of a node; `<Node>Config` is taken."""
    return f"{node['class_name']}Dynamic"


def cfg_value(value: Any) -> str:
    r"""Return a value as a literal for a .cfg file.

    dynamic_reconfigure writes texts into C++ as they are, and its whole numbers have 32 bits.
    """
    if isinstance(value, str):
        letters = (letter if letter.isascii() else _octal(letter) for letter in cpp_escape(value))
        return repr("".join(letters))
    if isinstance(value, int) and not isinstance(value, bool):
        return repr(min(max(value, -(2**31)), 2**31 - 1))
    return repr(value)


def fit(text: str) -> str:
    """Return code whose lines too long for long names are broken as uncrustify breaks them.

    It would break guards and includes, too, which cpplint wants whole: comments keep it away.
    """
    written = text.split("\n")
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
    fits = len(line) <= _LIMIT or re.fullmatch(r" *//.*https?://\S*", line)
    return line if fits else line + _NO_LIMIT


def _broken(line: str, is_value: bool = False) -> list[str]:
    """Return the lines that a line is broken into; `is_value`: it follows a sign of equality."""
    code = line.lstrip()
    if len(line) <= _LIMIT or code.startswith("#"):
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
        parts = [(0, match[1]), (0 if match[1].endswith(">") else 2, match[2])]
    elif match := re.fullmatch(r"([^=\"(]+ =) (.+)", code):
        value = " " * (indent + 2) + match[2]
        return [line[: indent + match.end(1)], *_broken(value, is_value=True)]
    else:
        parts = _parts(code, is_value)
    if len(parts) == 1:
        return [line]
    first, *rest = [" " * (indent + more) + text for more, text in parts]
    return [*_broken(first, is_value), *(part for text in rest for part in _broken(text))]


def _parts(code: str, is_value: bool) -> list[tuple[int, str]]:
    """Return what a line is broken into, each with the columns that it is indented further."""
    if match := re.fullmatch(r"(\[\[maybe_unused\]\]) (.+)", code):
        return [(0, match[1]), (0, match[2])]
    if match := re.fullmatch(r"(if \()(.+ [!=]=) (.+\)) \{", code):
        return [(0, match[1]), (2, match[2]), (2, match[3]), (0, "{")]
    if match := re.fullmatch(r"(.+ &) (\w+\()", code):
        return [(0, match[1]), (0, match[2])]
    if arguments := _arguments(code):
        return [(0, arguments[0]), *((0 if is_value else 2, each) for each in arguments[1:])]
    if match := re.fullmatch(r"([^()]*<)([\w:]+>.*)", code):
        is_nested = match[1].count("<") > 1
        further = 0 if is_value else 2
        if is_nested and (is_value or not code.endswith("(")):
            further = 4
        return [(0, match[1]), (further, match[2])]
    if match := re.fullmatch(r"(.+::)(\w.*)", code):
        # Uncrustify counts one column less than cpplint, and would join the name of a function.
        is_joined = len(code) == _LIMIT + 1 and re.fullmatch(r"(\w+ )?\w+::\w+\(", code)
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


def _octal(letter: str) -> str:
    return "".join(f"\\{byte:03o}" for byte in letter.encode())
