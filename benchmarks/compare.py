"""Compare generated nodes with nodes that do the same, written by hand as tutorials of ROS do.

    python benchmarks/compare.py              # prints the table
    python benchmarks/compare.py --write      # writes it and its picture into docs/

Both sides run in turn, in an order that changes, so that a busy machine slows them alike; the
table has medians. What a node records is the same text on both sides.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import copier

from support import ros as installed
from support.ros import Ros

ROOT = Path(__file__).parents[1]
SOURCES = Path(__file__).parent / "nodes"
SPEC = SOURCES / "bench.ros_package"
SIDES = ("by hand", "generated")
SIZES = {1: 100, 10_000: 50, 100_000: 10}
"""Floats of a message, and how many such messages a second."""
PERIOD = 0.001  # s, of relay
LIMIT = 60  # s, for a node to start or end

MODELS = {"python_model": "Python", "cpp_model": "C++"}
GOAL = 1.1
BEGIN, END = "<!-- `make bench NODES=--write` writes this -->", "<!-- to here -->"
COLOURS = ("#1f77b4", "#2ca02c", "#ff7f0e", "#9467bd")

Values = dict[str, float]
Medians = dict[str, dict[str, tuple[float, ...]]]
Make = Callable[[Path, str, str], None]
"""Makes the package in a folder, of a model, for a ROS."""


@dataclass(frozen=True)
class Effort:
    """How long to measure."""

    rounds: int = 9
    seconds: float = 4.0
    calls: int = 200


def make_package(folder: Path, model: str, distro: str) -> None:
    """Make the package from the collection as it is committed."""
    data = {"model": model, "ros_distro": distro, "spec_file": str(SPEC)}
    options: dict[str, Any] = {"defaults": True, "unsafe": True, "quiet": True}
    copier.run_copy(str(ROOT), folder, data=data, vcs_ref="HEAD", **options)


class Variant:
    """The nodes in a language and a ROS, both sides."""

    def __init__(self, model: str, ros: Ros, workspace: Path, make: Make = make_package) -> None:
        """Build them."""
        self.language, self.name = MODELS[model], name_of(model, ros)
        self.ros, self.workspace = ros, workspace
        package, by_hand = workspace / "src/bench", workspace / "src/by_hand"
        make(package, model, ros.distro)
        folders = {".py": "bench", ".hpp": "include/bench", ".cpp": "src"}
        for source in SOURCES.glob("*_impl.*"):
            if (package / folders[source.suffix]).is_dir():
                shutil.copy(source, package / folders[source.suffix])
        record = "record.py" if self.language == "Python" else "record.hpp"
        shutil.copy(SOURCES / record, package / folders[Path(record).suffix])
        if self.language == "C++":
            shutil.copytree(SOURCES / "by_hand", by_hand)
        if ros.distro == "noetic":
            shutil.copytree(ROOT / "tests/data/test_msgs", workspace / "src/test_msgs")
        options = "-DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF"
        options = options if ros.distro == "noetic" else f"--cmake-args {options}"
        ros.run(f"{ros.build_command} {options}", workspace, timeout=1800)
        command = ros.command("env -0", workspace)
        env = subprocess.run(command, env=ros.environment, check=True, stdout=subprocess.PIPE)
        lines = env.stdout.decode().split("\0")
        self.environment = dict(line.split("=", 1) for line in lines if line)

    def command(self, side: str, node: str) -> list[str]:
        """Return the command that runs a node."""
        version = self.ros.environment["ROS_VERSION"]
        if side == "by hand" and self.language == "Python":
            return [self.ros.python, str(SOURCES / f"by_hand/ros{version}.py"), node]
        package, program = ("by_hand", "by_hand") if side == "by hand" else ("bench", node)
        folder = "devel/lib" if version == "1" else f"install/{package}/lib"
        file = str(self.workspace / folder / package / program)
        return [file, node] if side == "by hand" else [file]

    @contextmanager
    def peer(self) -> Iterator[Callable[..., Any]]:
        """Run the peer; give what tells it to do something, and returns its answer."""
        command = [self.ros.python, str(SOURCES / "peer.py")]
        pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
        with subprocess.Popen(command, env=self.environment, **pipes) as process:
            assert process.stdin
            assert process.stdout
            answers = iter(process.stdout.readline, "")

            def tell(*words: Any) -> Any:
                if words:
                    process.stdin.write(json.dumps(words) + "\n")  # type: ignore[union-attr]
                    process.stdin.flush()  # type: ignore[union-attr]
                return json.loads(next(answers))

            try:
                yield tell
                process.stdin.close()
            finally:
                process.kill()

    def measure(self, side: str, effort: Effort) -> Values:
        """Run both nodes of a side; return what was measured."""
        values: Values = {}
        with self.peer() as tell, Node(self, side, "relay") as node:
            assert tell("first") is None
            started = node.start()
            values["start to first message, ms"] = 1e3 * (tell() - started)
            spans = {}
            for size, rate in SIZES.items():
                with node.span() as spans[size]:
                    tell("send", size, rate, effort.seconds)
            values["memory of the loop, MB"] = node.memory()
            values["threads of the loop"] = node.threads()
            cycles, messages = node.end()
            for size, span in spans.items():
                name = f" with {size:,} floats" if size > 1 else ""
                ran = [time for time in cycles if span.start <= time <= span.end]
                late = sorted(abs(b - a - PERIOD) for a, b in zip(ran, ran[1:], strict=False))
                values[f"rate{name}, Hz"] = (len(ran) - 1) / (ran[-1] - ran[0])
                values[f"p99 jitter{name}, ms"] = 1e3 * late[int(0.99 * len(late))]
                values[f"CPU at 1 kHz{name}, %"] = 100 * span.cpu / (span.end - span.start)
                values[f"to update{name}, ms"] = 1e3 * delay(messages, span)
        with self.peer() as tell, Node(self, side, "server") as node:
            node.start()
            tell("repeat", "call", 1)
            for size, rate in SIZES.items():
                with node.span() as spans[size]:
                    count = tell("send", size, rate, effort.seconds)
                name = f" with {size:,} floats" if size > 1 else ""
                values[f"CPU of a direct message{name}, ms"] = 1e3 * spans[size].cpu / count
            for what, name in (("call", "service call"), ("send_goal", "action round trip")):
                taken = tell("repeat", what, effort.calls)
                values[f"{name}, ms"] = 1e3 * statistics.median(taken)
            values["memory of the server, MB"] = node.memory()
            values["threads of the server"] = node.threads()
            messages = node.end()[1]
            for size, span in spans.items():
                name = f" with {size:,} floats" if size > 1 else ""
                values[f"direct path{name}, ms"] = 1e3 * delay(messages, span)
        return values


class Span:
    """A time in which a node was watched."""

    start = end = cpu = 0.0


def delay(messages: list[float], span: Span) -> float:
    """Return the median time that messages of a span took to the logic."""
    pairs = zip(messages[::2], messages[1::2], strict=True)
    return statistics.median(came - sent for sent, came in pairs if span.start <= sent <= span.end)


class Node:
    """A running node."""

    def __init__(self, variant: Variant, side: str, name: str) -> None:
        """Prepare to run it."""
        self.command = variant.command(side, name)
        self.folder = Path(tempfile.mkdtemp())
        self.environment = variant.environment | {"BENCH_RECORD": str(self.folder / "record")}

    def __enter__(self) -> Node:
        """Do nothing yet."""
        return self

    def __exit__(self, *_: object) -> None:
        """End it anyway."""
        self.process.kill()
        self.process.wait()
        shutil.rmtree(self.folder)

    def start(self) -> float:
        """Start it; return when."""
        start = time.monotonic()
        log = (self.folder / "log").open("w")
        self.process = subprocess.Popen(
            self.command, env=self.environment, stdout=log, stderr=log, stdin=subprocess.DEVNULL
        )
        return start

    @contextmanager
    def span(self) -> Iterator[Span]:
        """Watch it for a while."""
        span = Span()
        before, span.start = self._cpu(), time.monotonic()
        yield span
        span.cpu, span.end = self._cpu() - before, time.monotonic()

    def _cpu(self) -> float:
        """Return the seconds that all its threads have computed, to the nanosecond."""
        total = 0
        for task in Path(f"/proc/{self.process.pid}/task").glob("*/schedstat"):
            with suppress(FileNotFoundError, ProcessLookupError):  # it has just ended
                total += int(task.read_text().split()[0])
        return total * 1e-9

    def memory(self) -> float:
        """Return its resident memory in MB."""
        return self._status("VmRSS") / 1024

    def threads(self) -> int:
        """Return how many threads it has."""
        return self._status("Threads")

    def _status(self, name: str) -> int:
        lines = Path(f"/proc/{self.process.pid}/status").read_text().splitlines()
        return next(int(line.split()[1]) for line in lines if line.startswith(f"{name}:"))

    def end(self) -> tuple[list[float], list[float]]:
        """Interrupt it; return the times that it has recorded: of cycles, and of messages."""
        self.process.send_signal(signal.SIGINT)
        self.process.wait(LIMIT)
        times: dict[str, list[float]] = {"cycle": [], "message": []}
        file = self.folder / "record"
        assert file.exists(), (self.folder / "log").read_text()
        for line in file.read_text().splitlines():
            kind, value = line.split()
            times[kind].append(float(value))
        return times["cycle"], times["message"]


def variants(stack: ExitStack, only: str = "") -> Iterator[Variant]:
    """Build and yield what can run on this machine, of the chosen names."""
    for ros in filter(None, (installed.ros2(), installed.ros1())):
        version = ros.environment["ROS_VERSION"]
        chosen = [each for each in MODELS if only in name_of(each, ros)]
        if version == "2":
            # With shared memory, as for users.
            del ros.environment["FASTDDS_DEFAULT_PROFILES_FILE"]
            ros.environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
            if not installed.has_package(ros, "rclcpp"):
                chosen = [each for each in chosen if each != "cpp_model"]
        if chosen and version == "1":
            stack.enter_context(master(ros))
        for model in chosen:
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            yield Variant(model, ros, folder)


def master(ros: Ros) -> AbstractContextManager[None]:
    """Run a ROS 1 master whose own polling does not count as time of a node."""
    return installed.master(ros, f"{ros.python} {SOURCES}/master.py")


def name_of(model: str, ros: Ros) -> str:
    """Return the name of a variant."""
    return f"{MODELS[model]}, ROS {ros.environment['ROS_VERSION']}"


def compare(built: list[Variant], effort: Effort) -> Medians:
    """Run all in turn; return the medians of each variant: by hand, generated."""
    turns = [(variant, side) for variant in built for side in SIDES]
    runs: dict[tuple[str, str], list[Values]] = {(v.name, side): [] for v, side in turns}
    for turn in range(effort.rounds):
        print(f"  round {turn + 1} of {effort.rounds}", end="\r", file=sys.stderr)
        for variant, side in random.sample(turns, len(turns)):
            runs[variant.name, side].append(variant.measure(side, effort))
    return {
        v.name: {
            what: tuple(statistics.median(run[what] for run in runs[v.name, s]) for s in SIDES)
            for what in runs[v.name, SIDES[0]][0]
        }
        for v in built
    }


def describe(effort: Effort, load: float) -> str:
    """Say in general words where this was measured, and how."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    cores = os.cpu_count() or 1
    state = "shared with other programs" if load > cores / 2 else "idle before"
    if os.sched_getscheduler(0) != os.SCHED_OTHER:
        state += ", which had to wait for the nodes"
    return (
        f"Medians of {effort.rounds} rounds on a virtual machine with {cores} cores and"
        f" {memory:.0f} GB of memory, {state} (load {load:.1f})."
    )


