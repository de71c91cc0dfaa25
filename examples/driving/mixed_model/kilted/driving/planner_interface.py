# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of planner.

Generated from driving.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable

import builtin_interfaces.msg
from driving.ros.log import Log
import std_msgs.msg

# Types of messages, under the same names in ROS 1 and ROS 2.
InSpeed = std_msgs.msg.Float64
OutTargetSpeed = std_msgs.msg.Float64


@dataclass(frozen=True)
class PlannerConfig:
    """A snapshot of the node's parameters."""

    # Highest speed, m/s
    speed_limit: float = 1.0


class PlannerData:
    """
    The input and output messages of one cycle.

    in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
    out_<topic>: the message to publish; out_<topic>_active: whether this cycle publishes it.
    out_<topic>_subscribers: how many subscribe to it.
    """

    def __init__(self) -> None:
        """Create empty messages."""
        # Speed commanded, m/s
        self.in_speed = InSpeed()
        self.in_speed_updated = False
        # Speed planned, m/s
        self.out_target_speed = OutTargetSpeed()
        self.out_target_speed_active = True
        self.out_target_speed_subscribers = 0


@dataclass
class PlannerPassthrough:
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
