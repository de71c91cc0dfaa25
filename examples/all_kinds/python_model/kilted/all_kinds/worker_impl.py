# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of worker.

Edit this file: worker_interface.py declares what the logic can use.
"""

from all_kinds.worker_interface import (
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)


class WorkerImpl:
    """
    The logic of worker.

    Callbacks run in threads of their own: protect shared state with a lock.
    """

    def __init__(self, passthrough: WorkerPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: WorkerConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def update(
        self,
        data: WorkerData,
        config: WorkerConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""

    # Topic say
    def receive_say(self, message) -> None:
        """Handle a message when it arrives."""

    # Service reset
    def serve_reset(self, request, response):
        """Fill in the response and return it."""
        return response

    # Service enable
    def serve_enable(self, request, response):
        """Fill in the response and return it."""
        return response

    # Action compute
    def execute_compute(self, goal) -> None:
        """Execute a goal until it succeeds, is aborted, or a cancel is requested."""
        goal.succeed()

    # End of life
    def cleanup(self) -> None:
        """Release everything created in configure."""
