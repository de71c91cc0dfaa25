"""Compare copies and updates with bare Copier's, on a static template of the same bytes.

Times are user seconds of whole commands, git's included: medians of rounds in which all commands
take turns, so that a busy machine slows all alike. Fails where a ratio is above its target.
"""

from __future__ import annotations

import itertools
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
ROUNDS = int(os.environ.get("BENCH_ROUNDS", "3"))
MODELS = ("python_model", "cpp_model")
COPIES, UPDATES = (1, 100), (1, 10, 50)  # nodes
COPIER = (sys.executable, "-m", "copier")
QUIET = ("--trust", "--defaults", "--quiet")
NODE = """\
  <node name="{name}"{was} frequency="10">
    <publisher name="power_{i}" type="std_msgs::Float64" description="Power"/>
    <subscriber name="goal_{i}" type="std_msgs::Float64" description="Goal"/>
    <dynParameter name="gain_{i}" type="double" value="1.0" description="Gain"/>
  </node>
"""
MORE = '\n    <subscriber name="speed" type="std_msgs::Float64" description="Speed"/>'


@dataclass(frozen=True)
class Job:
    """A command to time: what it does, from which template, and how long it may take.

    `target` is relative to the job of the template `base`.
    """

    what: str
    template: str
    run: Callable[[], float]
    base: str = ""
    target: float = 0.0


def main() -> int:
    """Print the table; return 1 if a target is missed."""
    missed = 0
    print("model         nodes  command                template     user s   ratio  target")
    for model, nodes in itertools.product(MODELS, sorted({*COPIES, *UPDATES})):
        with tempfile.TemporaryDirectory() as folder:
            missed += compare(
                f"{model:12}  {nodes:5}", Workshop(Path(folder), model, nodes).jobs()
            )
    if missed:
        print(f"{missed} of these ratios are above their targets.")
    return 1 if missed else 0


def compare(packages: str, jobs: list[Job]) -> int:
    """Run the jobs in turn and print their medians; return how many miss their targets."""
    times: dict[tuple[str, str], list[float]] = {(job.what, job.template): [] for job in jobs}
    for turn in range(ROUNDS):
        print(f"{packages} nodes, round {turn + 1} of {ROUNDS}", end="\r", file=sys.stderr)
        for job in jobs:
            times[job.what, job.template].append(job.run())
    medians = {key: statistics.median(taken) for key, taken in times.items()}
    missed = 0
    for job in jobs:
        median = medians[job.what, job.template]
        line = f"{packages}  {job.what:22} {job.template:12} {median:6.2f}"
        if job.base:
            # Bare Copier has nothing to do in any of its updates.
            same = medians.get((job.what, job.base)) or medians["update, nothing", job.base]
            is_over = median / same > job.target
            missed += is_over
            line += f"  {median / same:6.2f}  {job.target:6.1f} of {job.base}"
            line += "  ABOVE" if is_over else ""
        print(line)
    return missed


