#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the node clerk, which nodes.test starts, and of its logic."""

import time
import unittest

import rosnode
import rostest
from test_clerk_impl import TestClerkImpl  # noqa: F401 (rostest runs it too)

NODE = '/clerk'
TIMEOUT = 10.0  # seconds


class TestClerkNode(unittest.TestCase):
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
        'serving',
        'clerk',
        'test_clerk_node',
    )
