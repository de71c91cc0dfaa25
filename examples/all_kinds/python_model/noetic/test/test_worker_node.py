# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of worker from outside: its interfaces and its lifecycle."""

import os
import signal
import sys
from time import sleep
import unittest

from all_kinds.worker_interface import WorkerConfig
import geometry_msgs.msg
import rospy
import std_msgs.msg
import std_srvs.srv
from support.peer import Peer
from support.running import eventually, RunningNode
import test_msgs.msg

NAME = '/worker'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'support', 'recorder.py'),
    'worker',
    'WorkerImpl',
]
LOGIC = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), '..', 'scripts', 'worker'),
]
LIFE = ['configure', 'activate', 'deactivate', 'cleanup']
PERIOD = 1.0 / 20  # seconds


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

    def publishes(self, topic, *expected):
        """Check that the node publishes to a topic, with type and latching."""
        self.assertEqual(set(expected) - set(self.peer.publisher(topic)), set(), topic)

    def subscribes(self, topic, *expected):
        """Check that the node subscribes to a topic, with type."""
        self.assertEqual(set(expected) - set(self.peer.subscription(topic)), set(), topic)

    def test_topics(self):
        """Every topic has its name, type and latching."""
        self.publishes(
            '/counter',
            'std_msgs/Int64',
            'not latched',
        )
        self.publishes(
            '/status',
            'std_msgs/String',
            'not latched',
        )
        self.publishes(
            '/echo',
            'std_msgs/String',
            'not latched',
        )
        self.publishes(
            '/worker/empty',
            'std_msgs/Empty',
            'not latched',
        )
        self.subscribes(
            '/speed',
            'geometry_msgs/Twist',
        )
        self.subscribes(
            '/counter',
            'std_msgs/Int64',
        )
        self.subscribes(
            '/say',
            'std_msgs/String',
        )
        self.publishes('/tf', 'tf2_msgs/TFMessage')
        self.subscribes('/tf', 'tf2_msgs/TFMessage')

    def test_messages_in(self):
        """Every message reaches the logic, and is new only once."""
        self.receives(
            geometry_msgs.msg.Twist(),
            '/speed',
            'in_speed_updated',
            once=True,
        )
        self.receives(
            std_msgs.msg.Int64(),
            '/counter',
            'in_counter_updated',
            once=False,
        )
        self.receives(
            std_msgs.msg.String(),
            '/say',
            'receive_say',
            once=True,
        )

    def receives(self, message, topic, call, once):
        """Check that a message makes a call; with `once`, that none makes a second one."""
        sent = self.peer.publish(message, topic, lambda: self.node.is_called(call, timeout=0.1))
        self.assertTrue(self.node.is_called(call), topic)
        sleep(3 * PERIOD)
        if once:
            self.assertLessEqual(len(self.node.calls(call)), sent, topic)

    def test_messages_out(self):
        """Every output is published."""
        self.sends(
            std_msgs.msg.Int64,
            '/counter',
        )
        self.sends(
            std_msgs.msg.String,
            '/status',
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
                '/reset',
                'std_srvs/Empty',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                std_srvs.srv.Empty,
                '/reset',
            )
        )
        self.assertTrue(self.node.is_called('serve_reset'))
        self.assertTrue(
            self.peer.has(
                'service server',
                '/enable',
                'std_srvs/SetBool',
            )
        )
        self.assertIsNotNone(
            self.peer.call(
                std_srvs.srv.SetBool,
                '/enable',
            )
        )
        self.assertTrue(self.node.is_called('serve_enable'))

    def test_actions(self):
        """Every action has its name and type, and executes a goal."""
        self.assertTrue(
            self.peer.has(
                'action server',
                '/compute',
                'test_msgs/Fibonacci',
            )
        )
        self.assertTrue(
            self.peer.execute(
                test_msgs.msg.FibonacciAction,
                '/compute',
            )
        )
        self.assertTrue(self.node.is_called('execute_compute'))

    def test_clients(self):
        """Every client finds its server, by name and type."""
        self.peer.serve(
            std_srvs.srv.Trigger,
            '/permit',
        )
        self.assertTrue(self.node.is_called('client_permit'))
        self.assertTrue(
            self.peer.has(
                'action client',
                '/delegate',
                'test_msgs/Fibonacci',
            )
        )

    def test_parameters(self):
        """Parameters have their defaults, stay within their ranges, and reach update."""
        default = WorkerConfig()
        self.assertEqual(self.node.words('configure'), [ascii(default)])
        self.sets(
            'gain',
            -1.0,
            kept=0.0,
        )
        self.sets(
            'gain',
            11.0,
            kept=10.0,
        )
        self.sets(
            'gain',
            0.0,
        )
        self.sets(
            'step',
            0,
            kept=1,
        )
        self.sets(
            'step',
            1000001,
        )
        self.sets(
            'verbose',
            True,
        )
        self.sets(
            'label',
            'other',
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
        for name, value in (parameters or {}).items():
            rospy.set_param(NAME + '/' + name, value)
        node = RunningNode(command)
        self.addCleanup(node.kill)
        return node, peer

    def test_every_edge(self):
        """The node activates itself, works at its frequency, and ends with code 0 at SIGINT."""
        node, peer = self.start(RECORDER)
        self.assertTrue(node.is_called('activate'))
        outputs = peer.subscribe(
            std_msgs.msg.Int64,
            '/counter',
        )
        self.assertTrue(eventually(lambda: outputs))
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
            'prefix': 'other',
            'weights': (0.0,),
            'gain': 0.0,
            'step': 1000001,
            'verbose': True,
            'label': 'other',
        }
        node, _ = self.start(RECORDER, given)
        self.assertTrue(node.is_called('configure'))
        config = WorkerConfig(**given)
        self.assertEqual(node.words('configure'), [ascii(config)])
        node.kill()
        refused = [
            ('prefix', True),
            ('weights', True),
            ('weights', [True]),
            ('gain', True),
            ('step', True),
            ('verbose', 'wrong'),
            ('label', True),
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
