"""Figure 1 of the paper, its interfaces and a written logic: two packages in one workspace."""

import itertools
import shutil

import pytest

from support import ros
from support.packages import fill_in_contacts, shared_runtime
from support.repository import EXAMPLES

INTERFACES = EXAMPLES / "contact_msgs.ros_package"
FIGURE = EXAMPLES / "contact_analysis.ros_package"
FOLDERS = ("src", "build", "install")


@pytest.fixture(scope="module")
def ros1_workspace(tmp_path_factory):
    return tmp_path_factory.mktemp("ros1_figure")


@pytest.fixture(scope="module")
def ros2_workspace(tmp_path_factory):
    return tmp_path_factory.mktemp("ros2_figure")


@pytest.fixture(params=["inside", "shared"])
def put_figure(request, put, make):
    """Put the package into a workspace, with the runtime inside or beside it."""

    def run(model, distro, workspace):
        for name, folder in itertools.product(("contact_analysis", "node_runtime"), FOLDERS):
            shutil.rmtree(workspace / folder / name, ignore_errors=True)
        if request.param == "inside":
            put(FIGURE, model, distro, workspace)
        else:
            shared_runtime(make, model, workspace, distro, FIGURE)

    return run


def build(ros_, put, put_figure, model, workspace, options):
    """Build both packages; the interfaces once, for the nodes in each language."""
    if not (workspace / "src/contact_msgs").exists():
        put(INTERFACES, "interfaces_model", ros_.distro, workspace)
    put_figure(model, ros_.distro, workspace)
    fill_in_contacts(workspace / "src/contact_analysis", model)
    printed = ros_.run(f"{ros_.build_command} {options}", workspace, timeout=1800).stdout
    assert "warning:" not in printed, printed


@pytest.mark.ros1
def test_figure_in_ros1(ros1, put, put_figure, model, ros1_workspace, tmp_path):
    build(ros1, put, put_figure, model, ros1_workspace, "-DCATKIN_ENABLE_TESTING=OFF")
    with ros.master(ros1):
        for part in ("learn", "remember"):
            launch = "roslaunch contact_analysis contact_analysis.launch"
            with ros1.running(launch, ros1_workspace) as log:
                ros1.talk(ros1_workspace, "contact_analysis", part, str(tmp_path))
            assert "Traceback" not in log()


@pytest.mark.ros2
def test_figure_in_ros2(ros2, put, put_figure, model, ros2_workspace, tmp_path):
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    build(ros2, put, put_figure, model, ros2_workspace, "--cmake-args -DBUILD_TESTING=OFF")
    for part in ("learn", "remember"):
        with ros.nodes(ros2, ros2_workspace, "contact_analysis", "contact_evaluate") as (log,):
            ros2.talk(ros2_workspace, "contact_analysis", part, str(tmp_path))
        assert "Traceback" not in log()


@pytest.mark.ros2
def test_logic_follows_the_style(ros2, put, model, tmp_path):
    """The linters of ROS 2 find nothing in the package with its logic."""
    put(FIGURE, model, ros2.distro, tmp_path)
    package = tmp_path / "src/contact_analysis"
    fill_in_contacts(package, model)
    if model == "python_model":
        ros2.run("ament_flake8 .", package)
        ros2.run("ament_pep257 .", package)
        return
    ros2.run("ament_cpplint include src", package)
    if not shutil.which("uncrustify"):
        pytest.skip("uncrustify is not installed")
    ros2.run("ament_uncrustify --language C++ include src", package)
