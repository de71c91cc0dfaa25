# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node idler: its life-cycle and its ROS interfaces.

Generated from serving.ros_package; the logic is in idler_impl.py.
"""

import logging

import rospy
from serving.idler_impl import IdlerImpl
from serving.idler_interface import (
    IdlerConfig,
    IdlerPassthrough,
)


class IdlerNode:
    """A node that calls its logic back from its start to its end."""

    def __init__(self):
        """Read the parameters, create publishers and clients, and construct the logic."""
        self._config = IdlerConfig()
        self._impl = IdlerImpl(
            IdlerPassthrough(
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
        # Nothing of this node receives.


def main():
    """Spin the node until ROS shuts down."""
    rospy.init_node('idler')
    logging.getLogger('rosout').setLevel(rospy.get_param('~log_level', 'info').upper())
    IdlerNode().run()
