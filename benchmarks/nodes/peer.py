"""Talks to the measured nodes, as a program of its own tells it on stdin, in ROS 1 or ROS 2."""

import array
import json
import os
import sys
import threading
import time

LIMIT = 60  # seconds


class Ros1:
    def __init__(self):
        import actionlib
        import rospy
        from std_msgs.msg import Float64, Float64MultiArray
        from std_srvs.srv import SetBool
        from test_msgs.msg import FibonacciAction, FibonacciGoal

        rospy.init_node("peer", disable_signals=True)
        self.rospy, self.tick = rospy, Float64
        self.publisher = rospy.Publisher("values", Float64MultiArray, queue_size=10)
        self.message = Float64MultiArray()
        self.set = rospy.ServiceProxy("set", SetBool)
        self.action = actionlib.ActionClient("compute", FibonacciAction)
        self.done = actionlib.CommState.DONE
        self.goal = FibonacciGoal(order=1)

    def hear(self, callback):
        self.subscriber = self.rospy.Subscriber("tick", self.tick, callback, queue_size=1)

    def unhear(self):
        self.subscriber.unregister()

    def listeners(self):
        return self.publisher.get_num_connections()

    def fill(self, size):
        self.message.data = [0.0] * size

    def serve(self):
        self.set.wait_for_service()
        self.action.wait_for_server()

    def call(self):
        self.set(True)

    def send_goal(self):
        # actionlib 1.14's SimpleActionClient waits forever for a result that comes at once.
        done = threading.Event()
        goal = self.action.send_goal(
            self.goal, lambda sent: done.set() if sent.get_comm_state() == self.done else None
        )
        assert done.wait(LIMIT), goal


class Ros2:
    def __init__(self):
        import rclpy
        from rclpy.action import ActionClient
        from std_msgs.msg import Float64, Float64MultiArray
        from std_srvs.srv import SetBool
        from test_msgs.action import Fibonacci

        rclpy.init()
        self.node = rclpy.create_node("peer")
        self.spin, self.tick = rclpy.spin_until_future_complete, Float64
        self.spin_once = rclpy.spin_once
        self.publisher = self.node.create_publisher(Float64MultiArray, "values", 10)
        self.message = Float64MultiArray()
        self.set, self.request = self.node.create_client(SetBool, "set"), SetBool.Request()
        self.action = ActionClient(self.node, Fibonacci, "compute")
        self.goal = Fibonacci.Goal(order=1)

    def hear(self, callback):
        self.subscription = self.node.create_subscription(self.tick, "tick", callback, 1)

    def unhear(self):
        self.node.destroy_subscription(self.subscription)

    def listeners(self):
        return self.publisher.get_subscription_count()

    def fill(self, size):
        self.message.data = array.array("d", bytes(8 * size))

    def serve(self):
        self.set.wait_for_service()
        self.action.wait_for_server()

    def call(self):
        self.spin(self.node, self.set.call_async(self.request))

    def send_goal(self):
        sent = self.action.send_goal_async(self.goal)
        self.spin(self.node, sent)
        self.spin(self.node, sent.result().get_result_async())


def first(peer):
    """Say that it listens, and return when the first message came."""
    came = []
    heard = threading.Event()

    def hear(_):
        came.append(time.monotonic())
        heard.set()

    peer.hear(hear)
    print("null", flush=True)
    while not heard.is_set():
        peer.spin_once(peer.node, timeout_sec=0.1) if hasattr(peer, "node") else heard.wait(0.1)
    peer.unhear()
    return came[0]


def send(peer, size, rate, seconds):
    """
    Send messages whose first value is when they were sent.

    They come at all moments of a cycle of 1 ms alike: multiples of the golden ratio leave no gap.
    """
    while not peer.listeners():
        time.sleep(0.01)
    peer.fill(size)
    time.sleep(0.2)
    start = time.monotonic()
    for number in range(int(rate * seconds)):
        due = start + number / rate + number * 0.618034 % 1 * 1e-3
        time.sleep(max(0.0, due - time.monotonic()))
        peer.message.data[0] = time.monotonic()
        peer.publisher.publish(peer.message)
    time.sleep(0.05)
    return int(rate * seconds)


def repeat(peer, what, count):
    """Return the seconds of calls, or of goals."""
    peer.serve()
    taken = []
    for _ in range(count):
        start = time.monotonic()
        getattr(peer, what)()
        taken.append(time.monotonic() - start)
        time.sleep(0.002)
    return taken


def main():
    peer = Ros1() if os.environ["ROS_VERSION"] == "1" else Ros2()
    for line in sys.stdin:
        name, *arguments = json.loads(line)
        print(json.dumps(globals()[name](peer, *arguments)), flush=True)
    os._exit(0)


main()
