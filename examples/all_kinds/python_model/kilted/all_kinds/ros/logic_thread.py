# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The thread that calls configure, activate, update, deactivate and cleanup of the logic."""

from __future__ import annotations

from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import Any, Callable, Optional

from all_kinds.ros.stop import Stop
from all_kinds.ros.worker import Worker

GRACE = 0.2  # seconds for a method to return once its waits have ended


class LogicThread:
    """
    Runs the methods of the logic one after another, and waits for them no longer than it may.

    timeout: gives the time that methods have to return when the node stops, in seconds.
    log: writes what still runs to the log as an error.
    fail: is told of the exceptions of the logic.
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
        self._told_to_end: Future[None] = Future()
        self._worker = Worker('logic')

    @property
    def is_ending(self) -> bool:
        """Whether the node is to end."""
        return self._told_to_end.done()

    def begin(self, name: str, method: Callable[[], Any]) -> Any:
        """
        Call a first method, unless the node is to end; it has its time until then.

        Return what it returns, or None if it raises an exception or does not return.
        """
        if self.is_ending:
            return None
        self._stop.clear()
        call = self._worker.submit(self._call, method, name=name)
        wait([call, self._told_to_end], return_when=FIRST_COMPLETED)
        return call.result() if self.have_returned({call: name}) else None

    def loop(self, name: str, method: Callable[..., None], *arguments: Any) -> None:
        """Call a method that goes on until the node stops."""
        self._worker.submit(self._call, method, *arguments, name=name)

    def finish(self, name: str, method: Callable[[], Any]) -> None:
        """Call a last method, whose waits work again until its time is over."""
        is_free = not self._worker.pending()
        call = self._worker.submit(self._call_last, method, name=name)
        if is_free:  # else it comes late, after what has been told to be running still
            wait([call], self._timeout())
            self._stop.request()
            self.have_returned({call: name}, GRACE)

    def end(self) -> None:
        """Give a first method no more time than a last one."""
        self._stop.finish()
        if not self._told_to_end.done():
            self._told_to_end.set_result(None)

    def close(self) -> None:
        """End the thread after what it does."""
        self._worker.close()

    def running(self) -> dict[Future[Any], str]:
        """Return the calls that have not returned, with the names of the methods."""
        return self._worker.pending()

    def have_returned(
        self,
        calls: dict[Future[Any], str],
        timeout: Optional[float] = None,
    ) -> bool:
        """Wait until calls have returned; say which have not in time."""
        wait(calls, self._timeout() if timeout is None else timeout)
        names = sorted({name for call, name in calls.items() if not call.done()})
        if names:
            self._log(f'Still running when the node stops: {", ".join(names)}.')
        return not names

    def _call_last(self, method: Callable[[], Any]) -> None:
        self._stop.request(spare=self._worker.thread)
        self._call(method)

    def _call(self, method: Callable[..., Any], *arguments: Any) -> Any:
        try:
            return method(*arguments)
        except BaseException as error:
            self._fail(error)
            return None
