"""Show the main job: a package made from a spec, run and talked to, then updated with its logic.

`make demo` runs it. All it makes stands in build/demo; nothing of it is left running.
"""

from __future__ import annotations

import contextlib
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from support.ros import Ros, master, ros1, ros2

HERE = Path(__file__).parent
ROOT = HERE.parent
WORKSPACE = ROOT / "build/demo"
PACKAGE = WORKSPACE / "src/spiral"
COLLECTION = f"git+{ROOT.as_uri()}"  # of a folder, Copier 9 takes uncommitted changes, too
LOGIC = "spiral/driver_impl.py"
BATTERY = (
    '    <subscriber name="battery" type="std_msgs::Float64" description="Charge, 0 to 1"/>\n'
)
COPIER = f"{shlex.quote(sys.executable)} -m copier"
NOISE = "template version\\|No git tags\\|^Rendering\\|^$"
"""What Copier says of a template that is not released, and progress of a slow machine."""


def main() -> None:
    """Tell the story, with as much of it in ROS as there is."""
    ros = None if "--without-ros" in sys.argv else ros2() or ros1()
    shutil.rmtree(WORKSPACE, ignore_errors=True)
    PACKAGE.parent.mkdir(parents=True)
    shutil.copy(HERE / "spiral.ros_package", WORKSPACE)

    tell("A node and its interface, in XML")
    show("cat spiral.ros_package")
    tell("Copier makes the package")
    make_package(ros)
    show("cd src/spiral && git ls-files", "git ls-files", cwd=PACKAGE)
    tell("The developer writes the logic, in one file")
    run("git", "apply", HERE / "logic.patch", cwd=PACKAGE)
    show(f"git diff {LOGIC}", f"git diff -U0 {LOGIC} | grep '^[+] '", cwd=PACKAGE)
    commit("Drive the spiral")
    if ros:
        run_and_talk(ros)
    else:
        tell("No ROS is found on this machine, so the node is not run")
    tell("The robot gets a battery: a line in the spec, and an update")
    spec = PACKAGE / "spiral.ros_package"
    spec.write_text(spec.read_text().replace("    <service", BATTERY + "    <service"))
    show("git diff", "git diff -U0 | grep '^[+] '", cwd=PACKAGE)
    commit("Add the battery")
    update = "update --trust --defaults"
    show(f"copier {update}", f"{COPIER} {update} 2>&1 | grep -v '{NOISE}'", cwd=PACKAGE)
    tell("The logic is as it was written, and data.in_battery is there for it")
    show("git diff HEAD --stat", cwd=PACKAGE)
    print(f"\nThe package is in {PACKAGE.relative_to(ROOT)}; its README.md has a diagram.")


def make_package(ros: Ros | None) -> None:
    """Make the package from the collection as it is committed, as the published model would."""
    data = ["model=python_model", "spec_file=spiral.ros_package"]
    data += [f"ros_distro={ros.distro}"] if ros else []
    given = " ".join(f"-d {item}" for item in data)
    options = f"--trust --defaults --quiet --vcs-ref=HEAD {given}"
    show(
        "copier copy --trust -d spec_file=spiral.ros_package gh:org/python_model src/spiral",
        f"{COPIER} copy {options} {shlex.quote(COLLECTION)} src/spiral",
    )
    run("git", "init", "--quiet", cwd=PACKAGE)
    commit("Make the package")


def run_and_talk(ros: Ros) -> None:
    """Build the package, start its node, and let another node talk to it."""
    peer = f"ros{ros.environment['ROS_VERSION']}"
    tell(f"Built and run in ROS {peer[-1]} ({ros.distro})")
    if peer == "ros1":
        shutil.copytree(ROOT / "tests/data/test_msgs", WORKSPACE / "src/test_msgs")
    print(f"$ {ros.build_command}", flush=True)
    ros.build(WORKSPACE)
    place = "devel" if peer == "ros1" else "install/spiral"
    print("$ rosrun spiral driver &" if peer == "ros1" else "$ ros2 run spiral driver &")
    print("$ python3 demo/talk.py", flush=True)
    with contextlib.ExitStack() as stack:
        if peer == "ros1":
            stack.enter_context(master(ros))
        stack.enter_context(ros.running(f"{place}/lib/spiral/driver", WORKSPACE, WORKSPACE))
        print(ros.run(f"{ros.python} {HERE}/talk.py {peer}", WORKSPACE, WORKSPACE).stdout, end="")


def tell(text: str) -> None:
    """Print a headline, bold on a terminal."""
    bold, plain = ("\033[1m", "\033[0m") if sys.stdout.isatty() else ("", "")
    print(f"\n{bold}# {text}{plain}", flush=True)


def show(shown: str, command: str = "", cwd: Path = WORKSPACE) -> None:
    """Print a command as a user types it, and run it, or another that does the same here."""
    print(f"$ {shown}", flush=True)
    run("bash", "-o", "pipefail", "-c", command or shown, cwd=cwd)


def run(*command: str | Path, cwd: Path) -> None:
    """Run a command with an identity for git, whatever the machine has."""
    person = {
        f"GIT_{who}_{what}": value
        for who in ("AUTHOR", "COMMITTER")
        for what, value in (("NAME", "Ada Lovelace"), ("EMAIL", "ada@example.org"))
    }
    environment = os.environ | person | {"GIT_PAGER": "cat"}
    subprocess.run(command, cwd=cwd, env=environment, check=True, stdin=subprocess.DEVNULL)


def commit(message: str) -> None:
    """Commit all of the package."""
    run("git", "add", "--all", cwd=PACKAGE)
    run("git", "commit", "--quiet", "-m", message, cwd=PACKAGE)


if __name__ == "__main__":
    main()
