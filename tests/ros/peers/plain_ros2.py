"""A node of rclpy as it is written by hand, for scripts/describe_node.py to be asked about."""

import contextlib

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.action import ActionClient, ActionServer
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Float64, String
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci


class Plain(Node):
    def __init__(self):
        super().__init__("plain")
        range_ = FloatingPointRange(from_value=0.0, to_value=2.5)
        about = ParameterDescriptor(description='"Gain" <of> it', floating_point_range=[range_])
        self.declare_parameter("axis.gain", 1.5, about)
        steps = IntegerRange(from_value=1, to_value=9)
        self.declare_parameter("steps", 3, ParameterDescriptor(integer_range=[steps]))
        self.declare_parameter("frames", ["map", 'it\'s "here"'])
        self.declare_parameter("weights", [0.5, 1.0])
        self.declare_parameter("enabled", True)
        self.declare_parameter("label", "")
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_publisher(String, "~/state", latched)
        timed = QoSProfile(
            depth=5,
            reliability=ReliabilityPolicy.BEST_EFFORT,
            deadline=Duration(seconds=0.5),
            lifespan=Duration(seconds=2),
            liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
            liveliness_lease_duration=Duration(seconds=3),
        )
        self.create_publisher(Float64, "speed", timed)
        self.create_subscription(Twist, "/cmd_vel", print, 10)
        self.create_service(SetBool, "enable", lambda _, response: response)
        self.client = self.create_client(Trigger, "permit")
        self.server = ActionServer(self, Fibonacci, "compute", print)
        self.sender = ActionClient(self, Fibonacci, "/delegate")


if __name__ == "__main__":
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Plain())
