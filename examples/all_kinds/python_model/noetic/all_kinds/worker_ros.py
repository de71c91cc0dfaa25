# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node worker: its life-cycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in worker_impl.py.
"""

from dataclasses import replace
import logging
from threading import Lock

from all_kinds.action_client import ActionClient
from all_kinds.action_server import ActionServer
from all_kinds.cfg import WorkerConfig as WorkerReconfigure
from all_kinds.service_client import ServiceClient
from all_kinds.service_server import ServiceServer
from all_kinds.transforms import TransformBroadcaster, TransformListener
from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)
from dynamic_reconfigure.server import Server as ReconfigureServer
import geometry_msgs.msg
import rospy
import std_msgs.msg
import std_srvs.srv
import test_msgs.msg

FREQUENCY = 20  # Hz
QUEUE = 10  # messages kept for a topic


class WorkerNode:
    """A node that runs its logic at a fixed frequency until shutdown."""

    def __init__(self):
        """Read the parameters, create publishers and clients, and construct the logic."""
        default = WorkerConfig()
        self._config = WorkerConfig(
            prefix=read_parameter('prefix', default.prefix),
            weights=read_parameter('weights', default.weights),
            gain=read_parameter('gain', default.gain),
            step=read_parameter('step', default.step),
            verbose=read_parameter('verbose', default.verbose),
            label=read_parameter('label', default.label),
        )
        self._data = WorkerData()
        self._received = {}
        self._received_lock = Lock()
        self._servers = {}
        self._out_counter = rospy.Publisher(
            'counter',
            std_msgs.msg.Int64,
            queue_size=QUEUE,
        )
        self._out_status = rospy.Publisher(
            '/status',
            std_msgs.msg.String,
            queue_size=QUEUE,
        )
        self._impl = WorkerImpl(
            WorkerPassthrough(
                log=logging.getLogger('rosout'),
                now=rospy.get_time,
                stamp=rospy.Time.now,
                pub_echo=rospy.Publisher(
                    'echo',
                    std_msgs.msg.String,
                    queue_size=QUEUE,
                ),
                pub_empty=rospy.Publisher(
                    '~empty',
                    std_msgs.msg.Empty,
                    queue_size=QUEUE,
                ),
                client_permit=self._client(
                    'service permit',
                    ServiceClient('permit', std_srvs.srv.Trigger),
                ),
                action_delegate=self._client(
                    'action delegate',
                    ActionClient('delegate', test_msgs.msg.FibonacciAction),
                ),
                listener_frames=TransformListener(),
                broadcaster_pose=TransformBroadcaster(),
            ),
        )

    def run(self):
        """Configure the logic, connect its callbacks, and run the update loop until shutdown."""
        if not self._impl.configure(self._config):
            rospy.logfatal('The logic rejected its configuration.')
            return
        self._connect_receivers()
        rate = rospy.Rate(FREQUENCY, reset=True)
        try:
            while not rospy.is_shutdown():
                self._update()
                rate.sleep()
        except rospy.ROSInterruptException:
            pass
        finally:
            self._impl.cleanup()

    def _connect_receivers(self):
        """Create subscriptions and servers."""
        ReconfigureServer(WorkerReconfigure, self._reconfigure)
        rospy.Subscriber(
            'speed',
            geometry_msgs.msg.Twist,
            self._receive_speed,
            queue_size=QUEUE,
        )
        rospy.Subscriber(
            'counter',
            std_msgs.msg.Int64,
            self._receive_counter,
            queue_size=QUEUE,
        )
        rospy.Subscriber(
            'say',
            std_msgs.msg.String,
            self._impl.receive_say,
            queue_size=QUEUE,
        )
        ServiceServer(
            'reset',
            std_srvs.srv.Empty,
            self._impl.serve_reset,
        )
        ServiceServer(
            'enable',
            std_srvs.srv.SetBool,
            self._impl.serve_enable,
        )
        ActionServer(
            'compute',
            test_msgs.msg.FibonacciAction,
            self._impl.execute_compute,
        )
        rospy.Timer(rospy.Duration(2.0), self._report_missing_servers)

    def _update(self):
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

    def _receive_speed(self, message):
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['speed'] = message

    def _receive_counter(self, message):
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['counter'] = message

    def _reconfigure(self, values, _level):
        """Update the configuration with the changed parameters."""
        self._config = replace(
            self._config,
            gain=values['gain'],
            step=values['step'],
            verbose=values['verbose'],
            label=values['label'],
        )
        return values

    def _client(self, name, client):
        """Register a client for the check of missing servers."""
        self._servers[name] = client
        return client

    def _report_missing_servers(self, _event):
        """Warn about servers that are not available."""
        missing = [name for name, client in self._servers.items() if not client.is_ready()]
        if missing:
            rospy.logwarn_throttle(10.0, 'Waiting for ' + ', '.join(missing) + '.')


def read_parameter(name, default):
    """Return a private parameter; raise if its type is not that of the default."""
    value = rospy.get_param('~' + name, default)
    if isinstance(value, list):
        value = tuple(value)
    if isinstance(default, float) and type(value) is int:
        value = float(value)
    if type(value) is not type(default):
        wanted = type(default).__name__
        raise rospy.ROSInitException('Parameter %s: %r is not a %s.' % (name, value, wanted))
    return value


def main():
    """Spin the node until ROS shuts down."""
    rospy.init_node('worker')
    logging.getLogger('rosout').setLevel(rospy.get_param('~log_level', 'info').upper())
    WorkerNode().run()
