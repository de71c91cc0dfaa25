"""Each way of the README to install Copier makes a package."""

import ast
import os
import re
import subprocess
import sys

import copier
import pytest

from support.documentation import blocks
from support.repository import ROOT

PIPX, UVX, VENV = blocks("README.md", "Install")
COPY = "copier copy --trust gh:org/python_model mypkg"
DISTRIBUTIONS = {"yaml": "pyyaml"}


@pytest.fixture(scope="module")
def installers(tmp_path_factory):
    """Install pipx and uv apart from everything, and return the folder of their commands."""
    folder = tmp_path_factory.mktemp("installers")
    subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    pip = [folder / "bin/pip", "install", "--quiet", "pipx", "uv"]
    result = subprocess.run(pip, capture_output=True, text=True)
    if result.returncode != 0:
        pytest.skip(f"no package index can be reached: {result.stderr.splitlines()[-1]}")
    index = [folder / "bin/pip", "config", "get", "global.index-url"]
    index = subprocess.run(index, capture_output=True, text=True).stdout.strip()
    return folder / "bin", {"UV_DEFAULT_INDEX": index} if index else {}


@pytest.fixture
def shell(installers, github, tmp_path):
    """Run commands in a home of their own, where pipx and uv are and Copier is not."""
    tools, index = installers
    *_, environment = github
    home = tmp_path / "home"
    home.mkdir()
    path = [home / ".local/bin", tools, "/usr/local/bin", "/usr/bin", "/bin"]
    environment = os.environ | environment | index
    environment |= {"HOME": str(home), "PATH": os.pathsep.join(map(str, path))}
    environment |= {"UV_PYTHON": sys.executable, "PIPX_DEFAULT_PYTHON": sys.executable}
    for name in ("PIPX_HOME", "PIPX_BIN_DIR", "VIRTUAL_ENV", "XDG_CONFIG_HOME"):
        environment.pop(name, None)

    def run(script):
        result = subprocess.run(
            ["bash", "-e", "-c", script],
            cwd=tmp_path,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        assert result.returncode == 0, result.stdout
        assert (tmp_path / "mypkg/mypkg/example_impl.py").exists(), result.stdout

    return run


@pytest.mark.parametrize(
    "script",
    [f"{PIPX}{COPY}", UVX, f"{VENV}~/copier/bin/{COPY}"],
    ids=["pipx", "uvx", "venv"],
)
def test_way_to_install(shell, script):
    shell(script)


def dependencies():
    """Return the distributions of pyproject.toml, each with its least version or ""."""
    text = (ROOT / "pyproject.toml").read_text()
    listed = re.search(r"^dependencies = \[\n(.*?)^\]", text, re.DOTALL | re.MULTILINE)[1]
    return dict(re.findall(r'"([\w-]+)(?:>=([\d.]+))?(?:,<[\d.]+)?"', listed))


def test_readme_names_every_distribution():
    """With its least version."""
    told = re.search(r"The models import (.*?);", (ROOT / "README.md").read_text(), re.DOTALL)[1]
    assert dict(re.findall(r"`([\w-]+)`(?:\s([\d.]+))?", told)) == dependencies()


def test_lowest_and_newest_copier_are_the_same_everywhere():
    """Of the extension, what is installed for the tests, CI of packages, models of one's own."""
    text = (ROOT / "extensions/spec.py").read_text()
    major, minor = map(int, re.search(r"^NEWEST_COPIER = \((\d+), (\d+)\)$", text, re.M).groups())
    below = f"<{major}.{minor + 1}"
    declared = (ROOT / "pyproject.toml").read_text()
    lowest = re.search(rf'"copier>=([\d.]+),{below}"', declared)[1]
    required = (ROOT / "starter_model/template/requirements.txt").read_text()
    assert f"copier>={lowest},{below}\n" in required
    for template in ("hooks", "starter_model"):
        said = (ROOT / template / "copier.yml").read_text()
        assert f'_min_copier_version: "{lowest}"' in said
    assert f" copier=={major}.{minor}.* " in (ROOT / "shared/ci/commands.jinja").read_text()
    assert tuple(map(int, copier.__version__.split(".")[:2])) <= (major, minor)


def test_what_is_imported_is_declared():
    imported = set()
    for file in [*ROOT.glob("hooks/**/*.py"), *ROOT.glob("extensions/*.py")]:
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.Import):
                imported |= {alias.name.split(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and not node.level:
                imported.add(node.module.split(".")[0])
    others = imported - sys.stdlib_module_names - {"hooks"}
    found = {DISTRIBUTIONS.get(name, name) for name in others}
    assert {"copier", "packaging", "pyyaml"} <= found
    assert found <= dependencies().keys()


@pytest.mark.parametrize(
    "model", ["cpp_model", "interfaces_model", "mixed_model", "runtime_model"]
)
def test_folder_of_a_model_in_a_clone(model, copier_command, tmp_path):
    """Copier's own error, that `spec` is undefined, comes after what cures it."""
    result = copier_command("copy", "--trust", "--defaults", ROOT / model, "arm", cwd=tmp_path)
    assert result.returncode != 0
    said = result.stdout + result.stderr
    assert f"copy from the folder above, with -d model={model}\n" in said
    assert not (tmp_path / "arm").exists()


def test_starter_in_a_clone(copier_command, github, tmp_path):
    """It is published first; from there, nothing is said of it."""
    options = ("copy", "--defaults", "--trust")
    result = copier_command(*options, ROOT / "starter_model", "our_model", cwd=tmp_path)
    assert result.returncode != 0
    told = "publish it first, as docs/designers.md says\n"
    assert told in result.stdout + result.stderr
    assert "scripts/publish.py starter_model" in (ROOT / "docs/designers.md").read_text()
    *_, environment = github
    published = (*options, "gh:org/starter_model", "our_model")
    result = copier_command(*published, cwd=tmp_path, **environment)
    assert result.returncode == 0, result.stderr
    assert "is a part of a collection" not in result.stdout + result.stderr
