"""The commands of docs/designers.md and the workflows, run against local repositories."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from support.documentation import blocks
from support.packages import answers
from support.repository import ROOT, bare_repository, commit, git

PAGE = "docs/designers.md"


def script_of(workflow):
    """Return the script of the last step of a workflow."""
    (job,) = workflow["jobs"].values()
    return job["steps"][-1]["run"]


@pytest.fixture
def shell(github, tmp_path):
    """Run a script as a user would; `pip` does nothing and `gh` writes down what it is told."""
    *_, environment = github
    tools = tmp_path / "tools"
    tools.mkdir()
    (tools / "pip").write_text("#!/bin/sh\n")
    (tools / "gh").write_text(f'#!/bin/sh\necho "$@" >> {tools}/gh.log\n')
    for tool in tools.iterdir():
        tool.chmod(0o755)
    path = [tools, Path(sys.executable).parent, os.environ["PATH"]]
    environment = os.environ | environment | {"PATH": os.pathsep.join(map(str, path))}

    def run(script, cwd, **more):
        command = ["bash", "-e", "-o", "pipefail", "-c", script]
        result = subprocess.run(
            command,
            cwd=cwd,
            env=environment | more,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        assert result.returncode == 0, f"{script}\n{result.stdout}"
        return result.stdout

    return run


def test_from_an_empty_folder_to_a_published_model(shell, tmp_path):
    bare_repository(tmp_path / "github/team/my_model.git")
    work = tmp_path / "work"
    work.mkdir()
    output = shell("\n".join(blocks(PAGE, "From an empty folder to a published model")), work)
    assert "node server: no template makes use of name, type\n" in output
    assert "as it should be" in output
    node = (work / "mypkg/mypkg/example_node.py").read_text()
    assert "import std_srvs.srv" in node
    assert '"""Go home: fill in the response and return it."""' in node
    assert answers(work / "mypkg")["_commit"] == "0.2.0"
    assert git(work / "mypkg", "status", "--short") == ""


@pytest.fixture
def lagging(own_collection, shell, tmp_path):
    """Make a package whose model has a newer version; return its folder."""
    shell("copier copy --trust --defaults gh:org/python_model src/arm", tmp_path)
    commit(tmp_path / "src/arm")
    gitignore = own_collection / "shared/gitignore"
    gitignore.write_text(gitignore.read_text().replace("log/", "/log/") + "*.bag\n")
    commit(own_collection, tag="1.1.0")
    publish = yaml.safe_load((ROOT / ".github/workflows/publish.yml").read_text())
    rewrite = f"url.file://{tmp_path}/github/.insteadOf"
    more = {
        "OWNER": "org",
        "TOKEN": "secret",
        "GIT_CONFIG_KEY_0": rewrite,
        "GIT_CONFIG_VALUE_0": "https://x-access-token:secret@github.com/",
    }
    shell(script_of(publish), own_collection, **more)
    return tmp_path / "src/arm"


def test_fleet_view(lagging, shell):
    (script,) = blocks(PAGE, "Which packages lag behind")
    output = shell(script, lagging.parent)
    (example,) = blocks(PAGE, "Which packages lag behind", "text")
    assert output == example.replace("0.1.0", "1.0.0").replace("0.2.0", "1.1.0")


def test_workflow_that_updates(lagging, shell, tmp_path):
    """It pushes a branch with the update; a second run in the updated package does nothing."""
    (text,) = blocks(PAGE, "Which packages lag behind", "yaml")
    script = script_of(yaml.safe_load(text))
    git(lagging, "remote", "add", "origin", bare_repository(tmp_path / "github/org/arm.git"))
    shell(script, lagging)
    assert "*.bag" in git(lagging, "show", "origin/model-update:.gitignore")
    assert git(lagging, "log", "-1", "--format=%s", "origin/model-update") == "Update the model"
    assert (tmp_path / "tools/gh.log").read_text() == "pr create --fill\n"
    shell(script, lagging)
    assert len((tmp_path / "tools/gh.log").read_text().splitlines()) == 1


def test_workflow_that_updates_says_where_conflicts_are(lagging, shell, tmp_path):
    (text,) = blocks(PAGE, "Which packages lag behind", "yaml")
    gitignore = lagging / ".gitignore"
    gitignore.write_text(gitignore.read_text().replace("log/", "*.log"))
    commit(lagging)
    git(lagging, "remote", "add", "origin", bare_repository(tmp_path / "github/org/arm.git"))
    shell(script_of(yaml.safe_load(text)), lagging)
    subject = git(lagging, "log", "-1", "--format=%s", "origin/model-update")
    assert subject == "Update the model (conflicts)"
