"""Make a package of this collection from one of the original generator.

    python scripts/adopt.py old/arm new/arm --ros-distro noetic

The original generator keeps a developer's code between two comments:

    # protected region user update begin #
    # protected region user update end #

Each such region is put, line by line as it is, where adopt.yaml says; that place is found by the
structure of the file: a function, a class, a command. What has none is listed, and kept in
NOT_PLACED.md. The original package is only read.
"""

from __future__ import annotations

import argparse
import ast
import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import copier
import yaml
from copier.errors import CopierError

ROOT = Path(__file__).resolve().parents[1]
RULES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
MODELS = list(RULES["renamed"])
KEPT = ".gen_maintain"
REST = "NOT_PLACED.md"
_NODE = re.compile(r"## (?:Node|Component):?\s+(\w+)|target_link_libraries\s*\(\s*(\w+)")
_MARK = re.compile(
    r"\s*[^\w\s]{1,5}\s*protected region\s+(?P<name>\S.*?)\s+(?P<end>begin|end)\s*[^\w\s]*\s*"
)


class AdoptError(Exception):
    """What is wrong with the folders given, for the user, in a sentence that ends with its id."""

    def __init__(self, text: str, id_: str) -> None:
        super().__init__(f"{text} [{id_}]")


@dataclass(frozen=True)
class Region:
    """A protected region: its file in the original package, its name and its code."""

    file: str
    name: str
    first: int  # the line number of its first line
    lines: tuple[str, ...]
    node: str = ""  # the node whose section of a README or target of CMake it stands in

    def __str__(self) -> str:
        last = self.first + len(self.lines) - 1
        span = f"{self.first}-{last}" if last > self.first else f"{self.first}"
        return f'{self.file}:{span} "{self.name}"'


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

    Without `model`, the logic's language decides. Either the whole package is made or nothing.

    Raises:
        AdoptError: a folder, or the spec or a file in it, is not as it must be.
        OSError: a file cannot be read or written.

    """
    if not legacy.is_dir():
        what = f"{legacy}: no such folder; it must be a package of the original"
        raise AdoptError(what, "not-a-folder")
    if new.exists() or new.is_symlink():
        what = f"{new}: is there already; nothing is written over it"
        raise AdoptError(what, "path-taken")
    if legacy.resolve() in new.resolve().parents:
        what = f"{new}: is inside {legacy}, which must stay as it is"
        raise AdoptError(what, "path-taken")
    spec = _find_spec(legacy)
    model = model or _choose_model(legacy)
    new.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=new.parent, prefix=".adopt-") as temporary:
        folder = Path(temporary, "package")
        report = Report(model=model)
        source = _without_dynamic(spec, Path(temporary).resolve(), report)
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
    found = sorted(legacy.glob("model/*.ros_package")) or sorted(legacy.glob("*.ros_package"))
    if not found:
        what = f"{legacy}: has no model/*.ros_package, the spec of the original generator"
        raise AdoptError(what, "lost-spec")
    if len(found) > 1:
        names = ", ".join(str(file.relative_to(legacy)) for file in found)
        raise AdoptError(f"{legacy}: one spec is needed, found {names}", "several-specs")
    return found[0]


def _choose_model(legacy: Path) -> str:
    """Return the model for the language of the package's logic."""
    logic = {"python_model": "src/*/*_impl.py", "cpp_model": "common/src/*_common.cpp"}
    found = [model for model, pattern in logic.items() if any(legacy.glob(pattern))]
    if len(found) != 1:
        what = f"{legacy}: say with --model which it is; allowed: {', '.join(MODELS)}"
        raise AdoptError(what, "unknown-language")
    return found[0]


def _without_dynamic(spec: Path, folder: Path, report: Report) -> Path:
    """Return the spec, or of a service server a copy whose parameters are static.

    It has no `update` here, and only `update` receives a dynamic parameter.
    """
    old = spec.read_bytes()
    new, number = re.subn(rb"(</?)dynParameter\b", rb"\1parameter", old)
    if not number or not re.search(rb"template\s*=\s*.\w+_service_server\b", old):
        return spec
    report.notes.append("without update, nothing gets a dynParameter: it is a parameter now")
    (folder / spec.name).write_bytes(new)
    return folder / spec.name


