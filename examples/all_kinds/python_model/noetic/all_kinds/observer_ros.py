# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node observer: its life-cycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in observer_impl.py.
"""

import logging
from threading import Lock

from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
)
import rospy
import std_msgs.msg

FREQUENCY = 12.5  # Hz
QUEUE = 10  # messages kept for a topic


class ObserverNode:
    """A node that runs its logic at a fixed frequency until shutdown."""

    def __init__(self):
        """Read the parameters, create publishers and clients, and construct the logic."""
        default = ObserverConfig()
        self._config = ObserverConfig(
            limit=read_parameter('limit', default.limit),
        )
        self._data = ObserverData()
        self._received = {}
        self._received_lock = Lock()
        self._impl = ObserverImpl(
            ObserverPassthrough(
                log=logging.getLogger('rosout'),
                now=rospy.get_time,
                stamp=rospy.Time.now,
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
        rospy.Subscriber(
            '/status',
            std_msgs.msg.String,
            self._receive_status,
            queue_size=QUEUE,
        )

    def _update(self):
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_status = received.get('status', data.in_status)
        data.in_status_updated = 'status' in received
        self._impl.update(data, self._config)

    def _receive_status(self, message):
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['status'] = message


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
    rospy.init_node('observer')
    logging.getLogger('rosout').setLevel(rospy.get_param('~log_level', 'info').upper())
    ObserverNode().run()
