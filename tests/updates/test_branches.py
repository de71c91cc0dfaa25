"""Two branches of a package become one, each with changes of its spec and lines of its own."""

import contextlib
import io
import os
import re
import shutil
import subprocess
import sys

import copier
import pytest
from copier import VcsRef
from copier.errors import UserMessageError

from support.arm import SPEC
from support.documentation import blocks
from support.laboratory.trials import second_version
from support.repository import commit, git

ANSWERS = ".copier-answers.yml"
STOP = '    <directSubscriber name="stop" type="std_msgs::Empty"/>\n'
HOME = '    <serviceServer name="home" type="std_srvs::Trigger"/>\n'
PARK = HOME.replace("home", "park")
WATCH = '  <node name="watch" frequency="1">\n'
PATHS = {"python_model": "arm/{}_impl.py", "cpp_model": "src/{}_impl.cpp"}
STARTS = {
    "python_model": (r"(?m)^    def {}\((?:.|\n)*?\n        \"\"\".*\"\"\"\n", "        # {}\n"),
    "cpp_model": (r"(?m)^\w.*::{}\((?:.|\n)*?\n\{{\n", "  // {}\n"),
}
"""Where the body of a function begins, and a line of logic."""


class Team:
    """A package, of which each developer has a branch."""

    def __init__(self, package, model):
        self.package, self.model = package, model
        self.spec = package / "arm.ros_package"

    def copier(self, run, fails=False, **options):
        """Run Copier as its command does; return what it says."""
        said = io.StringIO()
        failed = False
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            try:
                run(self.package, defaults=True, unsafe=True, overwrite=True, **options)
            except UserMessageError as error:
                failed = True
                said.write(str(error))
        assert failed == fails, said.getvalue()
        return said.getvalue()

    def update(self, **options):
        return self.copier(copier.run_update, **options)

    def join(self, **options):
        return self.copier(copier.run_recopy, **options)

    def git(self, *arguments):
        return git(self.package, *arguments)

    def text(self, node="reach"):
        return (self.package / PATHS[self.model].format(node)).read_text()

    def write(self, **lines):
        """Write a line of logic at the start of functions: `serve_load="a line"`."""
        start, form = STARTS[self.model]
        for function, line in lines.items():
            node = "watch" if function.startswith("watch_") else "reach"
            path = self.package / PATHS[self.model].format(node)
            place = start.format(function.removeprefix("watch_"))
            text, count = re.subn(
                place, lambda m, line=line: m[0] + form.format(line), self.text(node)
            )
            assert count == 1, (function, text)
            path.write_text(text)

    def work(self, branch, spec, data=None, at="start", **lines):
        """Change the spec on a branch, update, write lines."""
        self.git("checkout", "-q", "-B", branch, *([at] if branch != "main" else []))
        self.spec.write_text(spec)
        commit(self.package, f"Change the spec on {branch}")
        self.update(data=data)
        self.write(**lines)
        commit(self.package, f"Update on {branch}")

    def begin(self, *arguments):
        """Run a command of git's that may stop at conflicts; say whether it has."""
        command = ["git", *arguments]
        return bool(subprocess.run(command, cwd=self.package, capture_output=True).returncode)

    def resolve(self, spec):
        """Resolve the spec alone."""
        self.spec.write_text(spec)
        self.git("checkout", "HEAD", "--", ANSWERS)

    def has(self, **lines):
        """Insist that each line is in its function, once, and that an update changes nothing."""
        start, form = STARTS[self.model]
        for function, line in lines.items():
            text = self.text("watch" if function.startswith("watch_") else "reach")
            assert text.count(line) == 1, (line, text)
            place = start.format(function.removeprefix("watch_"))
            end = "    def " if self.model == "python_model" else "\n}\n"
            body = re.split(place, text)[1].partition(end)[0]
            assert form.format(line).strip() in body
        assert "<<<<<<<" not in self.text()
        self.is_current()

    def is_current(self):
        """Do what the job of a package's CI does."""
        assert self.git("status", "--porcelain") == ""
        said = self.update(vcs_ref=VcsRef.CURRENT)
        assert self.git("status", "--porcelain") == "", said + self.git("diff", "HEAD")
        assert "not made of the recorded spec" not in said


