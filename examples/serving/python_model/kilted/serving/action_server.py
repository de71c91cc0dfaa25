# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""An action server that executes one goal at a time."""

from rclpy.action import ActionServer as RosActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from serving.worker import Worker


class Goal:
    """
    An action goal that the logic executes.

    request: the goal message; feedback and result: messages to fill in.
    """

    def __init__(self, handle, action_type) -> None:
        """Wrap an rclpy goal handle."""
        self.request = handle.request
        self.feedback = action_type.Feedback()
        self.result = action_type.Result()
        self._handle = handle
        self._replaced = False

    @property
    def cancel_requested(self) -> bool:
        """Whether to stop: the client canceled the goal or sent a new one."""
        return self._replaced or self._handle.is_cancel_requested

    def publish_feedback(self) -> None:
        """Publish the current feedback."""
        self._handle.publish_feedback(self.feedback)

    def succeed(self) -> None:
        """Mark the goal as succeeded."""
        self._handle.succeed()

    def abort(self) -> None:
        """Mark the goal as aborted."""
        self._handle.abort()

    def canceled(self) -> None:
        """Mark the goal as canceled, after `cancel_requested` was true."""
        if self._handle.is_cancel_requested:
            self._handle.canceled()
        else:
            self._handle.abort()

    def replace(self) -> None:
        """Preempt the goal in favour of a new one."""
        self._replaced = True


class ActionServer:
    """
    An action server with one goal at a time; a new goal preempts the current one.

    It accepts goals inside a `with` block: while the node is active.
    """

    def __init__(self, node, action_type, name, execute) -> None:
        """Advertise the action; `execute` is called with each goal."""
        self._action_type = action_type
        self._worker = Worker(node, execute)
        self._open = False
        self._latest = None
        self._server = RosActionServer(
            node,
            action_type,
            name,
            self._take_turn,
            goal_callback=self._answer,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=ReentrantCallbackGroup(),
        )

    def __enter__(self):
        """Accept goals."""
        self._open = True
        return self

    def __exit__(self, *_error) -> None:
        """Reject new goals and preempt the current one."""
        self._open = False
        if self._latest is not None:
            self._latest.replace()

    def _answer(self, _request):
        return GoalResponse.ACCEPT if self._open else GoalResponse.REJECT

    async def _take_turn(self, handle):
        """Execute a goal after the previous one has ended."""
        goal = Goal(handle, self._action_type)
        if self._latest is not None:
            self._latest.replace()
        self._latest = goal
        await self._worker.run(goal)
        return goal.result
