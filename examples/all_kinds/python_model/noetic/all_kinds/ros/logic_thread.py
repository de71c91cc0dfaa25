# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The thread that calls configure, activate, update, deactivate and cleanup of the logic."""

from __future__ import annotations

from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import Any, Callable, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.stop import Stop
from all_kinds.ros.worker import Worker


class LogicThread(Worker):
    """
    Runs the methods of the logic one after another, and limits the time to wait for them.

    timeout: returns the parameter stop_timeout, in seconds.
    log: logs an error about methods that still run.
    fail: is called with every exception of the logic.
    """

    def __init__(
        self,
        stop: Stop,
        timeout: Callable[[], float],
        log: Callable[[str], object],
        fail: Callable[[BaseException], object],
    ) -> None:
        """Start the thread."""
        self._stop = stop
        self._timeout = timeout
        self._log = log
        self._fail = fail
        self._end_requested: Future[None] = Future()
        self._others: dict[str, Worker] = {}
        super().__init__('logic')

    @property
    def is_ending(self) -> bool:
        """Whether `end` was called."""
        return self._end_requested.done()

    def begin(self, name: str, method: Callable[[], Any]) -> Any:
        """
        Call configure or activate, and wait; after `end` for stop_timeout at most.

        Return its result, or None if it fails, has not returned or the node ends already.
        """
        if self.is_ending:
            return None
        self._stop.clear()
        call = self.submit(self._call, method, name=name)
        wait([call, self._end_requested], return_when=FIRST_COMPLETED)
        return call.result() if self.have_returned({call: name}) else None

    def loop(self, name: str, method: Callable[..., None], *arguments: Any) -> None:
        """Start a method that runs until the node stops."""
        self.submit(self._call, method, *arguments, name=name)

    def beside(self, name: str, method: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Call a method in a thread of its own, mostly one that runs until the node stops."""
        if name not in self._others:
            self._others[name] = Worker(name)
        return self._others[name].submit(self._call, method, *arguments, name=name)

    def repeat(self, name: str, method: Callable[[], object]) -> None:
        """Call a method again and again, in a thread of its own, until the node stops."""

        def run() -> None:
            while not self._stop.requested:
                method()

        self.beside(name, run)

    def finish(self, name: str, method: Callable[[], Any]) -> None:
        """Call deactivate or cleanup, whose own waits work until stop_timeout is over."""
        is_free = not super().pending()
        call = self.submit(self._call_last, method, name=name)
        if is_free:  # otherwise the method that blocks the thread is in the log already
            wait([call], self._timeout())
            self._stop.request()
            self.have_returned({call: name}, timeouts.RETURN_TIMEOUT)

    def reconfigure(self, method: Callable[[], str]) -> str:
        """Call reconfigure in a thread of its own; return why the logic refuses, or ''."""
        call = self.beside('reconfigure', method)
        wait([call], timeouts.RECONFIGURE_TIMEOUT)
        reason = call.result() if call.done() else 'reconfigure has not returned'
        return reason if isinstance(reason, str) else 'reconfigure has failed'

    def end(self) -> None:
        """Let configure and activate take no longer than stop_timeout from now on."""
        self._stop.finish()
        if not self.is_ending:
            self._end_requested.set_result(None)

    def close(self) -> None:
        """End the threads after the calls submitted so far."""
        super().close()
        for worker in self._others.values():
            worker.close()

    def pending(self) -> dict[Future[Any], str]:
        """Return the calls that have not returned, in all threads, with their methods."""
        pending = super().pending()
        for worker in list(self._others.values()):
            pending.update(worker.pending())
        return pending

    def have_returned(
        self,
        calls: dict[Future[Any], str],
        timeout: Optional[float] = None,
    ) -> bool:
        """Return whether calls return in time, by default stop_timeout; log those that do not."""
        wait(calls, self._timeout() if timeout is None else timeout)
        names = sorted({name for call, name in calls.items() if not call.done()})
        if names:
            self._log(f'Still running when the node stops: {", ".join(names)}.')
        return not names

    def _call_last(self, method: Callable[[], Any]) -> None:
        self._stop.request(exempt=self.thread)
        self._call(method)

    def _call(self, method: Callable[..., Any], *arguments: Any) -> Any:
        try:
            return method(*arguments)
        except BaseException as error:
            self._fail(error)
            return None
