"""Make a package of this collection from one of the original generator.

    python scripts/adopt.py old/arm new/arm --ros-distro noetic

The original generator keeps a developer's code between two comments:

    # protected region user update begin #
    # protected region user update end #

Each such region is put, line by line as it is, where this collection's package has a place for it.
What has none is listed, and kept in NOT_PLACED.md. The original package is only read.
"""

from __future__ import annotations

import argparse
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import copier
import yaml
from copier.errors import CopierError

ROOT = Path(__file__).resolve().parents[1]
KEPT = ".gen_maintain"
REST = "NOT_PLACED.md"


class AdoptError(Exception):
    """What is wrong with the folders given, for the user."""


@dataclass(frozen=True)
class Region:
    """A protected region: its file in the original package, its name and its code."""

    file: str
    name: str
    first: int  # the line number of its first line
    lines: tuple[str, ...]
    node: str = ""  # in a README: the node whose section it stands in

    def __str__(self) -> str:
        last = self.first + len(self.lines) - 1
        span = f"{self.first}-{last}" if last > self.first else f"{self.first}"
        return f'{self.file}:{span} "{self.name}"'


@dataclass(frozen=True)
class Place:
    """Where code goes in a file: at the line that the last of some patterns finds.

    Each pattern is searched from the line on that the one before it found. In `file` and `steps`,
    the words PACKAGE, NODE and NAME stand for what a region is about.
    """

    file: str
    steps: tuple[str, ...]
    where: Literal["after", "before", "instead", "end"] = "after"
    gap: bool = False  # whether an empty line parts the code from what is there
    unless: str = ""  # a pattern of code that would not work there
    why: str = ""


# For each model: a pattern of a file, a pattern of a region in it, and the place of its code.
Places = Sequence[tuple[str, str, Place]]
_NODE = "README.md", ("^## Node NODE$", "^Runs its logic")
_BUILD: Places = (
    (
        r"README\.md",
        "package descripi?t?ion",
        Place("README.md", ("^Rounded: topics",), gap=True),
    ),
    (r"README\.md", r"(?P<node>\w+)", Place(*_NODE, gap=True)),
    (
        r"README\.md",
        "(?P<kind>param|(direct )?(publisher|subscriber)|(service|action) (server|client))"
        " (?P<name>.+)",
        Place(*_NODE, gap=True),
    ),
    (
        r"CMakeLists\.txt",
        "additional user defined REQUIREMENTS",
        Place("CMakeLists.txt", (r"^find_package\(catkin REQUIRED", r"\)$"), gap=True),
    ),
    (
        r"CMakeLists\.txt",
        "additional user defined BUILD STATEMENTS",
        Place("CMakeLists.txt", (r"^find_package\(catkin", r"^install\("), "before", gap=True),
    ),
    (
        r"CMakeLists\.txt",
        "user Cmake macros",
        Place("CMakeLists.txt", (r"^find_package\(catkin",), "end", gap=True),
    ),
    (
        r"package\.xml",
        "additional package statements",
        Place(
            "package.xml",
            (r"<test_depend>",),
            "before",
            gap=True,
            unless="<(run_depend|buildtool_depend|export)\\b",
            why="package.xml has format 3 here, with exec_depend for run_depend and one export;"
            " the spec's <depend> is another way to name a package",
        ),
    ),
)
_PYTHON = "PACKAGE/NODE_impl.py"
_HEADER, _SOURCE = "include/PACKAGE/NODE_impl.hpp", "src/NODE_impl.cpp"
_OF_PYTHON = r"src/\w+/(?P<node>\w+)_impl\.py"
_OF_CPP = r"common/src/(?P<node>\w+)_common\.cpp"
_CALLBACK = "user implementation of %s callback for (?P<name>.+)"
PLACES: Mapping[str, Places] = {
    "python_model": (
        *(
            (_OF_PYTHON, region, place)
            for region, place in (
                (
                    "imports|user include package",
                    Place(_PYTHON, (r"^from PACKAGE\.NODE_interface", r"^\)"), gap=True),
                ),
                (
                    "user member variables",
                    Place(_PYTHON, (r"def __init__\(", r"self\.passthrough = passthrough")),
                ),
                (
                    "user configure",
                    Place(_PYTHON, (r"def configure\(", "^ {8}return True$"), "instead"),
                ),
                ("user update", Place(_PYTHON, (r"def update\(", '"""'))),
                (
                    _CALLBACK % "direct subscriber",
                    Place(_PYTHON, (r"def receive_NAME\(", '"""')),
                ),
                (_CALLBACK % "service", Place(_PYTHON, (r"def serve_NAME\(", '"""'))),
                (
                    _CALLBACK % "action",
                    Place(_PYTHON, (r"def execute_NAME\(", r"goal\.succeed\(\)"), "instead"),
                ),
                ("user additional functions", Place(_PYTHON, ("^class ",), "end", gap=True)),
            )
        ),
        *_BUILD,
    ),
    "cpp_model": (
        *(
            (_OF_CPP, region, place)
            for region, place in (
                ("user include files", Place(_HEADER, ('NODE_interface.hpp"$',), gap=True)),
                ("user member variables", Place(_HEADER, ("^private:", "passthrough_;"))),
                ("user constructor", Place(_SOURCE, ("Impl::", r"^\{"))),
                ("user destructor", Place(_SOURCE, (r"Impl::cleanup\(", r"^\{"))),
                ("user configure", Place(_SOURCE, (r"Impl::configure\(", r"^\{"))),
                ("user update", Place(_SOURCE, (r"Impl::update\(", r"^\{"))),
                (
                    _CALLBACK % "direct subscriber",
                    Place(_SOURCE, (r"Impl::receive_NAME\(", r"^\{")),
                ),
                (_CALLBACK % "service", Place(_SOURCE, (r"Impl::serve_NAME\(", r"^\{"))),
                (
                    _CALLBACK % "action",
                    Place(_SOURCE, (r"Impl::execute_NAME\(", r"goal\.succeed\(\)"), "instead"),
                ),
                ("user additional functions", Place(_HEADER, (r"void cleanup\(",), gap=True)),
            )
        ),
        *_BUILD,
    ),
}

