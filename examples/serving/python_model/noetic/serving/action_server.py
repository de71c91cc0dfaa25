# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""An action server that executes one goal at a time."""

from actionlib import SimpleActionServer


class Goal:
    """
    An action goal that the logic executes.

    request: the goal message; feedback and result: messages to fill in.
    """

    def __init__(self, server, request, action_type):
        """Wrap the current goal of an actionlib server."""
        self.request = request
        self.feedback = type(action_type().action_feedback.feedback)()
        self.result = type(action_type().action_result.result)()
        self._server = server

    @property
    def cancel_requested(self):
        """Whether to stop: the client canceled the goal or sent a new one."""
        return self._server.is_preempt_requested()

    def publish_feedback(self):
        """Publish the current feedback."""
        self._server.publish_feedback(self.feedback)

    def succeed(self):
        """Mark the goal as succeeded."""
        self._server.set_succeeded(self.result)

    def abort(self):
        """Mark the goal as aborted."""
        self._server.set_aborted(self.result)

    def canceled(self):
        """Mark the goal as canceled, after `cancel_requested` was true."""
        self._server.set_preempted(self.result)


class ActionServer:
    """An action server with one goal at a time; a new goal preempts the current one."""

    def __init__(self, name, action_type, execute):
        """Advertise the action; `execute` is called with each goal."""
        self._action_type = action_type
        self._execute = execute
        self._server = SimpleActionServer(
            name,
            action_type,
            execute_cb=self._work,
            auto_start=False,
        )
        self._server.start()

    def _work(self, request):
        self._execute(Goal(self._server, request, self._action_type))
