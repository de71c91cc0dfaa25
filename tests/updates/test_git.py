"""What git is asked of a package."""

from hooks.merge.git import (
    changed,
    commit_that_had,
    committed,
    files_of,
    mark_conflict,
    merge_bases,
    name_in,
    once_there,
    parents,
    stage,
    tracked,
    untracked,
)
from support.repository import commit, git


def test_commits_and_what_they_have(tmp_path):
    (tmp_path / "a").write_text("1\n")
    commit(tmp_path)
    first = git(tmp_path, "rev-parse", "HEAD")
    commit(tmp_path)
    second = git(tmp_path, "rev-parse", "HEAD")
    assert (parents(tmp_path, second), parents(tmp_path, first)) == ([first], [])
    assert merge_bases(tmp_path, first, second) == [first]
    assert name_in(tmp_path, first, "a") == git(tmp_path, "hash-object", "a")
    assert name_in(tmp_path, first, "b") == ""


def test_paths_are_those_from_the_folder_of_a_package(tmp_path):
    folder = tmp_path / "arm"
    folder.mkdir()
    (folder / "a").write_text("1\n")
    (tmp_path / "b").write_text("1\n")
    commit(tmp_path)
    (folder / "a").write_text("2\n")
    (folder / "c").write_text("2\n")
    (tmp_path / "b").write_text("2\n")
    assert (changed(folder), untracked(folder), [*tracked(folder)]) == (["a"], ["c"], ["a"])
    assert committed(folder, "a", "HEAD") == files_of(folder, "HEAD")["a"].data == b"1\n"
    assert [*files_of(folder, "HEAD")] == ["a"]
    stage(folder, ["a", "c"])
    assert tracked(folder).keys() == {"a", "c"}
    mark_conflict(folder, "a", "100644", {1: b"1\n", 2: b"2\n", 3: b"3\n"})
    assert git(tmp_path, "status", "--short", "arm").split("\n")[0] == "UU arm/a"


def test_histories_with_nothing_in_common(tmp_path):
    commit(tmp_path)
    first = git(tmp_path, "rev-parse", "HEAD")
    git(tmp_path, "checkout", "-q", "--orphan", "other")
    commit(tmp_path, "Another beginning")
    assert merge_bases(tmp_path, first, "HEAD") == []


def test_nothing_was_there_before_the_first_commit(tmp_path):
    git(tmp_path, "init")
    assert once_there(tmp_path, ["a"]) == set()


def test_what_was_once_there(tmp_path):
    """Asked of all at once, it is what is found for each: with renames among them, in a folder."""
    folder = tmp_path / "arm"
    folder.mkdir()
    (folder / "gone.py").write_text("a = 1\n" * 9)
    (folder / "kept.py").write_text("def load(self):\n    pass\n")
    (folder / "odd.cpp").write_text("Odd[1]* Odd::operator()(\n")
    (folder / ".gitattributes").write_text("*.cpp -diff\n")
    commit(tmp_path)
    (folder / "gone.py").rename(folder / "here.py")
    (folder / "kept.py").write_text("")
    (folder / "odd.cpp").write_text("")
    commit(tmp_path)
    paths = ["gone.py", "here.py", "kept.py", "odd.cpp"]
    assert once_there(folder, []) == set()
    assert once_there(folder, paths) == {"gone.py"}
    assert once_there(folder, paths, ["store(", "load("]) == {"kept.py"}
    assert once_there(folder, paths, ["Odd[1]* Odd::operator()("]) == {"odd.cpp"}
    for word in ("def load.", "load", "Odd1", "d*", "(", "x|a", "^"):
        each = {path for path in paths if commit_that_had(folder, path, word)}
        assert each <= once_there(folder, paths, [word]), word
    assert once_there(folder, paths, ["x" * 40_000]) == {*paths}
