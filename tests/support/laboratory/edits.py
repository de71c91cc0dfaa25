"""What developers do to a package. Every line of theirs carries a mark of its own."""

import ast
import re
import shutil
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from hooks.merge.tree import LINK, File, encode
from support.laboratory.judge import COUNTERPARTS

FOREIGN = b"caf\xe9".decode(errors="surrogateescape")
"""A word in an encoding that is not UTF-8."""


@dataclass
class Edited:
    """An edited package: its texts, and what was done to it."""

    texts: dict
    lines: dict = field(default_factory=dict)
    """By mark, where it was written: the path, and the function or None."""
    repeated: dict = field(default_factory=dict)
    """By path, lines without a mark: code that may stand anywhere."""
    replaced: dict = field(default_factory=dict)
    """By path, generated lines that are no longer there."""
    deleted: set = field(default_factory=set)
    """Generated files, and functions as (path, name), that are no longer there."""
    moved: dict = field(default_factory=dict)
    """By path, the one that the generated file had before the developer moved it."""
    links: dict = field(default_factory=dict)
    """By path, where a symbolic link leads."""
    crlf: set = field(default_factory=set)
    """Paths of files whose lines end as in Windows."""
    foreign: set = field(default_factory=set)
    """Marks of lines in another encoding."""
    formatted: set = field(default_factory=set)
    ahead: set = field(default_factory=set)
    """Paths in which a callback was written before the spec had it."""
    around: dict = field(default_factory=dict)
    """By the mark of a line above a callback or node, that of the one below, and the name."""
    exact: dict = field(default_factory=dict)
    """By mark, lines that no rename changes: what they name is another's."""
    number: int = 0

    def follow(self, texts, moves, renamed):
        """Go on from an update: what was written is now at other places."""
        words = {path: {*re.findall(r"\w+", text)} for path, text in texts.items()}
        everything = set().union(*words.values())

        def at(path):
            return path if path in self.moved else moves.get(path, path)

        def new_name(mark, name):
            """Return nothing for what left, where another one has its name."""
            names = renamed.get(self.lines[mark][0], {})
            return names.get(name, "" if name in names.values() else name)

        self.around = {
            first: (last, new_name(first, name))
            for first, (last, name) in self.around.items()
            if first in everything
        }

        def place(mark, path):
            places = [path, *COUNTERPARTS.get(path, ())]
            return next((p for p in places if mark in words.get(p, ())), path)

        self.lines = {
            mark: (place(mark, at(path)), renamed.get(path, {}).get(function, function))
            for mark, (path, function) in self.lines.items()
            if mark in everything
        }
        self.deleted = {
            (at(part[0]), renamed.get(part[0], {}).get(part[1], part[1]))
            if isinstance(part, tuple)
            else at(part)
            for part in self.deleted
        }
        # One file may leave for another that is renamed.
        replaced, self.replaced = self.replaced, {}
        for path, lines in replaced.items():
            self.replaced.setdefault(at(path), []).extend(lines)
        repeated, self.repeated = self.repeated, {}
        for path, lines in repeated.items():
            self.repeated[at(path)] = self.repeated.get(at(path), Counter()) + lines
        self.formatted = {at(path) for path in self.formatted}
        self.ahead = {at(path) for path in self.ahead}
        self.crlf = {at(path) for path in self.crlf if at(path) in texts}
        self.moved = {
            path: moves.get(origin, origin) for path, origin in self.moved.items() if path in texts
        }

    def mark(self, path, function=None):
        self.number += 1
        mark = f"mine_{self.number}"
        self.lines[mark] = (path, function)
        return mark

    def deleted_files(self):
        return [part for part in self.deleted if isinstance(part, str)]

    def tree(self):
        """Return the files, byte by byte."""
        files = {
            path: File(encode(text.replace("\n", "\r\n") if path in self.crlf else text))
            for path, text in self.texts.items()
        }
        return files | {path: File(to.encode(), LINK) for path, to in self.links.items()}


