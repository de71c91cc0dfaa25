# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
What the nodes with the group output have in common.

Generated from driver.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable

import builtin_interfaces.msg
from driver.ros.log import Log
from driver.ros.protocols import (
    Publisher,
)
import std_msgs.msg

# Types of messages, under the same names in ROS 1 and ROS 2.
PubReading = std_msgs.msg.Float64


@dataclass(frozen=True)
class OutputConfig:
    """A snapshot of the parameters of the group."""

    # How long one unit of the sensor is, m
    scale: float = 1.0


@dataclass
class OutputPassthrough:
    """What the logic can use of ROS, in any of its methods."""

    # The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
    # log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
    log: Log

    # Returns the ROS time in seconds.
    now: Callable[[], float]

    # Returns the ROS time as a stamp for messages.
    stamp: Callable[[], builtin_interfaces.msg.Time]

    # Waits that many seconds of ROS time; returns False at once when the node stops.
    sleep: Callable[[float], bool]

    # Stops the node with an error, as an exception would, from any thread; logs the reason.
    fail: Callable[[str], None]

    # What was measured, m
    pub_reading: Publisher[PubReading]
