"""The packages that packages of this model depend on."""

from __future__ import annotations

from typing import Any


def dependencies_from_template(ros_distro: str) -> list[str]:
    """Return the packages every package of this model needs at run time."""
    if ros_distro == "noetic":
        return ["rospy"]
    return ["launch_ros", "launch_xml", "rcl_interfaces", "rclpy"]


def dependencies_from_interface(
    kind: str, attributes: dict[str, Any], ros_distro: str
) -> list[str]:
    """Return the packages that one interface needs: that of its type, and that of its kind."""
    packages = ["actionlib"] if (kind, ros_distro) == ("actionServer", "noetic") else []
    return packages if kind == "parameter" else [*packages, attributes["type"].split("/")[0]]