OURS = SPEC.replace(STOP, STOP + HOME)
THEIRS = SPEC.replace(STOP, STOP + PARK)
BOTH = SPEC.replace(STOP, STOP + HOME + PARK)
THEIRS_ELSEWHERE = SPEC.replace(WATCH, WATCH + PARK)
BOTH_ELSEWHERE = OURS.replace(WATCH, WATCH + PARK)
LINES = {"serve_home": "homed", "serve_store": "ours"}
TOGETHER = LINES | {"serve_park": "parked", "serve_load": "theirs"}


def branches(team):
    team.work("topic", THEIRS, serve_park="parked", serve_load="theirs")
    team.git("checkout", "-q", "main")
    team.work("main", OURS, **LINES)


def elsewhere(team):
    """Make the same in two nodes: git merges the answers without a question."""
    team.work("topic", THEIRS_ELSEWHERE, watch_serve_park="parked", serve_load="theirs")
    team.git("checkout", "-q", "main")
    team.work("main", OURS, **LINES)


@pytest.fixture(scope="session")
def teams(published, tmp_path_factory):
    """Make a package, and what was done in it; each once."""
    known = {}

    def get(model, work=None):
        if (model, work) not in known:
            folder = tmp_path_factory.mktemp("team") / "arm"
            known[model, work] = folder
            if work:
                shutil.copytree(get(model), folder)
                work(Team(folder, model))
                return folder
            spec = folder.parent / "spec.xml"
            spec.write_text(SPEC)
            data = {"ros_distro": "kilted", "spec_file": str(spec)}
            options = {"defaults": True, "unsafe": True, "quiet": True}
            source = str(published / f"{model}.git")
            copier.run_copy(source, folder, data=data, **options)
            team = Team(folder, model)
            commit(folder, "Render")
            team.write(serve_load="first", serve_store="second", watch_serve_load="third")
            commit(folder, "Write the logic")
            team.git("tag", "start")
        return known[model, work]

    return get


@pytest.fixture
def make_team(teams, tmp_path):
    def run(work=None, model="python_model"):
        return Team(shutil.copytree(teams(model, work), tmp_path / "arm", symlinks=True), model)

    return run


MODELS = pytest.mark.parametrize("model", ["python_model", "cpp_model"])


@MODELS
def test_files_of_one_side_are_not_of_the_recorded_spec(model, make_team):
    """A hand has taken a side of each file in conflict: seen before anything wrong is written."""
    team = make_team(branches, model)
    assert team.begin("merge", "topic")
    team.git("checkout", "--ours", ".")
    team.spec.write_text(BOTH)
    commit(team.package, "Merge")
    before = team.git("rev-parse", "--short=7", "HEAD")
    for pretend in (True, False):
        said = team.update(pretend=pretend)
        assert f"! {before} has left files that were not made of the recorded spec" in said
    team.git("add", "-A")
    team.git("commit", "-q", "-m", "Join")
    team.has(**TOGETHER)


def take_ours(team, *merge):
    """Merge two branches whose answers git can merge, but take some files from one side."""
    team.git("merge", "-q", "--no-commit", *merge, "topic")
    ours = team.git("ls-files", "README.md", "*watch_i*").split("\n")
    team.git("checkout", "HEAD", "--", *ours)
    assert team.spec.read_text() == BOTH_ELSEWHERE
    commit(team.package, "Merge")


ELSEWHERE = LINES | {"watch_serve_park": "parked", "serve_load": "theirs"}


@MODELS
def test_answers_that_git_has_merged_by_itself(model, make_team):
    """The case in which an update found nothing to do."""
    team = make_team(elsewhere, model)
    take_ours(team)
    said = team.update(vcs_ref=VcsRef.CURRENT)
    assert "not made of the recorded spec: README.md" in said
    assert team.git("status", "--porcelain")
    commit(team.package, "Join")
    team.has(**ELSEWHERE)


def test_what_came_after_a_wrong_merge_stays(make_team):
    team = make_team(elsewhere)
    take_ours(team)
    team.write(receive_stop="later")
    commit(team.package, "Go on")
    assert "not made of the recorded spec" in team.update()
    commit(team.package, "Join")
    team.has(**ELSEWHERE, receive_stop="later")


def test_branch_that_was_squashed_with_one_side(make_team):
    """No commit has two parents: each file is taken for what it was made of."""
    team = make_team(elsewhere)
    take_ours(team, "--squash")
    assert "not made of the recorded spec" in team.update()
    commit(team.package, "Mend")
    team.has(**LINES, serve_load="theirs")
    assert "def serve_park" in team.text("watch")


