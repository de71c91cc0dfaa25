#!/usr/bin/env python
"""
@package arm
@file reach_impl.py
"""

import rospy
from std_msgs.msg import Float64
from std_msgs.msg import Empty
from std_srvs.srv import Trigger, TriggerResponse
from std_srvs.srv import Trigger, TriggerRequest
from test_msgs.msg import FibonacciFeedback, FibonacciResult
import tf

# protected region user include package begin #
from threading import Lock
from arm.helper import Filter
# protected region user include package end #


class ReachConfig(object):
    def __init__(self):
        self.gain = 0.5


class ReachImplementation(object):
    def __init__(self):
        self.passthrough = ReachPassthrough()

        # protected region user member variables begin #
        self.lock = Lock()
        self.filter = Filter()
        self.latest = Float64()
        # protected region user member variables end #

    def configure(self, config):
        # protected region user configure begin #
        self.filter.gain = config.gain
        return self.filter.gain > 0
        # protected region user configure end #

    def update(self, data, config):
        # protected region user update begin #

        if data.in_wanted_updated:
            data.out_pose.data = self.filter.step(data.in_wanted.data)

        rospy.loginfo("at {}".format(data.out_pose.data))
        # protected region user update end #

    def callback_load(self, req):
        result = TriggerResponse()
        # protected region user implementation of service callback for load begin #
        result.success = self.passthrough.client_permit(TriggerRequest()).success
        result.message = "loaded"
        # protected region user implementation of service callback for load end #
        return result

    def callback_learn(self, goal):
        # protected region user implementation of action callback for learn begin #
        feedback = FibonacciFeedback()
        result = FibonacciResult()
        for step in range(goal.order):
            self.passthrough.as_learn.publish_feedback(feedback)
        self.passthrough.as_learn.set_succeeded(result)
        # protected region user implementation of action callback for learn end #

    def direct_topic_callback_stop(self, msg):
        # protected region user implementation of direct subscriber callback for stop begin #
        with self.lock:
            self.stopped(msg)
        # protected region user implementation of direct subscriber callback for stop end #
        pass

    # protected region user additional functions begin #
    def stopped(self, why):
        """Stop, whatever the reason."""
        self.passthrough.frames.waitForTransform("base", "tool", rospy.Time(0), rospy.Duration(1))

    # protected region user additional functions end #
