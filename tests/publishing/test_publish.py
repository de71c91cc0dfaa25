"""What `scripts/publish.py` makes of versions, and what it says where it cannot publish."""

import shutil
import subprocess
import sys

import pytest

from support.repository import ROOT, commit, git

SCRIPT = ROOT / "scripts/publish.py"


@pytest.fixture
def own(tmp_path):
    """Make a collection of one model, at 1.0.0."""
    folder = tmp_path / "own"
    for file in ("a_model/copier.yml", "hooks/a.py", "extensions/b.py", "LICENSE"):
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_text(f"{file}\n")
    (folder / "scripts").mkdir()
    (folder / "scripts/publish.py").write_bytes(SCRIPT.read_bytes())
    git(tmp_path, "init", "-q", "-b", "main", "own")
    commit(folder, "Begin", tag="1.0.0")
    return folder


@pytest.fixture
def target(tmp_path):
    git(tmp_path, "init", "-q", "--bare", "-b", "main", "there.git")
    return tmp_path / "there.git"


def change(folder, text, tag):
    (folder / "shared").mkdir(exist_ok=True)
    (folder / "shared/c").write_text(text)
    commit(folder, text, tag=tag)


def run(own, target, model="a_model"):
    command = [sys.executable, "scripts/publish.py", model, str(target)]
    result = subprocess.run(command, cwd=own, capture_output=True, text=True)
    assert "Traceback" not in result.stderr
    assert len(result.stderr.splitlines()) == bool(result.returncode and result.stderr)
    return result


def tags(target):
    lines = git(target, "for-each-ref", "refs/tags", "--format=%(refname:short) %(objectname)")
    return dict(map(str.split, lines.splitlines()))


def test_version_without_what_came_later(own, target):
    """`shared` is younger than the first version."""
    change(own, "more", "1.1.0")
    assert run(own, target).stdout == "a_model: 1.0.0, 1.1.0\n"
    assert git(target, "ls-tree", "--name-only", "1.0.0").split() == [
        "LICENSE",
        "copier.yml",
        "extensions",
        "hooks",
    ]
    assert "shared" in git(target, "ls-tree", "--name-only", "1.1.0").split()


def test_commit_names_that_of_the_collection(own, target):
    run(own, target)
    message = git(target, "log", "-1", "--format=%B", "1.0.0")
    assert message.split("\n\n") == [
        "Begin",
        f"Collection-commit: {git(own, 'rev-parse', '1.0.0')}",
    ]


@pytest.mark.parametrize("is_on_a_branch", [True, False])
def test_version_that_is_mended_later(own, target, is_on_a_branch):
    """1.0.1 after 1.1.0 changes no version that is published, and `main` stays at 1.1.0."""
    change(own, "more", "1.1.0")
    run(own, target)
    before = tags(target)
    if is_on_a_branch:
        git(own, "checkout", "-q", "-b", "old", "1.0.0")
    change(own, "mended", "1.0.1")
    result = run(own, target)
    assert result.returncode == 0, result.stderr
    after = tags(target)
    assert {**before, "1.0.1": after["1.0.1"]} == after
    parent = "1.0.0" if is_on_a_branch else "1.1.0"
    assert git(target, "rev-parse", "1.0.1~1") == after[parent]
    assert git(target, "rev-parse", "main") == after["1.1.0"]
    git(own, "checkout", "-q", "main")
    change(own, "next", "1.2.0")
    assert run(own, target).returncode == 0
    assert git(target, "rev-parse", "main") == tags(target)["1.2.0"]


def test_two_tags_of_one_commit(own, target):
    git(own, "tag", "1.0.0rc1")
    assert run(own, target).stdout == "a_model: 1.0.0rc1, 1.0.0\n"
    assert git(target, "rev-parse", "1.0.0~1") == tags(target)["1.0.0rc1"]
    assert run(own, target).returncode == 0


@pytest.mark.parametrize("tag", ["1.0", "v1.0.0"])
def test_two_tags_of_one_version(own, target, tag):
    git(own, "tag", tag)
    said = " are one version; delete one [version-twice]\n"
    assert said in run(own, target).stderr
    assert tags(target) == {}


def test_main_that_went_on_by_itself(own, target, tmp_path):
    """Nothing is pushed, no tag either, so that the next try is not in its way."""
    run(own, target)
    git(tmp_path, "clone", "-q", target, "clone")
    commit_other = tmp_path / "clone"
    (commit_other / "x").write_text("x")
    commit(commit_other, "Go on")
    git(commit_other, "push", "-q", "origin", "HEAD:main")
    before = tags(target)
    change(own, "more", "1.1.0")
    result = run(own, target)
    assert result.returncode == 1
    assert (
        "main there has commits that were not published from here [foreign-commits]"
        in result.stderr
    )
    assert tags(target) == before


def test_tag_that_was_put_elsewhere(own, target):
    run(own, target)
    change(own, "other", None)
    git(own, "tag", "-f", "1.0.0")
    result = run(own, target)
    said = "1.0.0 is published with other content; give it a new number [changed-tag]\n"
    assert said in result.stderr
    assert result.returncode == 1


def test_shallow_clone(own, target, tmp_path):
    change(own, "more", "1.1.0")
    git(tmp_path, "clone", "-q", "--depth", "1", f"file://{own}", "shallow")
    result = run(tmp_path / "shallow", target)
    said = "the clone is shallow; git fetch --unshallow --tags completes it [shallow-clone]\n"
    assert said in result.stderr
    assert tags(target) == {}


def test_collection_that_was_not_cloned(own, target):
    shutil.rmtree(own / ".git")
    result = run(own, target)
    assert "fatal: not a git repository" in result.stderr
    assert result.returncode == 1


def test_address_that_is_wrong(own, tmp_path):
    result = run(own, tmp_path / "nowhere.git")
    assert "nowhere.git' does not appear to be a git repository [git-fails]" in result.stderr
    assert result.returncode == 1
    result = run(own, "https://user:secret@localhost:9/x.git")
    assert (
        "nothing is pushed to https://localhost:9/x.git: fatal: unable to access" in result.stderr
    )
    assert "secret" not in result.stderr


def test_folder_of_the_model_in_the_way(own, target):
    (own / "a_model/shared").mkdir()
    (own / "a_model/shared/x").write_text("x")
    change(own, "more", "1.1.0")
    assert (
        "1.1.0: a_model has shared already; call it otherwise [path-taken]"
        in run(own, target).stderr
    )
    assert tags(target) == {}


def test_model_that_is_not_there(own, target):
    for model in ("b_model", ".", "./a_model", "../a_model"):
        assert run(own, target, model).stdout == f"{model}: no version tag has this model\n"
