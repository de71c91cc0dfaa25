# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of sensor.

Generated from driver.ros_package; change the interface there.
"""

from dataclasses import dataclass

from driver.output_interface import (
    OutputConfig,
    OutputPassthrough,
)
from driver.ros.logic_status import LogicStatus
from driver.ros.protocols import (
    Node,
)
import std_msgs.msg

# Types of messages, under the same names in ROS 1 and ROS 2.
PubReading = std_msgs.msg.Float64


@dataclass(frozen=True)
class SensorConfig(OutputConfig):
    """A snapshot of the node's parameters."""

    # Where the sensor is
    device: str = '/dev/ttyUSB0'

    # Bits a second
    serial_baud: int = 9600

    # How long a reading may take, s
    serial_timeout: float = 0.5


@dataclass
class SensorPassthrough(OutputPassthrough):
    """What the logic can use of ROS, in any of its methods."""

    # What the logic says of itself on /diagnostics, from any thread.
    diagnostics: LogicStatus

    # The node of rclpy, for what the spec cannot say: the logic looks after what it makes of it.
    node: Node
