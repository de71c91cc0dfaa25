# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""ROS time for the logic: simulated or not."""

from __future__ import annotations

from math import inf

from all_kinds.ros.stop import Stop
from rosgraph_msgs.msg import Clock
import rospy


class RosTime:
    """
    The clock of a node, and sleeps that end when the node stops.

    simulated: whether time comes from /clock.
    """

    def __init__(self, stop: Stop) -> None:
        """Wake sleeps whenever simulated time changes."""
        self.simulated = not rospy.rostime.is_wallclock()
        self._stop = stop
        if self.simulated:
            rospy.Subscriber('/clock', Clock, lambda _: stop.wake(), queue_size=1)

    @staticmethod
    def now() -> float:
        """Return the time in seconds."""
        return float(rospy.get_time())

    @staticmethod
    def stamp() -> rospy.Time:
        """Return the time as a stamp for messages."""
        time: rospy.Time = rospy.Time.now()
        return time

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