MODELS = [model for model in PLACES if (ROOT / model).is_dir()]

# For each model: a pattern of regions, a pattern in their code, the old name and the new one.
_ANY, _CALLS = "user ", "user implementation of %s "
RENAMED: Mapping[str, Sequence[tuple[str, str, str, str]]] = {
    "python_model": (
        (_ANY, r"\brospy\.log", "rospy.loginfo(text)", "self.passthrough.log.info(text)"),
        (_ANY, r"\brospy\.(Time|get_)", "rospy.Time.now()", "self.passthrough.stamp()"),
        (_ANY, r"\brospy\b(?!\.(log|Time|get_))", "rospy", "nothing; it is ROS 1 alone"),
        (_ANY, r"\.client_\w+\(", "client_NAME(request)", "client_NAME.call(request, timeout)"),
        (_ANY, r"\.ac_\w+", "passthrough.ac_NAME", "passthrough.action_NAME"),
        (_ANY, r"\.as_\w+", "passthrough.as_NAME", "goal, the callback's argument"),
        (_ANY, r"\.sub_\w+", "passthrough.sub_NAME", "receive_NAME(message)"),
        (
            _ANY,
            r"passthrough\.(?!(client|ac|as|sub|pub)_)\w+\.(lookup|send|wait|can|transform)",
            "passthrough.NAME, of tf",
            "passthrough.listener_NAME, passthrough.broadcaster_NAME",
        ),
        (_ANY, r"\w+Implementation\b", "class NODEImplementation", "class NODEImpl"),
        (_ANY, r"\bdirect_topic_callback_", "direct_topic_callback_NAME", "receive_NAME"),
        (_ANY, r"\.callback_", "callback_NAME", "serve_NAME, execute_NAME"),
        (_CALLS % "service", r"\breq\b", "req", "request"),
        (_CALLS % "service", r"\bresult\b", "result", "response"),
        (_CALLS % "action", r"\bgoal\.", "goal.FIELD", "goal.request.FIELD"),
        (_CALLS % "action", r"\bfeedback\b", "feedback", "goal.feedback"),
        (_CALLS % "action", r"\bresult\b", "result", "goal.result"),
        (_CALLS % "direct", r"\bmsg\b", "msg", "message"),
    ),
    "cpp_model": (
        (
            _ANY,
            r"\bROS_(DEBUG|INFO|WARN|ERROR|FATAL)",
            "ROS_INFO(...)",
            "passthrough_.log.info(text)",
        ),
        (_ANY, r"\bros::", "ros::Time::now()", "passthrough_.now()"),
        (
            _ANY,
            r"\bpassthrough\.client_",
            "passthrough.client_NAME.call(service)",
            "passthrough_.client_NAME->call(request, timeout)",
        ),
        (_ANY, r"\bpassthrough\.ac_", "passthrough.ac_NAME", "passthrough_.action_NAME"),
        (
            _ANY,
            r"\bpassthrough\.(?!(client|ac)_)",
            "passthrough.NAME",
            "passthrough_.pub_NAME, listener_NAME, broadcaster_NAME",
        ),
        ("user destructor", r"\S", "the destructor", "cleanup()"),
        (_ANY, r"\bdirectTopicCallback_", "directTopicCallback_NAME", "receive_NAME"),
        (_ANY, r"\bcallback_", "callback_NAME", "serve_NAME, execute_NAME"),
        (_CALLS % "service", r"\breq\b", "req", "request"),
        (_CALLS % "service", r"\bres\b", "res", "response"),
        (_CALLS % "service", r"\breturn\b", "return true", "return; serve_NAME is void"),
        (_CALLS % "service", r"\bconfig\b", "config", "a copy that configure or update makes"),
        (_CALLS % "action", r"\bgoal->", "goal->FIELD", "goal.request.FIELD"),
        (_CALLS % "action", r"\bas_", "as_", "goal"),
        (_CALLS % "direct", r"\bmsg\b", "msg->FIELD", "message.FIELD"),
    ),
}

