# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A tf listener and a tf broadcaster."""

from __future__ import annotations

from typing import Any, Dict, List, Optional

from all_kinds.ros.stop import Stop
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
import rospy
import tf2_ros


class Buffer(tf2_ros.Buffer):
    """A buffer that wakes lookups when a transform arrives."""

    def __init__(self, stop: Stop) -> None:
        """Create an empty buffer."""
        super().__init__()
        self._stop = stop

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Store a transform."""
        super().set_transform(transform, authority)
        self._stop.wake()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Store a static transform."""
        super().set_transform_static(transform, authority)
        self._stop.wake()


class TransformListener:
    """
    Looks up transforms from tf.

    reason: why the last lookup found nothing, or ''.
    """

    def __init__(self, stop: Stop) -> None:
        """Subscribe to tf."""
        self.reason = ''
        self._stop = stop
        self._buffer = Buffer(stop)
        self._listener = tf2_ros.TransformListener(self._buffer)

    def lookup(
        self,
        target: str,
        source: str,
        timeout: float = 0.0,
        stamp: Optional[rospy.Time] = None,
    ) -> Optional[TransformStamped]:
        """
        Return the transform that takes coordinates from frame `source` to frame `target`.

        stamp: the time of the transform; by default the latest.
        Return None if there is none after `timeout` seconds or when the node stops.
        """
        time = stamp or rospy.Time()
        found: List[TransformStamped] = []

        def is_there() -> bool:
            try:
                found.append(self._buffer.lookup_transform_core(target, source, time))
            except tf2_ros.TransformException as error:  # type: ignore[attr-defined]
                self.reason = str(error)
            return bool(found)

        if not self._stop.wait_for(is_there, timeout):
            return None
        self.reason = ''
        return found[0]


class TransformBroadcaster:
    """Publishes transforms to tf."""

    def __init__(self) -> None:
        """Create the publishers."""
        self._broadcaster = tf2_ros.TransformBroadcaster()
        self._static_broadcaster = tf2_ros.StaticTransformBroadcaster()
        self._static: Dict[str, TransformStamped] = {}

    def broadcast(self, parent: str, child: str, translation: Any, rotation: Any) -> None:
        """
        Publish the pose of frame `child` in frame `parent`, stamped with the current time.

        translation: x, y, z in metres; rotation: x, y, z, w of a unit quaternion.
        """
        self.send(self._transform(parent, child, translation, rotation))

    def broadcast_static(self, parent: str, child: str, translation: Any, rotation: Any) -> None:
        """Publish a static pose; the arguments are those of `broadcast`."""
        self.send_static(self._transform(parent, child, translation, rotation))

    def send(self, transform: TransformStamped) -> None:
        """Publish a transform as given."""
        self._broadcaster.sendTransform(transform)

    def send_static(self, transform: TransformStamped) -> None:
        """Publish a static transform with all earlier ones, as /tf_static keeps one message."""
        self._static[transform.child_frame_id] = transform
        self._static_broadcaster.sendTransform(list(self._static.values()))

    @staticmethod
    def _transform(parent: str, child: str, translation: Any, rotation: Any) -> TransformStamped:
        transform = TransformStamped()
        transform.header.stamp = rospy.Time.now()
        transform.header.frame_id = parent
        transform.child_frame_id = child
        transform.transform.translation = Vector3(*translation)
        transform.transform.rotation = Quaternion(*rotation)
        return transform
