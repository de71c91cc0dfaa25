# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Awaiting calls in other threads."""

from __future__ import annotations

from concurrent.futures import Future
from typing import Any

from rclpy.executors import Executor
from rclpy.node import Node
import rclpy.task


def executor_of(node: Node) -> Executor:
    """Return the executor that the node was added to."""
    assert node.executor is not None
    return node.executor


async def first(node: Node, calls: list[Future[Any]]) -> None:
    """Await the first of some calls in other threads."""
    executor = executor_of(node)
    completed: rclpy.task.Future[None] = rclpy.task.Future(executor=executor)

    def complete(_: Future[Any]) -> None:
        completed.set_result(None)
        executor.wake()  # a future of rclpy 9.1.2 does not wake it

    for call in calls:
        call.add_done_callback(complete)
    await completed