# For each model: where a kept file goes that stood in a folder this collection does not have.
MOVED: Mapping[str, Sequence[tuple[str, str]]] = {
    "python_model": (("^src/PACKAGE/", "PACKAGE/"),),
    "cpp_model": (
        (r"^common/(src|include)/(PACKAGE/)?(?=.*\.(h|hh|hpp|hxx|ipp)$)", "include/PACKAGE/"),
        ("^common/src/", "src/"),
    ),
}

# The files the original generator writes; of these, only the protected regions are a developer's.
_WRITTEN = re.compile(
    r"CMakeLists\.txt|package\.xml|setup\.py|README\.md|\.gen_maintain|cfg/\w+\.cfg"
    r"|model/\w+\.ros_package|scripts/\w+|src/\w+/(__init__|\w+_(impl|ros))\.py"
    r"|common/src/\w+_common\.cpp|ros/src/\w+_ros\.cpp|test/test_\w+\.test"
)
_MARK = re.compile(
    r"\s*[^\w\s]{1,5}\s*protected region\s+(?P<name>\S.*?)\s+(?P<end>begin|end)\s*[^\w\s]*\s*"
)
_KINDS = {
    "param": ("parameters", "dynParameters"),
    "publisher": ("publishers",),
    "subscriber": ("subscribers",),
    "direct publisher": ("directPublishers",),
    "direct subscriber": ("directSubscribers",),
    "service server": ("serviceServers",),
    "service client": ("serviceClients",),
    "action server": ("actionServers",),
    "action client": ("actionClients",),
}


@dataclass
class Report:
    """What became of the original package, one text an item."""

    package: str = ""
    model: str = ""
    notes: list[str] = field(default_factory=list)
    placed: list[str] = field(default_factory=list)
    rest: list[tuple[Region, str]] = field(default_factory=list)
    copied: list[str] = field(default_factory=list)
    left: list[str] = field(default_factory=list)
    look: dict[str, list[str]] = field(default_factory=dict)


