"""What `make demo` shows: a package made, run, talked to, and updated with its logic."""

import html
import os
import re
import subprocess
import sys

import pytest

from support import ros
from support.repository import ROOT

DEMO = (sys.executable, "demo/demo.py")
ENVIRONMENT = os.environ | {"PYTHONPATH": "tests"}


@pytest.fixture(scope="module")
def told(collection):
    """What the demo of the collection prints where there is a ROS."""
    _ = ros.ros2() or ros.ros1() or pytest.skip("no ROS is installed")
    link = collection / ".venv"
    link.symlink_to(ROOT / ".venv")
    try:
        yield run_demo(collection)
    finally:
        link.unlink()


def run_demo(collection, *options):
    result = subprocess.run(
        [*DEMO, *options], cwd=collection, env=ENVIRONMENT, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def test_node_is_talked_to(told):
    """The service and the action answer, and the topic followed the logic."""
    assert "service enable   True: The robot may drive." in told
    assert "action spiral    succeeded: [1, 1, 2, 3, 5, 8, 13, 21], after 6 feedbacks" in told
    assert re.search(r"turned with up to 0\.25 rad/s, now stands still", told)


def test_update_keeps_the_logic(told):
    updated = told.partition("$ copier update")[2]
    assert "+ subscriber battery on driver" in updated
    assert re.search(r"^(\d+) of \1 of your lines are in their place$", updated, re.MULTILINE)
    assert "driver_interface.py" in updated.partition("--stat")[2]
    assert "driver_impl.py" not in updated.partition("--stat")[2]


def test_without_ros(own_collection):
    """The package is made, shown and updated; that it is not run is said.

    What is not committed in the collection does no harm.
    """
    (own_collection / "README.md").write_text("changed\n")
    told = run_demo(own_collection, "--without-ros")
    assert "No ROS is found on this machine" in told
    assert "service enable" not in told
    test_update_keeps_the_logic(told)


def test_picture_shows_the_demo(told):
    """The picture of the README is of what the demo prints today."""
    if "ROS 2 (kilted)" not in told:
        pytest.skip("the picture is of the demo in ROS 2 Kilted")
    assert "docs/demo.svg" in (ROOT / "README.md").read_text()
    rows = {}
    for y, text in re.findall(r'<text[^>]*? y="([\d.]+)"[^>]*>(.*?)</text>', picture()):
        rows[y] = rows.get(y, "") + html.unescape(text).replace("\xa0", " ")
    shown = [row.rstrip() for row in rows.values()]
    missing = [line for line in told.splitlines() if line.strip() and line.rstrip() not in shown]
    assert not missing, f"make picture: {missing}"


def picture():
    return (ROOT / "docs/demo.svg").read_text()
