"""Two branches become one, with a model of a few lines in the place of Copier, so quickly."""

import itertools
import re
import subprocess
import textwrap
from operator import methodcaller
from pathlib import PurePosixPath

import pytest
import yaml

from hooks.dictionary import load
from hooks.faults import SpecError
from hooks.merge.branches import Branches, Joiner, Side, people, settle, under_way, wrong_merge
from hooks.merge.merging import Version, by_line
from hooks.merge.tree import LINK, File, read_folder, read_paths, write
from hooks.merge.update import Update
from hooks.merge.versions import Versions
from support.repository import ROOT, commit, git
from support.small_model import ANSWERS, LOGIC, SPEC, Model, answers


class Team:
    """A package in a repository, whose developers write lines in callbacks."""

    def __init__(self, folder):
        self.folder = folder

    def make(self, *callbacks, branch="", message="Update", **lines):
        """Commit what the model makes of callbacks, and lines in them."""
        if branch:
            self.git("checkout", "-q", "-B", branch, "start")
        made = Model().recorded(answers(*callbacks)).tree
        for path in {*read_folder(self.folder)} - {*made}:
            (self.folder / path).unlink()
        for path, file in made.items():
            write(self.folder / path, file)
        self.answer(*callbacks)
        self.edit(**lines)
        commit(self.folder, message)

    def answer(self, *callbacks, **others):
        text = yaml.safe_dump(answers(*callbacks, **others))
        (self.folder / ANSWERS).write_text(text, newline="\n")

    def edit(self, **lines):
        """Write a line into each of some callbacks."""
        for name, line in lines.items():
            start = f'"""Serve {name}."""\n'
            text = (self.folder / "arm.py").read_text()
            assert start in text
            text = text.replace(start, f"{start}        {line} = 1\n")
            (self.folder / "arm.py").write_text(text, newline="\n")

    def git(self, *arguments):
        return git(self.folder, *arguments)

    def begin(self, *arguments):
        """Run a command of git's that stops at conflicts."""
        command = ["git", "-c", "core.editor=true", *arguments]
        assert subprocess.run(command, cwd=self.folder, capture_output=True).returncode

    def joiner(self, *callbacks, **others):
        dictionary = load(ROOT / "python_model/dictionary.yaml", ROOT)
        given = answers(*callbacks, **others)
        return Joiner(self.folder, ANSWERS, given, Model(), dictionary, {})

    def now(self):
        return {path: file for path, file in read_folder(self.folder).items() if path != ANSWERS}

    def wrong(self, *callbacks):
        return wrong_merge(self.joiner(*callbacks), self.now())

    def update(self, *callbacks, inline=True):
        """Update as Copier would have us do, and return what is said."""
        update = Update(self.folder, ANSWERS, quiet=True)
        self.answer(*callbacks)
        joiner = self.joiner(*callbacks)
        about = (joiner.answers, joiner.renderer, joiner.dictionary, {})
        return update.finish(*about, inline=inline).lines


@pytest.fixture
def team(tmp_path):
    team = Team(tmp_path)
    team.make("load", "store")
    team.git("tag", "start")
    team.make("load", "store", "park", branch="topic", load="theirs")
    team.make("load", "store", "home", branch="main", store="ours")
    return team


BOTH = ("load", "store", "home", "park")


@pytest.mark.parametrize("ours", ["1.0.0", "a commit without a tag"])
def test_version_older_than_that_of_a_branch(ours):
    commits = {"ours": {"_commit": ours}, "theirs": {"_commit": "1.2.0"}}
    joiner = Joiner(None, ANSWERS, {"_commit": "1.1.0"}, None, None, {})
    joiner.recorded = commits.get
    with pytest.raises(SpecError) as caught:
        joiner.check(Branches("ours", "theirs", []), [])
    assert str(caught.value) == (
        "one branch was made by version 1.2.0 of the model, newer than 1.1.0;"
        " add --vcs-ref=1.2.0 [older-version]"
    )


def merge_wrong(team, *paths, callbacks=BOTH, others=("topic",)):
    """Merge branches right, but take some files of one side; return the commit."""
    if others:
        team.git("merge", "-q", "-s", "ours", "--no-commit", *others)
    ours = read_paths(team.folder, paths)
    made = Model().recorded(answers(*callbacks)).tree
    for path, file in made.items():
        write(team.folder / path, file)
    team.answer(*callbacks)
    team.edit(store="ours", load="theirs")
    for path in paths:
        write(team.folder / path, ours[path]) if path in ours else (team.folder / path).unlink()
    commit(team.folder, "Merge")
    return team.git("rev-parse", "HEAD")