def adopt(legacy: Path, new: Path, model: str = "", distro: str = "noetic") -> Report:
    """Make the package `new` from the original generator's package `legacy`.

    Without `model`, the template that the spec names decides. Either the whole package is made
    or nothing.

    Raises:
        AdoptError: a folder or what is in it is not as it must be.
        CopierError: the hook found a fault in the spec.
        OSError: a file cannot be read or written.

    """
    if not legacy.is_dir():
        raise AdoptError(f"{legacy}: no such folder; it must be a package of the original")
    if new.exists() or new.is_symlink():
        raise AdoptError(f"{new}: is there already; nothing is written over it")
    if legacy.resolve() in new.resolve().parents:
        raise AdoptError(f"{new}: is inside {legacy}, which must stay as it is")
    spec = _find_spec(legacy)
    template = _template(spec)
    model = model or _choose_model(legacy, template)
    new.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=new.parent, prefix=".adopt-") as temporary:
        folder = Path(temporary, "package")
        report = Report(model=model)
        source = _with_frequency(spec, template, Path(temporary), report)
        context = _render(source, spec, folder, model, distro)
        report.package = str(context["name"])
        kept = _copy_kept(legacy, folder, report)
        regions = list(_regions(legacy, kept))
        if context["ros"] == 1:
            regions = [*_imports(legacy, regions), *regions]
        _place(regions, folder, context, report)
        _write_rest(folder, report)
        folder.rename(new)
    return report


def _find_spec(legacy: Path) -> Path:
    """Return the spec, which the original keeps in `model/`."""
    for pattern in ("model/*.ros_package", "*.ros_package"):
        found = sorted(legacy.glob(pattern))
        if len(found) == 1:
            return found[0]
        if found:
            names = ", ".join(str(file.relative_to(legacy)) for file in found)
            raise AdoptError(f"{legacy}: one spec is needed, found {names}")
    raise AdoptError(f"{legacy}: has no model/*.ros_package, the spec of the original generator")


def _template(spec: Path) -> str:
    """Return the name of the original's template that a spec asks for, if it does."""
    try:
        return ElementTree.parse(spec).getroot().get("template", "")
    except ElementTree.ParseError as error:
        raise AdoptError(f"{spec}:{error.position[0]}: not well-formed XML: {error}") from None


def _choose_model(legacy: Path, template: str) -> str:
    is_python = template.startswith("python") or any(legacy.glob("src/*/*_impl.py"))
    is_cpp = template.startswith("cpp") or any(legacy.glob("common/src/*_common.cpp"))
    if is_python == is_cpp:
        raise AdoptError(f"{legacy}: say with --model which it is; allowed: {', '.join(MODELS)}")
    model = "python_model" if is_python else "cpp_model"
    if model not in MODELS:
        raise AdoptError(f"{legacy}: needs {model}, which is not here: {', '.join(MODELS)}")
    return model


def _with_frequency(spec: Path, template: str, folder: Path, report: Report) -> Path:
    """Return the spec, or a copy with the frequencies that a service server had no need of."""
    if not template.endswith("_service_server"):
        return spec
    pattern = rb"<(node|component)\b(?![^>]*\bfrequency\s*=)"
    xml, number = re.subn(pattern, rb'<\1 frequency="1"', spec.read_bytes())
    if number:
        report.notes.append(f'{template} has no update; its nodes got frequency="1"')
    copy = folder / spec.name
    copy.write_bytes(xml)
    return copy


def _render(source: Path, spec: Path, folder: Path, model: str, distro: str) -> dict[str, Any]:
    """Make the new package by Copier, and return the context of its spec."""
    data = {"model": model, "ros_distro": distro, "spec_file": str(source)}
    try:
        copier.run_copy(str(ROOT), folder, data=data, defaults=True, unsafe=True, quiet=True)
    except CopierError as error:
        copy = rf"\S*{re.escape(source.parent.name)}/{re.escape(spec.name)}"
        raise AdoptError(re.sub(copy, lambda _: str(spec), str(error))) from error
    except ValueError as error:
        raise AdoptError(str(error)) from error
    answers = yaml.safe_load((folder / ".copier-answers.yml").read_text(encoding="utf-8"))
    return dict(answers["spec"])


