# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node sensor: its lifecycle and its ROS interfaces.

Generated from driver.ros_package; the logic is in sensor_impl.py.
"""

from __future__ import annotations

from typing import Any, Optional

from diagnostic_msgs.msg import DiagnosticArray
from driver.ros import timeouts
from driver.ros.diagnostics import Diagnostics
from driver.ros.log import Log
from driver.ros.managed_node import ManagedNode
from driver.ros.process import run
from driver.ros.publisher import Publisher
from driver.sensor_impl import SensorImpl
from driver.sensor_interface import (
    SensorConfig,
    SensorPassthrough,
)
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.clock import Clock, ClockType
from rclpy.qos import QoSProfile, ReliabilityPolicy
import std_msgs.msg


class SensorNode(ManagedNode):
    """
    A managed node that runs the callbacks of its logic while it is active.

    Publishers exist from configure to cleanup.
    """

    fixed_parameters = [
        'scale',
        'device',
        'serial.baud',
        'serial.timeout',
    ]

    def __init__(self, **options: Any) -> None:
        """Declare the parameters and create what lives as long as the node."""
        super().__init__('sensor', **options)
        default = SensorConfig()
        self._declare(
            'scale',
            default.scale,
            ParameterDescriptor(
                description='How long one unit of the sensor is, m',
            ),
        )
        self._declare(
            'device',
            default.device,
            ParameterDescriptor(
                description='Where the sensor is',
            ),
        )
        self._declare(
            'serial.baud',
            default.serial_baud,
            ParameterDescriptor(
                description='Bits a second',
            ),
            (4800, 9600, 115200),
        )
        self._declare(
            'serial.timeout',
            default.serial_timeout,
            ParameterDescriptor(
                description='How long a reading may take, s',
                floating_point_range=[
                    FloatingPointRange(
                        from_value=0.01,
                        to_value=10.0,
                    ),
                ],
            ),
        )
        self._diagnostics = Diagnostics(
            self.get_fully_qualified_name(),
            None,
        )
        self._diagnostics_publisher = self.create_publisher(DiagnosticArray, '/diagnostics', 10)
        self.create_timer(
            timeouts.DIAGNOSTICS_PERIOD,
            self._publish_diagnostics,
            clock=Clock(clock_type=ClockType.STEADY_TIME),
        )

    def _read_config(self) -> SensorConfig:
        """Return the current parameters."""
        return SensorConfig(
            scale=self.get_parameter('scale').value,
            device=self.get_parameter('device').value,
            serial_baud=self.get_parameter('serial.baud').value,
            serial_timeout=self.get_parameter('serial.timeout').value,
        )

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._configured.callback(self._diagnostics.renew)
        self._impl = SensorImpl(
            SensorPassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
                diagnostics=self._diagnostics.renew(),
                node=self,
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
        self._logic.repeat('read', self._impl.read)

    def _publish_diagnostics(self) -> None:
        """Publish how the node is, and what its logic says."""
        report = self._diagnostics.report(self.state, self.failure, self._time.stamp())
        self._diagnostics_publisher.publish(report)


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(SensorNode, args)
