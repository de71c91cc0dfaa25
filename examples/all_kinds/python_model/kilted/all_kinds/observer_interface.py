# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
What the logic of observer sees of ROS.

Generated from all_kinds.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Any, Callable

import std_msgs.msg


@dataclass(frozen=True)
class ObserverConfig:
    """The parameters, as they are at one moment."""

    # How many to keep
    limit: int = 100


class ObserverData:
    """
    The messages of one cycle.

    in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
    out_<topic>: the message to send; out_<topic>_active: whether to send it in this cycle.
    """

    def __init__(self) -> None:
        """Start with empty messages."""
        # What the worker does
        self.in_status = std_msgs.msg.String()
        self.in_status_updated = False


@dataclass
class ObserverPassthrough:
    """What the logic may use at any time, from any of its methods."""

    # Writes to the log of ROS: log.debug(text), info, warning, error.
    log: Any

    # Returns the time of ROS in seconds.
    now: Callable[[], float]

    # Returns the time of ROS as messages carry it.
    stamp: Callable[[], Any]
