#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of controller: what its spec says, tried from outside."""

import signal
from time import sleep
import unittest

from peer import Peer
from roslib.packages import find_node
import rospy
import rostest
from running import eventually, RunningNode
import std_msgs.msg
import std_srvs.srv

NAME = '/controller'
RECORDER = find_node('driving', 'test_controller_recorder')
LOGIC = find_node('driving', 'controller')
LIFE = ['configure', 'activate', 'update', 'deactivate', 'cleanup']
PERIOD = 1.0 / 100  # seconds


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

    def publishes(self, topic, *expected):
        """Check that the node publishes to a topic, with type and latching."""
        self.assertEqual(set(expected) - set(self.peer.publisher(topic)), set(), topic)

    def subscribes(self, topic, *expected):
        """Check that the node subscribes to a topic, with type."""
        self.assertEqual(set(expected) - set(self.peer.subscription(topic)), set(), topic)

    def test_topics(self):
        """Every topic has its name, type and latching."""
        self.publishes(
            '/speed',
            'std_msgs/Float64',
            'not latched',
        )
        self.subscribes(
            '/target_speed',
            'std_msgs/Float64',
        )

    def test_messages_in(self):
        """A message reaches the logic, and is new once."""
        self.receives(
            std_msgs.msg.Float64(),
            '/target_speed',
            'in_target_speed',
            once=True,
        )

    def receives(self, message, topic, call, once):
        """Check that each message published makes one call, unless others publish as well."""
        sent = self.peer.publish(message, topic, lambda: self.node.is_called(call, timeout=0.1))
        self.assertTrue(self.node.is_called(call), topic)
        sleep(3 * PERIOD)
        if once:
            self.assertLessEqual(len(self.node.calls(call)), sent, topic)

    def test_messages_out(self):
        """Every output leaves."""
        self.sends(
            std_msgs.msg.Float64,
            '/speed',
        )

    def sends(self, message_type, topic):
        """Check that the node publishes to a topic again and again."""
        messages = self.peer.subscribe(message_type, topic)
        self.assertTrue(eventually(lambda: len(messages) > 1), topic)

    def test_services(self):
        """Every service has its name and type, and answers."""
        self.assertTrue(
            self.peer.has(
                'service server',
                '/stop',
                'std_srvs/Trigger',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                std_srvs.srv.Trigger,
                '/stop',
            )
        )
        self.assertTrue(self.node.is_called('serve_stop'))


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
            'speed_limit': 0.0,
        }
        node, _ = self.start(RECORDER, given)
        for name in given:
            self.assertTrue(node.is_called('config.' + name), name)
        self.assertEqual(node.stop(), 0)
        node, _ = self.start(RECORDER, {'speed_limit': {'of': 'another type'}})
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
        'driving',
        'test_controller_node',
        'test_controller_node',
    )
