"""Merges that are wrong, as merges have been: the judge must see each of them.

A mutant spoils the files of a merged package, and says whether it found something to spoil.
"""

import re
from dataclasses import replace

from hooks.merge.tree import File, encode
from support.laboratory.edits import functions


def _write(tree, path, text):
    tree[path] = replace(tree[path], data=encode(text))


def _with_lines(tree, edited):
    """Yield the files that have lines of the developer's."""
    paths = {path for path, _ in edited.lines.values()}
    return [path for path in sorted(paths) if path in tree and "mine_" in tree[path].text]


def left_as_it_was(random, tree, edited, pair):
    """Every edited file is left un-updated."""
    spoiled = False
    for path in _with_lines(tree, edited):
        if pair.old.get(path) != pair.new.get(path) and path not in edited.formatted:
            spoiled |= tree[path].text != edited.texts[path]
            _write(tree, path, edited.texts[path])
    return spoiled


def edits_dropped(random, tree, edited, pair):
    """Every edit is dropped, as with apply.whitespace=error."""
    paths = [path for path in _with_lines(tree, edited) if path in pair.new]
    for path in paths:
        _write(tree, path, pair.new[path])
    return bool(paths)


def line_in_another_file(random, tree, edited, pair):
    paths = _with_lines(tree, edited)
    if len(tree) < 2 or not paths:
        return False
    lines = tree[paths[0]].text.split("\n")
    at = next(i for i, line in enumerate(lines) if "mine_" in line)
    other = next(path for path in sorted(tree) if path != paths[0])
    _write(tree, other, tree[other].text + lines.pop(at) + "\n")
    _write(tree, paths[0], "\n".join(lines))
    return True


def line_at_the_end(random, tree, edited, pair):
    for path in _with_lines(tree, edited):
        lines = tree[path].text.split("\n")
        for i, line in enumerate(lines):
            if re.search(r"value.*mine_\d+$", line) and path.endswith("_impl.py"):
                _write(tree, path, "\n".join([*lines[:i], *lines[i + 1 :], line]))
                return True
    return False


def line_twice(random, tree, edited, pair):
    for path in _with_lines(tree, edited):
        lines = tree[path].text.split("\n")
        at = next(i for i, line in enumerate(lines) if "mine_" in line)
        _write(tree, path, "\n".join([*lines[: at + 1], *lines[at:]]))
        return True
    return False


def cleanup_deleted(random, tree, edited, pair):
    for path in sorted(tree):
        for name, first, last in functions(path, tree[path].text) if _is_logic(path) else ():
            if name == "cleanup":
                lines = tree[path].text.split("\n")
                _write(tree, path, "\n".join([*lines[:first], *lines[last + 1 :]]))
                return True
    return False


def file_gone(random, tree, edited, pair):
    paths = _with_lines(tree, edited)
    if paths:
        del tree[paths[0]]
    return bool(paths)


def generated_file_gone(random, tree, edited, pair):
    paths = [path for path in sorted(pair.new) if path in tree and path not in edited.texts]
    for path in paths[:1]:
        del tree[path]
    return bool(paths)


def bodies_swapped(random, tree, edited, pair):
    """Two callbacks have each other's bodies: the defect that started this."""
    for path in filter(_is_logic, sorted(tree)):
        text = tree[path].text
        names = [n for n, *_ in functions(path, text) if n.startswith(("serve_", "receive_"))]
        for one, two in zip(names, names[1:], strict=False):
            if _body(path, text, one) != _body(path, text, two):
                swapped = re.sub(rf"\b{one}\(", "\0(", text)
                swapped = re.sub(rf"\b{two}\(", f"{one}(", swapped).replace("\0(", f"{two}(")
                _write(tree, path, swapped)
                return "mine_" in _body(path, text, one) + _body(path, text, two)
    return False


def replaced_runs_the_other(random, tree, edited, pair):
    """A callback that came has the body of one that left."""
    for path in filter(_is_logic, _with_lines(tree, edited)):
        old = {name for name, *_ in functions(path, pair.old.get(path, ""))}
        new = {name for name, *_ in functions(path, pair.new.get(path, ""))}
        came = sorted(n for n in new - old if n.startswith("serve_"))
        gone = [f for p, f in edited.lines.values() if p == path and f in old - new]
        if came and gone and not pair.renaming.names and path not in edited.formatted:
            line = next(m for m, where in edited.lines.items() if where == (path, gone[0]))
            margin = "        value = 1  # " if path.endswith(".py") else "  // "
            lines = tree[path].text.split("\n")
            at = next(last for n, first, last in functions(path, tree[path].text) if n == came[0])
            lines.insert(at, margin + line)
            _write(tree, path, "\n".join(lines))
            return True
    return False