def test_what_git_is_about_to_join(team):
    """Each of its ways, and what the two come from; nothing where nothing is under way."""
    start, topic = team.git("rev-parse", "start"), team.git("rev-parse", "topic")
    assert under_way(team.folder, ANSWERS) is None
    team.begin("cherry-pick", "topic")
    assert under_way(team.folder, ANSWERS) == Branches("HEAD", topic, [start])
    team.git("cherry-pick", "--abort")
    main = team.git("rev-parse", "main")
    team.git("checkout", "-q", "topic")
    team.begin("rebase", "main")
    assert under_way(team.folder, ANSWERS) == Branches("HEAD", topic, [start])
    team.git("rebase", "--abort")
    team.begin("merge", "main")
    assert under_way(team.folder, ANSWERS) == Branches("HEAD", main, [start])


@pytest.mark.parametrize("branch", ["main", "topic"])
def test_merge_with_what_no_model_has_made_is_left_to_git(team, branch):
    """Only both sides together can be joined."""
    team.git("checkout", "-q", branch)
    team.git("rm", "-q", ANSWERS)
    team.git("commit", "-q", "-m", "Leave the model")
    team.git("checkout", "-q", "main")
    team.git("merge", "-q", "-s", "ours", "--no-commit", "topic")
    assert under_way(team.folder, ANSWERS) is None


def test_merge_of_three_is_refused(team):
    heads = [team.git("rev-parse", one) for one in ("topic", "start")]
    (team.folder / ".git/MERGE_HEAD").write_text("".join(f"{head}\n" for head in heads))
    with pytest.raises(SpecError, match=r"^3 branches are merged at once .*\[several-branches\]$"):
        under_way(team.folder, ANSWERS)


def test_merge_that_is_under_way_is_joined(team):
    team.begin("merge", "topic")
    team.git("checkout", "-q", "HEAD", "--", "arm.py", ANSWERS)
    text = (team.folder / "arm.py").read_text() + "BY_HAND = 1\n"
    (team.folder / "arm.py").write_text(text)
    (team.folder / SPEC).write_text("resolved\n")
    said = team.update(*BOTH)
    text = (team.folder / "arm.py").read_text()
    assert all(f"serve_{name}" in text for name in BOTH)
    bodies = {part.partition("(")[0]: part for part in text.split("serve_")}
    assert "theirs = 1" in bodies["load"]
    assert "ours = 1" in bodies["store"]
    assert (team.folder / SPEC).read_text() == "resolved\n"
    assert "BY_HAND" not in text
    (line,) = (line for line in said if "BY_HAND" in line)
    name = line.removesuffix(")").split()[-1]
    assert "BY_HAND" in team.git("show", name)
    assert [line for line in said if "lines are in their place" in line] == [said[-1]]
    assert said[-1].startswith("2 of 2 ")
    status = team.git("status", "--porcelain").split("\n")
    assert all(line[0] in "MA" and line[1] == " " for line in status)
    assert f"M  {ANSWERS}" in status


@pytest.mark.parametrize("path", ["README.md", "arm.py", "config/park.yaml"])
def test_merge_that_has_left_a_file_of_one_side_is_seen(team, path):
    """Until the file is mended, by whom ever."""
    commit_ = merge_wrong(team, path)
    main, topic, start = (team.git("rev-parse", one) for one in ("main^", "topic", "start"))
    found = team.wrong(*BOTH)
    assert found == Branches(main, topic, [start], commit_, (path,))
    commit(team.folder, "Something else")
    assert team.wrong(*BOTH) == found
    write(team.folder / path, Model().recorded(answers(*BOTH)).tree[path])
    assert team.wrong(*BOTH) is None


def test_merge_that_has_left_what_one_side_no_longer_makes_is_seen(team):
    commit_ = merge_wrong(team, "config/home.yaml", callbacks=("load", "store", "park"))
    found = team.wrong("load", "store", "park")
    assert (found.merge, found.files) == (commit_, ("config/home.yaml",))


def test_merge_that_has_dropped_lines_of_one_side_is_seen(team):
    """The file is the other side's, and such as any spec makes it."""
    team.git("checkout", "-q", "topic")
    (team.folder / "rate.txt").write_text("rate: 1\nmine: 2\n")
    commit(team.folder, "Write")
    team.git("checkout", "-q", "main")
    commit_ = merge_wrong(team, "rate.txt")
    found = team.wrong(*BOTH)
    assert (found.merge, found.files) == (commit_, ("rate.txt",))
    (team.folder / "rate.txt").write_text("rate: 2\n")
    assert team.wrong(*BOTH) is None


def test_wrong_merge_of_three_is_refused(team):
    team.make("load", "store", branch="third", load="another's")
    team.git("checkout", "-q", "main")
    merge_wrong(team, "README.md", others=("topic", "third"))
    with pytest.raises(SpecError, match=r"^3 branches are merged at once .*\[several-branches\]$"):
        team.wrong(*BOTH)


def test_right_merge_is_not_joined_again(team):
    merge_wrong(team)
    assert team.wrong(*BOTH) is None


