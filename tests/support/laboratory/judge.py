"""What became of a package: each line in its function, and the template's side of each file.

The judge reads texts alone. It knows nothing of blocks, and shares no code with the merge.
"""

import ast
import functools
import re
from collections import Counter
from xml.etree import ElementTree

import yaml

CONFLICT = "<<<<<<< before updating"
LINK = "120000"
LAUNCH_FILES = ("launch/lab.launch", "launch/lab.launch.xml")
BUILD_FILES = ("CMakeLists.txt", "setup.py")
COUNTERPARTS = {path: files for files in (LAUNCH_FILES, BUILD_FILES) for path in files}
"""Files that take lines from one another in a move to the other ROS."""


def judge(edited, old, new, tree, said, missing, moves, callbacks):
    """Return the complaints.

    Args:
        edited: what the developer did.
        old, new: the texts of the renders, by path.
        tree: the files of the package after the update, each with `text`, `data` and `mode`.
        said: what the summary says left: `path`, or `path: function` (or key, element, section),
            or a mark.
        missing: what it says the developer has deleted, in the same form.
        moves: the paths that a rename, or the model, gives to paths of before.
        callbacks: the names that a rename gives to functions of before, by path of before.

    """
    complaints = []
    result = {path: file.text for path, file in tree.items() if file.mode != LINK}
    where = {
        path: path if path in edited.moved else moves.get(path, path) for path in edited.texts
    }
    for path in sorted(edited.crlf & {*where}):
        text = result.get(where[path], "")
        if "\n" in edited.texts[path] and text.count("\r\n") != text.count("\n"):
            complaints.append(f"{path}: its line ends have changed")
        result |= {where[path]: text.replace("\r\n", "\n")} if text else {}
    for path, target in edited.links.items():
        file = tree.get(path)
        gone = path in said and path in old and path not in new
        if not gone and (not file or (file.mode, file.data) != (LINK, target.encode())):
            complaints.append(f"{path}: was a link to {target}")
    marks = {}
    for path, text in result.items():
        for mark in set(re.findall(r"\bmine_\d+\b", text)):
            marks.setdefault(mark, []).append(path)
    for mark, (path, function) in edited.lines.items():
        complaints += _line(marks, mark, path, function, where[path], result, said, callbacks)
    is_catkin = ["catkin_package" in side.get("CMakeLists.txt", "") for side in (old, new)]
    for first, (last, name) in edited.around.items() if len(set(is_catkin)) == 1 else ():
        if [len(marks.get(mark, [])) for mark in (first, last)] == [1, 1]:
            complaints += _around(marks, first, last, name, edited, result, callbacks)
    for mark in edited.foreign:
        lines = (line for path in marks.get(mark, []) for line in result[path].split("\n"))
        if any(re.search(rf"\b{mark}\b", line) and "\udce9" not in line for line in lines):
            complaints.append(f"{mark}: its encoding has changed")
    for mark, line in edited.exact.items():
        if mark in edited.lines and line not in "\n".join(result[p] for p in marks.get(mark, [])):
            complaints.append(f"{mark}: a name of another has changed: {line}")
    complaints += _stays_deleted(edited, old, new, result, missing, moves, callbacks)
    deleted = {moves.get(path, path) for path in edited.deleted if isinstance(path, str)}
    places = {moves.get(origin, origin): path for path, origin in edited.moved.items()}
    for path in sorted(set(new) - deleted - (set(edited.links) - set(places))):
        place = places.get(path, path)
        if place not in result:
            complaints.append(f"{place}: the file is not there")
        elif CONFLICT not in result[place]:
            complaints += _template_side(edited, path, place, where, new, result, callbacks)
            complaints += _readable(place, result[place])
    kept = {where[path] for path in edited.texts if path not in old}
    for path in sorted(set(result) - set(new) - kept):
        if not path.endswith(".ros_package"):
            complaints.append(f"{path}: a file too many")
    return complaints


