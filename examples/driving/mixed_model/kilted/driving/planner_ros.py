# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node planner: its lifecycle and its ROS interfaces.

Generated from driving.ros_package; the logic is in planner_impl.py.
"""

from __future__ import annotations

from threading import Lock
from typing import Any, Optional

from driving.planner_impl import PlannerImpl
from driving.planner_interface import (
    PlannerConfig,
    PlannerData,
    PlannerPassthrough,
)
from driving.ros.log import Log
from driving.ros.loop import Loop
from driving.ros.managed_node import ManagedNode
from driving.ros.process import run
from rcl_interfaces.msg import ParameterDescriptor
import std_msgs.msg

FREQUENCY = 10  # Hz


class PlannerNode(ManagedNode):
    """
    A managed node that runs its logic at a fixed frequency while it is active.

    Publishers exist from configure to cleanup. Subscriptions exist while it is active.
    """

    fixed_parameters = [
        'speed_limit',
    ]

    def __init__(self, **options: Any) -> None:
        """Declare the parameters."""
        super().__init__('planner', **options)
        default = PlannerConfig()
        self._declare(
            'speed_limit',
            default.speed_limit,
            ParameterDescriptor(
                description='Highest speed, m/s',
            ),
        )
        self._received: dict[str, Any] = {}
        self._received_lock = Lock()
        frequency = self._declare_frequency(FREQUENCY)
        self.loop = Loop(self._update, frequency, self._time, self.get_logger().warning)

    def _read_config(self) -> PlannerConfig:
        """Return the current parameters."""
        return PlannerConfig(
            speed_limit=self.get_parameter('speed_limit').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._data = PlannerData()
        self._out_target_speed = self._advertise(
            std_msgs.msg.Float64,
            'target_speed',
        )
        self._impl = PlannerImpl(
            PlannerPassthrough(
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
            std_msgs.msg.Float64,
            'speed',
            self._receive_speed,
        )

    def _update(self) -> None:
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_speed = received.get('speed', data.in_speed)
        data.in_speed_updated = 'speed' in received
        data.out_target_speed_active = True
        data.out_target_speed_subscribers = self._out_target_speed.get_subscription_count()
        self._impl.update(data, self._config)
        if data.out_target_speed_active:
            self._out_target_speed.publish(data.out_target_speed)

    def _receive_speed(self, message: Any) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['speed'] = message


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(PlannerNode, args)
