# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of the node contact_evaluate: it starts, runs its logic and stops."""

import time
import unittest
from unittest.mock import patch

from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_ros import ContactEvaluateNode
import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.lifecycle import TransitionCallbackReturn

TIMEOUT = 10.0 + 2.0 / 1000  # seconds


class TestContactEvaluateNode(unittest.TestCase):
    """The running node, without its peers."""

    def test_life_cycle(self):
        """Every transition succeeds, and the active node calls update."""
        context = rclpy.Context()
        rclpy.init(context=context)
        node = ContactEvaluateNode(context=context)
        executor = MultiThreadedExecutor(context=context)
        executor.add_node(node)
        with patch.object(ContactEvaluateImpl, 'update') as update:
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
