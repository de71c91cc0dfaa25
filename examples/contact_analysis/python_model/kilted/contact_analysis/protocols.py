# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
What the logic uses of ROS, as types: the same in ROS 1 and ROS 2.

The nodes give the logic objects that talk to ROS, its tests give it those of test/harness.py.
"""

from typing import Protocol, TypeVar

import builtin_interfaces.msg

Stamp = builtin_interfaces.msg.Time

Message = TypeVar('Message', contravariant=True)

GoalRequest = TypeVar('GoalRequest', covariant=True)
Feedback = TypeVar('Feedback')
Result = TypeVar('Result')


class Log(Protocol):
    """Writes to the ROS log."""

    def debug(self, text: str, /) -> object:
        """Write a text for debugging."""

    def info(self, text: str, /) -> object:
        """Write a text."""

    def warning(self, text: str, /) -> object:
        """Write a text about something that may go wrong."""

    def error(self, text: str, /) -> object:
        """Write a text about something that went wrong."""


class Publisher(Protocol[Message]):
    """Publishes messages to a topic."""

    def publish(self, message: Message, /) -> object:
        """Publish a message."""


class Goal(Protocol[GoalRequest, Feedback, Result]):
    """An action goal that the logic executes; `feedback` and `result` are to be filled in."""

    feedback: Feedback
    result: Result

    @property
    def request(self) -> GoalRequest:
        """Return the goal that the client sent."""

    @property
    def cancel_requested(self) -> bool:
        """Return whether to stop: canceled, replaced by another goal, or the node stops."""

    def publish_feedback(self) -> None:
        """Publish the current feedback."""

    def succeed(self) -> None:
        """Mark the goal as succeeded."""

    def abort(self) -> None:
        """Mark the goal as aborted."""

    def canceled(self) -> None:
        """Mark the goal as canceled, after `cancel_requested` was true."""
