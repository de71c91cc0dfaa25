"""The packages that packages of this model depend on."""

from __future__ import annotations

from typing import Any

from jinja2 import Environment, pass_environment


def dependencies_from_template(ros_distro: str) -> list[str]:
    """Return the packages every package of this model needs at run time."""
    if ros_distro == "noetic":
        return ["rosgraph_msgs", "roslaunch", "rospy"]
    return ["builtin_interfaces", "launch_ros", "launch_xml", "rcl_interfaces", "rclpy"]


def check_component(kind: str, attributes: dict[str, Any], ros_distro: str) -> None:
    """Refuse types of the package itself in ROS 2: rosidl makes a Python package of its name."""
    if kind in ("message", "service", "action") and ros_distro != "noetic":
        what = (
            "in ROS 2 a package with Python has no types of its own; make one of interfaces_model"
        )
        raise ValueError(what, "not-in-ros")


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that one interface needs: that of its type, and that of its kind."""
    ros1 = ros_distro == "noetic"
    if ros1 and kind == "dynParameter" and attributes["name"] == "groups":
        what = 'dynamic_reconfigure overwrites a parameter "groups"; choose another'
        raise ValueError(what, "not-in-dynamic-reconfigure")
    packages = {
        "actionServer": ["actionlib", "actionlib_msgs"] if ros1 else [],
        "actionClient": (
            ["actionlib", "actionlib_msgs"] if ros1 else ["action_msgs", "unique_identifier_msgs"]
        ),
        "serviceClient": ["rosgraph"] if ros1 else [],
        "dynParameter": ["dynamic_reconfigure"] if ros1 else [],
        "listener": ["geometry_msgs", "tf2_ros" if ros1 else "tf2_ros_py"],
        "broadcaster": ["geometry_msgs", "tf2_ros" if ros1 else "tf2_msgs"],
        "synchronizer": ["message_filters"],
    }.get(kind, [])
    if ros1 and (attributes.get("topic_parameter") or attributes.get("for_each")):
        packages = [*packages, "rosgraph"]
    type_ = attributes.get("type", "")
    return [*packages, type_.split("/")[0]] if "/" in type_ else packages


def logic_file(node: dict[str, Any], package: str) -> str:
    """Return where the logic of a node stands."""
    return f"{package}/{node['name']}_impl.py"


@pass_environment
def topic_name(environment: Environment, topic: dict[str, Any], ros: int = 2) -> str:
    """Return the name of a topic, or the parameter that has it, as code of a node.

    Of several topics it is that of one, in a loop. rospy 1.15 takes `~/pose` for `/pose`, but not
    `~pose`.
    """
    parameter = topic["topic_parameter"]
    if topic.get("for_each") or parameter:
        member = environment.filters["member"]
        code = f"self._config.{member(parameter)}" if parameter else "topic"
        return f"{code}.replace('~/', '~', 1)" if ros == 1 else code
    return repr(topic["name"].replace("~/", "~", 1) if ros == 1 else topic["name"])


def cfg_name(node: dict[str, Any]) -> str:
    """Return what dynamic_reconfigure calls the parameters of a node."""
    return str(node["class_name"])
