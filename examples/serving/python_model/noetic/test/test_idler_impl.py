# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the logic of idler, without a ROS graph."""

import unittest

from harness import fake
from serving.idler_impl import IdlerImpl
from serving.idler_interface import (
    IdlerConfig,
    IdlerPassthrough,
)


class TestIdlerImpl(unittest.TestCase):
    """The logic alone, with fakes of harness.py that record what it does."""

    def setUp(self):
        """Create the logic and make it ready to work."""
        self.ros = fake(IdlerPassthrough)
        self.impl = IdlerImpl(self.ros)
        self.assertTrue(self.impl.configure(IdlerConfig()))
        self.assertTrue(self.impl.activate())

    def tearDown(self):
        """End the logic as the node does."""
        self.impl.deactivate()
        self.impl.cleanup()

    def test_without_errors(self):
        """The logic starts and ends without an error in the log."""
        self.assertNotIn('error', [level for level, _ in self.ros.log.lines])
