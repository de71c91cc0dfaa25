# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The logic of worker.

Edit this file: worker_interface.py declares what the logic can use.
"""

from all_kinds.worker_interface import (
    CallMessage,
    ComputeGoal,
    ComputeGoalRequest,
    EnableRequest,
    EnableResponse,
    MeasureGoal,
    ResetRequest,
    ResetResponse,
    SayMessage,
    SightingMessages,
    WorkerConfig,
    WorkerData,
    WorkerPassthrough,
)


class WorkerImpl:
    """The logic of worker."""

    def __init__(self, passthrough: WorkerPassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough

    def configure(self, config: WorkerConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        return True

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    def update(
        self,
        data: WorkerData,
        config: WorkerConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""

    def reconfigure(self, config: WorkerConfig) -> str:
        """Take changed parameters and return '', or return why they are refused."""
        return ''

    # Topic say
    def receive_say(
        self,
        message: SayMessage,
    ) -> None:
        """Handle a message when it arrives, in a thread of its own."""

    # Topic call
    def receive_call(
        self,
        topic: str,
        message: CallMessage,
    ) -> None:
        """Handle a message when it arrives, in a thread of its own."""

    # Late topic speed
    def late_speed(self) -> None:
        """Act when no message has come within the deadline, in a thread of its own."""

    # Late topic say
    def late_say(self) -> None:
        """Act when no message has come within the deadline, in a thread of its own."""

    # Synchronizer sighting
    def receive_sighting(
        self,
        messages: SightingMessages,
    ) -> None:
        """Handle messages whose stamps belong together, in a thread of its own."""

    # Service reset
    def serve_reset(
        self,
        request: ResetRequest,
        response: ResetResponse,
    ) -> ResetResponse:
        """Fill in the response and return it, in a thread of its own."""
        return response

    # Service enable
    def serve_enable(
        self,
        request: EnableRequest,
        response: EnableResponse,
    ) -> EnableResponse:
        """Fill in the response and return it, in a thread of its own."""
        return response

    # Action compute
    def execute_compute(
        self,
        goal: ComputeGoal,
    ) -> None:
        """Execute a goal and set its outcome, in a thread of its own; this stub only succeeds."""
        goal.succeed()

    def accept_compute(
        self,
        request: ComputeGoalRequest,
    ) -> bool:
        """Return whether to accept a goal, in a thread of its own; this stub accepts all."""
        return True

    # Action measure
    def execute_measure(
        self,
        goal: MeasureGoal,
    ) -> None:
        """Execute a goal and set its outcome, in several threads at once; this stub succeeds."""
        goal.succeed()

    # Thread read
    def read(self) -> None:
        """Do one piece of work in a thread of its own; called again, this stub once a second."""
        self.passthrough.sleep(1.0)

    # Timer poll
    def poll(self) -> None:
        """Do what is due, in a thread of its own."""

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""
