#!/usr/bin/env python3
# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of contact_evaluate: what its spec says, tried from outside."""

import signal
from time import sleep
import unittest

import contact_msgs.msg
import contact_msgs.srv
import geometry_msgs.msg
from peer import Peer
from roslib.packages import find_node
import rospy
import rostest
from running import eventually, RunningNode

NAME = '/contact_evaluate'
RECORDER = find_node('contact_analysis', 'test_contact_evaluate_recorder')
LOGIC = find_node('contact_analysis', 'contact_evaluate')
LIFE = ['configure', 'activate', 'update', 'deactivate', 'cleanup']
PERIOD = 1.0 / 1000  # seconds


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
            '/plot_learn_cop',
            'contact_msgs/PointArray',
            'not latched',
        )
        self.subscribes(
            '/cop',
            'geometry_msgs/Point',
        )

    def test_messages_in(self):
        """A message reaches the logic, and is new once."""
        self.receives(
            geometry_msgs.msg.Point(),
            '/cop',
            'in_cop',
            once=True,
        )

    def receives(self, message, topic, call, once):
        """Check that each message published makes one call, unless others publish as well."""
        sent = self.peer.publish(message, topic, lambda: self.node.is_called(call, timeout=0.1))
        self.assertTrue(self.node.is_called(call), topic)
        sleep(3 * PERIOD)
        if once:
            self.assertLessEqual(len(self.node.calls(call)), sent, topic)

    def test_services(self):
        """Every service has its name and type, and answers."""
        self.assertTrue(
            self.peer.has(
                'service server',
                '/load',
                'contact_msgs/SetString',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                contact_msgs.srv.SetString,
                '/load',
            )
        )
        self.assertTrue(self.node.is_called('serve_load'))
        self.assertTrue(
            self.peer.has(
                'service server',
                '/store',
                'contact_msgs/SetString',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                contact_msgs.srv.SetString,
                '/store',
            )
        )
        self.assertTrue(self.node.is_called('serve_store'))

    def test_actions(self):
        """Every action has its name and type, and executes a goal."""
        self.assertTrue(
            self.peer.has(
                'action server',
                '/learn',
                'contact_msgs/LearnContact',
            )
        )
        self.assertTrue(
            self.peer.execute(
                contact_msgs.msg.LearnContactAction,
                '/learn',
            )
        )
        self.assertTrue(self.node.is_called('execute_learn'))
        self.assertTrue(
            self.peer.has(
                'action server',
                '/evaluate',
                'contact_msgs/EvaluateContact',
            )
        )
        self.assertTrue(
            self.peer.execute(
                contact_msgs.msg.EvaluateContactAction,
                '/evaluate',
            )
        )
        self.assertTrue(self.node.is_called('execute_evaluate'))

    def test_dynamic_parameters(self):
        """They keep their ranges, and reach the logic."""
        self.assertEqual(
            self.peer.set_parameter(
                'pub_sample',
                False,
            ),
            False,
        )
        self.assertTrue(self.node.is_called('config.pub_sample'))


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
        node, peer = self.start(RECORDER)
        self.assertTrue(node.is_called('update'))
        heard = {
            '/plot_learn_cop': peer.subscribe(
                contact_msgs.msg.PointArray,
                '/plot_learn_cop',
            ),
        }
        before = {topic: len(messages) for topic, messages in heard.items()}
        sleep(1.0 + 2.5 * PERIOD)
        self.assertEqual(node.stop(signal.SIGINT), 0)
        self.assertEqual(node.calls(*LIFE), LIFE)
        rate = float(node.words('rate')[0])
        self.assertGreater(rate, 0.2 / PERIOD)
        self.assertLess(rate, 1.5 / PERIOD)
        for topic, count in before.items():
            self.assertTrue(eventually(lambda t=topic, n=count: len(heard[t]) > n), topic)

    def test_given_parameters(self):
        """Every parameter reaches the logic; one of a wrong type ends the node."""
        given = {
            'samples': 0,
            'pub_sample': False,
        }
        node, _ = self.start(RECORDER, given)
        for name in given:
            self.assertTrue(node.is_called('config.' + name), name)
        self.assertEqual(node.stop(), 0)
        node, _ = self.start(RECORDER, {'samples': {'of': 'another type'}})
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
        'contact_analysis',
        'test_contact_evaluate_node',
        'test_contact_evaluate_node',
    )
