"""Nodes without a frequency: they have no loop, no update and no Data, whatever they serve."""

import re
import shutil

import pytest

from support import ros
from support.packages import DATA, DISTROS, MODELS, files
from support.repository import EXAMPLES, commit, git
from support.soundness import check_imports, check_sound

SPEC = EXAMPLES / "serving.ros_package"
LOGIC = {"python_model": "serving/clerk_impl.py", "cpp_model": "src/clerk_impl.cpp"}
HOME = '    <serviceServer name="go_home" type="std_srvs::Empty"/>\n'
each_model = pytest.mark.parametrize("model", MODELS)


@pytest.mark.parametrize("distro", ["noetic", "humble", "lyrical"])
def test_rendered_code_is_sound(render, distro):
    package = render(SPEC, ros_distro=distro)
    check_sound(package)
    check_imports(package, distro)


@each_model
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_nothing_of_a_loop_is_left(render, model, distro):
    package = render(SPEC, model=model, ros_distro=distro)
    words = r"\bupdate\(|_update\b|\w+Data\b|\bdata_?\b|FREQUENCY|[Ll]oop\b|frequency"
    for file in package.rglob("*"):
        own = {".git", ".copier-answers.yml", "serving.ros_package"} & set(file.parts)
        if file.is_file() and not own:
            text = file.read_text().replace("add_data", "").replace("data_files", "")
            assert not re.search(words, text), f"{file}: {re.search(words, text)}"


@each_model
def test_logic_is_the_same_for_all_ros(render, model):
    packages = [
        render(SPEC, model=model, ros_distro=distro, name=f"{distro}/same") for distro in DISTROS
    ]
    first, *others = [
        {file.name: file.read_bytes() for file in files(package, "*_impl.*")}
        for package in packages
    ]
    assert {name.split(".")[0] for name in first} == {
        "clerk_impl",
        "idler_impl",
        "test_clerk_impl",
        "test_idler_impl",
    }
    assert all(other == first for other in others)


def fill_in(package, model):
    """Write the logic of the clerk, and give its parameters other values than the spec."""
    git(package, "apply", str(DATA / f"logic/serving_{model}.patch"))
    config = package / "config/clerk.yaml"
    config.write_text(config.read_text().replace('"hello"', '"good day"').replace("0.5", "0.05"))
    commit(package, "Fill in the logic")
    return (package / LOGIC[model]).read_text()


@each_model
def test_new_service_is_merged(render, update, model):
    package = render(SPEC, model=model)
    text = fill_in(package, model)
    file = package / "serving.ros_package"
    file.write_text(file.read_text().replace("    <actionServer", HOME + "    <actionServer", 1))
    commit(package)
    update(package)
    new = (package / LOGIC[model]).read_text()
    assert "serve_go_home(" in new
    assert "<<<<<<<" not in new
    assert set(text.splitlines()) <= set(new.splitlines())


@each_model
def test_frequency_comes_and_goes(render, update, model):
    """A node gets its update when it gets a frequency, and an update that was filled in stays."""
    package = render(SPEC, model=model)
    text = fill_in(package, model)
    file = package / "serving.ros_package"
    spec = file.read_text()
    file.write_text(spec.replace('name="clerk"', 'name="clerk" frequency="5"'))
    commit(package)
    update(package)
    commit(package)
    new = (package / LOGIC[model]).read_text()
    assert "update(" in new
    assert set(text.splitlines()) <= set(new.splitlines())
    file.write_text(spec)
    commit(package)
    update(package)
    assert (package / LOGIC[model]).read_text() == text


def talk(ros_, workspace, peer):
    ros_.run(f"{ros_.python} {ros.PEERS / 'serving.py'} {peer}", workspace, workspace, timeout=120)


@pytest.mark.ros2
@each_model
def test_serves_in_ros2(ros2, render, tmp_path, model):
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    spec = SPEC.read_text()
    package = render(spec, model=model, ros_distro=ros2.distro, name="src/serving")
    ros2.build(tmp_path)
    ros2.run("colcon test --event-handlers console_cohesion+", tmp_path, tmp_path)
    result = ros2.run("colcon test-result --all --verbose", tmp_path, tmp_path).stdout
    assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", result), result
    fill_in(package, model)
    ros2.build(tmp_path)
    install = "install/serving"
    command = f"{install}/lib/serving/clerk --ros-args"
    command += f" --params-file {install}/share/serving/config/clerk.yaml"
    with ros2.running(command, tmp_path, tmp_path) as log:
        talk(ros2, tmp_path, "ros2")
        assert "Traceback" not in log()


@pytest.mark.ros1
@each_model
def test_serves_in_ros1(ros1, render, tmp_path, model):
    shutil.copytree(DATA / "test_msgs", tmp_path / "src/test_msgs")
    package = render(SPEC, model=model, ros_distro="noetic", name="src/serving")
    assert "warning:" not in ros1.build(tmp_path)
    ros1.run("catkin_make run_tests", tmp_path, tmp_path)
    result = ros1.run("catkin_test_results", tmp_path, tmp_path).stdout
    assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", result), result
    lint = ros1.run("catkin_lint --strict -W1 .", package).stdout
    assert "found 0 problems" in lint, lint
    fill_in(package, model)
    ros1.build(tmp_path)
    with ros.master(ros1), ros1.running("roslaunch serving serving.launch", tmp_path) as log:
        talk(ros1, tmp_path, "ros1")
        assert "Traceback" not in log()
