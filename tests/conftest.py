"""The fixtures of all tests: the collection, rendering, updating, and ROS."""

import functools
import gc
import inspect
import os
import re
import shutil
import tempfile
from collections import Counter
from pathlib import Path

import copier
import pytest

from support import copier_once, ros
from support.command import run_copier
from support.direct_render import Renderer, variants
from support.model_checks import template
from support.packages import DATA
from support.processes import Scheduling
from support.repository import EXAMPLES, GIT, commit, copy_collection, git, publish

try:
    import fcntl
except ImportError:  # Windows, where the tests run in one process
    fcntl = None

ROOM = 8e9  # bytes
NEEDS = {
    "ros1": "ros1",
    "ros2": "ros2",
    "network": "installers",
    "posix": "copier|collection|github|laboratory|once|own|pairs|published|render|seen|uncloned",
}
"""Marks, and the fixtures whose tests have them."""
POSIX = re.compile(
    r"link|mkfifo|chmod|[\"'](ba|)sh\b|/dev/|/proc/|os\.kill|run_copier|\bgit\(|commit\("
)
"""What tests have in name or text that do what Windows does otherwise."""
LONGEST = """
  test_contract test_mutants test_ros1 test_lab test_ros2 test_runtime test_models test_cpp_model
  test_readme test_mixed test_fuzz test_benchmarks test_driver test_linters test_other_ros
  test_launch test_install test_figure test_configuration test_interfaces
""".split()


def pytest_configure():
    """Work in memory where there is room: git and builds write many small files."""
    memory = Path("/dev/shm")
    if memory.is_dir() and shutil.disk_usage(memory).free > ROOM:
        os.environ.setdefault("TMPDIR", str(memory))
        tempfile.tempdir = None


def pytest_terminal_summary(terminalreporter):
    """Say what was skipped, and why, in a line for each cause."""
    skipped = terminalreporter.stats.get("skipped", [])
    causes = Counter(re.split("[:;]", report.longrepr[2][9:])[0] for report in skipped)
    most = causes.most_common(4)
    for cause, count in most:
        terminalreporter.write_line(f"{count} skipped: {cause}")
    if rest := len(skipped) - sum(count for _, count in most):
        terminalreporter.write_line(f"{rest} skipped for other causes (pytest -rs names them)")


def pytest_collection_modifyitems(config, items):
    """Begin with the files that take minutes, so that no process is left with one at the end."""
    place = {name: number for number, name in enumerate(LONGEST)}
    items.sort(key=lambda item: place.get(item.path.stem, len(LONGEST)))
    for item in items:
        for need in {need for name in item.fixturenames for need in _needs(name)}:
            item.add_marker(need)
        if "posix" in config.option.markexpr and POSIX.search(item.name + _source(item.function)):
            item.add_marker("posix")


@functools.cache
def _needs(fixture):
    return [need for need, names in NEEDS.items() if re.match(rf"_?({names})(_|$)", fixture)]


_source = functools.cache(inspect.getsource)


def pytest_collection_finish():
    """Have the garbage collector look seldom, and not at what lives as long as the tests."""
    gc.freeze()
    gc.set_threshold(100_000, 50, 50)


def pytest_xdist_make_scheduler(config, log):
    return Scheduling(config, log) if config.getoption("dist") == "loadfile" else None


@pytest.fixture(scope="session", autouse=True)
def _clean_environment(tmp_path_factory):
    """Keep the user's git, Copier and ROS settings out of the tests, and the tests out of them."""
    home = tmp_path_factory.mktemp("home")
    with pytest.MonkeyPatch.context() as patch:
        for name, value in {
            **GIT,
            "XDG_CACHE_HOME": str(home / "cache"),
            "XDG_CONFIG_HOME": str(home / "config"),
            "GIT_CONFIG_GLOBAL": str(home / "gitconfig"),
            "GIT_CONFIG_NOSYSTEM": "1",
        }.items():
            patch.setenv(name, value)
        (home / "gitconfig").write_text(
            "[user]\nname = Test Er\nemail = test@example.org\n[init]\ndefaultBranch = main\n"
        )
        patch.delenv("ROS_DISTRO", raising=False)
        copier_once.use(patch, _of_the_run(tmp_path_factory) / "clones")
        yield


def _of_the_run(tmp_path_factory):
    """Return the folder that all processes of a run share."""
    folder = tmp_path_factory.getbasetemp()
    return folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder


@pytest.fixture(scope="session")
def once(tmp_path_factory):
    """Make a folder once in a run, in whichever of its processes needs it first."""
    run = _of_the_run(tmp_path_factory)

    def get(name, make):
        folder, made = run / name, run / f"{name}.made"
        with (run / f"{name}.lock").open("w") as lock:
            if fcntl:
                fcntl.flock(lock, fcntl.LOCK_EX)
            if not made.exists():
                shutil.rmtree(folder, ignore_errors=True)  # another process has failed to
                folder.mkdir()
                make(folder)
                made.touch()
        return folder

    return get


