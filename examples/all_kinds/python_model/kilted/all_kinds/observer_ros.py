# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node observer: its life-cycle and its connections to ROS.

Generated from all_kinds.ros_package; the logic is in observer_impl.py.
"""

from contextlib import ExitStack
from threading import Event, Lock, Thread
import traceback

from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
)
from rcl_interfaces.msg import ParameterDescriptor
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.qos_overriding_options import QoSOverridingOptions
import std_msgs.msg

FREQUENCY = 12.5  # Hz
QUEUE = 10  # messages kept for a topic, unless its QoS is overridden


class ObserverNode(LifecycleNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    What sends is connected when the node is configured, what receives when it is activated.
    """

    def __init__(self, **options) -> None:
        """Declare the parameters; the rest is done when the node is configured."""
        super().__init__('observer', **options)
        self.declare_parameter(
            'autostart',
            True,
            ParameterDescriptor(
                description='Whether the node configures and activates itself.',
                read_only=True,
            ),
        )
        self.declare_parameter(
            'limit',
            100,
            ParameterDescriptor(
                description='How many to keep',
                read_only=True,
            ),
        )
        self._config = self._read_config()
        self._configured = ExitStack()
        self._active = ExitStack()
        self._received = {}
        self._received_lock = Lock()

    def start(self) -> None:
        """Configure and activate the node, unless its parameter autostart forbids it."""
        if not self.get_parameter('autostart').value:
            return
        if self.trigger_configure() == TransitionCallbackReturn.SUCCESS:
            self.trigger_activate()

    def on_configure(self, state) -> TransitionCallbackReturn:
        """Connect what sends, then let the logic prepare itself."""
        try:
            self._connect_senders()
            if self._impl.configure(self._config):
                self._configured.callback(self._impl.cleanup)
                return super().on_configure(state)
            self.get_logger().error('The logic refuses its configuration.')
        except Exception:
            self.get_logger().error(traceback.format_exc())
        self.release()
        return TransitionCallbackReturn.FAILURE

    def on_activate(self, state) -> TransitionCallbackReturn:
        """Connect what receives, and start the loop."""
        result = super().on_activate(state)
        self._connect_receivers()
        return result

    def on_deactivate(self, state) -> TransitionCallbackReturn:
        """Stop the loop, and disconnect what receives."""
        self._active.close()
        return super().on_deactivate(state)

    def on_cleanup(self, state) -> TransitionCallbackReturn:
        """Let go of all that configuring made."""
        self.release()
        return super().on_cleanup(state)

    def on_shutdown(self, state) -> TransitionCallbackReturn:
        """End in good order, from whatever state."""
        self.release()
        return super().on_shutdown(state)

    def release(self) -> None:
        """Disconnect from ROS, and let the logic clean up."""
        self._active.close()
        try:
            self._configured.close()
        except Exception:
            self.get_logger().error(traceback.format_exc())

    def _read_config(self) -> ObserverConfig:
        """Return the parameters as they are now."""
        return ObserverConfig(
            limit=self.get_parameter('limit').value,
        )

    def _connect_senders(self) -> None:
        """Make all that the logic can use, then the logic."""
        self._data = ObserverData()
        self._impl = ObserverImpl(
            ObserverPassthrough(
                log=self.get_logger(),
                now=lambda: self.get_clock().now().nanoseconds * 1e-9,
                stamp=lambda: self.get_clock().now().to_msg(),
            ),
        )

    def _connect_receivers(self) -> None:
        """Make all that calls the logic, each from a thread of its own, and the loop."""
        self._subscribe(
            std_msgs.msg.String,
            '/status',
            self._receive_status,
        )
        stop = Event()
        loop = Thread(target=self._loop, args=(stop,), daemon=True)
        self._active.callback(loop.join, timeout=1.0)
        self._active.callback(stop.set)
        loop.start()

    def _loop(self, stop) -> None:
        """Run a cycle in every period until told to stop; skip those that come too late."""
        clock = self.get_clock()
        period = Duration(seconds=1.0 / FREQUENCY)
        due = clock.now()
        while not stop.is_set() and self.context.ok():
            try:
                self._update()
            except Exception as error:
                self.executor.create_task(fail, error)
                return
            now = clock.now()
            due = min(max(due + period, now), now + period)
            clock.sleep_until(due, self.context)

    def _update(self) -> None:
        """Run one cycle: the latest messages in, the logic, the active outputs out."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_status = received.get('status', data.in_status)
        data.in_status_updated = 'status' in received
        self._impl.update(data, self._config)

    def _receive_status(self, message) -> None:
        """Keep a message for the next cycle."""
        with self._received_lock:
            self._received['status'] = message

    def _subscribe(self, message_type, topic, callback) -> None:
        """Subscribe to a topic, whose QoS parameters can override."""
        subscription = self.create_subscription(
            message_type,
            topic,
            callback,
            QUEUE,
            callback_group=MutuallyExclusiveCallbackGroup(),
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )
        self._active.callback(self.destroy_subscription, subscription)


def fail(error) -> None:
    """End the node with an error of its loop."""
    raise error


def main(args=None) -> None:
    """Run the node until ROS shuts down."""
    rclpy.init(args=args)
    node = ObserverNode()
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
