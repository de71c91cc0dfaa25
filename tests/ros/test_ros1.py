"""The models in ROS 1: packages built by catkin, started by roslaunch, talked to by rospy."""

import re
import shutil
import xml.etree.ElementTree as ET

import pytest

from support import ros
from support.packages import (
    DATA,
    HOSTILE,
    LOGIC,
    MODELS,
    add_volume,
    all_kinds,
    fill_in,
    use_volume,
)
from support.repository import EXAMPLES

pytestmark = [pytest.mark.ros1, pytest.mark.parametrize("model", MODELS)]


@pytest.fixture
def workspace(tmp_path):
    """A workspace with the interfaces that ROS 1 lacks."""
    shutil.copytree(DATA / "test_msgs", tmp_path / "src/test_msgs")
    return tmp_path


def run_scenario(ros1, workspace, *options):
    with ros.master(ros1), ros1.running("roslaunch all_kinds all_kinds.launch", workspace) as log:
        ros1.scenario(workspace, "tf", *options)
        return log()


def test_every_interface(ros1, render, workspace, model):
    package = render(all_kinds(), model=model, ros_distro="noetic", name="src/all_kinds")
    fill_in(package, model)
    built = ros1.build(workspace)
    assert "warning:" not in built
    log = run_scenario(ros1, workspace)
    assert "Waiting for service permit, action delegate." in log
    assert "Traceback" not in log


def test_added_subscriber(ros1, render, update, workspace, model):
    package = render(all_kinds(), model=model, ros_distro="noetic", name="src/all_kinds")
    logic = fill_in(package, model)
    add_volume(package)
    update(package)
    assert (package / LOGIC[model]).read_text() == logic
    use_volume(package, model)
    ros1.build(workspace)
    run_scenario(ros1, workspace, "volume")


def test_package_tests_and_linters(ros1, render, workspace, model):
    """The untouched packages pass their own tests, catkin_lint and the schema of REP 149."""
    packages = [
        render(spec, model=model, ros_distro="noetic", name=f"src/{name}")
        for name, spec in (
            ("all_kinds", EXAMPLES / "all_kinds.ros_package"),
            ("hostile", HOSTILE),
        )
    ]
    built = ros1.build(workspace)
    assert "warning:" not in built, built
    ros1.run("catkin_make run_tests", workspace, workspace)
    result = ros1.run("catkin_test_results", workspace, workspace).stdout
    assert re.search(r"Summary: [1-9]\d tests, 0 errors, 0 failures, 0 skipped", result), result
    for package in packages:
        lint = ros1.run("catkin_lint --strict -W1 .", package).stdout
        assert "found 0 problems" in lint, lint
        ros1.run("xmllint --noout package.xml", package)


def test_installed_package_is_whole(ros1, render, workspace, model):
    """`catkin_make install` brings everything the launch file needs."""
    render(
        HOSTILE,
        model=model,
        ros_distro="noetic",
        name="src/hostile",
    )
    ros1.run("catkin_make install", workspace)
    share = workspace / "install/share/hostile"
    assert ET.parse(share / "launch/hostile.launch").getroot().tag == "launch"
    assert (share / "config/first_one.yaml").exists()
    assert (workspace / "install/lib/hostile/first_one").exists()
