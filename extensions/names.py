"""Filters that turn the names of a spec into names in code."""

from __future__ import annotations

from jinja2 import Environment
from jinja2.ext import Extension


class NamesExtension(Extension):
    """Register the filters of this file."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        environment.filters |= {
            "identifier": identifier,
            "graph_id": graph_id,
            "ros_type": ros_type,
            "type_package": type_package,
            "type_name": type_name,
        }


def identifier(name: str) -> str:
    """Return a ROS name as one word of an identifier: `~/arm/pose` gives `arm_pose`."""
    return name.lstrip("~/").replace("/", "_")


def graph_id(name: str, owner: str) -> str:
    """Return one word for a name in the graph of all nodes; a private name is its owner's."""
    return f"{owner}_{identifier(name)}" if name.startswith("~") else identifier(name)


def ros_type(type_: str, ros: int) -> str:
    """Return a type as users of a ROS generation write it: in ROS 1 `std_msgs/String`."""
    return f"{type_package(type_)}/{type_name(type_)}" if ros == 1 else type_


def type_package(type_: str) -> str:
    """Return the package of a ROS type: `std_msgs/msg/String` gives `std_msgs`."""
    return type_.split("/")[0]


def type_name(type_: str) -> str:
    """Return the last part of a ROS type: `std_msgs/msg/String` gives `String`."""
    return type_.split("/")[-1]
