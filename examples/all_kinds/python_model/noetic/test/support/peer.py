# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A node that talks to the node under test."""

from contextlib import suppress
from time import monotonic, sleep
from xmlrpc.client import ServerProxy

import actionlib
import dynamic_reconfigure.client
import rosgraph
import rospy
from support.running import eventually, TIMEOUT

PUBLISHERS, SUBSCRIBERS, SERVICES = range(3)  # indices of the master's system state
EVERY_NODE_HAS = ('/rosout', '/get_loggers', '/set_logger_level')


class Peer:
    """Publishers, subscriptions and clients for the node of a given full name."""

    def __init__(self, node):
        """Join the graph, and delete the parameters of earlier nodes of that name."""
        self.name = node
        self._master = rosgraph.Master('/peer')
        self._endpoints = []
        if not rospy.core.is_initialized():
            rospy.init_node('peer', argv=[], anonymous=True, disable_signals=True)
        if rospy.has_param(node):
            rospy.delete_param(node)

    def close(self):
        """Leave the topics."""
        for endpoint in self._endpoints:
            endpoint.unregister()

    def _has(self, kind, name):
        return self.name in dict(self._master.getSystemState()[kind]).get(name, [])

    def publisher(self, topic):
        """Return type and latching of the node's publisher to a topic."""
        probe = rospy.Subscriber(topic, rospy.AnyMsg)

        def own():
            return [link for link in probe.impl.connections if link.callerid_pub == self.name]

        try:
            if not eventually(own):
                return ()
            return own()[0].type, 'latched' if own()[0].is_latched else 'not latched'
        finally:
            probe.unregister()

    def subscription(self, topic):
        """Return the type of the node's subscription to a topic."""
        if not eventually(lambda: self._has(SUBSCRIBERS, topic)):
            return ()
        return (dict(self._master.getTopicTypes())[topic],)

    def has(self, kind, name, type_):
        """Return whether the node has a service or action, as a server or client."""
        if kind == 'service server':  # a call checks its type
            return eventually(lambda: self._has(SERVICES, name))
        goals, results = self.subscription, self.publisher
        if kind == 'action client':
            goals, results = results, goals
        is_sent = type_ + 'ActionGoal' in goals(name + '/goal')
        return is_sent and type_ + 'ActionResult' in results(name + '/result')

    def is_connected(self):
        """Return whether the node has a topic or service beside those of every node."""
        state = self._master.getSystemState()
        names = {name for kind in state for name, nodes in kind if self.name in nodes}
        return any(not name.endswith(EVERY_NODE_HAS) for name in names)

    def kill(self):
        """Tell the node to end, as `rosnode kill` does; it may end before it answers."""
        with suppress(OSError):
            ServerProxy(self._master.lookupNode(self.name)).shutdown('/peer', 'killed')

    def call(self, service_type, name):
        """Return the response of a service, or None."""
        try:
            rospy.wait_for_service(name, TIMEOUT)
            return rospy.ServiceProxy(name, service_type)()
        except (rospy.ROSException, rospy.ServiceException):
            return None

    def serve(self, service_type, name):
        """Serve with empty responses."""
        rospy.Service(name, service_type, lambda _: service_type._response_class())

    def execute(self, action_type, name):
        """Send a goal and return whether it succeeds."""
        client = actionlib.SimpleActionClient(name, action_type)
        if not client.wait_for_server(rospy.Duration(TIMEOUT)):
            return False
        client.send_goal(action_type().action_goal.goal)
        client.wait_for_result(rospy.Duration(TIMEOUT))
        return client.get_state() == actionlib.GoalStatus.SUCCEEDED

    def set_parameter(self, name, value):
        """Set a dynamic parameter; return its value afterwards."""
        client = dynamic_reconfigure.client.Client(self.name, TIMEOUT)
        try:
            return client.update_configuration({name: value})[name]
        finally:
            client.close()

    def subscribe(self, message_type, topic):
        """Return a list that grows by the messages to a topic."""
        messages = []
        subscriber = rospy.Subscriber(topic, message_type, messages.append)
        self._endpoints.append(subscriber)
        eventually(subscriber.get_num_connections)
        return messages

    def publish(self, message, topic, is_received):
        """Publish a message until it is received; return how many times."""
        publisher = rospy.Publisher(topic, type(message), queue_size=1)
        eventually(publisher.get_num_connections)
        count = 0
        end = monotonic() + TIMEOUT
        while not is_received() and monotonic() < end:
            publisher.publish(message)
            count += 1
            sleep(0.1)
        publisher.unregister()
        return count
