# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of clerk.

This file is yours: clerk_interface.py says what the logic can use.
"""

from serving.clerk_interface import (
    ClerkConfig,
    ClerkPassthrough,
)


class ClerkImpl:
    """
    The logic of clerk.

    ROS calls each callback in a thread of its own: guard with a lock what they share.
    """

    def __init__(self, passthrough: ClerkPassthrough) -> None:
        """Keep what the logic may use at any time."""
        self.passthrough = passthrough

    def configure(self, config: ClerkConfig) -> bool:
        """Prepare for work; return False to refuse the configuration."""
        return True

    # Service greet
    def serve_greet(self, request, response):
        """Fill in the response to a request and return it."""
        return response

    # Service ~/open
    def serve_open(self, request, response):
        """Fill in the response to a request and return it."""
        return response

    # Action count
    def execute_count(self, goal) -> None:
        """Work on a goal until it succeeds, is aborted, or its cancelling is requested."""
        goal.succeed()

    # End of life
    def cleanup(self) -> None:
        """Let go of what configure took."""
