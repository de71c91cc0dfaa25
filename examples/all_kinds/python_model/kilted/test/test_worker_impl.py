# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the logic of worker, without a ROS graph."""

import unittest

from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    WorkerConfig,
    WorkerPassthrough,
)
from support.harness import fake, run_cycle


class TestWorkerImpl(unittest.TestCase):
    """The logic alone, with fakes of harness.py that record what it does."""

    def setUp(self):
        """Create the logic and make it ready to work."""
        self.ros = fake(WorkerPassthrough)
        self.impl = WorkerImpl(self.ros)
        self.assertTrue(self.impl.configure(WorkerConfig()))
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
