# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Actions, served one goal at a time."""

from rclpy.action import ActionServer as RosActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from serving.worker import Worker


class Goal:
    """
    A goal the logic works on.

    request: the goal message; feedback and result: messages to fill in.
    """

    def __init__(self, handle, action_type) -> None:
        """Wrap a goal handle of rclpy."""
        self.request = handle.request
        self.feedback = action_type.Feedback()
        self.result = action_type.Result()
        self._handle = handle
        self._replaced = False

    @property
    def cancel_requested(self) -> bool:
        """Whether the work should end: the client asked for it, or sent a newer goal."""
        return self._replaced or self._handle.is_cancel_requested

    def publish_feedback(self) -> None:
        """Send the feedback as it is now."""
        self._handle.publish_feedback(self.feedback)

    def succeed(self) -> None:
        """End the goal: it is reached."""
        self._handle.succeed()

    def abort(self) -> None:
        """End the goal: it cannot be reached."""
        self._handle.abort()

    def canceled(self) -> None:
        """End the goal because `cancel_requested` said so."""
        if self._handle.is_cancel_requested:
            self._handle.canceled()
        else:
            self._handle.abort()

    def replace(self) -> None:
        """Make room for a newer goal."""
        self._replaced = True


class ActionServer:
    """
    A server that works on one goal at a time; a newer goal asks the older to end.

    It accepts goals in a `with` block: while the node is active.
    """

    def __init__(self, node, action_type, name, execute) -> None:
        """Serve an action of a node by calling `execute` with each goal."""
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
        """Accept no more goals, and ask the one that runs to end."""
        self._open = False
        if self._latest is not None:
            self._latest.replace()

    def _answer(self, _request):
        return GoalResponse.ACCEPT if self._open else GoalResponse.REJECT

    async def _take_turn(self, handle):
        """Work on a goal once the one before has ended."""
        goal = Goal(handle, self._action_type)
        if self._latest is not None:
            self._latest.replace()
        self._latest = goal
        await self._worker.run(goal)
        return goal.result
