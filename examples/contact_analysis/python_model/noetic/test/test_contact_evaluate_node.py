# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Tests of contact_evaluate: what its spec says, tried from outside."""

import os
import signal
import sys
from time import sleep
import unittest

from contact_analysis.contact_evaluate_interface import ContactEvaluateConfig
import contact_msgs.msg
import contact_msgs.srv
import geometry_msgs.msg
from peer import Peer
import rospy
from running import eventually, RunningNode

NAME = '/contact_evaluate'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'recorder.py'),
    'contact_evaluate',
    'ContactEvaluateImpl',
]
LOGIC = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), '..', 'scripts', 'contact_evaluate'),
]
LIFE = ['configure', 'activate', 'deactivate', 'cleanup']
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
            'in_cop_updated',
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

    def test_parameters(self):
        """Parameters have their defaults, stay within their ranges, and reach update."""
        default = ContactEvaluateConfig()
        self.assertEqual(self.node.words('configure'), [ascii(default)])
        self.sets(
            'pub_sample',
            False,
        )

    def sets(self, name, value, kept=None):
        """Check what a parameter is after it was set, also in the logic."""
        kept = value if kept is None else kept
        self.assertEqual(self.peer.set_parameter(name, value), kept, name)
        config = f'{name}={kept!a}'
        self.assertTrue(eventually(lambda: config in self.node.words('configure', 'config')[-1]))


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
        """The node activates itself, works at its frequency, and ends well at SIGINT."""
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
            'samples': 0,
            'pub_sample': False,
        }
        node, _ = self.start(RECORDER, given)
        self.assertTrue(node.is_called('configure'))
        config = ContactEvaluateConfig(**given)
        self.assertEqual(node.words('configure'), [ascii(config)])
        node.kill()
        wrong = {
            'samples': 'wrong',
            'pub_sample': 'wrong',
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
