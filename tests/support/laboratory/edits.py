"""What developers do to a package. Every line of theirs carries a mark of its own."""

import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Edited:
    """An edited package: its texts, and what was done to it."""

    texts: dict
    lines: dict = field(default_factory=dict)
    """By mark, where it was written: the path, and the function or None."""
    replaced: dict = field(default_factory=dict)
    """By path, generated lines that are no longer there."""
    formatted: set = field(default_factory=set)
    ahead: set = field(default_factory=set)
    """Paths in which a callback was written before the spec had it."""
    number: int = 0

    def follow(self, texts, moves, renamed):
        """Go on from an update: what was written is now at other places."""
        everything = "\n".join(texts.values())
        self.lines = {
            mark: (moves.get(path, path), renamed.get(path, {}).get(function, function))
            for mark, (path, function) in self.lines.items()
            if re.search(rf"\b{mark}\b", everything)
        }
        self.replaced = {moves.get(path, path): lines for path, lines in self.replaced.items()}
        self.formatted = {moves.get(path, path) for path in self.formatted}
        self.ahead = {moves.get(path, path) for path in self.ahead}

    def mark(self, path, function=None):
        self.number += 1
        mark = f"mine_{self.number}"
        self.lines[mark] = (path, function)
        return mark


def edit(random, texts, new_callbacks=(), formatters=True, only_logic=False, edited=None):
    """Edit a package as a developer would; `new_callbacks` may be written ahead."""
    edited = edited or Edited({})
    edited.texts = dict(texts)
    for path in sorted(texts):
        if path.endswith(("_impl.py", "_impl.cpp")) and "test" not in path:
            write_logic(random, edited, path)
        elif not only_logic and random.random() < 0.6:
            edit_list(random, edited, path)
    for node, name in new_callbacks:
        write_ahead(random, edited, node, name)
    if formatters and random.random() < 0.2:
        run_formatter(edited)
    return edited


def functions(path, text):
    """Yield the name, the first and the last line number of each function, counted from 0."""
    lines = text.split("\n")
    start = re.compile(r"    def (\w+)\(" if path.endswith(".py") else r"(?:\w+ )?\w+::(\w+)\(")
    found = [(i, match[1]) for i, line in enumerate(lines) if (match := start.match(line))]
    for number, (first, name) in enumerate(found):
        last = found[number + 1][0] if number + 1 < len(found) else len(lines)
        body = range(first + 1, last)
        if path.endswith(".py"):
            ends = [
                i for i in body if re.match(r"( {0,4}\S)", lines[i]) and lines[i][:5] != "    )"
            ]
            ends = [i for i in ends if not lines[i].startswith("    )")]
        else:
            ends = [i + 1 for i in body if lines[i] == "}"]
        yield name, first, (ends[0] if ends else last) - 1


def write_logic(random, edited, path):
    """Fill bodies in, and put helpers between them."""
    lines = edited.texts[path].split("\n")
    python = path.endswith(".py")
    for name, first, last in reversed(list(functions(path, edited.texts[path]))):
        if random.random() < 0.25:
            mark = edited.mark(path, f"helper_{edited.number + 1}")
            name_of_it = f"helper_{edited.number}"
            lines[last + 1 : last + 1] = _helper(python, name_of_it, mark)
        if random.random() < 0.7:
            at = _body_start(python, lines, first, last)
            lines[at:at] = _body(random, python, edited, path, name)
    if random.random() < 0.4:
        at = next(i for i, line in enumerate(lines) if line.startswith(("from ", "#include")))
        mark = edited.mark(path)
        lines.insert(at, f"import math  # {mark}" if python else f"#include <cmath>  // {mark}")
    edited.texts[path] = "\n".join(lines)


def _helper(python, name, mark):
    if python:
        return ["", f"    def {name}(self):", f"        return 1  # {mark}"]
    return ["", f"static int {name}()", "{", f"  return 1;  // {mark}", "}"]


def _body_start(python, lines, first, last):
    """Return where the first line of a body goes: after the docstring, after the brace."""
    for at in range(first, last + 1):
        if python and lines[at].rstrip().endswith('"""') and lines[at].count('"""') in (1, 2):
            return at + 1
        if not python and lines[at] == "{":
            return at + 1
    return last + 1


def _body(random, python, edited, path, function):
    margin = "        " if python else "  "
    lines = []
    for _ in range(random.randint(1, 4)):
        mark = edited.mark(path, function)
        code = random.choice(("value = 1", "value = 2", "value = value + 1", "return_value = 0"))
        comment = f"  # {mark}" if python else f";  // {mark}"
        lines.append(f"{margin}{code if python else 'int ' + code.split()[0] + mark}{comment}")
    return lines