def edit(random, texts, new_callbacks=(), only_logic=False, edited=None, ways=None, always=()):
    """Edit a package as a developer would; `new_callbacks` may be written ahead.

    `ways` are those of `HABITS` that may be tried, all by default; `always`, those that are.
    """
    edited = edited or Edited({})
    edited.texts = dict(texts)
    habits = HABITS if ways is None else ways
    for habit in ("move", "delete_file", "delete_function", "replace_by_link"):
        if habit in always or (habit in habits and random.random() < 0.1):
            HABITS[habit](random, edited)
    for path in sorted(edited.texts):
        if is_logic(path):
            write_logic(random, edited, path)
        elif not only_logic and random.random() < 0.6:
            edit_list(random, edited, path)
        if not only_logic and random.random() < 0.3:
            reshape(random, edited, path)
    if not only_logic and random.random() < 0.3:
        write_own_file(edited)
    for node, name in new_callbacks:
        write_ahead(random, edited, node, name)
    for habit in ("link", "format", "write_in_another_encoding", "end_lines_as_windows"):
        chance = 0.2 if habit == "format" else 0.1
        if habit in always or (habit in habits and random.random() < chance):
            HABITS[habit](random, edited)
    for path, text in edited.texts.items():
        if path.endswith(".py"):
            ast.parse(plain(text))
    return edited


def is_logic(path):
    return path.endswith(("_impl.py", "_impl.cpp")) and "test" not in path


def plain(text):
    """Return a text without what another encoding has left in it."""
    return re.sub("[\udc80-\udcff]", "?", text)


def functions(path, text):
    """Yield the name, the first and the last line number of each function, counted from 0."""
    lines = text.split("\n")
    start = re.compile(
        r"    def (\w+)\(" if path.endswith(".py") else r"(?:\w+ )*(?:\w+::)+(\w+)\("
    )
    found = [(i, match[1]) for i, line in enumerate(lines) if (match := start.match(line))]
    for number, (first, name) in enumerate(found):
        last = found[number + 1][0] if number + 1 < len(found) else len(lines)
        body = range(first + 1, last)
        if path.endswith(".py"):
            ends = [
                i
                for i in body
                if re.match(r" {0,4}\S", lines[i]) and not lines[i].startswith("    )")
            ]
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
            helper = _helper(python, f"helper_{edited.number}", mark)
            after = [] if lines[last + 1 : last + 2] == [""] else [""]
            before = [""] if lines[last].strip() else []
            lines[last + 1 : last + 1] = [*before, *helper, *after]
        if random.random() < 0.7:
            at = _body_start(python, lines, first, last)
            lines[at:at] = _body(random, python, edited, path, name)
    if random.random() < 0.4:
        at = next(i for i, line in enumerate(lines) if line.startswith(("from ", "#include")))
        mark = edited.mark(path)
        lines.insert(at, f"import math  # {mark}" if python else f"#include <cmath>  // {mark}")
    edited.texts[path] = "\n".join(lines)
    if not python and random.random() < 0.5:
        put_in_condition(random, edited, path)


def put_in_condition(random, edited, path):
    """Put `#if` and `#endif` around a callback, with the comment, macro and attribute above it."""
    lines = edited.texts[path].split("\n")
    found = [
        (name, first, last)
        for name, first, last in functions(path, edited.texts[path])
        if name.startswith(("serve_", "receive_", "execute_"))
    ]
    if found:
        name, first, last = random.choice(found)
        while lines[first - 1].startswith(("//", "LAB_", "[[")):
            first -= 1
        if not lines[first - 1].startswith("#if"):
            form = "#if 1  // {}", "#endif  // {}"
            _put_around(edited, path, lines, first, last, name, form)
            edited.texts[path] = "\n".join(lines)


def _put_around(edited, path, lines, first, last, name, form):
    """Put a line above others, and one below."""
    above, below = (edited.mark(path) for _ in form)
    lines[last + 1 : last + 1] = [form[1].format(below)]
    lines[first:first] = [form[0].format(above)]
    edited.around[above] = (below, name)


