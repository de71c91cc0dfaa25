# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of observer.

Generated from all_kinds.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable

from all_kinds.ros.log import Log
import builtin_interfaces.msg
import geometry_msgs.msg
import std_msgs.msg

# Types of messages, under the same names in ROS 1 and ROS 2.
InStatus = std_msgs.msg.String
PairLeft = geometry_msgs.msg.PointStamped
PairRight = geometry_msgs.msg.PointStamped


@dataclass(frozen=True)
class ObserverConfig:
    """A snapshot of the node's parameters."""

    # How many to keep
    limit: int = 100


class ObserverData:
    """
    The input and output messages of one cycle.

    in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
    """

    def __init__(self) -> None:
        """Create empty messages."""
        # What the worker does
        self.in_status = InStatus()
        self.in_status_updated = False


@dataclass(frozen=True)
class PairMessages:
    """Messages whose stamps belong together, for receive_pair."""

    # The left side
    left: PairLeft

    # The right side
    right: PairRight


@dataclass
class ObserverPassthrough:
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
