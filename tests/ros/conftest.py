"""The packages of the specs in examples/, built once a session for each ROS and model.

They are built and tested as the models make them, with a package of traps beside them; then their
logic is filled in. Tests that need another state of a package make their own.
"""

from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from support import ros
from support.packages import HOSTILE, MODELS, fill_in, fill_in_serving
from support.repository import EXAMPLES

ALL_KINDS = EXAMPLES / "all_kinds.ros_package"
SERVING = EXAMPLES / "serving.ros_package"
CONTACT_MSGS = EXAMPLES / "contact_msgs.ros_package"
CONTACT_ANALYSIS = EXAMPLES / "contact_analysis.ros_package"


@dataclass(frozen=True)
class Built:
    """A workspace, what its build printed, and what the tests of its packages gave."""

    workspace: Path
    printed: str
    results: str


@pytest.fixture(scope="session", params=MODELS)
def model(request):
    """Each model; all tests of one come together, and share its packages."""
    return request.param


@pytest.fixture(scope="session")
def ros2_interfaces(put, once):
    """A workspace with the interfaces that ROS 2 lacks."""
    ros2 = ros.ros2() or pytest.skip(ros.NO_ROS2)

    def build(workspace):
        put(CONTACT_MSGS, "interfaces_model", ros2.distro, workspace)
        ros2.build(workspace)

    return once("ros2_interfaces", build)


def untouched(ros_, put, model, workspace, interfaces, all_kinds):
    """Build and test the packages, by the compiler of most users, whose warnings count."""
    ros_ = replace(ros_, environment=ros_.environment | ros.GCC)
    for spec in (all_kinds, CONTACT_ANALYSIS, HOSTILE):
        put(spec, model, ros_.distro, workspace)
    printed = ros_.build(workspace, interfaces)
    return Built(workspace, printed, ros_.test(workspace))


def with_logic(ros_, put, model, untouched, interfaces):
    """Fill in the logic; the tests of `serving` are those that test_runtime.py runs."""
    workspace = untouched.workspace
    put(SERVING, model, ros_.distro, workspace)
    fill_in(workspace / "src/all_kinds", model)
    fill_in_serving(workspace / "src/serving", model)
    return Built(workspace, ros_.build(workspace, interfaces), "")


@pytest.fixture(scope="session")
def ros1_untouched(ros1_interfaces, put, model, tmp_path_factory):
    workspace = tmp_path_factory.mktemp("ros1")
    return untouched(ros.ros1(), put, model, workspace, ros1_interfaces, ALL_KINDS)


@pytest.fixture(scope="session")
def ros1_with_logic(ros1_untouched, ros1_interfaces, put, model):
    return with_logic(ros.ros1(), put, model, ros1_untouched, ros1_interfaces)


@pytest.fixture(scope="session")
def ros2_spec(model, tmp_path_factory):
    """The spec of all kinds, and what the peer can test of it in this ROS 2."""
    ros2 = ros.ros2() or pytest.skip(ros.NO_ROS2)
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed; models/test_cpp_model.py checks what can be without")
    spec = tmp_path_factory.mktemp("fitting") / ALL_KINDS.name
    spec.write_text(ros.fitting(ros2, ALL_KINDS.read_text()))
    return spec, ["tf"] if "<listener" in spec.read_text() else []


@pytest.fixture(scope="session")
def ros2_untouched(ros2_spec, ros2_interfaces, put, model, tmp_path_factory):
    workspace = tmp_path_factory.mktemp("ros2")
    return untouched(ros.ros2(), put, model, workspace, ros2_interfaces, ros2_spec[0])


@pytest.fixture(scope="session")
def ros2_with_logic(ros2_untouched, ros2_interfaces, put, model):
    return with_logic(ros.ros2(), put, model, ros2_untouched, ros2_interfaces)
