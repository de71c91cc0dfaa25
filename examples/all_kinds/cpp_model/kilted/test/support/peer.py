# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A node that talks to the node under test."""

from array import array
from contextlib import suppress
from math import modf
import os
from pathlib import Path
import socket
from threading import Event, Thread
from time import sleep

from action_msgs.msg import GoalStatus
from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticArray
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rcl_interfaces.srv import GetParameters, SetParametersAtomically
import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.task import Future
from rosgraph_msgs.msg import Clock
from support.running import eventually, TIMEOUT


def free_domain():
    """Return a ROS domain that is unused on this machine: its first DDS port is free."""
    for domain in (1 + (os.getpid() + number) % 100 for number in range(100)):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as port, suppress(OSError):
            port.bind(('', 7410 + 250 * domain))
            return domain
    raise RuntimeError('No ROS domain is free.')


# Isolate the test from other nodes on this machine.
os.environ['ROS_DOMAIN_ID'] = str(free_domain())
os.environ.setdefault(
    'FASTDDS_DEFAULT_PROFILES_FILE', str(Path(__file__).with_name('fastdds.xml'))
)


class Peer:
    """Publishers, subscriptions, clients and servers."""

    def __init__(self):
        """Join the graph."""
        self._context = rclpy.Context()
        rclpy.init(context=self._context)
        self._node = rclpy.create_node('peer', context=self._context)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self.clients = {}
        self._clock = self._node.create_publisher(Clock, '/clock', 10)
        self._thread = Thread(target=self._executor.spin)
        self._thread.start()

    def close(self):
        """Leave the graph."""
        self._executor.shutdown()
        self._thread.join()
        self._node.destroy_node()
        rclpy.shutdown(context=self._context)

    def call(self, node, service_type, name, request, *qos):
        """Return the response of a service of a node."""
        future = self.send(node, service_type, name, request, *qos)
        return future.result() if node.eventually(future.done) else None

    def send(self, node, service_type, name, request, reliability='reliable'):
        """Send a request to a node that is known to be discovered; return the future response."""
        if name not in self.clients:
            qos = QoSProfile(depth=10, reliability=ReliabilityPolicy[reliability.upper()])
            client = self._node.create_client(service_type, name, qos_profile=qos)
            assert node.eventually(client.service_is_ready), f'{name} is not served:\n{node.log}'
            self._be_known(node)
            self.clients[name] = client
        return self.clients[name].call_async(request)

    def _be_known(self, node):
        # Fast DDS discovers clients in their order, and drops responses to those it does not know.
        newest = self._node.create_client(GetState, node.name + '/get_state')
        answers = []

        def ask():
            newest.call_async(GetState.Request()).add_done_callback(answers.append)
            return eventually(lambda: answers, 0.5)

        assert node.eventually(ask), f'{node.name} does not answer:\n{node.log}'

    def state(self, node):
        """Return the name of a node's lifecycle state."""
        response = self.call(node, GetState, node.name + '/get_state', GetState.Request())
        return response.current_state.label

    def change(self, node, transition):
        """Request a lifecycle transition by its name; return whether it succeeded."""
        request = ChangeState.Request(transition=Transition(label=transition))
        return self.call(node, ChangeState, node.name + '/change_state', request).success

    def hear_diagnostics(self):
        """Return a list that grows by the messages on /diagnostics."""
        messages = []
        self._node.create_subscription(DiagnosticArray, '/diagnostics', messages.append, 10)
        return messages

    def set_parameter(self, node, name, value):
        """Set a parameter, after another at once; return False if that was refused."""
        parameter = rclpy.parameter.Parameter(name, value=value).to_parameter_msg()
        if value == []:  # rclpy 9.1.2 takes it for a list of bytes
            parameter.value.type = self.parameter(node, name).type
        other = rclpy.parameter.Parameter('stop_timeout', value=2.0).to_parameter_msg()
        request = SetParametersAtomically.Request(parameters=[other, parameter])
        service = node.name + '/set_parameters_atomically'
        result = self.call(node, SetParametersAtomically, service, request).result
        return result.successful or not result.reason

    def parameter(self, node, name):
        """Return the value of a parameter, of whichever type."""
        request = GetParameters.Request(names=[name])
        response = self.call(node, GetParameters, node.name + '/get_parameters', request)
        return response.values[0]

    def set_time(self, seconds):
        """Publish simulated time."""
        fraction, whole = modf(seconds)
        time = Time(sec=int(whole), nanosec=int(fraction * 1e9))
        self._clock.publish(Clock(clock=time))

    def names(self, node):
        """Return the names of the topics and services of a node, and of what it is a client of."""
        space, _, name = node.name.rpartition('/')
        kinds = 'publisher', 'subscriber', 'service', 'client'
        find = [getattr(self._node, f'get_{kind}_names_and_types_by_node') for kind in kinds]
        return {found for each in find for found, _ in each(name, space)}

    def has(self, node, kind, topic, type_, *policies):
        """Return whether a node has a publisher or subscription of a type and QoS."""
        wanted = f'{type_.__module__.split(".")[0]}/msg/{type_.__name__}', *policies
        for info in getattr(self._node, f'get_{kind}s_info_by_topic')(topic):
            qos = info.qos_profile.reliability, info.qos_profile.durability
            found = info.topic_type, *(policy.name.lower() for policy in qos)
            if f'{info.node_namespace}/{info.node_name}' == node.name:
                return all(each in (None, other) for each, other in zip(wanted, found))
        return False

    def offers(self, node, topic):
        """Return the times, in s, and the liveliness that the publisher of a node offers."""
        offers = {}
        for info in self._node.get_publishers_info_by_topic(topic):
            if f'{info.node_namespace}/{info.node_name}' == node.name:
                for name in ('deadline', 'lifespan', 'liveliness_lease_duration'):
                    time = getattr(info.qos_profile, name)
                    offers[name] = round(time.nanoseconds * 1e-9, 6)
                offers['liveliness'] = info.qos_profile.liveliness.name.lower()
        return offers

    @staticmethod
    def _qos(reliability, durability):
        return QoSProfile(
            depth=1000,
            reliability=ReliabilityPolicy[reliability.upper()],
            durability=DurabilityPolicy[durability.upper()],
        )

    def subscribe(self, message_type, topic, reliability, durability):
        """Return a list that grows by the messages to a topic."""
        messages = []
        qos = self._qos(reliability or 'best_effort', durability or 'volatile')
        self._node.create_subscription(message_type, topic, messages.append, qos)
        return messages

    def publisher(self, message_type, topic, reliability, durability):
        """Return a publisher that has a subscription."""
        qos = self._qos(reliability or 'reliable', durability or 'transient_local')
        publisher = self._node.create_publisher(message_type, topic, qos)
        assert eventually(publisher.get_subscription_count), f'{topic} has no subscription'
        return publisher

    def serve(self, service_type, name, response):
        """Respond, the first time after 1 s; return a list that grows by the requests."""
        requests = []

        def serve(request, _):
            requests.append(request)
            sleep(1.0 if len(requests) == 1 else 0.0)
            return response

        self._node.create_service(service_type, name, serve)
        return requests

    def goal(self, node, action_type, name, goal):
        """Send a goal; return it, with its feedback, or None if it is rejected."""
        if name not in self.clients:
            # In the executor, as rclpy 9.1.2 adds the client to the node before it is complete.
            created = self._executor.create_task(ActionClient, self._node, action_type, name)
            assert eventually(created.done) and eventually(created.result().server_is_ready), name
            self._be_known(node)
            self.clients[name] = created.result()
        feedback = []
        sent = self.clients[name].send_goal_async(goal, lambda it: feedback.append(it.feedback))
        assert eventually(sent.done), f'{name} does not answer a goal'
        return SentGoal(sent.result(), feedback) if sent.result().accepted else None

    def execute(self, action_type, name, feedback, result):
        """Serve an action: send feedback and the result when told to, the result if canceled."""
        return GoalServer(self._node, self._executor, action_type, name, feedback, result)


