"""The package of the contract, built once for each variant, and a stage for each test."""

import dataclasses

import pytest

from support import ros
from support.contract import Peer, Stage, Variant
from support.packages import MODELS, RUNTIME
from support.processes import part

VARIANTS = [
    pytest.param(
        (model, version, runtime),
        id=f"{model}-{distro}{'' if runtime == 'inside' else '-shared'}",
        marks=getattr(pytest.mark, f"ros{version}"),
    )
    for runtime, models in (("inside", MODELS), (RUNTIME.stem, MODELS[:1]))
    for version, distro in ((2, "kilted"), (1, "noetic"))
    for model in models
]
# models/test_runtime_model.py sees that the runtime of a workspace is the same, line by line;
# ros/test_runtime.py builds it in both languages.
SHARED = ("test_order_and_threads", "test_everything_works_in_all_five", "test_exception")


def pytest_collection_modifyitems(config, items):
    """Begin with a part of each variant: while one process builds it, the others have others.

    The runtime of a workspace has its part of the tests.
    """
    extra = [i for i in items if "-shared" in i.name and i.originalname not in SHARED]
    config.hook.pytest_deselected(items=extra)
    items[:] = [item for item in items if item not in extra]
    items.sort(key=lambda item: "variant" in item.fixturenames and part(item.nodeid))


@pytest.fixture(scope="session")
def _ros1(ros1_interfaces):
    """ROS 1 with its master, and the interfaces it lacks."""
    ros1 = ros.ros1()
    with ros.master(ros1):
        yield ros1, ros1_interfaces


@pytest.fixture(scope="session")
def _ros2():
    return ros.ros2() or pytest.skip(ros.NO_ROS2), None


@pytest.fixture(scope="session", params=VARIANTS)
def variant(request, make, once):
    """Each model in each ROS, built."""
    model, version, runtime = request.param
    ros_, underlay = request.getfixturevalue(f"_ros{version}")
    if (model, version) == ("cpp_model", 2) and not ros.has_package(ros_, "rclcpp"):
        pytest.skip("rclcpp is not installed: C++ in ROS 2 is not held to the contract here")
    return Variant(model, ros_, make, once, underlay, runtime)


@pytest.fixture(scope="session")
def humble(_ros2, make, once):
    """The package in Python as it is for Humble, in the ROS 2 that is there."""
    ros_ = dataclasses.replace(_ros2[0], distro="humble")
    return Variant("python_model", ros_, make, once)


@pytest.fixture(scope="session")
def peer(variant, tmp_path_factory):
    """A program that talks to the nodes of a variant."""
    peer = Peer(variant.ros, variant.environment, tmp_path_factory.mktemp("peer"))
    yield peer
    peer.kill()


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    outcome = yield
    if call.when == "call":
        item.stash[_passed] = outcome.get_result().passed


_passed = pytest.StashKey()


@pytest.fixture
def stage(request, variant, peer, tmp_path):
    """A namespace with a peer, where the test starts nodes; at its end all must end well."""
    stage = Stage(variant, peer, tmp_path)
    yield stage
    stage.close(request.node.stash.get(_passed, False))