def test_commit_without_another_side_is_no_merge(team):
    assert team.wrong("load", "store", "home") is None
    team.git("checkout", "-q", "start")
    assert team.wrong("load", "store") is None


def test_branch_that_was_squashed_is_made_of_what_was_before(team):
    commit_ = merge_wrong(team, "README.md", others=())
    main = team.git("rev-parse", "HEAD^")
    assert team.wrong(*BOTH) == Branches("", main, [], commit_, ("README.md",))
    (first, *_) = team.update(*BOTH)
    assert first == (
        f"! {commit_[:7]} has left files that were not made of the recorded spec: README.md:"
        " made of the spec before it"
    )
    assert (team.folder / "README.md").read_bytes() == (
        Model().recorded(answers(*BOTH)).tree["README.md"].data
    )


def test_another_model_is_no_merge(team):
    merge_wrong(team, "README.md")
    team.answer(*BOTH, _src_path="other")
    commit(team.folder, "Follow another")
    assert team.wrong(*BOTH) is None


def test_what_a_developer_has_changed_or_deleted_is_not_of_another_spec(team):
    """Else each update would bring it back."""
    team.make("load", "store", branch="main")
    text = (team.folder / "README.md").read_text().replace("- load\n", "- to load\n")
    (team.folder / "README.md").write_text(text)
    (team.folder / "config/store.yaml").unlink()
    commit(team.folder, "Write")
    (team.folder / "config/home.yaml").write_text("home: 1\n")
    text = (team.folder / "arm.py").read_text() + LOGIC.format("home")
    (team.folder / "arm.py").write_text(text)
    (team.folder / "README.md").write_text((team.folder / "README.md").read_text() + "- home\n")
    team.answer("load", "store", "home")
    commit(team.folder, "Update")
    assert team.wrong("load", "store", "home") is None


def test_what_came_after_a_wrong_merge_stays(team):
    commit_ = merge_wrong(team, "README.md")
    team.edit(home="later")
    (team.folder / "notes.txt").write_text("mine\n")
    commit(team.folder, "Go on")
    said = team.update(*BOTH)
    assert said[0] == (
        f"! {commit_[:7]} has left files that were not made of the recorded spec: README.md:"
        " joined again from its two sides"
    )
    text = (team.folder / "arm.py").read_text()
    assert all(f"{line} = 1" in text for line in ("ours", "theirs", "later"))
    assert "- park\n" in (team.folder / "README.md").read_text()
    assert (team.folder / "notes.txt").read_text() == "mine\n"
    assert team.git("diff", "--cached", "--name-only") == ""


@pytest.mark.parametrize("later", ["", "beside"])
@pytest.mark.parametrize("inline", [True, False])
def test_conflict_of_a_wrong_merge_is_asked_once_whatever_came_after(team, inline, later):
    """Between marks in the file, or in one beside it."""
    for branch, word in (("topic", "True"), ("main", "False")):
        team.git("checkout", "-q", branch)
        text = (team.folder / "arm.py").read_text()
        (team.folder / "arm.py").write_text(text.replace("return None", f"return {word}", 1))
        commit(team.folder, "Answer")
    merge_wrong(team, "README.md")
    (team.folder / "notes.txt").write_text("mine\n")
    team.edit(**({"home": later} if later else {}))
    commit(team.folder, "Go on")
    assert "CONFLICT  arm.py" in team.update(*BOTH, inline=inline)
    text = (team.folder / "arm.py").read_text()
    marks = re.findall("(?m)^(?:<<<|===|>>>).*$", text)
    if inline:
        assert [mark[0] for mark in marks] == ["<", "=", ">"]
        assert text.index("return False") < text.index("return True")
    else:
        assert (marks, "return True" in text) == ([], False)
        assert "+        return True\n" in (team.folder / "arm.py.rej").read_text()
    assert "return False" in text
    assert f"{later} = 1" in text or not later


def test_base_of_branches_that_have_merged_each_other(team):
    """Both last common commits count; without any, what the model makes."""
    joiner = team.joiner(*BOTH)
    text = joiner.base(["main", "topic"])["arm.py"].text
    assert "ours = 1" in text
    assert "theirs = 1" in text
    made = Model().fresh(answers(*BOTH)).tree
    assert joiner.base([]) == made
    assert {**joiner.base(["start"]), SPEC: made[SPEC]} == made
    team.git("rm", "-q", ANSWERS)
    team.git("commit", "-q", "-m", "Without a model")
    assert joiner.base(["HEAD"]) == made
    assert joiner.base(["HEAD", "topic"]) == joiner.base(["topic"])


