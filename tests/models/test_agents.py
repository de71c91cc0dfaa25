"""AGENTS.md: what newcomers to a package, people or assistants, need before they change it."""

import re

import pytest

from support.packages import QUIET
from support.repository import EXAMPLES, commit, git

MODELS = ("python_model", "cpp_model", "mixed_model")
NODE = """<package name="arm" author="A" author_email="a@example.org" license="MIT"
                   description="d">
  <node name="reach" {}><directPublisher name="say" type="std_msgs::String"/>{}</node></package>"""
SERVER = '<serviceServer name="load" type="std_srvs::Trigger"/>'


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("model", MODELS)
def test_guide_is_of_this_package(render, model, distro):
    spec = EXAMPLES / (
        "driving.ros_package" if model == "mixed_model" else "all_kinds.ros_package"
    )
    package = render(spec, model=model, ros_distro=distro, name="package")
    guide = (package / "AGENTS.md").read_text()
    paths = re.findall(r"`([\w./]+[./][\w.]*)`", guide)
    assert len(paths) >= 6
    for path in paths:
        assert (package / path).exists(), path
    commands = re.findall(r"```sh\n(.*?)```", guide, re.DOTALL)
    assert commands[-1] in (package / "README.md").read_text()
    assert len(guide.splitlines()) < 60
    assert max(map(len, guide.splitlines())) <= 160


def test_guide_says_nothing_of_what_is_not_there(render):
    loop, callback = "`update` misses", "Each callback"
    for attributes, inside, said in (
        ('frequency="1"', "", [loop]),
        ("", SERVER, [callback]),
        ("", "", []),
        ('frequency="1"', SERVER, [loop, callback]),
    ):
        package = render(NODE.format(attributes, inside), name=f"p{len(said)}{len(inside)}")
        guide = (package / "AGENTS.md").read_text()
        assert [words for words in (loop, callback) if words in guide] == said
        assert ("`data`" in guide) == (loop in said)


def test_package_without_a_guide(render, copier_command):
    package = render(NODE.format("", ""), name="arm", agents="none")
    assert not (package / "AGENTS.md").exists()
    for choice, is_there in (("AGENTS.md", True), ("none", False)):
        result = copier_command("update", *QUIET, "-d", f"agents={choice}", cwd=package)
        assert result.returncode == 0, result.stderr
        assert (package / "AGENTS.md").exists() == is_there
        commit(package, "Update")
    assert "AGENTS.md" not in git(package, "ls-files")
