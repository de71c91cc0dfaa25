#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the node worker: what it is in ROS; support.node_tests has the tests."""

import unittest

import geometry_msgs.msg
from roslib.packages import find_node
import rostest
import std_msgs.msg
import std_srvs.srv
from support.node_tests import NodeTests
import test_msgs.msg


class TestWorkerNode(NodeTests, unittest.TestCase):
    """Runs the node with the recorder as its logic, and with its own logic."""

    name = 'worker'
    parameter_files = ['worker.yaml']  # in config/
    recorder = find_node('all_kinds', 'test_worker_recorder')
    logic = find_node('all_kinds', 'worker')
    frequency = 20  # Hz
    reconfigures = True
    diagnostics = True
    interfaces = {
        'out_counter': ('counter', std_msgs.msg.Int64, 'publisher', None, 'volatile', None),
        'out_status': ('/status', std_msgs.msg.String, 'publisher', None, 'volatile', None),
        'in_speed': ('speed', geometry_msgs.msg.Twist, 'subscription', None, None, None),
        'in_counter': ('counter', std_msgs.msg.Int64, 'subscription', None, None, None),
        'pub_echo': ('{echo_topic}', std_msgs.msg.String, 'publisher', None, 'volatile', 10),
        'pub_empty': ('~/empty', std_msgs.msg.Empty, 'publisher', None, 'volatile', 10),
        'pub_answer': ('{answer_topics}', std_msgs.msg.String, 'publisher', None, 'volatile', 10),
        'receive_say': ('say', std_msgs.msg.String, 'subscription', None, None, 10),
        'receive_call': ('{call_topics}', std_msgs.msg.String, 'subscription', None, None, 10),
        'input_sighting.point': (
            'point',
            geometry_msgs.msg.PointStamped,
            'subscription',
            None,
            None,
            None,
        ),
        'input_sighting.motion': (
            'motion',
            geometry_msgs.msg.TwistStamped,
            'subscription',
            'best_effort',
            None,
            None,
        ),
        'serve_reset': ('reset', std_srvs.srv.Empty),
        'serve_enable': ('enable', std_srvs.srv.SetBool),
        'client_permit': ('permit', std_srvs.srv.Trigger),
        'execute_compute': ('compute', test_msgs.msg.FibonacciAction, 'replace'),
        'execute_measure': ('measure', test_msgs.msg.FibonacciAction, 'parallel', 3),
        'accept_compute': ('compute', test_msgs.msg.FibonacciAction, 'replace'),
        'action_delegate': ('delegate', test_msgs.msg.FibonacciAction),
    }
    synchronizers = {'sighting': (0.05, 10)}  # s between stamps, queue_size
    deadlines = {'in_speed': 0.5, 'receive_say': 1}  # s
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
        'weights': ([0.5, 1.0, 2000.0], [[], [0.0]], [True, [True]]),
    }
    dynamic_parameters = {  # default, other values, refused ones
        'gain': (1.5, [0.0, 1.0, 10.0], [True, -0.0001, 10.001]),
        'step': (1, [1000001], [True, 0]),
        'verbose': (False, [True], ['wrong']),
        'label': ('worker', ['other', 'another'], [True]),
    }


if __name__ == '__main__':
    rostest.rosrun(
        'all_kinds',
        'test_worker_node',
        'test_worker_node',
    )