@pytest.mark.parametrize(
    ("ours", "theirs", "now", "given", "said"),
    [
        ("a", "b", "a", (), "b"),
        ("b", "a", "a", (), "b"),
        ("b", "a", "b", (), None),
        ("a", "b", "b", (), None),
        ("a", "b", "a", ("license",), None),
        ("b", "c", "b", (), "c"),
        ("b", "b", "a", (), "b"),
        ("a", "a", "a", (), None),
    ],
)
def test_answer_that_differs_is_to_be_given(team, ours, theirs, now, given, said):
    """That which one side has changed; "a" is the one that both come from."""
    sides = {"ours": ours, "theirs": theirs, "base": "a"}
    # The addresses and specs of both may differ, too.
    recorded = {
        side: {"license": one, "_src_path": side, "spec": {"name": side}}
        for side, one in sides.items()
    }
    joiner = team.joiner(*BOTH, license=now)
    joiner.recorded = recorded.get
    branches = Branches("ours", "theirs", ["base"])
    if said is None:
        joiner.check(branches, given)
        return
    with pytest.raises(SpecError) as caught:
        joiner.check(branches, given)
    assert str(caught.value) == (
        f"license: one branch has {ours}, the other {theirs}; say which one the package is to"
        f" have: -d license={said} [answers-differ]"
    )


def files(**texts):
    return {f"{name}.py": File(text.encode()) for name, text in texts.items()}


def test_files_that_one_developer_has_moved_are_those_that_the_other_edits():
    """The most alike first, each once, and none with another ending."""
    lines = [f"a{number}\n" for number in range(10)]
    near, far = ("".join([*lines[:keep], "b\n" * (10 - keep)]) for keep in (9, 7))
    old = files(one="".join(lines), two=far)
    moved = files(to_one=near, to_two=far) | {"copy.txt": old["one.py"]}
    edited = {**old, "one.py": File(b"mine\n" + old["one.py"].data)}
    for sides in ((moved, edited), (edited, moved)):
        result, wrong = people(sides[0], old, sides[1]).merged()
        assert not wrong
        assert {*result.tree} == {"to_one.py", "to_two.py", "copy.txt"}
        assert result.tree["to_one.py"].text == "mine\n" + near


@pytest.mark.parametrize("is_ours", [True, False])
def test_file_like_the_one_that_a_developer_has_moved_is_deleted(is_ours):
    lines = "".join(f"a{number}\n" for number in range(10))
    old = files(moved=lines, deleted=lines.replace("a9", "b"))
    sides = (files(to=lines), {**old, "moved.py": File(b"mine\n" + old["moved.py"].data)})
    first, second = sides if is_ours else sides[::-1]
    result, wrong = people(first, old, second).merged()
    assert (wrong, result.conflicts) == ([], {})
    assert result.tree == files(to="mine\n" + lines)


@pytest.mark.parametrize("branch", ["main", "topic"])
def test_conflict_of_one_developer_and_the_model_stays_one(team, branch):
    """The other developer has not touched what the model has changed, too."""
    team.git("checkout", "-q", branch)
    (team.folder / "rate.txt").write_text("rate: 7\n")
    commit(team.folder, "Tune")
    now = {SPEC: File(b"resolved by hand"), "rate.txt": File(b"rate: 1\n")}
    joined = team.joiner(*BOTH, rate=2).join(Branches("main", "topic", ["start"]), now)
    assert joined.result.tree[SPEC] == now[SPEC]
    stages = {1: b"rate: 1\n", 2: b"rate: 7\n", 3: b"rate: 2\n"}
    result = joined.result
    assert result.conflicts == {"rate.txt": stages}
    assert result.settled["rate.txt"].data == stages[2]
    assert "+rate: 2\n" in result.rejected["rate.txt"].text
    lines = result.tree["rate.txt"].text.split("\n")
    assert lines[1::2] == ["rate: 7", "rate: 2", ""]


@pytest.mark.parametrize("naming", "name from file param id exec type if unless".split())
def test_elements_of_other_names_that_both_write_at_one_place_are_two(naming):
    base, form = "<launch>\n</launch>\n", '  <own {}="{}" of="{}"/>\n'
    first, second = (form.format(naming, name, name) for name in "ab")
    texts = [base.replace("</", f"{own}</") for own in (first, second)]
    sides = ({"launch/arm.launch": File(text.encode())} for text in (texts[0], base, texts[1]))
    result, wrong = people(*sides).merged()
    assert (wrong, result.conflicts) == ([], {})
    both = base.replace("</", f"{first}{second}</")
    assert result.tree["launch/arm.launch"].text == both


EMPTY = "void Arm::cleanup()\n{\n}\n"
HELPER = "\nstatic int %s()\n{\n  return 1;\n}\n"
SCOPE = "  {\n    int %s = 2;\n  }\n"


def joined_texts(ours, theirs, base=EMPTY):
    """Join the two texts of a source file that two developers have made of one."""
    sides = ({"src/arm_impl.cpp": File(text.encode())} for text in (ours, base, theirs))
    versions = Versions(*sides, of_people=True)
    result, wrong = versions.merged()
    assert not wrong
    return versions, result, result.tree["src/arm_impl.cpp"].text