def _helper(python, name, mark):
    if python:
        return [f"    def {name}(self):", f"        return 1  # {mark}"]
    return [f"static int {name}()", "{", f"  return 1;  // {mark}", "}"]


def _body_start(python, lines, first, last):
    """Return where the first line of a body goes: after the docstring, after the brace."""
    for at in range(first, last + 1):
        if python and lines[at].rstrip().endswith('"""') and lines[at].count('"""') in (1, 2):
            return at + 1
        if not python and lines[at] == "{":
            return at + 1
    return last + 1


_PYTHON = (
    ("value = 1  # {0}",),
    ("value = 2  # {0}",),
    ("self.passthrough.log.info('{0}')",),
    ("for value in range(2):", "    self.passthrough.log.info('{0}')"),
    ("try:", "    self.passthrough.log.info('{0}')", "except ValueError:", "    pass"),
    ("if self.passthrough is None:", "    return  # {0}"),
)
_CPP = (
    ("int value_{0} = 1;  // {0}",),
    ("{{", "  int value = 2;  // {0}", "  (void)value;", "}}"),
    ("for (int i = 0; i < 2; i++) {{", "  (void)i;  // {0}", "}}"),
    ("// {0}",),
)
"""Statements, with the mark of each in one line: all other lines may be those of another body."""


def _body(random, python, edited, path, function):
    margin = "        " if python else "  "
    lines = []
    for _ in range(random.randint(1, 4)):
        mark = edited.mark(path, function)
        forms = _PYTHON[:2] if function == "__init__" else _PYTHON if python else _CPP
        for form in random.choice(forms):
            line = margin + form.format(mark)
            lines.append(line)
            if mark not in line:
                edited.repeated.setdefault(path, Counter())[line.strip()] += 1
    return lines


def write_ahead(random, edited, node, name):
    """Write a callback that the spec does not have yet."""
    for path in [path for path in edited.texts if is_logic(path)]:
        if PurePosixPath(path).stem == f"{node}_impl":
            lines = edited.texts[path].split("\n")
            last = list(functions(path, edited.texts[path]))[-1][1]
            while re.match(r"\s*(#|//)", lines[last - 1]):
                last -= 1
            mark = edited.mark(path, name)
            if path.endswith(".py"):
                code = [f"    def {name}(self, request, response):"]
                code += [f"        return response  # {mark}", ""]
            else:
                types = f"{node}_types::{_class(name.removeprefix('serve_'))}Service"
                start = f"{name}(const {types}::Request &, {types}::Response &)"
                code = [f"void {_class(node)}Impl::{start}", "{", f"  // {mark}", "}", ""]
                _declare(edited, f"include/lab/{node}_impl.hpp", f"  void {start};")
            edited.texts[path] = "\n".join([*lines[:last], *code, *lines[last:]])
            edited.ahead.add(path)


def _declare(edited, header, line):
    if header in edited.texts:
        lines = edited.texts[header].split("\n")
        at = lines.index("private:")
        edited.texts[header] = "\n".join([*lines[: at - 1], line, *lines[at - 1 :]])
        edited.ahead.add(header)


def _class(name):
    return "".join(word.capitalize() for word in name.split("_"))


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
    if random.random() < 0.2:
        return _remove_item(random, edited, path, lines, "^  <exec_depend>.*_msgs<")
    form = "<exec_depend>{}</exec_depend>".format
    return _beside(random, edited, path, lines, "^  <(exec_)?depend>.*</", form)


def _remove_item(random, edited, path, lines, pattern):
    places = [i for i, line in enumerate(lines) if re.search(pattern, line)]
    if places:
        edited.replaced.setdefault(path, []).append(lines.pop(random.choice(places)))


