# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The logic of contact_evaluate.

Edit this file: contact_evaluate_interface.py declares what the logic can use.
"""

from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
)


class ContactEvaluateImpl:
    """
    The logic of contact_evaluate.

    Callbacks run in threads of their own: protect shared state with a lock.
    """

    def __init__(self, passthrough: ContactEvaluatePassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: ContactEvaluateConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def update(
        self,
        data: ContactEvaluateData,
        config: ContactEvaluateConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""

    # Service load
    def serve_load(self, request, response):
        """Fill in the response and return it."""
        return response

    # Service store
    def serve_store(self, request, response):
        """Fill in the response and return it."""
        return response

    # Action learn
    def execute_learn(self, goal) -> None:
        """Execute a goal until it succeeds, is aborted, or a cancel is requested."""
        goal.succeed()

    # Action evaluate
    def execute_evaluate(self, goal) -> None:
        """Execute a goal until it succeeds, is aborted, or a cancel is requested."""
        goal.succeed()

    # End of life
    def cleanup(self) -> None:
        """Release everything created in configure."""
