"""Compare making a package with copying its files by Copier alone, and an update with a copy."""

from __future__ import annotations

import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import copier

ROOT = Path(__file__).parents[1]
ROUNDS = 9


def main() -> None:
    """Print the medians of interleaved rounds, and their ratio to the baseline."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        package, plain = folder / "package", folder / "plain"
        make(package)
        commit(package)
        plain.mkdir()
        subprocess.run(["cp", "-r", package, plain / "template"], check=True)
        (plain / "template/.git").rename(folder / "git")
        (plain / "template/{{ _copier_conf.answers_file }}.jinja").write_text("# {{ spec }}\n")
        (plain / "copier.yml").write_text(
            "_subdirectory: template\nspec: {type: str, default: x}\n"
        )
        times = interleaved(
            {
                "Copier alone, the same files": lambda i: copy(plain, folder / f"plain{i}"),
                "copy from the spec": lambda i: make(folder / f"made{i}"),
                "update, nothing to do": lambda i: copier.run_update(
                    package, defaults=True, unsafe=True, quiet=True, overwrite=True
                ),
            }
        )
    base = times["Copier alone, the same files"]
    for what, median in times.items():
        print(f"{what:32}{median * 1e3:8.0f} ms  x {median / base:.1f}")


def interleaved(jobs: dict[str, Callable[[int], object]]) -> dict[str, float]:
    """Run the jobs in turn, so that a busy machine slows all alike; return medians in seconds."""
    times: dict[str, list[float]] = {what: [] for what in jobs}
    for turn in range(ROUNDS):
        for what, job in jobs.items():
            start = time.perf_counter()
            job(turn)
            times[what].append(time.perf_counter() - start)
    return {what: statistics.median(taken) for what, taken in times.items()}


def make(package: Path) -> None:
    """Make the package of the paper's example."""
    spec = ROOT / "examples/contact_analysis.ros_package"
    copy(ROOT, package, model="python_model", spec_file=str(spec), ros_distro="kilted")


def copy(template: Path, target: Path, **data: str) -> None:
    """Copy a template as it stands in the work tree or its last commit."""
    copier.run_copy(
        str(template),
        target,
        data=dict(data),
        vcs_ref="HEAD" if (template / ".git").exists() else None,
        defaults=True,
        unsafe=True,
        quiet=True,
    )


def commit(folder: Path) -> None:
    """Make a folder a git repository with one commit, as an update needs it."""
    identity = ["-c", "user.name=Bench", "-c", "user.email=bench@example.org"]
    for arguments in (["init", "-q"], ["add", "-A"], [*identity, "commit", "-q", "-m", "Made"]):
        subprocess.run(["git", *arguments], cwd=folder, check=True)


if __name__ == "__main__":
    main()
