# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node worker: its lifecycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in worker_impl.py.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from math import isfinite
from threading import Lock
from time import sleep
from typing import Any, Dict

from all_kinds.cfg import WorkerConfig as WorkerReconfigure
from all_kinds.ros import timeouts
from all_kinds.ros.deadline import Deadline
from all_kinds.ros.diagnostics import Diagnostics
from all_kinds.ros.log import Log
from all_kinds.ros.loop import Loop
from all_kinds.ros.managed_node import (
    check_range,
    check_topic,
    check_topics,
    ManagedNode,
    read_list,
    read_parameter,
)
from all_kinds.ros.process import run
from all_kinds.ros.publisher import Publisher
from all_kinds.ros.service_client import ServiceClient
from all_kinds.ros.service_server import ServiceServer
from all_kinds.ros.synchronizer import Synchronizer
from all_kinds.ros.transforms import TransformBroadcaster, TransformListener
from all_kinds.ros.worker import Worker
from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    SightingMessages,
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.server import Server as ReconfigureServer
import geometry_msgs.msg
import rospy
import std_msgs.msg
import std_srvs.srv
import test_msgs.msg

FREQUENCY = 20  # Hz


class WorkerNode(ManagedNode):
    """A node that runs its logic at a fixed frequency."""

    def __init__(self) -> None:
        """Read the parameters; everything else is created in configure."""
        super().__init__()
        default = WorkerConfig()
        self._config = WorkerConfig(
            prefix=read_parameter('prefix', default.prefix),
            echo_topic=read_parameter('echo_topic', default.echo_topic),
            call_topics=read_list('call_topics', str, default.call_topics),
            answer_topics=read_list('answer_topics', str, default.answer_topics),
            weights=read_list('weights', float, default.weights),
            gain=read_parameter('gain', default.gain),
            step=read_parameter('step', default.step),
            verbose=read_parameter('verbose', default.verbose),
            label=read_parameter('label', default.label),
        )
        check_topic('echo_topic', self._config.echo_topic)
        check_topics('call_topics', self._config.call_topics)
        check_topics('answer_topics', self._config.answer_topics)
        self._data = WorkerData()
        self._received: Dict[str, Any] = {}
        self._received_lock = Lock()
        self._deadline_speed = Deadline(0.5, self._time)
        self._deadline_say = Deadline(1, self._time)
        frequency = read_parameter('frequency', float(FREQUENCY))
        check_range('frequency', frequency, 0.001, 100000.0)
        self.loop = Loop(self._update, frequency, self._time, self._log.warning)
        self._diagnostics = Diagnostics(
            rospy.get_name(),
            self.loop,
            [
                self._deadline_speed,
                self._deadline_say,
            ],
        )
        self._diagnostics_publisher = rospy.Publisher(
            '/diagnostics',
            DiagnosticArray,
            queue_size=10,
        )
        Worker('diagnostics').submit(self._report)

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        ReconfigureServer(WorkerReconfigure, self._reconfigure)
        self._out_counter = rospy.Publisher(
            'counter',
            std_msgs.msg.Int64,
            queue_size=10,
        )
        self._out_status = rospy.Publisher(
            '/status',
            std_msgs.msg.String,
            queue_size=10,
        )
        self._impl = WorkerImpl(
            WorkerPassthrough(
                log=Log(self._log),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
                diagnostics=self._diagnostics.renew(),
                pub_echo=Publisher(
                    rospy.Publisher(
                        self._config.echo_topic.replace('~/', '~', 1),
                        std_msgs.msg.String,
                        queue_size=10,
                    ),
                ),
                pub_empty=Publisher(
                    rospy.Publisher(
                        '~empty',
                        std_msgs.msg.Empty,
                        queue_size=10,
                    ),
                ),
                pub_answer={
                    topic: Publisher(
                        rospy.Publisher(
                            topic.replace('~/', '~', 1),
                            std_msgs.msg.String,
                            queue_size=10,
                        ),
                    )
                    for topic in self._config.answer_topics
                },
                client_permit=self._client(
                    'service permit',
                    ServiceClient(
                        'permit',
                        std_srvs.srv.Trigger,
                        self.stop,
                    ),
                ),
                action_delegate=self._client(
                    'action delegate',
                    self._action_client(
                        'delegate',
                        test_msgs.msg.FibonacciAction,
                    ),
                ),
                listener_frames=TransformListener(self.stop),
                broadcaster_pose=TransformBroadcaster(),
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers, and start threads."""
        rospy.Subscriber(
            'speed',
            geometry_msgs.msg.Twist,
            self._receive_speed,
            queue_size=10,
        )
        rospy.Subscriber(
            'counter',
            std_msgs.msg.Int64,
            self._receive_counter,
            queue_size=10,
        )
        rospy.Subscriber(
            'say',
            std_msgs.msg.String,
            self._deadline_say.receiver(
                self._callback(
                    'say',
                    'receive_say',
                ).receive,
            ),
            queue_size=10,
        )
        for topic in self._config.call_topics:
            rospy.Subscriber(
                topic.replace('~/', '~', 1),
                std_msgs.msg.String,
                partial(
                    self._callback(
                        'call',
                        'receive_call',
                    ).receive,
                    topic,
                ),
                queue_size=10,
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
        rospy.Subscriber(
            'point',
            geometry_msgs.msg.PointStamped,
            synchronizer.receiver('point'),
            queue_size=10,
        )
        rospy.Subscriber(
            'motion',
            geometry_msgs.msg.TwistStamped,
            synchronizer.receiver('motion'),
            queue_size=5,
            tcp_nodelay=True,
        )
        ServiceServer(
            'reset',
            std_srvs.srv.Empty,
            self._callback('reset', 'serve_reset'),
        )
        ServiceServer(
            'enable',
            std_srvs.srv.SetBool,
            self._callback('enable', 'serve_enable'),
        )
        self._action_server(
            'compute',
            test_msgs.msg.FibonacciAction,
            'execute_compute',
            new_goal='replace',
            accept='accept_compute',
        )
        self._action_server(
            'measure',
            test_msgs.msg.FibonacciAction,
            'execute_measure',
            new_goal='parallel',
            at_once=3,
        )
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
        data.out_counter_subscribers = self._out_counter.get_num_connections()
        data.out_status_active = True
        data.out_status_subscribers = self._out_status.get_num_connections()
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

    def _report(self) -> None:
        """Publish how the node is until it ends."""
        while not rospy.is_shutdown():
            sleep(timeouts.DIAGNOSTICS_PERIOD)
            self._publish_diagnostics()

    def _publish_diagnostics(self) -> None:
        """Publish how the node is, and what its logic says."""
        report = self._diagnostics.report(self.state, self.failure, self._time.stamp())
        self._diagnostics_publisher.publish(report)

    def _reconfigure(self, values: Any, _level: int) -> Any:
        """Update the configuration with the changed parameters."""
        if not isfinite(values['gain']):
            values['gain'] = WorkerConfig().gain
        config = replace(
            self._config,
            gain=values['gain'],
            step=values['step'],
            verbose=values['verbose'],
            label=values['label'],
        )
        reason = self._refusal(config)
        if reason:
            self._log.warning(f'Parameters refused: {reason}')
            current = vars(self._config)
            values.update({name: current[name] for name in current.keys() & values.keys()})
        else:
            self._config = config
        return values


def main() -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run('worker', WorkerNode)
