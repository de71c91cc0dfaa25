"""Copy and update without network, as docs/developers.md tells."""

import os
import subprocess
import sys

import pytest

from support.documentation import blocks
from support.packages import QUIET
from support.repository import commit

CLONE, USE = blocks("docs/developers.md", "Without network")
TOPIC = '    <publisher name="added" type="std_msgs::String"/>\n  </node>'


@pytest.fixture(scope="module")
def cut_off():
    """Return the start of a command that cuts the network off from what follows."""
    for command in (["unshare", "-n"], ["unshare", "-rn"]):
        try:
            if subprocess.run([*command, "true"], capture_output=True).returncode == 0:
                return command
        except FileNotFoundError:
            break
    pytest.skip("this user may not cut the network off (unshare -n)")


def test_copy_and_update_without_network(cut_off, github, tmp_path):
    *_, way_to_github = github
    environment = os.environ | {"HOME": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path / "cache")}
    environment |= {"GIT_CONFIG_GLOBAL": str(tmp_path / ".gitconfig")}

    def run(*command, cwd=tmp_path, **more):
        return subprocess.run(
            command, cwd=cwd, env=environment | more, capture_output=True, text=True
        )

    def copier(*arguments, cwd=tmp_path, **more):
        return run(*cut_off, sys.executable, "-m", "copier", *arguments, cwd=cwd, **more)

    assert copier("copy", *QUIET, "gh:org/python_model", "arm", **way_to_github).returncode == 0
    package = tmp_path / "arm"
    commit(package)
    spec = package / "arm.ros_package"
    spec.write_text(spec.read_text().replace("  </node>", TOPIC, 1))
    commit(package, "Add a topic")
    assert copier("update", *QUIET, cwd=package).returncode != 0
    assert run("bash", "-ec", CLONE, **way_to_github).returncode == 0
    assert run("bash", "-ec", USE).returncode == 0
    for options in ((), ("--vcs-ref=:current:",)):
        result = copier("update", *QUIET, *options, cwd=package)
        assert result.returncode == 0, result.stderr
        assert "out_added" in (package / "arm/example_interface.py").read_text()
        commit(package)
    assert copier("copy", *QUIET, "gh:org/python_model", "other").returncode == 0
    result = run("git", "-C", str(tmp_path / "models/python_model.git"), "remote", "update",
                 **way_to_github)  # fmt: skip
    assert result.returncode == 0, result.stderr
