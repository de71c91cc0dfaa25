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
    """A daemon thread that runs the calls submitted to it, in their order."""

    def __init__(self, name: str) -> None:
        """Start the thread."""
        self._calls: SimpleQueue[Optional[tuple[Future[Any], Callable[[], Any]]]] = SimpleQueue()
        self._pending: dict[Future[Any], str] = {}
        self.thread = Thread(target=self._work, name=name, daemon=True)
        self.thread.start()

    def submit(self, call: Callable[..., Any], *arguments: Any, name: str = '') -> Future[Any]:
        """Run call(*arguments) in the thread; the future has what it returns or raises."""
        future: Future[Any] = Future()
        self._pending[future] = name
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
                future.set_result(call())
            except BaseException as error:
                future.set_exception(error)
            del future, call  # release them before waiting for the next call


class Workers(Worker):
    """Daemon threads of one name; each call submitted runs in the first that is free."""

    def __init__(self, name: str, count: int) -> None:
        """Start the threads."""
        super().__init__(name)
        self._count = count
        for _ in range(count - 1):
            Thread(target=self._work, name=name, daemon=True).start()

    def close(self) -> None:
        """End the threads after the calls submitted so far."""
        for _ in range(self._count):
            super().close()


def show_name(name: str) -> None:
    """Show a name for this thread in tools such as top, on Linux."""
    with suppress(OSError):
        Path(f'/proc/self/task/{get_native_id()}/comm').write_text(name[:15])
