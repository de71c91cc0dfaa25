# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of idler.

This file is yours: idler_interface.py says what the logic can use.
"""

from serving.idler_interface import (
    IdlerConfig,
    IdlerPassthrough,
)


class IdlerImpl:
    """
    The logic of idler.

    ROS calls each callback in a thread of its own: guard with a lock what they share.
    """

    def __init__(self, passthrough: IdlerPassthrough) -> None:
        """Keep what the logic may use at any time."""
        self.passthrough = passthrough

    def configure(self, config: IdlerConfig) -> bool:
        """Prepare for work; return False to refuse the configuration."""
        return True

    # End of life
    def cleanup(self) -> None:
        """Let go of what configure took."""
