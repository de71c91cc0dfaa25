# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the logic of observer, without a ROS graph."""

import unittest

from all_kinds.observer_impl import ObserverImpl
from all_kinds.observer_interface import (
    ObserverConfig,
    ObserverPassthrough,
)
from support.harness import fake, run_cycle


class TestObserverImpl(unittest.TestCase):
    """The logic alone, with fakes of harness.py that record what it does."""

    def setUp(self):
        """Create the logic and make it ready to work."""
        self.ros = fake(ObserverPassthrough)
        self.impl = ObserverImpl(self.ros)
        self.assertTrue(self.impl.configure(ObserverConfig()))
        self.assertTrue(self.impl.activate())

    def tearDown(self):
        """End the logic as the node does."""
        self.impl.deactivate()
        self.impl.cleanup()

    def test_update(self):
        """A cycle runs; run_cycle(self.impl, in_NAME=message) returns data with data.out_NAME."""
        data = run_cycle(self.impl)
        run_cycle(self.impl, data)

    def test_misspelt_name(self):
        """The harness refuses a message that the node does not receive."""
        with self.assertRaises(TypeError):
            run_cycle(self.impl, in_misspelt_name=None)
