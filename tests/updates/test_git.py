"""What git is asked of a package."""

from hooks.merge.git import merge_bases, name_in, parents
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


def test_histories_with_nothing_in_common(tmp_path):
    commit(tmp_path)
    first = git(tmp_path, "rev-parse", "HEAD")
    git(tmp_path, "checkout", "-q", "--orphan", "other")
    commit(tmp_path, "Another beginning")
    assert merge_bases(tmp_path, first, "HEAD") == []