def _launch(random, edited, path, lines):
    nodes = [i for i, line in enumerate(lines) if line.lstrip().startswith("<node ")]
    free = [i for i in nodes if "<group>" not in lines[i - 1]]
    if free and random.random() < 0.3:
        first = random.choice(free)
        last = next(i for i in range(first, len(lines)) if "</node>" in lines[i])
        name = re.search(r' name="(\w+)"', lines[first])[1]
        form = "<group>  <!-- {} -->", "</group>  <!-- {} -->"
        _put_around(edited, path, lines, first, last, name, form)
    else:
        places = [i for i in nodes if lines[i].startswith("  <node ")]
        at = random.choice([*places, len(lines) - 2])
        lines.insert(at, f'  <arg name="{edited.mark(path)}" default="1"/>')


def _yaml(random, edited, path, lines):
    places = [i for i, line in enumerate(lines) if re.match(r"\s+\w+: [\d.]+$", line)]
    if places and random.random() < 0.7:
        at = random.choice(places)
        edited.replaced.setdefault(path, []).append(lines[at])
        lines[at] = re.sub(r": [\d.]+$", f": 7  # {edited.mark(path)}", lines[at])
    elif places:
        at = random.choice(places)
        margin = re.match(r"\s*", lines[at])[0]
        lines.insert(at + 1, f"{margin}{edited.mark(path)}: 3")


def _cmake(random, edited, path, lines):
    form = "find_package({} REQUIRED)".format
    _beside(random, edited, path, lines, r"^find_package\(\w+ REQUIRED\)", form)
    if random.random() < 0.5:
        _beside(random, edited, path, lines, r"^  [\w:]+::[\w:]+$", "{}::library".format)
    places = [i for i, line in enumerate(lines) if re.match(r" *[a-z_]+\(|\)$", line)]
    if random.random() < 0.5:
        at = random.choice(places) + 1
        own = random.choice(CONDITIONS)
        if lines[at - 1].endswith(")"):
            marks = [edited.mark(path) for _ in re.findall(r"\{\d\}", own)]
            lines[at:at] = own.format(*marks).split("\n")
    if random.random() < 0.3:
        form = r"^add_(?:library|executable)\(\$\{PROJECT_NAME\}_(\w+)"
        starts = [i for i, line in enumerate(lines) if re.match(form, line)]
        first = random.choice(starts or [0])
        while lines[first - 1].startswith("#"):
            first -= 1
        if starts and not lines[first - 1].startswith("if("):
            ends = [i for i in range(first, len(lines)) if lines[i] == ")" and not lines[i + 1]]
            name = next(re.match(form, line)[1] for line in lines[first:] if line[:1] != "#")
            form = "if(TRUE)  # {}", "endif()  # {}"
            if not any(first < start < ends[0] for start in starts):
                _put_around(edited, path, lines, first, ends[0], name, form)


CONDITIONS = (
    "if({0})\n  set({1} 1)\nendif()  # {2}",
    "if(UNIX AND NOT APPLE)  # {0}\n  set({1} 1)\nelseif(TRUE)  # {2}\n  set({3} 1)\n"
    "else()  # {4}\n  set({5} 1)\nendif()  # {6}",
    "foreach({0} 1 2)\n  if(TRUE)  # {1}\n    set({2} 1)\n  endif()  # {3}\nendforeach()  # {4}",
    "function({0})\n  if(TRUE)  # {1}\n  endif()  # {2}\nendfunction()  # {3}",
)


def _setup(random, edited, path, lines):
    _beside(random, edited, path, lines, "= .*_ros:main'", "'{0} = lab.{0}:main',".format)


def _readme(random, edited, path, lines):
    heads = [i for i, line in enumerate(lines) if line.startswith("## ")]
    at = random.choice([*heads, len(lines) - 1])
    lines[at:at] = [f"Words of mine, {edited.mark(path)}.", ""]


def _definition(random, edited, path, lines):
    mark = edited.mark(path)
    form = random.choice(("# {}", "float64 {}", "float64 {0}  # {0}"))
    free = [i for i in range(len(lines)) if not lines[max(i - 1, 0)].startswith("#")]
    lines.insert(random.choice(free or [len(lines)]), form.format(mark))