def _copy_kept(legacy: Path, folder: Path, report: Report) -> set[str]:
    """Copy what `.gen_maintain` names, list what is left, and return the files that are copied."""
    marked: set[str] = set()
    listing = legacy / KEPT
    for entry in filter(None, map(str.strip, _lines(listing) if listing.is_file() else [])):
        path = legacy / entry
        if legacy.resolve() not in [path.resolve(), *path.resolve().parents]:
            report.notes.append(f"{KEPT}: {entry} is outside of the package")
        elif not path.exists():
            report.notes.append(f"{KEPT}: {entry} is not there")
        else:
            marked |= set(_files(legacy, path))
    copied: set[str] = set()
    for name in _files(legacy, legacy):
        if name not in marked:
            if not _WRITTEN.fullmatch(name):
                report.left.append(f"{name}: neither written by the original nor in {KEPT}")
            continue
        target = _moved(name, report)
        if (folder / target).exists() or (folder / target).is_symlink():
            if not _WRITTEN.fullmatch(name):
                report.left.append(f"{name}: the model makes {target}")
            continue
        (folder / target).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(legacy / name, folder / target, follow_symlinks=False)
        copied.add(name)
        report.copied.append(name if name == target else f"{name} -> {target}")
    return copied


def _moved(name: str, report: Report) -> str:
    for pattern, folder in MOVED[report.model]:
        pattern, folder = (text.replace("PACKAGE", report.package) for text in (pattern, folder))
        if re.search(pattern, name):
            return re.sub(pattern, folder, name)
    return name


def _files(legacy: Path, top: Path) -> Iterator[str]:
    """Yield the files at or below `top`, relative to the package, without those git has."""
    for path in [top] if top.is_file() or top.is_symlink() else sorted(top.rglob("*")):
        name = path.relative_to(legacy)
        is_junk = {".git", "__pycache__"} & set(name.parts) or name.suffix == ".pyc"
        if not is_junk and (path.is_file() or path.is_symlink()):
            yield name.as_posix()


def _lines(file: Path) -> list[str]:
    """Return the lines of a text, whatever its encoding and its line ends."""
    content = file.read_bytes()
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    return [line.rstrip("\r") for line in text.split("\n")]


def _regions(legacy: Path, copied: set[str]) -> Iterator[Region]:
    """Yield the protected regions that hold something, of all files that are not copied."""
    for name in _files(legacy, legacy):
        file = legacy / name
        if name in copied or not file.is_file():
            continue
        content = file.read_bytes()
        if b"protected region" in content and b"\0" not in content:
            yield from _regions_of(name, _lines(file), file)


def _regions_of(name: str, lines: list[str], file: Path) -> Iterator[Region]:
    """Yield the regions of one file.

    Raises:
        AdoptError: a region has no beginning or no end, so that its code cannot be told.

    """
    region, start, node = "", 0, ""
    for number, line in enumerate(lines, 1):
        if not region and (heading := re.match(r"## (?:Node|Component):?\s+(\w+)", line)):
            node = heading[1]
        mark = _MARK.fullmatch(line)
        if not mark:
            continue
        if mark["end"] == "begin" and not region:
            region, start = mark["name"], number
        elif mark["end"] == "end" and region == mark["name"]:
            code = lines[start : number - 1]
            empty = [not line.strip() for line in code]
            if not all(empty):
                first, last = empty.index(False), len(code) - empty[::-1].index(False)
                yield Region(name, region, start + first + 1, tuple(code[first:last]), node)
            region = ""
        else:
            raise AdoptError(f"{file}:{number}: {_unbalanced(mark['name'], region, start)}")
    if region:
        raise AdoptError(f'{file}:{start}: protected region "{region}" has no end')