def table(found: Medians) -> str:
    """Return the table in Markdown: of each variant, by hand, generated, and how much of it."""
    lines = [f"| | {' | '.join(found)} |", f"|---|{'---|' * len(found)}"]
    for what in next(iter(found.values())):
        digits = 3 if "rate" in what else 2
        cells = [
            f"{by_hand:.4g} → {generated:.4g}: {generated / by_hand:.{digits}f}"
            for by_hand, generated in (values[what] for values in found.values())
        ]
        lines.append(f"| {what} | {' | '.join(cells)} |")
    return "\n".join(lines)


def picture(found: Medians) -> str:
    """Return a picture of the ratios: a row for each line of the table, a dot for each variant."""
    rows = list(next(iter(found.values())))
    names, step, left, width = list(found), 18, 330, 480
    top, bottom = 44, 44 + 18 * len(rows)

    def x(ratio: float) -> float:
        return left + width * (math.log2(min(4.0, max(0.25, ratio))) + 2) / 4

    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + width + 20} {bottom + 24}"'
        ' font-family="sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="white"/>',
    ]
    for number, (name, colour) in enumerate(zip(names, COLOURS, strict=False)):
        at = left + number * width / len(COLOURS)
        lines.append(f'<circle cx="{at}" cy="16" r="5" fill="{colour}"/>')
        lines.append(f'<text x="{at + 10}" y="20">{name}</text>')
    for ratio in (0.25, 0.5, 1, GOAL, 2, 4):
        shade = "black" if ratio == 1 else "#c00" if ratio == GOAL else "#ccc"
        lines.append(
            f'<line x1="{x(ratio):.1f}" x2="{x(ratio):.1f}" y1="{top - 10}" y2="{bottom}"'
            f' stroke="{shade}"/>'
        )
        if ratio != GOAL:
            lines.append(
                f'<text x="{x(ratio):.1f}" y="{bottom + 16}" text-anchor="middle">{ratio:g}</text>'
            )
    for row, what in enumerate(rows):
        y = top + step * row
        lines.append(f'<text x="{left - 12}" y="{y + 4}" text-anchor="end">{what}</text>')
        for name, colour in zip(names, COLOURS, strict=False):
            by_hand, generated = found[name][what]
            at = f'cx="{x(generated / by_hand):.1f}" cy="{y}"'
            lines.append(f'<circle {at} r="5" fill="{colour}" fill-opacity="0.8"/>')
    return "\n".join([*lines, "</svg>"]) + "\n"


def write(found: Medians, measured: str) -> None:
    """Put the table into the page, and the picture beside it."""
    page = ROOT / "docs/benchmarks.md"
    head, _, rest = page.read_text().partition(BEGIN)
    tail = rest.partition(END)[2]
    page.write_text(f"{head}{BEGIN}\n{measured}\n\n{table(found)}\n{END}{tail}")
    page.with_suffix(".svg").write_text(picture(found))


def main() -> int:
    """Print the table, or write it."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--only", default="", help="a part of the names of variants")
    parser.add_argument("--rounds", type=int, default=Effort.rounds)
    parser.add_argument("--seconds", type=float, default=Effort.seconds)
    parser.add_argument("--write", action="store_true", help="write docs/benchmarks.md")
    options = parser.parse_args()
    effort, load = Effort(options.rounds, options.seconds), os.getloadavg()[0]
    with ExitStack() as stack:
        found = compare(list(variants(stack, options.only)), effort)
    print(f"\n{describe(effort, load)}\n\n{table(found)}")
    if options.write:
        write(found, describe(effort, load))
    return 0


if __name__ == "__main__":
    sys.exit(main())
