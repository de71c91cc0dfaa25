# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Callbacks of the logic: one call of each at a time, and none delays another."""

from __future__ import annotations

from concurrent.futures import Future
from threading import current_thread, Lock
from typing import Any, Callable, Dict, TYPE_CHECKING

from all_kinds.ros.worker import show_name, Workers
import rospy

if TYPE_CHECKING:
    from all_kinds.ros.managed_node import ManagedNode


class Callback:
    """A callback that runs in the threads of rospy, which has one for each connection."""

    def __init__(self, node: ManagedNode, name: str, method: str) -> None:
        """Call a method of the logic, in threads that then have the name of a topic or service."""
        self._node = node
        self._method = method
        self._name = name
        self._one_at_a_time = Lock()
        self._running: Dict[Future[Any], str] = {}

    def run(self, *arguments: Any) -> Any:
        """Run the callback; return None if it fails or the node stops."""
        if current_thread().name != self._name:
            current_thread().name = self._name
            show_name(self._name)
        call: Future[Any] = Future()
        with self._one_at_a_time:
            if not self._node.stop.admit(lambda: self._running.setdefault(call, self._name)):
                return None
            try:
                return self._node.call(self._method, *arguments)
            except BaseException as error:
                self._node.fail(error)
                return None
            finally:
                del self._running[call]
                call.set_result(None)

    def running(self) -> Dict[Future[Any], str]:
        """Return the call that has not returned, with its name."""
        return self._running.copy()

    def receive(self, *arguments: Any) -> None:
        """Run the callback of a subscription; rospy queues the messages that come meanwhile."""
        self.run(*arguments)

    def serve(self, request: Any, response: Any) -> Any:
        """Run the callback of a service."""
        answer = self.run(request, response)
        if answer is not None:
            return answer
        if not (self._node.has_error or self._node.stop.requested):
            self._node.fail(TypeError(f'{self._method} returned no response'))
        raise rospy.ServiceException(f'{self._method} gives no response')


class CallbackThread:
    """
    A thread that runs a callback of an action, one call at a time.

    count: how many such threads there are, for as many calls at once.
    """

    def __init__(self, node: ManagedNode, name: str, method: str, count: int = 1) -> None:
        """Start the thread, named after the action."""
        self.count = count
        self._node = node
        self._method = method
        self._name = name
        self._worker = Workers(name, count)

    def execute(self, goal: Any, end: Callable[[Any], object]) -> None:
        """Run the callback of an action, unless the goal is canceled already, then end(goal)."""

        def execute() -> None:
            if goal.start():
                self._call(goal)
                if self._node.has_error:
                    goal.abort()
                elif goal.lacks_outcome():
                    rospy.logwarn(
                        f'{self._method} returned without an outcome: the goal is aborted.'
                    )
            try:
                end(goal)
            except BaseException as error:  # such as a field of a wrong type in the result
                self._node.fail(error)

        self._worker.submit(execute, name=self._name)

    def ask(self, request: Any, answer: Callable[[bool], object]) -> None:
        """Run the callback that says which goals to accept, then answer(whether it does)."""

        def ask() -> None:
            answer(not self._node.stop.requested and bool(self._call(request)))

        self._worker.submit(ask, name=self._name)

    def running(self) -> Dict[Future[Any], str]:
        """Return the calls that have not returned, with the name of the thread."""
        return self._worker.pending()

    def _call(self, *arguments: Any) -> Any:
        try:
            return self._node.call(self._method, *arguments)
        except BaseException as error:
            self._node.fail(error)
            return None
