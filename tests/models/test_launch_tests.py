"""What a package's own test of its launch files sees; tests/data/mutants has it with ROS."""

import ast
import re
import unittest

import pytest

from support.packages import SPECS

LAUNCH = {
    "noetic": "launch/contact_analysis.launch",
    "kilted": "launch/contact_analysis.launch.xml",
}
TYPE = {"noetic": "type", "kilted": "exec"}
FIND = {"noetic": "$(find contact_analysis)", "kilted": "$(find-pkg-share contact_analysis)"}
RIGHT = [
    '<node pkg="{package}" {type}="contact_evaluate" name="again"/>',
    '<node pkg="{package}" {type}="tool.py" name="tool"/>',
    '<node pkg="{package}" {type}="$(arg program)" name="chosen"/>',
    '<node pkg="other" {type}="no_such" name="other"/>',
    '<arg name="map" value="{find}/maps/floor_$(arg number).yaml"/>',
    '<arg name="robot" value="{find}/config/$(arg robot)/base.yaml"/>',
    '<arg name="config" value="{find}/config/contact_evaluate.yaml"/>',
]
WRONG = [
    '<node pkg="{package}" {type}="contact_evaluater" name="again"/>',
    '<arg name="config" value="{find}/config/contact_evaluater.yaml"/>',
]


@pytest.mark.parametrize("distro", LAUNCH)
@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_launch_files(render, model, distro):
    package = render(SPECS["paper"], model=model, ros_distro=distro)
    (package / "tools").mkdir()
    (package / "tools/tool.py").touch()
    tree = ast.parse((package / "test/support/node_tests.py").read_text())
    (method,) = [
        each for each in ast.walk(tree) if getattr(each, "name", "") == "test_launch_files"
    ]
    made = {"re": re}
    exec(compile(ast.Module([method], []), "node_tests.py", "exec"), made)
    case = unittest.TestCase()
    case.root = package
    words = {"package": "contact_analysis", "type": TYPE[distro], "find": FIND[distro]}
    file = package / LAUNCH[distro]
    text = file.read_text()
    for line in RIGHT:
        file.write_text(text.replace("</launch>", f"{line.format(**words)}\n</launch>"))
        made["test_launch_files"](case)
    for line in WRONG:
        file.write_text(text.replace("</launch>", f"{line.format(**words)}\n</launch>"))
        with pytest.raises(AssertionError, match="contact_evaluater"):
            made["test_launch_files"](case)
