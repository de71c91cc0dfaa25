# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node worker: its lifecycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in worker_impl.py.
"""

from __future__ import annotations

from functools import partial
from threading import Lock
from typing import Any, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.deadline import Deadline
from all_kinds.ros.diagnostics import Diagnostics
from all_kinds.ros.log import Log
from all_kinds.ros.loop import Loop
from all_kinds.ros.managed_node import ManagedNode
from all_kinds.ros.process import run
from all_kinds.ros.publisher import Publisher
from all_kinds.ros.synchronizer import Synchronizer
from all_kinds.ros.transforms import TransformBroadcaster, TransformListener
from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    SightingMessages,
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)
from diagnostic_msgs.msg import DiagnosticArray
import geometry_msgs.msg
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rclpy.qos import LivelinessPolicy, QoSProfile, ReliabilityPolicy
import std_msgs.msg
import std_srvs.srv
import test_msgs.action

FREQUENCY = 20  # Hz


class WorkerNode(ManagedNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    Publishers and service clients exist from configure to cleanup. Subscriptions and service
    servers exist while it is active. Action clients and action servers exist as long as the node;
    while inactive, a server rejects goals.
    """

    fixed_parameters = [
        'prefix',
        'echo_topic',
        'call_topics',
        'answer_topics',
        'weights',
    ]

    topic_parameters = [
        'echo_topic',
        'answer_topics',
        'call_topics',
    ]

    reconfigures = True

    def __init__(self, **options: Any) -> None:
        """Declare the parameters and create what lives as long as the node."""
        super().__init__('worker', **options)
        default = WorkerConfig()
        self._declare(
            'prefix',
            default.prefix,
            ParameterDescriptor(
                description='What stands before a status, e.g. "a" < \'b\' and so on',
            ),
        )
        self._declare(
            'echo_topic',
            default.echo_topic,
            ParameterDescriptor(
                description='Where things are said again',
            ),
        )
        self._declare_list(
            'call_topics',
            Parameter.Type.STRING_ARRAY,
            default.call_topics,
            ParameterDescriptor(
                description='Where to listen for calls',
            ),
        )
        self._declare_list(
            'answer_topics',
            Parameter.Type.STRING_ARRAY,
            default.answer_topics,
            ParameterDescriptor(
                description='Where to answer',
            ),
        )
        self._declare_list(
            'weights',
            Parameter.Type.DOUBLE_ARRAY,
            default.weights,
            ParameterDescriptor(
                description='Weights of the inputs',
            ),
        )
        self._declare(
            'gain',
            default.gain,
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
        self._declare(
            'step',
            default.step,
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
        self._declare(
            'verbose',
            default.verbose,
            ParameterDescriptor(
                description='Whether to say more',
            ),
        )
        self._declare(
            'label',
            default.label,
            ParameterDescriptor(
                description='Name in the status',
            ),
        )
        self.add_on_set_parameters_callback(self._reconfigure)
        self.add_post_set_parameters_callback(self._apply_parameters)
        self._action_client_delegate = self._action_client(
            test_msgs.action.Fibonacci,
            'delegate',
        )
        self._action_server_compute = self._action_server(
            test_msgs.action.Fibonacci,
            'compute',
            'execute_compute',
            new_goal='replace',
            accept='accept_compute',
        )
        self._action_server_measure = self._action_server(
            test_msgs.action.Fibonacci,
            'measure',
            'execute_measure',
            new_goal='parallel',
            at_once=3,
        )
        self._received: dict[str, Any] = {}
        self._received_lock = Lock()
        self._deadline_speed = Deadline(0.5, self._time)
        self._deadline_say = Deadline(1, self._time)
        frequency = self._declare_frequency(FREQUENCY)
        self.loop = Loop(self._update, frequency, self._time, self.get_logger().warning)
        self._diagnostics = Diagnostics(
            self.get_fully_qualified_name(),
            self.loop,
            [
                self._deadline_speed,
                self._deadline_say,
            ],
        )
        self._diagnostics_publisher = self.create_publisher(DiagnosticArray, '/diagnostics', 10)
        self.create_timer(
            timeouts.DIAGNOSTICS_PERIOD,
            self._publish_diagnostics,
            clock=Clock(clock_type=ClockType.STEADY_TIME),
        )

    def _read_config(self) -> WorkerConfig:
        """Return the current parameters."""
        return WorkerConfig(
            prefix=self.get_parameter('prefix').value,
            echo_topic=self.get_parameter('echo_topic').value,
            call_topics=tuple(self.get_parameter('call_topics').value),
            answer_topics=tuple(self.get_parameter('answer_topics').value),
            weights=tuple(self.get_parameter('weights').value),
            gain=self.get_parameter('gain').value,
            step=self.get_parameter('step').value,
            verbose=self.get_parameter('verbose').value,
            label=self.get_parameter('label').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._configured.callback(self._diagnostics.renew)
        listener = TransformListener(self, self.stop)
        self._configured.callback(listener.close)
        broadcaster = TransformBroadcaster(self)
        self._configured.callback(broadcaster.close)
        self._configured.callback(self._action_client_delegate.reset)
        self._data = WorkerData()
        self._out_counter = self._advertise(
            std_msgs.msg.Int64,
            'counter',
            QoSProfile(depth=10, deadline=Duration(seconds=0.5)),
        )
        self._out_status = self._advertise(
            std_msgs.msg.String,
            '/status',
            QoSProfile(depth=10, lifespan=Duration(seconds=2)),
        )
        self._impl = WorkerImpl(
            WorkerPassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
                diagnostics=self._diagnostics.renew(),
                pub_echo=Publisher(
                    self._advertise(
                        std_msgs.msg.String,
                        self._config.echo_topic,
                        QoSProfile(
                            depth=10,
                            liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
                            liveliness_lease_duration=Duration(seconds=5),
                        ),
                    ),
                ),
                pub_empty=Publisher(
                    self._advertise(
                        std_msgs.msg.Empty,
                        '~/empty',
                    ),
                ),
                pub_answer={
                    topic: Publisher(
                        self._advertise(
                            std_msgs.msg.String,
                            topic,
                        ),
                    )
                    for topic in self._config.answer_topics
                },
                client_permit=self._service_client(
                    std_srvs.srv.Trigger,
                    'permit',
                    QoSProfile(depth=1),
                ),
                action_delegate=self._action_client_delegate,
                listener_frames=listener,
                broadcaster_pose=broadcaster,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers, and start threads."""
        self._received = {}
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
            self._deadline_say.receiver(
                self._callback(
                    'say',
                    'receive_say',
                ).receive,
            ),
        )
        for topic in self._config.call_topics:
            self._subscribe(
                std_msgs.msg.String,
                topic,
                partial(
                    self._callback(
                        'call',
                        'receive_call',
                    ).receive,
                    topic,
                ),
            )
        synchronizer = Synchronizer(
            self._callback(
                'sighting',
                'receive_sighting',
            ),
            SightingMessages,
            queue_size=10,
            slop=0.05,
        )
        self._subscribe(
            geometry_msgs.msg.PointStamped,
            'point',
            synchronizer.receiver('point'),
            callback_group=synchronizer.callback_group,
        )
        self._subscribe(
            geometry_msgs.msg.TwistStamped,
            'motion',
            synchronizer.receiver('motion'),
            QoSProfile(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5),
            callback_group=synchronizer.callback_group,
        )
        self._serve(
            std_srvs.srv.Empty,
            'reset',
            'serve_reset',
        )
        self._serve(
            std_srvs.srv.SetBool,
            'enable',
            'serve_enable',
            QoSProfile(reliability=ReliabilityPolicy.BEST_EFFORT, depth=20),
        )
        self._action_server_compute.accept_goals(True)
        self._action_server_measure.accept_goals(True)
        self._logic.beside(
            'late_speed',
            self._deadline_speed.watch,
            self._impl.late_speed,
            'speed',
        )
        self._logic.beside(
            'late_say',
            self._deadline_say.watch,
            self._impl.late_say,
            'say',
        )
        self._logic.repeat('read', self._impl.read)
        self._call_at(4, 'poll')

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
        data.out_counter_subscribers = self._out_counter.get_subscription_count()
        data.out_status_active = True
        data.out_status_subscribers = self._out_status.get_subscription_count()
        self._impl.update(data, self._config)
        if data.out_counter_active:
            self._out_counter.publish(data.out_counter)
        if data.out_status_active:
            self._out_status.publish(data.out_status)

    def _receive_speed(self, message: Any) -> None:
        """Store the message for the next cycle."""
        self._deadline_speed.heard()
        with self._received_lock:
            self._received['speed'] = message

    def _receive_counter(self, message: Any) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['counter'] = message

    def _publish_diagnostics(self) -> None:
        """Publish how the node is, and what its logic says."""
        report = self._diagnostics.report(self.state, self.failure, self._time.stamp())
        self._diagnostics_publisher.publish(report)


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(WorkerNode, args)
