# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of idler.

Generated from serving.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable

from serving.ros.protocols import (
    Log,
    Stamp,
)


@dataclass(frozen=True)
class IdlerConfig:
    """A snapshot of the node's parameters."""


@dataclass
class IdlerPassthrough:
    """Publishers, clients, transforms, clock and logger, for use in any method of the logic."""

    # The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
    # log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
    log: Log

    # Returns the ROS time in seconds.
    now: Callable[[], float]

    # Returns the ROS time as a stamp for messages.
    stamp: Callable[[], Stamp]

    # Waits that many seconds of ROS time; returns False at once when the node stops.
    sleep: Callable[[float], bool]

    # Has the node stop as an exception does, from any thread; the reason goes to the log.
    fail: Callable[[str], None]
