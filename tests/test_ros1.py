"""python_model in ROS 1: packages built by catkin, started by roslaunch, talked to by rospy."""

import re
import shutil
import xml.etree.ElementTree as ET

import pytest
import ros
from conftest import EXAMPLES, ROOT, commit, git

pytestmark = pytest.mark.ros1
VOLUME = '    <subscriber name="volume" type="std_msgs::Float64" description="How loud"/>\n'


@pytest.fixture
def workspace(tmp_path):
    """A workspace with the interfaces that ROS 1 lacks."""
    shutil.copytree(ROOT / "tests/interfaces/test_msgs", tmp_path / "src/test_msgs")
    return tmp_path


def run_scenario(ros1, workspace, *options):
    with ros.master(ros1), ros1.running("roslaunch all_kinds all_kinds.launch", workspace) as log:
        ros1.scenario(workspace, "tf", *options)
        return log()


def test_every_interface(ros1, render, workspace):
    package = render(EXAMPLES / "all_kinds.ros_package", ros_distro="noetic", name="src/all_kinds")
    git(package, "apply", str(ROOT / "tests/logic/all_kinds.patch"))
    ros1.build(workspace)
    log = run_scenario(ros1, workspace)
    assert "Waiting for service permit, action delegate." in log
    assert "Traceback" not in log


def test_added_subscriber(ros1, render, update, workspace):
    package = render(EXAMPLES / "all_kinds.ros_package", ros_distro="noetic", name="src/all_kinds")
    git(package, "apply", str(ROOT / "tests/logic/all_kinds.patch"))
    logic = (package / "all_kinds/worker_impl.py").read_text()
    file = package / "all_kinds.ros_package"
    file.write_text(
        file.read_text().replace("    <directPublisher", VOLUME + "    <directPublisher", 1)
    )
    commit(package, "Fill in the logic, add a topic")
    update(package)
    assert (package / "all_kinds/worker_impl.py").read_text() == logic
    ros1.build(workspace)
    run_scenario(ros1, workspace, "volume")


def test_package_tests_and_linters(ros1, render, workspace):
    """The untouched packages pass their own tests, catkin_lint and the schema of REP 149."""
    packages = [
        render(spec, ros_distro="noetic", name=f"src/{name}")
        for name, spec in (
            ("all_kinds", EXAMPLES / "all_kinds.ros_package"),
            ("hostile", ROOT / "tests/specs/hostile.ros_package"),
        )
    ]
    ros1.build(workspace)
    ros1.run("catkin_make run_tests", workspace, workspace)
    result = ros1.run("catkin_test_results", workspace, workspace).stdout
    assert re.search(r"Summary: [1-9]\d tests, 0 errors, 0 failures, 0 skipped", result), result
    for package in packages:
        lint = ros1.run("catkin_lint --strict -W1 .", package).stdout
        assert "found 0 problems" in lint, lint
        ros1.run("xmllint --noout package.xml", package)


def test_installed_package_runs(ros1, render, workspace):
    """`catkin_make install` brings everything the launch file needs."""
    render(ROOT / "tests/specs/hostile.ros_package", ros_distro="noetic", name="src/hostile")
    ros1.run("catkin_make install", workspace)
    share = workspace / "install/share/hostile"
    assert ET.parse(share / "launch/hostile.launch").getroot().tag == "launch"
    assert (share / "config/first_one.yaml").exists()
    assert (workspace / "install/lib/hostile/first_one").exists()