@pytest.mark.parametrize(
    "ends", [("", ""), (HELPER % "lift", HELPER % "sink"), (HELPER % "lift", "")]
)
def test_both_write_blocks_with_braces_in_one_empty_function(ends):
    """The brace of the function is not one of a block in it."""
    written = EMPTY.replace("{\n", "{\n%s")
    ours, theirs = (written % (SCOPE % name) + end for name, end in zip("ab", ends, strict=True))
    _, result, text = joined_texts(ours, theirs, EMPTY + "\n")
    assert not result.conflicts
    assert written % (SCOPE % "b" + SCOPE % "a") in text
    assert all(end in text for end in ends)


def test_line_of_a_join_in_another_function_is_seen():
    """Even between the lines that it was between."""
    ours, helper = EMPTY.replace("{\n", "{\n" + SCOPE % "a"), HELPER % "lift"
    versions, result, text = joined_texts(ours, EMPTY + helper)
    assert versions.doubts(result) == []
    wrong = text.replace(SCOPE % "a", "").replace("  return 1;\n", SCOPE % "a" + "  return 1;\n")
    result.tree["src/arm_impl.cpp"] = File(wrong.encode())
    assert ("src/arm_impl.cpp", "int a = 2;") in versions.doubts(result)


@pytest.mark.parametrize("is_ours", [True, False])
def test_one_moves_a_file_that_the_other_edits_and_leaves_a_link(is_ours):
    page = "# Arm\n\nWhat it is.\n\n## Use\n\nHow to.\n"
    moved = {"docs/README.md": File(page.encode()), "README.md": File(b"docs/README.md", LINK)}
    edited = {"README.md": File(page.replace("How to.", "How to.\n\n## Help\n\nAsk.").encode())}
    sides = (moved, edited) if is_ours else (edited, moved)
    result, wrong = people(sides[0], {"README.md": File(page.encode())}, sides[1]).merged()
    assert (wrong, result.conflicts) == ([], {})
    assert result.tree == {**moved, "docs/README.md": edited["README.md"]}


@pytest.mark.parametrize("is_ours", [True, False])
def test_both_wrap_a_node_and_one_has_the_line_ends_of_windows(is_ours):
    base = '<launch>\n  <arg name="a"/>\n  <node name="arm"/>\n</launch>\n'
    sides = [
        base.replace("  <node", f"<group>  <!-- {name} -->\n  <node").replace(
            "</launch>", f"</group>  <!-- {name} ends -->\n</launch>"
        )
        for name in "ab"
    ]
    encoded = [sides[0].replace("\n", "\r\n").encode(), sides[1].encode()]
    files = [{"launch/arm.launch": File(each)} for each in (encoded if is_ours else encoded[::-1])]
    result, wrong = people(files[0], {"launch/arm.launch": File(base.encode())}, files[1]).merged()
    assert (wrong, result.conflicts) == ([], {})
    text = result.tree["launch/arm.launch"].data
    assert text.count(b"\r\n") == text.count(b"\n") > 0
    assert all(name in text for name in (b"<!-- a -->", b"<!-- b ends -->"))


AROUND = {
    "launch/arm.launch": (
        "<launch>\n{}</launch>\n",
        '  <node name="{0}"/>\n\n',
        "  <group if={!r}>\n{}  </group>\n",
    ),
    "CMakeLists.txt": ("project(arm)\n\n{}", "add_{0}({0})\n\n", "if({})\n{}endif()\n"),
    "src/arm_impl.cpp": ("{}", "void {0}()\n{{\n}}\n\n", "#ifdef {}\n{}#endif\n"),
    "include/arm.hpp": ("{}", "void {0}()\n{{\n}}\n\n", "namespace {}\n{{\n{}}}\n"),
    "arm/arm_impl.py": ("{}", "def {0}(self):\n    pass\n\n\n", "class {}:\n{}"),
    "arm/arm_ros.py": ("import a\n\n{}", "import {0}\n\n\n", "if {}:\n{}"),
}
"""A file, a thing in it, and what a developer may put around it."""


