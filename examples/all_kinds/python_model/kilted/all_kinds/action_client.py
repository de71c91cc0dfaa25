# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A non-blocking action client."""

from action_msgs.msg import GoalStatus
from rclpy.action import ActionClient as RosActionClient
from rclpy.callback_groups import ReentrantCallbackGroup

STATES = {
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

    def __init__(self, node, action_type, name) -> None:
        """Create the client."""
        self.Goal = action_type.Goal
        self.state = 'idle'
        self.feedback = None
        self.result = None
        self._sent = None
        self._handle = None
        self._client = RosActionClient(
            node,
            action_type,
            name,
            callback_group=ReentrantCallbackGroup(),
        )

    def forget(self) -> None:
        """Cancel the goal and reset the state."""
        self.cancel()
        self.state = 'idle'
        self.feedback = None
        self.result = None
        self._sent = None
        self._handle = None

    def is_ready(self) -> bool:
        """Return whether a server is available."""
        return self._client.server_is_ready()

    def send_goal(self, goal) -> bool:
        """Send a goal, replacing the previous one; return False if no server is available."""
        self.feedback = None
        self.result = None
        self._handle = None
        if not self.is_ready():
            self.state = 'lost'
            return False
        self.state = 'pending'
        self._sent = sent = object()
        future = self._client.send_goal_async(
            goal,
            feedback_callback=lambda message: self._receive_feedback(sent, message),
        )
        future.add_done_callback(lambda answer: self._receive_answer(sent, answer.result()))
        return True

    def cancel(self) -> None:
        """Ask the server to cancel the goal."""
        if self._handle is not None:
            self._handle.cancel_goal_async()

    def _receive_answer(self, sent, handle) -> None:
        if sent is not self._sent:
            return
        if not handle.accepted:
            self.state = 'rejected'
            return
        self._handle = handle
        self.state = 'active'
        handle.get_result_async().add_done_callback(
            lambda answer: self._receive_result(sent, answer.result())
        )

    def _receive_feedback(self, sent, message) -> None:
        if sent is self._sent:
            self.feedback = message.feedback

    def _receive_result(self, sent, answer) -> None:
        if sent is self._sent:
            self.result = answer.result
            self.state = STATES.get(answer.status, 'lost')
