# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of sensor.

Edit this file: sensor_interface.py declares what the logic can use.
"""

from driver.sensor_interface import (
    SensorConfig,
    SensorPassthrough,
)


class SensorImpl:
    """The logic of sensor."""

    def __init__(self, passthrough: SensorPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: SensorConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    # Thread read
    def read(self) -> None:
        """Do one piece of work in a thread of its own; called again, this stub once a second."""
        self.passthrough.sleep(1.0)

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
