# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of replay.

Generated from driver.ros_package; change the interface there.
"""

from dataclasses import dataclass

from driver.output_interface import (
    OutputConfig,
    OutputPassthrough,
)
import std_msgs.msg

# Types of messages, under the same names in ROS 1 and ROS 2.
PubReading = std_msgs.msg.Float64


@dataclass(frozen=True)
class ReplayConfig(OutputConfig):
    """A snapshot of the node's parameters."""

    # Where the readings are
    file: str = 'readings.txt'


@dataclass
class ReplayPassthrough(OutputPassthrough):
    """What the logic can use of ROS, in any of its methods."""
