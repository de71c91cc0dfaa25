#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the node worker: what it is in ROS; support.node_tests has the tests."""

import os
import unittest

import geometry_msgs.msg
import std_msgs.msg
import std_srvs.srv
from support.node_tests import NodeTests
import test_msgs.action


@unittest.skipIf('RECORDER' not in os.environ, 'ctest runs this, as CMakeLists.txt says')
class TestWorkerNode(NodeTests, unittest.TestCase):
    """Runs the node with the recorder as its logic, and with its own logic."""

    name = 'worker'
    parameter_files = ['worker.yaml']  # in config/
    recorder = [os.environ.get('RECORDER')]
    logic = [os.environ.get('NODE')]
    frequency = 20  # Hz
    reconfigures = True
    diagnostics = True
    interfaces = {
        'out_counter': ('counter', std_msgs.msg.Int64, 'publisher', 'reliable', 'volatile', 10),
        'out_status': ('/status', std_msgs.msg.String, 'publisher', 'reliable', 'volatile', 10),
        'in_speed': ('speed', geometry_msgs.msg.Twist, 'subscription', 'reliable', 'volatile', 10),
        'in_counter': ('counter', std_msgs.msg.Int64, 'subscription', 'reliable', 'volatile', 10),
        'pub_echo': ('{echo_topic}', std_msgs.msg.String, 'publisher', 'reliable', 'volatile', 10),
        'pub_empty': ('~/empty', std_msgs.msg.Empty, 'publisher', 'reliable', 'volatile', 10),
        'pub_answer': (
            '{answer_topics}',
            std_msgs.msg.String,
            'publisher',
            'reliable',
            'volatile',
            10,
        ),
        'receive_say': ('say', std_msgs.msg.String, 'subscription', 'reliable', 'volatile', 10),
        'receive_call': (
            '{call_topics}',
            std_msgs.msg.String,
            'subscription',
            'reliable',
            'volatile',
            10,
        ),
        'input_sighting.point': (
            'point',
            geometry_msgs.msg.PointStamped,
            'subscription',
            'reliable',
            'volatile',
            10,
        ),
        'input_sighting.motion': (
            'motion',
            geometry_msgs.msg.TwistStamped,
            'subscription',
            'best_effort',
            'volatile',
            5,
        ),
        'serve_reset': ('reset', std_srvs.srv.Empty),
        'serve_enable': ('enable', std_srvs.srv.SetBool, 'best_effort'),
        'client_permit': ('permit', std_srvs.srv.Trigger),
        'execute_compute': ('compute', test_msgs.action.Fibonacci, 'replace'),
        'execute_measure': ('measure', test_msgs.action.Fibonacci, 'parallel', 3),
        'accept_compute': ('compute', test_msgs.action.Fibonacci, 'replace'),
        'action_delegate': ('delegate', test_msgs.action.Fibonacci),
    }
    synchronizers = {'sighting': (0.05, 10)}  # s between stamps, queue_size
    deadlines = {'in_speed': 0.5, 'receive_say': 1}  # s
    offers = {  # times in s
        'out_counter': {'deadline': 0.5},
        'out_status': {'lifespan': 2.0},
        'pub_echo': {'liveliness': 'manual_by_topic', 'liveliness_lease_duration': 5.0},
    }
    threads = ('read',)
    timers = {'poll': 4}  # Hz
    transforms = ('broadcaster_pose', 'listener_frames')
    parameters = {  # default, other values, refused ones
        'prefix': ('it\'s "said" <so> & für immer', ['other', 'another'], [True]),
        'echo_topic': ('echo', ['/other_echo_topic'], [True]),
        'call_topics': (
            ['hall/call', '~/call'],
            [['/other_call_topics']],
            [True, [True]],
        ),
        'answer_topics': (
            ['hall/answer', '/answer'],
            [['/other_answer_topics']],
            [True, [True]],
        ),
        'weights': ([0.5, 1.0, 2000.0], [[0.0], []], [True, [True]]),
    }
    dynamic_parameters = {  # default, other values, refused ones
        'gain': (1.5, [0.0, 1.0, 10.0], [True, -0.0001, 10.001]),
        'step': (1, [1000001], [True, 0]),
        'verbose': (False, [True], ['wrong']),
        'label': ('worker', ['other', 'another'], [True]),
    }


if __name__ == '__main__':
    unittest.main()
