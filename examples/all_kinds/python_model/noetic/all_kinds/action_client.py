# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A non-blocking action client."""

from actionlib import GoalStatus, SimpleActionClient
import rospy

STATES = {
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

    def __init__(self, name, action_type):
        """Create the client."""
        self.Goal = type(action_type().action_goal.goal)
        self.state = 'idle'
        self.feedback = None
        self.result = None
        self._sent = None
        self._client = SimpleActionClient(name, action_type)

    def is_ready(self):
        """Return whether a server is available."""
        return self._client.wait_for_server(rospy.Duration(0.001))

    def send_goal(self, goal):
        """Send a goal, replacing the previous one; return False if no server is available."""
        self.feedback = None
        self.result = None
        if not self.is_ready():
            self.state = 'lost'
            return False
        self.state = 'pending'
        self._sent = sent = object()
        self._client.send_goal(
            goal,
            done_cb=lambda status, result: self._receive_result(sent, status, result),
            active_cb=lambda: self._receive_start(sent),
            feedback_cb=lambda feedback: self._receive_feedback(sent, feedback),
        )
        return True

    def cancel(self):
        """Ask the server to cancel the goal."""
        if self.state in ('pending', 'active'):
            self._client.cancel_goal()

    def _receive_start(self, sent):
        if sent is self._sent:
            self.state = 'active'

    def _receive_feedback(self, sent, feedback):
        if sent is self._sent:
            self.feedback = feedback

    def _receive_result(self, sent, status, result):
        if sent is self._sent:
            self.result = result
            self.state = STATES.get(status, 'lost')
