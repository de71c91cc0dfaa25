# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Worker threads for the callbacks of the logic, so that none delays another."""

from queue import SimpleQueue
from threading import Thread

from rclpy.task import Future


class Worker:
    """Runs a blocking callback in its own thread, one call at a time."""

    def __init__(self, node, callback) -> None:
        """Start the thread; it ends with the worker."""
        self._node = node
        self._calls = SimpleQueue()
        Thread(target=work, args=(callback, self._calls), daemon=True).start()

    def __del__(self) -> None:
        """End the thread."""
        self._calls.put(None)

    async def run(self, *arguments):
        """Await the callback's result without blocking the executor."""
        executor = self._node.executor
        result = Future(executor=executor)
        result.add_done_callback(lambda _: executor.wake())  # it may be asleep
        self._calls.put((arguments, result))
        return await result


def work(callback, calls) -> None:
    """Execute the queued calls until None."""
    for arguments, result in iter(calls.get, None):
        try:
            result.set_result(callback(*arguments))
        except Exception as error:
            result.set_exception(error)
