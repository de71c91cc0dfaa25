# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A non-blocking action client."""

from __future__ import annotations

import concurrent.futures
from time import monotonic
from typing import Any, Callable, Optional

from action_msgs.msg import GoalStatus
from all_kinds.ros import timeouts
from all_kinds.ros.goal_sender import GoalSender
from all_kinds.ros.protocols import GoalState
from rclpy.action.client import ClientGoalHandle
from rclpy.node import Node
from rclpy.task import Future

OUTCOMES: dict[int, GoalState] = {
    GoalStatus.STATUS_SUCCEEDED: 'succeeded',
    GoalStatus.STATUS_ABORTED: 'aborted',
    GoalStatus.STATUS_CANCELED: 'canceled',
}


class ActionClient:
    """
    An action client with one goal at a time; no method blocks.

    state: idle, pending, active, rejected, succeeded, aborted, canceled or lost.
    feedback: the latest feedback message, or None.
    result: the result message once the goal has ended, or None.
    """

    def __init__(self, node: Node, action_type: Any, name: str) -> None:
        """Create the client."""
        self._client = GoalSender(node, action_type, name)
        self._goal = SentGoal(self._client, 'idle')
        self._under_way: list[SentGoal] = []
        self._last_seen = monotonic()

    @property
    def state(self) -> GoalState:
        """Return the state of the goal."""
        return self._goal.state

    @property
    def feedback(self) -> Optional[Any]:
        """Return the latest feedback."""
        return self._goal.feedback

    @property
    def result(self) -> Optional[Any]:
        """Return the result."""
        return self._goal.result

    def is_ready(self) -> bool:
        """Return whether a server is available."""
        return self._client.server_is_ready()

    def send_goal(self, goal: Any) -> bool:
        """Send a goal and cancel the one before; return False if no server is available."""
        self.cancel()
        if not self.is_ready():
            self._goal = SentGoal(self._client, 'lost')
            return False
        self._last_seen = monotonic()
        self._goal = SentGoal(self._client, 'pending')
        self._under_way = [sent for sent in self._under_way if sent.is_under_way()]
        self._under_way.append(self._goal)
        self._goal.send(goal)
        return True

    def cancel(self) -> None:
        """Ask the server to cancel the goal, now or when it has accepted it."""
        self._goal.cancel()

    def unanswered(self) -> list[concurrent.futures.Future[None]]:
        """Return futures of the goals that the server has yet to accept or reject."""
        return [sent.answered for sent in self._under_way if not sent.answered.done()]

    def reset(self) -> None:
        """Forget the goal."""
        self.cancel()
        self._goal = SentGoal(self._client, 'idle')

    def watch(self) -> None:
        """Give up the goals if the server has been lost for too long."""
        if self.is_ready():
            self._last_seen = monotonic()
        elif monotonic() - self._last_seen >= timeouts.SERVER_LOST_TIMEOUT:
            for sent in self._under_way:
                sent.lose()


class SentGoal:
    """A goal and what becomes of it; its attributes are those of ActionClient."""

    def __init__(self, client: GoalSender, state: GoalState) -> None:
        """Prepare a pending goal, or one that is never sent: idle or lost."""
        self.state: GoalState = state
        self.feedback: Optional[Any] = None
        self.result: Optional[Any] = None
        self._client = client
        self._id = client.new_id()
        self._handle: Optional[ClientGoalHandle[Any, Any, Any]] = None
        self._cancel = False
        self._futures: list[Future[Any]] = []
        self.answered: concurrent.futures.Future[None] = concurrent.futures.Future()

    def is_under_way(self) -> bool:
        """Return whether the goal has not ended."""
        return self.state in ('pending', 'active')

    def send(self, goal: Any) -> None:
        """Send the goal message."""
        answer = self._client.send(goal, self._id, self._receive_feedback)
        self._await(answer, self._receive_answer)

    def cancel(self) -> None:
        """Ask the server to cancel the goal as soon as it has accepted it."""
        self._cancel = True
        handle = self._handle  # another thread may remove it
        if handle is not None and self.is_under_way():
            self._futures.append(handle.cancel_goal_async())

    def lose(self) -> None:
        """Give up the goal, unless it has ended."""
        if self.is_under_way():
            for future in self._futures:
                future.cancel()  # no answer will come
            self._end('lost')

    def _await(self, future: Future[Any], receive: Callable[[Any], None]) -> None:
        def finish(_: Future[Any]) -> None:
            if not future.cancelled():
                receive(future.result())

        self._futures.append(future)
        future.add_done_callback(finish)

    def _receive_answer(self, handle: ClientGoalHandle[Any, Any, Any]) -> None:
        if not handle.accepted:
            self._end('rejected')
            return
        self._handle = handle
        self.state = 'active'
        self._await(handle.get_result_async(), self._receive_result)
        if self._cancel:
            self.cancel()
        self.answered.set_result(None)

    def _receive_feedback(self, message: Any) -> None:
        self.feedback = message.feedback

    def _receive_result(self, answer: Any) -> None:
        self.result = answer.result
        self._end(OUTCOMES.get(answer.status, 'lost'))

    def _end(self, state: GoalState) -> None:
        self.state = state
        self._client.forget(self._id)
        self._futures.clear()
        self._handle = None
        if not self.answered.done():
            self.answered.set_result(None)
