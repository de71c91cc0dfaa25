# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A tf listener and a tf broadcaster."""

from __future__ import annotations

from typing import Any, Optional

from all_kinds.ros.stop import Stop
import builtin_interfaces.msg
from geometry_msgs.msg import TransformStamped
from rclpy.clock import JumpThreshold
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
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

    def __init__(self, node: Node, stop: Stop) -> None:
        """Subscribe to tf."""
        self.reason = ''
        self._stop = stop
        self._buffer = Buffer(stop)
        self._listener = tf2_ros.TransformListener(self._buffer, node)
        self._jumps = node.get_clock().create_jump_callback(
            JumpThreshold(
                min_forward=None,
                min_backward=Duration(nanoseconds=-1),
                on_clock_change=True,
            ),
            post_callback=lambda _: self._buffer.clear(),
        )

    def close(self) -> None:
        """Unsubscribe."""
        self._jumps.unregister()
        self._listener.unregister()

    def lookup(
        self,
        target: str,
        source: str,
        timeout: float = 0.0,
        stamp: Optional[builtin_interfaces.msg.Time] = None,
    ) -> Optional[TransformStamped]:
        """
        Return the transform that takes coordinates from frame `source` to frame `target`.

        stamp: the time of the transform; by default the latest.
        Return None if there is none after `timeout` seconds or when the node stops.
        """
        time = Time() if stamp is None else Time.from_msg(stamp)
        found: list[TransformStamped] = []

        def is_there() -> bool:
            try:
                found.append(self._buffer.lookup_transform_core(target, source, time))
            except tf2_ros.TransformException as error:
                self.reason = str(error)
            return bool(found)

        if not self._stop.wait_for(is_there, timeout):
            return None
        self.reason = ''
        return found[0]


class TransformBroadcaster:
    """Publishes transforms to tf."""

    def __init__(self, node: Node) -> None:
        """Create the publishers."""
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._node = node
        self._publisher = node.create_publisher(TFMessage, '/tf', 100)
        self._static_publisher = node.create_publisher(TFMessage, '/tf_static', latched)
        self._static: dict[str, TransformStamped] = {}

    def close(self) -> None:
        """Destroy the publishers."""
        self._node.destroy_publisher(self._publisher)
        self._node.destroy_publisher(self._static_publisher)

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
        self._publisher.publish(TFMessage(transforms=[transform]))

    def send_static(self, transform: TransformStamped) -> None:
        """Publish a static transform with all earlier ones, as /tf_static keeps one message."""
        self._static[transform.child_frame_id] = transform
        self._static_publisher.publish(TFMessage(transforms=list(self._static.values())))

    def _transform(
        self,
        parent: str,
        child: str,
        translation: Any,
        rotation: Any,
    ) -> TransformStamped:
        transform = TransformStamped()
        transform.header.stamp = self._node.get_clock().now().to_msg()
        transform.header.frame_id = parent
        transform.child_frame_id = child
        vector = transform.transform.translation
        vector.x, vector.y, vector.z = translation
        quaternion = transform.transform.rotation
        quaternion.x, quaternion.y, quaternion.z, quaternion.w = rotation
        return transform
