"""Make rospy slow and forgetful.

Publishers take each connection half a second after the subscriber knows of it. Of a publisher that
comes while a node subscribes the node does not hear: rospy 1.15 (RegManager.run) drops the update
of the master where the answer to the subscription is queued after it.
"""

import time

from rospy.impl.masterslave import ROSHandler
from rospy.topics import _PublisherImpl

at_once = _PublisherImpl.add_connection
update = ROSHandler.publisherUpdate
lost = set()


def late(self, connection):
    time.sleep(0.5)
    return at_once(self, connection)


def forget(self, caller_id, topic, publishers):
    is_lost = topic.endswith(("/turn/cancel", "/say")) and publishers and topic not in lost
    if is_lost:
        lost.add(topic)
        return 1, "", 0
    return update(self, caller_id, topic, publishers)


_PublisherImpl.add_connection = late
ROSHandler.publisherUpdate = forget
