"""A peer in ROS 2, written with rclpy alone."""

import contextlib
import importlib
import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from discovery import be_discovered
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

TIMEOUT = 30.0
TRANSITIONS = {"configure": 1, "cleanup": 2, "activate": 3, "deactivate": 4}
RESULTS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "canceled",
    GoalStatus.STATUS_ABORTED: "aborted",
}


def load(type_name):
    package, folder, name = type_name.split("/")
    return getattr(importlib.import_module(f"{package}.{folder}"), name)


def wait_for(condition, what):
    end = time.monotonic() + TIMEOUT
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(0.002)


def result_of(future, what):
    wait_for(future.done, what)
    return future.result()


def profile(depth, policies):
    """Return a QoS profile with policies given in words: durability="transient_local"."""
    enums = {"durability": DurabilityPolicy, "reliability": ReliabilityPolicy}
    given = {name: enums[name][word.upper()] for name, word in policies.items()}
    return QoSProfile(depth=depth, **given)


class Goal:
    def __init__(self, client, goal):
        self.feedback = []
        future = client.send_goal_async(
            goal, feedback_callback=lambda message: self.feedback.append(message.feedback)
        )
        self.handle = result_of(future, "the goal was not answered")
        assert self.handle.accepted, "the goal was rejected"

    def cancel(self):
        self.handle.cancel_goal_async()

    def answer(self):
        """Wait for the end; return the outcome and the message of the result."""
        answer = result_of(self.handle.get_result_async(), "the goal does not end")
        return RESULTS[answer.status], answer.result

    def result(self):
        """Wait for the end; return the outcome and the sequence of the result."""
        outcome, result = self.answer()
        return outcome, list(getattr(result, "sequence", []))


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
        self.clients = {}
        self.buffer = None

    def spin(self):
        with contextlib.suppress(ExternalShutdownException):
            self.executor.spin()

    def close(self):
        rclpy.try_shutdown()
        self.thread.join(TIMEOUT)

    def message(self, type_name, **fields):
        return load(type_name)(**fields)

    def hear(self, topic, type_name, **policies):
        heard = []
        self.node.create_subscription(
            load(type_name),
            topic,
            heard.append,
            profile(50, policies),
            callback_group=self.group,
        )
        return heard

    def publisher(self, topic, type_name, **policies):
        qos = profile(10, policies)
        return Publisher(self.node.create_publisher(load(type_name), topic, qos))

    def offered(self, topic):
        """Return reliability and durability of the publishers of a topic."""
        found = self.node.get_publishers_info_by_topic(topic)
        profiles = [item.qos_profile for item in found]
        return [(qos.reliability.name, qos.durability.name) for qos in profiles]

    def call(self, service, type_name, reliability="reliable", **fields):
        type_ = load(type_name)
        client = self.clients.get(service)
        if client is None:
            qos = profile(10, {"reliability": reliability})
            client = self.node.create_client(
                type_, service, qos_profile=qos, callback_group=self.group
            )
            assert client.wait_for_service(TIMEOUT), f"no service {service}"
            be_discovered(self.node, service)
            self.clients[service] = client
        assert client.wait_for_service(TIMEOUT), f"no service {service}"
        return result_of(client.call_async(type_.Request(**fields)), f"no answer: {service}")

    def serve(self, service, type_name, **fields):
        type_ = load(type_name)
        self.node.create_service(
            type_, service, lambda request, response: type_.Response(**fields)
        )

    def goal(self, action, type_name, **fields):
        type_ = load(type_name)
        return Goal(self.action_client(action, type_), type_.Goal(**fields))

    def action_client(self, action, type_):
        """Make a client, once, in the thread that spins: it could see one that is half made."""
        if action not in self.clients:
            task = self.executor.create_task(
                ActionClient, self.node, type_, action, callback_group=self.group
            )
            client = self.clients[action] = result_of(task, "no action client was made")
            assert client.wait_for_server(TIMEOUT), "no action server"
            be_discovered(self.node, f"{action}/_action/send_goal")
        return self.clients[action]

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

    def refusal(self, node, name, value):
        """Try to set a parameter; return why that is refused, and nothing if it is not."""
        parameter = Parameter(name, value=value).to_parameter_msg()
        answer = self.call(
            f"{node}/set_parameters", "rcl_interfaces/srv/SetParameters", parameters=[parameter]
        )
        result = answer.results[0]
        assert result.successful or result.reason
        return "" if result.successful else result.reason

    def set_parameter(self, node, name, value):
        return not self.refusal(node, name, value)

    def refuses(self, node, name, value, limit):
        """Check that a value beyond a limit is refused, and so are wrong types and statics."""
        before = self.get_parameter(node, name)
        assert not self.set_parameter(node, name, value), f"{name} = {value} was accepted"
        assert not self.set_parameter(node, name, "text"), f"{name} = text was accepted"
        assert not self.set_parameter(node, "prefix", "text"), "a static parameter was set"
        assert self.get_parameter(node, name) == before

    def state(self, node):
        return self.call(f"{node}/get_state", "lifecycle_msgs/srv/GetState").current_state.label

    def wait_until_active(self, node):
        """Wait until a node that starts takes goals and answers services."""
        wait_for(lambda: self.state(node) == "active", f"{node} does not become active")

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