class Workshop:
    """The templates, and a package of each, for specs of so many nodes."""

    def __init__(self, folder: Path, model: str, nodes: int) -> None:
        """Publish the model and make the packages; `folder` is empty."""
        self.folder, self.model, self.nodes, self.copies = folder, model, nodes, 0
        (folder / "home").mkdir()
        (folder / "gitconfig").write_text(
            "[user]\nname = Bench\nemail = bench@example.org\n"
            f'[url "file://{folder}/host/"]\ninsteadOf = https://github.com/\n'
        )
        self.environment = os.environ | {
            "GIT_CONFIG_GLOBAL": str(folder / "gitconfig"),
            "HOME": str(folder / "home"),
            "XDG_CACHE_HOME": str(folder / "home/cache"),
        }
        collection, self.spec = folder / "collection", folder / "arm.xml"
        self.spec.write_text(self.text())
        self.git(folder, "clone", "--quiet", str(ROOT), str(collection))
        self.git(collection, "tag", "1000.0.0")
        self.git(collection, "repack", "-adq")
        self.sources = {
            "collection": str(collection),
            "published": f"gh:org/{model}",
            "bare": "gh:org/static",
        }
        published, static = (folder / f"host/org/{name}.git" for name in (model, "static"))
        self.git(folder, "init", "--quiet", "--bare", "--initial-branch=main", str(published))
        self.run(sys.executable, "scripts/publish.py", model, str(published), cwd=collection)
        for template in ("published", "collection"):
            self.copy(template, self.package(template))
        self.make_static(folder / "static")
        self.git(folder, "clone", "--quiet", "--bare", str(folder / "static"), str(static))
        self.copy("bare", self.package("bare"))
        for template in self.sources:
            self.commit(self.package(template))

    def jobs(self) -> list[Job]:
        """Return what is compared for this number of nodes."""
        more = self.text().replace('Goal"/>', f'Goal"/>{MORE}', 1)
        renamed = self.text(was=' was="node_0"')
        found: list[Job] = []
        if self.nodes in COPIES:
            limits = {"published": ("bare", 1.2), "collection": ("bare", 1.4), "bare": ("", 0.0)}
            found += [
                Job("copy", name, lambda name=name: self.copy_anew(name), *limits[name])  # type: ignore[misc]
                for name in limits
            ]
        if self.nodes in UPDATES:
            changes = (("nothing", "", 1.5), ("one interface", more, 1.5), ("rename", renamed, 2))
            found.append(Job("update, nothing", "bare", lambda: self.update("bare", "")))
            for what, text, limit in changes:
                for name, base, most in (
                    ("published", "bare", limit),
                    ("collection", "published", 2),
                ):
                    run = lambda name=name, text=text: self.update(name, text)  # noqa: E731
                    found.append(Job(f"update, {what}", name, run, base, most))
        return found

    def text(self, was: str = "") -> str:
        """Return a spec, in which the first node may have had another name."""
        names = ["arm" if was and not i else f"node_{i}" for i in range(self.nodes)]
        nodes = [NODE.format(name=name, was="" if i else was, i=i) for i, name in enumerate(names)]
        about = 'name="arm_nodes" author="Ada" author_email="ada@example.org" description="Arms"'
        rights = 'license="Apache-2.0" copyright="2026 Ada"'
        return f"<package {about} {rights}>\n{''.join(nodes)}</package>\n"

    def package(self, template: str) -> Path:
        """Return the folder of the package that is updated."""
        return self.folder / template / "arm_nodes"

    def make_static(self, template: Path) -> None:
        """Make a template of the bytes of the package."""
        source, target = self.package("published"), template / "template"
        shutil.copytree(source, target, ignore=shutil.ignore_patterns(".copier-answers.yml"))
        answers = target / "{{ _copier_conf.answers_file }}.jinja"
        answers.write_text("{{ _copier_answers | to_nice_yaml }}")
        (template / "copier.yml").write_text("_subdirectory: template\nanswer: {type: str}\n")
        self.commit(template)
        self.git(template, "tag", "1.0.0")

    def copy(self, template: str, target: Path) -> float:
        """Make a package; return user seconds."""
        data = ["-d", f"spec_file={self.spec}", "-d", "ros_distro=kilted"]
        data += ["-d", f"model={self.model}"] if template == "collection" else []
        data = ["-d", "answer=yes"] if template == "bare" else data
        source = self.sources[template]
        return self.run(*COPIER, "copy", *QUIET, *data, source, str(target), cwd=self.folder)

    def copy_anew(self, template: str) -> float:
        """Make a package in a folder that is not there yet."""
        self.copies += 1
        return self.copy(template, self.folder / f"copy_{self.copies}/arm_nodes")

    def update(self, template: str, spec: str) -> float:
        """Update a package to a spec, or as it is, and undo that; return user seconds."""
        package = self.package(template)
        head = self.git(package, "rev-parse", "HEAD")
        if spec:
            (package / "arm_nodes.ros_package").write_text(spec)
            self.commit(package)
        taken = self.run(*COPIER, "update", *QUIET, cwd=package)
        self.git(package, "reset", "--quiet", "--hard", head)
        self.git(package, "clean", "-fdq")
        return taken

    def commit(self, folder: Path) -> None:
        """Commit all of a folder, which becomes a repository if it is none."""
        self.git(folder, "init", "--quiet")
        self.git(folder, "add", "--all")
        self.git(folder, "commit", "--quiet", "--message", "Change")

    def git(self, folder: Path, *arguments: str) -> str:
        """Run git and return what it prints."""
        command = ["git", *arguments]
        result = subprocess.run(
            command, cwd=folder, env=self.environment, check=True, capture_output=True, text=True
        )
        return result.stdout.strip()

    def run(self, *command: str, cwd: Path) -> float:
        """Run a command; return the user seconds of it and of all that it has started."""
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen(
                command, cwd=cwd, env=self.environment, stdout=said, stderr=said
            )
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode:
                said.seek(0)
                raise SystemExit(f"{' '.join(command)}:\n{said.read().decode()}")
        return usage.ru_utime


if __name__ == "__main__":
    sys.exit(main())
