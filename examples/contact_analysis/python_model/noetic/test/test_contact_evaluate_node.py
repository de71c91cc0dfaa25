#!/usr/bin/env python3
# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of the node contact_evaluate, which nodes.test starts, and of its logic."""

import time
import unittest

import rosnode
import rostest
from test_contact_evaluate_impl import TestContactEvaluateImpl  # noqa: F401 (rostest runs it too)

NODE = '/contact_evaluate'
TIMEOUT = 10.0  # seconds


class TestContactEvaluateNode(unittest.TestCase):
    """The running node, without its peers."""

    def test_starts(self):
        """The node responds."""
        end = time.monotonic() + TIMEOUT
        while not self.is_alive() and time.monotonic() < end:
            time.sleep(0.1)
        self.assertTrue(self.is_alive())

    @staticmethod
    def is_alive():
        """Return whether the node responds."""
        return NODE in rosnode.get_node_names() and rosnode.rosnode_ping(NODE, max_count=1)


if __name__ == '__main__':
    rostest.rosrun(
        'contact_analysis',
        'contact_evaluate',
        'test_contact_evaluate_node',
    )
