"""A package's tests lose nothing where the publishers of its node are late to connect."""

import dataclasses

import pytest

from support import ros
from support.packages import DATA

SPEC = """
<package name="mypkg" author="A" author_email="a@b.example.org" description="d" license="MIT">
  <node name="drive" frequency="50" diagnostics="true">
    <actionServer name="turn" type="actionlib/Test"/>
    <actionClient name="move" type="actionlib/Test"/>
    <publisher name="speed" type="std_msgs/Float64"/>
    <directPublisher name="state" type="std_msgs/String"/>
    <broadcaster name="pose"/>
  </node>
</package>
"""


@pytest.mark.ros1
def test_what_publishers_send(ros1, render, tmp_path):
    """Rospy tells a subscriber that it is connected before the publisher sends to it."""
    package = render(SPEC, ros_distro="noetic")
    own = dataclasses.replace(ros1, environment=ros.ros1().environment)
    path = f"PYTHONPATH={DATA}/late:{package}:$PYTHONPATH"
    command = f"env {path} {own.python} -m unittest test_drive_node"
    with ros.master(own, "rosmaster"):
        printed = own.run(command, package / "test", check=False).stdout
    assert printed.endswith("\nOK\n"), printed
