# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Actions, served one goal at a time."""

from actionlib import SimpleActionServer


class Goal:
    """
    A goal the logic works on.

    request: the goal message; feedback and result: messages to fill in.
    """

    def __init__(self, server, request, action_type):
        """Wrap the goal a server of actionlib works on."""
        self.request = request
        self.feedback = type(action_type().action_feedback.feedback)()
        self.result = type(action_type().action_result.result)()
        self._server = server

    @property
    def cancel_requested(self):
        """Whether the work should end: the client asked for it, or sent a newer goal."""
        return self._server.is_preempt_requested()

    def publish_feedback(self):
        """Send the feedback as it is now."""
        self._server.publish_feedback(self.feedback)

    def succeed(self):
        """End the goal: it is reached."""
        self._server.set_succeeded(self.result)

    def abort(self):
        """End the goal: it cannot be reached."""
        self._server.set_aborted(self.result)

    def canceled(self):
        """End the goal because `cancel_requested` said so."""
        self._server.set_preempted(self.result)


class ActionServer:
    """A server that works on one goal at a time; a newer goal asks the older to end."""

    def __init__(self, name, action_type, execute):
        """Serve an action by calling `execute` with each goal."""
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
