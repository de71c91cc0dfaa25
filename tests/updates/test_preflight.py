"""What is refused before the first write, without Copier."""

import os
import shutil
from types import SimpleNamespace

import pytest
import yaml
from jinja2 import Environment, FileSystemLoader

from extensions import spec
from extensions.spec import SpecExtension
from hooks.dictionary import load
from hooks.faults import SpecError
from hooks.merge.git import mark_conflict
from hooks.merge.preflight import (
    check,
    is_joining,
    modes_in_git,
    refuse,
    refuse_copy,
    refuse_join,
    refuse_names,
    refuse_places,
)
from hooks.merge.tree import TOO_LARGE, write
from support.repository import ROOT, commit, git
from support.small_model import ANSWERS, SPEC, Model, answers


@pytest.fixture
def package(tmp_path):
    """Return a package in a repository, with a file outside of it."""
    package = tmp_path / "arm"
    (package / "config").mkdir(parents=True)
    (package / "reach.py").write_text("MINE = 1\n")
    (package / "watch.py").write_text("MINE = 2\n")
    (tmp_path / "outside.py").write_text("MINE = 3\n")
    commit(package)
    return package


def ignored(package):
    (package / ".gitignore").write_text("reach.py\n")
    git(package, "rm", "-q", "--cached", "reach.py")
    commit(package)


def never_added(package):
    git(package, "rm", "-q", "--cached", "reach.py")
    git(package, "commit", "-q", "-m", "Forget it")


def repository_of_its_own(package):
    (package / "config/arm.yaml").write_text("MINE: 1\n")
    git(package / "config", "init", "-q")
    commit(package / "config")


def link_out_of_the_package(package):
    (package / "reach.py").unlink()
    (package / "reach.py").symlink_to("../outside.py")
    commit(package)


def folder_that_leads_out(package):
    (package / "config").rmdir()
    (package / "config").symlink_to("..")
    commit(package)


def link_to_what_git_does_not_have(package):
    (package / ".gitignore").write_text("mine.py\n")
    (package / "reach.py").rename(package / "mine.py")
    (package / "reach.py").symlink_to("mine.py")
    commit(package)


def submodule(package):
    name = git(package, "rev-parse", "HEAD")
    git(package, "update-index", "--add", "--cacheinfo", f"160000,{name},config")
    git(package, "commit", "-q", "-m", "A submodule")


def not_committed(package):
    (package / "reach.py").write_text("MINE = 4\n")


def staged(package):
    not_committed(package)
    git(package, "add", "-A")


def no_repository(package):
    (package / ".git").rename(package / "git")


@pytest.mark.parametrize(
    ("situation", "message", "id_"),
    [
        (ignored, "reach.py: not in git (ignored, or never added)", "not-in-git"),
        (never_added, "reach.py: not in git (ignored, or never added)", "not-in-git"),
        (repository_of_its_own, "config/arm.yaml: not in git", "not-in-git"),
        (link_out_of_the_package, "reach.py: a link to", "link-out-of-package"),
        (folder_that_leads_out, "config: a link to", "link-out-of-package"),
        (link_to_what_git_does_not_have, "reach.py: a link to", "link-out-of-package"),
        (submodule, "config/arm.yaml: belongs to a submodule", "in-a-submodule"),
        (not_committed, "reach.py: changed since the last commit", "not-committed"),
        (staged, "reach.py: changed since the last commit", "not-committed"),
        (no_repository, "not in a git repository", "no-repository"),
    ],
)
def test_what_git_could_not_bring_back_is_refused(package, situation, message, id_):
    paths = ["reach.py", "config/arm.yaml"]
    refuse(package, modes_in_git(package), paths, {})
    situation(package)
    with pytest.raises(SpecError) as caught:
        refuse(package, modes_in_git(package), paths, {})
    assert message in str(caught.value)
    assert str(caught.value).endswith(f" [{id_}]")
    refuse(
        package, modes_in_git(package), ["other.py"], {}
    ) if situation is not no_repository else None


def test_file_that_git_does_not_have_is_no_folder_of_what_begins_like_it(package):
    (package / "reach").write_text("MINE = 1\n")
    refuse(package, modes_in_git(package), ["reach.py"], {})