@pytest.mark.parametrize("way", ["merge", "rebase", "cherry-pick"])
@MODELS
def test_join_of_what_git_has_begun(model, make_team, way):
    team = make_team(branches, model)
    if way == "merge":
        stops = team.begin("merge", "topic")
    elif way == "rebase":
        stops = team.begin("rebase", "topic")
    else:
        stops = team.begin("cherry-pick", "start..topic")
    while stops:
        team.resolve(BOTH)
        team.join()
        assert not re.search("(?m)^(U|.U|AA|DD)", team.git("status", "--porcelain"))
        if way == "merge":
            team.git("commit", "-q", "--no-edit")
            break
        todo = "--skip" if not team.git("diff", "--cached", "--name-only") else "--continue"
        stops = team.begin("-c", "core.editor=true", way, todo)
    parents = team.git("rev-parse", "HEAD^@").split()
    assert len(parents) == (2 if way == "merge" else 1)
    team.has(**TOGETHER)


def test_clean_merge_needs_nothing(make_team):
    """Git merges by line what lies apart; an update finds nothing to do."""
    team = make_team()
    team.work("topic", SPEC.replace('"An arm"', '"A long arm"'), serve_load="theirs")
    team.git("checkout", "-q", "main")
    team.work("main", SPEC.replace('frequency="1"', 'frequency="2"'), serve_store="ours")
    assert not team.begin("merge", "topic")
    team.has(serve_load="theirs", serve_store="ours")


def test_three_branches_one_after_the_other(make_team):
    team = make_team(branches)
    third = SPEC.replace('    <dynParameter name="gain"', '    <dynParameter name="bias"')
    team.work("third", third, receive_stop="of the third")
    team.git("checkout", "-q", "main")
    assert team.begin("merge", "topic")
    team.resolve(BOTH)
    team.join()
    team.git("commit", "-q", "--no-edit")
    team.begin("merge", "--no-commit", "third")
    team.resolve(BOTH.replace('name="gain"', 'name="bias"'))
    team.join()
    team.git("commit", "-q", "--no-edit")
    assert "bias" in (team.package / "config/reach.yaml").read_text()
    team.has(**TOGETHER, receive_stop="of the third")


def test_criss_cross(make_team):
    """Both have merged the other once before: there are two commits that they have in common."""
    team = make_team(branches)
    team.git("tag", "before")
    for branch, other in (("main", "topic"), ("topic", "before")):
        team.git("checkout", "-q", branch)
        assert team.begin("merge", "--no-commit", other)
        team.resolve(BOTH)
        team.join()
        team.git("commit", "-q", "--no-edit")
        team.write(receive_stop=f"crossed on {branch}")
        commit(team.package, "Go on")
    assert len(team.git("merge-base", "--all", "main", "topic").split()) == 2
    team.begin("merge", "--no-commit", "main")
    team.resolve(BOTH)
    team.join()
    team.git("commit", "-q", "--no-edit")
    team.has(**TOGETHER)
    assert "crossed on main" in team.text()
    assert "crossed on topic" in team.text()


def test_octopus_is_refused(make_team):
    team = make_team(branches)
    team.work("third", SPEC.replace('frequency="1"', 'frequency="2"'))
    team.git("checkout", "-q", "main")
    heads = [team.git("rev-parse", branch) for branch in ("topic", "third")]
    (team.package / ".git/MERGE_HEAD").write_text("\n".join([*heads, ""]))
    team.spec.write_text(BOTH)
    said = team.join(fails=True)
    assert said.startswith("3 branches are merged at once here")
    assert said.endswith("[several-branches]")
    assert team.git("status", "--porcelain") == "M arm.ros_package"


def swapped(spec):
    first, second = (f'serviceServer name="{name}"' for name in ("load", "store"))
    spec = spec.replace(second, f'{first} was="store"', 1)
    return spec.replace(f"{first} type", f'{second} was="load" type', 1)


def renamed(spec, name="lift"):
    return spec.replace('serviceServer name="load"', f'serviceServer name="{name}" was="load"', 1)


