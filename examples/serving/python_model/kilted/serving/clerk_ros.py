# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node clerk: its lifecycle and its ROS interfaces.

Generated from serving.ros_package; the logic is in clerk_impl.py.
"""

from __future__ import annotations

from typing import Any, Optional

from rcl_interfaces.msg import ParameterDescriptor
from serving.clerk_impl import ClerkImpl
from serving.clerk_interface import (
    ClerkConfig,
    ClerkPassthrough,
)
from serving.ros.log import Log
from serving.ros.managed_node import ManagedNode
from serving.ros.process import run
import std_srvs.srv
import test_msgs.action


class ClerkNode(ManagedNode):
    """
    A managed node that runs the callbacks of its logic while it is active.

    Service servers exist while it is active. Action servers exist as long as the node; while
    inactive, a server rejects goals.
    """

    fixed_parameters = [
        'greeting',
        'patience',
    ]

    def __init__(self, **options: Any) -> None:
        """Declare the parameters and create what lives as long as the node."""
        super().__init__('clerk', **options)
        default = ClerkConfig()
        self._declare(
            'greeting',
            default.greeting,
            ParameterDescriptor(
                description='What to say',
            ),
        )
        self._declare(
            'patience',
            default.patience,
            ParameterDescriptor(
                description='Time for a step, s',
            ),
        )
        self._action_server_count = self._action_server(
            test_msgs.action.Fibonacci,
            'count',
            'execute_count',
            new_goal='replace',
        )

    def _read_config(self) -> ClerkConfig:
        """Return the current parameters."""
        return ClerkConfig(
            greeting=self.get_parameter('greeting').value,
            patience=self.get_parameter('patience').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = ClerkImpl(
            ClerkPassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        self._serve(
            std_srvs.srv.Trigger,
            'greet',
            'serve_greet',
        )
        self._serve(
            std_srvs.srv.SetBool,
            '~/open',
            'serve_open',
        )
        self._action_server_count.accept_goals(True)


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(ClerkNode, args)
