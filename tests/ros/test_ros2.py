"""The models in ROS 2: packages installed, started and talked to through real middleware."""

import re
import shutil

import pytest

from support import ros
from support.packages import (
    HOSTILE,
    LOGIC,
    MODELS,
    add_volume,
    all_kinds,
    fill_in,
    use_volume,
    without_tf,
)
from support.repository import EXAMPLES
from support.ros import PEERS, nodes

pytestmark = pytest.mark.ros2
each_model = pytest.mark.parametrize("model", MODELS)


@pytest.fixture
def spec(ros2, request):
    """The spec of all kinds, and what the scenario can test of it in this ROS 2."""
    if request.getfixturevalue("model") == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed; models/test_cpp_model.py checks what can be without")
    if ros.has(ros2, "tf2_ros"):
        return all_kinds(), ["tf"]
    print("tf2_ros is not installed: transforms are left out")
    return without_tf(all_kinds()), []


@each_model
def test_every_interface(ros2, spec, render, tmp_path, model):
    text, options = spec
    package = render(text, model=model, ros_distro=ros2.distro, name="src/all_kinds")
    fill_in(package, model)
    built = ros2.build(tmp_path)
    assert "warning:" not in built, built
    with nodes(ros2, tmp_path, "all_kinds", "worker", "observer") as (worker, _):
        ros2.scenario(tmp_path, *options)
        log = worker()
    assert re.search("Waiting for (action delegate|service permit), ", log)
    assert "Traceback" not in log


@each_model
def test_added_subscriber(ros2, spec, render, update, tmp_path, model):
    text, options = spec
    package = render(text, model=model, ros_distro=ros2.distro, name="src/all_kinds")
    logic = fill_in(package, model)
    add_volume(package)
    update(package)
    assert (package / LOGIC[model]).read_text() == logic
    use_volume(package, model)
    ros2.build(tmp_path)
    with nodes(ros2, tmp_path, "all_kinds", "worker"):
        ros2.scenario(tmp_path, "volume", *options)


@each_model
def test_package_tests_and_linters(ros2, spec, render, tmp_path, model):
    """The untouched packages pass their own tests, the linters of ROS 2 among them."""
    render(spec[0], model=model, ros_distro=ros2.distro, name="src/all_kinds")
    render(
        HOSTILE,
        model=model,
        ros_distro=ros2.distro,
        name="src/hostile",
    )
    for file in tmp_path.glob("src/*/package.xml"):
        if shutil.which("xmllint"):
            ros2.run(f"xmllint --noout {file}", tmp_path)
    built = ros2.build(tmp_path)
    assert "warning:" not in built, built
    ros2.run("colcon test --event-handlers console_cohesion+", tmp_path, tmp_path)
    result = ros2.run("colcon test-result --all --verbose", tmp_path, tmp_path).stdout
    assert re.search(r"Summary: [1-9]\d+ tests, 0 errors, 0 failures, 0 skipped", result), result


@each_model
def test_launch_file(ros2, spec, render, tmp_path, model):
    if not ros.has(ros2, "launch_ros"):
        pytest.skip("launch_ros is not installed")
    text, options = spec
    package = render(text, model=model, ros_distro=ros2.distro, name="src/all_kinds")
    fill_in(package, model)
    ros2.build(tmp_path)
    with ros2.running("ros2 launch all_kinds all_kinds.launch.xml", tmp_path):
        ros2.scenario(tmp_path, *options)


def test_messages_are_not_copied(ros2, render, tmp_path):
    """python_model hands on the message that came; C++ moves what it owns."""
    render(EXAMPLES / "../benchmarks/fast.ros_package", ros_distro=ros2.distro, name="src/fast")
    ros2.build(tmp_path)
    ros2.run(f"python3 {PEERS}/same_message.py", tmp_path, tmp_path)
