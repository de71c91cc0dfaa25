"""What mypy says of a Python package: nothing while its logic is right."""

import re
import shutil
import sys

import pytest

from support import ros
from support.packages import DATA, all_kinds


@pytest.mark.ros1
def test_mypy_finds_what_is_misspelt_in_ros1(ros1, ros1_interfaces, render, tmp_path):
    package = render(all_kinds(), ros_distro="noetic", name="src/all_kinds")
    ros1.build(tmp_path, ros1_interfaces)
    built = tmp_path / "devel/lib/python3/dist-packages/all_kinds/cfg"
    shutil.copytree(built, package / "all_kinds/cfg")
    check(ros1, package, tmp_path)


@pytest.mark.ros2
def test_mypy_finds_what_is_misspelt_in_ros2(ros2, render):
    check(ros2, render(ros.fitting(ros2, all_kinds()), ros_distro=ros2.distro))


def check(ros_, package, *workspace):
    def errors():
        mypy = f"{sys.executable} -m mypy --strict --python-executable $(command -v {ros_.python})"
        printed = ros_.run(mypy, package, *workspace, check=False).stdout
        assert "source files" in printed, printed
        found = re.findall(r"^all_kinds/([\w/]+)\.py:(\d+): error: (.*)", printed, re.M)
        return {(file, int(line)): text for file, line, text in found}

    assert (found := errors()) == {}, found
    logic = package / "all_kinds/worker_impl.py"
    logic.write_text(logic.read_text() + (DATA / "logic/misspelt.py").read_text())
    lines = enumerate(logic.read_text().splitlines(), 1)
    wrong = {
        ("worker_impl", number): line.split("# error: ")[1]
        for number, line in lines
        if "# error: " in line
    }
    found = errors()
    assert found.keys() == wrong.keys()
    assert all(word in found[number] for number, word in wrong.items()), found
