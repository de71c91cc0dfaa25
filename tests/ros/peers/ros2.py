"""A peer in ROS 2, written with rclpy alone."""

import contextlib
import importlib
import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.parameter import Parameter, parameter_value_to_python

TIMEOUT = 10.0
TRANSITIONS = {"configure": 1, "cleanup": 2, "activate": 3, "deactivate": 4}
RESULTS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "canceled",
    GoalStatus.STATUS_ABORTED: "aborted",
}


def load(type_name):
    package, folder, name = type_name.split("/")
    return getattr(importlib.import_module(f"{package}.{folder}"), name)


def result_of(future, what):
    end = time.monotonic() + TIMEOUT
    while not future.done():
        assert time.monotonic() < end, what
        time.sleep(0.002)
    return future.result()


class Goal:
    def __init__(self, client, goal):
        assert client.wait_for_server(TIMEOUT), "no action server"
        self.feedback = []
        future = client.send_goal_async(
            goal, feedback_callback=lambda message: self.feedback.append(message.feedback)
        )
        self.handle = result_of(future, "the goal was not answered")
        assert self.handle.accepted, "the goal was rejected"

    def cancel(self):
        self.handle.cancel_goal_async()

    def result(self):
        answer = result_of(self.handle.get_result_async(), "the goal does not end")
        return RESULTS[answer.status], list(getattr(answer.result, "sequence", []))


class Publisher:
    def __init__(self, publisher):
        self.publish = publisher.publish
        self.connected = lambda: publisher.get_subscription_count() > 0


class Peer:
    def __init__(self):
        rclpy.init()
        self.node = rclpy.create_node("peer")
        self.group = ReentrantCallbackGroup()
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        self.thread = threading.Thread(target=self.spin, daemon=True)
        self.thread.start()
        self.buffer = None

    def spin(self):
        with contextlib.suppress(ExternalShutdownException):
            self.executor.spin()

    def close(self):
        rclpy.try_shutdown()
        self.thread.join(TIMEOUT)

    def message(self, type_name, **fields):
        return load(type_name)(**fields)

    def hear(self, topic, type_name):
        heard = []
        self.node.create_subscription(
            load(type_name), topic, heard.append, 50, callback_group=self.group
        )
        return heard

    def publisher(self, topic, type_name):
        return Publisher(self.node.create_publisher(load(type_name), topic, 10))

    def call(self, service, type_name, **fields):
        type_ = load(type_name)
        client = self.node.create_client(type_, service, callback_group=self.group)
        assert client.wait_for_service(TIMEOUT), f"no service {service}"
        response = result_of(client.call_async(type_.Request(**fields)), f"no answer: {service}")
        self.node.destroy_client(client)
        return response

    def serve(self, service, type_name, **fields):
        type_ = load(type_name)
        self.node.create_service(
            type_, service, lambda request, response: type_.Response(**fields)
        )

    def goal(self, action, type_name, **fields):
        type_ = load(type_name)
        client = ActionClient(self.node, type_, action, callback_group=self.group)
        return Goal(client, type_.Goal(**fields))

    def serve_action(self, action, type_name, **fields):
        type_ = load(type_name)

        def execute(handle):
            handle.succeed()
            return type_.Result(**fields)

        ActionServer(self.node, type_, action, execute, callback_group=self.group)

    def get_parameter(self, node, name):
        answer = self.call(
            f"{node}/get_parameters", "rcl_interfaces/srv/GetParameters", names=[name]
        )
        return parameter_value_to_python(answer.values[0])

    def set_parameter(self, node, name, value):
        parameter = Parameter(name, value=value).to_parameter_msg()
        answer = self.call(
            f"{node}/set_parameters", "rcl_interfaces/srv/SetParameters", parameters=[parameter]
        )
        return answer.results[0].successful

    def refuses(self, node, name, value, limit):
        """Check that a value beyond a limit is refused, and so are wrong types and statics."""
        before = self.get_parameter(node, name)
        assert not self.set_parameter(node, name, value), f"{name} = {value} was accepted"
        assert not self.set_parameter(node, name, "text"), f"{name} = text was accepted"
        assert not self.set_parameter(node, "prefix", "text"), "a static parameter was set"
        assert self.get_parameter(node, name) == before

    def state(self, node):
        return self.call(f"{node}/get_state", "lifecycle_msgs/srv/GetState").current_state.label

    def change_state(self, node, transition):
        request = {
            "transition": self.message("lifecycle_msgs/msg/Transition", id=TRANSITIONS[transition])
        }
        return self.call(
            f"{node}/change_state", "lifecycle_msgs/srv/ChangeState", **request
        ).success

    def lookup(self, target, source):
        import tf2_ros

        if self.buffer is None:
            self.buffer = tf2_ros.Buffer()
            self.listener = tf2_ros.TransformListener(self.buffer, self.node)
        try:
            found = self.buffer.lookup_transform(target, source, rclpy.time.Time())
        except tf2_ros.TransformException:
            return None
        vector = found.transform.translation
        return vector.x, vector.y, vector.z

    def send_transform(self, parent, child, translation):
        import tf2_ros

        message = self.message("geometry_msgs/msg/TransformStamped")
        message.header.stamp = self.node.get_clock().now().to_msg()
        message.header.frame_id, message.child_frame_id = parent, child
        vector = message.transform.translation
        vector.x, vector.y, vector.z = translation
        message.transform.rotation.w = 1.0
        tf2_ros.TransformBroadcaster(self.node).sendTransform(message)
