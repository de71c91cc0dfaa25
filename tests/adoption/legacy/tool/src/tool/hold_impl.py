#!/usr/bin/env python
import rospy

# protected region user include package begin #
# protected region user include package end #


class HoldImplementation(object):
    def __init__(self):
        self.passthrough = HoldPassthrough()

        # protected region user member variables begin #
        self.is_closed = False
        # protected region user member variables end #

    def configure(self, config):
        # protected region user configure begin #
        self.force = config.force
        return self.force > 0
        # protected region user configure end #

    def callback_grip(self, req, config):
        # protected region user implementation of service callback for grip begin #
        self.is_closed = self.closed()
        # protected region user implementation of service callback for grip end #

    # protected region user additional functions begin #
    def closed(self):
        return True
    # protected region user additional functions end #