def _line(marks, mark, path, function, target, result, said, callbacks):
    """Look for a line, in the file and the function it was written in."""
    found = marks.get(mark, [])
    if not found:
        parts = [part for part in said if part.startswith(f"{path}: ")]
        gone = path in said or f"{path}: {function}" in said or (not function and parts)
        gone = gone or mark in said
        return [] if gone else [f"{path}: {mark} is lost"]
    if len(found) == 1 and found[0] != target and found[0] in COUNTERPARTS.get(target, ()):
        return []  # in the file of the other ROS, which has no functions
    if found != [target]:
        return [f"{path}: {mark} is in {', '.join(found)}"]
    lines = result[target].split("\n")
    at = [i for i, line in enumerate(lines) if re.search(rf"\b{mark}\b", line)]
    if len(at) != 1:
        return [f"{path}: {mark} is there {len(at)} times"]
    wanted = callbacks.get(path, {}).get(function, function)
    if wanted and enclosing(target, lines, at[0]) != wanted:
        return [f"{path}: {mark} of {wanted} is in {enclosing(target, lines, at[0])}"]
    return []


_HOLDS = {
    ".cpp": r"^\w.*::((?:serve|receive|execute|con|de|act|clean)\w+)\(",
    "CMakeLists.txt": r"^add_(?:library|executable)\(\$\{PROJECT_NAME\}_(\w+)",
    ".launch": r'<node [^>]*? name="(\w+)"',
    ".xml": r'<node [^>]*? name="(\w+)"',
}


def _around(marks, first, last, name, edited, result, callbacks):
    """Look for what was between two lines, which is there, alone, unless it has left."""
    path, place = edited.lines[first][0], marks[first][0]
    text = result[place]
    if CONFLICT in text:
        return
    form = next(form for end, form in _HOLDS.items() if place.endswith(end))
    start, end = (re.search(rf"\b{mark}\b", text).start() for mark in (first, last))
    found = re.findall(form, text[start:end], re.MULTILINE)
    names = callbacks.get(path, {})
    wanted = names.get(name, name)
    is_there = wanted in re.findall(form, text, re.MULTILINE)
    if wanted == name and name in names.values():
        is_there = False  # it left, and another one has its name
    if found != [wanted] * is_there:
        yield f"{path}: around {wanted} is around {found}"


def _stays_deleted(edited, old, new, result, missing, moves, callbacks):
    """What the developer deleted does not come back; the summary names it."""
    for part in sorted(edited.deleted, key=str):
        path, function = part if isinstance(part, tuple) else (part, None)
        target = path if path in edited.moved else moves.get(path, path)
        if function is None:
            if path not in moves and path in moves.values():
                continue  # it left, and another one has its name
            if target in new and path in old and (target in result or target not in missing):
                yield f"{path}: was deleted, and is there or not said"
            continue
        names = callbacks.get(path, {})
        if function not in names and function in names.values():
            continue  # it left, and another one has its name
        name = names.get(function, function)
        origin = edited.moved.get(path, path)
        before, after = old.get(origin, ""), new.get(moves.get(origin, origin), "")
        if not (_has(before, function) and _has(after, name)) or CONFLICT in result.get(
            target, ""
        ):
            continue
        if _has(result.get(target, ""), name) or f"{target}: {name}" not in missing:
            yield f"{path}: {function} was deleted, and is there or not said"


def _has(text, function):
    return re.search(rf"(^\s*def |::){function}\(", text, re.MULTILINE)


_BEFORE = r"LAB_TRACE\(\w+\)|(?:__attribute__\(\(hot\)\)|LAB_API|LAB_EXPORT\(1\)) "


def without_macros(text):
    """Return C++ without what the developer has put before functions and classes."""
    return re.sub(rf"(?m)^\s*(?:{_BEFORE})|\blab::(?=\w+::\w+\()", "", text)


def enclosing(path, lines, at):
    """Return the name of the function that a line is in."""
    pattern = r"\s*def (\w+)\(" if path.endswith(".py") else r"(?:\w[\w:]* )*(?:\w+::)?(\w+)\("
    for line in map(without_macros, reversed(lines[: at + 1])):
        match = re.match(pattern, line)
        if match and not line.startswith(("  ", "}", "#")) | path.endswith(".py"):
            return match[1]
        if match and path.endswith(".py"):
            return match[1]
    return None