def _code(random, edited, path, lines):
    python = path.endswith(".py")
    found = list(functions(path, "\n".join(lines)))
    if found:
        name, first, last = random.choice(found)
        at = _body_start(python, lines, first, last)
        mark = edited.mark(path, name)
        lines.insert(at, f"        value = 1  # {mark}" if python else f"  // {mark}")


def _header(random, edited, path, lines):
    at = next((i for i, line in enumerate(lines) if line.startswith("#include")), None)
    if at is not None:
        lines.insert(at, f"#include <cmath>  // {edited.mark(path)}")


def reshape(random, edited, path):
    """Write as developers do, but not as the model does."""
    ways = [way for suffixes, way in SHAPES if path.endswith(suffixes)]
    if ways and edited.texts[path].endswith("\n"):
        lines = edited.texts[path].split("\n")
        random.choice(ways)(random, edited, path, lines)
        edited.texts[path] = "\n".join(lines)


def _blank_end(random, edited, path, lines):
    lines.append("")


def _comment(random, edited, path, lines):
    """Put a comment above an item, perhaps with an empty line after it."""
    is_xml, is_cpp = path.endswith((".xml", ".launch")), path.endswith((".cpp", ".hpp"))
    form = "<!-- {} -->" if is_xml else "// {}" if is_cpp else "# {}"
    item = r"  <\w" if is_xml else r"[a-z_]+\(" if path.endswith(".txt") else r" *[\w/*]+:"
    item = r"(  )?(\w+ )+\w+(::\w+)?\(" if is_cpp else item
    places = [i for i, line in enumerate(lines) if i and re.match(item, line)]
    if places:
        at = random.choice(places)
        margin = re.match(r"\s*", lines[at])[0]
        gap = [""] if random.random() < 0.3 else []
        lines[at:at] = [margin + form.format(edited.mark(path)), *gap]


def _own_import(random, edited, path, lines):
    """Make the import of the interface relative, or try it."""
    start = next(
        (i for i, line in enumerate(lines) if re.match(r"from \w+\.\w+_interface", line)), 0
    )
    if not start or lines[start].count("(") != 1 or not is_logic(path):
        return
    end = next(i for i in range(start, len(lines)) if ")" in lines[i])
    if random.random() < 0.5:
        edited.replaced.setdefault(path, []).append(lines[start])
        lines[start] = re.sub(r"from \w+\.", "from .", lines[start]) + f"  # {edited.mark(path)}"
    else:
        inside = ["    " + line for line in lines[start : end + 1]]
        first, second, third = (edited.mark(path) for _ in range(3))
        after = [f"except ImportError:  # {second}", f"    raise  # {third}"]
        lines[start : end + 1] = [f"try:  # {first}", *inside, *after]


def _definitions(path, lines):
    form = (
        r"  \w+ (\w+)\(" if path.endswith(".hpp") else r"\w+ \w+::((?:serve|receive|execute)\w+)\("
    )
    return [i for i, line in enumerate(lines) if re.match(form, line)]


def _macro(random, edited, path, lines):
    if places := _definitions(path, lines):
        at = random.choice(places)
        margin = re.match(r"\s*", lines[at])[0]
        form = random.choice(("LAB_TRACE({})", "LAB_HOT  // {}", "[[gnu::hot]]  // {}"))
        lines.insert(at, margin + form.format(edited.mark(path)))


def _attribute(random, edited, path, lines):
    if places := _definitions(path, lines):
        at = random.choice(places)
        edited.replaced.setdefault(path, []).append(lines[at])
        margin, rest = re.match(r"(\s*)(.*)", lines[at]).groups()
        form = random.choice(("__attribute__((hot)) ", "LAB_EXPORT(1) ", "LAB_API "))
        lines[at] = f"{margin}{form}{rest}  // {edited.mark(path)}"


