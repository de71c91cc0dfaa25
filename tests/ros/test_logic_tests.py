"""The tests of a logic without ROS, as developers write them with the harness of their package."""

import contextlib

import pytest

from support import ros
from support.packages import DATA, fill_in
from support.repository import EXAMPLES


def run(ros_, render, workspace):
    spec = EXAMPLES / "all_kinds.ros_package"
    package = render(spec, ros_distro=ros_.distro)
    fill_in(package, "python_model")
    script = f"{DATA}/logic/worker_tests.py {package}/test"
    return ros_.run(f"env PYTHONPATH={package}:$PYTHONPATH {ros_.python} {script}", "/", workspace)


@pytest.mark.ros1
def test_python_in_ros1(ros1, render, ros1_interfaces):
    assert "\nOK\n" in run(ros1, render, ros1_interfaces).stdout


@pytest.mark.ros2
def test_python_in_ros2(ros2, render, ros2_interfaces):
    assert "\nOK\n" in run(ros2, render, ros2_interfaces).stdout


REFUSING = """
<package name="lab" author="A" author_email="a@example.org" description="d" license="MIT">
  <node name="talk"><directPublisher name="said" type="std_msgs::String"/></node>
</package>
"""


@pytest.mark.parametrize(
    "version", [pytest.param(n, marks=getattr(pytest.mark, f"ros{n}")) for n in (1, 2)]
)
def test_a_logic_that_refuses_is_told_at_once(request, render, version):
    """As one does whose parameter names no file; not as a service that is missing."""
    ros_ = request.getfixturevalue(f"ros{version}")
    package = render(REFUSING, ros_distro=ros_.distro, name="lab")
    file = package / "lab/talk_impl.py"
    logic = file.read_text().replace("return True", "return False", 1)
    file.write_text(logic)
    test = "test_talk_node.TestTalkNode.test_own_logic"
    command = (
        f"env TEST_TIMEOUT=600 PYTHONPATH={package}:$PYTHONPATH {ros_.python} -m unittest {test}"
    )
    for _ in range(5):  # on a busy machine a node of ROS 1 may be told to end before it refuses
        with ros.master(ros_) if version == 1 else contextlib.nullcontext():
            told = ros_.run(command, package / "test", check=False, timeout=120).stdout
        if "AssertionError: " in told:
            break
    assert "The logic refused to configure." in told.partition("AssertionError: ")[2]
