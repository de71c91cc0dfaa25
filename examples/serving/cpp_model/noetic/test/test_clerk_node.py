#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of clerk: what its spec says, tried from outside."""

import signal
import unittest

from peer import Peer
from roslib.packages import find_node
import rospy
import rostest
from running import eventually, RunningNode
import std_srvs.srv
import test_msgs.msg

NAME = '/clerk'
RECORDER = find_node('serving', 'test_clerk_recorder')
LOGIC = find_node('serving', 'clerk')
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

    def test_every_step(self):
        """The logic goes through its life in order, and is heard to the end."""
        node, _ = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*LIFE), LIFE)

    def test_given_parameters(self):
        """Every parameter reaches the logic; one of a wrong type ends the node."""
        given = {
            'greeting': 'other',
            'patience': 0.0,
        }
        node, _ = self.start(RECORDER, given)
        for name in given:
            self.assertTrue(node.is_called('config.' + name), name)
        self.assertEqual(node.stop(), 0)
        node, _ = self.start(RECORDER, {'greeting': {'of': 'another type'}})
        self.assertEqual(node.exit_code(), 1)
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


if __name__ == '__main__':
    rostest.rosrun(
        'serving',
        'test_clerk_node',
        'test_clerk_node',
    )