@pytest.mark.parametrize(("change", "name"), [(renamed, "lift"), (swapped, "store")])
@MODELS
def test_one_renames_what_the_other_edits(model, make_team, change, name):
    team = make_team(model=model)
    team.work("topic", change(SPEC), **{f"serve_{name}": "theirs"})
    team.git("checkout", "-q", "main")
    team.work("main", OURS, serve_load="ours", serve_home="homed")
    team.begin("merge", "--no-commit", "topic")
    team.resolve(change(OURS))
    team.join()
    team.git("commit", "-q", "--no-edit")
    body = re.split(STARTS[team.model][0].format(f"serve_{name}"), team.text())[1][:120]
    assert [team.text().count(word) for word in ("ours", "theirs", "first", "second")] == [1] * 4
    assert all(word in body for word in ("ours", "theirs", "first"))
    team.has(serve_home="homed")


@MODELS
def test_one_renames_twice_what_the_other_edits(model, make_team):
    """The merged spec says the last of the names before, which the other never had."""
    team = make_team(model=model)
    team.work("topic", renamed(SPEC, "hoist"), serve_hoist="theirs")
    twice = ('"hoist" was="load"', '"lift" was="hoist"')
    team.work("topic", renamed(SPEC, "hoist").replace(*twice), at="topic", serve_lift="again")
    team.git("checkout", "-q", "main")
    team.work("main", OURS, serve_load="ours", serve_home="homed")
    team.begin("merge", "--no-commit", "topic")
    team.resolve(renamed(OURS, "hoist").replace(*twice))
    team.join()
    team.git("commit", "-q", "--no-edit")
    body = re.split(STARTS[team.model][0].format("serve_lift"), team.text())[1][:160]
    assert all(word in body for word in ("ours", "theirs", "again", "first"))
    assert "serve_load" not in team.text()


@MODELS
def test_both_rename_one_each_in_another_way(model, make_team):
    team = make_team(model=model)
    team.work("topic", renamed(SPEC), serve_lift="theirs")
    team.git("checkout", "-q", "main")
    team.work("main", renamed(OURS, "raise_arm"), serve_raise_arm="ours", serve_home="homed")
    team.begin("merge", "--no-commit", "topic")
    team.resolve(renamed(OURS, "raise_arm"))
    team.join()
    team.git("commit", "-q", "--no-edit")
    body = re.split(STARTS[team.model][0].format("serve_raise_arm"), team.text())[1][:120]
    assert all(word in body for word in ("ours", "theirs", "first"))
    assert "serve_lift" not in team.text()


@MODELS
def test_both_add_the_same_alike_and_differently(model, make_team):
    team = make_team(model=model)
    team.work("topic", OURS, serve_home="alike", serve_load="theirs")
    team.git("checkout", "-q", "main")
    team.work("main", OURS, serve_home="alike", serve_load="ours")
    team.begin("merge", "--no-commit", "topic")
    team.resolve(OURS)
    said = team.join()
    assert "Done, without conflicts" in said, said
    assert team.text().count("alike") == 1
    assert team.text().count("ours") == team.text().count("theirs") == 1


@MODELS
def test_one_removes_what_the_other_edits(model, make_team):
    """The lines leave with what was removed, and it is said by which command to see them."""
    team = make_team(model=model)
    load = '    <serviceServer name="load" type="std_srvs::Trigger"/>\n'
    team.work("topic", SPEC.replace(load, "", 1))
    team.git("checkout", "-q", "main")
    team.work("main", OURS, serve_load="edited", serve_home="homed")
    team.begin("merge", "--no-commit", "topic")
    team.resolve(OURS.replace(load, "", 1))
    said = team.join()
    (line,) = re.findall(r"(?m)^removed   .*serve_load from .*git show (\S+)\)$", said)
    assert "edited" in team.git("show", line)
    team.git("commit", "-q", "--no-edit")
    team.has(serve_home="homed")


@MODELS
def test_other_version_of_the_model_on_one_side(model, make_team, own_collection):
    team = make_team(model=model)
    for branch, spec in (("topic", THEIRS), ("main", OURS)):
        team.git("checkout", "-q", "-B", branch, "start")
        answers = team.package / ANSWERS
        answers.write_text(
            re.sub(
                "_src_path: .*",
                f"_src_path: {own_collection}\nmodel: {model}",
                answers.read_text(),
            )
        )
        commit(team.package, "Follow")
        if branch == "main":
            second_version(own_collection)
        team.git("tag", f"at_{branch}")
        team.work(branch, spec, at=f"at_{branch}")
        team.write(
            **(LINES if branch == "main" else {"serve_park": "parked", "serve_load": "theirs"})
        )
        commit(team.package, "Write")
    assert team.begin("merge", "topic")
    team.resolve(BOTH)
    team.join()
    team.git("commit", "-q", "--no-edit")
    assert "_commit: 2.0.0" in (team.package / ANSWERS).read_text()
    team.has(**TOGETHER)


