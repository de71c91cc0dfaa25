"""A node of rospy as it is written by hand, for scripts/describe_node.py to be asked about."""

import time

import actionlib
import rospy
import tf2_ros
from actionlib.msg import TestAction
from dynamic_reconfigure.server import Server
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64, String
from std_srvs.srv import SetBool

MODES = {
    "enum": [
        {
            "name": name,
            "type": "int",
            "value": value,
            "description": "",
            "srcline": 0,
            "srcfile": "",
        }
        for name, value in (("Slow", 1), ("Fast", 2))
    ]
}
PARAMETERS = [
    # name, type, its description, default, least, most
    ("gain", "double", "Gain of it", 1.5, 0.0, 2.5, ""),
    ("limit", "int", "", 7, 1, 2147483647, ""),
    ("mode", "int", "How fast", 2, -2147483648, 2147483647, str(MODES)),
    ("label", "str", "", "arm", "", "", ""),
    ("enabled", "bool", "", True, False, True, ""),
]
FIELDS = ("name", "type", "description", "default", "min", "max", "edit_method")


class Config:
    """What a .cfg file is compiled into."""

    _parameters = [{**dict(zip(FIELDS, each)), "level": 0} for each in PARAMETERS]  # noqa: B905
    config_description = {
        **{"name": "Default", "type": "", "state": True, "cstate": "true", "id": 0, "parent": 0},
        **{"parameters": _parameters, "groups": []},
    }
    min = {each["name"]: each["min"] for each in _parameters}
    max = {each["name"]: each["max"] for each in _parameters}
    defaults = {each["name"]: each["default"] for each in _parameters}
    level = {each["name"]: 0 for each in _parameters}
    type = {each["name"]: each["type"] for each in _parameters}
    all_level = 0


if __name__ == "__main__":
    rospy.init_node("plain")
    rospy.set_param("~axis/speed", 0.5)
    rospy.set_param("~frames", ["map", 'it\'s "here"'])
    rospy.set_param("~empty", [])
    state = rospy.Publisher("~state", String, queue_size=1, latch=True)
    speed = rospy.Publisher("speed", Float64, queue_size=1)
    rospy.Subscriber("/cmd_vel", Twist, print)
    rospy.Service("enable", SetBool, print)
    listener = tf2_ros.TransformListener(tf2_ros.Buffer())
    server = actionlib.SimpleActionServer("compute", TestAction, print, auto_start=False)
    server.start()
    client = actionlib.SimpleActionClient("/delegate", TestAction)
    reconfigured = Server(Config, lambda config, _: config)
    while not rospy.is_shutdown():
        speed.publish(0.5)
        time.sleep(0.1)
