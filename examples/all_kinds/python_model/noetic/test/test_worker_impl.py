# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the logic of worker, without ROS's graph."""

import unittest
from unittest.mock import MagicMock

from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    WorkerConfig,
    WorkerData,
)


class TestWorkerImpl(unittest.TestCase):
    """The logic by itself; the rest of ROS is played by a mock."""

    def setUp(self):
        """Make the logic and what it works on."""
        self.passthrough = MagicMock()
        self.config = WorkerConfig()
        self.data = WorkerData()
        self.impl = WorkerImpl(self.passthrough)

    def test_configure(self):
        """The logic accepts its default parameters."""
        self.assertTrue(self.impl.configure(self.config))

    def test_update(self):
        """A cycle without any message received works."""
        self.impl.configure(self.config)
        self.impl.update(self.data, self.config)
        self.impl.cleanup()
