# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of replay.

Edit this file: replay_interface.py declares what the logic can use.
"""

from driver.replay_interface import (
    ReplayConfig,
    ReplayPassthrough,
)


class ReplayImpl:
    """The logic of replay."""

    def __init__(self, passthrough: ReplayPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: ReplayConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    # Timer play
    def play(self) -> None:
        """Do what is due, in a thread of its own."""

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
