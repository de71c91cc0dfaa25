# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The logic of contact_evaluate.

This file is yours: contact_evaluate_interface.py says what the logic can use.
"""

from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
)


class ContactEvaluateImpl:
    """
    The logic of contact_evaluate.

    ROS calls each callback in a thread of its own: guard with a lock what they share.
    """

    def __init__(self, passthrough: ContactEvaluatePassthrough) -> None:
        """Keep what the logic may use at any time."""
        self.passthrough = passthrough

    def configure(self, config: ContactEvaluateConfig) -> bool:
        """Prepare for work; return False to refuse the configuration."""
        return True

    def update(
        self,
        data: ContactEvaluateData,
        config: ContactEvaluateConfig,
    ) -> None:
        """Turn the latest inputs into outputs, once in every cycle."""

    # Service load
    def serve_load(self, request, response):
        """Fill in the response to a request and return it."""
        return response

    # Service store
    def serve_store(self, request, response):
        """Fill in the response to a request and return it."""
        return response

    # Action learn
    def execute_learn(self, goal) -> None:
        """Work on a goal until it succeeds, is aborted, or its cancelling is requested."""
        goal.succeed()

    # Action evaluate
    def execute_evaluate(self, goal) -> None:
        """Work on a goal until it succeeds, is aborted, or its cancelling is requested."""
        goal.succeed()

    # End of life
    def cleanup(self) -> None:
        """Let go of what configure took."""
