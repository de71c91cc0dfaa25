"""python_model in ROS 2: packages installed, started and talked to through real middleware."""

import contextlib
import re

import pytest
import ros
from conftest import EXAMPLES, ROOT, commit, git

pytestmark = pytest.mark.ros2
VOLUME = '    <subscriber name="volume" type="std_msgs::Float64" description="How loud"/>\n'


def spec_without_tf(ros2):
    """Return the spec of all kinds, and what the scenario can test of it here."""
    text = (EXAMPLES / "all_kinds.ros_package").read_text()
    if ros.has(ros2, "tf2_ros"):
        return text, ["tf"]
    print("tf2_ros is not installed: transforms are left out")
    return re.sub(r" *<(listener|broadcaster) .*\n", "", text), []


@contextlib.contextmanager
def nodes(ros2, workspace, package, *names):
    """Run nodes of a package with the parameter files its launch file names."""
    install = workspace / "install" / package
    with contextlib.ExitStack() as stack:
        yield [
            stack.enter_context(
                ros2.running(
                    f"{install}/lib/{package}/{name} --ros-args"
                    f" --params-file {install}/share/{package}/config/{name}.yaml",
                    workspace,
                )
            )
            for name in names
        ]


def test_every_interface(ros2, render, tmp_path):
    spec, options = spec_without_tf(ros2)
    package = render(spec, ros_distro=ros2.distro, name="src/all_kinds")
    git(package, "apply", str(ROOT / "tests/logic/all_kinds.patch"))
    ros2.build(tmp_path)
    with nodes(ros2, tmp_path, "all_kinds", "worker", "observer") as (worker, _):
        ros2.scenario(tmp_path, *options)
        log = worker()
    assert "Waiting for action delegate, service permit." in log
    assert "Traceback" not in log


def test_added_subscriber(ros2, render, update, tmp_path):
    spec, options = spec_without_tf(ros2)
    package = render(spec, ros_distro=ros2.distro, name="src/all_kinds")
    git(package, "apply", str(ROOT / "tests/logic/all_kinds.patch"))
    logic = (package / "all_kinds/worker_impl.py").read_text()
    file = package / "all_kinds.ros_package"
    file.write_text(
        file.read_text().replace("    <directPublisher", VOLUME + "    <directPublisher", 1)
    )
    commit(package, "Fill in the logic, add a topic")
    changed = update(package)
    assert "UU" not in changed
    assert (package / "all_kinds/worker_impl.py").read_text() == logic
    ros2.build(tmp_path)
    with nodes(ros2, tmp_path, "all_kinds", "worker"):
        ros2.scenario(tmp_path, "volume", *options)


def test_package_tests_and_linters(ros2, render, tmp_path):
    spec, _ = spec_without_tf(ros2)
    render(spec, ros_distro=ros2.distro, name="src/all_kinds")
    render(ROOT / "tests/specs/hostile.ros_package", ros_distro=ros2.distro, name="src/hostile")
    ros2.build(tmp_path)
    ros2.run("colcon test --event-handlers console_cohesion+", tmp_path, tmp_path)
    result = ros2.run("colcon test-result --all --verbose", tmp_path, tmp_path).stdout
    assert re.search(r"Summary: 1[0-9] tests, 0 errors, 0 failures, 0 skipped", result), result


def test_messages_are_not_copied(ros2, render, tmp_path):
    render(
        """<package name="fast" author="A" author_email="a@example.org" description="d"
                    license="MIT">
             <node name="relay" frequency="1000">
               <subscriber name="floats_in" type="std_msgs::Float64MultiArray"/>
             </node>
           </package>""",
        ros_distro=ros2.distro,
        name="src/fast",
    )
    ros2.build(tmp_path)
    ros2.run(f"python3 {ROOT}/tests/peers/same_message.py", tmp_path, tmp_path)


def test_launch_file(ros2, render, tmp_path):
    if not ros.has(ros2, "launch_ros"):
        pytest.skip("launch_ros is not installed")
    spec, options = spec_without_tf(ros2)
    package = render(spec, ros_distro=ros2.distro, name="src/all_kinds")
    git(package, "apply", str(ROOT / "tests/logic/all_kinds.patch"))
    ros2.build(tmp_path)
    with ros2.running("ros2 launch all_kinds all_kinds.launch.xml", tmp_path):
        ros2.scenario(tmp_path, *options)
