"""What the rehearsal of a release finds: breakages of a model, in packages with edits."""

import json
import os
import subprocess
import sys

import pytest

from support.packages import QUIET
from support.repository import commit, git

SPEC = """<package name="{}" author="A" author_email="a@example.org" license="MIT" description="d">
  <node name="reach" frequency="10">
    <publisher name="pose" type="std_msgs::Float64"/>{}
  </node>
</package>
"""
SERVER = '<serviceServer name="load" type="std_srvs::Trigger"/>'
LOGIC = "python_model/template/{{ spec.name }}/[node.name]_impl.py.jinja"
HARNESS = "python_model/template/test/support/harness.py.jinja"


@pytest.fixture
def team(github, copier_command, tmp_path):
    """Two packages with edits in a list, and a way to rehearse what the collection has now."""
    collection, _, environment = github
    for name, inside in (("arm", ""), ("leg", SERVER)):
        (tmp_path / "spec.xml").write_text(SPEC.format(name, inside))
        command = ("copy", *QUIET, "-d", "spec_file=spec.xml", "-d", "ros_distro=kilted")
        result = copier_command(*command, "gh:org/python_model", name, cwd=tmp_path, **environment)
        assert result.returncode == 0, result.stderr
        logic = tmp_path / name / f"{name}/reach_impl.py"
        logic.write_text(logic.read_text() + "\n    def helper(self) -> None:\n        pass\n")
        commit(tmp_path / name, "Make the package")
    (tmp_path / "list").write_text(f"# of the team\n{tmp_path}/arm\n\n'{tmp_path}/leg'\n")

    def run(shell=None):
        commit(collection, "A candidate")
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-n", "0"]
        command += ["tests/publishing/test_rehearsal.py"]
        list_ = {"PACKAGES": str(tmp_path / "list")}
        if shell:
            shell.environment.update(list_)
            shell.run(" ".join(command), collection, check=False)
        else:
            environment = {k: v for k, v in os.environ.items() if k != "ROS_VERSION"} | list_
            subprocess.run(command, cwd=collection, env=environment, capture_output=True)
        return json.loads((tmp_path / "rehearsal.json").read_text())

    return collection, run


def change(collection, path, *pairs):
    text = (collection / path).read_text()
    for old, new in pairs:
        assert old in text, f"{path}: {old}"
        text = text.replace(old, new)
    (collection / path).write_text(text)


def test_candidate_that_breaks_nothing(team, tmp_path):
    collection, run = team
    change(collection, "shared/README.md.jinja", ("## Use", "## How to use it"))
    arm, leg = run()
    assert [arm["package"], leg["package"]] == ["arm", "leg"]
    for each in (arm, leg):
        assert (each["update"], each["build"]) == ("clean", "ROS 2 is not sourced")
        assert each["version"] == "1.0.0"
    for name in ("arm", "leg"):
        assert git(tmp_path / name, "status", "--short") == ""


def renamed_file(collection):
    (collection / LOGIC).rename(collection / LOGIC.replace("_impl", "_logic"))


def stricter_dictionary(collection):
    change(
        collection, "shared/dictionary.yaml", ("minimum: 0.001, maximum", "minimum: 20, maximum")
    )


@pytest.mark.parametrize(
    ("breaks", "arm", "leg"),
    [(renamed_file, "findings", "findings"), (stricter_dictionary, "refused", "refused")],
)
def test_candidate_that_breaks_packages(team, breaks, arm, leg):
    collection, run = team
    breaks(collection)
    found = run()
    assert [each["update"].split(":")[0] for each in found] == [arm, leg], found
    for each in found:
        assert each["findings"]


def test_candidate_that_breaks_one_kind_alone(team):
    collection, run = team
    wrong = "{% for server in spec.nodes[0].serviceServers %}{{ server.nam }}{% endfor %}"
    change(collection, "shared/README.md.jinja", ("## The logic\n", f"## The logic\n{wrong}\n"))
    arm, leg = run()
    assert arm["update"] == "clean", arm
    assert (leg["update"], "nam" in leg["findings"][0]) == ("refused", True)


@pytest.mark.ros2
def test_candidate_that_breaks_tests(team, ros2, tmp_path):
    collection, run = team
    (tmp_path / "list").write_text(f"{tmp_path}/arm\n")
    change(collection, HARNESS, ("def fake(", "def faked("))
    (arm,) = run(ros2)
    assert (arm["update"], arm["build"]) == ("clean", "tests fail"), arm
    git(collection, "checkout", "--quiet", "HEAD~1", "--", HARNESS)
    (arm,) = run(ros2)
    assert (arm["update"], arm["build"]) == ("clean", "passes"), arm