def _unbalanced(name: str, region: str, start: int) -> str:
    if region:
        return f'protected region "{region}" of line {start} has no end before this line'
    return f'protected region "{name}" has no beginning'


def _imports(legacy: Path, regions: list[Region]) -> Iterator[Region]:
    """Yield the imports that the original itself wrote into a file and that its regions use."""
    for file in sorted(
        {region.file for region in regions if re.fullmatch(_OF_PYTHON, region.file)}
    ):
        code = [line for region in regions if region.file == file for line in region.lines]
        words = set(re.findall(r"\w+", "\n".join(code)))
        for number, line in enumerate(_lines(legacy / file), 1):
            statement = re.fullmatch(r"(?:from [\w.]+ )?import ([\w, ]+)", line)
            if statement and line not in code and words & set(re.findall(r"\w+", statement[1])):
                yield Region(file, "imports", number, (line,))


@dataclass(frozen=True)
class _Edit:
    """Code to put into a file instead of its lines from `start` to `end`, counted from 0."""

    start: int
    end: int
    region: Region
    above: tuple[str, ...] = ()
    below: tuple[str, ...] = ()


def _place(
    regions: Iterable[Region], folder: Path, context: dict[str, Any], report: Report
) -> None:
    """Put the code of the regions into the files of the new package, which are as rendered."""
    edits: dict[str, list[_Edit]] = {}
    for region in regions:
        if region.file == "README.md" and _is_in_spec(region, context):
            report.placed.append(f"{region} in the spec")
            continue
        place, names, why = _find_place(region, context, report.model)
        file = _filled(place.file, names) if place else ""
        if place and not (folder / file).is_file():
            why = f"there is no {file}"
        elif place:
            edit = _edit(region, place, names, _lines(folder / file))
            if edit:
                edits.setdefault(file, []).append(edit)
                continue
            why = f"{file} has no place for it"
        report.rest.append((region, why))
    for file, found in edits.items():
        _write(folder / file, file, found, report)


def _is_in_spec(region: Region, context: dict[str, Any]) -> bool:
    """Say whether a region of the README only repeats a description of the spec."""
    descriptions = [context["description"]]
    for node in context["nodes"]:
        for items in node.values():
            if isinstance(items, list):
                descriptions += [item.get("description", "") for item in items]
    return " ".join(region.lines).split() in [text.split() for text in descriptions]


def _find_place(
    region: Region, context: dict[str, Any], model: str
) -> tuple[Place | None, dict[str, str], str]:
    """Return a region's place and the names in it, or why it has none."""
    for source, pattern, place in PLACES[model]:
        of_file, of_name = re.fullmatch(source, region.file), re.fullmatch(pattern, region.name)
        if not of_file or not of_name:
            continue
        if place.unless and re.search(place.unless, "\n".join(region.lines)):
            return None, {}, place.why
        about = of_file.groupdict() | of_name.groupdict()
        node, name = about.get("node"), about.get("name")
        if place.file == "README.md" and (node or name):
            node, name = _documented(region, node, about.get("kind"), name, context)
        names = {"PACKAGE": context["name"], "NODE": node or "", "NAME": _identifier(name or "")}
        return place, names, ""
    return None, {}, f"{model} knows no such region of such a file"


def _identifier(name: str) -> str:
    return name.lstrip("~/").replace("/", "_")


def _documented(
    region: Region, word: str | None, kind: str | None, name: str | None, context: dict[str, Any]
) -> tuple[str, str]:
    """Return the node and the interface that a region of the README describes.

    A region with one word for its name is about a node, or in old packages about a subscriber.
    """
    if word in [node["name"] for node in context["nodes"]]:
        return str(word), ""
    wanted = str(name or word)
    keys = _KINDS[kind or "subscriber"]
    nodes = [
        node["name"]
        for node in context["nodes"]
        if any(item["name"] == wanted for key in keys for item in node[key])
    ]
    return (region.node if region.node in nodes else "?"), wanted


def _filled(text: str, names: Mapping[str, str]) -> str:
    return re.sub("PACKAGE|NODE|NAME", lambda word: names[word[0]], text)


