# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of clerk.

Edit this file: clerk_interface.py declares what the logic can use.
"""

from serving.clerk_interface import (
    ClerkConfig,
    ClerkPassthrough,
    CountGoal,
    GreetRequest,
    GreetResponse,
    OpenRequest,
    OpenResponse,
)


class ClerkImpl:
    """The logic of clerk."""

    def __init__(self, passthrough: ClerkPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: ClerkConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    # Service greet
    def serve_greet(
        self,
        request: GreetRequest,
        response: GreetResponse,
    ) -> GreetResponse:
        """Fill in the response and return it, in a thread of its own."""
        return response

    # Service ~/open
    def serve_open(
        self,
        request: OpenRequest,
        response: OpenResponse,
    ) -> OpenResponse:
        """Fill in the response and return it, in a thread of its own."""
        return response

    # Action count
    def execute_count(
        self,
        goal: CountGoal,
    ) -> None:
        """Execute a goal and set its outcome, in a thread of its own; this stub only succeeds."""
        goal.succeed()

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
