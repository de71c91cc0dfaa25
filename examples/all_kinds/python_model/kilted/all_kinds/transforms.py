# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Coordinate transforms, read and sent."""

from time import monotonic, sleep

import geometry_msgs.msg
import rclpy.time
import tf2_ros


class TransformListener:
    """Reads the coordinate transforms that any node sends."""

    def __init__(self, node) -> None:
        """Listen to tf with a node."""
        self._buffer = tf2_ros.Buffer(node=node)
        self._listener = tf2_ros.TransformListener(self._buffer, node)

    def close(self) -> None:
        """Stop listening."""
        self._listener.unregister()

    def lookup(self, target, source, timeout: float = 0.0):
        """
        Return the latest transform (geometry_msgs.msg.TransformStamped) to `target`.

        It takes coordinates from the frame `source` to the frame `target`. Return None if there is
        none within `timeout` seconds.
        """
        end = monotonic() + timeout
        while True:
            try:
                return self._buffer.lookup_transform(target, source, rclpy.time.Time())
            except tf2_ros.TransformException:
                if monotonic() >= end:
                    return None
                sleep(0.01)


class TransformBroadcaster:
    """Sends coordinate transforms."""

    def __init__(self, node) -> None:
        """Send to tf with a node."""
        self._clock = node.get_clock()
        self._broadcaster = tf2_ros.TransformBroadcaster(node)

    def broadcast(self, parent, child, translation, rotation) -> None:
        """
        Send where the frame `child` is in the frame `parent` now.

        translation: x, y, z in metres; rotation: x, y, z, w of a unit quaternion.
        """
        transform = geometry_msgs.msg.TransformStamped()
        transform.header.stamp = self._clock.now().to_msg()
        transform.header.frame_id = parent
        transform.child_frame_id = child
        vector = transform.transform.translation
        vector.x, vector.y, vector.z = translation
        quaternion = transform.transform.rotation
        quaternion.x, quaternion.y, quaternion.z, quaternion.w = rotation
        self.send(transform)

    def send(self, transform) -> None:
        """Send a transform (geometry_msgs.msg.TransformStamped) as it is."""
        self._broadcaster.sendTransform(transform)
