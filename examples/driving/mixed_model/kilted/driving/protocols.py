# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
What the logic uses of ROS, as types: the same in ROS 1 and ROS 2.

The nodes give the logic objects that talk to ROS, its tests give it those of test/harness.py.
"""

from typing import Protocol

import builtin_interfaces.msg

Stamp = builtin_interfaces.msg.Time


class Log(Protocol):
    """Writes to the ROS log."""

    def debug(self, text: str, /) -> object:
        """Write a text for debugging."""

    def info(self, text: str, /) -> object:
        """Write a text."""

    def warning(self, text: str, /) -> object:
        """Write a text about something that may go wrong."""

    def error(self, text: str, /) -> object:
        """Write a text about something that went wrong."""
