"""The launch files take what people expect: namespace, params_file, autostart, ..."""

import re

import pytest
import yaml

from support import ros
from support.packages import MODELS
from support.ros import wait_for

SPEC = """<package name="arm" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="reach" frequency="10">
    <parameter name="limit" type="int" value="3"/>
    <publisher name="pose" type="std_msgs::Float64" history="keep_all"/>
    <publisher name="speed" type="std_msgs::Float64"/>
  </node>
  <node name="watch" frequency="5">
    <subscriber name="pose" type="std_msgs::Float64"/>
    <subscriber name="speed" type="std_msgs::Float64"/>
  </node>
</package>
"""
# What watch says of a cycle with messages of both topics.
EMPTY = """  [[maybe_unused]] WatchData & data,
  [[maybe_unused]] const WatchConfig & config)
{
}"""
WRITTEN = """  WatchData & data,
  [[maybe_unused]] const WatchConfig & config)
{
  if (data.in_pose_updated && data.in_speed_updated) {
    passthrough_.log.info("Both are new");
  }
}"""
each_model = pytest.mark.parametrize("model", MODELS, scope="module")


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


@pytest.fixture(scope="module")
def arm(put, model, tmp_path_factory):
    """A workspace of ROS 2 with the package; in C++ one of its nodes says what it receives."""
    ros2 = ros.ros2() or pytest.skip(ros.NO_ROS2)
    if not ros.has(ros2, "launch_ros"):
        pytest.skip("launch_ros is not installed")
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    workspace = tmp_path_factory.mktemp("launch")
    spec = workspace / "arm.ros_package"
    spec.write_text(SPEC)
    put(spec, model, ros2.distro, workspace)
    for logic in workspace.glob("src/arm/src/watch_impl.cpp"):
        assert EMPTY in logic.read_text()
        logic.write_text(logic.read_text().replace(EMPTY, WRITTEN))
    ros2.run(f"{ros2.build_command} --cmake-args -DBUILD_TESTING=OFF", workspace, timeout=1800)
    return workspace


@pytest.mark.ros2
@each_model
def test_arguments_in_ros2(ros2, arm, tmp_path):
    def run(command):
        return ros2.run(command, tmp_path, arm, check=False).stdout

    get = "ros2 param get {} {} --no-daemon"
    with ros2.running("ros2 launch arm arm.launch.xml", arm):
        wait_for("is: 3", lambda: run(get.format("/reach", "limit")))
        wait_for("is: False", lambda: run(get.format("/watch", "use_sim_time")))
        wait_for("is: True", lambda: run(get.format("/watch", "autostart")))
        wait_for("^active", lambda: run("ros2 lifecycle get /reach --no-daemon"))
    with ros2.running("ros2 launch arm arm.launch.xml autostart:=false", arm):
        wait_for("^unconfigured", lambda: run("ros2 lifecycle get /reach --no-daemon"))
        wait_for("^unconfigured", lambda: run("ros2 lifecycle get /watch --no-daemon"))
    (tmp_path / "mine.yaml").write_text(
        "/**:\n  ros__parameters:\n    limit: 7\n    autostart: false\n"
    )
    arguments = f"namespace:=left use_sim_time:=true params_file:={tmp_path}/mine.yaml"
    with ros2.running(f"ros2 launch arm arm.launch.xml log_level:=debug {arguments}", arm) as log:
        wait_for("is: 7", lambda: run(get.format("/left/reach", "limit")))
        wait_for("is: True", lambda: run(get.format("/left/watch", "use_sim_time")))
        wait_for("is: False", lambda: run(get.format("/left/watch", "autostart")))
        wait_for(r"\[DEBUG\]", log)


@pytest.mark.ros2
@pytest.mark.parametrize("model", ["cpp_model"], scope="module")
def test_composition(ros2, arm, tmp_path):
    """One process, with the names, parameters and lifecycle that the nodes have alone.

    rclcpp does not hand on `pose` within a process, for it is keep_all; `speed` it does.
    """
    (tmp_path / "mine.yaml").write_text("/**:\n  ros__parameters:\n    limit: 7\n")
    launch = f"ros2 launch arm arm.launch.xml composition:=true params_file:={tmp_path}/mine.yaml"

    def run(command):
        return ros2.run(f"{command} --no-daemon", tmp_path, arm, check=False).stdout

    with ros2.running(f"{launch} namespace:=left", arm) as log:
        wait_for("Both are new", log)
        wait_for("^active", lambda: run("ros2 lifecycle get /left/reach"))
        wait_for("is: 7", lambda: run("ros2 param get /left/reach limit"))
    started = re.findall(r"\[(\S+)\]: process started", log())
    assert started == ["component_container_isolated-1"]
    assert "process has finished cleanly" in log()
    assert not re.search(r"\[(WARN|ERROR|FATAL)\]", log()), log()
    with ros2.running(f"{launch} autostart:=false", arm) as log:
        wait_for("^unconfigured", lambda: run("ros2 lifecycle get /reach"))
        wait_for("^unconfigured", lambda: run("ros2 lifecycle get /watch"))
    assert "process has finished cleanly" in log()
