"""What a package of messages, services and actions depends on."""

from __future__ import annotations

from typing import Any

_GENERATORS = {
    "ament_cmake",
    "catkin",
    "message_generation",
    "message_runtime",
    "rosidl_default_generators",
    "rosidl_default_runtime",
}


def dependencies(spec: dict[str, Any]) -> list[str]:
    """Return what package.xml names beside the generators and what these need at run time."""
    return [name for name in spec["depends"] if name not in _GENERATORS]
