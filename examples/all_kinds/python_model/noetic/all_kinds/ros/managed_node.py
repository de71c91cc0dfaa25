# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A node whose logic runs in threads of its own."""

from __future__ import annotations

from concurrent.futures import Future, wait
from functools import partial
import logging
from math import isfinite
from time import monotonic, sleep
import traceback
from typing import Any, Callable, Optional, Sequence

from all_kinds.ros import timeouts
from all_kinds.ros.action_client import ActionClient
from all_kinds.ros.action_server import ActionServer
from all_kinds.ros.callbacks import Callback, CallbackThread
from all_kinds.ros.logic_thread import LogicThread
from all_kinds.ros.loop import Loop
from all_kinds.ros.ros_time import RosTime
from all_kinds.ros.stop import Stop
from all_kinds.ros.worker import Worker
from rosgraph.names import is_legal_name
import rospy


class ManagedNode:
    """
    The base of the nodes; calls their logic in other threads, and limits the time to wait.

    state: as in the lifecycle of ROS 2.
    loop: calls update while the node is active, if there is one.
    failed: whether the logic refused to start or failed.
    has_error: whether the logic has failed.
    failure: why it has, or what it has refused.
    on_failure: called when the node has failed and is to end.
    """

    def __init__(self) -> None:
        """Prepare the threads."""
        self.state = 'unconfigured'
        self.failed = False
        self.on_failure: Callable[[], object] = lambda: None
        self.stop = Stop()
        self._time = RosTime(self.stop)
        self.loop: Optional[Loop] = None
        self._config: Any = None
        self._impl: Any = None
        self._log = logging.getLogger('rosout')
        self.has_error = False
        self.failure = ''
        self._callbacks: dict[str, Callback] = {}
        self._action_clients: list[ActionClient] = []
        self._action_servers: list[ActionServer] = []
        self._action_threads: list[CallbackThread] = []
        self._servers: dict[str, Any] = {}
        self._watcher = Worker('watch')
        # Read now, as the master may be gone when the node stops.
        self._timeout = read_parameter('stop_timeout', timeouts.STOP_TIMEOUT)
        if not 0.0 <= self._timeout <= 3600.0:
            raise rospy.ROSInitException('Parameter stop_timeout must be from 0 to 3600 s.')
        self._logic = LogicThread(self.stop, lambda: self._timeout, self._log.error, self.fail)
        self._transitions = Worker('transitions')

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        raise NotImplementedError

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        raise NotImplementedError

    def _publish_diagnostics(self) -> None:
        """Publish how the node is, if it has diagnostics."""

    def start(self) -> None:
        """Configure and activate the logic; do not wait for it."""
        self._starting = self._transitions.submit(self._start)
        self._watcher.submit(self._watch_servers)

    def end(self) -> bool:
        """Deactivate and clean up; return whether the logic has returned."""
        self._logic.end()
        wait([self._starting], self._timeout + timeouts.STOP_MARGIN)
        has_started = self._starting.done()
        # The start may wait for a master that does not answer, as may logging (rospy 1.15.15).
        ending = (self._transitions if has_started else Worker('end')).submit(self._end)
        wait([ending], 3.0 * self._timeout + timeouts.STOP_MARGIN)
        return has_started and ending.done() and ending.result()

    def _end(self) -> bool:
        self._shut_down()
        for server in self._action_servers:
            server.close()
        running = self._running()
        return self._logic.have_returned({self._starting: 'start'}, 0.0) and not running

    def fail(self, error: BaseException) -> None:
        """Log an exception of the logic and end the node."""
        lines = traceback.format_exception(type(error), error, error.__traceback__)
        reason = traceback.format_exception_only(type(error), error)
        self._give_up(''.join(lines), ''.join(reason))

    def fail_because(self, reason: str) -> None:
        """Log why the logic cannot go on, and end the node."""
        self._give_up(f'The logic failed: {reason}')

    def call(self, method: str, *arguments: Any) -> Any:
        """Call a method of the logic."""
        return getattr(self._impl, method)(*arguments)

    def _refusal(self, config: Any) -> str:
        """Let the logic take changed parameters; return why it refuses, or ''."""
        if self.state not in ('inactive', 'active'):
            return ''
        return self._logic.reconfigure(lambda: self._impl.reconfigure(config))

    def _running(self) -> dict[Future[Any], str]:
        """Return the calls of the logic that have not returned, with their names."""
        running = self._logic.pending()
        for callback in list(self._callbacks.values()):  # a copy, as a late start adds some
            running.update(callback.running())
        for thread in self._action_threads.copy():
            running.update(thread.running())
        return running

    def _callback(self, name: str, method: str) -> Callback:
        """Return a callback of the logic, the same each time."""
        if method not in self._callbacks:
            self._callbacks[method] = Callback(self, name, method)
        return self._callbacks[method]

    def _thread(self, name: str, method: str, count: int = 1) -> CallbackThread:
        """Create a thread for a callback of an action."""
        thread = CallbackThread(self, name, method, count)
        self._action_threads.append(thread)
        return thread

    def _client(self, name: str, client: Any) -> Any:
        """Add a client to those whose servers are watched."""
        self._servers[name] = client
        return client

    def _action_client(self, name: str, action_type: Any) -> ActionClient:
        """Create a client of an action."""
        client = ActionClient(name, action_type)
        self._action_clients.append(client)
        return client

    def _action_server(
        self,
        name: str,
        action_type: Any,
        method: str,
        new_goal: str,
        accept: str = '',
        at_once: int = 1,
    ) -> None:
        """Create a server of an action that a method of the logic executes."""
        thread = self._thread(name, method, at_once)
        asks = self._thread(name, accept) if accept else None
        self._action_servers.append(
            ActionServer(name, action_type, thread, self.stop, new_goal, asks)
        )

    def _start(self) -> None:
        if not self._begin('configure', self._connect_and_configure):
            return
        self.state = 'inactive'
        if self.has_error or not self._begin('activate', self._impl.activate):
            return
        self.state = 'active'
        if self.has_error:
            return
        try:
            self._connect_receivers()
        except BaseException as error:
            self.fail(error)
            return
        if self.loop and not self._logic.is_ending:  # otherwise the logic may be cleaned up
            self._logic.loop('update', self.loop.run, self.stop)

    def _call_at(self, frequency: float, method: str) -> None:
        """Call a method of the logic at a frequency, in a thread of its own."""
        call = partial(self.call, method)
        loop = Loop(call, frequency, self._time, self._log.warning, method)
        self._logic.beside(method, loop.run, self.stop)

    def _begin(self, name: str, method: Callable[[], bool]) -> bool:
        """Call configure or activate; leave if the logic refuses."""
        accepted = self._logic.begin(name, method)
        if not accepted and not self.has_error and not self._logic.is_ending:
            self.failure = f'The logic refused to {name}.'
            self._log.fatal(f'The logic refused to {name}.')
            self._leave()
        return bool(accepted)

    def _connect_and_configure(self) -> bool:
        self._connect_senders()
        return not self._logic.is_ending and bool(self._impl.configure(self._config))

    def _give_up(self, text: str, reason: str = '') -> None:
        self.failure = self.failure or ' '.join((reason or text).split())
        self.has_error = True
        self.failed = True
        self._transitions.submit(self._leave)
        self.on_failure()
        self._log.error(text)  # last, as rospy may wait for the master

    def _leave(self) -> None:
        self._publish_diagnostics()  # at once, as the process may end soon
        self._shut_down()
        self.failed = True
        self.on_failure()

    def _shut_down(self) -> None:
        if self.state == 'active':
            self._deactivate()
            self.state = 'inactive'
        if self.state == 'inactive':
            self._logic.finish('cleanup', self._impl.cleanup)
            self.state = 'finalized'

    def _deactivate(self) -> None:
        self.stop.request()
        self._logic.have_returned(self._running())
        for server in self._action_servers:
            server.give_up()
        self._logic.finish('deactivate', self._impl.deactivate)
        for client in self._action_clients:
            client.cancel()

    def _watch_servers(self) -> None:
        """Warn about servers that are not available; give up the goals of a lost one."""
        look_due = monotonic()
        while not rospy.is_shutdown():
            for client in self._action_clients:
                client.watch()
            if monotonic() >= look_due:
                servers = list(self._servers.items())  # a copy, as configure adds some
                missing = ', '.join(name for name, client in servers if not client.is_ready())
                if missing and self.state == 'active':
                    rospy.logwarn_throttle(timeouts.WARNING_PERIOD, f'Waiting for {missing}.')
                look_due = monotonic() + timeouts.MISSING_CHECK_PERIOD
            sleep(timeouts.SERVER_CHECK_PERIOD)


