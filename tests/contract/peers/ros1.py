"""The peer in ROS 1, written with rospy and actionlib alone."""

import contextlib
import os
import socket
import threading
import time
from xmlrpc.client import ServerProxy

import actionlib
import dynamic_reconfigure.client
import rosgraph
import rosnode
import rospy
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from common import TIMEOUT, Heard, Served, later, load, wait_for
from connection import sends_to
from genpy.message import fill_message_args

RESULTS = {
    GoalStatus.SUCCEEDED: "succeeded",
    GoalStatus.PREEMPTED: "canceled",
    GoalStatus.RECALLED: "canceled",
    GoalStatus.ABORTED: "aborted",
    GoalStatus.REJECTED: "rejected",
    GoalStatus.LOST: "lost",
}


class Peer:
    def __init__(self):
        rospy.init_node(f"peer_{os.getpid()}", disable_signals=True)
        self.subscribers = {}
        self.publishers = {}
        self.served = {}
        self.clients = {}
        self.goals = {}
        self.lock = threading.Lock()
        self.broadcaster = tf2_ros.StaticTransformBroadcaster()

    def ready(self):
        return True

    def leave(self, namespace):
        """End what is still served there; the master forgets the nodes, which have all ended.

        It would keep the address of a killed one, which rosout then calls. Once a node of another
        test has that port for its topics, rospy 1.15 waits for the rest of such a call, and
        accepts no other connection.
        """
        for name, served in self.served.items():
            if name.startswith(namespace + "/"):
                served.ended.set()
        nodes = rosnode.get_node_names(namespace)
        rosnode.cleanup_master_blacklist(rosgraph.Master("/peer"), nodes)

    # Topics
    def hear(self, topic, kind, **_qos):
        heard = Heard()
        subscriber = rospy.Subscriber(topic, load(kind), heard.take, queue_size=1000)
        self.subscribers[topic] = heard, subscriber

    def deafen(self, topic):
        self.subscribers[topic][1].unregister()

    def heard(self, topic):
        return self.subscribers[topic][0].messages

    def publish(self, topic, kind, data=None, wait=True, qos=None):
        latch = (qos or {}).get("durability") == "transient_local"
        with self.lock:
            if topic not in self.publishers:
                self.publishers[topic] = rospy.Publisher(
                    topic, load(kind), queue_size=10, latch=latch
                )
        publisher = self.publishers[topic]
        if wait:
            wait_for(publisher.get_num_connections, f"nobody hears {topic}")
        message = load(kind)()
        fill_message_args(message, [] if data is None else [data])  # fields, or the only one
        publisher.publish(message)

    def publish_point(self, topic, seconds, value, wait=True):
        kind = load("geometry_msgs/msg/PointStamped")
        with self.lock:
            if topic not in self.publishers:
                self.publishers[topic] = rospy.Publisher(topic, kind, queue_size=10)
        if wait:
            wait_for(self.publishers[topic].get_num_connections, f"nobody hears {topic}")
        message = kind()
        message.header.stamp = rospy.Time.from_sec(seconds)
        message.point.x = value
        self.publishers[topic].publish(message)

    def clock(self, seconds):
        publisher = self.publishers.get("/clock")
        if publisher is None:
            publisher = rospy.Publisher(
                "/clock", load("rosgraph_msgs/msg/Clock"), queue_size=10, latch=True
            )
            self.publishers["/clock"] = publisher
        publisher.publish(rospy.Time.from_sec(seconds))

    def end_clock(self):
        if publisher := self.publishers.pop("/clock", None):
            publisher.unregister()

    def transform(self, parent, child, x):
        message = load("geometry_msgs/msg/TransformStamped")()
        message.header.stamp = rospy.Time.now()
        message.header.frame_id, message.child_frame_id = parent, child
        message.transform.translation.x = x
        message.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(message)

    # Services
    def call(self, service, timeout=TIMEOUT):
        rospy.wait_for_service(service, timeout)
        return rospy.ServiceProxy(service, load("std_srvs/srv/Trigger"))().message

    def serve(self, service, seconds=0.0):
        served = Served(seconds)

        def answer(_request):
            served.note("request", time.monotonic())
            served.work(served.ended.is_set)
            return load("std_srvs/srv/Trigger")._response_class(True, "yes")

        rospy.Service(service, load("std_srvs/srv/Trigger"), answer)
        self.served[service] = served

    # Actions
    def serve_action(self, action, seconds=0.0, feedback=0, answer_after=0.0):
        served = Served(seconds, feedback)
        part = load("test_msgs/msg/FibonacciFeedback")

        def execute(goal):
            served.note("goal", goal.order)
            if feedback:
                server.publish_feedback(part(list(range(feedback))))
            result = load("test_msgs/msg/FibonacciResult")([goal.order])
            if served.work(lambda: server.is_preempt_requested() or served.ended.is_set()):
                server.set_succeeded(result)
                served.note("succeeded", goal.order)
            else:
                server.set_preempted(result)
                served.note("canceled", goal.order)

        type_ = load("test_msgs/msg/FibonacciAction")
        server = actionlib.SimpleActionServer(action, type_, execute, auto_start=False)
        for take in ("internal_goal_callback", "internal_cancel_callback"):
            late = later(answer_after, getattr(server.action_server, take))
            setattr(server.action_server, take, late)
        server.start()
        self.served[action] = served

    def served_log(self, name):
        return self.served[name].log

    def goal(self, action, order):
        """Send a goal; return its number, or nothing if it is rejected."""
        with self.lock:
            client = self.clients.get(action)
            if client is None:
                type_ = load("test_msgs/msg/FibonacciAction")
                self.clients[action] = client = actionlib.ActionClient(action, type_)
        assert client.wait_for_server(rospy.Duration(TIMEOUT)), f"no action {action}"
        wait_for(lambda: sends_to(client), "the server does not send to this peer")
        handle = client.send_goal(load("test_msgs/msg/FibonacciGoal")(order))
        wait_for(
            lambda: handle.get_comm_state() != actionlib.CommState.WAITING_FOR_GOAL_ACK,
            "the goal was not answered",
        )
        # A status that comes before the result tells of the rejection as well.
        if handle.get_goal_status() == GoalStatus.REJECTED:
            return None
        with self.lock:
            number = len(self.goals) + 1
            self.goals[number] = handle
        return number

    def is_accepted(self, number):
        """Wait until the server has accepted a goal."""
        handle = self.goals[number]
        wait_for(
            lambda: handle.get_comm_state() == actionlib.CommState.ACTIVE,
            "the goal was not accepted",
        )
        return True

    def cancel(self, number):
        self.goals[number].cancel()

    def result(self, number, timeout=TIMEOUT):
        handle = self.goals[number]
        wait_for(
            lambda: handle.get_comm_state() == actionlib.CommState.DONE,
            "the goal does not end",
            timeout,
        )
        sequence = getattr(handle.get_result(), "sequence", [])
        return [RESULTS[handle.get_goal_status()], list(sequence)]

    # The node
    def kill_node(self, node):
        rosnode.kill_nodes([node])

    def kill_when_known(self, node):
        """Do as `rosnode kill`, as soon as the master knows the node."""
        master = rosgraph.Master("/peer")
        address = None
        end = time.monotonic() + TIMEOUT
        while not address and time.monotonic() < end:
            with contextlib.suppress(rosgraph.MasterException):
                address = master.lookupNode(node)
        with contextlib.suppress(OSError):  # it may end before it answers
            ServerProxy(address).shutdown("/peer", "killed")

    def request_at_data_port(self, node, topic):
        """Send the port of the node's data how a request of the master begins."""
        api = ServerProxy(rosgraph.Master("/peer").lookupNode(node))
        _, host, port = api.requestTopic("/peer", topic, [["TCPROS"]])[2]
        with socket.create_connection((host, port)) as connection:
            connection.sendall(b"POST /RPC2 HTTP/1.1\r\n")

    def set_parameter(self, node, name, value, waits=True):
        if not waits:
            return threading.Thread(target=self.set_parameter, args=(node, name, value)).start()
        client = dynamic_reconfigure.client.Client(node, timeout=TIMEOUT)
        return client.update_configuration({name: value})[name] == value

    def set_global(self, name, value):
        rospy.set_param(name, value)

    def delete_global(self, name):
        rospy.delete_param(name)

    def graph(self, namespace):
        """Return how many topics and services nodes there have at the master."""
        names = rosgraph.Master("/peer").getSystemState()
        return sum(
            node.startswith(namespace + "/")
            for kind in names
            for _, nodes in kind
            for node in nodes
        )
