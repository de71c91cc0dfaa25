"""The peer in ROS 2, written with rclpy alone."""

import contextlib
import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from common import TIMEOUT, Heard, Served, later, load, wait_for
from discovery import be_discovered
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.time import Time

TRANSITIONS = {"configure": 1, "cleanup": 2, "activate": 3, "deactivate": 4}
SHUTDOWN = {"unconfigured": 5, "inactive": 6, "active": 7}
RESULTS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "canceled",
    GoalStatus.STATUS_ABORTED: "aborted",
}


def profile(reliability="reliable", durability="volatile"):
    return QoSProfile(
        history=HistoryPolicy.KEEP_LAST,
        depth=1000,
        reliability=ReliabilityPolicy[reliability.upper()],
        durability=DurabilityPolicy[durability.upper()],
    )


class SafeActionClient(ActionClient):
    """rclpy shows a client to the executor, which takes its lock, before it has one."""

    _lock = threading.Lock()


class Peer:
    def __init__(self):
        rclpy.init()
        self.node = rclpy.create_node("peer")
        self.group = ReentrantCallbackGroup()
        self.executor = MultiThreadedExecutor(16)
        self.executor.add_node(self.node)
        threading.Thread(target=self.spin, daemon=True).start()
        self.subscriptions = {}
        self.publishers = {}
        self.clients = {}
        self.served = {}
        self.goals = {}
        self.lock = threading.Lock()

    def spin(self):
        with contextlib.suppress(ExternalShutdownException):
            self.executor.spin()

    def ready(self):
        return True

    def leave(self, namespace):
        """End what is still served there."""
        for name, served in self.served.items():
            if name.startswith(namespace + "/"):
                served.ended.set()

    # Topics
    def hear(self, topic, kind, **qos):
        heard = Heard()
        subscription = self.node.create_subscription(
            load(kind), topic, heard.take, profile(**qos), callback_group=self.group
        )
        self.subscriptions[topic] = heard, subscription

    def deafen(self, topic):
        self.node.destroy_subscription(self.subscriptions[topic][1])

    def heard(self, topic):
        return self.subscriptions[topic][0].messages

    def publish(self, topic, kind, data=None, wait=True, qos=None):
        with self.lock:
            if topic not in self.publishers:
                self.publishers[topic] = self.node.create_publisher(
                    load(kind), topic, profile(**qos or {}), callback_group=self.group
                )
        publisher = self.publishers[topic]
        if wait:
            wait_for(publisher.get_subscription_count, f"nobody hears {topic}")
        message = load(kind)()
        if data is not None:
            message.data = data
        publisher.publish(message)

    def publish_point(self, topic, seconds, value, wait=True):
        kind = load("geometry_msgs/msg/PointStamped")
        with self.lock:
            if topic not in self.publishers:
                self.publishers[topic] = self.node.create_publisher(
                    kind, topic, profile(), callback_group=self.group
                )
        if wait:
            wait_for(self.publishers[topic].get_subscription_count, f"nobody hears {topic}")
        message = kind()
        message.header.stamp = Time(nanoseconds=round(seconds * 1e9)).to_msg()
        message.point.x = value
        self.publishers[topic].publish(message)

    def clock(self, seconds):
        publisher = self.publishers.get("/clock")
        if publisher is None:
            publisher = self.node.create_publisher(load("rosgraph_msgs/msg/Clock"), "/clock", 10)
            self.publishers["/clock"] = publisher
        message = load("rosgraph_msgs/msg/Clock")()
        message.clock.sec, part = divmod(int(seconds * 1e9), 10**9)
        message.clock.nanosec = part
        publisher.publish(message)

    def transform(self, parent, child, x):
        publisher = self.publishers.get("/tf_static")
        if publisher is None:
            publisher = self.node.create_publisher(
                load("tf2_msgs/msg/TFMessage"),
                "/tf_static",
                profile(durability="transient_local"),
            )
            self.publishers["/tf_static"] = publisher
        message = load("geometry_msgs/msg/TransformStamped")()
        message.header.stamp = self.node.get_clock().now().to_msg()
        message.header.frame_id, message.child_frame_id = parent, child
        message.transform.translation.x = x
        message.transform.rotation.w = 1.0
        publisher.publish(load("tf2_msgs/msg/TFMessage")(transforms=[message]))

    # Services
    def request(self, service, kind, timeout=TIMEOUT, **fields):
        type_ = load(kind)
        with self.lock:
            client = self.clients.get(service)
            if client is None:
                client = self.node.create_client(type_, service, callback_group=self.group)
                self.clients[service] = client
        assert client.wait_for_service(timeout), f"no service {service}"
        be_discovered(self.node, service)
        future = client.call_async(type_.Request(**fields))
        wait_for(future.done, f"no answer: {service}", timeout)
        return future.result()

    def burst(self, service, count):
        """Send many requests at once, and wait until all are answered."""
        type_ = load("std_srvs/srv/Trigger")
        client = self.node.create_client(
            type_, service, qos_profile=profile(), callback_group=self.group
        )
        assert client.wait_for_service(TIMEOUT), f"no service {service}"
        be_discovered(self.node, service)
        answers = [client.call_async(type_.Request()) for _ in range(count)]
        wait_for(lambda: all(answer.done() for answer in answers), f"no answer: {service}")

    def call(self, service, timeout=TIMEOUT):
        return self.request(service, "std_srvs/srv/Trigger", timeout).message

    def serve(self, service, seconds=0.0):
        served = Served(seconds)

        def answer(_request, response):
            served.note("request", time.monotonic())
            served.work(served.ended.is_set)
            response.success, response.message = True, "yes"
            return response

        type_ = load("std_srvs/srv/Trigger")
        self.node.create_service(type_, service, answer, callback_group=self.group)
        self.served[service] = served

    # Actions
    def serve_action(self, action, seconds=0.0, feedback=0, answer_after=0.0):
        type_ = load("test_msgs/action/Fibonacci")
        served = Served(seconds, feedback)

        def execute(handle):
            served.note("goal", handle.request.order)
            if feedback:
                handle.publish_feedback(type_.Feedback(sequence=list(range(feedback))))
            if served.work(lambda: handle.is_cancel_requested or served.ended.is_set()):
                handle.succeed()
                served.note("succeeded", handle.request.order)
            else:
                handle.canceled() if handle.is_cancel_requested else handle.abort()
                served.note("canceled", handle.request.order)
            return type_.Result(sequence=[handle.request.order])

        ActionServer(
            self.node,
            type_,
            action,
            execute,
            goal_callback=later(answer_after, lambda _request: GoalResponse.ACCEPT),
            cancel_callback=lambda _handle: CancelResponse.ACCEPT,
            callback_group=self.group,
        )
        self.served[action] = served

    def served_log(self, name):
        return self.served[name].log

    def goal(self, action, order):
        """Send a goal; return its number, or nothing if it is rejected."""
        type_ = load("test_msgs/action/Fibonacci")
        with self.lock:
            client = self.clients.get(action)
            if client is None:
                client = SafeActionClient(self.node, type_, action, callback_group=self.group)
                self.clients[action] = client
        assert client.wait_for_server(TIMEOUT), f"no action {action}"
        be_discovered(self.node, f"{action}/_action/send_goal")
        future = client.send_goal_async(type_.Goal(order=order))
        wait_for(future.done, "the goal was not answered")
        handle = future.result()
        if not handle.accepted:
            return None
        with self.lock:
            number = len(self.goals) + 1
            self.goals[number] = handle, handle.get_result_async()
        return number

    def repeat_goal(self, action, order):
        """Send a goal with the id of the last one, as another client."""
        type_ = load("test_msgs/action/Fibonacci")
        with self.lock:
            client = SafeActionClient(self.node, type_, action, callback_group=self.group)
            self.clients[action, len(self.clients)] = client
            handle, _ = self.goals[len(self.goals)]
        assert client.wait_for_server(TIMEOUT), f"no action {action}"
        client.send_goal_async(type_.Goal(order=order), goal_uuid=handle.goal_id)
        time.sleep(1.0)

    def is_accepted(self, number):
        return self.goals[number][0].accepted

    def cancel(self, number):
        self.goals[number][0].cancel_goal_async()

    def result(self, number, timeout=TIMEOUT):
        future = self.goals[number][1]
        wait_for(future.done, "the goal does not end", timeout)
        answer = future.result()
        return [RESULTS[answer.status], list(answer.result.sequence)]

    # The node
    def state(self, node):
        answer = self.request(f"{node}/get_state", "lifecycle_msgs/srv/GetState")
        return answer.current_state.label

    def change_state(self, node, transition, timeout=30.0):
        number = TRANSITIONS.get(transition) or SHUTDOWN[self.state(node)]
        return self.request(
            f"{node}/change_state",
            "lifecycle_msgs/srv/ChangeState",
            timeout,
            transition=load("lifecycle_msgs/msg/Transition")(id=number),
        ).success

    def set_parameter(self, node, name, value):
        answer = self.request(
            f"{node}/set_parameters",
            "rcl_interfaces/srv/SetParameters",
            parameters=[Parameter(name, value=value).to_parameter_msg()],
        )
        return answer.results[0].successful

    def set_unknown_parameter(self, node, name):
        """Set a parameter to a value of a type that ROS does not know."""
        parameter = Parameter(name, value=0).to_parameter_msg()
        parameter.value.type = 99
        with contextlib.suppress(AssertionError):  # it may not be answered
            self.request(
                f"{node}/set_parameters",
                "rcl_interfaces/srv/SetParameters",
                timeout=2.0,
                parameters=[parameter],
            )

    def set_parameters_atomically(self, node, values):
        answer = self.request(
            f"{node}/set_parameters_atomically",
            "rcl_interfaces/srv/SetParametersAtomically",
            parameters=[Parameter(name, value=values[name]).to_parameter_msg() for name in values],
        )
        return answer.result.successful

    def load_node(self, container, package, plugin, namespace, parameters):
        answer = self.request(
            f"{container}/_container/load_node",
            "composition_interfaces/srv/LoadNode",
            package_name=package,
            plugin_name=plugin,
            node_namespace=namespace,
            parameters=[
                Parameter(name, value=value).to_parameter_msg()
                for name, value in parameters.items()
            ],
        )
        assert answer.success, answer.error_message
        return answer.unique_id

    def unload_node(self, container, number):
        return self.request(
            f"{container}/_container/unload_node",
            "composition_interfaces/srv/UnloadNode",
            30.0,
            unique_id=number,
        ).success

    def graph(self, namespace):
        """Return how many publishers, subscriptions, services and clients nodes there have."""
        count = 0
        for name, space in self.node.get_node_names_and_namespaces():
            if space == namespace:
                for kind in ("publisher", "subscriber", "service", "client"):
                    find = getattr(self.node, f"get_{kind}_names_and_types_by_node")
                    count += len(find(name, space))
        return count
