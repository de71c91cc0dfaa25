# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node clerk: its life-cycle and its connections to ROS.

Generated from serving.ros_package; the logic is in clerk_impl.py.
"""

import logging

import rospy
from serving.action_server import ActionServer
from serving.clerk_impl import ClerkImpl
from serving.clerk_interface import (
    ClerkConfig,
    ClerkPassthrough,
)
from serving.service_server import ServiceServer
import std_srvs.srv
import test_msgs.msg


class ClerkNode:
    """A node that calls its logic back from its start to its end."""

    def __init__(self):
        """Read the parameters, connect what sends, and make the logic."""
        default = ClerkConfig()
        self._config = ClerkConfig(
            greeting=read_parameter('greeting', default.greeting),
            patience=read_parameter('patience', default.patience),
        )
        self._impl = ClerkImpl(
            ClerkPassthrough(
                log=logging.getLogger('rosout'),
                now=rospy.get_time,
                stamp=rospy.Time.now,
            ),
        )

    def run(self):
        """Configure the logic, and connect what receives until ROS ends."""
        if not self._impl.configure(self._config):
            rospy.logfatal('The logic refuses its configuration.')
            return
        self._connect_receivers()
        try:
            rospy.spin()
        finally:
            self._impl.cleanup()

    def _connect_receivers(self):
        """Make all that calls the logic, each in threads of its own."""
        ServiceServer(
            'greet',
            std_srvs.srv.Trigger,
            self._impl.serve_greet,
        )
        ServiceServer(
            '~open',
            std_srvs.srv.SetBool,
            self._impl.serve_open,
        )
        ActionServer(
            'count',
            test_msgs.msg.FibonacciAction,
            self._impl.execute_count,
        )


def read_parameter(name, default):
    """Return a private parameter; refuse one that has not the type of its default."""
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
    """Run the node until ROS shuts down."""
    rospy.init_node('clerk')
    ClerkNode().run()
