# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The node contact_evaluate: its life-cycle and its ROS interfaces.

Generated from contact_analysis.ros_package; the logic is in contact_evaluate_impl.py.
"""

from dataclasses import replace
import logging
from threading import Lock

from contact_analysis.action_server import ActionServer
from contact_analysis.cfg import ContactEvaluateConfig as ContactEvaluateReconfigure
from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
)
from contact_analysis.service_server import ServiceServer
import contact_msgs.msg
import contact_msgs.srv
from dynamic_reconfigure.server import Server as ReconfigureServer
import geometry_msgs.msg
import rospy

FREQUENCY = 1000  # Hz
QUEUE = 10  # messages kept for a topic


class ContactEvaluateNode:
    """A node that runs its logic at a fixed frequency until shutdown."""

    def __init__(self):
        """Read the parameters, create publishers and clients, and construct the logic."""
        default = ContactEvaluateConfig()
        self._config = ContactEvaluateConfig(
            samples=read_parameter('samples', default.samples),
            pub_sample=read_parameter('pub_sample', default.pub_sample),
        )
        self._data = ContactEvaluateData()
        self._received = {}
        self._received_lock = Lock()
        self._impl = ContactEvaluateImpl(
            ContactEvaluatePassthrough(
                log=logging.getLogger('rosout'),
                now=rospy.get_time,
                stamp=rospy.Time.now,
                pub_plot_learn_cop=rospy.Publisher(
                    'plot_learn_cop',
                    contact_msgs.msg.PointArray,
                    queue_size=QUEUE,
                ),
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
        ReconfigureServer(ContactEvaluateReconfigure, self._reconfigure)
        rospy.Subscriber(
            'cop',
            geometry_msgs.msg.Point,
            self._receive_cop,
            queue_size=QUEUE,
        )
        ServiceServer(
            'load',
            contact_msgs.srv.SetString,
            self._impl.serve_load,
        )
        ServiceServer(
            'store',
            contact_msgs.srv.SetString,
            self._impl.serve_store,
        )
        ActionServer(
            'learn',
            contact_msgs.msg.LearnContactAction,
            self._impl.execute_learn,
        )
        ActionServer(
            'evaluate',
            contact_msgs.msg.EvaluateContactAction,
            self._impl.execute_evaluate,
        )

    def _update(self):
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_cop = received.get('cop', data.in_cop)
        data.in_cop_updated = 'cop' in received
        self._impl.update(data, self._config)

    def _receive_cop(self, message):
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['cop'] = message

    def _reconfigure(self, values, _level):
        """Update the configuration with the changed parameters."""
        self._config = replace(
            self._config,
            pub_sample=values['pub_sample'],
        )
        return values


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
    rospy.init_node('contact_evaluate')
    logging.getLogger('rosout').setLevel(rospy.get_param('~log_level', 'info').upper())
    ContactEvaluateNode().run()