def _render(source: Path, spec: Path, folder: Path, model: str, distro: str) -> dict[str, Any]:
    """Make the new package by Copier, and return the context of its spec."""
    data = {"model": model, "ros_distro": distro, "spec_file": str(source)}
    try:
        copier.run_copy(str(ROOT), folder, data=data, defaults=True, unsafe=True, quiet=True)
    except (CopierError, ValueError) as error:
        fault: Any = error.__cause__
        if hasattr(fault, "id"):
            raise AdoptError(fault.text.replace(str(source), str(spec)), fault.id) from error
        raise AdoptError(str(error), "not-rendered") from error
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
            if _matched(RULES["written"], name) is None:
                report.left.append(f"{name}: neither written by the original nor in {KEPT}")
            continue
        target = _moved(name, report)
        if (folder / target).exists() or (folder / target).is_symlink():
            if _matched(RULES["written"], name) is None:
                report.left.append(f"{name}: the model makes {target}")
            continue
        (folder / target).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(legacy / name, folder / target, follow_symlinks=False)
        copied.add(name)
        report.copied.append(name if name == target else f"{name} -> {target}")
    return copied


def _moved(name: str, report: Report) -> str:
    for rule in RULES["moved"][report.model].items():
        pattern, folder = (text.replace("<package>", report.package) for text in rule)
        if re.search(pattern, name):
            return re.sub(pattern, folder, name)
    return name


def _files(legacy: Path, top: Path) -> Iterator[str]:
    """Yield the files at or below `top`, relative to the package; not git's, nor compiled ones."""
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
        if not region and (heading := _NODE.match(line)):
            node = heading[1] or heading[2]
        mark = _MARK.fullmatch(line)
        if not mark:
            continue
        if mark["end"] == "begin" and not region:
            region, start = mark["name"], number
        elif mark["end"] == "end" and region == mark["name"]:
            code = [n for n in range(start, number - 1) if lines[n].strip()]
            if code:
                text = tuple(lines[code[0] : code[-1] + 1])
                yield Region(name, region, code[0] + 1, text, node)
            region, start = "", 0
        else:
            found, what = (region, "end") if region else (mark["name"], "beginning")
            what = f'protected region "{found}" has no {what}'
            raise AdoptError(f"{file}:{start or number}: {what}", "open-region")
    if region:
        what = f'{file}:{start}: protected region "{region}" has no end'
        raise AdoptError(what, "open-region")


def _imports(legacy: Path, regions: list[Region]) -> Iterator[Region]:
    """Yield the imports that the original itself wrote into a file and that its regions use."""
    for file in sorted({region.file for region in regions if region.file.endswith("_impl.py")}):
        code = [line for region in regions if region.file == file for line in region.lines]
        words = set(re.findall(r"\w+", "\n".join(code)))
        for number, line in enumerate(_lines(legacy / file), 1):
            statement = re.fullmatch(r"(?:from [\w.]+ )?import ([\w, ]+)", line)
            if statement and line not in code and words & set(re.findall(r"\w+", statement[1])):
                yield Region(file, "imports", number, (line,))


class _Part(NamedTuple):
    """Lines of a file, counted from 0 and up to before `last`; and what is inside of them."""

    first: int
    start: int
    end: int
    last: int


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
        try:
            file, edit = _edit(region, folder, context, report.model)
        except NoPlaceError as why:
            report.rest.append((region, str(why)))
        else:
            edits.setdefault(file, []).append(edit)
    for file, found in edits.items():
        _write(folder / file, file, found, report)


class NoPlaceError(Exception):
    """Why a region's code is not in a file of the new package."""