def _edit(
    region: Region, place: Place, names: Mapping[str, str], lines: list[str]
) -> _Edit | None:
    """Return the edit that places a region in the lines of a file, if there is a line for it."""
    escaped = {word: re.escape(name) for word, name in names.items()}
    at = 0
    for step in place.steps:
        pattern = _filled(step, escaped)
        at = next((i for i in range(at, len(lines)) if re.search(pattern, lines[i])), len(lines))
    if at == len(lines):
        return None
    gap = ("",) if place.gap else ()
    title = (f"`{names['NAME']}`:", "") if place.file == "README.md" and names["NAME"] else ()
    if place.where == "before":
        return _Edit(at, at, region, title, gap)
    if place.where == "instead":
        return _Edit(at, at + 1, region, title)
    if place.where == "end":
        at = len(lines) - (lines[-1] == "") - 1
    return _Edit(at + 1, at + 1, region, gap + title)


def _write(path: Path, file: str, edits: list[_Edit], report: Report) -> None:
    """Apply the edits of one file, and report where each region's code came to stand."""
    lines = _lines(path)
    written: list[str] = []
    done = 0
    name = ""
    for edit in sorted(edits, key=lambda edit: edit.start):
        written += lines[done : edit.start]
        if not name == edit.region.name == "imports":
            written += edit.above
        name = edit.region.name
        first = len(written) + 1
        written += [*edit.region.lines, *edit.below]
        done = max(done, edit.end)
        report.placed.append(f"{edit.region} in {file}:{first}")
        for region, pattern, old, new in RENAMED[report.model]:
            if re.match(region, edit.region.name):
                for number, line in enumerate(edit.region.lines, first):
                    if re.search(pattern, line):
                        report.look.setdefault(f"{old} -> {new}", []).append(f"{file}:{number}")
    path.write_text("\n".join([*written, *lines[done:]]), encoding="utf-8", newline="")


def _write_rest(folder: Path, report: Report) -> None:
    """Keep what has no place in a file of the new package."""
    if not report.rest and not report.left:
        return
    text = ["# Not placed", "", "What the original package had and this one has no place for."]
    for region, why in report.rest:
        ticks = max([2, *map(len, re.findall("`+", "\n".join(region.lines)))]) + 1
        text += ["", f"## {region}", "", f"{why}.", "", "`" * ticks, *region.lines, "`" * ticks]
    if report.left:
        text += ["", "## Files", "", *(f"- {name}" for name in report.left)]
    (folder / REST).write_text("\n".join([*text, ""]), encoding="utf-8", newline="")


def _told(report: Report, new: Path) -> Iterator[str]:
    """Yield the lines to print."""
    yield from (f"note        {note}" for note in report.notes)
    yield from (f"placed      {text}" for text in report.placed)
    yield from (f"kept        {text}" for text in report.copied)
    yield from (f"LEFT        {text}" for text in report.left)
    yield from (f"NOT PLACED  {region}: {why}" for region, why in report.rest)
    if report.rest or report.left:
        yield f"            see {new / REST}"
    if report.look:
        yield "\nThe code is as it was. What has another name now (docs/developers.md tells more):"
        for change, places in report.look.items():
            yield f"  {change}: {', '.join(places)}"
    yield f"\n{new} is made with {report.model}. Read it, then commit it to git."


def main() -> int:
    """Adopt what the command line names."""
    parser = argparse.ArgumentParser(description="Adopt a package of the original generator.")
    parser.add_argument("legacy", type=Path, metavar="LEGACY_FOLDER", help="it is only read")
    parser.add_argument("new", type=Path, metavar="NEW_FOLDER", help="must not be there yet")
    parser.add_argument("--model", default="", choices=MODELS, help="default: as the spec says")
    parser.add_argument("--ros-distro", default="noetic", help="default: noetic")
    arguments = parser.parse_args()
    try:
        report = adopt(arguments.legacy, arguments.new, arguments.model, arguments.ros_distro)
    except (AdoptError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    print("\n".join(_told(report, arguments.new)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
