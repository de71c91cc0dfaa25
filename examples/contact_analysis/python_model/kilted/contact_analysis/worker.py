# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Threads for the callbacks of the logic, so that none stops another."""

from queue import SimpleQueue
from threading import Thread

from rclpy.task import Future


class Worker:
    """Runs a callback that may block in a thread of its own, one call at a time."""

    def __init__(self, node, callback) -> None:
        """Start the thread, which ends with the worker."""
        self._node = node
        self._calls = SimpleQueue()
        Thread(target=work, args=(callback, self._calls), daemon=True).start()

    def __del__(self) -> None:
        """End the thread."""
        self._calls.put(None)

    async def run(self, *arguments):
        """Call back and return the result, while the executor looks after other things."""
        executor = self._node.executor
        result = Future(executor=executor)
        result.add_done_callback(lambda _: executor.wake())  # it may be asleep
        self._calls.put((arguments, result))
        return await result


def work(callback, calls) -> None:
    """Make the calls of a queue until it holds None."""
    for arguments, result in iter(calls.get, None):
        try:
            result.set_result(callback(*arguments))
        except Exception as error:
            result.set_exception(error)
