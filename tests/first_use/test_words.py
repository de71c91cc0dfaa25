"""What a person reads first: the words while copying, and the README of the package."""

import re

import pytest

from support.packages import QUIET
from support.repository import EXAMPLES, commit, git

LOUD = ("--trust", "--defaults", "--overwrite")
EXAMPLE = EXAMPLES / "all_kinds.ros_package"
USE = {
    "noetic": [
        "catkin_make && . devel/setup.sh",
        "roslaunch arm arm.launch",
        "catkin_make --force-cmake run_tests_arm && catkin_test_results",
    ],
    "kilted": [
        "colcon build --packages-up-to arm && . install/setup.sh",
        "ros2 launch arm arm.launch.xml",
        "colcon test --packages-select arm && colcon test-result --verbose",
    ],
}
TOPIC = '    <publisher name="added" type="std_msgs::String"/>\n  </node>'


@pytest.fixture(params=["python_model", "cpp_model"])
def model(request):
    return request.param


@pytest.mark.parametrize("distro", USE)
def test_words_while_copying(collection, copier_command, tmp_path, model, distro):
    """The last ones are the next three commands; none is about a folder that was there."""
    data = ("-d", f"model={model}", "-d", f"ros_distro={distro}")
    result = copier_command("copy", *LOUD, *data, collection, "arm", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    words = re.sub(r"\x1b\[\d+m", "", result.stderr)
    assert " create  arm.ros_package\n" in words
    assert not re.search(r"identical +\.$", words, re.MULTILINE), words
    last = words.rpartition("arm is ready for ROS")[2]
    for what, command in zip(("build", "run", "test"), USE[distro], strict=True):
        assert re.search(rf"^ +{what}: +{re.escape(command)}$", last, re.MULTILINE), last


@pytest.mark.parametrize("distro", USE)
def test_first_screen_of_the_readme(render, model, distro):
    spec = EXAMPLE.read_text().replace('name="all_kinds"', 'name="arm"')
    package = render(spec, model=model, ros_distro=distro, name="arm")
    screen = "\n".join((package / "README.md").read_text().splitlines()[:36])
    for command in USE[distro]:
        assert command in screen
    for word in ("data.in_NAME", "data.out_NAME", "config.NAME", "passthrough", "log_level"):
        assert word in screen


def test_template_that_an_update_would_not_find(collection, copier_command, tmp_path):
    """Copier records the path as it is given, and looks for it from within the package."""
    (tmp_path / "models").symlink_to(collection)
    for source, is_noted in (("models", True), (tmp_path / "models", False)):
        package = tmp_path / f"arm_{is_noted}".lower()
        arguments = ("copy", "--trust", "--defaults", "-d", "model=python_model")
        said = copier_command(*arguments, source, package, cwd=tmp_path).stderr
        assert ("Note: an update looks for models from within" in said) is is_noted, said
        assert (f"copy from {tmp_path / 'models'}" in said) is is_noted, said


def test_pretended_update_says_what_would_change(render, copier_command):
    """In the words of the update itself, which it leaves to be done."""
    package = render(None, name="arm", model="python_model")
    spec = package / "arm.ros_package"
    spec.write_text(spec.read_text().replace("  </node>", TOPIC, 1))
    logic = package / "arm/example_interface.py"
    logic.write_text(logic.read_text() + "\n# mine\n")
    commit(package)
    result = copier_command("update", "--trust", "--defaults", "--pretend", cwd=package)
    assert result.returncode == 0, result.stderr
    assert "An update would do this; nothing was written." in result.stderr
    assert git(package, "status", "--short") == ""
    said = result.stderr.partition("\n+ publisher added on example\n")[2]
    assert "merged    arm/example_interface.py\n" in said
    real = copier_command("update", "--trust", "--defaults", cwd=package)
    done = real.stderr.partition("\n+ publisher added on example\n")[2]
    assert re.sub("^Done, .*\n", "", done, flags=re.MULTILINE) == said
    commit(package)
    nothing = copier_command("update", "--trust", "--defaults", "--pretend", cwd=package)
    assert "Nothing has changed." in nothing.stderr
    assert copier_command("update", *QUIET, cwd=package).returncode == 0
