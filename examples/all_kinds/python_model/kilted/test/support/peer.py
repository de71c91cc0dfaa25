# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A node that talks to the node under test."""

from functools import partial
import os
import socket
from threading import Thread
from time import monotonic, sleep

from action_msgs.msg import GoalStatus
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rcl_interfaces.srv import GetParameters, SetParameters
import rclpy
from rclpy.action import ActionClient, get_action_server_names_and_types_by_node
from rclpy.action import get_action_client_names_and_types_by_node
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from support.running import eventually, TIMEOUT


def free_domain():
    """Return a ROS domain that is unused on this machine: its first DDS port is free."""
    for domain in (1 + (os.getpid() + number) % 100 for number in range(100)):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as port:
            try:
                port.bind(('', 7410 + 250 * domain))
                return domain
            except OSError:
                continue
    raise RuntimeError('No ROS domain is free.')


# Isolate the test from other nodes on this machine.
os.environ['ROS_DOMAIN_ID'] = str(free_domain())


class Peer:
    """Publishers, subscriptions and clients for the node of a given full name."""

    def __init__(self, node):
        """Join the graph."""
        self.name = node
        self._context = rclpy.Context()
        rclpy.init(context=self._context)
        self._node = rclpy.create_node('peer_of_' + node[1:], context=self._context)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._clients = {}
        self._thread = Thread(target=self._spin, daemon=True)
        self._thread.start()

    def _spin(self):
        try:
            self._executor.spin()
        except ExternalShutdownException:
            pass

    def close(self):
        """Leave the graph."""
        rclpy.shutdown(context=self._context)
        self._thread.join()
        self._executor.shutdown()
        self._node.destroy_node()

    def publisher(self, topic):
        """Return type, reliability and durability of the node's publisher to a topic."""
        return self._endpoint(self._node.get_publishers_info_by_topic, topic)

    def subscription(self, topic):
        """Return type, reliability and durability of the node's subscription to a topic."""
        return self._endpoint(self._node.get_subscriptions_info_by_topic, topic)

    def _endpoint(self, find, topic):
        def own():
            return [info for info in find(topic) if '/' + info.node_name == self.name]

        if not eventually(own):
            return ()
        info = own()[0]
        qos = info.qos_profile
        return info.topic_type, qos.reliability.name.lower(), qos.durability.name.lower()

    def has(self, kind, name, type_):
        """Return whether the node has a service or action, as a server or client."""
        find = {
            'service server': self._node.get_service_names_and_types_by_node,
            'action server': partial(get_action_server_names_and_types_by_node, self._node),
            'action client': partial(get_action_client_names_and_types_by_node, self._node),
        }[kind]
        return eventually(lambda: self.name[1:] in self._node.get_node_names()) and eventually(
            lambda: (name, [type_]) in find(self.name[1:], '/')
        )

    def call(self, service_type, name, **fields):
        """Return the response of a service, or None."""
        if name not in self._clients:
            client = self._node.create_client(service_type, name)
            if not client.wait_for_service(TIMEOUT):
                return None
            self._be_discovered()
            self._clients[name] = client
        future = self._clients[name].call_async(service_type.Request(**fields))
        return future.result() if eventually(future.done) else None

    def _be_discovered(self):
        """
        Wait until the node has discovered all clients: until it responds to a newer one.

        Fast DDS discovers clients in their order, and drops responses to those it does not know.
        """
        client = self._node.create_client(GetParameters, self.name + '/get_parameters')

        def is_known():
            response = client.call_async(GetParameters.Request())
            return eventually(response.done, timeout=0.5)

        eventually(is_known)
        self._node.destroy_client(client)

    def serve(self, service_type, name):
        """Serve with empty responses."""
        self._node.create_service(service_type, name, lambda request, response: response)

    def execute(self, action_type, name):
        """Send a goal and return whether it succeeds."""
        # In the executor, as rclpy 9.1.2 adds the client to the node before it is complete.
        created = self._executor.create_task(ActionClient, self._node, action_type, name)
        if not eventually(created.done) or not created.result().wait_for_server(TIMEOUT):
            return False
        self._be_discovered()
        sent = created.result().send_goal_async(action_type.Goal())
        if not eventually(sent.done) or not sent.result().accepted:
            return False
        end = sent.result().get_result_async()
        return eventually(end.done) and end.result().status == GoalStatus.STATUS_SUCCEEDED

    def state(self):
        """Return the name of the lifecycle state."""
        response = self.call(GetState, self.name + '/get_state')
        return response and response.current_state.label

    def change(self, transition):
        """Request a lifecycle transition by its name; return whether it succeeded."""
        response = self.call(
            ChangeState,
            self.name + '/change_state',
            transition=Transition(label=transition),
        )
        return response and response.success

    def parameter(self, name):
        """Return the value of a parameter."""
        response = self.call(GetParameters, self.name + '/get_parameters', names=[name])
        return rclpy.parameter.parameter_value_to_python(response.values[0])

    def set_parameter(self, name, value):
        """Set a parameter; return whether it was accepted."""
        message = rclpy.parameter.Parameter(name, value=value).to_parameter_msg()
        response = self.call(
            SetParameters,
            self.name + '/set_parameters',
            parameters=[message],
        )
        return response.results[0].successful

    def subscribe(self, message_type, topic):
        """Return a list that grows by the messages to a topic."""
        messages = []
        qos = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._node.create_subscription(message_type, topic, messages.append, qos)
        return messages

    def publish(self, message, topic, is_received):
        """Publish a message until it is received; return how many times."""
        qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        publisher = self._node.create_publisher(type(message), topic, qos)
        eventually(publisher.get_subscription_count)
        count = 0
        end = monotonic() + TIMEOUT
        while not is_received() and monotonic() < end:
            publisher.publish(message)
            count += 1
            sleep(0.1)
        self._node.destroy_publisher(publisher)
        return count
