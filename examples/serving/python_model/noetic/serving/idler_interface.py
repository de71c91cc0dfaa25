# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
What the logic of idler sees of ROS.

Generated from serving.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Any, Callable


@dataclass(frozen=True)
class IdlerConfig:
    """The parameters, as they are at one moment."""


@dataclass
class IdlerPassthrough:
    """What the logic may use at any time, from any of its methods."""

    # Writes to the log of ROS: log.debug(text), info, warning, error.
    log: Any

    # Returns the time of ROS in seconds.
    now: Callable[[], float]

    # Returns the time of ROS as messages carry it.
    stamp: Callable[[], Any]
