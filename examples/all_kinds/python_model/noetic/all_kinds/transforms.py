# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A tf listener and a tf broadcaster."""

from time import monotonic, sleep

import geometry_msgs.msg
import rospy
import tf2_ros


class TransformListener:
    """Looks up transforms from tf."""

    def __init__(self):
        """Subscribe to tf."""
        self._buffer = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._buffer)

    def lookup(self, target, source, timeout=0.0):
        """
        Return the latest transform (geometry_msgs.msg.TransformStamped) to `target`.

        It takes coordinates from the frame `source` to the frame `target`. Return None if there is
        none within `timeout` seconds.
        """
        end = monotonic() + timeout
        while True:
            try:
                return self._buffer.lookup_transform(target, source, rospy.Time())
            except tf2_ros.TransformException:
                if monotonic() >= end:
                    return None
                sleep(0.01)


class TransformBroadcaster:
    """Publishes transforms to tf."""

    def __init__(self):
        """Create the broadcaster."""
        self._broadcaster = tf2_ros.TransformBroadcaster()

    def broadcast(self, parent, child, translation, rotation):
        """
        Publish the pose of frame `child` in frame `parent`, stamped with the current time.

        translation: x, y, z in metres; rotation: x, y, z, w of a unit quaternion.
        """
        transform = geometry_msgs.msg.TransformStamped()
        transform.header.stamp = rospy.Time.now()
        transform.header.frame_id = parent
        transform.child_frame_id = child
        transform.transform.translation = geometry_msgs.msg.Vector3(*translation)
        transform.transform.rotation = geometry_msgs.msg.Quaternion(*rotation)
        self.send(transform)

    def send(self, transform):
        """Publish a transform (geometry_msgs.msg.TransformStamped) as given."""
        self._broadcaster.sendTransform(transform)