def _ifdef(random, edited, path, lines):
    """Put an indented condition around a declaration and the comment above it."""
    if places := _definitions(path, lines):
        first = last = random.choice(places)
        while ";" not in lines[last] and "{" not in lines[last]:
            last += 1
        while lines[first - 1].lstrip().startswith("//") and ";" in lines[last]:
            first -= 1
        if ";" in lines[last] and not lines[first - 1].lstrip().startswith("#"):
            lines.insert(last + 1, f"  #endif  // {edited.mark(path)}")
            lines.insert(first, f"  # ifdef LAB_MINE  // {edited.mark(path)}")


def _class_macro(random, edited, path, lines):
    for at, line in enumerate(lines):
        if re.match(r"class \w+$", line):
            edited.replaced.setdefault(path, []).append(line)
            lines[at] = line.replace("class ", "class LAB_API ") + f"  // {edited.mark(path)}"


def _namespace(random, edited, path, lines):
    """Close the namespace, and open it again, perhaps below own code."""
    inside = lines.index("namespace lab") if "namespace lab" in lines else len(lines)
    places = [i for i, line in enumerate(lines) if line == "}" and i > inside + 2]
    if places:
        at = random.choice(places) + 1
        closed, opened, brace = (edited.mark(path) for _ in range(3))
        own = ["", f"static int {edited.mark(path)} = 0;", ""] if at % 2 else []
        opening = [f"namespace lab  // {opened}", f"{{  // {brace}"]
        lines[at:at] = ["", f"}}  // {closed}", *own, *opening]


def _fence(random, edited, path, lines):
    fence = random.choice(("~~~", "````", "```"))
    at = random.choice(
        [i for i, line in enumerate(lines) if line.startswith("#")][1:] or [len(lines)]
    )
    inside = [f"## {edited.mark(path)}", *(["~~~"] if fence != "~~~" else ["```"])]
    for line in (fence, inside[1]):
        edited.repeated.setdefault(path, Counter())[line] += 1
    lines[at:at] = [f"{fence} {edited.mark(path)}", *inside, fence, ""]


def _heading(random, edited, path, lines):
    if tables := [i for i, line in enumerate(lines[1:]) if line.startswith("|---")]:
        at = random.choice(tables)
        lines[at:at] = [f"### {edited.mark(path)}", ""]


def _title(random, edited, path, lines):
    """Give a section, or the parameters of a node, another name."""
    is_yaml = path.endswith(".yaml")
    form = r"/\*\*:$" if is_yaml else r"##? \w"
    places = [i for i, line in enumerate(lines) if re.match(form, line)]
    if places:
        at = random.choice(places)
        edited.replaced.setdefault(path, []).append(lines[at])
        start = "/robot/lab:  #" if is_yaml else lines[at]
        lines[at] = f"{start} {edited.mark(path)}"


def _between(random, edited, path, lines):
    """Part a function from the comment above it."""
    form = r"\s*(#|//) (Topic|Service|Action) \w+$"
    places = [i for i, line in enumerate(lines) if re.match(form, line)]
    if places:
        python = path.endswith(".py")
        form = (
            "    value = 1  # {}" if python else random.choice(("#pragma lab {}", "int {} = 0;"))
        )
        lines.insert(random.choice(places) + 1, form.format(edited.mark(path)))


def _qualified(random, edited, path, lines):
    """Write the namespace before a class."""
    if places := _definitions(path, lines):
        at = random.choice(places)
        edited.replaced.setdefault(path, []).append(lines[at])
        lines[at] = f"{lines[at].replace(' ', ' lab::', 1)}  // {edited.mark(path)}"


def _bracket(random, edited, path, lines):
    form = random.choice(("#[=[ {} ( ]=]", r"set({} a\(b)", 'set({} [[")]])'))
    at = random.choice([i for i, line in enumerate(lines) if re.match(r"[a-z_]+\(", line)])
    lines.insert(at, form.format(edited.mark(path)))


