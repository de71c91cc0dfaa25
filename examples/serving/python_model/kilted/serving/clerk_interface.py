# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of clerk.

Generated from serving.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Any, Callable


@dataclass(frozen=True)
class ClerkConfig:
    """A snapshot of the node's parameters."""

    # What to say
    greeting: str = 'hello'

    # Time for a step, s
    patience: float = 0.5


@dataclass
class ClerkPassthrough:
    """Publishers, clients, transforms, clock and logger, for use in any method of the logic."""

    # The node's logger: log.debug(text), log.info, log.warning, log.error.
    log: Any

    # Returns the ROS time in seconds.
    now: Callable[[], float]

    # Returns the ROS time as a stamp for messages.
    stamp: Callable[[], Any]
