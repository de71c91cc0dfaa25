# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A tf listener and a tf broadcaster."""

from time import monotonic, sleep

import geometry_msgs.msg
import rclpy.time
import tf2_ros


class TransformListener:
    """Looks up transforms from tf."""

    def __init__(self, node) -> None:
        """Subscribe to tf."""
        self._buffer = tf2_ros.Buffer(node=node)
        self._listener = tf2_ros.TransformListener(self._buffer, node)

    def close(self) -> None:
        """Unsubscribe."""
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
    """Publishes transforms to tf."""

    def __init__(self, node) -> None:
        """Create the broadcaster."""
        self._clock = node.get_clock()
        self._broadcaster = tf2_ros.TransformBroadcaster(node)

    def broadcast(self, parent, child, translation, rotation) -> None:
        """
        Publish the pose of frame `child` in frame `parent`, stamped with the current time.

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
        """Publish a transform (geometry_msgs.msg.TransformStamped) as given."""
        self._broadcaster.sendTransform(transform)
