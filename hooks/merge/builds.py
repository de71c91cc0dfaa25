"""What the developer wrote into build files, carried into those of another ROS.

The new file is the model's, and sound: items are put into its lists, commands where all that they
use stands above them. What means nothing in the other ROS stays behind.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ..data import load_data
from .blocks import THEN, Block
from .languages import CMAKE
from .launch import deleted, keys
from .lines import changed, margin, plain, split
from .matching import Blocks, match
from .package import Result
from .renaming import Renaming
from .tree import File, Tree, encode

_KNOWN = load_data("builds.yaml")
_CMAKE, _SETUP = "CMakeLists.txt", "setup.py"
_OWN = re.compile(r"(?im)^[ \t]*(?:function|macro)[ \t]*\([ \t]*(\w+)")
_INSTALL = re.compile(
    r"install\(\s*(FILES|PROGRAMS|DIRECTORY)\s+([^()]*?)\s+DESTINATION\s+(\S+?)\s*\)\s*"
)
_ENTRY = re.compile(
    r"\*installed\('([\w/.-]+)'\),"
    r"|\('(share|lib)/' \+ package_name(?: \+ '/([\w/.-]+)')?, (glob\('\3/\*'\)|\[[^]\n]*\])\),"
)
_PROJECT = {"share": "share/${PROJECT_NAME}", "lib": "lib/${PROJECT_NAME}"}
# Commands about the parts of a target.
_PARTS = ("target_link_libraries", "add_executable", "add_library")
_ABOUT_TARGET = re.compile(
    r"(?:target_|set_target_properties|add_dependencies|install(?=\s*\(\s*TARGETS))\w*"
    r"\s*\(\s*(?:TARGETS\s+)?([^\s)]+)"
)
_ARGUMENT = re.compile(
    r'(?P<head>\w+[ \t]*\()|(?P<comment>[ \t]*#.*)|"(?:\\.|[^"\\])*"|[^\s()"#]+'
)
_Lines = dict[int, tuple[str, ...]]


class _Item(NamedTuple):
    """An argument of a command, or a comment on a line of its own."""

    at: int
    """Its line."""
    keyword: str
    """What says what the arguments below it are; a keyword is its own."""
    name: str
    comment: str = ""
    """What stands behind it."""

    @property
    def text(self) -> str:
        return self.name + self.comment


def carry_build_files(
    mine: Tree, old: Tree, new: Tree, renaming: Renaming, result: Result, ros: int
) -> None:
    """Make build files those of a ROS, `ros`, with what was written into the other ones."""
    names = (_CMAKE, _SETUP)
    both = [path for path in names if path in mine and path in old]
    paths = [p for p in both if mine[p] != old[p] and mine[p].text is not None]
    files = {path: new[path] for path in names if path in new}
    try:
        carrier = _Carrier({path: file.written for path, file in files.items()}, ros)
        found = {}
        for path in paths:
            ours, base = (renaming.text(path, plain(side[path].written)) for side in (mine, old))
            found[path] = carrier.file(path, ours, base)
            result.back[path] = carrier.back
        texts = carrier.texts()
        CMAKE.blocks(texts[_CMAKE])
    except (ValueError, RecursionError):
        return  # the merge by block stands
    for path in paths:
        result.carried[path] = ([*names], found[path])
        for said in (result.conflicts, result.rejected, result.settled, result.removed):
            said.pop(path, None)
    for path, file in files.items() if paths else ():
        if path in mine and mine[path] != old.get(path) and path not in paths:
            continue
        result.missing.pop(path, None)
        text = texts[path]
        is_crlf = path in mine and "\r\n" in mine[path].written
        result.tree[path] = File(
            encode(text.replace("\n", "\r\n") if is_crlf else text), file.mode
        )


class _Carrier:
    """Build files of a ROS, into which is put what was written into those of the other one."""

    def __init__(self, texts: dict[str, str], ros: int) -> None:
        self.ros = ros
        self.foreign = re.compile(_KNOWN["foreign"][3 - ros]).search
        self.lists = [
            (row[2 * (2 - ros)], *row[2 * (ros - 1) : 2 * ros], row[-1]) for row in _KNOWN["lists"]
        ]
        """The commands of the other ROS, those of this one, the words above the items, folders."""
        self.new = CMAKE.blocks(texts.get(_CMAKE, ""))
        self.setup = split(texts.get(_SETUP, ""))
        catkin = self._named("find_package catkin")
        self.catkin = catkin.lines if catkin else []
        """What finds catkin and its components, in ROS 1."""
        self.has_cmake = _CMAKE in texts
        self.lines: _Lines = {}
        self.back: list[str] = []
        """What the developer had deleted."""
        self.own: set[str] = set()
        """The functions and macros of the developer's that stay behind."""
        self.made: set[str] = set()
        """The comments of the model's, which are about its own commands."""

    def _named(self, *keys: str) -> Block | None:
        return next((block for block in self.new if block.key in keys), None)

    def texts(self) -> dict[str, str]:
        return {_CMAKE: "".join(b.text for b in self.new), _SETUP: "".join(self.setup)}

    def file(self, path: str, mine: str, old: str) -> _Lines:
        """Carry what `mine` has more than `old`; return the lines that came along, and as what."""
        self.lines, self.back = {}, []
        if path == _SETUP:
            for number, line, _, _ in _own_lines(split(mine), split(old)):
                self._entry(number + 1, line)
        else:
            blocks, base = CMAKE.blocks(mine), CMAKE.blocks(old)
            match(blocks, base)
            self.back = deleted(blocks, base, self.new)
            self.made = {line.strip() for line in split(old) if line.startswith("#")}
            self.own = {name.lower() for name in _OWN.findall(mine)}
            self._commands(blocks, base, self.new, 1, is_top=True)
        return self.lines

    def _commands(
        self, mine: Blocks, old: Blocks, new: list[Block], number: int, is_top: bool = False
    ) -> None:
        known = {block.key: block for block in old}
        generated = {key for key in keys(old) if key != THEN}  # each condition has one
        there = {block.key: block for block in new}
        for block in mine:
            base = known.get(block.key)
            if is_top and self._is_list(block.key):
                self._list(block, base, number)
            elif is_top and generated.isdisjoint(keys([block])):
                self._command(block, number)
            elif base and block.children and block.key in there:
                inner = number + len(block.lines)
                self._commands(block.children, base.children, there[block.key].children, inner)
            elif base:
                same = {line.strip() for line in base.lines}
                for at, line, before, replaced in _own_lines(block.lines, base.lines):
                    if line.strip() not in same:
                        self._line(block.key, line, before, replaced, number + at, new)
            number += len(split(block.text))

    def _command(self, block: Block, number: int) -> None:
        """Put a command of the developer's where all that it uses stands above."""
        lines = split(block.text)
        text = self._translated("".join(each for each in lines if each.strip() not in self.made))
        code = re.sub(r"(?m)^\s*#.*\n?", "", text).strip()
        names = re.findall(r"(?m)^[ \t]*(\w+)[ \t]*\(", code.lower())
        installed = _INSTALL.fullmatch(code)
        package = re.fullmatch(r"find_package\(\s*(\w+)[^()]*\)", code)
        if self.foreign(code) or not self.own.isdisjoint(names):
            return
        if package and self._component(package[1]):
            self._note(number, block.text, package[1])
        elif not self.has_cmake:
            if installed and (entry := self._as_entry(installed)):
                self._note(number, block.text, entry)
        elif self._has_target(code):
            is_first = all(re.match(_KNOWN["first"], each) for each in names)
            at = self._below_packages() if is_first else len(self.new)
            while re.match(_KNOWN["last"], self.new[at - 1].key):
                at -= 1
            key = f"find_package own {number}" if is_first else f"own {number}"
            self.new.insert(at, Block(key, split(text.removesuffix("\n") + "\n")))
            self.own.difference_update(_OWN.findall(code.lower()))
            for i, line in enumerate(lines):
                self._note(number + i, line, self._translated(line).strip())

    def _is_list(self, key: str) -> bool:
        """Say whether the items of a command go into one that stands for it."""
        if _name(key) in _PARTS:
            return self._same_target(key) is not None
        if key in ("find_package catkin", "install DIRECTORY"):
            return self.ros == 2 if key.startswith("find") else not self.has_cmake
        return bool(self._lists(key))

    def _lists(self, key: str) -> list[tuple[str, str, str]]:
        """Return the commands that items of a command go to, with their words and folders."""
        return [(target, *rest) for name, target, *rest in self.lists if name == _name(key)]

    def _list(self, block: Block, base: Block | None, number: int) -> None:
        """Put the items that a list has more than `base` into the one that stands for it.

        Where those of the model stand now means nothing.
        """
        generated = base.text if base else ""
        key = block.key
        same = {*key.split(), *(item.name for item in _items(key, generated))}
        became = {
            item: "" if item.name in (*same, item.keyword) else self._item(key, item)
            for item in _items(key, block.text)
            if item.name not in same or item.comment not in generated
        }
        used = {item.keyword for item, text in became.items() if text}
        behind = {i.at for i, text in became.items() if not text and i.name not in used}
        for at, *_ in _own_lines(block.lines, split(generated)) if base or used else ():
            if at not in behind:
                self.lines[number + at] = tuple(text for i, text in became.items() if i.at == at)

    def _has_target(self, code: str) -> bool:
        """Say whether the target that a command is about is there."""
        target = _ABOUT_TARGET.match(code)
        if target is None:
            return True
        form = rf"add_(library|executable)\(\s*{re.escape(target[1])}[\s)]"
        return bool(re.search(form, self.texts()[_CMAKE]))

    def _translated(self, text: str) -> str:
        for pair in _KNOWN["destinations"]:
            before, after = pair if self.ros == 2 else reversed(pair)
            form = rf"(DESTINATION\s+){re.escape(before)}(?=[\s/)]|$)"
            text = re.sub(form, lambda m, after=after: m[1] + after, text)  # type: ignore[misc]
        return text.replace("catkin_install_python(", "install(")

    def _item(self, key: str, item: _Item) -> str:
        """Put an item into the list that stands for the one it is in; return what it is there."""
        if item.keyword not in _KNOWN["items"][_name(key)]:
            return ""
        if _name(key) in _PARTS:
            return self._part(key, item)
        for target, word, folder in (lists := self._lists(key)):
            before, after = ("", f"{folder}/") if self.ros == 2 else (f"{folder}/", "")
            if file := re.fullmatch(rf"{before}([\w/.-]+\.{folder})", item.name):
                return self._listed(target, word, after + file[1] + item.comment, f".{folder}")
            is_package = not folder and re.fullmatch(r"[a-z]\w*", item.name)
            if is_package and not self.foreign(item.name):
                return self._listed(target, word, item.text)
        if lists or self.foreign(item.name):
            return ""
        if key == "install DIRECTORY":
            is_folder = re.fullmatch(r"[\w/.-]+", item.name)
            return self._in_setup(f"*installed('{item.name}'),{item.comment}") if is_folder else ""
        return self._package(item) if self.has_cmake and re.fullmatch(r"\w+", item.name) else ""

    def _line(
        self, key: str, line: str, before: str, replaced: str, number: int, new: list[Block]
    ) -> None:
        """Put a line of a generated command into the same command."""
        item = line.strip()
        command = next((block for block in new if block.key == key), None)
        if self.foreign(self._translated(item)):
            return
        if command and replaced.strip() and replaced in command.lines:
            command.lines[command.lines.index(replaced)] = line
            self._note(number, line, item)
        elif command and not replaced and (at := _index(command.lines, before)) is not None:
            command.lines.insert(at + 1, line)
            self._note(number, line, item)

    def _part(self, key: str, item: _Item) -> str:
        """Put a library or a source to the target that stands for another one."""
        package = re.match(r"(?:\$\{)?(\w+)(?:_TARGETS\}|::\w+)$", item.name)
        if package and f"  {package[1]}\n" in self.catkin:  # which links all of its components
            return package[1]
        is_sort = key.startswith("add_") and re.fullmatch("[A-Z_]+", item.name)
        command = self._same_target(key)
        if command is None or is_sort or self.foreign(item.name):
            return ""
        lines = command.lines
        public = _index(lines, "  PUBLIC\n")
        at = len(lines) - 1 if public is None else public + 1
        lines.insert(at, f"{'  ' if public is None else '    '}{item.text}\n")
        return item.text

    def _same_target(self, key: str) -> Block | None:
        """Return the command of now about the parts of a target."""
        name, _, target = re.sub(r" #\d+$", "", key).partition(" ")
        names = _PARTS[:1] if name in _PARTS[:1] else _PARTS[1:]
        return self._named(*(f"{one} {target}" for one in names))

    def _listed(self, name: str, word: str, text: str, like: str = "") -> str:
        """Put an item below those like it in a command, or below a word, which is put there.

        Return the item. A list of files is made where there is none, if it has a use.
        """
        command = next((block for block in self.new if block.key.startswith(name)), None)
        if command is None:
            users = (i for i, b in enumerate(self.new) if b.key.startswith("generate_messages"))
            if (at := next(users, None)) is None:
                return ""
            made = [f"\n{name}(\n", f"  {word}\n", f"    {text}\n", ")\n"]
            self.new.insert(at, Block(f"{name} {word}", made))
            return text
        lines = command.lines
        if not any(word in line for line in lines):
            lines.insert(len(lines) - 1, f"  {word}\n")
        last = [i for i, line in enumerate(lines) if like and line.strip().endswith(like)]
        at = last[-1] if last else _index_of(lines, word or name)
        blanks = margin(lines[at]) if last else 4 if word and not like else 2
        if not any(line.strip() == text.partition("#")[0].rstrip() for line in lines[at:]):
            lines.insert(at + 1, f"{' ' * blanks}{text}\n")
        return text

    def _below_packages(self) -> int:
        return max(i for i, b in enumerate(self.new) if b.key.startswith("find_package")) + 1

    def _package(self, item: _Item) -> str:
        """Find a package, and link every target of a node with it, as catkin does."""
        name, key = item.name, f"find_package {item.name}"
        text = f"find_package({name} REQUIRED){item.comment}"
        if not self._named(key):
            self.new.insert(self._below_packages(), Block(key, [f"{text}\n"]))
            for command in self.new:
                public = _index(command.lines, "  PUBLIC\n")
                if command.key.startswith("target_link_libraries ${PROJECT_NAME}_") and public:
                    command.lines.insert(public + 1, f"    ${{{name}_TARGETS}}\n")
        return text

    def _component(self, name: str) -> bool:
        """Make a package a component of catkin, if it can be one."""
        line = f"  {name}\n"
        can_be = self.catkin[1:] and re.fullmatch(_KNOWN["components"], name)
        if can_be and line not in self.catkin:
            self.catkin.insert(_index_of(self.catkin, "COMPONENTS") + 1, line)
        return line in self.catkin

    def _as_entry(self, installed: re.Match[str]) -> str:
        """Put what CMake installs into setup.py; return the line there."""
        kind, files, place = installed.groups()
        base = next((key for key, value in _PROJECT.items() if value == place), None)
        names = files.split()
        if not base or "$" in files or (kind == "DIRECTORY" and (len(names) > 1 or base == "lib")):
            return ""
        if kind == "DIRECTORY":
            return self._in_setup(f"*installed('{names[0].rstrip('/')}'),")
        listed = ", ".join(repr(name) for name in names)
        return self._in_setup(f"('{base}/' + package_name, [{listed}]),")

    def _in_setup(self, entry: str) -> str:
        end = self.setup.index("    ],\n", _index_of(self.setup, "data_files=["))
        self.setup.insert(end, f"        {entry}\n")
        return entry

    def _entry(self, number: int, line: str) -> None:
        """Put a line of setup.py about what is installed into CMake, or into setup.py."""
        found = _ENTRY.fullmatch(line.strip())
        directory = self._named("install DIRECTORY")
        if not found or directory is None:
            return
        whole, base, folder, files = found.groups()
        folder = whole or folder
        if whole or (folder and base == "share" and files.startswith("glob")):
            at = max(i for i, text in enumerate(directory.lines) if text.startswith("    "))
            directory.lines.insert(at + 1, f"    {folder}\n")
            self._note(number, line, folder)
        elif not folder:
            kind = "PROGRAMS" if base == "lib" else "FILES"
            names = " ".join(re.findall(r"'([^']+)'", files))
            text = f"install({kind} {names} DESTINATION {_PROJECT[base]})\n"
            at = self.new.index(directory) + 1
            self.new.insert(at, Block(f"own {number}", ["\n", self._translated(text)]))
            self._note(number, line, self._translated(text).strip())

    def _note(self, number: int, text: str, as_what: str) -> None:
        for i, line in enumerate(split(text)):
            if line.strip() and (line.lstrip()[0] != "#" or line.strip() == as_what):
                self.lines[number + i] = (as_what,)


