"""A package with nodes and the messages, services and actions that they talk by."""

import re

import pytest

from support import ros
from support.packages import DATA, MODELS

GRIPPER = DATA / "gripper.ros_package"
USER = {
    1: """
#include <gripper/CloseAction.h>
#include <gripper/Grip.h>
int main() {return gripper::CloseGoal{}.wanted.force < gripper::Grip::FIRM ? 0 : 1;}
""",
    2: """
#include <gripper/action/close.hpp>
#include <gripper/msg/grip.hpp>
int main() {return gripper::action::Close::Goal{}.wanted.force < gripper::msg::Grip::FIRM ? 0 : 1;}
""",
}
CMAKE = """
cmake_minimum_required(VERSION 3.16)
project(user)
find_package(gripper REQUIRED)
add_executable(user user.cpp)
"""
LIBRARIES = {
    1: "target_include_directories(user PRIVATE ${gripper_INCLUDE_DIRS})\n",
    2: "target_link_libraries(user ${gripper_TARGETS})\n",
}


def check(ros_, workspace):
    """Build and test the package, and use its types in another one."""
    printed = ros_.build(workspace)
    assert "warning:" not in printed, printed
    results = ros_.test(workspace)
    assert re.search(r"Summary: [1-9]\d+ tests, 0 errors, 0 failures, 0 skipped", results), results
    version, folder = int(ros_.environment["ROS_VERSION"]), workspace / "user"
    (folder / "build").mkdir(parents=True)
    (folder / "user.cpp").write_text(USER[version])
    (folder / "CMakeLists.txt").write_text(CMAKE + LIBRARIES[version])
    ros_.run("cmake ..", folder / "build", workspace)
    ros_.run("make", folder / "build", workspace)
    ros_.run("./user", folder / "build", workspace)


@pytest.mark.ros1
@pytest.mark.parametrize("model", [*MODELS, "mixed_model"])
def test_in_ros1(ros1, put, tmp_path, model):
    spec = GRIPPER
    if model == "mixed_model":
        text = GRIPPER.read_text()
        node = re.search("  <node.*</node>\n", text, re.DOTALL)[0]
        other = node.replace('"gripper" f', '"watcher" language="python" f', 1)
        spec = tmp_path / GRIPPER.name
        spec.write_text(text.replace(node, node.replace(" f", ' language="cpp" f', 1) + other))
    put(spec, model, ros1.distro, tmp_path)
    lint = ros1.run("catkin_lint --strict -W1 .", tmp_path / "src/gripper").stdout
    assert "found 0 problems" in lint, lint
    ros1.run("xmllint --noout package.xml", tmp_path / "src/gripper")
    check(ros1, tmp_path)


@pytest.mark.ros2
def test_in_ros2(ros2, put, tmp_path):
    if not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed; a package with Python has no types of its own")
    put(GRIPPER, "cpp_model", ros2.distro, tmp_path)
    check(ros2, tmp_path)
