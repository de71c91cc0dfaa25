# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The node contact_evaluate: its lifecycle and its ROS interfaces.

Generated from contact_analysis.ros_package; the logic is in contact_evaluate_impl.py.
"""

from __future__ import annotations

from dataclasses import replace
from threading import Lock
from typing import Any, Dict

from contact_analysis.cfg import ContactEvaluateConfig as ContactEvaluateReconfigure
from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
)
from contact_analysis.loop import Loop
from contact_analysis.managed_node import ManagedNode
from contact_analysis.process import run
from contact_analysis.service_server import ServiceServer
import contact_msgs.msg
import contact_msgs.srv
from dynamic_reconfigure.server import Server as ReconfigureServer
import geometry_msgs.msg
import rospy

FREQUENCY = 1000  # Hz


class ContactEvaluateNode(ManagedNode):
    """A node that runs its logic at a fixed frequency."""

    def __init__(self) -> None:
        """Read the parameters; everything else is created in configure."""
        super().__init__()
        default = ContactEvaluateConfig()
        self._config = ContactEvaluateConfig(
            samples=read_parameter('samples', default.samples),
            pub_sample=read_parameter('pub_sample', default.pub_sample),
        )
        self._data = ContactEvaluateData()
        self._received: Dict[str, Any] = {}
        self._received_lock = Lock()
        self._cycles = Loop(self._update, FREQUENCY, self._time, self._log.warning)

    def _configure(self) -> bool:
        """Configure the logic with the parameters."""
        return bool(self._impl.configure(self._config))

    def _loop(self) -> None:
        """Call update until the node stops."""
        self._cycles.run(self.stop)

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        ReconfigureServer(ContactEvaluateReconfigure, self._reconfigure)
        self._impl = ContactEvaluateImpl(
            ContactEvaluatePassthrough(
                log=self._log,
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                pub_plot_learn_cop=rospy.Publisher(
                    'plot_learn_cop',
                    contact_msgs.msg.PointArray,
                    queue_size=10,
                ),
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        rospy.Subscriber(
            'cop',
            geometry_msgs.msg.Point,
            self._receive_cop,
            queue_size=10,
        )
        ServiceServer(
            'load',
            contact_msgs.srv.SetString,
            self._callback('load', 'serve_load'),
        )
        ServiceServer(
            'store',
            contact_msgs.srv.SetString,
            self._callback('store', 'serve_store'),
        )
        self._action_server(
            'learn',
            contact_msgs.msg.LearnContactAction,
            'execute_learn',
            new_goal='replace',
        )
        self._action_server(
            'evaluate',
            contact_msgs.msg.EvaluateContactAction,
            'execute_evaluate',
            new_goal='replace',
        )

    def _update(self) -> None:
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_cop = received.get('cop', data.in_cop)
        data.in_cop_updated = 'cop' in received
        self._impl.update(data, self._config)

    def _receive_cop(self, message: Any) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['cop'] = message

    def _reconfigure(self, values: Any, _level: int) -> Any:
        """Update the configuration with the changed parameters."""
        self._config = replace(
            self._config,
            pub_sample=values['pub_sample'],
        )
        return values


def read_parameter(name: str, default: Any) -> Any:
    """Return a private parameter; raise if its type is not that of the default."""
    value = rospy.get_param('~' + name, default)
    if isinstance(value, list):
        value = tuple(value)
    if isinstance(default, float) and type(value) is int:
        value = float(value)
    if type(value) is not type(default):
        wanted = type(default).__name__
        raise rospy.ROSInitException(f'Parameter {name} must be of type {wanted}, not {value!r}.')
    return value


def main() -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run('contact_evaluate', ContactEvaluateNode)
