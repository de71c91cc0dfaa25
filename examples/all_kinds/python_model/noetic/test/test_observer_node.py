# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests of the node observer: what it is in ROS; support.node_tests has the tests."""

import os
import sys
import unittest

import geometry_msgs.msg
import std_msgs.msg
from support.node_tests import NodeTests


class TestObserverNode(NodeTests, unittest.TestCase):
    """Runs the node with the recorder as its logic, and with its own logic."""

    name = 'observer'
    parameter_files = ['observer.yaml']  # in config/
    logic = [
        sys.executable,
        os.path.join(os.path.dirname(__file__), '..', 'scripts', 'observer'),
    ]
    recorder = [
        sys.executable,
        os.path.join(os.path.dirname(__file__), 'support', 'recorder.py'),
        'all_kinds.observer_ros',
        'ObserverImpl',
        '',  # its threads
    ]
    frequency = 12.5  # Hz
    interfaces = {
        'in_status': ('/status', std_msgs.msg.String, 'subscription', None, None, None),
        'input_pair.left': (
            'left',
            geometry_msgs.msg.PointStamped,
            'subscription',
            None,
            None,
            None,
        ),
        'input_pair.right': (
            '~/right',
            geometry_msgs.msg.PointStamped,
            'subscription',
            None,
            None,
            None,
        ),
    }
    synchronizers = {'pair': (0, 5)}  # s between stamps, queue_size
    parameters = {  # default, other values, refused ones
        'limit': (100, [0, 1, -999900, 1000100], [True, 0.5]),
    }
