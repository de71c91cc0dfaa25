"""What the templates of this model need to write C++. Each function is a filter."""

from __future__ import annotations

import re
from typing import Any
from unicodedata import east_asian_width

from jinja2 import Environment, pass_environment

WIDTH = 99

# Words that the header made by dynamic_reconfigure needs for itself.
_RESERVED = ("config", "groups", "name", "params", "state", "val")

# Decision 157: what CMake finds for a package of the system, and links, by rosdep's name.
_SYSTEM = {
    "boost": ("Boost", "Boost::boost"),
    "eigen": ("Eigen3", "Eigen3::Eigen"),
    "fmt": ("fmt", "fmt::fmt"),
    "libceres-dev": ("Ceres", "${CERES_LIBRARIES}"),
    "libopencv-dev": ("OpenCV", "${OpenCV_LIBS}"),
    "libpcl-all-dev": ("PCL", "${PCL_LIBRARIES}"),
    "nlohmann-json-dev": ("nlohmann_json", "nlohmann_json::nlohmann_json"),
    "yaml-cpp": ("yaml-cpp", "${YAML_CPP_LIBRARIES}"),
}


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


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that one interface needs: that of its type, and that of its kind."""
    ros1 = ros_distro == "noetic"
    name = attributes.get("name", "")
    if ros1 and kind == "dynParameter" and name in _RESERVED:
        what = f'dynamic_reconfigure cannot make a parameter "{name}"; choose another'
        raise ValueError(what, "not-in-dynamic-reconfigure")
    packages = {
        "actionServer": ["actionlib" if ros1 else "rclcpp_action"],
        "actionClient": ["actionlib", "actionlib_msgs"] if ros1 else ["rclcpp_action"],
        "dynParameter": ["dynamic_reconfigure"] if ros1 else [],
        "listener": ["geometry_msgs", "tf2", "tf2_ros", *([] if ros1 else ["tf2_msgs"])],
        "broadcaster": ["geometry_msgs", "tf2_ros"],
        "synchronizer": ["message_filters"],
    }.get(kind, [])
    type_ = attributes.get("type", "")
    if not ros1 and kind == "field" and re.match(r"(time|duration)\b", type_):
        return ["builtin_interfaces"]
    return [*packages, type_.split("/")[0]] if "/" in type_ else packages


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
        "message_filters",
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
        package for package in spec["depends"] if package not in names and is_for_cmake(package)
    ]


def linked_packages(spec: dict[str, Any], node: dict[str, Any]) -> list[str]:
    """Return the packages that <depend> names, but for those whose types the node has."""
    own = {*message_packages(node), *(["rclcpp_lifecycle"] if node["client_library"] else [])}
    return [
        package
        for package in spec["declared"]
        if package not in own and is_for_cmake(package) and not is_for_launch(package)
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
    return [name for name in names if name not in spec["depends"] and is_for_cmake(name)]


def required_packages(spec: dict[str, Any]) -> list[str]:
    """Return those of the dependencies that CMake must find."""
    return [
        package
        for package in spec["depends"]
        if package not in other_packages(spec)
        and is_for_cmake(package)
        and not is_for_launch(package)
    ]


def is_for_cmake(package: str) -> bool:
    """Say whether CMake may know a package: rosdep has names that it has not."""
    return is_of_the_system(package) or bool(re.fullmatch(r"\w+", package))


def is_of_the_system(package: str) -> bool:
    """Say whether a package is none of ROS, and CMake is known to know it."""
    return package in _SYSTEM


def cmake_name(package: str) -> str:
    """Return what CMake finds for a package."""
    return _SYSTEM[package][0] if package in _SYSTEM else package


def cmake_library(package: str, ros: int = 2) -> str:
    """Return what is linked of a package."""
    own = f"${{{package}_{'LIBRARIES' if ros == 1 else 'TARGETS'}}}"
    return _SYSTEM[package][1] if package in _SYSTEM else own


def types_library(package: str, spec: dict[str, Any]) -> str:
    """Return what is linked, in ROS 2, of a package whose types a node has; it may be its own."""
    return "${own_types}" if package == spec["name"] else cmake_library(package)


def main_target(node: dict[str, Any], spec: dict[str, Any]) -> str:
    """Return the target of a node's program in ROS 2.

    Where a package has types, rosidl has the name of the package for a target of its own.
    """
    has_types = spec["messages"] or spec["services"] or spec["actions"]
    name = str(node["name"])
    return f"{name}-program" if has_types and name == spec["name"] else name


def is_for_launch(package: str) -> bool:
    """Say whether a package is there to start nodes: no code is built with it."""
    return package == "roslaunch" or package.startswith("launch")


def exported_packages(spec: dict[str, Any]) -> list[str]:
    """Return the dependencies that the headers of the package show, sorted."""
    shown = {package for node in spec["nodes"] for package in message_packages(node)}
    linked = {package for node in spec["nodes"] for package in linked_packages(spec, node)}
    if any(node["client_library"] for node in spec["nodes"]):
        shown.add("rclcpp_lifecycle")
    others = set(other_packages(spec)) - set(_SYSTEM)
    return sorted(map(cmake_name, (shown | linked - others) - {spec["name"]}))


def message_packages(node: dict[str, Any]) -> list[str]:
    """Return the packages whose messages the interface of a node shows, sorted."""
    packages = {
        item["type"].split("/")[0]
        for items in (*node.values(), *(each["inputs"] for each in node["synchronizers"]))
        if isinstance(items, list)
        for item in items
        if "/" in item.get("type", "")
    }
    if node["listeners"] or node["broadcasters"]:
        packages.add("geometry_msgs")
    return sorted(packages)


def cpp_bases(names: list[str]) -> str:
    """Return what names the bases of a class; nothing for none."""
    return f" : {', '.join(names)}" if names else ""


@pass_environment
def cpp_topic(
    environment: Environment, topic: dict[str, Any], ros: int = 2, config: str = "config_"
) -> str:
    """Return the name of a topic, or the parameter that has it or several, as code of a node."""
    if not (parameter := topic["topic_parameter"] or topic.get("for_each")):
        return f'"{ros1_name(topic["name"]) if ros == 1 else topic["name"]}"'
    member = environment.filters["member"](parameter)
    if topic.get("for_each"):
        return f"{config}->{member}" if ros == 1 else f"std::atomic_load(config_.get())->{member}"
    if ros == 1:
        return f"ros::names::resolve({config}->{member}, false)"
    return f"std::atomic_load(config_.get())->{member}"


def cpp_topic_handle(topic: dict[str, Any]) -> str:
    """Return the node handle for a topic; the name in a parameter is resolved."""
    return "node_" if topic["topic_parameter"] else ros1_handle(topic["name"])


@pass_environment
def cpp_input(environment: Environment, topic: dict[str, Any], config: str) -> str:
    """Return the name of an input in ROS 1, all of which have the node handle of one thread."""
    if topic["topic_parameter"] or not topic["name"].startswith("~"):
        return cpp_topic(environment, topic, 1, config)
    return f'ros::names::resolve("~{ros1_name(topic["name"])}", false)'


def ros1_handle(name: str) -> str:
    """Return the node handle for a name: roscpp refuses `~/name` and wants another handle."""
    return "private_" if name.startswith("~") else "node_"


def ros1_name(name: str) -> str:
    """Return a name as its node handle takes it."""
    return name.removeprefix("~/")


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
    return repr(value).replace("e+", "e")


def _octal(letter: str) -> str:
    return "".join(f"\\{byte:03o}" for byte in letter.encode())
