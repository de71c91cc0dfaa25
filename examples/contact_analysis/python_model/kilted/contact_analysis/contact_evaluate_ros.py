# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The node contact_evaluate: its life-cycle and its ROS interfaces.

Generated from contact_analysis.ros_package; the logic is in contact_evaluate_impl.py.
"""

from contextlib import ExitStack
from threading import Event, Lock, Thread
import traceback

from contact_analysis.action_server import ActionServer
from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
)
from contact_analysis.worker import Worker
import contact_msgs.action
import contact_msgs.msg
import contact_msgs.srv
import geometry_msgs.msg
from rcl_interfaces.msg import ParameterDescriptor
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.qos_overriding_options import QoSOverridingOptions

FREQUENCY = 1000  # Hz
QUEUE = 10  # messages kept for a topic, unless its QoS is overridden


class ContactEvaluateNode(LifecycleNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    Publishers and clients exist from configure on, subscriptions and servers while it is active.
    """

    def __init__(self, **options) -> None:
        """Declare the parameters; everything else is created in configure."""
        super().__init__('contact_evaluate', **options)
        self.declare_parameter(
            'autostart',
            True,
            ParameterDescriptor(
                description='Whether the node configures and activates itself.',
                read_only=True,
            ),
        )
        self.declare_parameter(
            'samples',
            200,
            ParameterDescriptor(
                description='number of samples accumulated for learning',
                read_only=True,
            ),
        )
        self.declare_parameter(
            'pub_sample',
            True,
            ParameterDescriptor(
                description='Whether cop sampled should be published',
            ),
        )
        self._config = self._read_config()
        self.add_post_set_parameters_callback(self._apply_parameters)
        self._configured = ExitStack()
        self._active = ExitStack()
        self._action_server_learn = ActionServer(
            self,
            contact_msgs.action.LearnContact,
            'learn',
            lambda goal: self._impl.execute_learn(goal),
        )
        self._action_server_evaluate = ActionServer(
            self,
            contact_msgs.action.EvaluateContact,
            'evaluate',
            lambda goal: self._impl.execute_evaluate(goal),
        )
        self._received = {}
        self._received_lock = Lock()

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
        """Create subscriptions and servers, and start the update loop."""
        result = super().on_activate(state)
        self._connect_receivers()
        return result

    def on_deactivate(self, state) -> TransitionCallbackReturn:
        """Stop the update loop and destroy subscriptions and servers."""
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

    def _read_config(self) -> ContactEvaluateConfig:
        """Return the current parameters."""
        return ContactEvaluateConfig(
            samples=self.get_parameter('samples').value,
            pub_sample=self.get_parameter('pub_sample').value,
        )

    def _apply_parameters(self, parameters) -> None:
        """Update the configuration with the changed parameters."""
        self._config = self._read_config()

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._data = ContactEvaluateData()
        self._impl = ContactEvaluateImpl(
            ContactEvaluatePassthrough(
                log=self.get_logger(),
                now=lambda: self.get_clock().now().nanoseconds * 1e-9,
                stamp=lambda: self.get_clock().now().to_msg(),
                pub_plot_learn_cop=self._advertise(
                    contact_msgs.msg.PointArray,
                    'plot_learn_cop',
                ),
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions, servers and the update loop."""
        self._subscribe(
            geometry_msgs.msg.Point,
            'cop',
            self._receive_cop,
        )
        self._serve(
            contact_msgs.srv.SetString,
            'load',
            Worker(self, self._impl.serve_load).run,
        )
        self._serve(
            contact_msgs.srv.SetString,
            'store',
            Worker(self, self._impl.serve_store).run,
        )
        self._active.enter_context(self._action_server_learn)
        self._active.enter_context(self._action_server_evaluate)
        stop = Event()
        loop = Thread(target=self._loop, args=(stop,), daemon=True)
        self._active.callback(loop.join, timeout=1.0)
        self._active.callback(stop.set)
        loop.start()

    def _loop(self, stop) -> None:
        """Run update at FREQUENCY until stopped; skip missed cycles."""
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
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_cop = received.get('cop', data.in_cop)
        data.in_cop_updated = 'cop' in received
        self._impl.update(data, self._config)

    def _receive_cop(self, message) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['cop'] = message

    def _advertise(self, message_type, topic):
        """Create a publisher that allows QoS overrides."""
        publisher = self.create_lifecycle_publisher(
            message_type,
            topic,
            QUEUE,
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )
        self._configured.callback(self.destroy_lifecycle_publisher, publisher)
        return publisher

    def _subscribe(self, message_type, topic, callback) -> None:
        """Create a subscription that allows QoS overrides."""
        subscription = self.create_subscription(
            message_type,
            topic,
            callback,
            QUEUE,
            callback_group=MutuallyExclusiveCallbackGroup(),
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )
        self._active.callback(self.destroy_subscription, subscription)

    def _serve(self, service_type, name, callback) -> None:
        """Create a service server."""
        service = self.create_service(
            service_type,
            name,
            callback,
            callback_group=MutuallyExclusiveCallbackGroup(),
        )
        self._active.callback(self.destroy_service, service)


def fail(error) -> None:
    """Re-raise an exception of the update loop in the executor."""
    raise error


def main(args=None) -> None:
    """Spin the node until ROS shuts down."""
    rclpy.init(args=args)
    node = ContactEvaluateNode()
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
