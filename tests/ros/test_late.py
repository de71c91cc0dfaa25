"""A package's tests pass where its node is late: ready, but not for everything yet."""

import dataclasses

import pytest

from support import ros
from support.packages import DATA

SPEC = """
<package name="mypkg" author="A" author_email="a@b.example.org" description="d" license="MIT">
  <node name="drive" frequency="50" diagnostics="true">
    <actionServer name="turn" type="ACTIONS"/>
    <actionClient name="move" type="ACTIONS"/>
    <publisher name="speed" type="std_msgs/Float64"/>
    <directPublisher name="state" type="std_msgs/String"/>
  </node>
</package>
"""


def run_tests(ros_, package):
    path = f"PYTHONPATH={DATA}/late/ros{ros_.environment['ROS_VERSION']}:{package}:$PYTHONPATH"
    command = f"env {path} {ros_.python} -m unittest test_drive_node"
    printed = ros_.run(command, package / "test").stdout
    # A timer of actionlib 1.14.0 may print a traceback after it, as the process ends.
    assert "OK" in printed.splitlines(), printed


@pytest.mark.ros1
def test_late_connections(ros1, render):
    """Rospy connects subscribers before the publisher sends to them, and may lose a publisher."""
    spec = SPEC.replace("ACTIONS", "actionlib/Test")
    more = '<broadcaster name="pose"/><directSubscriber name="say" type="std_msgs/String"/>'
    spec = spec.replace("</node>", f"{more}</node>")
    package = render(spec, ros_distro="noetic")
    own = dataclasses.replace(ros1, environment=ros.ros1().environment)
    with ros.master(own, "rosmaster"):
        run_tests(own, package)


@pytest.mark.ros2
def test_late_activation(ros2, render):
    """A node that is inactive offers its actions and services, and reports its state."""
    package = render(SPEC.replace("ACTIONS", "test_msgs/action/Fibonacci"), ros_distro="kilted")
    run_tests(ros2, package)
