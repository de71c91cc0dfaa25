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
import std_msgs.msg
import std_srvs.srv
from support.peer import Peer
from support.running import eventually, RunningNode
import test_msgs.action

NAME = '/worker'
RECORDER = [
    sys.executable,
    os.path.join(os.path.dirname(__file__), 'support', 'recorder.py'),
    'worker',
    'WorkerImpl',
    '--ros-args',
]
LOGIC = [
    sys.executable,
    '-c',
    'from sys import exit; from all_kinds.worker_ros import main; exit(main())',
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
        """Check that the node publishes to a topic, with type and QoS."""
        self.assertEqual(set(expected) - set(self.peer.publisher(topic)), set(), topic)

    def subscribes(self, topic, *expected):
        """Check that the node subscribes to a topic, with type and QoS."""
        self.assertEqual(set(expected) - set(self.peer.subscription(topic)), set(), topic)

    def test_topics(self):
        """Every topic has its name, type and QoS."""
        self.publishes(
            '/counter',
            'std_msgs/msg/Int64',
            'reliable',
            'volatile',
        )
        self.publishes(
            '/status',
            'std_msgs/msg/String',
            'reliable',
            'volatile',
        )
        self.publishes(
            '/echo',
            'std_msgs/msg/String',
            'reliable',
            'volatile',
        )
        self.publishes(
            '/worker/empty',
            'std_msgs/msg/Empty',
            'reliable',
            'volatile',
        )
        self.subscribes(
            '/speed',
            'geometry_msgs/msg/Twist',
            'reliable',
            'volatile',
        )
        self.subscribes(
            '/counter',
            'std_msgs/msg/Int64',
            'reliable',
            'volatile',
        )
        self.subscribes(
            '/say',
            'std_msgs/msg/String',
            'reliable',
            'volatile',
        )
        self.publishes('/tf', 'tf2_msgs/msg/TFMessage')
        self.subscribes('/tf', 'tf2_msgs/msg/TFMessage')

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
                'std_srvs/srv/Empty',
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
                'std_srvs/srv/SetBool',
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
                'test_msgs/action/Fibonacci',
            )
        )
        self.assertTrue(
            self.peer.execute(
                test_msgs.action.Fibonacci,
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
                'test_msgs/action/Fibonacci',
            )
        )

    def test_parameters(self):
        """Parameters have their values, are refused where they must be, and reach update."""
        for name, value in vars(WorkerConfig()).items():
            is_list = isinstance(value, tuple)
            self.assertEqual(self.peer.parameter(name), list(value) if is_list else value, name)
        self.refuses('prefix', str())
        self.refuses('gain', -1.0)
        self.refuses('gain', 11.0)
        self.refuses('step', 0)
        self.assertTrue(
            self.peer.set_parameter(
                'gain',
                0.0,
            )
        )
        self.assertTrue(self.node.is_called('config', 1))
        self.assertTrue(
            self.peer.set_parameter(
                'step',
                2,
            )
        )
        self.assertTrue(self.node.is_called('config', 2))
        self.assertTrue(
            self.peer.set_parameter(
                'verbose',
                True,
            )
        )
        self.assertTrue(self.node.is_called('config', 3))
        self.assertTrue(
            self.peer.set_parameter(
                'label',
                'other',
            )
        )
        self.assertTrue(self.node.is_called('config', 4))

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
        outputs = peer.subscribe(
            std_msgs.msg.Int64,
            '/counter',
        )
        self.assertTrue(eventually(lambda: outputs))
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
            if transition == 'deactivate':
                sleep(0.5)
                outputs.clear()
                sleep(0.5 + 2 * PERIOD)
                self.assertEqual(outputs, [])
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
        self.assertTrue(peer.set_parameter('prefix', str()))
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
