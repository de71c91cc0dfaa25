"""The logic that obeys a package's tests: an order is for the next call, not for one reported."""

import runpy

import pytest

from support import ros
from support.packages import DATA

SPEC = """
<package name="mypkg" author="A" author_email="a@b.example.org" description="d" license="MIT">
  <node name="drive" frequency="50"/>
</package>
"""
PROGRAM = DATA / "logic/order_at_report"


def python(ros_, render):
    package = render(SPEC, ros_distro=ros_.distro)
    path = f"PYTHONPATH={package}/test/support:{package}:$PYTHONPATH"
    return ros_.run(f"echo | env {path} {ros_.python} {PROGRAM}.py", "/").stdout


@pytest.mark.ros1
def test_python_in_ros1(ros1, render):
    assert python(ros1, render) == "True False\n"


@pytest.mark.ros2
def test_python_in_ros2(ros2, render):
    assert python(ros2, render) == "True False\n"


@pytest.mark.ros1
def test_cpp(ros1, render, tmp_path):
    package = render(SPEC, model="cpp_model", ros_distro="noetic")
    folders = f"-I{package}/test/support/recorder -I{package}/include"
    flags = f"-std=c++17 {ros.GCC['CXXFLAGS']} {folders}"
    libraries = "-lroscpp_serialization -lrostime -pthread"
    ros1.run(f"c++ {flags} -o program {PROGRAM}.cpp {libraries}", tmp_path)
    assert ros1.run("./program", tmp_path).stdout == "1 0\n"


def test_node_that_ends_before_it_reports_its_failure(render, monkeypatch):
    package = render(SPEC, ros_distro="kilted")
    monkeypatch.setenv("TEST_TIMEOUT", "5")
    running = runpy.run_path(str(package / "test/support/running.py"))
    program = """read none; read order; echo 'report ["begun", "fail"]'"""
    node = running["RunningNode"]("drive", ["sh", "-c", program])
    assert node.order("now", "fail=lost") == "fail"
    assert node.exit_code() == 0
