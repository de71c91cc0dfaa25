"""One runtime for the packages of a workspace, in both languages and both ROS."""

import contextlib
import re

import pytest

from support import ros
from support.packages import shared_runtime
from support.repository import EXAMPLES, commit
from support.ros import wait_for

SERVING = EXAMPLES / "serving.ros_package"
SPEC = """
<package name="{name}" author="A" author_email="a@b.example.org" description="d" license="MIT">
  <node name="drive" frequency="50">
    <publisher name="throttle" type="std_msgs::Float64"/>
  </node>
</package>
"""
ADVERTISED = "publisher for topic name '/?throttle'"
REFUSED = r"car_2 was made for node_runtime 9\.0\.0, but\s+0\.1\.0 is installed"


@pytest.fixture
def cars(tmp_path):
    """Write specs of packages of these names, each with one node."""

    def write(*names):
        files = [tmp_path / f"specs/{name}.ros_package" for name in names]
        for file in files:
            file.parent.mkdir(exist_ok=True)
            file.write_text(SPEC.format(name=file.stem))
        return files

    return write


def check(ros_, workspace, underlay):
    """Build and test what is in a workspace."""
    printed = ros_.build(workspace, underlay)
    assert "warning:" not in printed, printed
    results = ros_.test(workspace)
    assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", results), results


@pytest.mark.ros1
def test_packages_pass_their_tests_in_ros1(ros1, ros1_interfaces, make, model, tmp_path):
    shared_runtime(make, model, tmp_path, "noetic", SERVING)
    check(ros1, tmp_path, ros1_interfaces)
    for name in ("node_runtime", "serving"):
        lint = ros1.run("catkin_lint --strict -W1 .", tmp_path / "src" / name).stdout
        assert "found 0 problems" in lint, lint


@pytest.mark.ros2
@pytest.mark.usefixtures("ros2_spec")  # skips where the language is not there
def test_packages_pass_their_tests_in_ros2(ros2, ros2_interfaces, make, model, tmp_path):
    shared_runtime(make, model, tmp_path, ros2.distro, SERVING)
    check(ros2, tmp_path, ros2_interfaces)


@pytest.mark.ros2
def test_packages_share_it(ros2, make, cars, tmp_path):
    """The packages of a workspace run at once, with one copy of the runtime."""
    specs = cars(*(f"car_{number}" for number in range(4)))
    shared_runtime(make, "python_model", tmp_path, ros2.distro, *specs)
    ros2.build(tmp_path)
    assert len(list((tmp_path / "src").rglob("managed_node.py"))) == 1
    with contextlib.ExitStack() as stack:
        for spec in specs:
            node = f"install/{spec.stem}/lib/{spec.stem}/drive"
            command = f"{tmp_path}/{node} --ros-args --log-level debug -r __ns:=/{spec.stem}"
            log = stack.enter_context(ros2.running(command, tmp_path))
            wait_for(ADVERTISED, log)


@pytest.mark.ros2
def test_versions_in_ros2(ros2, ros2_spec, own_collection, model, cars, render, tmp_path):
    """A package works with an older runtime of its major version, and refuses that of another."""
    newer, other = versions(own_collection, render, model, ros2.distro, cars, tmp_path)
    ros2.run(f"colcon build --packages-up-to {newer} --cmake-args -DBUILD_TESTING=OFF", tmp_path)
    program = f"{tmp_path}/install/{newer}/lib/{newer}/drive"
    with ros2.running(f"{program} --ros-args --log-level debug", tmp_path) as log:
        wait_for(ADVERTISED, log)
    printed = ros2.run(f"colcon build --packages-select {other}", tmp_path, check=False).stdout
    if model == "python_model":
        program = f"{tmp_path}/install/{other}/lib/{other}/drive"
        printed = ros2.run(program, tmp_path, tmp_path, check=False).stdout
    assert re.search(REFUSED, printed), printed


@pytest.mark.ros1
def test_versions_in_ros1(ros1, own_collection, model, cars, render, tmp_path):
    """The same in ROS 1."""
    newer, other = versions(own_collection, render, model, "noetic", cars, tmp_path)
    only = "catkin_make -DCATKIN_ENABLE_TESTING=OFF -DCATKIN_WHITELIST_PACKAGES='node_runtime;{}'"
    ros1.run(only.format(newer), tmp_path)
    with ros.master(ros1), ros1.running(f"devel/lib/{newer}/drive", tmp_path, tmp_path):
        wait_for("/throttle", lambda: ros1.run("rostopic list", tmp_path, tmp_path).stdout)
    printed = ros1.run(only.format(other), tmp_path, check=False).stdout
    if model == "python_model":
        printed = ros1.run(f"devel/lib/{other}/drive", tmp_path, tmp_path, check=False).stdout
    assert re.search(REFUSED, printed), printed


def versions(collection, render, model, distro, cars, workspace):
    """Render a runtime, and packages of a newer and of the next major version of the models."""
    options = {"template": collection, "ros_distro": distro}
    shared_runtime(
        lambda folder, spec, **data: render(
            spec, name=str(folder.relative_to(workspace)), **options, model=data["model"]
        ),
        model,
        workspace,
        distro,
    )
    place = collection / "shared/runtime/place.yml"
    names = {"car_1": "0.2.0", "car_2": "9.0.0"}
    for spec, version in zip(cars(*names), names.values(), strict=True):
        place.write_text(re.sub(r"\"\d\.\d\.0\"", f'"{version}"', place.read_text()))
        commit(collection, version, tag=version)
        name = f"src/{spec.stem}"
        render(spec, name=name, model=model, runtime="node_runtime", **options)
    return tuple(names)


SHORT_CALLBACKS = """
from unittest.mock import Mock

from ear.ros import callbacks
from ear.ros.stop import Stop

class Node:
    stop = Stop()
    executor = Mock()

    def call(self, method, message):
        pass

    async def await_first(self, *calls):
        global awaited
        awaited += 1

awaited = 0
thread = callbacks.CallbackThread(Node(), 'say', 'receive_say')
for message in range(500):
    try:
        thread.receive(message).send(None)
    except StopIteration:
        pass
print(f'{awaited} of 500 awaited')
"""


@pytest.mark.ros2
def test_short_callback_has_returned_when_the_executor_goes_on(ros2, make, tmp_path):
    """Nearly each: the system may take the processor from the thread of the callback."""
    spec = tmp_path / "ear.ros_package"
    spec.write_text(
        SPEC.format(name="ear")
        .replace("publisher", "directSubscriber")
        .replace(' frequency="50"', "")
    )
    make(tmp_path / "ear", spec, ros_distro=ros2.distro)
    (tmp_path / "short.py").write_text(SHORT_CALLBACKS)
    command = f"env PYTHONPATH={tmp_path}/ear:$PYTHONPATH {ros2.python} short.py"
    printed = ros2.run(command, tmp_path).stdout
    assert int(printed.split()[0]) < 100, printed