@pytest.fixture(scope="session")
def collection(once):
    """The collection as it is in the working tree, as a repository with the tag 1.0.0."""
    return once("collection", copy_collection)


@pytest.fixture
def own_collection(collection, tmp_path):
    """A collection that the test may change and tag."""
    return shutil.copytree(collection, tmp_path / "own_collection", symlinks=True)


@pytest.fixture(scope="session")
def uncloned(tmp_path_factory):
    """The collection without its history, which Copier would clone each time."""
    return template(tmp_path_factory.mktemp("uncloned") / "collection")


@pytest.fixture(scope="session")
def renderers(uncloned):
    """Every model, ready to render contexts without Copier."""
    return {model: Renderer(uncloned, model) for model, _ in variants()}


@pytest.fixture(scope="session")
def published(collection, once):
    """The folder of all models of the collection, each published as a repository of its own."""
    return once("published", functools.partial(publish, collection))


@pytest.fixture
def github(own_collection, published, tmp_path):
    """Stand in for GitHub, at `org`: a collection, what publishes it, and the way there."""
    host = tmp_path / "github"
    shutil.copytree(published, host / "org")
    return (
        own_collection,
        lambda: publish(own_collection, host / "org"),
        {
            "GIT_CONFIG_COUNT": "1",
            "GIT_CONFIG_KEY_0": f"url.file://{host}/.insteadOf",
            "GIT_CONFIG_VALUE_0": "https://github.com/",
        },
    )


@pytest.fixture(scope="session")
def make(published, tmp_path_factory):
    """Make a package in a folder from a spec; of the same spec and data it is made only once."""
    made = {}

    def run(folder, spec, *, model="python_model", **data):
        data = {"ros_distro": "kilted", **data}
        key = (spec.read_bytes(), model, *sorted(data.items()))
        if key not in made:
            made[key] = tmp_path_factory.mktemp("made") / "package"
            copy(published / f"{model}.git", made[key], spec_file=str(spec), **data)
        shutil.copytree(made[key], folder, dirs_exist_ok=True)

    return run


def copy(template, folder, vcs_ref=None, **data):
    options = {"defaults": True, "unsafe": True, "quiet": True}
    copier.run_copy(str(template), folder, data=data, vcs_ref=vcs_ref, **options)


@pytest.fixture
def render(make, published, tmp_path):
    """Render a package from a spec, given as a file or as XML, and commit it to git.

    A `template` is a collection; without one, the model is that of a repository of its own.
    """

    def run(spec=None, *, template=None, vcs_ref=None, name="package", **data):
        folder = tmp_path / name
        if isinstance(spec, str):
            file = tmp_path / "specs" / f"{folder.name}.xml"
            file.parent.mkdir(exist_ok=True)
            file.write_text(spec, encoding="utf-8")
            spec = file
        data = {"model": "python_model", "ros_distro": "kilted", **data}
        if spec is not None and template is None:
            make(folder, spec, **data)
        else:
            data |= {"spec_file": str(spec)} if spec else {}
            template = template or published / f"{data.pop('model')}.git"
            copy(template, folder, vcs_ref, **data)
        commit(folder, "Render")
        return folder

    return run


@pytest.fixture
def update():
    """Update a committed package as `copier update --trust --defaults` does."""

    def run(package, **data):
        copier.run_update(
            package, data=data, defaults=True, unsafe=True, quiet=True, overwrite=True
        )
        return git(package, "status", "--short")

    return run


@pytest.fixture
def copier_command():
    """Run the copier command as a user would; the result has returncode, stdout and stderr."""

    def run(*arguments, cwd, **environment):
        return run_copier(arguments, cwd, environment)

    return run


@pytest.fixture
def ros1():
    """ROS 1, or skip."""
    return ros.ros1() or pytest.skip(ros.NO_ROS1)


@pytest.fixture
def ros2():
    """ROS 2, or skip."""
    return ros.ros2() or pytest.skip(ros.NO_ROS2)


@pytest.fixture(scope="session")
def put(make):
    """Put the package that stands whole beside a spec into a workspace; else render it."""

    def run(spec, model, distro, workspace):
        package = workspace / "src" / spec.stem
        shown = spec.with_suffix("") / model / distro
        if (shown / ".copier-answers.yml").exists():  # which no part has
            shutil.copytree(shown, package)
        else:
            make(package, spec, model=model, ros_distro=distro)

    return run


@pytest.fixture(scope="session")
def ros1_interfaces(put, once):
    """A workspace with the interfaces that ROS 1 lacks."""
    ros1 = ros.ros1() or pytest.skip(ros.NO_ROS1)

    def build(workspace):
        shutil.copytree(DATA / "test_msgs", workspace / "src/test_msgs")
        put(EXAMPLES / "contact_msgs.ros_package", "interfaces_model", ros1.distro, workspace)
        ros1.build(workspace)

    return once("ros1_interfaces", build)
