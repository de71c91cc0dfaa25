# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of idler: what its spec says, tried from outside."""

import os
import signal
import sys
from time import sleep
import unittest

from peer import Peer
from running import RunningNode

NAME = '/idler'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'recorder.py'),
    'idler',
    'IdlerImpl',
]
LOGIC = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), '..', 'scripts', 'idler'),
]
LIFE = ['configure', 'activate', 'deactivate', 'cleanup']


class TestInterfaces(unittest.TestCase):
    """The active node, with a logic that records its calls."""

    @classmethod
    def setUpClass(cls):
        """Start the node."""
        cls.peer = Peer(NAME)
        cls.addClassCleanup(cls.peer.close)
        cls.node = RunningNode(RECORDER)
        cls.addClassCleanup(cls.node.kill)
        assert cls.node.is_called('activate')

    @classmethod
    def tearDownClass(cls):
        """Stop the node, which still runs."""
        assert cls.node.stop() == 0


class TestLifeCycle(unittest.TestCase):
    """Nodes that are started and stopped."""

    def start(self, command):
        """Start a node for this test, and a peer."""
        peer = Peer(NAME)
        self.addCleanup(peer.close)
        node = RunningNode(command)
        self.addCleanup(node.kill)
        return node, peer

    def test_every_edge(self):
        """The node activates itself and ends well at SIGINT."""
        node, _ = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        self.assertEqual(node.calls(*LIFE), LIFE[:2])
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*LIFE), LIFE)

    def test_rosnode_kill(self):
        """The node ends as well when it is told to by `rosnode kill`."""
        node, peer = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        peer.kill()
        self.assertEqual(node.exit_code(), 0)
        self.assertEqual(node.calls('deactivate', 'cleanup'), ['deactivate', 'cleanup'])

    def test_logic(self):
        """The node runs with its own logic, and ends well at SIGTERM."""
        node, _ = self.start(LOGIC)
        sleep(3.0)
        self.assertEqual(node.stop(signal.SIGTERM), 0)
