#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of observer from outside: its interfaces and its lifecycle."""

import signal
from time import sleep
import unittest

from roslib.packages import find_node
import rospy
import rostest
import std_msgs.msg
from support.peer import Peer
from support.running import eventually, RunningNode

NAME = '/observer'
RECORDER = find_node('all_kinds', 'test_observer_recorder')
LOGIC = find_node('all_kinds', 'observer')
LIFE = ['configure', 'activate', 'update', 'deactivate', 'cleanup']
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
            'in_status',
            once=True,
        )

    def receives(self, message, topic, call, once):
        """Check that a message makes a call; with `once`, that none makes a second one."""
        sent = self.peer.publish(message, topic, lambda: self.node.is_called(call, timeout=0.1))
        self.assertTrue(self.node.is_called(call), topic)
        sleep(3 * PERIOD)
        if once:
            self.assertLessEqual(len(self.node.calls(call)), sent, topic)


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

    def test_every_step(self):
        """The logic goes through its life in order, and is heard to the end."""
        node, _ = self.start(RECORDER)
        self.assertTrue(node.is_called('update'))
        sleep(1.0 + 2.5 * PERIOD)
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*LIFE), LIFE)
        rate = float(node.words('rate')[0])
        self.assertGreater(rate, 0.2 / PERIOD)
        self.assertLess(rate, 1.5 / PERIOD)

    def test_given_parameters(self):
        """Every parameter reaches the logic; one of a wrong type ends the node."""
        given = {
            'limit': 0,
        }
        node, _ = self.start(RECORDER, given)
        for name in given:
            self.assertTrue(node.is_called('config.' + name), name)
        self.assertEqual(node.stop(), 0)
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


if __name__ == '__main__':
    rostest.rosrun(
        'all_kinds',
        'test_observer_node',
        'test_observer_node',
    )
