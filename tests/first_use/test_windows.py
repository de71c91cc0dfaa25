"""What Windows has otherwise, as far as another system can show it.

The workflow runs what has no mark `posix` on Windows; `tests/hook/test_collisions.py` has its
devices.
"""

import ast
import re
import subprocess

import pytest

from support.arm import SPEC
from support.packages import MODELS
from support.repository import ROOT, commit, git

SETTINGS = {"core.autocrlf": "true", "core.symlinks": "false"}
"""What git for Windows sets: texts have its line ends, and links are texts."""


@pytest.fixture
def windows(monkeypatch):
    """Let git check files out as on Windows."""
    monkeypatch.setenv("GIT_CONFIG_COUNT", str(len(SETTINGS)))
    for number, (key, value) in enumerate(SETTINGS.items()):
        monkeypatch.setenv(f"GIT_CONFIG_KEY_{number}", key)
        monkeypatch.setenv(f"GIT_CONFIG_VALUE_{number}", value)


def files(package):
    return {
        path.relative_to(package): path.read_bytes()
        for path in package.rglob("*")
        if path.is_file() and path.name != ".copier-answers.yml"
    }


def make(copier_command, model, source, target, *more):
    options = ("--trust", "--defaults", "--quiet", "-d", f"model={model}", *more)
    result = copier_command("copy", *options, source, target, cwd=target.parent)
    assert result.returncode == 0, result.stderr
    return target


@pytest.mark.parametrize("model", [*MODELS, "mixed_model", "interfaces_model", "runtime_model"])
def test_clone_of_the_collection(collection, copier_command, tmp_path, model, request):
    (tmp_path / "here").mkdir()
    expected = files(make(copier_command, model, collection, tmp_path / "here/arm"))
    request.getfixturevalue("windows")
    clone = tmp_path / "clone"
    subprocess.run(["git", "clone", "-q", collection, clone], check=True)
    assert b"\r\n" in (clone / "copier.yml").read_bytes()
    assert not (clone / "mixed_model/cpp_model").is_symlink()
    assert files(make(copier_command, model, clone, tmp_path / "arm")) == expected


@pytest.mark.parametrize("model", MODELS)
def test_update_of_a_checkout(collection, copier_command, tmp_path, windows, model):
    spec = tmp_path / "arm.xml"
    spec.write_text(SPEC)
    given = ("-d", f"spec_file={spec}")
    package = make(copier_command, model, collection, tmp_path / "arm", *given)
    commit(package)
    checkout = tmp_path / "checkout"
    subprocess.run(["git", "clone", "-q", package, checkout], check=True)
    assert b"\r\n" in next(checkout.rglob("reach_impl.*")).read_bytes()
    spec = checkout / "arm.ros_package"
    spec.write_bytes(re.sub(rb'name="stop"', b'name="halt" was="stop"', spec.read_bytes()))
    commit(checkout, "Rename a service")
    result = copier_command("update", "--trust", "--defaults", cwd=checkout)
    assert result.returncode == 0, result.stderr
    assert "Done, without conflicts." in result.stdout + result.stderr
    git(checkout, "add", "-A")
    changed = git(checkout, "diff", "--cached", "--numstat").splitlines()
    assert changed
    assert not [line for line in changed if int(line.split()[1]) > 40]  # each line of a file


def test_paths_may_be_on_several_drives():
    """These raise where two paths have no folder in common."""
    for folder in ("hooks", "extensions"):
        for file in (ROOT / folder).rglob("*.py"):
            assert not re.search(r"relpath|commonpath|walk_up", file.read_text()), file


def test_no_text_is_read_in_the_encoding_of_the_system():
    """On Windows it is another one than UTF-8."""
    run_by_users = ("scripts/adopt.py", "scripts/describe_node.py", "scripts/publish.py")
    for pattern in ("hooks/**/*.py", "extensions/*.py", "*/functions.py", *run_by_users):
        for file in ROOT.glob(pattern):
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
                called = ast.unparse(node) if isinstance(node, ast.Call) else ""
                if re.match(r"[^(]*\b(read_text|write_text|open)\(", called):
                    assert re.search("encoding=|[\"'][rw]b[\"']", called), (file, called)
