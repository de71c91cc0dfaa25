"""What became of a package: each line in its function, and the template's side of each file.

The judge reads texts alone. It knows nothing of blocks, and shares no code with the merge.
"""

import ast
import re
from collections import Counter
from xml.etree import ElementTree

import yaml

CONFLICT = "<<<<<<< before updating"


def judge(edited, old, new, result, said, moves, callbacks):
    """Return the complaints.

    Args:
        edited: what the developer did.
        old, new: the texts of the renders, by path.
        result: the texts of the package after the update.
        said: what the summary says left: `path`, or `path: function` (or key, element, section).
        moves: the paths that a rename gives to paths of before.
        callbacks: the names that a rename gives to functions of before, by path of before.

    """
    complaints = []
    where = {path: moves.get(path, path) for path in edited.texts}
    for mark, (path, function) in edited.lines.items():
        complaints += _line(mark, path, function, where[path], result, said, callbacks)
    for path in sorted(new):
        if path not in result:
            complaints.append(f"{path}: the file is not there")
        elif CONFLICT not in result[path]:
            complaints += _template_side(edited, path, where, new, result)
            complaints += _readable(path, result[path])
    kept = {where[path] for path in edited.texts if path not in old}
    for path in sorted(set(result) - set(new) - kept):
        if not path.endswith(".ros_package"):
            complaints.append(f"{path}: a file too many")
    return complaints


def _line(mark, path, function, target, result, said, callbacks):
    """Look for a line, in the file and the function it was written in."""
    found = [name for name, text in result.items() if re.search(rf"\b{mark}\b", text)]
    if not found:
        parts = [part for part in said if part.startswith(f"{path}: ")]
        gone = path in said or f"{path}: {function}" in said or (not function and parts)
        return [] if gone else [f"{path}: {mark} is lost"]
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


def enclosing(path, lines, at):
    """Return the name of the function that a line is in."""
    pattern = r"\s*def (\w+)\(" if path.endswith(".py") else r"(?:\w[\w:]* )*(?:\w+::)?(\w+)\("
    for line in reversed(lines[: at + 1]):
        match = re.match(pattern, line)
        if match and not line.startswith(("  ", "}", "#")) | path.endswith(".py"):
            return match[1]
        if match and path.endswith(".py"):
            return match[1]
    return None


def _template_side(edited, path, where, new, result):
    """The result is the new version, less what the developer changed, plus their lines."""
    source = next((before for before, after in where.items() if after == path), path)
    if source in edited.formatted or source in edited.ahead:
        return _parts(path, new[path], result[path])
    wanted, found = _lines(new[path]), _lines(result[path])
    missing = wanted - found
    replaced = Counter(line.strip() for line in edited.replaced.get(source, []))
    extra = Counter({line: n for line, n in (found - wanted).items() if "mine_" not in line})
    helper = Counter({line: n for line, n in extra.items() if "helper_" in line})
    extra -= helper
    extra -= Counter({sign: sum(helper.values()) for sign in "{}"})
    if sum(missing.values()) > sum(replaced.values()):
        return [f"{path}: has not {sorted(missing)[:3]}"]
    return [f"{path}: has still {sorted(extra)[:3]}"] if extra else []


def _parts(path, new, result):
    """Say which functions of the new version a formatted file has not, or has twice."""
    form = r"^\s*def (\w+)\(" if path.endswith(".py") else r"^(?:\w+ )?(\w+::\w+)\("
    wanted, found = (Counter(re.findall(form, text, re.MULTILINE)) for text in (new, result))
    return [f"{path}: {n} has {found[n]} bodies" for n, k in wanted.items() if found[n] != k]


def _lines(text):
    return Counter(line.strip() for line in text.split("\n") if line.strip())


def _readable(path, text):
    try:
        if path.endswith(".py"):
            ast.parse(text)
        elif path.endswith((".xml", ".launch")):
            ElementTree.fromstring(text)
        elif path.endswith(".yaml"):
            yaml.safe_load(text)
        elif path.endswith((".cpp", ".hpp")) and text.count("{") != text.count("}"):
            return [f"{path}: braces do not match"]
    except (SyntaxError, ElementTree.ParseError, yaml.YAMLError) as error:
        return [f"{path}: {error}"]
    return []
