# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A non-blocking action client."""

from __future__ import annotations

from threading import Lock
from time import monotonic
from typing import Any, List, Optional

import actionlib
from actionlib import CommState, GoalStatus
from actionlib_msgs.msg import GoalID
from all_kinds.ros import timeouts

OUTCOMES = {
    GoalStatus.REJECTED: 'rejected',
    GoalStatus.SUCCEEDED: 'succeeded',
    GoalStatus.ABORTED: 'aborted',
    GoalStatus.PREEMPTED: 'canceled',
    GoalStatus.RECALLED: 'canceled',
}


class ActionClient:
    """
    An action client with one goal at a time; no method blocks.

    state: idle, pending, active, rejected, succeeded, aborted, canceled or lost.
    feedback: the latest feedback message, or None.
    result: the result message once the goal has ended, or None.
    """

    def __init__(self, name: str, action_type: Any) -> None:
        """Create the client."""
        self._client = actionlib.ActionClient(name, action_type)
        self._goal = SentGoal(self._client, 'idle')
        self._under_way: List[SentGoal] = []
        self._last_seen = monotonic()

    @property
    def state(self) -> str:
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
        """Return whether a server has sent its status and is connected by all topics."""
        status = self._client.last_status_msg
        if status is None:
            return False
        server = status._connection_header['callerid']
        subscribers = (self._client.status_sub, self._client.result_sub, self._client.feedback_sub)
        publishers = (self._client.pub_goal, self._client.pub_cancel)
        return all(publisher.impl.has_connection(server) for publisher in publishers) and all(
            any(connection.callerid_pub == server for connection in subscriber.impl.connections)
            for subscriber in subscribers
        )

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
        """Ask the server to cancel the goal."""
        self._goal.cancel()

    def watch(self) -> None:
        """Give up the goals if the server has been lost for too long."""
        if self.is_ready():
            self._last_seen = monotonic()
        elif monotonic() - self._last_seen >= timeouts.SERVER_LOST_TIMEOUT:
            for sent in self._under_way:
                sent.lose()


class SentGoal:
    """A goal and what becomes of it; its attributes are those of ActionClient."""

    def __init__(self, client: actionlib.ActionClient, state: str) -> None:
        """Prepare a pending goal, or one that is never sent: idle or lost."""
        self.state = state
        self.feedback: Optional[Any] = None
        self.result: Optional[Any] = None
        self._client = client
        self._handle: Optional[actionlib.ClientGoalHandle] = None
        self._lock = Lock()  # results and `watch` come from different threads

    def is_under_way(self) -> bool:
        """Return whether the goal has not ended."""
        return self.state in ('pending', 'active')

    def send(self, goal: Any) -> None:
        """Send the goal message."""
        self._handle = self._client.send_goal(goal, self._receive_state, self._receive_feedback)

    def cancel(self) -> None:
        """Ask the server to cancel the goal."""
        handle = self._handle
        if handle is not None and self.is_under_way():
            # In actionlib 1.14.0 handle.cancel() loses a goal that no status message lists yet.
            machine = handle.comm_state_machine
            machine.send_cancel_fn(GoalID(id=machine.action_goal.goal_id.id))

    def lose(self) -> None:
        """Give up the goal, unless it has ended."""
        self._end('lost')

    def _receive_state(self, handle: actionlib.ClientGoalHandle) -> None:
        state = handle.get_comm_state()
        if state in (CommState.ACTIVE, CommState.PREEMPTING):
            self._become_active()
        elif state == CommState.DONE:
            self._end(OUTCOMES.get(handle.get_goal_status(), 'lost'), handle.get_result())

    def _receive_feedback(self, _handle: actionlib.ClientGoalHandle, feedback: Any) -> None:
        self.feedback = feedback

    def _become_active(self) -> None:
        with self._lock:
            if self.is_under_way():
                self.state = 'active'

    def _end(self, state: str, result: Optional[Any] = None) -> None:
        with self._lock:
            if not self.is_under_way():
                return
            self.result = result
            self.state = state
        self._handle = None
        # actionlib 1.14.0 forgets ended goals only when a status message arrives.
        manager = self._client.manager
        with manager.list_mutex:
            manager.statuses = [goal for goal in manager.statuses if goal() is not None]
