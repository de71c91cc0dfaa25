#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of worker from outside: its interfaces and its lifecycle."""

import signal
from time import sleep
import unittest

import geometry_msgs.msg
from roslib.packages import find_node
import rospy
import rostest
import std_msgs.msg
import std_srvs.srv
from support.peer import Peer
from support.running import eventually, RunningNode
import test_msgs.msg

NAME = '/worker'
RECORDER = find_node('all_kinds', 'test_worker_recorder')
LOGIC = find_node('all_kinds', 'worker')
LIFE = ['configure', 'activate', 'update', 'deactivate', 'cleanup']
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
            'in_speed',
            once=True,
        )
        self.receives(
            std_msgs.msg.Int64(),
            '/counter',
            'in_counter',
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

    def test_dynamic_parameters(self):
        """They keep their ranges, and reach the logic."""
        self.assertEqual(
            self.peer.set_parameter(
                'gain',
                0.0,
            ),
            0.0,
        )
        self.assertTrue(self.node.is_called('config.gain'))
        self.clamps('gain', -1.0, 0.0)
        self.clamps('gain', 11.0, 10.0)
        self.assertEqual(
            self.peer.set_parameter(
                'step',
                1000001,
            ),
            1000001,
        )
        self.assertTrue(self.node.is_called('config.step'))
        self.clamps('step', 0, 1)
        self.assertEqual(
            self.peer.set_parameter(
                'verbose',
                True,
            ),
            True,
        )
        self.assertTrue(self.node.is_called('config.verbose'))
        self.assertEqual(
            self.peer.set_parameter(
                'label',
                'other',
            ),
            'other',
        )
        self.assertTrue(self.node.is_called('config.label'))

    def clamps(self, name, value, bound):
        """Check that a value which is refused becomes one that is allowed."""
        self.assertEqual(self.peer.set_parameter(name, value), bound, name)


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
        node, peer = self.start(RECORDER)
        self.assertTrue(node.is_called('update'))
        heard = {
            '/echo': peer.subscribe(
                std_msgs.msg.String,
                '/echo',
            ),
            '/worker/empty': peer.subscribe(
                std_msgs.msg.Empty,
                '/worker/empty',
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
            'prefix': 'other',
            'weights': (0.0,),
            'gain': 0.0,
            'step': 1000001,
            'verbose': True,
            'label': 'other',
        }
        node, _ = self.start(RECORDER, given)
        for name in given:
            self.assertTrue(node.is_called('config.' + name), name)
        self.assertEqual(node.stop(), 0)
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


if __name__ == '__main__':
    rostest.rosrun(
        'all_kinds',
        'test_worker_node',
        'test_worker_node',
    )
