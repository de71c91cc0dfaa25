#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of idler: what its spec says, tried from outside."""

import os
import signal
from time import sleep
import unittest

from peer import Peer
from running import eventually, RunningNode

NAME = '/idler'
if 'RECORDER' not in os.environ:
    raise unittest.SkipTest('ctest runs this, as CMakeLists.txt says')
RECORDER = [os.environ['RECORDER'], '--ros-args']
LOGIC = [os.environ['NODE']]
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
        """The node activates itself, obeys every transition, and is heard to its end at SIGINT."""
        node, peer = self.start(RECORDER)
        calls = LIFE[:2]
        self.assertTrue(node.is_called(calls[-1]))
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
            self.assertTrue(node.is_called(calls[-1], calls.count(calls[-1])))
            self.assertEqual(node.calls(*LIFE), calls)
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*LIFE), [*calls, 'deactivate', 'cleanup'])

    def test_managed(self):
        """Without autostart the node waits to be managed, and shuts down from any state."""
        node, peer = self.start([*RECORDER, '-p', 'autostart:=false'])
        self.assertTrue(eventually(lambda: peer.state() == 'unconfigured'))
        sleep(1.0)
        self.assertEqual(node.calls(), [])
        for transition in ('configure', 'activate', 'shutdown'):
            self.assertTrue(peer.change(transition))
        self.assertTrue(node.is_called('cleanup'))
        calls = ['configure', 'activate', 'deactivate', 'cleanup']
        self.assertEqual(node.calls(*calls), calls)
        self.assertEqual(peer.state(), 'finalized')

    def test_logic(self):
        """The node runs with its own logic, and ends well at SIGTERM."""
        node, peer = self.start(LOGIC)
        self.assertTrue(eventually(lambda: peer.state() == 'active'))
        self.assertEqual(node.stop(signal.SIGTERM), 0)


if __name__ == '__main__':
    unittest.main()
