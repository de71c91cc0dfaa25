"""A peer in ROS 1, written with rospy alone."""

import importlib
import time

import actionlib
import dynamic_reconfigure.client
import rospy
import tf2_ros
from connection import sends_to

TIMEOUT = 30.0
RESULTS = {
    actionlib.GoalStatus.SUCCEEDED: "succeeded",
    actionlib.GoalStatus.PREEMPTED: "canceled",
    actionlib.GoalStatus.ABORTED: "aborted",
}


def load(type_name, suffix=""):
    package, folder, name = type_name.split("/")
    folder = "msg" if folder == "action" else folder
    return getattr(importlib.import_module(f"{package}.{folder}"), name + suffix)


class Goal:
    """A goal of its own client, since a simple client follows one goal at a time."""

    def __init__(self, client, goal):
        self.feedback = []
        self.handle = client.send_goal(
            goal, feedback_cb=lambda handle, feedback: self.feedback.append(feedback)
        )

    def cancel(self):
        """Cancel once the server's list has the goal; actionlib loses it by an older list."""
        waiting = actionlib.CommState.WAITING_FOR_GOAL_ACK
        self._wait(lambda state: state != waiting, "the goal is not listed")
        self.handle.cancel()

    def answer(self):
        """Wait for the end; return the outcome and the message of the result."""
        self._wait(lambda state: state == actionlib.CommState.DONE, "the goal does not end")
        return RESULTS[self.handle.get_goal_status()], self.handle.get_result()

    def _wait(self, reached, problem):
        end = time.monotonic() + TIMEOUT
        while not reached(self.handle.get_comm_state()):
            assert time.monotonic() < end, problem
            time.sleep(0.002)

    def result(self):
        """Wait for the end; return the outcome and the sequence of the result."""
        outcome, result = self.answer()
        return outcome, list(getattr(result, "sequence", []))


class Publisher:
    def __init__(self, publisher):
        self.publish = publisher.publish
        self.connected = lambda: publisher.get_num_connections() > 0


class Peer:
    def __init__(self):
        rospy.init_node("peer")
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer)
        self.kept = []

    def close(self):
        rospy.signal_shutdown("done")

    def wait_until_active(self, node):
        """Do nothing: a node of ROS 1 offers its actions and services once it is active."""

    def message(self, type_name, **fields):
        return load(type_name)(**fields)

    def hear(self, topic, type_name, **_qos):
        heard = []
        rospy.Subscriber(topic, load(type_name), heard.append)
        return heard

    def publisher(self, topic, type_name, **_qos):
        return Publisher(rospy.Publisher(topic, load(type_name), queue_size=10))

    def call(self, service, type_name, reliability="", **fields):
        """Call a service; reliability is of ROS 2 alone."""
        rospy.wait_for_service(service, TIMEOUT)
        return rospy.ServiceProxy(service, load(type_name))(**fields)

    def serve(self, service, type_name, **fields):
        type_ = load(type_name)
        rospy.Service(service, type_, lambda request: type_._response_class(**fields))

    def goal(self, action, type_name, **fields):
        client = actionlib.ActionClient(action, load(type_name, "Action"))
        assert client.wait_for_server(rospy.Duration(TIMEOUT)), "no action server"
        end = time.monotonic() + TIMEOUT
        while not sends_to(client):
            assert time.monotonic() < end, "the server does not send to this peer"
            time.sleep(0.01)
        self.kept.append(client)
        return Goal(client, load(type_name, "Goal")(**fields))

    def serve_action(self, action, type_name, **fields):
        server = actionlib.SimpleActionServer(
            action,
            load(type_name, "Action"),
            execute_cb=lambda goal: server.set_succeeded(load(type_name, "Result")(**fields)),
            auto_start=False,
        )
        server.start()

    def get_parameter(self, node, name):
        end = time.monotonic() + TIMEOUT  # roslaunch may not have set it yet
        while not rospy.has_param(f"/{node}/{name}"):
            assert time.monotonic() < end, f"no parameter {name} of {node}"
            time.sleep(0.05)
        return rospy.get_param(f"/{node}/{name}")

    def set_parameter(self, node, name, value):
        client = dynamic_reconfigure.client.Client(node, timeout=TIMEOUT)
        return client.update_configuration({name: value})[name] == value

    def refuses(self, node, name, value, limit):
        """Check that a value beyond a limit is brought back to it, as dynamic_reconfigure does."""
        client = dynamic_reconfigure.client.Client(node, timeout=TIMEOUT)
        assert client.update_configuration({name: value})[name] == limit

    def lookup(self, target, source):
        try:
            found = self.buffer.lookup_transform(target, source, rospy.Time())
        except tf2_ros.TransformException:
            return None
        vector = found.transform.translation
        return vector.x, vector.y, vector.z

    def send_transform(self, parent, child, translation):
        message = self.message("geometry_msgs/msg/TransformStamped")
        message.header.stamp = rospy.Time.now()
        message.header.frame_id, message.child_frame_id = parent, child
        vector = message.transform.translation
        vector.x, vector.y, vector.z = translation
        message.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(message)