def put_around(path, text, *heads):
    """Return a text of things with containers around it, the first one inside."""
    for head in heads:
        text = AROUND[path][2].format(head, textwrap.indent(text, " " * 4 * path.endswith(".py")))
    return text


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize(
    ("ours", "theirs"),
    [
        ("a[one]", "b[one]"),
        ("a[one two]", "b[two three]"),
        ("a[one two]", "b[two]"),
        ("a[one two three]", "b[two]"),
        ("a[one two]", "a[two]"),
        ("a[one]", "a[two]"),
        ("a[one]", "a[one]"),
        ("c[four] a[one]", "c[four] b[one]"),
    ],
)
@pytest.mark.parametrize("is_ours", [True, False])
def test_both_put_something_around_the_same(path, ours, theirs, is_ours):
    """They choose, unless it is around different things, or the same."""
    whole, thing, _ = AROUND[path]

    def written(side):
        parts = {name: thing.format(name) for name in ("one", "two", "three", "four")}
        for head, inside in re.findall(r"(\w)\[(.*?)\]", side):
            names = inside.split()
            text = put_around(path, "".join(parts[name] for name in names), head)
            parts |= {**dict.fromkeys(names, ""), names[0]: text}
        return whole.format("".join(parts.values()))

    base = written("c[four]" if "c" in ours else "")
    sides = [{path: File(written(side).encode())} for side in (ours, theirs)]
    first, second = sides if is_ours else sides[::-1]
    result, wrong = people(first, {path: File(base.encode())}, second).merged()
    assert not wrong
    both = " ".join(sorted({ours, theirs}))
    if both in ("a[one] a[two]", "a[one]"):
        assert not result.conflicts
        assert result.tree[path].text.split() == written(both).split()
    else:
        assert [*result.conflicts] == [path]


OWN = {
    ".launch": ('  <arg name="own"/>\n', "  <!-- own -->"),
    ".txt": ("set(OWN 1)\n", "  # own"),
    ".cpp": ("int own;\n", "  // own"),
    ".hpp": ("int own;\n", "  // own"),
    ".py": ("OWN = 1\n", "  # own"),
}
"""What a developer may write beside a thing, and at the end of a line of it."""


def joined(path, is_ours, base, *sides):
    """Join two texts that developers have made of one, and return the lines of both."""
    files = [{path: File(AROUND[path][0].format(text).encode())} for text in (base, *sides)]
    first, second = files[1:] if is_ours else files[:0:-1]
    result, wrong = people(first, files[0], second).merged()
    assert (wrong, result.conflicts) == ([], {})
    return [*filter(str.strip, result.tree[path].text.split("\n"))]


def commented(path, thing):
    """Return a thing with a comment at the end of its last line."""
    whole = thing.rstrip()
    return whole + OWN[PurePosixPath(path).suffix][1] + thing[len(whole) :]


def things(path):
    return [AROUND[path][1].format(name) for name in ("one", "two", "three")]


def lines_of(path, text):
    return [*filter(str.strip, AROUND[path][0].format(text).split("\n"))]


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("around", ["", "c"])
@pytest.mark.parametrize("is_beside", [False, True])
@pytest.mark.parametrize("is_ours", [True, False])
def test_what_one_writes_stays_in_what_the_other_puts_around(path, around, is_beside, is_ours):
    one, two, three = things(path)
    own, _ = OWN[PurePosixPath(path).suffix]
    ours = two + own if is_beside else commented(path, two)
    base, written = (
        put_around(path, text, *around) for text in (one + two + three, one + ours + three)
    )
    wrapped, wanted = (
        put_around(path, text, "a", *around) for text in (one + two + three, one + ours + three)
    )
    assert joined(path, is_ours, base, wrapped, written) == lines_of(path, wanted)


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("is_ours", [True, False])
def test_what_stands_again_in_a_container_is_still_there(path, is_ours):
    """A line in it is where it was written."""
    one, two, three = things(path)
    ours = commented(path, two)
    again = put_around(path, two, "a")
    found = joined(path, is_ours, one + two + three, one + ours + three, one + two + three + again)
    assert found == lines_of(path, one + ours + three + again)


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("is_ours", [True, False])
def test_what_one_puts_around_what_the_other_deletes_stays(path, is_ours):
    """They choose in Python, where nothing that is empty can stay, whoever joins."""
    one, two, three = things(path)
    texts = (put_around(path, two, "a"), two, "")
    ours, base, theirs = (AROUND[path][0].format(one + each + three) for each in texts)
    if path.endswith(".py"):
        files = [{path: File(text.encode())} for text in (ours, base, theirs)]
        result, wrong = people(*(files if is_ours else files[::-1])).merged()
        assert (wrong, [*result.conflicts], result.removed) == ([], [path], {})
    else:
        wanted = one + put_around(path, "", "a") + three
        found = joined(
            path, is_ours, one + two + three, *(one + each + three for each in texts[::2])
        )
        assert found == lines_of(path, wanted)


def test_lines_alone_do_not_tell_how_deep_they_are_in_what_the_other_puts_around():
    old = "class A:\n    x = 1\n\n    y = 2\n    z = 3\n"
    mine, new = old.replace("y = 2", "y = 2  # mine"), put_around("arm/arm_ros.py", old, "a")
    for sides in ((mine, new), (new, mine)):
        versions = [Version(text, lambda known: []) for text in (sides[0], old, sides[1])]
        assert by_line("arm/a.py", *versions, of_people=True).conflict


