# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node idler: its life-cycle and its ROS interfaces.

Generated from serving.ros_package; the logic is in idler_impl.py.
"""

from contextlib import ExitStack
from threading import Thread
import traceback

from rcl_interfaces.msg import ParameterDescriptor
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from serving.idler_impl import IdlerImpl
from serving.idler_interface import (
    IdlerConfig,
    IdlerPassthrough,
)


class IdlerNode(LifecycleNode):
    """
    A managed node that calls its logic back while it is active.

    Publishers and clients exist from configure on, subscriptions and servers while it is active.
    """

    def __init__(self, **options) -> None:
        """Declare the parameters; everything else is created in configure."""
        super().__init__('idler', **options)
        self.declare_parameter(
            'autostart',
            True,
            ParameterDescriptor(
                description='Whether the node configures and activates itself.',
                read_only=True,
            ),
        )
        self._config = self._read_config()
        self._configured = ExitStack()
        self._active = ExitStack()

    def start(self) -> None:
        """Configure and activate the node if autostart is true."""
        if not self.get_parameter('autostart').value:
            return
        if self.trigger_configure() == TransitionCallbackReturn.SUCCESS:
            self.trigger_activate()

    def on_configure(self, state) -> TransitionCallbackReturn:
        """Create publishers and clients, then configure the logic."""
        try:
            self._connect_senders()
            if self._impl.configure(self._config):
                self._configured.callback(self._impl.cleanup)
                return super().on_configure(state)
            self.get_logger().error('The logic rejected its configuration.')
        except Exception:
            self.get_logger().error(traceback.format_exc())
        self.release()
        return TransitionCallbackReturn.FAILURE

    def on_activate(self, state) -> TransitionCallbackReturn:
        """Create subscriptions and servers."""
        result = super().on_activate(state)
        self._connect_receivers()
        return result

    def on_deactivate(self, state) -> TransitionCallbackReturn:
        """Destroy subscriptions and servers."""
        self._active.close()
        return super().on_deactivate(state)

    def on_cleanup(self, state) -> TransitionCallbackReturn:
        """Release everything created in configure."""
        self.release()
        return super().on_cleanup(state)

    def on_shutdown(self, state) -> TransitionCallbackReturn:
        """Shut down from any state."""
        self.release()
        return super().on_shutdown(state)

    def release(self) -> None:
        """Destroy all connections to ROS and clean up the logic."""
        self._active.close()
        try:
            self._configured.close()
        except Exception:
            self.get_logger().error(traceback.format_exc())

    def _read_config(self) -> IdlerConfig:
        """Return the current parameters."""
        return IdlerConfig()

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = IdlerImpl(
            IdlerPassthrough(
                log=self.get_logger(),
                now=lambda: self.get_clock().now().nanoseconds * 1e-9,
                stamp=lambda: self.get_clock().now().to_msg(),
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""


def main(args=None) -> None:
    """Spin the node until ROS shuts down."""
    rclpy.init(args=args)
    node = IdlerNode()
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    Thread(target=node.start, daemon=True).start()
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.release()
        node.destroy_node()
        rclpy.try_shutdown()
