# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of worker.

This file is yours: worker_interface.py says what the logic can use.
"""

from all_kinds.worker_interface import (
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)


class WorkerImpl:
    """
    The logic of worker.

    ROS calls each callback in a thread of its own: guard with a lock what they share.
    """

    def __init__(self, passthrough: WorkerPassthrough) -> None:
        """Keep what the logic may use at any time."""
        self.passthrough = passthrough

    def configure(self, config: WorkerConfig) -> bool:
        """Prepare for work; return False to refuse the configuration."""
        return True

    def update(
        self,
        data: WorkerData,
        config: WorkerConfig,
    ) -> None:
        """Turn the latest inputs into outputs, once in every cycle."""

    # Topic say
    def receive_say(self, message) -> None:
        """Handle a message at once."""

    # Service reset
    def serve_reset(self, request, response):
        """Fill in the response to a request and return it."""
        return response

    # Service enable
    def serve_enable(self, request, response):
        """Fill in the response to a request and return it."""
        return response

    # Action compute
    def execute_compute(self, goal) -> None:
        """Work on a goal until it succeeds, is aborted, or its cancelling is requested."""
        goal.succeed()

    # End of life
    def cleanup(self) -> None:
        """Let go of what configure took."""
