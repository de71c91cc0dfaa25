"""A package moves from ROS 1 to ROS 2 and back with its logic in place, and runs on both."""

import shutil

import pytest

from support import ros
from support.packages import LOGIC, all_kinds, fill_in
from support.repository import EXAMPLES, commit, git
from support.ros import nodes


@pytest.mark.ros1
@pytest.mark.ros2
def test_there_and_back(ros1, ros2, ros1_interfaces, render, update, tmp_path, model):
    """The wheels of ROS 2 lack rclcpp, and for Python tf2_ros."""
    in_python = model == "python_model"
    spec = ros.fitting(ros2, all_kinds()) if in_python else all_kinds()
    options = ["tf"] if "<listener" in spec else []
    package = render(spec, model=model, ros_distro="noetic", name="src/all_kinds")
    logic = fill_in(package, model)
    files = git(package, "ls-files")
    update(package, ros_distro=ros2.distro)
    commit(package, "Move to ROS 2")
    assert (package / LOGIC[model]).read_text() == logic
    for gone in ("cfg", "scripts", "launch/all_kinds.launch", "test/nodes.test"):
        assert not (package / gone).exists(), gone
    if in_python or ros.has_package(ros2, "rclcpp"):
        ros2.build(tmp_path)
        with nodes(ros2, tmp_path, "all_kinds", "worker"):
            ros2.talk(tmp_path, "all_kinds", *options)
    for folder in ("build", "install", "log"):
        shutil.rmtree(tmp_path / folder, ignore_errors=True)
    update(package, ros_distro="noetic")
    commit(package, "Move to ROS 1")
    assert (package / LOGIC[model]).read_text() == logic
    assert git(package, "ls-files") == files
    assert git(package, "diff", "HEAD~2", "HEAD", "--stat") == ""
    ros1.build(tmp_path, ros1_interfaces)
    with ros.master(ros1), ros1.running("roslaunch all_kinds all_kinds.launch", tmp_path):
        ros1.talk(tmp_path, "all_kinds", *options)


@pytest.mark.parametrize("distro", ["humble", "rolling"])
def test_other_distribution_of_ros2(render, update, distro):
    """What differs between distributions follows, and nothing else."""
    package = render(EXAMPLES / "all_kinds.ros_package", ros_distro="jazzy", name="all_kinds")
    update(package, ros_distro=distro)
    changed = set(git(package, "diff", "--name-only").split())
    generated = (
        {"all_kinds/ros/managed_node.py", "all_kinds/worker_ros.py"}
        if distro == "humble"
        else set()
    )
    assert changed == {".copier-answers.yml"} | generated
