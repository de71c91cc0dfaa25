# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of clerk: what its spec says, tried from outside."""

import os
import signal
import sys
from time import sleep
import unittest

from peer import Peer
from running import eventually, RunningNode
from serving.clerk_interface import ClerkConfig
import std_srvs.srv
import test_msgs.action

NAME = '/clerk'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'recorder.py'),
    'clerk',
    'ClerkImpl',
    '--ros-args',
]
LOGIC = [
    sys.executable,
    '-c',
    'from sys import exit; from serving.clerk_ros import main; exit(main())',
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

    def test_services(self):
        """Every service has its name and type, and answers."""
        self.assertTrue(
            self.peer.has(
                'service server',
                '/greet',
                'std_srvs/srv/Trigger',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                std_srvs.srv.Trigger,
                '/greet',
            )
        )
        self.assertTrue(self.node.is_called('serve_greet'))
        self.assertTrue(
            self.peer.has(
                'service server',
                '/clerk/open',
                'std_srvs/srv/SetBool',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                std_srvs.srv.SetBool,
                '/clerk/open',
            )
        )
        self.assertTrue(self.node.is_called('serve_open'))

    def test_actions(self):
        """Every action has its name and type, and executes a goal."""
        self.assertTrue(
            self.peer.has(
                'action server',
                '/count',
                'test_msgs/action/Fibonacci',
            )
        )
        self.assertTrue(
            self.peer.execute(
                test_msgs.action.Fibonacci,
                '/count',
            )
        )
        self.assertTrue(self.node.is_called('execute_count'))

    def test_parameters(self):
        """Parameters have their values, are refused where they must be, and reach update."""
        for name, value in vars(ClerkConfig()).items():
            is_list = isinstance(value, tuple)
            self.assertEqual(self.peer.parameter(name), list(value) if is_list else value, name)
        self.refuses('greeting', str())
        self.refuses('patience', float())

    def refuses(self, name, value):
        """Check that a parameter cannot be set now, or not to that value."""
        before = self.peer.parameter(name)
        self.assertFalse(self.peer.set_parameter(name, value), name)
        self.assertEqual(self.peer.parameter(name), before)


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
        self.assertTrue(peer.set_parameter('greeting', str()))
        self.assertTrue(peer.set_parameter('patience', float()))
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