def empty_method_twice(random, tree, edited, pair):
    """The method that was written ahead is there again, empty; the empty one counts."""
    for path in filter(_is_logic, _with_lines(tree, edited)):
        for name, first, last in functions(path, pair.new.get(path, "")):
            if name.startswith("serve_"):
                lines = pair.new[path].split("\n")[first : last + 1]
                _write(tree, path, tree[path].text.rstrip("\n") + "\n\n" + "\n".join(lines) + "\n")
                return True
    return False


def words_exchanged(random, tree, edited, pair):
    """A rename exchanges words: for i in distance(3)."""
    if not pair.renaming.names:
        return False
    before, after = pair.renaming.names[0]
    for path in _with_lines(tree, edited):
        text = re.sub(rf"\bmine_|\b{before}\b", f"{after}_", tree[path].text, count=1)
        was = tree[path].text
        _write(tree, path, text)
        return text != was
    return False


def template_change_missed(random, tree, edited, pair):
    """One line of the new version is not there."""
    for path in _with_lines(tree, edited):
        came = set(pair.new.get(path, "").split("\n")) - set(pair.old.get(path, "").split("\n"))
        lines = tree[path].text.split("\n")
        at = [i for i, line in enumerate(lines) if line in came and line.strip()]
        if at and path not in edited.formatted | edited.ahead and not edited.replaced.get(path):
            _write(tree, path, "\n".join([*lines[: at[0]], *lines[at[0] + 1 :]]))
            return True
    return False


def condition_ends_elsewhere(random, tree, edited, pair):
    """What was put around a callback holds the next one, too."""
    for last, _ in edited.around.values():
        for path in _with_lines(tree, edited):
            lines = tree[path].text.split("\n")
            at = next((i for i, line in enumerate(lines) if last in line.split()), None)
            ends = [i for i, line in enumerate(lines) if line == "}"]
            if at and path.endswith(".cpp") and ends[-1] > at:
                lines.insert(ends[-1] - 1, lines.pop(at))
                _write(tree, path, "\n".join(lines))
                return True
    return False


def _is_logic(path):
    return path.endswith(("_impl.py", "_impl.cpp")) and "test" not in path


def _body(path, text, name):
    for found, first, last in functions(path, text):
        if found == name:
            return "\n".join(text.split("\n")[first + 1 : last + 1])
    return ""


def deleted_comes_back(random, tree, edited, pair):
    """Generated files that the developer has deleted are there again."""
    paths = [path for path in edited.deleted_files() if pair.renaming.path(path) in pair.new]
    for path in paths:
        target = pair.renaming.path(path)
        tree[target] = File(encode(pair.new[target]))
    return bool(paths)


def deleted_callback_comes_back(random, tree, edited, pair):
    for path, name in (part for part in edited.deleted if isinstance(part, tuple)):
        target = pair.renaming.path(edited.moved.get(path, path))
        for found, first, last in functions(target, pair.new.get(target, "")):
            if found == name and pair.renaming.path(path) in tree and not pair.renaming.names:
                body = pair.new[target].split("\n")[first : last + 1]
                text = tree[pair.renaming.path(path)].text.rstrip("\n")
                _write(tree, pair.renaming.path(path), "\n".join([text, "", *body, ""]))
                return True
    return False


def moved_goes_back(random, tree, edited, pair):
    """A file that the developer has moved is where the model makes it."""
    for path, origin in edited.moved.items():
        if path in tree and pair.renaming.path(origin) in pair.new:
            tree[pair.renaming.path(origin)] = tree.pop(path)
            return True
    return False


def line_ends_exchanged(random, tree, edited, pair):
    spoiled = False
    for path in map(pair.renaming.path, edited.crlf):
        if path in tree and b"\r\n" in tree[path].data:
            tree[path] = replace(tree[path], data=tree[path].data.replace(b"\r\n", b"\n"))
            spoiled = True
    return spoiled


def encoding_exchanged(random, tree, edited, pair):
    spoiled = False
    for path, file in tree.items():
        if b"caf\xe9" in file.data:
            tree[path] = replace(file, data=file.data.replace(b"caf\xe9", "café".encode()))
            spoiled = True
    return spoiled


def link_written_through(random, tree, edited, pair):
    """In the place of a link is the text that it leads to."""
    for path, target in edited.links.items():
        if path in tree and target in tree:
            tree[path] = tree[target]
            return True
    return False


MUTANTS = [
    left_as_it_was,
    edits_dropped,
    line_in_another_file,
    line_at_the_end,
    line_twice,
    cleanup_deleted,
    file_gone,
    generated_file_gone,
    bodies_swapped,
    replaced_runs_the_other,
    empty_method_twice,
    words_exchanged,
    template_change_missed,
    condition_ends_elsewhere,
]
OF_HABITS = {
    deleted_comes_back: "delete_file",
    deleted_callback_comes_back: "delete_function",
    moved_goes_back: "move",
    line_ends_exchanged: "end_lines_as_windows",
    encoding_exchanged: "write_in_another_encoding",
    link_written_through: "replace_by_link",
}
"""Those that need what developers do but now and then, and what that is."""
