# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the logic of observer, without a ROS graph."""

import unittest
from unittest.mock import MagicMock

from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverData,
)


class TestObserverImpl(unittest.TestCase):
    """The logic alone; the passthrough is a mock."""

    def setUp(self):
        """Create the logic with its configuration and data."""
        self.passthrough = MagicMock()
        self.config = ObserverConfig()
        self.data = ObserverData()
        self.impl = ObserverImpl(self.passthrough)

    def test_configure(self):
        """The logic accepts the default parameters."""
        self.assertTrue(self.impl.configure(self.config))

    def test_update(self):
        """A cycle without any received message succeeds."""
        self.impl.configure(self.config)
        self.impl.update(self.data, self.config)
        self.impl.cleanup()
