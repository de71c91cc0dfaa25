# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node replay: its lifecycle and its ROS interfaces.

Generated from driver.ros_package; the logic is in replay_impl.py.
"""

from __future__ import annotations

from typing import Any, Optional

from driver.replay_impl import ReplayImpl
from driver.replay_interface import (
    ReplayConfig,
    ReplayPassthrough,
)
from driver.ros.log import Log
from driver.ros.managed_node import ManagedNode
from driver.ros.process import run
from driver.ros.publisher import Publisher
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.qos import QoSProfile, ReliabilityPolicy
import std_msgs.msg


class ReplayNode(ManagedNode):
    """
    A managed node that runs the callbacks of its logic while it is active.

    Publishers exist from configure to cleanup.
    """

    fixed_parameters = [
        'scale',
        'file',
    ]

    def __init__(self, **options: Any) -> None:
        """Declare the parameters."""
        super().__init__('sensor', **options)
        default = ReplayConfig()
        self._declare(
            'scale',
            default.scale,
            ParameterDescriptor(
                description='How long one unit of the sensor is, m',
            ),
        )
        self._declare(
            'file',
            default.file,
            ParameterDescriptor(
                description='Where the readings are',
            ),
        )

    def _read_config(self) -> ReplayConfig:
        """Return the current parameters."""
        return ReplayConfig(
            scale=self.get_parameter('scale').value,
            file=self.get_parameter('file').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = ReplayImpl(
            ReplayPassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
                pub_reading=Publisher(
                    self._advertise(
                        std_msgs.msg.Float64,
                        'reading',
                        QoSProfile(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5),
                    ),
                ),
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers, and start threads."""
        self._call_at(10, 'play')


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(ReplayNode, args)