def _template_side(edited, path, place, where, new, result, callbacks):
    """The result is the new version, less what the developer changed, plus their lines."""
    sources = [before for before, after in where.items() if after == place]
    source = max(sources, key=lambda before: before != place, default=path)  # not one that leaves
    if source in edited.formatted or source in edited.ahead:
        names = {p[1] for p in edited.deleted if isinstance(p, tuple) and p[0] == source}
        names = {callbacks.get(source, {}).get(name, name) for name in names}
        return _parts(place, new[path], result[place], names)
    wanted, found = _lines(new[path]), _lines(result[place])
    behind = (re.sub(r"\s+# .*", "", line) for line in found if "mine_" in line)
    missing = wanted - found - Counter(behind)  # an import, with a comment of the developer's
    replaced = Counter(line.strip() for line in edited.replaced.get(source, []))
    extra = Counter({line: n for line, n in (found - wanted).items() if "mine_" not in line})
    helper = Counter({line: n for line, n in extra.items() if "helper_" in line})
    extra -= helper
    extra -= Counter({sign: sum(helper.values()) for sign in "{}"})
    extra -= edited.repeated.get(source, Counter())
    if sum(missing.values()) > sum(replaced.values()):
        return [f"{place}: has not {sorted(missing)[:3]}"]
    return [f"{place}: has still {sorted(extra)[:3]}"] if extra else []


def _parts(path, new, result, deleted):
    """Say which functions of the new version a formatted file has not, or has twice."""
    form = r"^\s*def (\w+)\(" if path.endswith(".py") else r"^(?:\w+ )?\w+::(\w+)\("
    texts = (new, without_macros(result))
    wanted, found = (Counter(re.findall(form, text, re.MULTILINE)) for text in texts)
    return [
        f"{path}: {name} has {found[name]} bodies"
        for name, count in wanted.items()
        if found[name] != count and name not in deleted
    ]


def _lines(text):
    small = re.sub(r"(?m)^\s*[A-Z_]+(?=\()", lambda command: command[0].lower(), text)
    return Counter(line.strip() for line in small.split("\n") if line.strip())


@functools.lru_cache(maxsize=4096)
def _readable(path, text):
    text = re.sub("[\udc80-\udcff]", "?", text)
    try:
        if path.endswith(".py"):
            ast.parse(text)
        elif path.endswith((".xml", ".launch")):
            ElementTree.fromstring(text)
        elif path.endswith(".yaml"):
            yaml.safe_load(text)
        elif path.endswith((".cpp", ".hpp")) and text.count("{") != text.count("}"):
            return [f"{path}: braces do not match"]
        return [f"{path}: {fault}" for fault in nesting(path, text)]
    except (SyntaxError, ElementTree.ParseError, yaml.YAMLError) as error:
        return [f"{path}: {error}"]


_CMAKE = re.compile(
    r"^\s*(?:(if|foreach|while|function|macro|block)|(?:end(\w+))|else\w*)\s*\(", re.M
)
_CPP = re.compile(r"^\s*#\s*(?:(if)\w*|end(if)|el\w+)\b", re.M)


def nesting(path, text):
    """Yield what opens and does not end, or ends and was not open."""
    is_cmake = path.endswith("CMakeLists.txt")
    pattern = _CMAKE if is_cmake else _CPP if path.endswith((".cpp", ".hpp")) else None
    stack = []
    for match in pattern.finditer(text) if pattern else ():
        opened, closed = match.groups()
        line = text.count("\n", 0, match.start(1 if opened else 0)) + 1
        if opened:
            stack.append(opened)
        elif closed and (not stack or stack.pop() != closed):
            yield f"{line}: end{closed} that nothing opens"
        elif not closed and not stack:
            yield f"{line}: an else without an if"
    yield from (f"{opened} that nothing ends" for opened in stack)
