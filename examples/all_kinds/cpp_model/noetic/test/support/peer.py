# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A node that talks to the node under test."""

from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from copy import deepcopy
from io import BytesIO
from socket import IPPROTO_TCP, TCP_NODELAY
from threading import Event, Thread
from time import sleep
from xmlrpc.client import ServerProxy

import actionlib
from actionlib import GoalStatus
from actionlib_msgs.msg import GoalID
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
import genpy
import rosgraph
from rosgraph_msgs.msg import Clock
import rospy
from rospy.msg import serialize_message
from support.running import eventually, TIMEOUT


class Peer:
    """Publishers, subscriptions, clients and servers."""

    def __init__(self):
        """Join the graph."""
        if not rospy.core.is_initialized():
            rospy.init_node('peer', argv=[], anonymous=True, disable_signals=True)
        self._clients = {}
        self._pool = ThreadPoolExecutor()
        self._clock = rospy.Publisher('/clock', Clock, queue_size=10)

    def give(self, node, parameters, use_sim_time):
        """Set the parameters of a node that is to start; simulated time is one for all."""
        master = rosgraph.Master('/peer')
        master.setParam('/use_sim_time', use_sim_time)
        for name, value in parameters.items():
            is_whole = isinstance(value, float) and value.is_integer() and abs(value) < 2**31
            # Also without a decimal point, as people write it in YAML.
            master.setParam(f'{node}/{name}', int(value) if is_whole else value)

    def knows(self, node):
        """Return whether the master knows a node."""
        state = rosgraph.Master('/peer').getSystemState()
        return any(node.name in nodes for kind in state for _, nodes in kind)

    def kill(self, node):
        """Tell a node to end, as `rosnode kill` does; it may end before it answers."""
        uri = rosgraph.Master('/peer').lookupNode(node.name)

        def shut_down():
            with suppress(OSError):
                ServerProxy(uri).shutdown('/peer', 'killed')

        Thread(target=shut_down, daemon=True).start()

    def set_time(self, seconds):
        """Publish simulated time."""
        self._clock.publish(Clock(clock=rospy.Time.from_sec(seconds)))

    def hear_diagnostics(self):
        """Return a list that grows by the messages on /diagnostics."""
        messages = []
        rospy.Subscriber('/diagnostics', DiagnosticArray, messages.append)
        return messages

    def set_parameter(self, node, name, value):
        """Set a dynamic parameter; return whether the server took it unchanged."""
        if node.name not in self._clients:
            self._clients[node.name] = Client(node.name, TIMEOUT)
        return self._clients[node.name].update_configuration({name: value})[name] == value

    def has(self, node, kind, topic, type_, _=None, durability=None):
        """Return whether a node has a publisher, latched or not, or a subscription of a type."""
        if kind == 'subscription':
            master = rosgraph.Master('/peer')
            nodes = dict(master.getSystemState()[1]).get(topic, [])
            return node.name in nodes and dict(master.getTopicTypes())[topic] == type_._type
        probe = rospy.Subscriber(topic, type_)

        def latching():
            links = [each for each in probe.impl.connections if each.callerid_pub == node.name]
            return ['transient_local' if each.is_latched else 'volatile' for each in links]

        try:
            return eventually(latching, 2.0) and durability in (None, *latching())
        finally:
            probe.unregister()

    def subscribe(self, message_type, topic, *_):
        """Return a list that grows by the messages to a topic."""
        messages = []
        rospy.Subscriber(topic, message_type, lambda message: messages.append(same(message)))
        return messages

    def publisher(self, message_type, topic, reliability=None, *_):
        """Return a publisher that has a subscription."""
        publisher = rospy.Publisher(topic, message_type, queue_size=1000)
        # rospy 1.15 may never hear of a publisher that comes while it subscribes.
        if not eventually(publisher.get_num_connections, 5.0):
            publisher.unregister()
            publisher = rospy.Publisher(topic, message_type, queue_size=1000)
        assert eventually(publisher.get_num_connections), f'{topic} has no subscription'
        if reliability == 'best_effort':  # which asks for no delay
            sockets = [link.socket for link in publisher.impl.connections]
            assert all(each.getsockopt(IPPROTO_TCP, TCP_NODELAY) for each in sockets), topic
        publish = publisher.publish
        publisher.publish = lambda message: publish(deepcopy(message))  # publish() sets header.seq
        return publisher

    def call(self, node, service_type, name, request):
        """Return the response of a service of a node."""
        with suppress(rospy.ServiceException):
            return self.send(node, service_type, name, request).result()

    def send(self, _, service_type, name, request):
        """Send a request; return the future response."""
        rospy.wait_for_service(name, TIMEOUT)
        return self._pool.submit(rospy.ServiceProxy(name, service_type), request)

    def serve(self, service_type, name, response):
        """Respond, the first time after 1 s; return a list that grows by the requests."""
        requests = []

        def serve(request):
            requests.append(request)
            sleep(1.0 if len(requests) == 1 else 0.0)
            return response

        rospy.Service(name, service_type, serve)
        return requests

    def goal(self, node, action_type, name, goal):
        """Send a goal; return it, with its feedback, or None if it is rejected."""
        if name not in self._clients:
            for _ in range(1 + int(TIMEOUT / 5.0)):
                client = actionlib.ActionClient(name, action_type)
                if client.wait_for_server(rospy.Duration(5.0)):
                    break
                # rospy 1.15 may never hear of a publisher that comes while it subscribes.
                client.pub_goal.unregister()
                client.pub_cancel.unregister()
            else:
                raise AssertionError(f'{name} is not served:\n{node.log}')
            feedback = []
            rospy.Subscriber(name + '/feedback', client.ActionFeedback, feedback.append)
            topics = {name + '/feedback', name + '/result'}
            assert eventually(lambda: topics <= self._heard(node)), f'{name} does not connect'
            self._clients[name] = client, feedback
        client, feedback = self._clients[name]
        sent = SentGoal(client.send_goal(goal), feedback)
        assert eventually(lambda: sent.state() != GoalStatus.PENDING), f'{name} does not answer'
        return None if sent.state() == GoalStatus.REJECTED else sent

    def _heard(self, node):
        """
        Return the topics that a node sends to this one.

        ros_comm 1.15 tells a subscriber that it is connected before the publisher sends to it.
        """
        uri = rosgraph.Master('/peer').lookupNode(node.name)
        _, _, links = ServerProxy(uri).getBusInfo('/peer')
        return {topic for _, name, _, _, topic, *_ in links if name == rospy.get_name()}

    def execute(self, action_type, name, feedback, result):
        """Serve an action: send feedback and the result when told to, the result if canceled."""
        return GoalServer(action_type, name, feedback, result)


