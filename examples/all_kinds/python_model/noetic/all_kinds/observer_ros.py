# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node observer: its lifecycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in observer_impl.py.
"""

from __future__ import annotations

from threading import Lock
from typing import Any, Dict

from all_kinds.loop import Loop
from all_kinds.managed_node import ManagedNode
from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
)
from all_kinds.process import run
import rospy
import std_msgs.msg

FREQUENCY = 12.5  # Hz


class ObserverNode(ManagedNode):
    """A node that runs its logic at a fixed frequency."""

    def __init__(self) -> None:
        """Read the parameters; everything else is created in configure."""
        super().__init__()
        default = ObserverConfig()
        self._config = ObserverConfig(
            limit=read_parameter('limit', default.limit),
        )
        self._data = ObserverData()
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
        self._impl = ObserverImpl(
            ObserverPassthrough(
                log=self._log,
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        rospy.Subscriber(
            '/status',
            std_msgs.msg.String,
            self._receive_status,
            queue_size=10,
        )

    def _update(self) -> None:
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_status = received.get('status', data.in_status)
        data.in_status_updated = 'status' in received
        self._impl.update(data, self._config)

    def _receive_status(self, message: Any) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['status'] = message


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
    return run('observer', ObserverNode)
