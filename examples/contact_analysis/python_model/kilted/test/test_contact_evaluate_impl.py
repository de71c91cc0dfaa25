# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of the logic of contact_evaluate, without a ROS graph."""

import unittest

from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluatePassthrough,
)
from harness import fake, run_cycle


class TestContactEvaluateImpl(unittest.TestCase):
    """The logic alone, with fakes of harness.py that record what it does."""

    def setUp(self):
        """Create the logic and make it ready to work."""
        self.ros = fake(ContactEvaluatePassthrough)
        self.impl = ContactEvaluateImpl(self.ros)
        self.assertTrue(self.impl.configure(ContactEvaluateConfig()))
        self.assertTrue(self.impl.activate())

    def tearDown(self):
        """End the logic as the node does."""
        self.impl.deactivate()
        self.impl.cleanup()

    def test_update(self):
        """A cycle works; with messages it is run_cycle(self.impl, in_name=message).out_name."""
        data = run_cycle(self.impl)
        run_cycle(self.impl, data)

    def test_misspelt_name(self):
        """The harness refuses a message that the node does not receive."""
        with self.assertRaises(TypeError):
            run_cycle(self.impl, in_misspelt_name=None)
