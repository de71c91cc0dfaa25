"""The tests that a package brings notice every fault that data/mutants puts into its code.

`make test` tries some of the faults, by another choice each day; `make mutants` tries all.
"""

import dataclasses
import datetime
import os
import random
import re
import shlex
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import pytest
import yaml

from support import ros
from support.linters import write
from support.model_checks import Model
from support.own_tests import UNTESTED, differences
from support.packages import DATA, all_kinds
from support.repository import EXAMPLES, ROOT

PATIENT = f"TEST_TIMEOUT={ros.PATIENCE}"
IMPATIENT = "TEST_TIMEOUT=20"
WANTED = os.environ.get("MUTANTS")
SOME = 6
FAILING = r"^(?:FAIL|ERROR): (\w+) "
TODAY = datetime.date.today().isoformat()
BUILT = "all_kinds/cfg"
"""Where a Python package for ROS 1 has what dynamic_reconfigure makes."""


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


KINDS = {"synchronizer": "synchronizer", "transform": "listener", "lookup": "listener"}
"""Words of faults that are of a kind which a ROS may lack."""


def mutants_of(variant, package):
    """Return the mutants of a variant by their faults; `package` may lack some kinds."""
    spec = (package / "all_kinds.ros_package").read_text()
    lacking = [word for word, kind in KINDS.items() if f"<{kind} " not in spec]
    faults = yaml.safe_load((DATA / f"mutants/{variant}.yaml").read_text())
    return {
        fault: Mutant(**fields)
        for fault, fields in faults.items()
        if not any(word in fault for word in lacking)
    }


def chosen(mutants):
    """Return the names of the mutants to try."""
    if WANTED:
        return [name for name in mutants if re.search(WANTED, name)]
    return random.Random(TODAY).sample(list(mutants), SOME)


class Python:
    """all_kinds for Python. A mutant is a copy of it, which needs no build."""

    at_once = 2  # they wait more than they compute
    passed = r"^OK$"
    failed = r"^(FAIL|ERROR): ({test}|setUpClass|tearDownClass) "

    def __init__(self, ros, package, workspace=None):
        self.ros = ros
        self.package = package
        self.workspace = workspace

    def run(self, name, tests, mutant=None):
        """Run tests, which are to notice a mutant or to pass without; return what they print."""
        copy = self.package.parent / re.sub(r"\W", "_", name)
        shutil.copytree(self.package, copy, ignore=shutil.ignore_patterns(".git"))
        if mutant:
            mutant.apply(copy)
        return self.unittest(copy, f"test_worker_node {tests}", passes=not mutant)

    def unittest(self, package, tests, passes):
        """Run tests, patiently if they are to pass, as they share the machine with others."""
        start = f"env {PATIENT if passes else IMPATIENT} PYTHONPATH={package}:$PYTHONPATH"
        command = f"{start} {self.ros.python} -m unittest {tests}"
        return self.ros.run(command, package / "test", self.workspace, check=False).stdout


@pytest.fixture
def python_kilted(ros2, render):
    return Python(ros2, render(ros.fitting(ros2, all_kinds()), ros_distro=ros2.distro))


class PythonRos1(Python):
    def unittest(self, package, tests, passes):
        """Run tests with a master of their own."""
        own = dataclasses.replace(self.ros, environment=ros.ros1().environment)
        with ros.master(own, "rosmaster"):
            return Python(own, package, self.workspace).unittest(package, tests, passes)


@pytest.fixture
def python_noetic(ros1, ros1_interfaces, render, tmp_path):
    package = render(all_kinds(), ros_distro="noetic", name="src/all_kinds")
    ros1.build(tmp_path, ros1_interfaces)
    shutil.copytree(tmp_path / "devel/lib/python3/dist-packages" / BUILT, package / BUILT)
    return PythonRos1(ros1, package, tmp_path)


class Cpp:
    """all_kinds for C++, with all mutants in one build; the environment chooses one."""

    passed = Python.passed
    failed = Python.failed
    flags = f'env CXXFLAGS="$CXXFLAGS -include {DATA}/mutants/is_mutant.hpp"'

    def __init__(self, package, variant):
        """Put the mutants into the package."""
        self.package = package
        for name, mutant in mutants_of(variant, package).items():
            chosen = mutant.new.replace("MUTANT", f'is_mutant("{name}")')
            dataclasses.replace(mutant, new=chosen).apply(package)

    def unittest(self, ros, name, tests, mutant, workspace=None, **environment):
        """Run tests, which are to notice a mutant or to pass without; return what they print."""
        settings = shlex.join(f"{key}={value}" for key, value in environment.items())
        patience = IMPATIENT if mutant else PATIENT
        start = f"env {patience} MUTANT={shlex.quote(name)} {settings} {ros.python} -m unittest"
        folder = self.package / "test"
        return ros.run(f"{start} test_worker_node {tests}", folder, workspace, check=False).stdout


class CppRos1(Cpp):
    at_once = 3

    def run(self, name, tests, mutant=None):
        """Run tests with a master of their own."""
        own = ros.ros1()
        with ros.master(own, "rosmaster"):
            return self.unittest(own, name, tests, mutant, self.package.parents[1])


@pytest.fixture
def cpp_noetic(ros1, ros1_interfaces, render, tmp_path):
    options = {"model": "cpp_model", "ros_distro": "noetic", "name": "src/all_kinds"}
    cpp = CppRos1(render(all_kinds(), **options), "cpp_noetic")
    targets = "all_kinds_worker all_kinds_test_worker_recorder"
    ros1.run(f"{cpp.flags} catkin_make {targets}", tmp_path, ros1_interfaces, timeout=3600)
    return cpp


