# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""An action server that executes one goal at a time, or several."""

from __future__ import annotations

from concurrent.futures import Future
from time import monotonic, sleep
from typing import Any, cast, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.callbacks import CallbackThread
from all_kinds.ros.stop import Stop
from rclpy.action import ActionServer as RosActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node


class Goal:
    """
    An action goal that the logic executes.

    request: the goal message; feedback and result: messages to fill in.
    """

    def __init__(
        self,
        handle: ServerGoalHandle[Any, Any, Any],
        action_type: Any,
        stop: Stop,
    ) -> None:
        """Wrap an rclpy goal handle."""
        self.request = handle.request
        self.feedback = action_type.Feedback()
        self.result = action_type.Result()
        self._handle = handle
        self._stop = stop
        self._replaced = False
        self._outcome = 'canceled'
        self._given_up: Future[None] = Future()

    @property
    def cancel_requested(self) -> bool:
        """Whether to stop: canceled, replaced by another goal, or the node stops."""
        return self._replaced or self._stop.requested or self._handle.is_cancel_requested

    def publish_feedback(self) -> None:
        """Publish the current feedback."""
        if not self._given_up.done():
            self._handle.publish_feedback(self.feedback)

    def succeed(self) -> None:
        """Mark the goal as succeeded."""
        self._outcome = 'succeeded'

    def abort(self) -> None:
        """Mark the goal as aborted."""
        self._outcome = 'aborted'

    def canceled(self) -> None:
        """Mark the goal as canceled, after `cancel_requested` was true."""
        self._outcome = 'canceled'

    def replace(self) -> None:
        """Ask the logic to end the goal in favour of a new one."""
        self._replaced = True

    def give_up(self) -> None:
        """End the goal without waiting for the logic."""
        if not self._given_up.done():
            self._given_up.set_result(None)

    def start(self) -> None:
        """Have the server execute the goal."""
        self._handle.execute()

    def is_of(self, handle: ServerGoalHandle[Any, Any, Any]) -> bool:
        """Return whether this is the goal of a handle."""
        return self._handle is handle

    async def execute(self, thread: CallbackThread) -> None:
        """Have the logic execute the goal, unless it is canceled already; send its outcome."""
        if not self.cancel_requested:
            self._outcome = 'none'  # until the logic sets one
            await thread.run(self, until=self._given_up)
            if thread.has_failed:
                self.abort()
            elif self._outcome == 'none' and not self.cancel_requested:
                thread.warn('returned without an outcome: the goal is aborted.')
        if self._outcome == 'succeeded' and not self._given_up.done():
            self._handle.succeed()
        elif self._outcome == 'canceled' and self._handle.is_cancel_requested:
            self._handle.canceled()
        else:
            self._handle.abort()


class ActionServer:
    """
    An action server with one goal at a time, or several.

    new_goal: how to treat a goal that comes while another is executed: let it `replace` the other,
    put it into a `queue`, `reject` it, or execute it in `parallel`, if a thread is free.
    asks: the thread of the method that says which goals the logic accepts, if it does.
    """

    def __init__(
        self,
        node: Node,
        action_type: Any,
        name: str,
        thread: CallbackThread,
        stop: Stop,
        new_goal: str,
        asks: Optional[CallbackThread] = None,
    ) -> None:
        """Advertise the action, whose goals the thread executes."""
        self._action_type = action_type
        self._thread = thread
        self._stop = stop
        self._new_goal = new_goal
        self._asks = asks
        self._open = False
        self._last_time = 0.0  # when a goal came or ended
        self._goals: list[Goal] = []
        self._server = RosActionServer(
            node,
            action_type,
            name,
            self._execute,
            # rclpy 9.1 awaits its answer, which the type of this argument does not say.
            goal_callback=cast(Any, self._answer),
            handle_accepted_callback=self._accept,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=ReentrantCallbackGroup(),
        )

    def accept_goals(self, whether: bool) -> None:
        """Accept new goals, or reject them."""
        self._open = whether

    def give_up(self) -> None:
        """End the goals without waiting for the logic."""
        for goal in self._goals.copy():
            goal.give_up()

    def flush(self) -> None:
        """Wait for the last goals to end, and for clients to ask for their results."""
        end = monotonic() + timeouts.GOAL_TIMEOUT
        while self._goals and monotonic() < end:
            sleep(0.01)
        sleep(max(0.0, self._last_time + timeouts.RESULT_TIMEOUT - monotonic()))

    async def _answer(self, request: Any) -> GoalResponse:
        is_accepted = self._is_welcome()
        if is_accepted and self._asks:
            is_accepted = bool(await self._asks.run(request)) and self._is_welcome()
        return GoalResponse.ACCEPT if is_accepted else GoalResponse.REJECT

    def _is_welcome(self) -> bool:
        return self._open and not self._is_full()

    def _is_full(self) -> bool:
        is_limited = self._new_goal in ('reject', 'parallel')
        return is_limited and len(self._goals) >= self._thread.count

    def _accept(self, handle: ServerGoalHandle[Any, Any, Any]) -> None:
        self._last_time = monotonic()
        if self._new_goal == 'replace':
            for goal in self._goals:
                goal.replace()
        goal = Goal(handle, self._action_type, self._stop)
        self._goals.append(goal)
        if len(self._goals) <= self._thread.count:
            goal.start()

    async def _execute(self, handle: ServerGoalHandle[Any, Any, Any]) -> Any:
        """Execute a goal and start the next that waits."""
        goal = next(goal for goal in self._goals if goal.is_of(handle))
        await goal.execute(self._thread)
        self._last_time = monotonic()
        self._goals.remove(goal)
        if len(self._goals) >= self._thread.count:
            self._goals[self._thread.count - 1].start()
        return goal.result
