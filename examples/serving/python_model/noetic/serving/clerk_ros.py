# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node clerk: its lifecycle and its ROS interfaces.

Generated from serving.ros_package; the logic is in clerk_impl.py.
"""

from __future__ import annotations

from typing import Any

import rospy
from serving.clerk_impl import ClerkImpl
from serving.clerk_interface import (
    ClerkConfig,
    ClerkPassthrough,
)
from serving.managed_node import ManagedNode
from serving.process import run
from serving.service_server import ServiceServer
import std_srvs.srv
import test_msgs.msg


class ClerkNode(ManagedNode):
    """A node that calls its logic back."""

    def __init__(self) -> None:
        """Read the parameters; everything else is created in configure."""
        super().__init__()
        default = ClerkConfig()
        self._config = ClerkConfig(
            greeting=read_parameter('greeting', default.greeting),
            patience=read_parameter('patience', default.patience),
        )

    def _configure(self) -> bool:
        """Configure the logic with the parameters."""
        return bool(self._impl.configure(self._config))

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = ClerkImpl(
            ClerkPassthrough(
                log=self._log,
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        ServiceServer(
            'greet',
            std_srvs.srv.Trigger,
            self._callback('greet', 'serve_greet'),
        )
        ServiceServer(
            '~open',
            std_srvs.srv.SetBool,
            self._callback('~/open', 'serve_open'),
        )
        self._action_server(
            'count',
            test_msgs.msg.FibonacciAction,
            'execute_count',
            new_goal='replace',
        )


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
    return run('clerk', ClerkNode)
