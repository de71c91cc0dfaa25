# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of observer from outside: its interfaces and its lifecycle."""

import os
import signal
import sys
from time import sleep
import unittest

from all_kinds.observer_interface import ObserverConfig
import rospy
import std_msgs.msg
from support.peer import Peer
from support.running import eventually, RunningNode

NAME = '/observer'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'support', 'recorder.py'),
    'observer',
    'ObserverImpl',
]
LOGIC = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), '..', 'scripts', 'observer'),
]
LIFE = ['configure', 'activate', 'deactivate', 'cleanup']
PERIOD = 1.0 / 12.5  # seconds


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
        """Stop the node, which must still run."""
        assert cls.node.stop() == 0

    def subscribes(self, topic, *expected):
        """Check that the node subscribes to a topic, with type."""
        self.assertEqual(set(expected) - set(self.peer.subscription(topic)), set(), topic)

    def test_topics(self):
        """Every topic has its name, type and latching."""
        self.subscribes(
            '/status',
            'std_msgs/String',
        )

    def test_messages_in(self):
        """Every message reaches the logic, and is new only once."""
        self.receives(
            std_msgs.msg.String(),
            '/status',
            'in_status_updated',
            once=True,
        )

    def receives(self, message, topic, call, once):
        """Check that a message makes a call; with `once`, that none makes a second one."""
        sent = self.peer.publish(message, topic, lambda: self.node.is_called(call, timeout=0.1))
        self.assertTrue(self.node.is_called(call), topic)
        sleep(3 * PERIOD)
        if once:
            self.assertLessEqual(len(self.node.calls(call)), sent, topic)

    def test_parameters(self):
        """Parameters have their defaults, stay within their ranges, and reach update."""
        default = ObserverConfig()
        self.assertEqual(self.node.words('configure'), [ascii(default)])


class TestLifeCycle(unittest.TestCase):
    """Nodes that are started and stopped."""

    def start(self, command, parameters=None):
        """Start a node for this test, and a peer."""
        peer = Peer(NAME)
        self.addCleanup(peer.close)
        for name, value in (parameters or {}).items():
            rospy.set_param(NAME + '/' + name, value)
        node = RunningNode(command)
        self.addCleanup(node.kill)
        return node, peer

    def test_every_edge(self):
        """The node activates itself, works at its frequency, and ends with code 0 at SIGINT."""
        node, _ = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        sleep(1.0 + 5 * PERIOD)
        self.assertEqual(node.calls(*LIFE), LIFE[:2])
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*LIFE), LIFE)
        rate = float(node.words('rate')[0])
        self.assertGreater(rate, 0.2 / PERIOD)
        self.assertLess(rate, 1.5 / PERIOD)

    def test_given_parameters(self):
        """Parameters reach the logic; one of a wrong type ends the node."""
        given = {
            'limit': 0,
        }
        node, _ = self.start(RECORDER, given)
        self.assertTrue(node.is_called('configure'))
        config = ObserverConfig(**given)
        self.assertEqual(node.words('configure'), [ascii(config)])
        node.kill()
        refused = [
            ('limit', True),
        ]
        for name, value in refused:
            node, _ = self.start(RECORDER, {name: value})
            self.assertEqual(node.exit_code(), 1, (name, value))
            self.assertEqual(node.calls(), [])

    def test_rosnode_kill(self):
        """The node deactivates, cleans up and ends at `rosnode kill`."""
        node, peer = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        peer.kill()
        self.assertEqual(node.exit_code(), 0)
        self.assertEqual(node.calls('deactivate', 'cleanup'), ['deactivate', 'cleanup'])

    def test_logic(self):
        """The node runs with its own logic, and ends with exit code 0 at SIGTERM."""
        node, peer = self.start(LOGIC)
        self.assertTrue(eventually(peer.is_connected))
        self.assertEqual(node.stop(signal.SIGTERM), 0)
