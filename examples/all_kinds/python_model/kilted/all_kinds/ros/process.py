# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The process of a node: from its start to its exit code."""

from __future__ import annotations

from queue import Empty, SimpleQueue
import signal
from threading import Event, Thread
from time import sleep
from typing import Any, Callable, Optional

from all_kinds.ros.callbacks import NoResponse
from all_kinds.ros.managed_node import ManagedNode
from all_kinds.ros.worker import show_name
import rclpy
from rclpy.exceptions import InvalidHandle
from rclpy.executors import Executor, ExternalShutdownException, SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions

LAST_WORDS = 0.2  # seconds for the last responses and results to leave
SIGNALS = 0.5  # seconds between two looks for signals


def run(node_type: Callable[[], ManagedNode], args: Optional[list[str]] = None) -> int:
    """
    Run a node until SIGINT, SIGTERM or its failure; return the exit code.

    The node stops while communication works. A second signal ends the process at once.
    """
    ends: SimpleQueue[Any] = SimpleQueue()

    def end(number: int, _frame: Any) -> None:
        for each in signal.SIGINT, signal.SIGTERM:
            signal.signal(each, signal.SIG_DFL)
        ends.put(number)

    signal.signal(signal.SIGINT, end)
    signal.signal(signal.SIGTERM, end)
    rclpy.init(args=args, signal_handler_options=SignalHandlerOptions.NO)
    rclpy.get_default_context().on_shutdown(lambda: ends.put('shutdown'))
    node = node_type()
    node.on_failure = lambda: ends.put('failure')
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    done = Event()
    spinning = Thread(target=spin, args=(executor, node, done), name='spin', daemon=True)
    spinning.start()
    if ends.empty():  # nobody has told the node to stop while it was created
        node.start()
    wait_for(ends)
    has_returned = node.end()
    sleep(LAST_WORDS)
    executor.create_task(done.set)  # being woken alone does not end spin_once
    spinning.join()
    executor.shutdown()
    node.destroy_node()
    rclpy.try_shutdown()
    return 0 if has_returned and not node.failed else 1


def wait_for(ends: SimpleQueue[Any]) -> None:
    """Wait for an end; a signal that another thread has taken does not wake this one."""
    while True:
        try:
            ends.get(timeout=SIGNALS)
            return
        except Empty:
            pass


def spin(executor: Executor, node: ManagedNode, done: Event) -> None:
    """Execute callbacks until done."""
    show_name('spin')
    while not done.is_set():
        try:
            executor.spin_once()
        except ExternalShutdownException:
            return
        except (InvalidHandle, NoResponse):
            pass  # of a connection that was just destroyed; of a callback that failed
        except Exception as error:
            node.fail(error)
