# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of observer.

This file is yours: observer_interface.py says what the logic can use.
"""

from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
)


class ObserverImpl:
    """
    The logic of observer.

    ROS calls each callback in a thread of its own: guard with a lock what they share.
    """

    def __init__(self, passthrough: ObserverPassthrough) -> None:
        """Keep what the logic may use at any time."""
        self.passthrough = passthrough

    def configure(self, config: ObserverConfig) -> bool:
        """Prepare for work; return False to refuse the configuration."""
        return True

    def update(
        self,
        data: ObserverData,
        config: ObserverConfig,
    ) -> None:
        """Turn the latest inputs into outputs, once in every cycle."""

    # End of life
    def cleanup(self) -> None:
        """Let go of what configure took."""