def write_ahead(random, edited, node, name):
    """Write a callback that the spec does not have yet."""
    for path in list(edited.texts):
        if path.endswith(f"/{node}_impl.py"):
            mark = edited.mark(path, name)
            code = ["", f"    def {name}(self, request, response):"]
            code += [f"        return response  # {mark}", ""]
            lines = edited.texts[path].split("\n")
            at = next((i for i, line in enumerate(lines) if "# End of life" in line), None)
            at = at - 1 if at else len(lines) - 1
            edited.texts[path] = "\n".join([*lines[:at], *code[:-1], *lines[at:]])
            edited.ahead.add(path)


def edit_list(random, edited, path):
    """Put an item of one's own beside generated ones, or tune one."""
    text = edited.texts[path]
    for suffix, way in WAYS.items():
        if path.endswith(suffix):
            lines = text.split("\n")
            way(random, edited, path, lines)
            edited.texts[path] = "\n".join(lines)
            return


def _beside(random, edited, path, lines, pattern, form):
    places = [i for i, line in enumerate(lines) if re.search(pattern, line)]
    if places:
        at = random.choice(places)
        margin = re.match(r"\s*", lines[at])[0]
        lines.insert(at + random.randint(0, 1), margin + form(edited.mark(path)))


def _package_xml(random, edited, path, lines):
    form = "<exec_depend>{}</exec_depend>".format
    _beside(random, edited, path, lines, "^  <(exec_)?depend>.*</", form)


def _launch(random, edited, path, lines):
    places = [i for i, line in enumerate(lines) if line.startswith("  <node ")]
    at = random.choice([*places, len(lines) - 2])
    lines.insert(at, f'  <arg name="{edited.mark(path)}" default="1"/>')


def _yaml(random, edited, path, lines):
    places = [i for i, line in enumerate(lines) if re.match(r"\s+\w+: [\d.]+$", line)]
    if places and random.random() < 0.7:
        at = random.choice(places)
        edited.replaced.setdefault(path, []).append(lines[at])
        lines[at] = re.sub(r": [\d.]+$", f": 7  # {edited.mark(path)}", lines[at])
    elif places:
        lines.insert(random.choice(places) + 1, f"    {edited.mark(path)}: 3")


def _cmake(random, edited, path, lines):
    form = "find_package({} REQUIRED)".format
    _beside(random, edited, path, lines, r"^find_package\(\w+ REQUIRED\)", form)
    if random.random() < 0.5:
        _beside(random, edited, path, lines, r"^  [\w:]+::[\w:]+$", "{}::library".format)


def _setup(random, edited, path, lines):
    _beside(random, edited, path, lines, "= .*_ros:main'", "'{0} = lab.{0}:main',".format)


def _readme(random, edited, path, lines):
    heads = [i for i, line in enumerate(lines) if line.startswith("## ")]
    at = random.choice([*heads, len(lines) - 1])
    lines[at:at] = [f"Words of mine, {edited.mark(path)}.", ""]


def _code(random, edited, path, lines):
    python = path.endswith(".py")
    found = list(functions(path, "\n".join(lines)))
    if found:
        name, first, last = random.choice(found)
        at = _body_start(python, lines, first, last)
        mark = edited.mark(path, name)
        lines.insert(at, f"        value = 1  # {mark}" if python else f"  // {mark}")


WAYS = {
    "package.xml": _package_xml,
    ".launch": _launch,
    ".launch.xml": _launch,
    ".yaml": _yaml,
    "CMakeLists.txt": _cmake,
    "setup.py": _setup,
    "README.md": _readme,
    "_ros.py": _code,
    "_ros.cpp": _code,
    "_impl.hpp": lambda random, edited, path, lines: _beside(
        random, edited, path, lines, "^private:", "// {}".format
    ),
}


def run_formatter(edited):
    """Run ruff over the Python files; indent C++ by four and join what a line can hold."""
    for path, text in edited.texts.items():
        if path.endswith(".py"):
            edited.texts[path] = ruff(path, text)
        elif path.endswith((".cpp", ".hpp")):
            text = re.sub(r"(?m)^((?:  )+)(?=\S)", lambda m: m[1] * 2, text)
            edited.texts[path] = re.sub(r"\(\n\s+([^\n/]{1,60})\)", r"(\1)", text)
        if edited.texts[path] != text or path.endswith((".cpp", ".hpp")):
            edited.formatted.add(path)


def ruff(path, text):
    tool = shutil.which("ruff") or str(Path(sys.executable).parent / "ruff")
    command = [tool, "format", "--isolated", "--stdin-filename", Path(path).name, "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