def _name(key: str) -> str:
    """Return the command of a block."""
    return key.partition(" ")[0]


def _items(key: str, text: str) -> list[_Item]:
    """Return the arguments of a list."""
    name, keyword = _name(key), ""
    found: list[_Item] = []
    for part in _ARGUMENT.finditer(text):
        at, word = text.count("\n", 0, part.start()), part[0]
        if part["comment"] and found and found[-1].at == at:
            found[-1] = found[-1]._replace(comment=word)
        elif not part["head"]:
            # A part of a target may be a library that is called GL.
            is_other = name not in _PARTS and re.fullmatch("[A-Z_]+", word)
            keyword = word if is_other or word in _KNOWN["items"][name] else keyword
            found.append(_Item(at, keyword, word.strip()))
    return found


def _own_lines(mine: Sequence[str], old: Sequence[str]) -> Iterator[tuple[int, str, str, str]]:
    """Yield each line of the developer's: its place, itself, the one before, the one replaced."""
    for start, end, first, last in changed(old, mine):
        for at in range(first, last):
            same = start + at - first
            replaced = old[same] if same < end else ""
            if mine[at].strip():
                yield at, mine[at], mine[at - 1] if at else "", replaced


def _index(lines: Sequence[str], line: str) -> int | None:
    return next((i for i, found in enumerate(lines) if found.strip() == line.strip()), None)


def _index_of(lines: Sequence[str], part: str) -> int:
    return next((i for i, line in enumerate(lines) if part in line), 0)
