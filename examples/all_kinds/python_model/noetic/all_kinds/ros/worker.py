# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A named thread that runs one call after another."""

from __future__ import annotations

from concurrent.futures import Future
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue
from threading import get_native_id, Thread
from typing import Any, Callable, Optional


class Worker:
    """
    A thread that runs the calls submitted to it, in their order.

    thread: the thread; it does not keep the process alive.
    """

    def __init__(self, name: str) -> None:
        """Start the thread."""
        self._calls: SimpleQueue[Optional[tuple[Future[Any], Callable[[], Any]]]] = SimpleQueue()
        self._pending: dict[Future[Any], str] = {}
        self.thread = Thread(target=self._work, name=name, daemon=True)
        self.thread.start()

    def submit(self, call: Callable[..., Any], *arguments: Any, name: str = '') -> Future[Any]:
        """Have call(*arguments) run; the future gives what it returns or raises."""
        future: Future[Any] = Future()
        self._pending[future] = name or getattr(call, '__name__', str(call))
        future.add_done_callback(self._pending.pop)
        self._calls.put((future, lambda: call(*arguments)))
        return future

    def pending(self) -> dict[Future[Any], str]:
        """Return the calls that have not returned, with their names."""
        return {call: name for call, name in list(self._pending.items()) if not call.done()}

    def close(self) -> None:
        """End the thread after the calls submitted so far."""
        self._calls.put(None)

    def _work(self) -> None:
        show_name(self.thread.name)
        for future, call in iter(self._calls.get, None):
            try:
                result = call()
            except BaseException as error:
                future.set_exception(error)
            else:
                future.set_result(result)
            del future, call  # do not keep them until the next call


def show_name(name: str) -> None:
    """Name this thread in tools such as top, where the system is Linux."""
    with suppress(OSError):
        Path(f'/proc/self/task/{get_native_id()}/comm').write_text(name[:15])
