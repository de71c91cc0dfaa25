# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The process of a node: from its start to its exit code."""

from __future__ import annotations

from queue import Empty, SimpleQueue
import signal
from threading import Event, Thread
import traceback
from typing import Any, Callable, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.callbacks import NoResponse
from all_kinds.ros.managed_node import ManagedNode
from all_kinds.ros.worker import show_name
import rclpy
from rclpy.exceptions import InvalidHandle, ParameterException
from rclpy.executors import Executor, ExternalShutdownException, SingleThreadedExecutor
from rclpy.logging import get_logger
from rclpy.signals import SignalHandlerOptions


def run(node_type: Callable[[], ManagedNode], args: Optional[list[str]] = None) -> int:
    """
    Run a node until SIGINT, SIGTERM or its failure; return the exit code.

    The node deactivates and cleans up before ROS shuts down; a second signal ends it at once.
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
    try:
        node = node_type()
    except ParameterException as error:
        get_logger(node_type.__name__).fatal(str(error))
        return 1
    node.on_failure = lambda: ends.put('failure')
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    done = Event()
    spinning = Thread(target=spin, args=(executor, node, done), name='spin', daemon=True)
    spinning.start()
    if ends.empty():  # no signal has come yet
        node.start()
    wait_for(ends)
    has_returned = node.end()
    executor.create_task(done.set)  # spin_once() returns only after it has executed something
    spinning.join()
    executor.shutdown()
    node.destroy_node()
    rclpy.try_shutdown()
    return 0 if has_returned and not node.failed else 1


def wait_for(ends: SimpleQueue[Any]) -> None:
    """Wait for a reason to end; wake up regularly to let Python run signal handlers."""
    while True:
        try:
            ends.get(timeout=timeouts.SIGNAL_CHECK_PERIOD)
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
            pass  # InvalidHandle: destroyed meanwhile; NoResponse: in the log already
        except Exception:  # of rclpy, as the logic runs in other threads
            node.get_logger().error(traceback.format_exc())
