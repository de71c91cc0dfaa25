# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The process of a node: from its start to its exit code."""

from __future__ import annotations

import logging
import os
from queue import Empty, SimpleQueue
import signal
import sys
from threading import Event, Thread
from time import sleep
from typing import Any, Callable

from all_kinds.ros import timeouts
from all_kinds.ros.managed_node import ManagedNode
from all_kinds.ros.worker import Worker
import rospy


def run(name: str, node_type: Callable[[], ManagedNode]) -> int:
    """
    Run a node until SIGINT, SIGTERM, `rosnode kill` or its failure; return the exit code.

    The node deactivates and cleans up before ROS shuts down; a second signal ends it at once.
    """
    ends: SimpleQueue[Any] = SimpleQueue()
    is_up = Event()
    ended = Event()
    unregistered = Event()

    def end(number: int, _frame: Any) -> None:
        for each in signal.SIGINT, signal.SIGTERM:
            signal.signal(each, signal.SIG_DFL)
        ends.put(number)

    def end_before_shutdown() -> None:
        ends.put('shutdown')
        if is_up.is_set():  # rospy 1.15.15 now holds a lock that init_node() needs
            ended.wait()

    signal.signal(signal.SIGINT, signal.SIG_DFL)  # init_node() may wait for the master
    rospy.on_shutdown(end_before_shutdown)
    rospy.init_node(name, disable_signals=True)
    signal.signal(signal.SIGINT, end)
    signal.signal(signal.SIGTERM, end)
    rospy.core.add_shutdown_hook(lambda _: unregistered.set())
    is_up.set()
    try:
        ended_well = not ends.empty() or live(node_type, ends)
    finally:
        ended.set()
    exit_code = 0 if ended_well else 1
    shutdown = Thread(target=rospy.signal_shutdown, args=['the node has ended'], daemon=True)
    shutdown.start()
    shutdown.join(timeouts.UNREGISTER_TIMEOUT)
    if shutdown.is_alive() or not unregistered.wait(timeouts.UNREGISTER_TIMEOUT):
        # The master does not answer: Python would wait for non-daemon threads of rospy 1.15.15.
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(exit_code)
    return exit_code


def live(node_type: Callable[[], ManagedNode], ends: SimpleQueue[Any]) -> bool:
    """Run the node until there is a reason to end; return whether it ended well."""
    creator = Worker('creator')  # it may wait for a master that does not answer
    creation = creator.submit(create, node_type)
    creation.add_done_callback(ends.put)
    creator.close()
    if wait_for(ends) is not creation:
        return True
    try:
        node: ManagedNode = creation.result()
    except rospy.ROSInitException as error:
        rospy.logfatal('%s', error)
        return False
    node.on_failure = lambda: ends.put('failure')
    node.start()
    wait_for(ends)
    has_returned = node.end()
    sleep(timeouts.SHUTDOWN_DELAY)
    return has_returned and not node.failed


def create(node_type: Callable[[], ManagedNode]) -> ManagedNode:
    """Create the node and set the level of its log, as the parameters say."""
    level = rospy.get_param('~log_level', 'info')
    if level in ('debug', 'info', 'warn', 'error', 'fatal'):
        logging.getLogger('rosout').setLevel(level.upper())
    else:
        rospy.logwarn('log_level must be debug, info, warn, error or fatal.')
    return node_type()


def wait_for(ends: SimpleQueue[Any]) -> Any:
    """Return the next reason to end; wake up regularly to let Python run signal handlers."""
    while True:
        try:
            return ends.get(timeout=timeouts.SIGNAL_CHECK_PERIOD)
        except Empty:
            pass
