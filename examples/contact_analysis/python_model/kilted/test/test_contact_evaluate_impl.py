# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of the logic of contact_evaluate, without ROS's graph."""

import unittest
from unittest.mock import MagicMock

from contact_analysis.contact_evaluate_impl import ContactEvaluateImpl
from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
)


class TestContactEvaluateImpl(unittest.TestCase):
    """The logic by itself; the rest of ROS is played by a mock."""

    def setUp(self):
        """Make the logic and what it works on."""
        self.passthrough = MagicMock()
        self.config = ContactEvaluateConfig()
        self.data = ContactEvaluateData()
        self.impl = ContactEvaluateImpl(self.passthrough)

    def test_configure(self):
        """The logic accepts its default parameters."""
        self.assertTrue(self.impl.configure(self.config))

    def test_update(self):
        """A cycle without any message received works."""
        self.impl.configure(self.config)
        self.impl.update(self.data, self.config)
        self.impl.cleanup()
