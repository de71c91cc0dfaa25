"""The models in ROS 2: packages installed, started and talked to through real middleware."""

import re
import shutil

import pytest

from support import ros
from support.packages import DATA, LOGIC, add_volume, fill_in, use_volume
from support.ros import PEERS, nodes

pytestmark = pytest.mark.ros2


def test_every_interface(ros2, ros2_spec, ros2_with_logic):
    workspace = ros2_with_logic.workspace
    assert "warning:" not in ros2_with_logic.printed, ros2_with_logic.printed
    with nodes(ros2, workspace, "all_kinds", "worker", "observer") as (worker, _):
        ros2.talk(workspace, "all_kinds", *ros2_spec[1])
        log = worker()
    assert re.search("Waiting for (action delegate|service permit), ", log)
    assert "Traceback" not in log


def test_nodes_without_a_loop(ros2, ros2_with_logic):
    workspace = ros2_with_logic.workspace
    with nodes(ros2, workspace, "serving", "clerk") as (log,):
        ros2.talk(workspace, "serving")
        assert "Traceback" not in log()


def test_added_subscriber(ros2, ros2_spec, render, update, tmp_path, model):
    spec, options = ros2_spec
    package = render(spec, model=model, ros_distro=ros2.distro, name="src/all_kinds")
    logic = fill_in(package, model)
    add_volume(package)
    update(package)
    assert (package / LOGIC[model]).read_text() == logic
    use_volume(package, model)
    ros2.build(tmp_path)
    with nodes(ros2, tmp_path, "all_kinds", "worker"):
        ros2.talk(tmp_path, "all_kinds", "volume", *options)


def test_package_tests_and_linters(ros2, ros2_untouched):
    """The untouched packages pass their own tests, the linters of ROS 2 among them."""
    workspace, printed, results = vars(ros2_untouched).values()
    assert "warning:" not in printed, printed
    assert re.search(r"Summary: [1-9]\d+ tests, 0 errors, 0 failures, 0 skipped", results), results
    packages = sorted(workspace.glob("src/*/package.xml"))
    names = {file.parent.name for file in packages}
    assert names - {"serving"} == {"all_kinds", "contact_analysis", "hostile"}
    for file in packages:
        if shutil.which("xmllint"):
            ros2.run(f"xmllint --noout {file}", workspace)


SETUP = """\
from setuptools import setup

setup(name="a", version="1.0.0", tests_require=["pytest"])
"""
FAILING = """\
def test_a():
    with open("{}/tries", "a+") as tries:
        tries.write("x")
        assert tries.tell() > {}
"""


@pytest.mark.parametrize(("failures", "passes"), [(1, True), (9, False)])
def test_package_whose_test_fails_is_tested_once_more(ros2, tmp_path, failures, passes):
    """A fault that is always there is a fault."""
    (tmp_path / "src/a/test").mkdir(parents=True)
    (tmp_path / "src/a/setup.py").write_text(SETUP)
    (tmp_path / "src/a/test/test_a.py").write_text(FAILING.format(tmp_path, failures))
    ros2.build(tmp_path)
    with pytest.warns(UserWarning, match="1 failure"):
        results = ros2.test(tmp_path)
    assert ("0 failures" in results) == passes
    assert (tmp_path / "tries").read_text() == "xx"


def test_launch_file(ros2, ros2_spec, ros2_with_logic):
    if not ros.has(ros2, "launch_ros"):
        pytest.skip("launch_ros is not installed")
    workspace = ros2_with_logic.workspace
    with ros2.running("ros2 launch all_kinds all_kinds.launch.xml", workspace):
        ros2.talk(workspace, "all_kinds", *ros2_spec[1])


def test_node_that_is_destroyed_twice(ros2, ros2_with_logic, model):
    """As by `with` and by an executor of others; the second time nothing is left to do."""
    if model != "python_model":
        pytest.skip("C++ has destructors")
    code = "rclpy.init(); node = ClerkNode(); node.destroy_node(); node.destroy_node()"
    code = f"import rclpy; from serving.clerk_ros import ClerkNode; {code}; rclpy.shutdown()"
    workspace = ros2_with_logic.workspace
    ros2.run(f"python3 -c '{code}'", workspace, workspace, timeout=60)


@pytest.mark.parametrize("tests", ["of the package", "of the collection"])
def test_broken_shared_memory(ros2, ros2_with_logic, tests):
    """Tests kill nodes, and Fast DDS crashes where their shared memory is left broken."""
    workspace = ros2_with_logic.workspace
    folder = "src/serving/test" if tests == "of the package" else ""
    ros2.run(f"python3 {PEERS}/broken_memory.py {folder}", workspace, workspace)


def test_messages_are_not_copied(ros2, render, tmp_path):
    """python_model hands on the message that came; C++ moves what it owns."""
    render(DATA / "fast.ros_package", ros_distro=ros2.distro, name="src/fast")
    ros2.build(tmp_path)
    ros2.run(f"python3 {PEERS}/same_message.py", tmp_path, tmp_path)