@pytest.mark.parametrize("of_people", [True, False])
def test_lines_alone_do_not_tell_whose_the_body_of_a_new_function_is(of_people):
    """The model gives a name another function; two people only add their own."""
    old = "def a():\n    pass\n\n\nx = 1\n"
    mine, new = old.replace("x = 1", "x = 2"), "def b():\n    pass\n\n\n" + old
    versions = [Version(text, methodcaller("blocks", text)) for text in (mine, old, new)]
    assert by_line("arm/a.py", *versions, of_people=of_people).conflict is not of_people


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("is_ours", [True, False])
def test_container_of_the_same_name_in_another_one_is_another(path, is_ours):
    one, two, three = things(path)
    own = put_around(path, OWN[PurePosixPath(path).suffix][0], "a", "c")
    wrapped = put_around(path, one, "a")
    found = joined(
        path, is_ours, one + two + three, wrapped + two + three, one + two + own + three
    )
    assert found == lines_of(path, wrapped + two + own + three)


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("is_ours", [True, False])
def test_both_move_another_thing(path, is_ours):
    base, ours, theirs, both = (
        "".join(AROUND[path][1].format(f"thing_{name}") for name in names)
        for names in ("abcdefg", "bcadefg", "abcdgef", "bcadgef")
    )
    assert joined(path, is_ours, base, ours, theirs) == lines_of(path, both)


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("is_ours", [True, False])
def test_both_put_the_same_around_different_things_and_one_writes_there(path, is_ours):
    one, two, three = things(path)
    written = commented(path, three)
    wrapped = put_around(path, one, "a")
    ours, theirs = wrapped + two + written, one + put_around(path, two + three, "a")
    wanted = wrapped + put_around(path, two + written, "a")
    assert joined(path, is_ours, one + two + three, ours, theirs) == lines_of(path, wanted)


@pytest.mark.parametrize("path", AROUND)
@pytest.mark.parametrize("is_empty", [False, True])
@pytest.mark.parametrize("is_ours", [True, False])
def test_container_of_the_same_name_that_holds_nothing_generated_is_another(
    path, is_empty, is_ours
):
    """One of it has been left empty, as by what left, or was written with own code in it."""
    parts = things(path)
    content = "" if is_empty and not path.endswith(".py") else OWN[PurePosixPath(path).suffix][0]
    own = put_around(path, content, "a")
    for at, (first, last) in itertools.product(range(4), itertools.combinations(range(4), 2)):
        ours = "".join([*parts[:at], own, *parts[at:]])
        before, after = "".join(parts[:first]), "".join(parts[last:])
        wrapped = put_around(path, "".join(parts[first:last]), "a")
        found = joined(path, is_ours, "".join(parts), ours, before + wrapped + after)
        if first < at < last:
            inside = "".join([*parts[first:at], own, *parts[at:last]])
            wanted = before + put_around(path, inside, "a") + after
        elif at <= first:
            wanted = "".join([*parts[:at], own, *parts[at:first], wrapped, after])
        else:
            wanted = "".join([before, wrapped, *parts[last:at], own, *parts[at:]])
        assert found == lines_of(path, wanted), (at, first, last)


FUNCTION = "int %s()\n{\n  return %s;\n}\n"


@pytest.mark.parametrize(
    ("ours", "base", "theirs", "wanted"),
    [
        ({"a": 1, "b": 2}, {"a": 1}, {"a": 1}, {"a": 1, "b": 2}),
        ({"a": 1, "b": 2}, {"a": 1}, {"a": 1, "b": 2}, {"a": 1, "b": 2}),
        ({"a": 1, "b": 2}, {"a": 1}, {"a": 1, "b": 3}, None),
        ({"a": 1}, {"a": 1, "b": 2}, {"a": 1, "b": 2}, {"a": 1}),
        ({"a": 1}, {"a": 1, "b": 2}, {"a": 1}, {"a": 1}),
        ({"a": 1}, {"a": 1, "b": 2}, {"a": 0}, {"a": 0}),
        ({"a": 1}, {"a": 1, "b": 2}, {"a": 1, "b": 3}, None),
        ({"a": 1, "b": 3}, {"a": 1, "b": 2}, {"a": 1}, None),
        ({"a": 1, "b": 3}, {"a": 1, "b": 2}, {"a": 1, "b": 4}, None),
        ({"a": 1, "b": 3}, {"a": 1, "b": 2}, {"a": 0, "b": 2}, {"a": 0, "b": 3}),
    ],
)
def test_functions_of_two_developers(ours, base, theirs, wanted):
    """What one has deleted and the other edited, or both wrote, neither has to give way."""
    sides = ("".join(FUNCTION % pair for pair in each.items()) for each in (ours, base, theirs))
    versions = Versions(
        *({"src/arm_impl.cpp": File(text.encode())} for text in sides), of_people=True
    )
    result, wrong = versions.merged()
    assert not wrong
    assert bool(result.conflicts) == (wanted is None)
    assert (result.removed, result.missing, result.own) == ({}, {}, {})
    text = result.tree["src/arm_impl.cpp"].text
    if wanted is not None:
        assert text == "".join(FUNCTION % pair for pair in wanted.items())
    else:
        parts = {part for each in (ours, theirs) for part in each.items()}
        assert all(f"return {value};" in text for name, value in parts if name == "b")
        (settled,) = (file.text for file in result.settled.values())
        assert settled == "".join(FUNCTION % pair for pair in ours.items())


