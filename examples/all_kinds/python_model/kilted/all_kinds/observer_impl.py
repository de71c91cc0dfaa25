# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of observer.

Edit this file: observer_interface.py declares what the logic can use.
"""

from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
    ObserverPassthrough,
    PairMessages,
)


class ObserverImpl:
    """The logic of observer."""

    def __init__(self, passthrough: ObserverPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: ObserverConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    def update(
        self,
        data: ObserverData,
        config: ObserverConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""

    # Synchronizer pair
    def receive_pair(
        self,
        messages: PairMessages,
    ) -> None:
        """Handle messages whose stamps belong together, in a thread of its own."""

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
