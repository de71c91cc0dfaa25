# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the node clerk: it starts, serves and stops."""

import unittest

import rclpy
from rclpy.lifecycle import TransitionCallbackReturn
from serving.clerk_ros import ClerkNode


class TestClerkNode(unittest.TestCase):
    """The running node, without its peers."""

    def test_life_cycle(self):
        """Every transition succeeds."""
        context = rclpy.Context()
        rclpy.init(context=context)
        node = ClerkNode(context=context)
        self.assertEqual(node.trigger_configure(), TransitionCallbackReturn.SUCCESS)
        self.assertEqual(node.trigger_activate(), TransitionCallbackReturn.SUCCESS)
        self.assertEqual(node.trigger_deactivate(), TransitionCallbackReturn.SUCCESS)
        self.assertEqual(node.trigger_cleanup(), TransitionCallbackReturn.SUCCESS)
        node.destroy_node()
        rclpy.shutdown(context=context)
