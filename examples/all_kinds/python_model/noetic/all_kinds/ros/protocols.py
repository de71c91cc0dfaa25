# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
Types of what the logic uses of ROS, the same for ROS 1 and ROS 2.

The node passes objects that talk to ROS, tests pass the fakes of test/support/harness.py.
"""

from typing import Literal, Optional, Protocol, Tuple, TypeVar

import geometry_msgs.msg
import rospy

Transform = geometry_msgs.msg.TransformStamped
Translation = Tuple[float, float, float]
Rotation = Tuple[float, float, float, float]

Message = TypeVar('Message', contravariant=True)

Request = TypeVar('Request', contravariant=True)
Response = TypeVar('Response', covariant=True)

SentGoal = TypeVar('SentGoal', contravariant=True)
SentFeedback = TypeVar('SentFeedback', covariant=True)
SentResult = TypeVar('SentResult', covariant=True)

GoalState = Literal[
    'idle',
    'pending',
    'active',
    'rejected',
    'succeeded',
    'aborted',
    'canceled',
    'lost',
]

GoalRequest = TypeVar('GoalRequest', covariant=True)
Feedback = TypeVar('Feedback')
Result = TypeVar('Result')


class Publisher(Protocol[Message]):
    """Publishes messages to a topic."""

    def publish(self, message: Message, /) -> object:
        """Publish a message."""

    def subscriber_count(self) -> int:
        """Return how many subscribe to the topic."""


class ServiceClient(Protocol[Request, Response]):
    """Calls a service."""

    def is_ready(self) -> bool:
        """Return whether a server is available."""

    def call(self, request: Request, timeout: float = 1.0) -> Optional[Response]:
        """Return the response, or None after `timeout` seconds or when the node stops."""


class ActionClient(Protocol[SentGoal, SentFeedback, SentResult]):
    """An action client with one goal at a time; no method blocks."""

    @property
    def state(self) -> GoalState:
        """Return the state of the goal; lost: there is no server, or it has died."""

    @property
    def feedback(self) -> Optional[SentFeedback]:
        """Return the latest feedback."""

    @property
    def result(self) -> Optional[SentResult]:
        """Return the result, once the goal has ended."""

    def is_ready(self) -> bool:
        """Return whether a server is available."""

    def send_goal(self, goal: SentGoal) -> bool:
        """Send a goal, replacing the previous one; return False if no server is available."""

    def cancel(self) -> None:
        """Ask the server to cancel the goal."""


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


class TransformListener(Protocol):
    """Looks up transforms from tf."""

    @property
    def reason(self) -> str:
        """Return why the last lookup found nothing; empty if it found its transform."""

    def lookup(
        self,
        target: str,
        source: str,
        timeout: float = 0.0,
        stamp: Optional[rospy.Time] = None,
    ) -> Optional[Transform]:
        """
        Return the transform that takes coordinates from frame `source` to frame `target`.

        stamp: the time of the transform; by default the latest.
        Return None if there is none after `timeout` seconds or when the node stops.
        """


class TransformBroadcaster(Protocol):
    """Publishes transforms to tf."""

    def broadcast(
        self,
        parent: str,
        child: str,
        translation: Translation,
        rotation: Rotation,
    ) -> None:
        """
        Publish the pose of frame `child` in frame `parent`, stamped with the current time.

        translation: x, y, z in metres; rotation: x, y, z, w of a unit quaternion.
        """

    def broadcast_static(
        self,
        parent: str,
        child: str,
        translation: Translation,
        rotation: Rotation,
    ) -> None:
        """Publish a pose that never changes; later listeners receive it too."""

    def send(self, transform: Transform) -> None:
        """Publish a transform as given."""

    def send_static(self, transform: Transform) -> None:
        """Publish a static transform as given."""