def read_parameter(name: str, default: Any) -> Any:
    """Return a private parameter; raise if its type is not that of the default."""
    return checked(name, rospy.get_param('~' + name, default), type(default))


def read_list(name: str, type_: type, default: Sequence[Any]) -> Any:
    """Return a private parameter; raise if it is no list of values of a type."""
    values = rospy.get_param('~' + name, list(default))
    if not isinstance(values, list):
        raise rospy.ROSInitException(f'Parameter {name} must be a list, not {values!r}.')
    return tuple(checked(name, value, type_) for value in values)


def checked(name: str, value: Any, type_: type) -> Any:
    """Return a value of a parameter; raise if it is not of its type."""
    if type_ is float and type(value) is int:
        value = float(value)
    if type(value) is not type_:
        wanted = type_.__name__
        raise rospy.ROSInitException(f'Parameter {name} must be of type {wanted}, not {value!r}.')
    return value


def check_topic(name: str, value: str) -> None:
    """Raise if the value of a parameter is not the name of a topic."""
    if not value or not is_legal_name(value):
        wanted = 'the name of a topic'
        raise rospy.ROSInitException(f'Parameter {name} must be {wanted}, not {value!r}.')


def check_topics(name: str, values: Sequence[str]) -> None:
    """Raise if not all values of a parameter are names of topics, each once."""
    for value in values:
        is_name = bool(value) and is_legal_name(value)
        if not is_name or values.count(value) > 1:
            wanted = 'have names of topics, each once'
            found = f'{value!r} twice' if is_name else repr(value)
            raise rospy.ROSInitException(f'Parameter {name} must {wanted}, not {found}.')


def check_range(name: str, value: float, low: float, high: float) -> None:
    """Raise if a parameter is out of its range, or not finite."""
    if not (isfinite(value) and low <= value <= high):
        wanted = f'from {low} to {high}'
        raise rospy.ROSInitException(f'Parameter {name} must be {wanted}, not {value}.')
