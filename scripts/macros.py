"""Make `hooks/macros.yaml` anew: what the headers define that C++ nodes of each ROS include.

    . /opt/ros/kilted/setup.sh && python scripts/macros.py > hooks/macros.yaml

It asks the compiler, with ROS 1 in /usr or /opt/ros/noetic and ROS 2 in the environment.
Decision 82: patterns refused names that ROS itself has.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import textwrap
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DISTROS = {1: "noetic", 2: "kilted"}
# As CMake compiles by default, with the extensions of GNU.
COMPILER = ("g++", "-std=gnu++17", "-x", "c++", "-E")
# Include guards, and what libraries keep apart by a form of their own.
UNLIKELY = re.compile(
    r"_|.*__|.*_$|BOOST|GTEST|RCUTILS|RCPPUTILS|ROSIDL|SYS_[a-z]|.*_(H|HPP)(_INCLUDED)?$"
    r"|.*_(DEPRECATED|EXPORT|IMPORT|LOCAL|PUBLIC|PUBLIC_TYPE)$|(rcl|rmw)_|[A-Z].*[A-Z].*_[a-z].*"
)

HEAD = """\
# The macros that a name cannot be, as C++ nodes and their tests include the headers that define
# them. Made by scripts/macros.py with {compiler}.
# A function-like macro is one before a parenthesis alone: it harms fields, not constants.
"""


def headers(ros: int) -> str:
    """Return lines that include what the packages shown in examples include, where it is."""
    found: set[str] = set()
    for language in ("cpp", "hpp"):
        for file in ROOT.glob(f"examples/*/cpp_model/{DISTROS[ros]}/**/*.{language}"):
            found |= set(
                re.findall(r"^#include [<\"]([^>\"]*)[>\"]", file.read_text(), re.MULTILINE)
            )
    return "".join(
        f"#if __has_include(<{each}>)\n#include <{each}>\n#endif\n" for each in sorted(found)
    )


def compiler(ros: int) -> list[str]:
    """Return the command that preprocesses C++ with the headers of a ROS."""
    if ros == 1:
        return [*COMPILER, "-I/opt/ros/noetic/include", "-"]
    prefixes = [Path(prefix) for prefix in os.environ["AMENT_PREFIX_PATH"].split(":")]
    folders = [f for prefix in prefixes for f in sorted(prefix.glob("include/*")) if f.is_dir()]
    return [*COMPILER, *(f"-I{folder}" for folder in folders), "-"]


def preprocess(ros: int, text: str, *options: str) -> str:
    """Return C++ after the preprocessor, with the headers of a ROS before it."""
    command = [*compiler(ros), *options]
    source = headers(ros) + text
    return subprocess.run(command, input=source, capture_output=True, text=True, check=True).stdout


def macros(ros: int) -> tuple[set[str], set[str]]:
    """Return the object-like and the function-like macros whose names a spec might have."""
    defined = re.compile(r"#define (\w+)(\(.*?\))?(?: (.*))?")
    objects: set[str] = set()
    functions: set[str] = set()
    for line in preprocess(ros, "", "-dM").splitlines():
        name, arguments, body = defined.match(line).groups()  # type: ignore[union-attr]
        if UNLIKELY.match(name) or (body or "").strip() == name:
            continue
        (objects if arguments is None else functions).add(name)
    return objects, {name for name in functions if name.islower()}


def table() -> dict[str, set[str]]:
    """Return the words of each meaning."""
    (objects, functions), (other_objects, other_functions) = macros(1), macros(2)
    return {
        "a macro of C++": objects & other_objects,
        "a macro of C++ in ROS 1": objects - other_objects,
        "a macro of C++ in ROS 2": other_objects - objects,
        "a function-like macro of C++": functions | other_functions,
    }


def written(words: Iterable[str]) -> str:
    """Return words in lines."""
    return textwrap.fill(" ".join(sorted(words)), 99, initial_indent="  ", subsequent_indent="  ")


if __name__ == "__main__":
    version = subprocess.run(["g++", "--version"], capture_output=True, text=True, check=True)
    sys.stdout.write(HEAD.format(compiler=version.stdout.splitlines()[0]))
    for meaning, words in table().items():
        sys.stdout.write(f"{meaning}: >-\n{written(words)}\n")
