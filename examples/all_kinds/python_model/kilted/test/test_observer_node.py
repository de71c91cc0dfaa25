# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of observer from outside: its interfaces and its lifecycle."""

import os
import signal
import sys
from time import sleep
import unittest

from all_kinds.observer_interface import ObserverConfig
import std_msgs.msg
from support.peer import Peer
from support.running import eventually, RunningNode

NAME = '/observer'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'support', 'recorder.py'),
    'observer',
    'ObserverImpl',
    '--ros-args',
]
LOGIC = [
    sys.executable,
    '-c',
    'from sys import exit; from all_kinds.observer_ros import main; exit(main())',
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
        """Check that the node subscribes to a topic, with type and QoS."""
        self.assertEqual(set(expected) - set(self.peer.subscription(topic)), set(), topic)

    def test_topics(self):
        """Every topic has its name, type and QoS."""
        self.subscribes(
            '/status',
            'std_msgs/msg/String',
            'reliable',
            'volatile',
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
        """Parameters have their values, are refused where they must be, and reach update."""
        for name, value in vars(ObserverConfig()).items():
            is_list = isinstance(value, tuple)
            self.assertEqual(self.peer.parameter(name), list(value) if is_list else value, name)
        self.refuses('limit', int())

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
        """The node activates itself, obeys every transition, and ends with code 0 at SIGINT."""
        node, peer = self.start(RECORDER)
        calls = LIFE[:2]
        self.assertTrue(node.is_called('activate'))
        self.assertTrue(eventually(lambda: peer.state() == 'active'))
        sleep(1.0 + 5 * PERIOD)
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
        rate = float(node.words('rate')[0])
        self.assertGreater(rate, 0.2 / PERIOD)
        self.assertLess(rate, 1.5 / PERIOD)
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*calls), [*calls, 'deactivate', 'cleanup'])

    def test_managed(self):
        """Without autostart the node waits to be managed, and shuts down from any state."""
        node, peer = self.start([*RECORDER, '-p', 'autostart:=false'])
        self.assertTrue(eventually(lambda: peer.state() == 'unconfigured'))
        sleep(1.0)
        self.assertEqual(node.calls(), [])
        self.assertTrue(peer.set_parameter('limit', int()))
        self.assertTrue(peer.change('configure'))
        self.assertTrue(peer.change('activate'))
        self.assertTrue(peer.change('shutdown'))
        self.assertTrue(node.is_called('cleanup'))
        self.assertEqual(node.calls(*LIFE), LIFE)
        self.assertEqual(peer.state(), 'finalized')

    def test_logic(self):
        """The node runs with its own logic, and ends with exit code 0 at SIGTERM."""
        node, peer = self.start(LOGIC)
        self.assertTrue(eventually(lambda: peer.state() == 'active'))
        self.assertEqual(node.stop(signal.SIGTERM), 0)
