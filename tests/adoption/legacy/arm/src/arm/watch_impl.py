#!/usr/bin/env python
import rospy
from std_msgs.msg import Float64

# protected region user include package begin #
# protected region user include package end #


class WatchImplementation(object):
    def __init__(self):
        self.passthrough = WatchPassthrough()

        # protected region user member variables begin #
        # protected region user member variables end #

    def configure(self, config):
        # protected region user configure begin #
        return True
        # protected region user configure end #

    def update(self, data, config):
        # protected region user update begin #
        # can be removed once filled
        pass
        # protected region user update end #

    def callback_forgotten(self, req):
        # protected region user implementation of service callback for forgotten begin #
        self.forgotten = req
        # protected region user implementation of service callback for forgotten end #

    # protected region user additional functions begin #
    # protected region user additional functions end #
