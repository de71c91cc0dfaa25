# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the logic of clerk, without a ROS graph."""

import unittest
from unittest.mock import MagicMock

from serving.clerk_impl import ClerkImpl
from serving.clerk_interface import ClerkConfig


class TestClerkImpl(unittest.TestCase):
    """The logic alone; the passthrough is a mock."""

    def setUp(self):
        """Create the logic with its configuration."""
        self.passthrough = MagicMock()
        self.config = ClerkConfig()
        self.impl = ClerkImpl(self.passthrough)

    def test_configure(self):
        """The logic accepts the default parameters."""
        self.assertTrue(self.impl.configure(self.config))

    def test_cleanup(self):
        """The logic cleans up after itself."""
        self.impl.configure(self.config)
        self.impl.cleanup()
