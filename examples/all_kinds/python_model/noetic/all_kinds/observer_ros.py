# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node observer: its lifecycle and its ROS interfaces.

Generated from all_kinds.ros_package; the logic is in observer_impl.py.
"""

from __future__ import annotations

from threading import Lock
from typing import Any, Dict

from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
    PairMessages,
)
from all_kinds.ros.log import Log
from all_kinds.ros.loop import Loop
from all_kinds.ros.managed_node import check_range, ManagedNode, read_parameter
from all_kinds.ros.process import run
from all_kinds.ros.synchronizer import Synchronizer
import geometry_msgs.msg
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
        frequency = read_parameter('frequency', float(FREQUENCY))
        check_range('frequency', frequency, 0.001, 100000.0)
        self.loop = Loop(self._update, frequency, self._time, self._log.warning)

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = ObserverImpl(
            ObserverPassthrough(
                log=Log(self._log),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
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
        synchronizer = Synchronizer(
            self._callback(
                'pair',
                'receive_pair',
            ),
            PairMessages,
            queue_size=5,
        )
        rospy.Subscriber(
            'left',
            geometry_msgs.msg.PointStamped,
            synchronizer.receiver('left'),
            queue_size=10,
        )
        rospy.Subscriber(
            '~right',
            geometry_msgs.msg.PointStamped,
            synchronizer.receiver('right'),
            queue_size=10,
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


def main() -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run('observer', ObserverNode)
