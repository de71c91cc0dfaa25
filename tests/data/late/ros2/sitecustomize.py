"""Let nodes of rclpy be inactive for a second before they become active."""

import time

from rclpy.lifecycle import LifecycleNode

at_once = LifecycleNode.trigger_activate


def late(self):
    time.sleep(1.0)
    return at_once(self)


LifecycleNode.trigger_activate = late