def test_merge_of_two_that_is_not_proved(monkeypatch):
    wrong = [("a.py", f"x = {number}") for number in range(30)]
    monkeypatch.setattr(Versions, "merged", lambda made: (None, wrong))
    with pytest.raises(SpecError, match="nothing was joined") as caught:
        settle(people({}, {}, {}))
    first, *lines, last = str(caught.value).split("\n")
    assert lines == [f"  a.py: {what}" for _, what in wrong[:20]]
    assert first.endswith("put them in again: [merge-not-proved]")
    assert last == ""


@pytest.mark.parametrize(
    ("ours", "base", "theirs", "wanted"),
    [
        (None, "a", "a", None),
        ("a", "a", None, None),
        (None, "a", "b", "b"),
        ("b", "a", None, "b"),
        (None, "a", None, None),
        ("a", None, None, "a"),
        (None, None, "a", "a"),
    ],
)
def test_files_that_a_developer_has_deleted(ours, base, theirs, wanted):
    sides = [{"a.py": File(each.encode())} if each else {} for each in (ours, base, theirs)]
    result, wrong = people(*sides).merged()
    assert not wrong
    assert result.tree == ({"a.py": File(wanted.encode())} if wanted else {})
    assert bool(result.conflicts) == (wanted == "b")
    if wanted == "b":
        stages = dict(enumerate((base, ours, theirs), 1))
        found = {stage: text.encode() for stage, text in stages.items() if text}
        assert result.conflicts == {"a.py": found}
        assert result.settled == result.tree


class Sides(Joiner):
    """Joins what two developers have made of files, which the model has changed, too."""

    def __init__(self, before, after, **trees):
        super().__init__(None, ANSWERS, {}, None, None, {})
        self.before, self.after, self.made = before, after, trees

    def side(self, commit):
        mine = self.made[commit]
        made = Versions(mine, self.before, self.after)
        result, _ = made.merged()
        changed = [path for path, file in self.before.items() if file not in mine.values()]
        assert list(result.conflicts) == changed
        return Side(commit, made, result, made.proof(result, result.tree))

    def base(self, commits):
        return self.after

    def files(self, commit):
        return {}

    def result(self, first, second):
        spec = {SPEC: File(b"<arm/>\n")}
        result = self.join(Branches(first, second, []), spec).result
        assert {SPEC: result.tree.pop(SPEC)} == spec
        return result


@pytest.mark.parametrize("branches", [("moved", "tuned"), ("tuned", "moved")])
@pytest.mark.parametrize("content", [b"arm:\n  speed: %d\n", b"\0%d"], ids=["text", "binary"])
def test_conflict_with_the_model_follows_a_file_that_the_other_has_moved(content, branches):
    path, target = "config/arm.yaml", "config/mine/arm.yaml"
    before, after, tuned = (File(content % speed) for speed in (1, 2, 3))
    if b"\0" in content:  # which is no text in which what has moved could be known
        target = path
    trees = {"moved": {target: before}, "tuned": {path: tuned}}
    result = Sides({path: before}, {path: after}, **trees).result(*branches)
    assert list(result.conflicts) == [target]
    text = result.tree[target].text
    if text is not None:
        assert re.findall(r"speed: \d", text) == ["speed: 3", "speed: 2"]
        assert text.startswith("arm:\n<<<<<<<")


def test_conflict_of_two_developers_and_the_model_is_marked_once():
    """And one that one of them has with the model, beside it."""
    path, other = "config/arm.yaml", "config/leg.yaml"
    before, after, ours, theirs = (
        {path: File(b"arm:\n  speed: %d\n" % speed), other: File(b"leg: %d\n" % leg)}
        for speed, leg in ((1, 1), (2, 2), (3, 3), (4, 1))
    )
    result = Sides(before, after, ours=ours, theirs=theirs).result("ours", "theirs")
    assert list(result.conflicts) == [path, other]
    assert re.findall(r"leg: \d", result.tree[other].text) == ["leg: 3", "leg: 2"]
    text = result.tree[path].text
    assert text.count("<<<<<<< ") == 1
    assert re.findall(r"speed: \d", text) == ["speed: 3", "speed: 4"]
