"""What a spec says of the package itself: executables, folders, dependencies, whose it is."""

import os
import xml.etree.ElementTree as ET
from time import sleep

import pytest

from support.ros import has_package

SPEC = """<package name="arm" author="Ada" author_email="ada@example.org" description="d"
         license="MIT" version="1.2.3">
  <node name="reach" frequency="10" executable="reach-node" {language}/>
  <folder name="urdf"/>
  <folder name="later"/>
  <folder name="tools" holds="programs"/>
  <maintainer name="Grace &amp; Co" email="grace@example.org"/>
  <url address="https://example.org/?a=1&amp;b=2"/>
  <url address="https://example.org/arm.git" type="repository"/>
  <depend kind="exec">joy</depend>
  <depend kind="build">std_msgs</depend>
  <depend kind="test">python3-numpy</depend>
</package>
"""
MODELS = ["python_model", "cpp_model", "mixed_model python", "mixed_model cpp"]
FILES = ["config/left/arm.yaml", "launch/old/arm.txt", "urdf/hand/finger.urdf", "tools/calibrate"]
each_model = pytest.mark.parametrize("model", MODELS)


def make(render, model, distro, folder):
    model, _, language = model.partition(" ")
    spec = SPEC.format(language=language and f'language="{language}"')
    package = render(spec, model=model, ros_distro=distro, name=f"{folder}/arm")
    for name in FILES:
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text("#!/bin/sh\necho calibrated\n")
    (package / "tools/calibrate").chmod(0o755)
    (package / "tools/parts").mkdir()
    return package


def check_installed(prefix):
    share, programs = prefix / "share/arm", prefix / "lib/arm"
    for name in FILES[:3]:
        assert (share / name).is_file(), name
    for name in ("calibrate", "reach-node"):
        assert os.access(programs / name, os.X_OK), name


@each_model
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_package_xml(render, model, distro):
    root = ET.parse(make(render, model, distro, "package") / "package.xml").getroot()

    def found(tag):
        return [element.text for element in root.iter(tag)]

    assert found("version") == ["1.2.3"]
    assert found("maintainer") == ["Ada", "Grace & Co"]
    assert [url.get("type") for url in root.iter("url")] == ["website", "repository"]
    assert found("url")[0] == "https://example.org/?a=1&b=2"
    assert found("exec_depend").count("joy") == 1
    assert found("test_depend").count("python3-numpy") == 1
    assert found("build_depend") == ["std_msgs"]
    generic = set(found("depend"))
    assert not generic & {*found("build_depend"), *found("exec_depend"), *found("test_depend")}


@pytest.mark.ros1
@each_model
def test_what_is_installed_in_ros1(ros1, render, tmp_path, model):
    make(render, model, "noetic", "src")
    ros1.run("catkin_make install", tmp_path, timeout=1800)
    check_installed(tmp_path / "install")


@pytest.mark.ros2
@each_model
def test_what_is_installed_in_ros2(ros2, render, tmp_path, model):
    if "cpp" in model and not has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    make(render, model, ros2.distro, "src")
    ros2.run(f"{ros2.build_command} --cmake-args -DBUILD_TESTING=OFF", tmp_path, timeout=1800)
    check_installed(tmp_path / "install/arm")
    with ros2.running(tmp_path / "install/arm/lib/arm/reach-node", tmp_path):
        sleep(3)  # it ends by itself where it cannot start