def test_message_names_three_files(package):
    paths = [f"{name}.py" for name in "abcde"]
    for path in paths:
        (package / path).write_text("MINE = 1\n")
    with pytest.raises(SpecError, match=r"^a\.py, b\.py, c\.py and 2 more: not in git"):
        refuse(package, modes_in_git(package), paths, {})
    with pytest.raises(SpecError, match=r"^a\.py, b\.py, c\.py: not in git"):
        refuse(package, modes_in_git(package), paths[:3], {})


def test_links_inside_of_the_package_are_fine(package):
    (package / "link.py").symlink_to("watch.py")
    commit(package)
    refuse(package, modes_in_git(package), ["link.py"], {})


def test_new_name_that_a_file_has_is_refused(package):
    with pytest.raises(SpecError, match=r"watch\.py: reach\.py is to have this name"):
        refuse(package, modes_in_git(package), [], {"reach.py": "watch.py"})
    refuse(package, modes_in_git(package), [], {"reach.py": "watch.py", "watch.py": "reach.py"})


@pytest.mark.parametrize(
    "name", ["wörter.py", pytest.param('a "b"\t\\.py', marks=pytest.mark.posix)]
)
def test_conflict_is_marked_whatever_the_name_and_the_settings(package, name):
    """Git quotes such a name by default, and a hook would see the index change."""
    (package / "hooks").mkdir()
    hook = package / "hooks/post-index-change"
    hook.write_text(f"#!/bin/sh\necho seen > {package}/seen\n")
    hook.chmod(0o755)
    (package / name).write_text("MINE = 5\n")
    commit(package)
    git(package, "config", "core.hooksPath", str(package / "hooks"))
    mark_conflict(package, name, "100644", {1: b"old", 2: b"mine", 3: b"new"})
    assert not (package / "seen").exists()
    found = git(package, "ls-files", "-u", "-z").split("\0")
    assert [entry.split(maxsplit=2)[2] for entry in found if entry] == [
        f"{n}\t{name}" for n in "123"
    ]


def file_in_the_place_of_a_folder(package):
    (package / "config").rmdir()
    (package / "config").write_text("mine\n")
    return "config: a file, and config/arm.yaml needs a folder of this name"


def folder_in_the_place_of_a_file(package):
    (package / "config/arm.yaml").mkdir(parents=True)
    (package / "config/arm.yaml/mine.yaml").write_text("mine: 1\n")
    return "config/arm.yaml: a folder, and a generated file has this name"


