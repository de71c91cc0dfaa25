# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Threads for the callbacks of the logic, so that none delays another or the executor."""

from __future__ import annotations

from concurrent.futures import Future
from queue import SimpleQueue
from typing import Any, Optional, TYPE_CHECKING

from all_kinds.ros.worker import Workers

if TYPE_CHECKING:
    from all_kinds.ros.managed_node import ManagedNode


class NoResponse(Exception):
    """A callback of the logic has returned no response."""


class CallbackThread:
    """
    A thread that runs one callback, one call at a time, while the executor goes on.

    count: how many such threads there are, for as many calls at once.
    """

    def __init__(self, node: ManagedNode, name: str, method: str, count: int = 1) -> None:
        """Start the thread, named after a topic, service or action."""
        self.count = count
        self.name = name
        self._unanswered: dict[Future[None], str] = {}
        self._node = node
        self._method = method
        self._worker = Workers(name, count)

    async def run(self, *arguments: Any, until: Optional[Future[None]] = None) -> Any:
        """Run the callback; return None if it fails, the node stops or `until` comes first."""
        answered: Future[None] = Future()
        self._unanswered[answered] = self.name
        call = self._begin(*arguments)
        if call is None:
            self._forget(answered)
            return None
        try:
            if not call.done():
                await self._node.await_first(call, *([until] if until else []))
            return call.result() if call.done() else None
        finally:
            executor = self._node.executor
            assert executor is not None
            # In a task, which it runs after it has sent the response of a service.
            executor.create_task(self._forget, answered)

    async def receive(self, *arguments: Any) -> None:
        """Run the callback of a subscription."""
        call = self._begin(*arguments)
        if call and not call.done():
            await self._node.await_first(call)

    async def serve(self, request: Any, response: Any) -> Any:
        """Run the callback of a service."""
        answer = await self.run(request, response)
        if answer is not None:
            return answer
        if not (self._node.has_error or self._node.stop.requested):
            self._node.fail(TypeError(f'{self._method} returned no response'))
        raise NoResponse(self._method)

    @property
    def has_failed(self) -> bool:
        """Whether the logic has failed."""
        return self._node.has_error

    def warn(self, text: str) -> None:
        """Warn of what the callback did."""
        self._node.get_logger().warning(f'{self._method} {text}')

    def under_way(self) -> dict[Future[Any], str]:
        """Return the calls that have not returned or are not yet answered, with their name."""
        return {**self._worker.pending(), **self._unanswered}

    def is_running(self) -> bool:
        """Return whether a call has not returned."""
        return bool(self._worker.pending())

    def close(self) -> None:
        """End the thread after the calls under way."""
        self._worker.close()

    def _begin(self, *arguments: Any) -> Optional[Future[Any]]:
        """
        Submit a call, unless the node stops; wait until its thread begins it.

        Otherwise the executor would hold the GIL until it waits again. A thread that is still busy
        with a call that was given up is not waited for.
        """
        is_free = len(self._worker.pending()) < self.count
        begun: SimpleQueue[None] = SimpleQueue()

        def run() -> Any:
            begun.put(None)
            return self._call(*arguments)

        call = self._node.stop.admit(lambda: self._worker.submit(run, name=self.name))
        if call and is_free:
            begun.get()
        return call

    def _call(self, *arguments: Any) -> Any:
        try:
            return self._node.call(self._method, *arguments)
        except BaseException as error:
            self._node.fail(error)
            return None

    def _forget(self, answered: Future[None]) -> None:
        del self._unanswered[answered]
        answered.set_result(None)
