"""The macros of C++ that names cannot be: each changes what is made of the name, and no other."""

import importlib.util
import os
import re
import subprocess

import pytest

from hooks.data import load_data
from support import ros
from support.repository import ROOT

LOADED = importlib.util.spec_from_file_location("macros", ROOT / "scripts/macros.py")
macros = importlib.util.module_from_spec(LOADED)
LOADED.loader.exec_module(macros)
LISTED = {meaning: text.split() for meaning, text in load_data("macros.yaml").items()}
# Names that definitions of ROS have, or that look like those of headers.
FREE = """
    PRISM PRIMARY_STATE_ACTIVE CHAR_CONST PRIORITY_LOW PRIVATE SYS_OK M_PER_S INT_OVERFLOW DEBUG
    ERROR OK SUCCESS PI MIN MAX TRUE FALSE INFO WARN FATAL UNKNOWN CLOCK_SKEW SIG_LOST SCN_DONE
""".split()


@pytest.fixture(scope="module", autouse=True)
def _headers():
    """Skip without the headers of both ROS."""
    if not ros.ros1() or not ros.ros2() or not ros.has_package(ros.ros2(), "rclcpp"):
        pytest.skip("roscpp or rclcpp is not installed")
    assert "AMENT_PREFIX_PATH" in os.environ


def test_the_list_is_that_of_this_compiler():
    version = subprocess.run(["g++", "--version"], capture_output=True, text=True, check=True)
    head = (ROOT / "hooks/macros.yaml").read_text().split("\na macro")[0]
    if version.stdout.splitlines()[0] not in head:
        pytest.skip("the list was made with another compiler")
    assert {key: set(words) for key, words in LISTED.items()} == macros.table()


@pytest.mark.parametrize("generation", [1, 2])
def test_each_breaks_a_constant_and_no_other_name_does(generation):
    """A constant of each name is declared before the headers of ROS, and used after them."""
    names = LISTED["a macro of C++"] + LISTED[f"a macro of C++ in ROS {generation}"]
    others = LISTED[f"a macro of C++ in ROS {3 - generation}"] + FREE
    others += LISTED["a function-like macro of C++"]
    lines = {f"M{n}::{name}": name for n, name in enumerate([*names, *others])}
    declared = "".join(f"struct {use.replace('::', ' { enum { ')} = 1 }}; }};\n" for use in lines)
    used = "".join(f"int u{n} = {use};\n" for n, use in enumerate(lines))
    command = [word for word in macros.compiler(generation) if word != "-E"]
    result = subprocess.run(
        [*command, "-fsyntax-only", "-fmax-errors=0", "-ftrack-macro-expansion=0"],
        input=f'{declared}{macros.headers(generation)}#line 1 "used"\n{used}',
        capture_output=True,
        text=True,
    )
    found = re.findall(r"^used:(\d+):.* error", result.stderr, re.MULTILINE)
    broken = {name for n, name in enumerate(lines.values()) if str(n + 1) in found}
    broken |= set(re.findall(r" error: .*\n.* #define (\w+)", result.stderr))
    assert broken == set(names)
