"""Let publishers of rospy take each connection half a second after the subscriber knows of it."""

import time

from rospy.topics import _PublisherImpl

at_once = _PublisherImpl.add_connection


def late(self, connection):
    time.sleep(0.5)
    return at_once(self, connection)


_PublisherImpl.add_connection = late