class CppRos2(Cpp):
    at_once = 2

    def __init__(self, ros, package, variant, build):
        super().__init__(package, variant)
        self.ros = ros
        self.programs = {"NODE": build / "worker", "RECORDER": build / "test_worker_recorder"}

    def run(self, name, tests, mutant=None):
        return self.unittest(self.ros, name, tests, mutant, **self.programs)


@pytest.fixture
def cpp_kilted(ros2, render, tmp_path):
    if not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    package = render(ros.fitting(ros2, all_kinds()), model="cpp_model", ros_distro=ros2.distro)
    build = tmp_path / "build"
    cpp = CppRos2(ros2, package, "cpp_kilted", build)
    ros2.run(f"{cpp.flags} cmake -S {package} -B {build}", tmp_path)
    targets = "worker test_worker_recorder"
    ros2.run(f"cmake --build {build} --target {targets}", tmp_path, timeout=3600)
    return cpp


VARIANTS = [
    pytest.param("cpp_kilted", marks=pytest.mark.ros2),
    pytest.param("cpp_noetic", marks=pytest.mark.ros1),
    pytest.param("python_kilted", marks=pytest.mark.ros2),
    pytest.param("python_noetic", marks=pytest.mark.ros1),
]


@pytest.mark.parametrize("variant", [param.values[0] for param in VARIANTS])
def test_every_mutant_changes_the_package(variant, tmp_path):
    """Said where the ROS of the variant is not installed, too."""
    language, distro = variant.split("_")
    package = tmp_path / "package"
    shutil.copytree(EXAMPLES / f"all_kinds/{language}_model/{distro}", package)
    if language == "cpp":
        Cpp(package, variant)  # each applied to what the others have made
        return
    for mutant in mutants_of(variant, package).values():
        if (package / mutant.file).parent != package / BUILT:
            assert mutant.old in (package / mutant.file).read_text(), mutant


@pytest.mark.parametrize("variant", VARIANTS)
def test_every_mutant_dies(variant, request):
    package = request.getfixturevalue(variant)
    mutants = mutants_of(variant, package.package)
    assert len(mutants) >= 80
    tried = {name: mutants[name] for name in chosen(mutants)}
    tests = {name: f"-k {mutant.test}" for name, mutant in tried.items()}
    with ThreadPoolExecutor(package.at_once) as pool:
        sound = pool.submit(package.run, "the package itself", " ".join({*tests.values()}))
        running = {
            name: pool.submit(package.run, name, tests[name], mutant)
            for name, mutant in tried.items()
        }
    assert re.search(package.passed, sound.result(), re.M), sound.result()
    surviving = [
        f"{name} survives:\n{future.result()}"
        for name, future in running.items()
        if not re.search(package.failed.format(test=mutants[name].test), future.result(), re.M)
    ]
    assert not surviving, "\n".join(surviving)


def other_packages(renderer, distro, lacking):
    """Yield pairs of packages, and what their specs differ in, which the tests of packages know.

    Each day has an order of its own; a pair is rendered when its turn comes. Those that import
    what this ROS is lacking are left out.
    """
    model = Model(ROOT / "python_model")
    pairs = list(differences(model, UNTESTED))
    random.Random(TODAY).shuffle(pairs)
    for what, *elements in pairs:
        texts = [model.spec(each).replace("tf2_msgs::Lookup", "test_msgs::") for each in elements]
        texts = [text.replace("test_msgs::Transform", "test_msgs::Fibonacci") for text in texts]
        pair = [renderer.render(model.context(text, "kilted"), distro) for text in texts]
        code = "".join(
            text for files in pair for path, text in files.items() if path[-3:] == ".py"
        )
        if any(re.search(rf"^ *(from|import) {module}\b", code, re.M) for module in lacking):
            continue
        tests = [{p: text for p, text in files.items() if "_node.py" in p} for files in pair]
        if tests[0] != tests[1]:  # else it is the same in other words, such as a default
            yield what.replace(" ", "_"), pair


def test_a_node_of_another_spec_dies(ros2, renderers, tmp_path):
    """Without an interface of the spec, or with another value of an attribute, tests fail."""
    lacking = [name for name in ("tf2_ros", "message_filters") if not ros.has(ros2, name)]
    tried = {}
    for name, pair in other_packages(renderers["python_model"], ros2.distro, lacking):
        if WANTED and not re.search(WANTED, name) or name in tried:
            continue
        tried[name] = pair
        if len(tried) == SOME and not WANTED:
            break
    for name, (own, other) in tried.items():
        tests = {path: text for path, text in own.items() if path.startswith("test/")}
        write(tmp_path / name / "own", own)
        write(tmp_path / name / "other", other | tests)

    def run(name):
        """Return what the first test that fails prints, and what it prints for its own package."""
        (tests,) = {f.stem for f in (tmp_path / name / "own/test").glob("test_*_node.py")}
        own, other = (Python(ros2, tmp_path / name / each) for each in ("own", "other"))
        failing = other.unittest(other.package, f"-f {tests}", passes=False)
        found = re.search(FAILING, failing, re.M)
        if not found:
            return failing, None
        chosen = "" if found[1] == "setUpClass" else f"-k {found[1]}"
        return failing, own.unittest(own.package, f"{tests} {chosen}", passes=True)

    with ThreadPoolExecutor(Python.at_once) as pool:
        printed = dict(zip(tried, pool.map(run, tried), strict=True))
    for name, (other, own) in printed.items():
        assert own, f"{name} survives:\n{other}"
        assert re.search(Python.passed, own, re.M), f"{name}:\n{own}"
