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
    EvaluateGoal,
    LearnGoal,
    LoadRequest,
    LoadResponse,
    StoreRequest,
    StoreResponse,
)


class ContactEvaluateImpl:
    """The logic of contact_evaluate."""

    def __init__(self, passthrough: ContactEvaluatePassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: ContactEvaluateConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    def update(
        self,
        data: ContactEvaluateData,
        config: ContactEvaluateConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""

    # Service load
    def serve_load(
        self,
        request: LoadRequest,
        response: LoadResponse,
    ) -> LoadResponse:
        """Fill in the response and return it, in a thread of its own."""
        return response

    # Service store
    def serve_store(
        self,
        request: StoreRequest,
        response: StoreResponse,
    ) -> StoreResponse:
        """Fill in the response and return it, in a thread of its own."""
        return response

    # Action learn
    def execute_learn(
        self,
        goal: LearnGoal,
    ) -> None:
        """Execute a goal and set its outcome, in a thread of its own; this stub only succeeds."""
        goal.succeed()

    # Action evaluate
    def execute_evaluate(
        self,
        goal: EvaluateGoal,
    ) -> None:
        """Execute a goal and set its outcome, in a thread of its own; this stub only succeeds."""
        goal.succeed()

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
