# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of clerk: what its spec says, tried from outside."""

import os
import signal
import sys
import unittest

from peer import Peer
import rospy
from running import eventually, RunningNode
from serving.clerk_interface import ClerkConfig
import std_srvs.srv
import test_msgs.msg

NAME = '/clerk'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'recorder.py'),
    'clerk',
    'ClerkImpl',
]
LOGIC = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), '..', 'scripts', 'clerk'),
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
                'std_srvs/Trigger',
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
                'std_srvs/SetBool',
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
                'test_msgs/Fibonacci',
            )
        )
        self.assertTrue(
            self.peer.execute(
                test_msgs.msg.FibonacciAction,
                '/count',
            )
        )
        self.assertTrue(self.node.is_called('execute_count'))

    def test_parameters(self):
        """Parameters have their defaults, stay within their ranges, and reach update."""
        default = ClerkConfig()
        self.assertEqual(self.node.words('configure'), [ascii(default)])


class TestLifeCycle(unittest.TestCase):
    """Nodes that are started and stopped."""

    def start(self, command, parameters=None):
        """Start a node for this test, and a peer."""
        peer = Peer(NAME)
        self.addCleanup(peer.close)
        rospy.set_param(NAME, parameters or {})
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

    def test_given_parameters(self):
        """Parameters reach the logic; one of a wrong type ends the node."""
        given = {
            'greeting': 'other',
            'patience': 0.0,
        }
        node, _ = self.start(RECORDER, given)
        self.assertTrue(node.is_called('configure'))
        config = ClerkConfig(**given)
        self.assertEqual(node.words('configure'), [ascii(config)])
        node.kill()
        wrong = {
            'greeting': 0,
            'patience': 'wrong',
        }
        for name, value in wrong.items():
            node, _ = self.start(RECORDER, {name: value})
            self.assertEqual(node.exit_code(), 1, name)
            self.assertEqual(node.calls(), [])

    def test_rosnode_kill(self):
        """The node ends as well when it is told to by `rosnode kill`."""
        node, peer = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        peer.kill()
        self.assertEqual(node.exit_code(), 0)
        self.assertEqual(node.calls('deactivate', 'cleanup'), ['deactivate', 'cleanup'])

    def test_logic(self):
        """The node runs with its own logic, and ends well at SIGTERM."""
        node, peer = self.start(LOGIC)
        self.assertTrue(eventually(peer.is_connected))
        self.assertEqual(node.stop(signal.SIGTERM), 0)