@MODELS
def test_other_ros_on_one_side(model, make_team):
    team = make_team(model=model)
    noetic = {"ros_distro": "noetic"}
    team.work("topic", THEIRS, noetic, serve_park="parked", serve_load="theirs")
    team.git("checkout", "-q", "main")
    team.work("main", OURS, **LINES)
    assert team.begin("merge", "topic")
    team.resolve(BOTH)
    before = team.git("status", "--porcelain")
    said = team.join(fails=True)
    assert "-d ros_distro=noetic [answers-differ]" in said
    assert team.git("status", "--porcelain") == before
    team.join(data=noetic)
    team.git("commit", "-q", "--no-edit")
    team.has(**TOGETHER)


@MODELS
def test_same_lines_conflict(model, make_team):
    """As git marks conflicts: of each file three versions are in the index."""
    team = make_team(model=model)
    for branch, line in (("topic", "theirs"), ("main", "ours")):
        team.git("checkout", "-q", "-B", branch, "start")
        path = team.package / PATHS[team.model].format("reach")
        path.write_text(team.text().replace("first", line))
        team.spec.write_text(THEIRS if branch == "topic" else OURS)
        commit(team.package, "Change")
        team.update()
        commit(team.package, "Update")
    assert team.begin("merge", "topic")
    team.resolve(BOTH)
    said = team.join()
    path = PATHS[team.model].format("reach")
    assert f"CONFLICT  {path}" in said
    assert {*team.git("diff", "--name-only", "--diff-filter=U").split("\n")} == {path}
    versions = [team.git("show", f":{stage}:{path}") for stage in (1, 2, 3)]
    assert [word in text for word, text in zip(("first", "ours", "theirs"), versions, strict=True)]
    assert team.begin("commit", "-m", "Not yet")


def test_lines_of_a_resolution_are_said(make_team):
    """What stood in the place of the join is not git's yet; it is kept, and named."""
    team = make_team(branches)
    assert team.begin("merge", "topic")
    team.resolve(BOTH)
    path = team.package / "arm/reach_impl.py"
    path.write_text(path.read_text() + "\n# by hand\n")
    said = team.join()
    (name,) = re.findall(r"# by hand .*\(git show (\w+)\)", said)
    assert "# by hand" in team.git("show", name)


def test_what_fails_leaves_the_merge_as_it_was(make_team):
    team = make_team(branches)
    assert team.begin("merge", "topic")
    team.spec.write_text(BOTH.replace("std_srvs::Trigger", "std_srvs"))
    team.git("checkout", "HEAD", "--", ANSWERS)
    before = team.git("status", "--porcelain")
    team.join(fails=True)
    assert team.git("status", "--porcelain") == before
    team.spec.write_text(BOTH)
    team.join()
    team.git("commit", "-q", "--no-edit")
    team.has(**TOGETHER)


def test_page_of_two_branches(make_team):
    """The commands that docs/updates.md and the README tell, word by word."""
    team = make_team(branches)
    (told,) = blocks("docs/updates.md", "Two branches")
    every_day = blocks("README.md", "Every day")[0]
    words = [re.sub(" +#.*", "", line) for line in told.splitlines()]
    assert words[0] in every_day
    assert all(
        re.sub(r"arm\.ros_package", "mypkg.ros_package", word) in every_day for word in words
    )
    merged = team.package.parent / "merged.xml"
    merged.write_text(BOTH)
    script = team.package.parent / "bin/copier"
    script.parent.mkdir()
    script.write_text(f'#!/bin/sh\nexec {sys.executable} -m copier "$@"\n')
    script.chmod(0o755)
    environment = os.environ | {
        "EDITOR": f"cp {merged}",
        "GIT_EDITOR": "true",
        "PATH": f"{script.parent}:{os.environ['PATH']}",
    }
    subprocess.run(["sh", "-c", told], cwd=team.package, env=environment, check=True)
    assert len(team.git("rev-parse", "HEAD^@").split()) == 2
    team.has(**TOGETHER)
