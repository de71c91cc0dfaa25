# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The node contact_evaluate: its lifecycle and its ROS interfaces.

Generated from contact_analysis.ros_package; the logic is in contact_evaluate_impl.py.
"""

from __future__ import annotations

from threading import Lock
from typing import Any, Optional

from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
)
from contact_analysis.ros.log import Log
from contact_analysis.ros.loop import Loop
from contact_analysis.ros.managed_node import ManagedNode
from contact_analysis.ros.process import run
from contact_analysis.ros.publisher import Publisher
import contact_msgs.action
import contact_msgs.msg
import contact_msgs.srv
import geometry_msgs.msg
from rcl_interfaces.msg import ParameterDescriptor

FREQUENCY = 1000  # Hz


class ContactEvaluateNode(ManagedNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    Publishers exist from configure to cleanup. Subscriptions and service servers exist while it is
    active. Action servers exist as long as the node; while inactive, a server rejects goals.
    """

    fixed_parameters = [
        'samples',
    ]

    def __init__(self, **options: Any) -> None:
        """Declare the parameters and create what lives as long as the node."""
        super().__init__('contact_evaluate', **options)
        default = ContactEvaluateConfig()
        self._declare(
            'samples',
            default.samples,
            ParameterDescriptor(
                description='number of samples accumulated for learning',
            ),
        )
        self._declare(
            'pub_sample',
            default.pub_sample,
            ParameterDescriptor(
                description='Whether cop sampled should be published',
            ),
        )
        self.add_post_set_parameters_callback(self._apply_parameters)
        self._action_server_learn = self._action_server(
            contact_msgs.action.LearnContact,
            'learn',
            'execute_learn',
            new_goal='replace',
        )
        self._action_server_evaluate = self._action_server(
            contact_msgs.action.EvaluateContact,
            'evaluate',
            'execute_evaluate',
            new_goal='replace',
        )
        self._received: dict[str, Any] = {}
        self._received_lock = Lock()
        frequency = self._declare_frequency(FREQUENCY)
        self.loop = Loop(self._update, frequency, self._time, self.get_logger().warning)

    def _read_config(self) -> ContactEvaluateConfig:
        """Return the current parameters."""
        return ContactEvaluateConfig(
            samples=self.get_parameter('samples').value,
            pub_sample=self.get_parameter('pub_sample').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._data = ContactEvaluateData()
        self._impl = ContactEvaluateImpl(
            ContactEvaluatePassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
                pub_plot_learn_cop=Publisher(
                    self._advertise(
                        contact_msgs.msg.PointArray,
                        'plot_learn_cop',
                    ),
                ),
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        self._received = {}
        self._subscribe(
            geometry_msgs.msg.Point,
            'cop',
            self._receive_cop,
        )
        self._serve(
            contact_msgs.srv.SetString,
            'load',
            'serve_load',
        )
        self._serve(
            contact_msgs.srv.SetString,
            'store',
            'serve_store',
        )
        self._action_server_learn.accept_goals(True)
        self._action_server_evaluate.accept_goals(True)

    def _update(self) -> None:
        """Run one cycle: take the latest messages, call update."""
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


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(ContactEvaluateNode, args)
