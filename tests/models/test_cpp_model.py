"""cpp_model without rclcpp: as far as the wheels of ROS 2 reach.

Covered here: messages, interface layer and logic are compiled and their unit tests run;
every file is held against ROS 2's linters, `<node>_ros.cpp` among them. Not covered: compiling
`<node>_ros.cpp` and the headers it includes from src/, which needs rclcpp; test_ros2.py does that
where rclcpp is installed, and test_ros1.py compiles their twins of ROS 1.
"""

import shutil

import pytest
import yaml

from support.packages import DATA, DISTROS, HOSTILE, SPECS, all_kinds, files

MESSAGES = {"geometry_msgs", "std_msgs", "std_srvs", "test_msgs"}


@pytest.mark.ros2
@pytest.mark.parametrize("spec", [all_kinds(), HOSTILE], ids=["all_kinds", "hostile"])
def test_logic_compiles_and_passes_its_tests(ros2, render, tmp_path, spec):
    package = render(spec, model="cpp_model", ros_distro=ros2.distro)
    recorded = yaml.safe_load((package / ".copier-answers.yml").read_text())["spec"]
    nodes = ";".join(node["name"] for node in recorded["nodes"])
    depends = ";".join(sorted(MESSAGES & {*recorded["depends"], "std_msgs"}))
    build = tmp_path / "build"
    build.mkdir()
    options = f"-DPACKAGE={package} '-DNODES={nodes}' '-DDEPENDS={depends}'"
    ros2.run(f"cmake {DATA}/logic_only {options}", build)
    ros2.run("make -j2", build)
    result = ros2.run("ctest", build).stdout
    assert "100% tests passed" in result, result


@pytest.mark.ros2
@pytest.mark.parametrize("distro", ["noetic", "humble", "rolling"])
@pytest.mark.parametrize("spec", [all_kinds(), HOSTILE, None], ids=["all", "hostile", "starter"])
def test_linters(ros2, render, spec, distro):
    package = render(spec, model="cpp_model", ros_distro=distro)
    ros2.run("ament_cpplint .", package)
    for linter in ("uncrustify", "cppcheck"):
        if not shutil.which(linter):
            pytest.skip(f"{linter} is not installed")
        options = "--language C++ " if linter == "uncrustify" else ""
        ros2.run(f"ament_{linter} {options}include src test", package)


@pytest.mark.parametrize("name", SPECS)
def test_logic_is_the_same_for_all_ros(render, name):
    packages = [
        render(SPECS[name], model="cpp_model", ros_distro=distro, name=f"{distro}/same")
        for distro in DISTROS
    ]
    first, *others = [
        {file.name: file.read_bytes() for file in files(package, "*_impl.?pp")}
        for package in packages
    ]
    assert first
    assert all(other == first for other in others)


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_logic_names_no_client_library(render, distro):
    """The interface and the logic include messages alone, so that they compile without ROS."""
    package = render(SPECS["all kinds"], model="cpp_model", ros_distro=distro)
    logic = [*(package / "include").rglob("*.hpp"), *(package / "src").glob("*_impl.cpp")]
    for file in logic:
        text = file.read_text()
        for word in ("rclcpp", "roscpp", "ros/ros.h", "ros::", "tf2_ros", "actionlib/"):
            assert word not in text, f"{file.name} names {word}"
