# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of the logic of contact_evaluate, without a ROS graph."""

import unittest
from unittest.mock import MagicMock

from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
)


class TestContactEvaluateImpl(unittest.TestCase):
    """The logic alone; the passthrough is a mock."""

    def setUp(self):
        """Create the logic with its configuration and data."""
        self.passthrough = MagicMock()
        self.config = ContactEvaluateConfig()
        self.data = ContactEvaluateData()
        self.impl = ContactEvaluateImpl(self.passthrough)

    def test_configure(self):
        """The logic accepts the default parameters."""
        self.assertTrue(self.impl.configure(self.config))

    def test_update(self):
        """A cycle without any received message succeeds."""
        self.impl.configure(self.config)
        self.impl.update(self.data, self.config)
        self.impl.cleanup()
