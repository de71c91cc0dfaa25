# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node observer: its lifecycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in observer_impl.py.
"""

from __future__ import annotations

from threading import Lock
from typing import Any, Optional

from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
    PairMessages,
)
from all_kinds.ros.log import Log
from all_kinds.ros.loop import Loop
from all_kinds.ros.managed_node import ManagedNode
from all_kinds.ros.process import run
from all_kinds.ros.synchronizer import Synchronizer
import geometry_msgs.msg
from rcl_interfaces.msg import ParameterDescriptor
import std_msgs.msg

FREQUENCY = 12.5  # Hz


class ObserverNode(ManagedNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    Subscriptions exist while it is active.
    """

    fixed_parameters = [
        'limit',
    ]

    def __init__(self, **options: Any) -> None:
        """Declare the parameters."""
        super().__init__('observer', **options)
        default = ObserverConfig()
        self._declare(
            'limit',
            default.limit,
            ParameterDescriptor(
                description='How many to keep',
            ),
        )
        self._received: dict[str, Any] = {}
        self._received_lock = Lock()
        frequency = self._declare_frequency(FREQUENCY)
        self.loop = Loop(self._update, frequency, self._time, self.get_logger().warning)

    def _read_config(self) -> ObserverConfig:
        """Return the current parameters."""
        return ObserverConfig(
            limit=self.get_parameter('limit').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._data = ObserverData()
        self._impl = ObserverImpl(
            ObserverPassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        self._received = {}
        self._subscribe(
            std_msgs.msg.String,
            '/status',
            self._receive_status,
        )
        synchronizer = Synchronizer(
            self._callback(
                'pair',
                'receive_pair',
            ),
            PairMessages,
            queue_size=5,
        )
        self._subscribe(
            geometry_msgs.msg.PointStamped,
            'left',
            synchronizer.receiver('left'),
            callback_group=synchronizer.callback_group,
        )
        self._subscribe(
            geometry_msgs.msg.PointStamped,
            '~/right',
            synchronizer.receiver('right'),
            callback_group=synchronizer.callback_group,
        )

    def _update(self) -> None:
        """Run one cycle: take the latest messages, call update."""
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


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(ObserverNode, args)
