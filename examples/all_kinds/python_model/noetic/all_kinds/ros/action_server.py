# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""An action server that executes one goal at a time, or several."""

from __future__ import annotations

from contextlib import suppress
from io import BytesIO
from threading import Event, RLock, Thread
from typing import Any, List, Optional

import actionlib
from actionlib import GoalStatus, ServerGoalHandle
from actionlib_msgs.msg import GoalID, GoalStatusArray
from all_kinds.ros import timeouts
from all_kinds.ros.callbacks import CallbackThread
from all_kinds.ros.stop import Stop
import rospy


class Goal:
    """
    An action goal that the logic executes.

    request: the goal message; feedback and result: messages to fill in.
    """

    def __init__(self, handle: ServerGoalHandle, action_type: Any, stop: Stop) -> None:
        """Wrap an actionlib goal handle."""
        self.request = handle.get_goal()
        self.feedback = type(action_type().action_feedback.feedback)()
        self.result = type(action_type().action_result.result)()
        self._handle = handle
        self._stop = stop
        self._lock = RLock()
        self._replaced = False
        self._has_ended = False
        self._outcome = 'canceled'

    @property
    def cancel_requested(self) -> bool:
        """Whether to stop: canceled, replaced by another goal, or the node stops."""
        return self._replaced or self._stop.requested or self._is_canceled()

    def publish_feedback(self) -> None:
        """Publish the current feedback."""
        with self._lock:
            if not self._has_ended:
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

    def start(self) -> bool:
        """Return whether the logic is to execute the goal: False if it is canceled already."""
        with self._lock:
            if self._has_ended or self.cancel_requested:
                return False
            self._outcome = 'none'  # until the logic sets one
            return True

    def lacks_outcome(self) -> bool:
        """Return whether the logic has set none, though no cancel was requested."""
        return self._outcome == 'none' and not self.cancel_requested

    def end(self) -> None:
        """Send the outcome; abort the goal if its result cannot be sent."""
        with self._lock:
            if self._has_ended:
                return
            self._has_ended = True
            try:
                self.result.serialize(BytesIO())
            except Exception:
                self._handle.set_aborted()
                raise
            if self._outcome == 'succeeded':
                self._handle.set_succeeded(self.result)
            elif self._outcome == 'canceled' and (self._replaced or self._is_canceled()):
                self._handle.set_canceled(self.result)
            else:
                self._handle.set_aborted(self.result)

    def give_up(self) -> None:
        """End the goal without waiting for the logic."""
        with self._lock:
            self._outcome = 'aborted'
            with suppress(Exception):  # the logic may be changing the result
                self.end()

    def _is_canceled(self) -> bool:
        return bool(self._handle.get_goal_status().status == GoalStatus.PREEMPTING)


class ActionServer:
    """
    An action server with one goal at a time, or several.

    new_goal: how to treat a goal that comes while another is executed: let it `replace` the other,
    put it into a `queue`, `reject` it, or execute it in `parallel`, if a thread is free.
    asks: the thread of the method that says which goals the logic accepts, if it does.
    """

    def __init__(
        self,
        name: str,
        action_type: Any,
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
        self._undecided: List[ServerGoalHandle] = []
        self._goals: List[Goal] = []
        self._server = RosActionServer(name, action_type, self._take, auto_start=False)
        self._server.start()

    def close(self) -> None:
        """Publish the status no more."""
        self._server.ended.set()

    def give_up(self) -> None:
        """End the goals without waiting for the logic."""
        for handle in self._undecided.copy():
            self._decide(handle, False)
        for goal in self._goals.copy():
            goal.give_up()

    def _take(self, handle: ServerGoalHandle) -> None:
        if not self._is_welcome():
            handle.set_rejected()
        elif self._asks:  # in its own thread: actionlib has locked the server
            self._undecided.append(handle)
            self._asks.ask(handle.get_goal(), lambda accepts: self._decide(handle, accepts))
        else:
            self._accept(handle)

    def _decide(self, handle: ServerGoalHandle, accepts: bool) -> None:
        try:
            self._undecided.remove(handle)
        except ValueError:  # decided when the node stopped
            return
        if accepts and self._is_welcome():
            self._accept(handle)
        else:
            handle.set_rejected()

    def _is_welcome(self) -> bool:
        return not (self._stop.requested or self._is_full())

    def _accept(self, handle: ServerGoalHandle) -> None:
        if self._new_goal == 'replace':
            for goal in self._goals.copy():  # the first may end meanwhile
                goal.replace()
        handle.set_accepted()
        goal = Goal(handle, self._action_type, self._stop)
        self._goals.append(goal)
        self._thread.execute(goal, self._end)

    def _is_full(self) -> bool:
        is_limited = self._new_goal in ('reject', 'parallel')
        return is_limited and len(self._goals) >= self._thread.count

    def _end(self, goal: Goal) -> None:
        self._goals.remove(goal)
        goal.end()


class RosActionServer(actionlib.ActionServer):
    """
    The action server of actionlib, with its status published by wall time.

    The rospy.Timer that actionlib 1.14.0 uses ends with an exception when ROS time jumps back.
    """

    def initialize(self) -> None:
        """Advertise and subscribe, with actionlib's defaults; start to publish the status."""
        self.ended = Event()
        self.status_list_timeout = rospy.Duration(timeouts.STATUS_TIMEOUT)
        name = rospy.remap_name(self.ns)
        self.status_pub = rospy.Publisher(
            name + '/status',
            GoalStatusArray,
            latch=True,
            queue_size=50,
        )
        self.result_pub = rospy.Publisher(name + '/result', self.ActionResult, queue_size=50)
        self.feedback_pub = rospy.Publisher(name + '/feedback', self.ActionFeedback, queue_size=50)
        rospy.Subscriber(name + '/goal', self.ActionGoal, self.internal_goal_callback)
        rospy.Subscriber(name + '/cancel', GoalID, self.internal_cancel_callback)
        Thread(target=self._publish_status, name=self.ns + ' status', daemon=True).start()

    def _publish_status(self) -> None:
        while not self.ended.wait(timeouts.STATUS_PERIOD):
            self.publish_status_async(None)
