"""The launch files take what people expect: namespace, use_sim_time, params_file, log_level."""

import re
import time

import pytest
import yaml

from support import ros
from support.packages import MODELS

SPEC = """<package name="arm" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="reach" frequency="10">
    <parameter name="limit" type="int" value="3"/>
    <publisher name="pose" type="std_msgs::Float64"/>
  </node>
  <node name="watch" frequency="5"><subscriber name="pose" type="std_msgs::Float64"/></node>
</package>
"""
each_model = pytest.mark.parametrize("model", MODELS)


def wait_for(text, look):
    """Look until a text is there, and return all that was seen."""
    end = time.monotonic() + 30
    while not re.search(text, seen := look()):
        assert time.monotonic() < end, f"no {text} in {seen}"
        time.sleep(0.2)
    return seen


@pytest.mark.ros1
@each_model
def test_arguments_in_ros1(ros1, render, tmp_path, model):
    render(SPEC, model=model, ros_distro="noetic", name="src/arm")
    ros1.build(tmp_path)
    (tmp_path / "mine.yaml").write_text("limit: 7\n")

    def run(command):
        return ros1.run(command, tmp_path, tmp_path).stdout

    assert run("roslaunch arm arm.launch --nodes").split() == ["/reach", "/watch"]
    found = run("roslaunch arm arm.launch --nodes namespace:=left").split()
    assert found == ["/left/reach", "/left/watch"]
    parameters = yaml.safe_load(run("roslaunch arm arm.launch --dump-params"))
    assert parameters["/reach/limit"] == 3
    assert "/use_sim_time" not in parameters
    arguments = f"namespace:=left use_sim_time:=true params_file:={tmp_path}/mine.yaml"
    parameters = yaml.safe_load(run(f"roslaunch arm arm.launch --dump-params {arguments}"))
    assert parameters["/left/reach/limit"] == 7
    assert parameters["/use_sim_time"] is True
    command = "roslaunch arm arm.launch namespace:=left log_level:=error"
    with ros.master(ros1), ros1.running(command, tmp_path):
        service = "/left/reach/get_loggers"
        wait_for(service, lambda: run("rosservice list"))
        loggers = run(f"rosservice call {service}")
        name = "rosout" if model == "python_model" else "ros.arm"
        level = re.search(rf'name: "?{re.escape(name)}"?\s+level: "?(\w+)', loggers)
        assert level, loggers
        assert level[1].lower() == "error"


@pytest.mark.ros2
@each_model
def test_arguments_in_ros2(ros2, render, tmp_path, model):
    if not ros.has(ros2, "launch_ros"):
        pytest.skip("launch_ros is not installed")
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    render(SPEC, model=model, ros_distro=ros2.distro, name="src/arm")
    ros2.build(tmp_path)
    (tmp_path / "mine.yaml").write_text("/**:\n  ros__parameters:\n    limit: 7\n")

    def run(command):
        return ros2.run(command, tmp_path, tmp_path, check=False).stdout

    get = "ros2 param get {} {} --no-daemon"
    with ros2.running("ros2 launch arm arm.launch.xml", tmp_path):
        wait_for("is: 3", lambda: run(get.format("/reach", "limit")))
        wait_for("is: False", lambda: run(get.format("/watch", "use_sim_time")))
    arguments = f"namespace:=left use_sim_time:=true params_file:={tmp_path}/mine.yaml"
    with ros2.running(
        f"ros2 launch arm arm.launch.xml log_level:=debug {arguments}", tmp_path
    ) as log:
        wait_for("is: 7", lambda: run(get.format("/left/reach", "limit")))
        wait_for("is: True", lambda: run(get.format("/left/watch", "use_sim_time")))
        wait_for(r"\[DEBUG\]", log)
