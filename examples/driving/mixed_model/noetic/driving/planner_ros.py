# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node planner: its lifecycle and its ROS interfaces.

Generated from driving.ros_package; the logic is in planner_impl.py.
"""

from __future__ import annotations

from threading import Lock
from typing import Any, Dict

from driving.loop import Loop
from driving.managed_node import ManagedNode
from driving.planner_impl import PlannerImpl
from driving.planner_interface import (
    PlannerConfig,
    PlannerData,
    PlannerPassthrough,
)
from driving.process import run
import rospy
import std_msgs.msg

FREQUENCY = 10  # Hz


class PlannerNode(ManagedNode):
    """A node that runs its logic at a fixed frequency."""

    def __init__(self) -> None:
        """Read the parameters; everything else is created in configure."""
        super().__init__()
        default = PlannerConfig()
        self._config = PlannerConfig(
            speed_limit=read_parameter('speed_limit', default.speed_limit),
        )
        self._data = PlannerData()
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
        self._out_target_speed = rospy.Publisher(
            'target_speed',
            std_msgs.msg.Float64,
            queue_size=10,
        )
        self._impl = PlannerImpl(
            PlannerPassthrough(
                log=self._log,
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        rospy.Subscriber(
            'speed',
            std_msgs.msg.Float64,
            self._receive_speed,
            queue_size=10,
        )

    def _update(self) -> None:
        """Run one cycle: take the latest messages, call update, publish the active outputs."""
        data = self._data
        with self._received_lock:
            received, self._received = self._received, {}
        data.in_speed = received.get('speed', data.in_speed)
        data.in_speed_updated = 'speed' in received
        data.out_target_speed_active = True
        self._impl.update(data, self._config)
        if data.out_target_speed_active:
            self._out_target_speed.publish(data.out_target_speed)

    def _receive_speed(self, message: Any) -> None:
        """Store the message for the next cycle."""
        with self._received_lock:
            self._received['speed'] = message


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
    return run('planner', PlannerNode)