def _edit(region: Region, folder: Path, context: dict[str, Any], model: str) -> tuple[str, _Edit]:
    """Return the file that takes a region's code, and how."""
    rule, about = rule_for(region)
    place = rule["to"].get(model) or rule["to"].get("any")
    is_code_of_it = not re.search(rule.get("not", "(?!)"), "\n".join(region.lines))
    if not place or not is_code_of_it or context["ros"] not in rule.get("ros", [1, 2]):
        raise NoPlaceError(rule.get("why", f"{model} has no place for it in ROS {context['ros']}"))
    node, name = about.get("node") or region.node, about.get("name") or ""
    if region.file == "README.md" and about:
        node, name = _documented(region, about, context)
    name = name.lstrip("~/").replace("/", "_")
    for word, text in {"package": context["name"], "node": node, "name": name}.items():
        place = place.replace(f"<{word}>", text)
    part_name, _, file = place.rpartition(" in ")
    where, wanted = re.split(" (?!of )", part_name, maxsplit=1)
    if not (folder / file).is_file():
        raise NoPlaceError(f"there is no {file}")
    try:
        part = _PARTS[Path(file).suffix](_lines(folder / file), wanted)
    except NoPlaceError:
        raise NoPlaceError(f"{file} has no place for it") from None
    title = (f"`{name}`:", "") if region.file == "README.md" and name else ()
    return file, {
        "above": _Edit(part.first, part.first, region, title, ("",)),
        "below": _Edit(part.last, part.last, region, ("", *title)),
        "start of": _Edit(part.start, part.start, region),
        "end of": _Edit(part.end, part.end, region),
        "body of": _Edit(part.start, part.end, region),
    }[where]


def rule_for(region: Region) -> tuple[dict[str, Any], dict[str, str]]:
    """Return the rule for a region, and what its file and its name say: node, kind, name.

    Raises:
        NoPlaceError: there is none.

    """
    for rule in RULES["regions"]:
        file = _matched(rule["from"], region.file)
        if file is not None and (name := _matched(rule["region"], region.name)) is not None:
            return rule, file | name
    raise NoPlaceError("no such region of such a file is known")


def _matched(patterns: str | list[str], text: str) -> dict[str, str] | None:
    """Return what the words in angle brackets of the pattern that fits stand for, if one does."""
    for pattern in [patterns] if isinstance(patterns, str) else patterns:
        groups = re.sub(r"<(\w+)>", r"(?P<\1>\\w+)", re.escape(pattern))
        groups = groups.replace(r"<kind>\w+", f"<kind>{'|'.join(RULES['kinds'])}")
        if match := re.fullmatch(groups.replace(r"<name>\w+", "<name>.+"), text):
            return match.groupdict()
    return None


def _is_in_spec(region: Region, context: dict[str, Any]) -> bool:
    """Say whether a region of the README only repeats a description of the spec."""
    items = [
        item
        for node in context["nodes"]
        for kind in node.values()
        if isinstance(kind, list)
        for item in kind
    ]
    texts = [item.get("description", "") for item in [context, *items]]
    return " ".join(region.lines).split() in [text.split() for text in texts]


def _documented(
    region: Region, about: Mapping[str, str], context: dict[str, Any]
) -> tuple[str, str]:
    """Return the node and the interface that a region of the README describes.

    A region with one word for its name is about a node, or in old packages about a subscriber.
    """
    wanted = about.get("name") or about["node"]
    if about.get("node") in [node["name"] for node in context["nodes"]]:
        return wanted, ""
    keys = RULES["kinds"][about.get("kind", "subscriber")]
    for node in context["nodes"]:
        names = [item["name"] for key in keys for item in node[key]]
        if node["name"] == region.node and wanted in names:
            return region.node, wanted
    raise NoPlaceError(f"the spec has no {wanted} there")


def _python_part(lines: list[str], name: str) -> _Part:
    """Find the imports, the class, or a function by its name."""
    tree = ast.parse("\n".join(lines))
    for node in reversed(tree.body if name == "imports" else list(ast.walk(tree))):
        if name == "imports" and isinstance(node, ast.Import | ast.ImportFrom):
            return _Part(
                node.lineno - 1, node.lineno - 1, node.end_lineno or 0, node.end_lineno or 0
            )
        if isinstance(node, ast.ClassDef if name == "class" else ast.FunctionDef) and (
            name in ("class", node.name)
        ):
            start, end = node.body[0].lineno - 1, node.body[-1].end_lineno or 0
            if ast.get_docstring(node) is not None:
                start = node.body[0].end_lineno or 0
            return _Part(node.lineno - 1, start, end, end)
    raise NoPlaceError


