# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The action client of rclpy, for many goals from any thread."""

from __future__ import annotations

from threading import Lock
from typing import Any, Callable
from uuid import uuid4

from rclpy.action import ActionClient
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from rclpy.task import Future
from unique_identifier_msgs.msg import UUID


class GoalSender(ActionClient):  # type: ignore[type-arg] # generic in newer ROS 2 only
    """
    The action client of rclpy, with two defects of rclpy 9.1.2 worked around.

    Its send_goal_async() replaces the future of a goal by a second one: a response in between is
    lost, and the first future is kept for ever, as are the feedback callbacks of rejected goals.
    """

    def __init__(self, node: Node, action_type: Any, name: str) -> None:
        """Create the client."""
        self._sending = Lock()
        super().__init__(node, action_type, name, callback_group=ReentrantCallbackGroup())

    @staticmethod
    def new_id() -> UUID:
        """Return an identifier for a goal."""
        return UUID(uuid=list(uuid4().bytes))

    def send(
        self,
        goal: Any,
        goal_id: UUID,
        receive_feedback: Callable[[Any], None],
    ) -> Future[Any]:
        """Send a goal; the future gives its handle."""
        with self._sending:
            before = list(self._futures)
            future = self.send_goal_async(goal, receive_feedback, goal_id)
            for other in list(self._futures):  # a copy, as the executor removes some
                if other not in before and other is not future:
                    self.remove_future(other)
        return future

    def take_data(self) -> Any:
        """Take received data, but not while a goal is being sent."""
        with self._sending:
            return super().take_data()

    def forget(self, goal_id: UUID) -> None:
        """Remove what rclpy keeps of a goal."""
        key = bytes(goal_id.uuid)
        self._feedback_callbacks.pop(key, None)
        self._goal_handles.pop(key, None)