def encode(message):
    """Return a message, serialized, in hexadecimal."""
    return serialize_message(message).hex()


def decode(text, message_type):
    """Return a message from hexadecimal."""
    return deserialize_message(bytes.fromhex(text), message_type)


def sample(message_type, number=3):
    """Return a message with a number in its numbers, strings and arrays of numbers."""
    message = message_type()
    for name in message.get_fields_and_field_types():
        value = getattr(message, name)
        if hasattr(value, 'get_fields_and_field_types'):
            value = sample(type(value), number)
        elif isinstance(value, array):
            value = array(value.typecode, [number])
        elif isinstance(value, (bool, int, float)):
            value = type(value)(number)
        elif isinstance(value, str):
            value = f's{number}'
        setattr(message, name, value)
    return message


def stamped(message_type, seconds):
    """Return a message with a stamp."""
    message = sample(message_type)
    stamp = message.header.stamp
    stamp.sec, stamp.nanosec = divmod(round(seconds * 1e9), 10**9)
    return message


class SentGoal:
    """A goal that a node executes."""

    def __init__(self, handle, feedback):
        """Wait for the result of an accepted goal."""
        self.feedback = feedback
        self.cancel = handle.cancel_goal_async
        self._result = handle.get_result_async()

    def end(self):
        """Return the outcome and the result, when they are there."""
        assert eventually(self._result.done), 'the goal has no result'
        end = self._result.result()
        words = {
            GoalStatus.STATUS_SUCCEEDED: 'succeeded',
            GoalStatus.STATUS_ABORTED: 'aborted',
            GoalStatus.STATUS_CANCELED: 'canceled',
        }
        return words[end.status], end.result


class GoalServer:
    """An action server: `goals` are those it got, `cancels` the number of cancels."""

    rejects = False

    def __init__(self, node, executor, action_type, name, feedback, result):
        """Serve an action."""
        self.answers = Event()
        self.answers.set()
        self.goals = []
        self.cancels = 0
        self._executor = executor
        self._feedback = feedback
        self._result = result
        self._handle = None
        self._server = ActionServer(
            node,
            action_type,
            name,
            self._execute,
            goal_callback=self._accept,
            handle_accepted_callback=self._start,
            cancel_callback=self._cancel,
        )

    def feed_back(self):
        """Send feedback, which a client that is not yet discovered does not get."""
        if self._handle:
            self._handle.publish_feedback(self._feedback)

    def close(self):
        """Serve the action no longer."""
        self._executor.create_task(self._server.destroy)

    def finish(self, outcome):
        """End the goal: succeeded or aborted."""
        self._executor.create_task(self._handle.end.set_result, outcome)

    def _accept(self, goal):
        self.goals.append(goal)
        self.answers.wait(TIMEOUT)
        return GoalResponse.REJECT if self.rejects else GoalResponse.ACCEPT

    def _start(self, handle):
        handle.end = Future(executor=self._executor)
        handle.end.add_done_callback(lambda _: self._executor.wake())  # rclpy 9.1.2 does not
        handle.execute()
        self._handle = handle

    def _cancel(self, handle):
        self.cancels += 1
        handle.end.set_result('canceled')
        return CancelResponse.ACCEPT

    async def _execute(self, handle):
        ends = {'succeeded': handle.succeed, 'aborted': handle.abort, 'canceled': handle.canceled}
        ends[await handle.end]()
        return self._result