SHAPES = (
    ((".py", ".cpp", ".hpp", ".xml", ".yaml", ".txt", ".md"), _blank_end),
    ((".xml", ".launch", ".yaml", ".txt", ".hpp", "_impl.cpp"), _comment),
    (("_impl.py",), _own_import),
    (("_impl.hpp", "_impl.cpp"), _macro),
    (("_impl.hpp", "_impl.cpp"), _attribute),
    (("_impl.hpp",), _ifdef),
    (("_impl.hpp",), _class_macro),
    (("_impl.cpp",), _namespace),
    ((".md",), _fence),
    ((".md",), _heading),
    ((".txt",), _bracket),
    ((".md", ".yaml"), _title),
    (("_impl.py", "_impl.cpp"), _between),
    (("_impl.cpp",), _qualified),
)
"""What is written in another way than the model does it, by the ends of paths."""


def write_own_file(edited):
    """Write a file of one's own that uses what only looks like the model's."""
    nodes = [m[1] for path in edited.texts if (m := re.match(r"(?:src|lab)/(\w+)_impl\.", path))]
    words = re.findall(r"\b(?:in|out)_\w+|\bserve_\w+", "".join(map(str, edited.texts.values())))
    if not nodes:
        return
    python = any(path.endswith("_impl.py") for path in edited.texts)
    path, sign = ("lab/foreign.py", "#") if python else ("src/foreign.cpp", "//")
    lines = []
    for node in nodes:
        name = _class(node)
        forms = ("from kinematics import {0}Config", "print(msg.{2}, other.{1})", "{1} = 1")
        if not python:
            forms = ("using kin::{0}Config;", "int a_{1} = msg.{2} + other.{1};", '// "{1}"')
        for form in forms:
            mark = edited.mark(path)
            word = (words or ["in_x"])[edited.number % len(words or [0])]
            lines.append(form.format(name, node, word) + f"  {sign} {mark}")
            edited.exact[mark] = lines[-1]
    edited.texts[path] = edited.texts.get(path, "") + "\n".join([*lines, ""])


WAYS = {
    "package.xml": _package_xml,
    ".launch": _launch,
    ".launch.xml": _launch,
    ".yaml": _yaml,
    "CMakeLists.txt": _cmake,
    "setup.py": _setup,
    "README.md": _readme,
    ".msg": _definition,
    ".srv": _definition,
    ".action": _definition,
    "_ros.py": _code,
    "_ros.cpp": _code,
    "worker.py": _code,
    "managed_node.py": _code,
    "harness.py": _code,
    "_impl.hpp": lambda random, edited, path, lines: _beside(
        random, edited, path, lines, "^private:", "// {}".format
    ),
    "inbox.hpp": _header,
    "logger.hpp": _header,
    "_harness.hpp": _header,
}


def move(random, edited):
    """Move a generated file into another folder, as `git mv` does."""
    found = [p for p in sorted(edited.texts) if re.search(r"_impl\.(py|cpp)$|\.yaml$", p)]
    found = [path for path in found if path not in edited.moved]
    if found:
        path = random.choice(found)
        target = str(PurePosixPath(path).parent / "mine" / PurePosixPath(path).name)
        _move(edited, path, target)


def _move(edited, path, target):
    edited.texts[target] = edited.texts.pop(path)
    edited.moved[target] = path
    for about in (edited.replaced, edited.repeated):
        if path in about:
            about[target] = about.pop(path)
    for about in (edited.formatted, edited.ahead, edited.crlf):
        if path in about:
            about.remove(path)
            about.add(target)
    edited.deleted = {
        (target, part[1]) if isinstance(part, tuple) and part[0] == path else part
        for part in edited.deleted
    }
    edited.lines = {
        mark: (target if at == path else at, function)
        for mark, (at, function) in edited.lines.items()
    }


def delete_file(random, edited):
    """Delete a generated file that nothing needs."""
    found = [p for p in edited.texts if re.match(r"README.md|(test|launch|config)/", p)]
    found = [path for path in sorted(found) if path not in edited.moved]
    if found:
        path = random.choice(found)
        edited.lines = {mark: at for mark, at in edited.lines.items() if at[0] != path}
        del edited.texts[path]
        edited.deleted.add(path)


