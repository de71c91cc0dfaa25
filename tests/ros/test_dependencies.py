"""A generated package of ROS 1 configures and builds with nothing but what it declares.

What it does not declare is hidden below empty folders, in a mount namespace of the build's own;
so are the tests' dependencies, gtest among them: a package is built where nobody tests it, too.
"""

import shlex
import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from support.packages import DATA
from support.repository import EXAMPLES

SHARE, INCLUDE = Path("/usr/share"), Path("/usr/include")
CMAKE = list(Path("/usr/lib").glob("*/cmake"))
GTEST = [
    Path("/usr/src/googletest"),
    INCLUDE / "gtest",
    *(folder / "GTest" for folder in CMAKE),
]


@pytest.fixture(scope="module")
def namespace():
    """Return the start of a command with mounts of its own."""
    for command in (["unshare", "-m"], ["unshare", "-rm"]):
        if not shutil.which(command[0]):
            break
        trial = [*command, "mount", "-t", "tmpfs", "none", "/usr/src"]
        if subprocess.run(trial, capture_output=True).returncode == 0:
            return command
    pytest.skip("this user may not hide folders (unshare -m)")


def declared(file, *ignored):
    """Return what a package.xml names as dependencies, without those of some tags."""
    return {
        element.text.strip()
        for element in ET.parse(file).getroot()
        if element.tag.endswith("depend") and element.tag not in ignored
    }


def needed(package):
    """Return what a package needs unless it is tested, and what comes with that."""
    found, names = set(), declared(package / "package.xml", "test_depend")
    while names:
        name = names.pop()
        found.add(name)
        if (file := SHARE / name / "package.xml").exists():
            ignored = ("build_depend", "buildtool_depend", "doc_depend", "test_depend")
            names |= declared(file, *ignored) - found
    return found


@pytest.mark.ros1
def test_builds_with_what_it_declares(ros1, ros1_interfaces, namespace, tmp_path, model):
    package = tmp_path / "src/all_kinds"
    shutil.copytree(EXAMPLES / "all_kinds" / model / "noetic", package)
    needs = (needed(package) | needed(DATA / "test_msgs")) - {"rostest", "rosunit"}
    installed = {file.parent.name for file in SHARE.glob("*/package.xml")}
    assert "catkin" in installed & needs
    assert "rostest" in installed - needs
    hidden = [place / name for name in installed - needs for place in (SHARE, INCLUDE, *CMAKE)]
    mounts = [f"mount -t tmpfs none {path}" for path in [*hidden, *GTEST] if path.is_dir()]
    (tmp_path / "build.sh").write_text("\n".join(["set -e", *mounts, "exec catkin_make", ""]))
    built = ros1.run(shlex.join([*namespace, "sh", "build.sh"]), tmp_path, ros1_interfaces).stdout
    assert "warning:" not in built
