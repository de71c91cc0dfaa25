"""Rehearse a release: what it does to packages, before it has a tag.

    PACKAGES=packages.txt pytest tests/test_rehearsal.py

Each line of the file is the address of a package's repository, and its folder in there if it is
not the top. Each package is updated to what is committed here. Where its ROS is sourced it is
built and tested; where that fails, so is the package of before: what failed already is no news. A
table ends the run; rehearsal.json, beside the list, has the same.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from dataclasses import asdict, dataclass, field
from pathlib import Path

import pytest
import yaml

LIST = os.environ.get("PACKAGES", "")
ROOT = next(parent for parent in Path(__file__).absolute().parents if (parent / "hooks").exists())
FINDINGS = r"^(?:removed|left|yours|back|missing) +.+$"
"""What an update says of lines of the developer's, besides conflicts."""
BUILD = {
    1: "catkin_make --only-pkg-with-deps {name}",
    2: "colcon build --packages-up-to {name}",
}
TEST = {
    1: "catkin_make --only-pkg-with-deps {name} run_tests_{name}"
    " && catkin_test_results build/test_results/{name}",
    2: "colcon test --packages-select {name} --return-code-on-test-failure",
}
NO_ROS = "ROS {ros} is not sourced"
NO_NEWS = "fails as before"


@dataclass
class Outcome:
    """What became of a package."""

    package: str
    ros: int = 0
    version: str = ""
    update: str = ""
    conflicts: list[str] = field(default_factory=list)
    findings: list[str] = field(default_factory=list)
    build: str = ""

    def row(self):
        return (self.package, self.version, self.update, self.build)

    def is_good(self):
        fine = ("passes", NO_NEWS, NO_ROS.format(ros=self.ros))
        return self.update == "clean" and self.build in fine


def packages():
    """Return the address of each package and its folder there."""
    lines = Path(LIST).read_text().splitlines() if LIST else []
    return [(*shlex.split(line), ".")[:2] for line in lines if line.strip()[:1] not in ("", "#")]


@pytest.fixture(scope="module")
def rehearsal(tmp_path_factory, request):
    """Update all packages in workspaces, one for each ROS; at the end, print the table."""
    workspaces = tmp_path_factory.mktemp("rehearsal")
    outcomes = {each: update(workspaces, *each) for each in packages()}
    yield workspaces, outcomes
    Path(LIST).with_name("rehearsal.json").write_text(
        json.dumps([asdict(outcome) for outcome in outcomes.values()], indent=2) + "\n"
    )
    rows = [("package", "made by", "update", "build and tests")]
    rows += [outcome.row() for outcome in outcomes.values()]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    terminal = request.config.pluginmanager.get_plugin("terminalreporter")
    terminal.ensure_newline()
    for row in rows:
        terminal.write_line("  ".join(map(str.ljust, row, widths)).rstrip())


@pytest.mark.skipif(not LIST, reason="PACKAGES names no list of packages")
@pytest.mark.parametrize("package", packages() or [()], ids=" ".join)
def test_update_to_the_candidate(rehearsal, package):
    workspaces, outcomes = rehearsal
    outcome = outcomes[package]
    if outcome.update != "refused":
        outcome.build = build(workspaces / f"ros{outcome.ros}", outcome)
    assert outcome.is_good(), "\n".join([*outcome.row(), *outcome.conflicts, *outcome.findings])


def update(workspaces, address, folder):
    """Clone a package and update it to the candidate."""
    clone = workspaces / "clones" / str(len(list(workspaces.glob("clones/*"))))
    run(["git", "clone", "--quiet", address, clone], workspaces)
    answers = clone / folder / ".copier-answers.yml"
    recorded = yaml.safe_load(answers.read_text())
    name, ros = recorded["spec"]["name"], recorded["spec"]["ros"]
    place = workspaces / f"ros{ros}/src" / name
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copytree(clone / folder, place, symlinks=True)
    lines = [line for line in answers.read_text().splitlines() if line[:9] != "_src_path"]
    lines.append(f"_src_path: {json.dumps(str(ROOT))}")
    if not (ROOT / "dictionary.yaml").exists():  # a collection, which asks for the model
        model = re.sub(r"\.git$", "", recorded["_src_path"].rpartition("/")[2])
        lines += [] if "model" in recorded else [f"model: {model}"]
    (place / answers.name).write_text("\n".join([*lines, ""]))
    shutil.rmtree(place / ".git", ignore_errors=True)
    git(place, "init", "--quiet")
    git(place, "add", "--all")
    git(place, "commit", "--quiet", "--message", "Before")
    command = [sys.executable, "-m", "copier", "update", "--trust", "--defaults"]
    result = run([*command, "--vcs-ref=HEAD"], place, check=False)
    outcome = Outcome(name, ros, str(recorded["_commit"]))
    outcome.conflicts = re.findall(r"^CONFLICT +(.+)$", result.stdout, re.MULTILINE)
    outcome.findings = re.findall(FINDINGS, result.stdout, re.MULTILINE)
    if result.returncode:
        outcome.update = "refused"
        outcome.findings = result.stdout.strip().splitlines()[-1:]
    elif outcome.conflicts:
        outcome.update = f"conflicts: {', '.join(outcome.conflicts)}"
    else:
        outcome.update = f"findings: {len(outcome.findings)}" if outcome.findings else "clean"
    return outcome


def build(workspace, outcome):
    """Build and test a package, and say how that went."""
    if os.environ.get("ROS_VERSION") != str(outcome.ros):
        return NO_ROS.format(ros=outcome.ros)
    place = workspace / "src" / outcome.package
    if not (after := fault(workspace, outcome)):
        return "passes"
    git(place, "stash", "push", "--quiet", "--include-untracked")
    before = fault(workspace, outcome)
    git(place, "stash", "pop", "--quiet")
    return NO_NEWS if after == before else after


def fault(workspace, outcome):
    for commands, words in ((BUILD, "does not build"), (TEST, "tests fail")):
        setup = "for each in devel install; do test ! -e $each/setup.sh || . $each/setup.sh; done"
        command = commands[outcome.ros].format(name=outcome.package)
        if run(["sh", "-c", f"{setup}; {command}"], workspace, check=False).returncode:
            return words
    return ""


def git(place, *arguments):
    person = ("-c", "user.name=Rehearsal", "-c", "user.email=rehearsal@example.org")
    run(["git", *person, *arguments], place)


def run(command, folder, check=True):
    result = subprocess.run(
        command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    assert not check or result.returncode == 0, f"{shlex.join(map(str, command))}: {result.stdout}"
    return result