def _cpp_part(lines: list[str], name: str) -> _Part:
    """Find the includes, the members with an access specifier, or a function's definition."""
    code = [re.sub("//.*", "", line).rstrip() for line in lines]
    if name == "includes":
        last = len(lines) - _search(code[::-1], "#include .*")[0]
        return _Part(0, 0, last, last)
    if name in ("public", "private"):
        first, closing = _search(code, f"{name}:", r"\w+:|\};")
        end = _trimmed(lines, closing)
        return _Part(first, first + 1, end, end)
    function = r"(\w+)::\1" if name == "constructor" else rf"\w+::{name}"
    first, opening, closing = _search(code, rf"(?:\S.* )?{function}\(.*", r"\{", r"\}")
    return _Part(first, opening + 1, closing, closing + 1)


def _cmake_part(lines: list[str], name: str) -> _Part:
    """Find a command by its beginning, or all there is."""
    if name == "everything":
        return _Part(0, 0, len(lines), _trimmed(lines, len(lines)))
    (first,) = _search(lines, f"{re.escape(name)}.*")
    (length,) = _search(lines[first:], r"[^#]*\)")
    return _Part(first, first + 1, first + length, first + length + 1)


def _xml_part(lines: list[str], name: str) -> _Part:
    """Find the first element that begins so."""
    (first,) = _search(lines, rf"\s*{name}.*")
    return _Part(first, first, first + 1, first + 1)


def _markdown_part(lines: list[str], name: str) -> _Part:
    """Find the introduction, or a section's heading and first paragraph."""
    if name == "introduction":
        end = _trimmed(lines, _search(lines, "## .*")[0])
        return _Part(0, 0, end, end)
    word = name.removeprefix("section ")
    first, start, end = _search(lines, rf"## \S.* {word}", r".*\S.*", r"\s*")
    return _Part(first, start, end, end)


_PARTS: Mapping[str, Callable[[list[str], str], _Part]] = {
    ".py": _python_part,
    ".hpp": _cpp_part,
    ".cpp": _cpp_part,
    ".txt": _cmake_part,
    ".xml": _xml_part,
    ".md": _markdown_part,
}


def _trimmed(lines: list[str], end: int) -> int:
    """Return where the empty lines before line `end` begin."""
    while end and not lines[end - 1].strip():
        end -= 1
    return end


def _search(lines: list[str], *patterns: str) -> list[int]:
    """Return the first line of each pattern, below that of the one before it."""
    found: list[int] = []
    for pattern in patterns:
        below = range(found[-1] + 1 if found else 0, len(lines))
        found += [number for number in below if re.fullmatch(pattern, lines[number])][:1]
    if len(found) < len(patterns):
        raise NoPlaceError
    return found


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
        for region, pattern, old, new in RULES["renamed"][report.model]:
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
        yield "\nThe code is as it was. What has another name now:"
        for change, places in report.look.items():
            yield f"  {change}: {', '.join(places)}"
    yield f"\n{new} is made with {report.model}. Read it, then commit it to git."


def main() -> int:
    """Adopt what the command line names."""
    parser = argparse.ArgumentParser(description="Adopt a package of the original generator.")
    parser.add_argument(
        "legacy",
        type=Path,
        metavar="LEGACY_FOLDER",
        help="the original package, which is only read",
    )
    parser.add_argument(
        "new", type=Path, metavar="NEW_FOLDER", help="the new package; must not exist yet"
    )
    parser.add_argument(
        "--model", default="", choices=MODELS, help="default: that of the language of its logic"
    )
    parser.add_argument(
        "--ros-distro", default="noetic", help="of the new package; default: noetic"
    )
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
