"""Models as git repositories of their own: `copier copy gh:org/python_model mypkg`.

What templates share is included by name, and published with each model (decision 18).
"""

import re
import shlex
import subprocess

import pytest

from support.documentation import blocks
from support.packages import QUIET, answers
from support.repository import EXAMPLES, ROOT, commit, git

EXAMPLE_OF = {
    "python_model": ("contact_analysis", "contact_evaluate"),
    "cpp_model": ("contact_analysis", "contact_evaluate"),
    "mixed_model": ("driving", "planner"),
    "interfaces_model": ("contact_msgs", "PointArray"),
}


@pytest.mark.parametrize("model", EXAMPLE_OF)
def test_copy_from_github(github, copier_command, tmp_path, model):
    """Exactly the commands of the README, without a spec and with one."""
    *_, environment = github
    result = copier_command(
        "copy", "--trust", f"gh:org/{model}", "mypkg", cwd=tmp_path, **environment
    )
    assert result.returncode == 0, result.stderr
    package = tmp_path / "mypkg"
    assert (package / "mypkg.ros_package").exists()
    assert answers(package)["_src_path"] == f"gh:org/{model}"
    assert answers(package)["_commit"] == "1.0.0"
    example, node = EXAMPLE_OF[model]
    (tmp_path / "mine.ros_package").write_bytes((EXAMPLES / f"{example}.ros_package").read_bytes())
    arguments = (
        "copy",
        "--trust",
        "-d",
        "spec_file=mine.ros_package",
        f"gh:org/{model}",
        "mine",
    )
    result = copier_command(*arguments, cwd=tmp_path, **environment)
    assert result.returncode == 0, result.stderr
    assert node in (tmp_path / "mine/README.md").read_text()


def test_trust_once(github, copier_command, tmp_path):
    """The settings of the README make `copier copy gh:org/python_model mypkg` enough."""
    *_, environment = github
    command = ("copy", "gh:org/python_model", "mypkg")
    assert copier_command(*command, cwd=tmp_path, **environment).returncode == 4
    (tmp_path / "config/copier").mkdir(parents=True)
    settings = "trust:\n  - gh:org/\n"
    (tmp_path / "config/copier/settings.yml").write_text(settings)
    environment["XDG_CONFIG_HOME"] = str(tmp_path / "config")
    result = copier_command(*command, cwd=tmp_path, **environment)
    assert result.returncode == 0, result.stderr


def test_published_versions_update(github, copier_command, tmp_path):
    """A second version of the collection reaches a package, and publishing adds to history."""
    collection, publish, environment = github
    command = ("copy", *QUIET, "gh:org/python_model", "mypkg")
    assert copier_command(*command, cwd=tmp_path, **environment).returncode == 0
    package = tmp_path / "mypkg"
    commit(package)
    gitignore = collection / "shared/gitignore"
    gitignore.write_text(gitignore.read_text() + "*.bag\n")
    commit(collection, "Ignore bags", tag="1.1.0")
    bare = tmp_path / "github/org/python_model.git"
    first = git(bare, "rev-parse", "1.0.0")
    publish()
    assert git(bare, "rev-parse", "1.1.0~1") == git(bare, "rev-parse", "1.0.0") == first
    assert git(bare, "rev-parse", "main") == git(bare, "rev-parse", "1.1.0")
    assert git(bare, "log", "-1", "--format=%s", "main") == "Ignore bags"
    result = copier_command("update", *QUIET, cwd=package, **environment)
    assert result.returncode == 0, result.stderr
    assert "*.bag" in (package / ".gitignore").read_text()
    assert answers(package)["_commit"] == "1.1.0"


def test_published_model_holds_what_it_needs_and_no_more(github, tmp_path):
    names = set(
        git(tmp_path / "github/org/python_model.git", "ls-tree", "--name-only", "main").split()
    )
    assert {"copier.yml", "dictionary.yaml", "functions.py", "template", "README.md"} <= names
    assert {"hooks", "extensions", "shared", "LICENSE"} <= names
    assert not names & {"python_model", "cpp_model", "tests", "docs", "Makefile"}


def test_readme_of_a_published_model_leads_back(github, tmp_path):
    """To pages of the collection that are there."""
    models = sorted(path.parent.name for path in ROOT.glob("*_model/copier.yml"))
    for model in models:
        readme = git(tmp_path / f"github/org/{model}.git", "show", "main:README.md")
        assert readme.startswith(f"# {model}\n")
        pages = re.findall(r"ros_package_models/blob/main/([\w/.]+)\)", readme)
        assert "docs/developers.md" in pages
        assert all((ROOT / page).is_file() for page in pages)


def test_links_lead_to_whoever_publishes(own_collection, render):
    """The command of docs/releasing.md leaves no link to the organisation of the examples."""
    (script,) = blocks("docs/releasing.md", "Before the first release")
    subprocess.run(["bash", "-e", "-c", script], cwd=own_collection, check=True)
    commit(own_collection, "Say who publishes", tag="1.0.1")
    package = render(template=own_collection, name="mypkg")
    readmes = [package / "README.md", *own_collection.glob("*_model/README.md")]
    assert len(readmes) > len(EXAMPLE_OF)
    for readme in readmes:
        assert re.findall(r"(?:gh:|github\.com/)(\w+)", readme.read_text())[:1] == ["acme"]
        assert not re.search(r"(gh:|github\.com/)org/", readme.read_text()), readme


def test_package_of_the_collection_follows_the_published_model(
    github, render, copier_command, tmp_path
):
    """By the line of docs/developers.md, and keeps what is written by hand, or deleted."""
    collection, publish, environment = github
    gitignore = collection / "shared/gitignore"
    gitignore.write_text(gitignore.read_text() + "*.bag\n")
    commit(collection, "Ignore bags", tag="1.1.0")
    publish()
    package = render(template=collection, vcs_ref="1.0.0", name="mypkg")
    logic = package / "mypkg/example_impl.py"
    written = logic.read_text() + "\n\nGAIN = 2\n"
    logic.write_text(written)
    (package / "mypy.ini").unlink()
    commit(package, "Write the logic")
    (line,) = blocks("docs/developers.md", "Coming from the original generator")[-1:]
    result = copier_command(*shlex.split(line)[1:], cwd=package, **environment)
    assert result.returncode == 0, result.stderr
    assert (answers(package)["_src_path"], answers(package)["_commit"]) == (
        "gh:org/python_model",
        "1.1.0",
    )
    assert "*.bag" in (package / ".gitignore").read_text()
    assert logic.read_text() == written
    assert not (package / "mypy.ini").exists()
    commit(package)
    assert copier_command("update", *QUIET, cwd=package, **environment).returncode == 0
    assert git(package, "status", "--short") == ""