def delete_function(random, edited):
    """Delete a callback that the spec has."""
    paths = [path for path in sorted(edited.texts) if is_logic(path)]
    if not paths:
        return
    path = random.choice(paths)
    found = [
        (name, first, last)
        for name, first, last in functions(path, edited.texts[path])
        if name.startswith(("serve_", "receive_", "execute_"))
    ]
    if found:
        name, first, last = random.choice(found)
        lines = edited.texts[path].split("\n")
        while re.match(r"\s*#" if path.endswith(".py") else "//", lines[first - 1]):
            first -= 1
        if path.endswith(".cpp") and lines[last + 1 : last + 2] == [""]:
            last += 1
        gone = lines[first : last + 1]
        marks = set(re.findall(r"mine_\d+", "\n".join(gone)))
        edited.lines = {mark: at for mark, at in edited.lines.items() if mark not in marks}
        edited.replaced.setdefault(path, []).extend(line for line in gone if line.strip())
        edited.texts[path] = "\n".join([*lines[:first], *lines[last + 1 :]])
        edited.deleted.add((path, name))


def replace_by_link(random, edited):
    """Move the README elsewhere, and leave a link to it."""
    if "README.md" in edited.texts and "docs/README.md" not in edited.texts:
        _move(edited, "README.md", "docs/README.md")
        edited.links["README.md"] = "docs/README.md"


def link(random, edited):
    """Put a link to a file beside it."""
    edited.links["params.yaml"] = "package.xml"


def write_in_another_encoding(random, edited):
    """Write a line that is not UTF-8; Python must be told of it."""
    paths = [
        path for path in sorted(edited.texts) if path.endswith((".py", ".cpp", ".txt", ".yaml"))
    ]
    paths = [p for p in paths if "mine_" in edited.texts[p] and FOREIGN not in edited.texts[p]]
    if paths:
        path = random.choice(paths)
        lines = edited.texts[path].split("\n")
        sign = "//" if path.endswith(".cpp") else "#"
        mark = edited.mark(path)
        new = [f"{sign} {FOREIGN} {mark}"]
        edited.foreign.add(mark)
        if path.endswith(".py"):
            new.insert(0, f"# -*- coding: latin-1 -*- {edited.mark(path)}")
        edited.texts[path] = "\n".join([*new, *lines])


def end_lines_as_windows(random, edited):
    """Save some files with other line ends."""
    paths = sorted(path for path in edited.texts if not path.endswith(".ros_package"))
    edited.crlf |= set(random.sample(paths, k=min(3, len(paths))))


def run_formatter(random, edited):
    """Run ruff over Python; indent C++ by four, join what a line can hold; CMake in capitals."""
    for path, text in edited.texts.items():
        if path.endswith(".py") and FOREIGN not in text:
            edited.texts[path] = ruff(path, text)
        elif path.endswith((".cpp", ".hpp")):
            text = re.sub(r"(?m)^((?:  )+)(?=\S)", lambda m: m[1] * 2, text)
            edited.texts[path] = re.sub(r"\(\n\s+([^\n/]{1,60})\)", r"(\1)", text)
        elif path == "CMakeLists.txt":
            command = r"(?m)^ *[a-z]\w*(?=\()"
            edited.texts[path] = re.sub(command, lambda m: m[0].upper(), text)
        if path.endswith((".cpp", ".hpp")) or (
            path.endswith(".py") and edited.texts[path] != text
        ):
            edited.formatted.add(path)


def ruff(path, text):
    tool = shutil.which("ruff") or str(Path(sys.executable).parent / "ruff")
    command = [tool, "format", "--isolated", "--stdin-filename", Path(path).name, "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


HABITS = {
    "move": move,
    "delete_file": delete_file,
    "delete_function": delete_function,
    "replace_by_link": replace_by_link,
    "link": link,
    "format": run_formatter,
    "write_in_another_encoding": write_in_another_encoding,
    "end_lines_as_windows": end_lines_as_windows,
}
