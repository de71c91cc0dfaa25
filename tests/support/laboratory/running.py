"""Whether a merged package still runs: its unit tests, what each callback does, the compiler.

Python runs without ROS: what the package imports from elsewhere is a mock. C++ is compiled with
the headers of ROS 1, but for nodes with dynamic parameters, whose header a build would make.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from hooks.merge.tree import write

_RUN = '''
import importlib.abc, importlib.util, json, pathlib, pkgutil, sys, unittest
from unittest.mock import MagicMock

class Elsewhere(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Makes a mock of every module that is not the package's."""
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] != "lab":
            return importlib.util.spec_from_loader(name, self, is_package=True)
    def create_module(self, spec):
        return MagicMock(name=spec.name, __path__=[], __spec__=spec)
    def exec_module(self, module):
        pass

sys.meta_path.append(Elsewhere())
sys.path[:0] = [".", "test"]
for file in sorted(pathlib.Path("test").glob("test_*_impl.py")):
    tests = unittest.defaultTestLoader.loadTestsFromName(file.stem)
    found = unittest.TestResult()
    tests.run(found)
    assert found.testsRun and found.wasSuccessful(), found.errors + found.failures
did = {}
for file in sorted(pathlib.Path("lab").glob("*_impl.py")):
    module = importlib.import_module(f"lab.{file.stem}")
    for name, logic in vars(module).items():
        if name.endswith("Impl"):
            for method, code in vars(logic).items():
                if callable(code):
                    self = MagicMock()
                    count = code.__code__.co_argcount - 1
                    code(self, *(MagicMock() for _ in range(count)))
                    calls = self.passthrough.log.info.call_args_list
                    did[f"lab/{file.name} {method}"] = [call.args[0] for call in calls]
print(json.dumps(did))
'''


def runs(mine, result, edited, pair, names):
    """Complain of a Python package whose unit tests fail, or whose callbacks do something else."""
    if edited.moved or any(path.startswith("test/") for path in edited.deleted_files()):
        return []  # the developer has broken it
    (before, wrong), (after, fault) = did(mine), did(result)
    if wrong or fault:
        return [f"the edited package does not run: {wrong}" if wrong else f"broken: {fault}"]
    complaints = []
    for place, marks in before.items():
        path, method = place.split()
        target = pair.renaming.path(path)
        place = f"{target} {names.get(path, {}).get(method, method)}"
        if marks and place in after and after[place] != marks:
            complaints.append(f"{place} did {marks} and does {after[place]}")
    return complaints


def did(tree):
    """Return what each method of the logic logs, and what went wrong."""
    with tempfile.TemporaryDirectory() as folder:
        put(Path(folder), tree)
        command = [sys.executable, "-m", "compileall", "-q", "lab"]
        found = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if not found.returncode:
            command = [sys.executable, "-B", "-c", _RUN]
            found = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if found.returncode:
            return {}, found.stdout[-300:] + found.stderr[-1500:]
        return json.loads(found.stdout), ""


def put(folder, tree):
    for path, file in tree.items():
        write(folder / path, file)


MACROS = ("LAB_API", "LAB_EXPORT(x)", "LAB_HOT", "LAB_TRACE(x)")
"""What the edits put before functions and classes."""
_STUB = """#pragma once
#include "actionlib/TwoIntsAction.h"
namespace {package}
{{
using {name}Action = actionlib::TwoIntsAction;
using {name}Goal = actionlib::TwoIntsGoal;
using {name}Feedback = actionlib::TwoIntsFeedback;
using {name}Result = actionlib::TwoIntsResult;
}}
"""
"""An action's header, of packages that Debian does not have."""


def compiles(mine, result, edited, pair, names, sources="src/.*_impl"):
    """Complain of a C++ package for ROS 1 that the compiler does not take any more."""
    if "find_package(catkin" not in pair.new.get("CMakeLists.txt", ""):
        return []
    if any(path.endswith((".cpp", ".hpp")) for path in (*edited.moved, *edited.deleted_files())):
        return []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        put(folder, result)
        for package, action in (("test_msgs", "Fibonacci"), ("other_msgs", "Move")):
            (folder / "stubs" / package).mkdir(parents=True)
            header = folder / "stubs" / package / f"{action}Action.h"
            header.write_text(_STUB.format(package=package, name=action))
        command = "g++ -std=c++17 -fsyntax-only -Iinclude -Istubs -Isrc".split()
        command += [f"-D{macro}=" for macro in (*MACROS, "LAB_MINE")]
        complaints = []
        for path in sorted(path for path in result if re.fullmatch(rf"{sources}\.cpp", path)):
            if not re.search(r"lab/\w+Config\.h", result[path].text):
                found = subprocess.run(
                    [*command, path], cwd=folder, capture_output=True, text=True
                )
                if found.returncode:
                    complaints.append(f"{path} does not compile: {found.stderr[:1500]}")
        return complaints
