"""The two nodes for ROS 2 as its tutorials write them, in Python."""

import contextlib
import sys

import rclpy
from bench.record import Record
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action import ActionServer
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float64, Float64MultiArray
from std_srvs.srv import SetBool
from test_msgs.action import Fibonacci


class Relay(Node):
    """Keeps the latest message for the next cycle."""

    def __init__(self):
        super().__init__("relay")
        self.record = Record()
        self.values = None
        self.tick = self.create_publisher(Float64, "tick", 10)
        self.create_subscription(Float64MultiArray, "values", self.receive, 10)
        self.create_timer(0.001, self.update)

    def receive(self, message):
        self.values = message

    def update(self):
        if self.values is not None:
            self.record.message(self.values.data[0])
            self.values = None
        self.tick.publish(Float64(data=self.record.cycle()))


class Server(Node):
    """Has callbacks alone."""

    def __init__(self):
        super().__init__("server")
        self.record = Record()
        self.create_subscription(Float64MultiArray, "values", self.receive, 10)
        self.create_service(SetBool, "set", self.serve)
        self.action = ActionServer(self, Fibonacci, "compute", self.execute)

    def receive(self, message):
        self.record.message(message.data[0])

    def serve(self, request, response):
        response.success = request.data
        return response

    def execute(self, goal):
        goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])


rclpy.init()
node = {"relay": Relay, "server": Server}[sys.argv[1]]()
# rclpy 9.1 raises RCLError where the signal comes between two waits.
with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException, RCLError):
    rclpy.spin(node)
node.record.save()
