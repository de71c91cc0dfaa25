"""The models in ROS 1: packages built by catkin, started by roslaunch, talked to by rospy."""

import re
import xml.etree.ElementTree as ET

import pytest

from support import ros
from support.packages import LOGIC, add_volume, all_kinds, fill_in, use_volume

pytestmark = pytest.mark.ros1


def launch_and_talk(ros1, workspace, package, *options):
    """Start the nodes of a package, talk to them, and return what they print."""
    with (
        ros.master(ros1),
        ros1.running(f"roslaunch {package} {package}.launch", workspace) as log,
    ):
        ros1.talk(workspace, package, *options)
        assert "Traceback" not in log()
        return log()


def test_every_interface(ros1, ros1_with_logic):
    assert "warning:" not in ros1_with_logic.printed
    log = launch_and_talk(ros1, ros1_with_logic.workspace, "all_kinds", "tf")
    assert "Waiting for service permit, action delegate." in log


def test_nodes_without_a_loop(ros1, ros1_with_logic):
    launch_and_talk(ros1, ros1_with_logic.workspace, "serving")


def test_added_subscriber(ros1, ros1_interfaces, render, update, tmp_path, model):
    package = render(all_kinds(), model=model, ros_distro="noetic", name="src/all_kinds")
    logic = fill_in(package, model)
    add_volume(package)
    update(package)
    assert (package / LOGIC[model]).read_text() == logic
    use_volume(package, model)
    ros1.build(tmp_path, ros1_interfaces)
    launch_and_talk(ros1, tmp_path, "all_kinds", "tf", "volume")


def test_package_tests_and_linters(ros1, ros1_untouched):
    """The untouched packages pass their own tests, catkin_lint and the schema of REP 149."""
    assert "warning:" not in ros1_untouched.printed, ros1_untouched.printed
    results = ros1_untouched.results
    assert re.search(r"Summary: [1-9]\d+ tests, 0 errors, 0 failures, 0 skipped", results), results
    packages = sorted((ros1_untouched.workspace / "src").glob("*/package.xml"))
    names = {file.parent.name for file in packages}
    assert names - {"serving"} == {"all_kinds", "contact_analysis", "hostile"}
    for file in packages:
        lint = ros1.run("catkin_lint --strict -W1 .", file.parent).stdout
        assert "found 0 problems" in lint, lint
        ros1.run("xmllint --noout package.xml", file.parent)


def test_installed_package_is_whole(ros1, ros1_untouched, model):
    """`catkin_make install` brings everything the launch file needs."""
    workspace = ros1_untouched.workspace
    ros1.run("catkin_make install", workspace, workspace)
    share = workspace / "install/share/hostile"
    assert ET.parse(share / "launch/hostile.launch").getroot().tag == "launch"
    assert (share / "config/first_one.yaml").exists()
    assert (workspace / "install/lib/hostile/first_one").exists()
    if model == "python_model":
        assert list(workspace.glob("install/lib/python3*/**/hostile/ros/managed_node.py"))
