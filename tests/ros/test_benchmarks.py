"""The benchmarks of nodes run, each for a moment; no time is held against them."""

import sys
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest

from benchmarks.compare import MODELS, SPEC, Effort, Node, Variant, compare, master, picture, table
from support import ros


def check(model, ros_, make, workspace):
    """Build both sides and measure them; make a table and a picture of that."""

    def render(folder, model, distro):
        make(folder, SPEC, model=model, ros_distro=distro)

    found = compare([Variant(model, ros_, workspace, render)], Effort(1, 0.5, 3))
    for values in found.values():
        assert all(time > 0.0 for sides in values.values() for time in sides), values
        assert len(table(found).splitlines()) == len(values) + 2
    ElementTree.fromstring(picture(found))


@pytest.mark.parametrize("model", MODELS)
def test_nodes_in_ros1(ros1, make, model, tmp_path):
    with master(ros1):
        check(model, ros1, make, tmp_path)


@pytest.mark.parametrize("model", MODELS)
def test_nodes_in_ros2(ros2, make, model, tmp_path):
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    check(model, ros2, make, tmp_path)


def test_threads_that_end():
    """A thread that ends while a node is watched does not end the benchmark."""
    code = "import threading\nwhile True:\n    threading.Thread(target=int).start()"
    variant = SimpleNamespace(command=lambda *_: [sys.executable, "-c", code], environment={})
    with Node(variant, "generated", "node") as node:
        node.start()
        for _ in range(2000):
            with node.span():
                pass
