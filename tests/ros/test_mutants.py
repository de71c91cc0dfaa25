"""The tests that a package brings notice every fault that data/mutants puts into its code."""

import dataclasses
import re
import shlex
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import pytest
import yaml

from support import ros
from support.packages import DATA, all_kinds, without_tf


@dataclass(frozen=True)
class Mutant:
    """A fault: in a file of the package, one text in place of another; `test` notices it."""

    test: str
    file: str
    old: str
    new: str

    def apply(self, package):
        path = package / self.file
        text = path.read_text()
        assert self.old in text, f"{self.file} has no {self.old}"
        path.write_text(text.replace(self.old, self.new))


def mutants_of(variant):
    """Return the mutants of a variant by their faults."""
    faults = yaml.safe_load((DATA / f"mutants/{variant}.yaml").read_text())
    return {fault: Mutant(**fields) for fault, fields in faults.items()}


class Python:
    """all_kinds for Python. A mutant is a copy of it, which needs no build."""

    at_once = 8  # they wait more than they compute
    passed = r"^OK$"
    failed = r"^(FAIL|ERROR): {test} "

    def __init__(self, ros, package, workspace=None):
        self.ros = ros
        self.package = package
        self.workspace = workspace

    def run(self, name, mutant=None):
        """Run the test that is to notice a mutant, or all tests; return what they print."""
        copy = self.package.parent / name.replace(" ", "_")
        shutil.copytree(self.package, copy, ignore=shutil.ignore_patterns(".git"))
        chosen = ""
        if mutant:
            mutant.apply(copy)
            chosen = f"-k {mutant.test}"
        return self.unittest(copy, f"test_worker_node {chosen}")

    def unittest(self, package, tests):
        command = f"env PYTHONPATH={package}:$PYTHONPATH {self.ros.python} -m unittest {tests}"
        return self.ros.run(command, package / "test", self.workspace, check=False).stdout


@pytest.fixture
def python_kilted(ros2, render):
    return Python(ros2, render(without_tf(all_kinds()), ros_distro=ros2.distro))


class PythonRos1(Python):
    def unittest(self, package, tests):
        """Run tests with a master of their own."""
        own = dataclasses.replace(self.ros, environment=ros.ros1().environment)
        with ros.master(own, "rosmaster"):
            return Python(own, package, self.workspace).unittest(package, tests)


@pytest.fixture
def python_noetic(ros1, ros1_interfaces, render, tmp_path):
    package = render(all_kinds(), ros_distro="noetic", name="src/all_kinds")
    ros1.build(tmp_path, ros1_interfaces)
    built = tmp_path / "devel/lib/python3/dist-packages/all_kinds/cfg"
    shutil.copytree(built, package / "all_kinds/cfg")
    return PythonRos1(ros1, package, tmp_path)


class Cpp:
    """all_kinds for C++, with all mutants in one build; the environment chooses one."""

    passed = Python.passed
    failed = Python.failed
    flags = f"{ros.COMPILER_FLAGS} -include {DATA}/mutants/is_mutant.hpp"
    flags = f"-DCMAKE_CXX_FLAGS='{flags}'"

    def __init__(self, package, variant):
        """Put the mutants into the package."""
        self.package = package
        for name, mutant in mutants_of(variant).items():
            chosen = mutant.new.replace("MUTANT", f'is_mutant("{name}")')
            dataclasses.replace(mutant, new=chosen).apply(package)

    def unittest(self, ros, name, mutant, workspace=None, **environment):
        """Run the test that is to notice a mutant, or all tests; return what they print."""
        settings = shlex.join(f"{key}={value}" for key, value in environment.items())
        chosen = f"-k {mutant.test}" if mutant else ""
        start = f"env MUTANT={shlex.quote(name)} {settings} {ros.python} -m unittest"
        folder = self.package / "test"
        return ros.run(f"{start} test_worker_node {chosen}", folder, workspace, check=False).stdout


class CppRos1(Cpp):
    at_once = 6

    def run(self, name, mutant=None):
        """Run tests with a master of their own."""
        own = ros.ros1()
        with ros.master(own, "rosmaster"):
            return self.unittest(own, name, mutant, self.package.parents[1])


@pytest.fixture
def cpp_noetic(ros1, ros1_interfaces, render, tmp_path):
    options = {"model": "cpp_model", "ros_distro": "noetic", "name": "src/all_kinds"}
    cpp = CppRos1(render(all_kinds(), **options), "cpp_noetic")
    targets = "all_kinds_worker all_kinds_test_worker_recorder"
    ros1.run(f"catkin_make {cpp.flags} {targets}", tmp_path, ros1_interfaces, timeout=3600)
    return cpp


class CppRos2(Cpp):
    at_once = 4

    def __init__(self, ros, package, variant, build):
        super().__init__(package, variant)
        self.ros = ros
        self.programs = {"NODE": build / "worker", "RECORDER": build / "test_worker_recorder"}

    def run(self, name, mutant=None):
        return self.unittest(self.ros, name, mutant, **self.programs)


@pytest.fixture
def cpp_kilted(ros2, render, tmp_path):
    if not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    spec = all_kinds() if ros.has(ros2, "tf2_ros") else without_tf(all_kinds())
    package = render(spec, model="cpp_model", ros_distro=ros2.distro)
    build = tmp_path / "build"
    cpp = CppRos2(ros2, package, "cpp_kilted", build)
    ros2.run(f"cmake -S {package} -B {build} {cpp.flags}", tmp_path)
    targets = "worker test_worker_recorder"
    ros2.run(f"cmake --build {build} --target {targets}", tmp_path, timeout=3600)
    return cpp


VARIANTS = [
    pytest.param("cpp_kilted", marks=pytest.mark.ros2),
    pytest.param("cpp_noetic", marks=pytest.mark.ros1),
    pytest.param("python_kilted", marks=pytest.mark.ros2),
    pytest.param("python_noetic", marks=pytest.mark.ros1),
]


@pytest.mark.parametrize("variant", VARIANTS)
def test_every_mutant_dies(variant, request):
    mutants = mutants_of(variant)
    assert len(mutants) >= 13
    package = request.getfixturevalue(variant)
    with ThreadPoolExecutor(package.at_once) as pool:
        whole = pool.submit(package.run, "the package itself")
        running = {name: pool.submit(package.run, name, mutants[name]) for name in mutants}
    assert re.search(package.passed, whole.result(), re.M), whole.result()
    for name, future in running.items():
        failed = package.failed.format(test=mutants[name].test)
        assert re.search(failed, future.result(), re.M), f"{name} survives:\n{future.result()}"
