# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node clerk: its life-cycle and its ROS interfaces.

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
        """Read the parameters, create publishers and clients, and construct the logic."""
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
        """Configure the logic and serve until shutdown."""
        if not self._impl.configure(self._config):
            rospy.logfatal('The logic rejected its configuration.')
            return
        self._connect_receivers()
        try:
            rospy.spin()
        finally:
            self._impl.cleanup()

    def _connect_receivers(self):
        """Create subscriptions and servers."""
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
    rospy.init_node('clerk')
    logging.getLogger('rosout').setLevel(rospy.get_param('~log_level', 'info').upper())
    ClerkNode().run()
