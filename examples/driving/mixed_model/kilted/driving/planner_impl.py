# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of planner.

Edit this file: planner_interface.py declares what the logic can use.
"""

from driving.planner_interface import (
    PlannerConfig,
    PlannerData,
    PlannerPassthrough,
)


class PlannerImpl:
    """The logic of planner."""

    def __init__(self, passthrough: PlannerPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: PlannerConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    def update(
        self,
        data: PlannerData,
        config: PlannerConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
