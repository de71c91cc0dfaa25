# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""ROS time for the logic: simulated or not."""

from __future__ import annotations

from math import inf
from typing import cast

from all_kinds.ros.stop import Stop
import builtin_interfaces.msg
from rclpy.clock import JumpThreshold, ROSClock
from rclpy.duration import Duration
from rclpy.node import Node


class RosTime:
    """The clock of a node, and sleeps that end when the node stops."""

    def __init__(self, node: Node, stop: Stop) -> None:
        """Wake sleeps whenever simulated time changes."""
        self._clock = cast(ROSClock, node.get_clock())
        self._stop = stop
        self._jumps = self._clock.create_jump_callback(
            JumpThreshold(
                min_forward=Duration(nanoseconds=1),
                min_backward=Duration(nanoseconds=-1),
                on_clock_change=True,
            ),
            post_callback=lambda _: stop.wake(),
        )

    @property
    def simulated(self) -> bool:
        """Whether time comes from /clock."""
        return self._clock.ros_time_is_active

    def now(self) -> float:
        """Return the time in seconds."""
        return self._clock.now().nanoseconds * 1e-9

    def stamp(self) -> builtin_interfaces.msg.Time:
        """Return the time as a stamp for messages."""
        return self._clock.now().to_msg()

    def wait_for_start(self) -> None:
        """Wait for the first /clock where time is simulated, or until the node stops."""
        self._stop.wait_for(lambda: not self.simulated or self.now() > 0.0, inf)

    def sleep(self, seconds: float) -> bool:
        """Wait, again if simulated time jumps back; return False at once when the node stops."""
        start = self.now()

        def is_over() -> bool:
            nonlocal start
            start = min(start, self.now())
            return self.now() >= start + seconds

        if self.simulated:
            self._stop.wait_for(is_over, inf)
        elif seconds > 0.0:
            self._stop.wait_for(lambda: False, seconds)
        return not self._stop.requested

    def close(self) -> None:
        """Stop listening to the clock."""
        self._jumps.unregister()
