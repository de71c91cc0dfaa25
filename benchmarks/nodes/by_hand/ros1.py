"""The two nodes for ROS 1 as its tutorials write them, in Python."""

import sys

import actionlib
import rospy
from bench.record import Record
from std_msgs.msg import Float64, Float64MultiArray
from std_srvs.srv import SetBool, SetBoolResponse
from test_msgs.msg import FibonacciAction, FibonacciResult


class Relay:
    """Keeps the latest message for the next cycle."""

    def __init__(self):
        self.record = Record()
        self.values = None
        self.tick = rospy.Publisher("tick", Float64, queue_size=10)
        rospy.Subscriber("values", Float64MultiArray, self.receive, queue_size=10)

    def receive(self, message):
        self.values = message

    def run(self):
        rate = rospy.Rate(1000)
        while not rospy.is_shutdown():
            self.update()
            try:
                rate.sleep()
            except rospy.ROSInterruptException:
                return

    def update(self):
        values, self.values = self.values, None
        if values is not None:
            self.record.message(values.data[0])
        self.tick.publish(Float64(self.record.cycle()))


class Server:
    """Has callbacks alone."""

    def __init__(self):
        self.record = Record()
        rospy.Subscriber("values", Float64MultiArray, self.receive, queue_size=10)
        rospy.Service("set", SetBool, self.serve)
        self.action = actionlib.SimpleActionServer(
            "compute",
            FibonacciAction,
            self.execute,
            auto_start=False,
        )
        self.action.start()

    def receive(self, message):
        self.record.message(message.data[0])

    def serve(self, request):
        return SetBoolResponse(success=request.data)

    def execute(self, goal):
        self.action.set_succeeded(FibonacciResult(sequence=[goal.order]))

    def run(self):
        rospy.spin()


rospy.init_node(sys.argv[1])
node = {"relay": Relay, "server": Server}[sys.argv[1]]()
node.run()
node.record.save()