def grown_beyond_the_limit(package):
    (package / "reach.py").write_text("TABLE = 1\n" * (TOO_LARGE // 10 + 1))
    return "reach.py: larger than 5 MB, which is too large to merge"


@pytest.mark.parametrize(
    ("situation", "id_"),
    [
        (file_in_the_place_of_a_folder, "path-taken"),
        (grown_beyond_the_limit, "too-large"),
        (folder_in_the_place_of_a_file, "path-taken"),
    ],
)
def test_what_has_no_place_for_a_generated_file_is_refused(package, situation, id_):
    paths = ["reach.py", "config/arm.yaml"]
    refuse_places(package, paths)
    message = situation(package)
    commit(package)
    with pytest.raises(SpecError) as caught:
        refuse_places(package, paths)
    assert str(caught.value).startswith(message)
    assert str(caught.value).endswith(f" [{id_}]")
    assert str(caught.value).isascii()


def test_name_in_another_encoding_is_refused():
    with pytest.raises(SpecError, match=r"^docs/caf\\xe9\.txt: a name that is not UTF-8"):
        refuse_names(["reach.py", os.fsdecode(b"docs/caf\xe9.txt")])
    refuse_names(["caf\xe9.txt"])


@pytest.mark.posix
def test_name_in_another_encoding_is_refused_before_an_update(package):
    (package / os.fsdecode(b"caf\xe9.txt")).write_text("mine\n")
    commit(package)
    renderer = SimpleNamespace(answers_file=".copier-answers.yml")
    with pytest.raises(SpecError, match=r"a name that is not UTF-8"):
        check(package, {}, {"spec": {}}, None, renderer, {})


def test_version_that_copier_refuses(tmp_path):
    (tmp_path / "model").mkdir()
    (tmp_path / "model/copier.yml").write_text("_min_copier_version: 99.0.0\n")
    extension = SpecExtension(Environment(loader=FileSystemLoader(ROOT)))
    with pytest.raises(spec.hooks.faults.UnrenderedError, match=r"99.* \[not-rendered\]$"):
        extension._copy(str(tmp_path / "model"), tmp_path / "arm", {}, "answers.yml", None, "*")


def test_large_file_of_the_developer_is_fine(package):
    grown_beyond_the_limit(package)
    commit(package)
    refuse_places(package, ["watch.py"])


@pytest.fixture
def small(tmp_path):
    """Return a package of the small model, in a repository."""
    package = tmp_path / "arm"
    given = answers("load", "store", nodes=[{"name": "reach"}])
    for path, file in Model().fresh(given).tree.items():
        write(package / path, file)
    (package / ANSWERS).write_text(yaml.safe_dump(given))
    (package / "mine.py").write_text("MINE = 1\n")
    commit(package)
    return package


def whole(package, *callbacks, places=None, moved=None, **others):
    """Check what an update of a package to other callbacks could not undo."""
    dictionary = load(ROOT / "python_model/dictionary.yaml", ROOT)
    given = answers(*callbacks, **{"nodes": [{"name": "reach"}], **others})
    check(package, places or {}, given, dictionary, Model(), moved or {})


def forgotten(package, path):
    git(package, "rm", "-q", "--cached", path)
    git(package, "commit", "-q", "-m", "Forget it")


@pytest.mark.parametrize("path", ["config/store.yaml", "reach.py", "arm.py", ANSWERS])
def test_file_that_an_update_would_change_or_remove_has_to_be_in_git(small, path):
    whole(small, "load")
    forgotten(small, path)
    with pytest.raises(SpecError, match=rf"^{path}: not in git .*\[not-in-git\]$"):
        whole(small, "load", nodes=[])
    git(small, "add", "-A")
    commit(small)
    (small / path).write_text("MINE = 2\n")
    gone = {"config/store.yaml", "reach.py"}  # git has what it was; the merge tells of what it is
    if path not in gone:
        with pytest.raises(SpecError, match=rf"^{path}: changed since the last .*-committed\]$"):
            whole(small, "load", nodes=[])


def test_file_that_an_update_would_add_has_to_be_in_git(small):
    (small / "config/home.yaml").write_text("mine: 1\n")
    whole(small, "load", "store")
    with pytest.raises(SpecError, match=r"^config/home\.yaml: not in git "):
        whole(small, "load", "store", "home")


def test_file_of_the_developer_in_the_place_of_a_renamed_one(small):
    (small / "grasp.py").write_text("MINE = 1\n")
    commit(small)
    renamed = [{"name": "grasp", "was": "reach"}]
    with pytest.raises(SpecError, match=r"^grasp\.py: reach\.py is to have this name"):
        whole(small, "load", "store", nodes=renamed)
    whole(small, "load", "store", nodes=[{"name": "lift", "was": "reach"}])
    (small / "lift.py").write_text("MINE = 1\n")
    with pytest.raises(SpecError, match=r"^lift\.py: not in git"):
        whole(small, "load", "store", nodes=[{"name": "lift", "was": "reach"}])


def test_file_of_the_developer_in_the_place_of_one_that_the_model_calls_otherwise(small):
    """It counts where the new version has made the new name."""
    moved = {"config/store.yaml": "config/home.yaml"}
    whole(small, "load", "home", moved=moved)
    (small / "config/home.yaml").write_text("mine: 1\n")
    commit(small)
    with pytest.raises(SpecError, match=r"^config/home\.yaml: config/store\.yaml is to have"):
        whole(small, "load", "home", moved=moved)
    whole(small, "load", moved=moved)


def test_was_is_checked_where_there_are_answers(small):
    nodes, places = [{"name": "grasp", "was": "raech"}], {"node grasp": "arm:1: <node>"}
    with pytest.raises(SpecError, match=r"^arm:1: <node>: was=\"raech\".*\[unknown-was\]$"):
        whole(small, "load", nodes=nodes, places=places)
    (small / ANSWERS).write_text("")
    commit(small)
    whole(small, "load", nodes=nodes, places=places)


def test_version_of_a_house_is_followed_by_one(small):
    """Copier may have found a tag of upstream's."""
    (small / ANSWERS).write_text(yaml.safe_dump(answers("load", _commit="1.0.0+house.1")))
    commit(small)
    with pytest.raises(SpecError, match=r"^1\.0\.0 is a version without a house.*-house\]$"):
        whole(small, "load")
    for others in ({"_src_path": "other"}, {"_commit": "0.9.0"}, {"_commit": "v1-2-gabc"}):
        (small / ANSWERS).write_text(yaml.safe_dump(answers("load", **others)))
        commit(small)
        whole(small, "load")


def test_generated_file_beyond_the_limit_is_refused(small):
    """One that would leave, too; of the developer's alone none."""
    for path in ("mine.py", "config/store.yaml"):
        (small / path).write_text("TABLE = 1\n" * (TOO_LARGE // 10 + 1))
        commit(small)
        if path == "mine.py":
            whole(small, "load")
    with pytest.raises(SpecError, match=r"^config/store\.yaml: larger than 5 MB"):
        whole(small, "load")


def test_package_in_no_repository(small):
    (small / ".git").rename(small / "git")
    with pytest.raises(SpecError, match=r"not in a git repository"):
        whole(small, "load")
    assert not is_joining(small, ANSWERS)


def test_join_needs_what_it_writes_over_in_git(small):
    """What both branches have changed may be changed, as git has begun to merge it."""
    given = answers("load", "home")
    (small / "arm.py").write_text("CONFLICT = 1\n")
    refuse_join(small, given, Model())
    (small / "config/home.yaml").write_text("mine: 1\n")
    with pytest.raises(SpecError, match=r"^config/home\.yaml: not in git "):
        refuse_join(small, given, Model())
    (small / "config/home.yaml").unlink()
    (small.parent / "outside").write_text("mine: 1\n")
    (small / "config/home.yaml").symlink_to("../../outside")
    with pytest.raises(SpecError, match=r"^config/home\.yaml: a link to"):
        refuse_join(small, given, Model())
    (small / "config/home.yaml").unlink()
    (small / "config/home.yaml").mkdir()
    with pytest.raises(SpecError, match=r"^config/home\.yaml: a folder"):
        refuse_join(small, given, Model())


def test_unfinished_merge_is_joined_by_an_update(small):
    git(small, "checkout", "-q", "-b", "topic")
    commit(small)
    git(small, "checkout", "-q", "-")
    assert not is_joining(small, ANSWERS)
    git(small, "merge", "-q", "--no-ff", "--no-commit", "topic")
    assert not is_joining(small, ANSWERS)  # nothing has changed, nothing is to be joined
    (small / "arm.py").write_text("CONFLICT = 1\n")
    assert is_joining(small, ANSWERS)
    git(small, "merge", "--abort")
    (small / "arm.py").write_text("MINE = 1\n")
    assert not is_joining(small, ANSWERS)


def test_copy_replaces_nothing_without_being_told(small):
    given = answers("load", "store", nodes=[{"name": "reach"}])
    refuse_copy(small, given, Model(), may_replace=False)
    (small / SPEC).write_text("mine\n")  # which Copier leaves alone
    refuse_copy(small, given, Model(), may_replace=False)
    for path in ("arm.py", "rate.txt"):
        (small / path).write_text("MINE = 1\n")
    with pytest.raises(SpecError) as caught:
        refuse_copy(small, given, Model(), may_replace=False)
    said = "arm.py, rate.txt would be replaced, and Copier cannot ask; move them away, or let"
    assert f"{small}: {said} --overwrite replace them [would-be-replaced]" == str(caught.value)
    refuse_copy(small, given, Model(), may_replace=True)
    for name in ("load", "store"):
        (small / f"config/{name}.yaml").write_text("mine: 1\n")
    for path in ("README.md", "reach.py"):
        (small / path).write_text("mine\n")
    said = "README.md, arm.py, config/load.yaml, config/store.yaml, rate.txt and more would be"
    with pytest.raises(SpecError, match=said):
        refuse_copy(small, given, Model(), may_replace=False)
    (small / "arm.py").unlink()
    (small / "arm.py").mkdir()
    with pytest.raises(SpecError, match=r"arm\.py: a folder"):
        refuse_copy(small, given, Model(), may_replace=True)


def test_copy_into_a_folder_with_a_spec_alone(tmp_path):
    """Nothing is rendered to see that."""
    (tmp_path / SPEC).write_text("mine\n")
    (tmp_path / ".git").mkdir()
    refuse_copy(tmp_path, {}, None, may_replace=False)


def test_copy_that_would_have_to_ask(collection, copier_command, tmp_path):
    """Without a terminal Copier ends at the first file, with half a package written."""
    package = tmp_path / "arm"
    package.mkdir()
    (package / "README.md").write_text("# Mine\n")
    (package / "notes.txt").write_text("mine\n")
    copy = ("copy", "--trust", "--defaults", "-d", "model=python_model", collection, "arm")
    result = copier_command(*copy, cwd=tmp_path)
    assert result.returncode
    assert "README.md would be replaced, and Copier cannot ask; move" in result.stderr
    assert "[would-be-replaced]" in result.stderr
    assert "Traceback" not in result.stderr
    assert {file.name for file in package.iterdir()} == {"README.md", "notes.txt"}
    (package / "README.md").rename(package / "mine.md")
    assert copier_command(*copy, cwd=tmp_path).returncode == 0
    shutil.rmtree(package / "launch")
    (package / ".copier-answers.yml").unlink()
    assert copier_command(*copy, cwd=tmp_path).returncode == 0
    (package / "README.md").write_text("# Mine\n")
    (package / ".copier-answers.yml").unlink()
    assert copier_command(*copy, "--overwrite", cwd=tmp_path).returncode == 0
    assert "Mine" not in (package / "README.md").read_text()


@pytest.mark.parametrize("more", [(), ("--overwrite",)])
@pytest.mark.parametrize(
    ("in_the_way", "says"),
    [
        ("README.md/mine.md", "README.md: a folder, and a generated file has this name"),
        ("test", "test: a file, and test/"),
        ("launch/arm.launch.xml/x", "launch/arm.launch.xml: a folder, and a generated file has"),
    ],
)
def test_copy_where_it_cannot_write(collection, copier_command, tmp_path, in_the_way, says, more):
    """Copier ends there in a traceback, with half a package written."""
    file = tmp_path / "arm" / in_the_way
    file.parent.mkdir(parents=True)
    file.write_text("mine\n")
    copy = ("copy", "--trust", "--defaults", *more, "-d", "model=python_model")
    result = copier_command(*copy, collection, "arm", cwd=tmp_path)
    assert result.returncode == 1
    assert says in result.stderr
    assert "Traceback" not in result.stderr
    assert [path for path in (tmp_path / "arm").rglob("*") if path.is_file()] == [file]


def test_copy_to_a_name_that_no_file_can_have(collection, copier_command, tmp_path):
    copy = ("copy", "--trust", "--defaults", "-d", "model=python_model")
    result = copier_command(*copy, collection, "arm" * 100, cwd=tmp_path)
    assert result.returncode == 1
    assert "too long" in result.stderr
    assert "OSError" not in result.stderr


ANSWERS_FILES = {
    "empty": "",
    "a list": "- spec\n",
    "a text": "spec\n",
    "in conflict": "<<<<<<< HEAD\na: 1\n=======\na: 2\n>>>>>>> topic\n",
    "cut off": "a: [1,\n",
}


@pytest.mark.parametrize("text", ANSWERS_FILES.values(), ids=ANSWERS_FILES)
def test_answers_file_that_is_none(arm, copier_command, text):
    """Copier reads it before any template; docs/updates.md says what its traceback means."""
    answers = arm / ".copier-answers.yml"
    whole = answers.read_text()
    answers.write_text(text)
    commit(arm, "Spoil the answers")
    for command in (("update",), ("recopy", "--overwrite")):
        result = copier_command(*command, "--trust", "--defaults", cwd=arm)
        assert result.returncode
        said = result.stderr.splitlines()[-1]
        assert "has no attribute 'items'" in said or ".copier-answers.yml" in said
        assert answers.read_text() == text
    git(arm, "checkout", "HEAD^", "--", ".copier-answers.yml")
    assert answers.read_text() == whole
    commit(arm, "Bring the answers back")
    assert copier_command("update", "--trust", "--defaults", cwd=arm).returncode == 0
