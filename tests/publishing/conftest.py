"""A shell as a user has it, and a package whose model has a newer version."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from support.repository import ROOT, commit
from support.workflows import script_of

_IDENTITY = ("GIT_AUTHOR_", "GIT_COMMITTER_")
"""Variables that go before the identity that a script sets."""


@pytest.fixture
def shell(github, tmp_path):
    """Run a script as a user would; `pip` does nothing and `gh` writes down what it is told."""
    *_, environment = github
    tools = tmp_path / "tools"
    tools.mkdir()
    (tools / "pip").write_text("#!/bin/sh\n")
    (tools / "gh").write_text(
        f'#!/bin/sh\necho "$@" >> {tools}/gh.log\n[ "$2" != list ] || cat {tools}/requests\n'
    )
    (tools / "requests").write_text("0\n")
    for tool in tools.iterdir():
        tool.chmod(0o755)
    path = [tools, Path(sys.executable).parent, os.environ["PATH"]]
    environment = os.environ | environment | {"PATH": os.pathsep.join(map(str, path))}
    environment = {k: v for k, v in environment.items() if not k.startswith(_IDENTITY)}

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


@pytest.fixture
def lagging(own_collection, shell, tmp_path):
    """Make a package, with CI, whose model has a newer version; return its folder."""
    shell("copier copy --trust --defaults -d ci=github gh:org/python_model src/arm", tmp_path)
    commit(tmp_path / "src/arm")
    gitignore = own_collection / "shared/gitignore"
    gitignore.write_text(gitignore.read_text().replace("log/", "/log/") + "*.bag\n")
    commit(own_collection, tag="1.1.0")
    more = {"BASE": f"{tmp_path}/github/org"}
    shell(script_of(ROOT / ".github/workflows/publish.yml", "publish"), own_collection, **more)
    return tmp_path / "src/arm"
