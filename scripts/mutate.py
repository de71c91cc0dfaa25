"""Put faults into the code of the hooks, one at a time; see whether the fast tests notice.

    python scripts/mutate.py                           # 120 faults, chosen by the seed 1
    python scripts/mutate.py --seed 7 --count 40 --modules hooks/merge

The fast tests first run once, to learn which of them run which line; build/mutate keeps that until
code or a test changes. A fault is then put into a copy of the collection, where the tests of its
line run, quickest first (decision 115). Faults that change nothing that anyone can see are in
`equivalent.yaml` beside this file, with the reason, and do not count. What only slower tests run
counts as unnoticed. Fails where more than 5 % of the faults survive.
"""

from __future__ import annotations

import argparse
import ast
import random
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import chain, islice, takewhile
from pathlib import Path
from queue import Queue

import yaml

ROOT = Path(__file__).parents[1]
RECORD = ROOT / "build/mutate"
MODULES = ("hooks", "extensions")
FOLDERS = ("tests/hook", "tests/updates", "tests/models/test_qos.py")
LONGEST = """
  branches lab mechanism moves runtime update work_done_once
""".split()
FAST = (*FOLDERS, *(f"--ignore=tests/updates/test_{name}.py" for name in LONGEST))
PYTEST = (sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider")
NEEDLESS = "not ros1 and not ros2 and not network"
SLOW = 4.0  # s, the longest that a fast test takes
ENOUGH = 90.0  # s, of tests for one fault
LIMIT = 400.0  # s, for them to run on a busy machine; a fault that makes them endless is noticed
SURVIVORS = 0.05
COVERAGE = "[run]\ninclude =\n  */hooks/*.py\n  */hooks/merge/*.py\n  */extensions/*.py\n"
"""Copier runs the hooks of copies of the collection: lines of those count as lines of this one."""
OTHERS: dict[type[ast.AST], type[ast.AST]] = {
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.And: ast.Or,
    ast.Or: ast.And,
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Break: ast.Continue,
    ast.Continue: ast.Break,
}
METHODS = {"any": "all", "min": "max", "startswith": "endswith", "lstrip": "rstrip"}
METHODS |= {new: old for old, new in METHODS.items()}


@dataclass(frozen=True)
class Mutant:
    """A fault: at a place of a file, one text in place of another."""

    file: str
    start: int
    old: str
    new: str
    lines: Sequence[int]
    """Those of the innermost statement; of a constant those that use it, as every test runs it."""

    def __str__(self) -> str:
        """Show it in a line."""
        old, new = (" ".join(text.split()) for text in (self.old, self.new))
        return f"{self.file}: {old} -> {new}"

    @property
    def line(self) -> int:
        """The line where it begins."""
        return (ROOT / self.file).read_bytes()[: self.start].count(b"\n") + 1

    @property
    def text(self) -> bytes:
        """The file with the fault."""
        source = (ROOT / self.file).read_bytes()
        rest = source[self.start + len(self.old.encode()) :]
        return source[: self.start] + self.new.encode() + rest

    @property
    def is_python(self) -> bool:
        """Whether that is still Python."""
        try:
            ast.parse(self.text)
        except SyntaxError:
            return False
        return True

    def apply(self, folder: Path) -> None:
        """Put the fault into a copy of the collection."""
        (folder / self.file).write_bytes(self.text)

    def remove(self, folder: Path) -> None:
        """Take it back."""
        shutil.copy2(ROOT / self.file, folder / self.file)


def mutants(file: str) -> Iterator[Mutant]:
    """Yield all faults for a file; a few of them are no Python."""
    source = (ROOT / file).read_bytes()
    lines = source.splitlines(keepends=True)
    starts = [sum(map(len, lines[:number])) for number in range(len(lines))]
    tree = ast.parse(source)
    uses: dict[str, list[int]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
            uses.setdefault(node.id, []).append(node.lineno)
    for statement in reversed(tree.body):  # what uses a constant uses those that it is made of
        for name in constants(statement):
            for node in ast.walk(statement):
                if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                    uses[node.id].extend(uses.get(name, ()))
    for node, lines_run in places(tree, (), uses):
        start = starts[node.lineno - 1] + node.col_offset
        old = source[
            start : starts[(node.end_lineno or 0) - 1] + (node.end_col_offset or 0)
        ].decode()
        for new in faults(node):
            if new != old:
                yield Mutant(file, start, old, new, lines_run)


def places(
    node: ast.AST, run: Sequence[int], uses: Mapping[str, Sequence[int]]
) -> Iterator[tuple[ast.stmt | ast.expr, Sequence[int]]]:
    """Yield the statements and expressions of a function or module that do something.

    Each with the lines whose tests may notice a fault of it; `uses`: the lines that use a name.
    """
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "type_params", "bases"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if not isinstance(child, ast.AST) or is_passive(child):
                continue
            inner = run
            if isinstance(node, ast.Module) and constants(child):
                inner = tuple(line for name in constants(child) for line in uses.get(name, ()))
            elif isinstance(child, ast.stmt) and (run or isinstance(node, ast.FunctionDef)):
                inner = range(child.lineno, (child.end_lineno or 0) + 1)
                if hasattr(child, "body"):
                    inner = range(child.lineno, child.body[0].lineno)
            if isinstance(child, ast.stmt | ast.expr):
                yield child, inner
            yield from places(child, inner, uses)


def constants(node: ast.AST) -> list[str]:
    """Return the names to which a statement gives a value."""
    if not isinstance(node, ast.Assign | ast.AnnAssign | ast.AugAssign):
        return []
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    return [target.id for target in targets if isinstance(target, ast.Name)]


def is_passive(node: ast.AST) -> bool:
    """Tell whether a node only documents, imports or serves the checker of types."""
    if isinstance(node, ast.Expr):
        return isinstance(node.value, ast.Constant)
    if isinstance(node, ast.If):
        return "TYPE_CHECKING" in ast.unparse(node.test)
    if isinstance(node, ast.Assign):
        return ast.unparse(node.targets[0]) == "__all__"
    if isinstance(node, ast.keyword):
        return node.arg == "strict"  # of `zip`: what must be so, as in an assertion
    # Before Python 3.12 what stands in an f-string has no place.
    return isinstance(node, ast.Import | ast.ImportFrom | ast.JoinedStr | ast.Assert)


def faults(node: ast.stmt | ast.expr) -> Iterator[str]:
    """Yield what may stand in place of a statement or an expression."""
    for changed in chain(changes(node), shorter(node)):
        text = ast.unparse(ast.fix_missing_locations(changed))
        yield f"({text})" if isinstance(node, ast.expr) else text


def changes(node: ast.stmt | ast.expr) -> Iterator[ast.AST]:
    """Yield the node with an operator, a constant, a condition or a result changed."""
    match node:
        case ast.Compare(left, [operator, *rest], right) if type(operator) in OTHERS:
            yield ast.Compare(left, [OTHERS[type(operator)](), *rest], right)  # type: ignore[list-item]
        case ast.BoolOp(operator, values):
            yield ast.BoolOp(OTHERS[type(operator)](), values)  # type: ignore[arg-type]
        case ast.BinOp(left, ast.Add() | ast.Sub() as operator, right):
            yield ast.BinOp(left, OTHERS[type(operator)](), right)  # type: ignore[arg-type]
        case ast.UnaryOp(ast.Not(), operand):
            yield operand
        case ast.IfExp(test, body, other):
            yield ast.IfExp(ast.UnaryOp(ast.Not(), test), body, other)
        case ast.If(test, body, other):
            yield ast.If(ast.UnaryOp(ast.Not(), test), body, other)
        case ast.Constant(bool() as value):
            yield ast.Constant(not value)
        case ast.Constant(int() as value):
            yield ast.Constant(value + 1)
        case ast.Constant(str() as value) if value:
            yield ast.Constant("")
        case ast.Return(value) if value and ast.unparse(value) != "None":
            yield ast.Return(ast.Constant(None))
        case ast.Break() | ast.Continue():
            yield OTHERS[type(node)]()
        case ast.Expr() | ast.Raise() | ast.AugAssign() | ast.Delete():
            yield ast.Pass()
        case ast.Assign([ast.Attribute() | ast.Subscript()]):
            yield ast.Pass()
        case ast.Call(ast.Name(name), arguments, keywords) if name in METHODS:
            yield ast.Call(ast.Name(METHODS[name]), arguments, keywords)
        case ast.Call(ast.Attribute(owner, name), arguments, keywords) if name in METHODS:
            yield ast.Call(ast.Attribute(owner, METHODS[name]), arguments, keywords)
        case ast.Call(ast.Name("sorted" | "reversed"), [argument, *_]):
            yield argument


def shorter(node: ast.stmt | ast.expr) -> Iterator[ast.AST]:
    """Yield the node without one of its parts."""
    match node:
        case ast.BoolOp(operator, values):
            for number in range(len(values)):
                rest = values[:number] + values[number + 1 :]
                yield ast.BoolOp(operator, rest) if len(rest) > 1 else rest[0]
        case ast.List(values) | ast.Set(values) if len(values) > 1:
            yield type(node)(values[:-1])
        case ast.Dict(keys, values) if len(values) > 1:
            yield ast.Dict(keys[:-1], values[:-1])
        case ast.ListComp(element, [*others, last]) | ast.SetComp(element, [*others, last]) if (
            last.ifs
        ):
            yield type(node)(element, [*others, ast.comprehension(last.target, last.iter, [], 0)])
        case ast.GeneratorExp(element, [*others, last]) if last.ifs:
            plain = ast.comprehension(last.target, last.iter, [], 0)
            yield ast.GeneratorExp(element, [*others, plain])
        case ast.Call(function, arguments, [*keywords, last]) if not is_passive(last):
            yield ast.Call(function, arguments, keywords)


class Tests:
    """The fast tests: how long each takes, and which lines each runs."""

    def __init__(self, folder: Path) -> None:
        """Read what they did, after they have run in a copy of the collection if need be."""
        from coverage import CoverageData

        report, recorded = RECORD / "report.xml", RECORD / "coverage"
        newest = max((ROOT / file).stat().st_mtime for file in python_files(*MODULES, "tests"))
        if not recorded.exists() or recorded.stat().st_mtime < newest:
            self.record(folder)
        self.seconds: dict[str, float] = {}
        for case in ElementTree.parse(report).iter("testcase"):
            name = f"{case.get('classname', '').replace('.', '/')}.py::{case.get('name')}"
            self.seconds[name] = float(case.get("time", 0))
        self.runs: dict[str, dict[int, set[str]]] = {}
        data = CoverageData(str(recorded))
        data.read()
        for name in data.measured_files():
            folder_name = next(part for part in reversed(Path(name).parts) if part in MODULES)
            file = self.runs.setdefault(folder_name + name.rpartition(folder_name)[2], {})
            for line, contexts in data.contexts_by_lineno(name).items():
                tests = {context.split("|")[0] for context in contexts if context}
                file.setdefault(line, set()).update(tests)

    def record(self, folder: Path) -> None:
        """Run them."""
        settings = folder / "coverage.ini"
        settings.write_text(COVERAGE)
        RECORD.mkdir(parents=True, exist_ok=True)
        options = ["--numprocesses=2", "--cov", "--cov-context=test", f"--cov-config={settings}"]
        options += ["--cov-report=", f"--junitxml={RECORD}/report.xml", "-m", NEEDLESS]
        if subprocess.run([*PYTEST, *options, *FAST], cwd=folder).returncode:
            raise SystemExit("The fast tests fail without a fault.")
        shutil.copy(folder / ".coverage", RECORD / "coverage")

    def of(self, mutant: Mutant) -> list[str]:
        """Return those that run a line, then those that run its file, as many as time allows."""
        lines = self.runs.get(mutant.file, {})
        near = set().union(*(lines.get(line, set()) for line in mutant.lines))
        far = set().union(*lines.values()) - near
        spent = 0.0

        def has_time(name: str) -> bool:
            nonlocal spent
            spent += self.seconds[name]
            return spent < ENOUGH

        fast = [
            name
            for names in (near, far)
            for name in sorted(names, key=lambda name: (self.seconds.get(name, SLOW), name))
            if self.seconds.get(name, SLOW) < SLOW
        ]
        return list(takewhile(has_time, fast))


def main() -> int:
    """Try the faults and print those that survive; return 1 if too many do."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=120)
    parser.add_argument("--modules", nargs="+", default=MODULES)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    every = [mutant for file in python_files(*options.modules) for mutant in mutants(file)]
    random.Random(options.seed).shuffle(every)
    chosen = [*islice((mutant for mutant in every if mutant.is_python), options.count)]
    equivalent = yaml.safe_load(Path(__file__).with_name("equivalent.yaml").read_text()) or {}
    tried = [mutant for mutant in chosen if str(mutant) not in equivalent]
    print(f"{len(tried)} of {len(every)} faults; {len(chosen) - len(tried)} change nothing")
    with tempfile.TemporaryDirectory() as name:
        survivors = attempt(tried, Path(name), options.jobs)
    share = len(survivors) / max(1, len(tried))
    print(f"{len(survivors)} of {len(tried)} faults survive: {share:.1%}")
    return int(share > SURVIVORS)


def python_files(*folders: str) -> list[str]:
    """Return the Python files in folders of the collection."""
    files = [file for folder in folders for file in (ROOT / folder).rglob("*.py")]
    return sorted(str(file.relative_to(ROOT)) for file in files)


def attempt(tried: list[Mutant], folder: Path, jobs: int) -> list[Mutant]:
    """Try each fault in one of several copies of the collection; return those that survive."""
    copies: Queue[Path] = Queue()
    for number in range(jobs):
        copies.put(copy_collection(folder / str(number)))
    tests = Tests(copy_collection(folder / "whole"))

    def survives(mutant: Mutant) -> bool:
        names = tests.of(mutant)
        copy = copies.get()
        mutant.apply(copy)
        try:
            return not names or passes(names, copy)
        finally:
            mutant.remove(copy)
            copies.put(copy)

    survivors = []
    with ThreadPoolExecutor(jobs) as pool:
        for mutant, lives in zip(tried, pool.map(survives, tried), strict=True):
            if lives:
                survivors.append(mutant)
                print(f"survives  {mutant}  (line {mutant.line})", flush=True)
    return survivors


def passes(tests: list[str], folder: Path) -> bool:
    """Tell whether tests pass in time."""
    command = [*PYTEST, "-x", *tests]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def copy_collection(target: Path) -> Path:
    """Copy what git knows of the collection, into a repository, as the tests need it."""
    names = git(ROOT, "ls-files", "-co", "--exclude-standard", "-z").split("\0")
    for name in filter(None, names):
        if (ROOT / name).exists():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, target / name, follow_symlinks=False)
    git(target, "init", "--quiet")
    git(target, "add", "--all")
    return target


def git(folder: Path, *arguments: str) -> str:
    """Run git and return what it prints."""
    command = ["git", *arguments]
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout


if __name__ == "__main__":
    sys.exit(main())
