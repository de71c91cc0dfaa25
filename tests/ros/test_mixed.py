"""A package with a node in each language: built, tested, started; each node hears the other."""

import re

import pytest

from support import ros
from support.packages import DATA
from support.repository import EXAMPLES, git
from support.ros import wait_for

DRIVING = EXAMPLES / "driving.ros_package"
PARAMETERS = "{}speed_limit: 0.25\n"
# The planner asks for twice the limit; the controller obeys the limit, the planner hears so.
HEARD = (r"Asked for 0\.50*", r"Driving at 0\.25 ")


def alone(language):
    """Return the spec with the nodes of one language."""
    other = r'  <node (?:(?!</node>)[\s\S])*? language="(?!LANGUAGE)[\s\S]*?</node>\n'
    return re.sub(other.replace("LANGUAGE", language), "", DRIVING.read_text())


def build(ros_, put, workspace):
    """Build and test the package as it is made, fill in its logic, and build that."""
    put(DRIVING, "mixed_model", ros_.distro, workspace)
    check_tests(ros_, workspace, ros_.build(workspace))
    git(workspace / "src/driving", "apply", str(DATA / "logic/driving.patch"))
    ros_.build(workspace)


def check_tests(ros_, workspace, printed):
    assert "warning:" not in printed, printed
    results = ros_.test(workspace)
    assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", results), results
    return results


def check_nodes(ros_, workspace, command):
    """Start both nodes with one parameter file, and look for what each makes of the other's."""
    with ros_.running(f"{command} params_file:={workspace}/mine.yaml", workspace) as log:
        for text in HEARD:
            wait_for(text, log)
        assert "Traceback" not in log()


@pytest.mark.ros1
def test_both_nodes_in_ros1(ros1, put, tmp_path):
    build(ros1, put, tmp_path)
    lint = ros1.run("catkin_lint --strict -W1 .", tmp_path / "src/driving").stdout
    assert "found 0 problems" in lint, lint
    ros1.run("catkin_make install", tmp_path, tmp_path)
    for name in ("planner", "controller"):
        assert (tmp_path / "install/lib/driving" / name).exists()
    (tmp_path / "mine.yaml").write_text(PARAMETERS.format(""))
    with ros.master(ros1):
        check_nodes(ros1, tmp_path, "roslaunch driving driving.launch")


@pytest.mark.ros2
def test_both_nodes_in_ros2(ros2, put, tmp_path):
    for package in ("rclcpp", "launch_ros"):
        if not ros.has_package(ros2, package):
            pytest.skip(f"{package} is not installed")
    build(ros2, put, tmp_path)
    (tmp_path / "mine.yaml").write_text(PARAMETERS.format("/**:\n  ros__parameters:\n    "))
    launch = "ros2 launch driving driving.launch.xml"
    check_nodes(ros2, tmp_path, launch)
    check_nodes(ros2, tmp_path, f"{launch} composition:=true")


@pytest.mark.ros1
@pytest.mark.parametrize("language", ["python", "cpp"])
def test_one_language_alone_in_ros1(ros1, render, tmp_path, language):
    """A package that has no node in the other language yet, or any more."""
    render(alone(language), model="mixed_model", ros_distro="noetic", name="src/driving")
    check_tests(ros1, tmp_path, ros1.build(tmp_path))


@pytest.mark.ros2
def test_python_alone_in_ros2(ros2, render, tmp_path):
    """Built by CMake, without rclcpp; the node is a program like those of CMake."""
    render(alone("python"), model="mixed_model", ros_distro=ros2.distro, name="src/driving")
    check_tests(ros2, tmp_path, ros2.build(tmp_path))
    program = tmp_path / "install/driving/lib/driving/planner"
    with ros2.running(f"{program} --ros-args --log-level debug", tmp_path) as log:
        wait_for("publisher for topic name '/?target_speed'", log)