def encode(message):
    """Return a message, serialized with its length, in hexadecimal."""
    buffer = BytesIO()
    serialize_message(buffer, 0, message)
    return buffer.getvalue().hex()


def decode(text, message_type):
    """Return a message from hexadecimal."""
    return same(message_type().deserialize(bytes.fromhex(text)[4:]))


def same(message):
    """Return a message without the number that its publisher has given it."""
    if message._has_header:
        message.header.seq = 0
    return message


def sample(message_type, number=3):
    """Return a message with a number in its numbers, strings and arrays of numbers."""
    message = message_type()
    for name, type_ in zip(message.__slots__, message._slot_types):
        value = getattr(message, name)
        if isinstance(value, genpy.Message):
            value = sample(type(value), number)
        elif isinstance(value, bytes):
            value = bytes([number]) * (len(value) or 1)
        elif isinstance(value, list) and genpy.base.is_simple(type_.partition('[')[0]):
            value = [number] * (len(value) or 1)
        elif isinstance(value, (bool, int, float, genpy.rostime.TVal)):
            value = type(value)(number)
        elif isinstance(value, str):
            value = f's{number}'
        setattr(message, name, value)
    return decode(encode(message), message_type)  # with arrays of the types of a received one


def stamped(message_type, seconds):
    """Return a message with a stamp."""
    message = sample(message_type)
    message.header.stamp = rospy.Time.from_sec(seconds)
    return message


def parts(action_type):
    """Return the types of goal, feedback and result."""
    action = action_type()
    goal, feedback = action.action_goal.goal, action.action_feedback.feedback
    return type(goal), type(feedback), type(action.action_result.result)


class SentGoal:
    """A goal that a node executes."""

    def __init__(self, handle, feedback):
        """Know a goal that is sent, and the feedback to all goals."""
        self.cancel = handle.cancel
        self._handle = handle
        self._feedback = feedback

    @property
    def feedback(self):
        """Return the feedback to this goal; actionlib drops what comes after the result."""
        goal = self._handle.comm_state_machine.action_goal.goal_id.id
        return [each.feedback for each in self._feedback if each.status.goal_id.id == goal]

    def state(self):
        """Return the state that the server has told."""
        return self._handle.get_goal_status()

    def end(self):
        """Return the outcome and the result, when they are there."""
        done = actionlib.CommState.DONE
        assert eventually(lambda: self._handle.get_comm_state() == done), 'the goal has no result'
        state = GoalStatus.to_string(self.state()).lower()
        return 'canceled' if state == 'preempted' else state, self._handle.get_result()


class GoalServer:
    """An action server: `goals` are those it got, `cancels` the number of cancels."""

    rejects = False

    def __init__(self, action_type, name, feedback, result):
        """Serve an action."""
        self.answers = Event()
        self.answers.set()
        self.goals = []
        self.cancels = 0
        self._handle = None
        self._feedback = feedback
        self._result = result
        self._server = actionlib.ActionServer(name, action_type, self._accept, self._cancel, False)
        self._server.start()
        rospy.Subscriber(name + '/cancel', GoalID, self._count)

    def feed_back(self):
        """Send feedback, which a client that does not know the goal yet does not get."""
        if self._handle and self._server.result_pub.get_num_connections():
            self._handle.publish_feedback(self._feedback)

    def close(self):
        """Serve the action no longer."""
        self._server.status_timer.shutdown()
        topics = 'status_pub', 'result_pub', 'feedback_pub', 'goal_sub', 'cancel_sub'
        for topic in topics:
            getattr(self._server, topic).unregister()

    def finish(self, outcome):
        """End the goal: succeeded or aborted."""
        getattr(self._handle, 'set_' + outcome)(self._result)

    def _accept(self, handle):
        self.goals.append(handle.get_goal())
        self.answers.wait(TIMEOUT)
        if self.rejects:
            handle.set_rejected()
            return
        handle.set_accepted()
        self._handle = handle

    def _count(self, cancel):
        self.cancels += bool(cancel.id)  # without one it is for the goals of all clients

    def _cancel(self, handle):
        handle.set_canceled(self._result)
