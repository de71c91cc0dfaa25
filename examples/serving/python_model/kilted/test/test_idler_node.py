# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of idler: what its spec says, tried from outside."""

import os
import signal
import sys
from time import sleep
import unittest

from peer import Peer
from running import eventually, RunningNode

NAME = '/idler'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'recorder.py'),
    'idler',
    'IdlerImpl',
    '--ros-args',
]
LOGIC = [
    sys.executable,
    '-c',
    'from sys import exit; from serving.idler_ros import main; exit(main())',
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
    """Nodes that are started, managed and stopped."""

    def start(self, command):
        """Start a node for this test, and a peer."""
        peer = Peer(NAME)
        self.addCleanup(peer.close)
        node = RunningNode(command)
        self.addCleanup(node.kill)
        return node, peer

    def test_every_edge(self):
        """The node activates itself, obeys every transition, and ends well at SIGINT."""
        node, peer = self.start(RECORDER)
        calls = LIFE[:2]
        self.assertTrue(node.is_called('activate'))
        self.assertTrue(eventually(lambda: peer.state() == 'active'))
        for transition, state, *called in (
            ('deactivate', 'inactive', 'deactivate'),
            ('activate', 'active', 'activate'),
            ('deactivate', 'inactive', 'deactivate'),
            ('cleanup', 'unconfigured', 'cleanup'),
            ('configure', 'inactive', 'configure'),
            ('cleanup', 'unconfigured', 'cleanup'),
            ('configure', 'inactive', 'configure'),
            ('activate', 'active', 'activate'),
        ):
            self.assertTrue(peer.change(transition), transition)
            self.assertEqual(peer.state(), state)
            calls += called
            self.assertEqual(node.calls(*calls), calls)
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*calls), [*calls, 'deactivate', 'cleanup'])

    def test_managed(self):
        """Without autostart the node waits to be managed, and shuts down from any state."""
        node, peer = self.start([*RECORDER, '-p', 'autostart:=false'])
        self.assertTrue(eventually(lambda: peer.state() == 'unconfigured'))
        sleep(1.0)
        self.assertEqual(node.calls(), [])
        self.assertTrue(peer.change('configure'))
        self.assertTrue(peer.change('activate'))
        self.assertTrue(peer.change('shutdown'))
        self.assertTrue(node.is_called('cleanup'))
        self.assertEqual(node.calls(*LIFE), LIFE)
        self.assertEqual(peer.state(), 'finalized')

    def test_logic(self):
        """The node runs with its own logic, and ends well at SIGTERM."""
        node, peer = self.start(LOGIC)
        self.assertTrue(eventually(lambda: peer.state() == 'active'))
        self.assertEqual(node.stop(signal.SIGTERM), 0)
