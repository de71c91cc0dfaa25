# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the node worker: it starts, runs its logic and stops."""

import time
import unittest
from unittest.mock import patch

from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_ros import WorkerNode
import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.lifecycle import TransitionCallbackReturn

TIMEOUT = 10.0 + 2.0 / 20  # seconds


class TestWorkerNode(unittest.TestCase):
    """The running node, without its peers."""

    def test_life_cycle(self):
        """Every transition succeeds, and the active node calls update."""
        context = rclpy.Context()
        rclpy.init(context=context)
        node = WorkerNode(context=context)
        executor = MultiThreadedExecutor(context=context)
        executor.add_node(node)
        with patch.object(WorkerImpl, 'update') as update:
            self.assertEqual(node.trigger_configure(), TransitionCallbackReturn.SUCCESS)
            self.assertEqual(node.trigger_activate(), TransitionCallbackReturn.SUCCESS)
            end = time.monotonic() + TIMEOUT
            while not update.called and time.monotonic() < end:
                executor.spin_once(timeout_sec=0.1)
        update.assert_called()
        self.assertEqual(node.trigger_deactivate(), TransitionCallbackReturn.SUCCESS)
        self.assertEqual(node.trigger_cleanup(), TransitionCallbackReturn.SUCCESS)
        executor.shutdown()
        node.destroy_node()
        rclpy.shutdown(context=context)
