"""The tests of a logic without ROS, as developers write them with the harness of their package."""

import pytest

from support.packages import DATA, fill_in
from support.repository import EXAMPLES


def run(ros, render, workspace):
    spec = EXAMPLES / "all_kinds.ros_package"
    package = render(spec, ros_distro=ros.distro)
    fill_in(package, "python_model")
    script = f"{DATA}/logic/worker_tests.py {package}/test"
    return ros.run(f"env PYTHONPATH={package}:$PYTHONPATH {ros.python} {script}", "/", workspace)


@pytest.mark.ros1
def test_python_in_ros1(ros1, render, ros1_interfaces):
    assert "\nOK\n" in run(ros1, render, ros1_interfaces).stdout


@pytest.mark.ros2
def test_python_in_ros2(ros2, render, ros2_interfaces):
    assert "\nOK\n" in run(ros2, render, ros2_interfaces).stdout
