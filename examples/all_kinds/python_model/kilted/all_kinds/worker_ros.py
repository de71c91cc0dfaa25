# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node worker: its life-cycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in worker_impl.py.
"""

from contextlib import ExitStack
from threading import Event, Lock, Thread
import traceback

from all_kinds.action_client import ActionClient
from all_kinds.action_server import ActionServer
from all_kinds.service_client import ServiceClient
from all_kinds.transforms import TransformBroadcaster, TransformListener
from all_kinds.worker import Worker
from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)
import geometry_msgs.msg
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.qos_overriding_options import QoSOverridingOptions
import std_msgs.msg
import std_srvs.srv
import test_msgs.action

FREQUENCY = 20  # Hz
QUEUE = 10  # messages kept for a topic, unless its QoS is overridden


class WorkerNode(LifecycleNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    Publishers and clients exist from configure on, subscriptions and servers while it is active.
    """

    def __init__(self, **options) -> None:
        """Declare the parameters; everything else is created in configure."""
        super().__init__('worker', **options)
        self.declare_parameter(
            'autostart',
            True,
            ParameterDescriptor(
                description='Whether the node configures and activates itself.',
                read_only=True,
            ),
        )
        self.declare_parameter(
            'prefix',
            'it\'s "said" <so> & für immer',
            ParameterDescriptor(
                description='What stands before a status, e.g. "a" < \'b\' and so on',
                read_only=True,
            ),
        )
        self.declare_parameter(
            'weights',
            (0.5, 1.0, 2000.0),
            ParameterDescriptor(
                description='Weights of the inputs',
                read_only=True,
            ),
        )
        self.declare_parameter(
            'gain',
            1.5,
            ParameterDescriptor(
                description='Gain of the output',
                floating_point_range=[
                    FloatingPointRange(
                        from_value=0.0,
                        to_value=10.0,
                    ),
                ],
            ),
        )
        self.declare_parameter(
            'step',
            1,
            ParameterDescriptor(
                description='How far to count in a cycle',
                integer_range=[
                    IntegerRange(
                        from_value=1,
                        to_value=2**63 - 1,
                        step=1,
                    ),
                ],
            ),
        )
        self.declare_parameter(
            'verbose',
            False,
            ParameterDescriptor(
                description='Whether to say more',
            ),
        )
        self.declare_parameter(
            'label',
            'worker',
            ParameterDescriptor(
                description='Name in the status',
            ),
        )
        self._config = self._read_config()
        self.add_post_set_parameters_callback(self._apply_parameters)
        self._configured = ExitStack()
        self._active = ExitStack()
        self._action_client_delegate = ActionClient(
            self,
            test_msgs.action.Fibonacci,
            'delegate',
        )
        self._action_server_compute = ActionServer(
            self,
            test_msgs.action.Fibonacci,
            'compute',
            lambda goal: self._impl.execute_compute(goal),
        )
        self._servers = {
            'action delegate': self._action_client_delegate,
        }
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

    def _read_config(self) -> WorkerConfig:
        """Return the current parameters."""
        return WorkerConfig(
            prefix=self.get_parameter('prefix').value,
            weights=tuple(self.get_parameter('weights').value),
            gain=self.get_parameter('gain').value,
            step=self.get_parameter('step').value,
            verbose=self.get_parameter('verbose').value,
            label=self.get_parameter('label').value,
        )

    def _apply_parameters(self, parameters) -> None:
        """Update the configuration with the changed parameters."""
        self._config = self._read_config()

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        listener = TransformListener(self)
        self._configured.callback(listener.close)
        broadcaster = TransformBroadcaster(self)
        self._configured.callback(self._action_client_delegate.forget)
        self._data = WorkerData()
        self._out_counter = self._advertise(
            std_msgs.msg.Int64,
            'counter',
        )
        self._out_status = self._advertise(
            std_msgs.msg.String,
            '/status',
        )
        self._impl = WorkerImpl(
            WorkerPassthrough(
                log=self.get_logger(),
                now=lambda: self.get_clock().now().nanoseconds * 1e-9,
                stamp=lambda: self.get_clock().now().to_msg(),
                pub_echo=self._advertise(
                    std_msgs.msg.String,
                    'echo',
                ),
                pub_empty=self._advertise(
                    std_msgs.msg.Empty,
                    '~/empty',
                ),
                client_permit=self._service_client(
                    std_srvs.srv.Trigger,
                    'permit',
                ),
                action_delegate=self._action_client_delegate,
                listener_frames=listener,
                broadcaster_pose=broadcaster,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions, servers and the update loop."""
        self._subscribe(
            geometry_msgs.msg.Twist,
            'speed',
            self._receive_speed,
        )
        self._subscribe(
            std_msgs.msg.Int64,
            'counter',
            self._receive_counter,
        )
        self._subscribe(
            std_msgs.msg.String,
            'say',
            Worker(self, self._impl.receive_say).run,
        )
        self._serve(
            std_srvs.srv.Empty,
            'reset',
            Worker(self, self._impl.serve_reset).run,
        )
        self._serve(
            std_srvs.srv.SetBool,
            'enable',
            Worker(self, self._impl.serve_enable).run,
        )
        self._active.enter_context(self._action_server_compute)
        timer = self.create_timer(2.0, self._report_missing_servers)
        self._active.callback(self.destroy_timer, timer)
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
        data.in_speed = received.get('speed', data.in_speed)
        data.in_speed_updated = 'speed' in received
        data.in_counter = received.get('counter', data.in_counter)
        data.in_counter_updated = 'counter' in received
        data.out_counter_active = True
        data.out_status_active = True
        self._impl.update(data, self._config)
        if data.out_counter_active:
            self._out_counter.publish(data.out_counter)
        if data.out_status_active:
            self._out_status.publish(data.out_status)

    def _receive_speed(self, message) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['speed'] = message

    def _receive_counter(self, message) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['counter'] = message

    def _report_missing_servers(self) -> None:
        """Warn about servers that are not available."""
        missing = [name for name, client in self._servers.items() if not client.is_ready()]
        if missing:
            self.get_logger().warning(
                'Waiting for ' + ', '.join(missing) + '.',
                throttle_duration_sec=10.0,
            )

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

    def _service_client(self, service_type, name) -> ServiceClient:
        """Create a client whose responses arrive while a callback waits."""
        client = self.create_client(
            service_type,
            name,
            callback_group=ReentrantCallbackGroup(),
        )
        self._configured.callback(self.destroy_client, client)
        self._servers['service ' + name] = ServiceClient(client)
        return self._servers['service ' + name]

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
    node = WorkerNode()
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
