"""Three lists of lines become one; and how a conflict is written."""

import operator

import pytest

from hooks.merge.lines import (
    MARKS,
    Conflict,
    conflicts,
    margin,
    merge_lines,
    plain,
    rejected,
    settled,
    split,
    text,
)


def merge(mine, old, new, of_people=False):
    """Merge lines of a letter each; of letters in capitals the form alone is another."""
    sides = ([f"{letter}\n" for letter in side] for side in (mine, old, new))
    merged = merge_lines(*sides, str.lower, lambda a, b: a.lower() == b.lower(), of_people)
    return "".join(
        part.strip()
        if isinstance(part, str)
        else "[" + "|".join("".join(side).replace("\n", "") for side in parts(part)) + "]"
        for part in merged
    )


def parts(conflict):
    return conflict.mine, conflict.old, conflict.new


@pytest.mark.parametrize(
    ("mine", "old", "new", "wanted"),
    [
        ("abxc", "abc", "abc", "abxc"),
        ("abc", "abc", "abyc", "abyc"),
        ("abxc", "abc", "abyc", "abyxc"),  # decision 24
        ("abxc", "abc", "abxyc", "abyxc"),
        ("axc", "abc", "aby", "axy"),
        ("axc", "abc", "ayc", "a[x|b|y]c"),
        ("axc", "abc", "axc", "axc"),
        ("aXc", "abc", "axc", "aXc"),
        ("aBc", "abc", "abc", "aBc"),
        ("abc", "abc", "aBc", "aBc"),
        ("aBc", "abc", "axc", "axc"),
        ("axc", "abc", "aBc", "axc"),
        ("ac", "abc", "abxc", "axc"),
        ("ac", "abc", "axc", "a[|b|x]c"),
        ("xabc", "abc", "abcy", "xabcy"),
        ("", "abc", "abc", ""),
        ("abc", "", "xyz", "xyzabc"),
        ("axyzd", "abcd", "abCxd", "axyzxd"),
        ("xyc", "abc", "azw", "[xyc|abc|azw]"),
        ("axyd", "abcd", "zbwd", "z[xy|bc|bw]d"),
        ("aXbc", "abc", "axbz", "aXbz"),
    ],
)
def test_lines_of_two_sides(mine, old, new, wanted):
    assert merge(mine, old, new) == wanted


def test_own_line_between_two_that_change_is_no_conflict_where_each_has_become_another():
    """As the entry of an own program, in setup.py of a package that is renamed."""
    old = ["'a = arm.a_ros:main',\n", "'b = arm.b_ros:main',\n"]
    new, mine = [line.replace("arm", "robot") for line in old], [old[0], "'own = c:d'\n", old[1]]
    wanted = [new[0], mine[1], new[1]]
    assert merge_lines(mine, old, new, str, operator.eq) == wanted
    assert merge_lines(new, old, mine, str, operator.eq) == wanted
    assert conflicts(merge_lines(mine, old, ["1\n", "2\n"], str, operator.eq))
    assert conflicts(merge_lines(mine, old, new[:1], str, operator.eq))


def test_conflict_is_of_the_line_alone_that_both_sides_change_where_each_has_become_another():
    """As a row with a description of the developer's, in a table that moves to another ROS."""
    old = [f"| `{name}` | read each cycle | `sensor_msgs/msg/Joy` |\n" for name in "abc"]
    new, mine = [line.replace("/msg", "") for line in old], [*old]
    mine[1] = mine[1].replace("cycle", "time")
    wanted = [new[0], Conflict(mine[1:2], old[1:2], new[1:2]), new[2]]
    assert merge_lines(mine, old, new, str, operator.eq) == wanted
    del mine[1]
    wanted = [new[0], Conflict([], old[1:2], new[1:2]), new[2]]
    assert merge_lines(mine, old, new, str, operator.eq) == wanted


def test_two_developers_may_insert_the_same_line():
    assert merge("axyb", "ab", "ayzb", of_people=True) == "ayzxyb"
    assert merge("axyb", "ab", "ayzb") == "azxyb"


MERGED = ["a\n", Conflict(["mine\n", "too"], ["old\n"], ["new"]), "b\n", Conflict([], ["c"], [])]


def test_conflict_between_marks():
    """Each side ends with a line end, or the mark after it would be a part of it."""
    first = "<<<<<<< before updating\nmine\ntoo\n=======\nnew\n>>>>>>> after updating\n"
    second = "<<<<<<< before updating\n=======\n>>>>>>> after updating\n"
    assert text(MERGED) == f"a\n{first}b\n{second}"
    assert text(["a", "b"]) == "a\nb"
    assert conflicts(MERGED)
    assert not conflicts(["a\n"])


@pytest.mark.parametrize(
    ("mine", "new", "written"),
    [
        ("a123b", "c123d", "[a|c]123[b|d]"),
        ("a12b", "c12d", "[a12b|c12d]"),
        ("a12-b", "c12-d", "[a12-b|c12-d]"),
        ("a123", "123", "[a|]123"),
        ("123", "123d", "123[|d]"),
        ("123", "123", "[123|123]"),
    ],
)
def test_lines_that_both_sides_have_part_a_conflict(mine, new, written):
    """Three with words do."""
    sides = ([f"{letter}\n" for letter in side] for side in (mine, new))
    found = text([Conflict(next(sides), [], next(sides))])
    for mark, sign in zip(MARKS, "[|]", strict=True):
        found = found.replace(mark, sign)
    assert found.replace("\n", "") == written


def test_conflict_with_the_developers_side():
    assert "".join(settled(MERGED)) == "a\nmine\ntoo\nb\n"
    assert settled(["a\n", Conflict(["mine"], [], [])]) == ["a\n", "mine"]


def test_conflict_as_a_patch():
    """Of the file with the developer's side."""
    assert rejected("a.py", [*MERGED, "d\n", Conflict(["e\n"], ["f\n", "g\n"], [])]) == (
        "diff a/a.py b/a.py\t(rejected hunks)\n"
        "@@ -2,1 +2,1 @@\n-old\n+new\n"
        "@@ -5,1 +5,0 @@\n-c\n"
        "@@ -6,2 +6,0 @@\n-f\n-g\n"
    )


def test_texts_as_lines():
    assert split("a\rb\n\nc") == ["a\rb\n", "\n", "c"]
    assert split("a\n") == ["a\n"]
    assert split("") == []
    assert margin(" \t a ") == 3
    assert plain("\ufeffa\r\nb\r") == "a\nb\r"
