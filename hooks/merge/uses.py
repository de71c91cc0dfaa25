"""Where the developer's lines still use what an update has renamed, or what has left."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable, Collection, Iterable, Iterator
from pathlib import PurePosixPath

from ..dictionary import WAS
from ..names import class_name
from ..package import SUFFIX
from . import python_blocks, xml_blocks
from .languages import CMAKE, CPP, PYTHON, XML, Language, language
from .lines import plain, split
from .origins import Names, origins
from .renaming import Renaming
from .settings import EVERY, Setting, dotted, node_calls, settings
from .tokens import words
from .tree import File, Tree

_NAME_BEFORE = re.compile(rf"""\b{WAS}\s*=\s*("[^"]*"|'[^']*')""")
_MARKUP = re.compile(r"""</?[\w:.-]+|[\w:.-]+(?=\s*=\s*["'])""")
"""The tags and attributes of XML, which are not the developer's words."""
_PATTERN = re.compile(r"_(?=\*)|(?<=\*)_|\b_(?=\w+:=)")
"""What ends a name in `reach_*.cpp`, a pattern of files, or begins one in `_gain:=1` of ROS 1."""
_NESTED = re.compile(r"[\w~/][\w~./]*\w")
"""A name with strokes or dots, all of it."""


def uses(mine: Tree, old: Tree, new: Tree, found: Tree, renaming: Renaming) -> Iterator[str]:
    """Yield `file:line: word` for each old name that the developer's lines still have.

    Likewise for each identifier that now belongs to another interface. The spec's own `was` is
    what has said so.
    """
    known = set(renaming.words())
    known |= {word.replace(".", "/") for word in known}  # of a group, in ROS 1
    before, after = map(_cmake, (old, new))
    package, sign = _project(before), "${PROJECT_NAME}"
    for word in re.findall(r"\w*\$\{PROJECT_NAME\}\w*", before):
        is_renamed = package != _project(after) or word.removeprefix(sign) in known
        known |= {word.replace(sign, package)} if is_renamed else set()
    taken = _uses_of_taken(mine, old, renaming)
    swapped = known & {*renaming.words().values()}
    fresh = _exchanged(mine, renaming) if swapped else {}
    nested = {word for word in known - swapped if "." in word}
    packages = {renaming.package, *renaming.packages.values()}
    for path, file in sorted(found.items()):
        if not (known or taken) or file.text is None:
            continue
        generated = set(split(new.get(path, File(b"")).written))
        text = plain(file.text)
        given = settings(language(path, text), text, packages) if nested else ()
        within = {one.line + 1: one.name for one in given if one.name in nested}  # in its group
        for number, line in enumerate(split(text), 1):
            if line not in generated:
                said = _NAME_BEFORE.sub("", line) if path.endswith(SUFFIX) else line
                said = _MARKUP.sub(" ", said) if language(path, "") is XML else said
                said = _PATTERN.sub(" ", said)
                used = known & {*re.findall(r"\w+", said), *_NESTED.findall(said)}
                used |= {within[number]} if number in within else set()
                for word in sorted(used - (fresh.get((path, line), set()) & swapped)):
                    yield f"{path}:{number}: {word}"
                for word in taken.get((path, line), ()):
                    yield f"{path}:{number}: {word}, which is another's now"


def uses_of_left(
    gone: Iterable[tuple[str, str]], old: Tree, new: Tree, found: Tree, holders: Names = ()
) -> Iterator[str]:
    """Yield `file:line: word` for each name of what left that the developer's lines still have.

    `gone` has the names, each after that of its component; `holders` is the dictionary's.
    """
    gone = set(gone)
    components = {name for owner, name in gone if owner == name}
    yield from _imports_of_left(components, old, new, found)
    yield from _messages_of_left({n for n in components if f"msg/{n}.msg" in old}, old, found)
    if not gone:
        return
    names = "|".join(re.escape(name.strip("~/")) for _, name in gone)
    classes = "|".join(class_name(name) for _, name in gone)
    form = rf"(?:\w*_)?(?:{names})(?:_\w*)?|(?:\w*[a-z\d_])?(?:{classes})(?:[A-Z_]\w*)?"
    bare = {name for _, name in gone}

    def lost(owner: str = "") -> set[str]:
        before, after = (_words(tree, owner) for tree in (old, new))
        return {word for word in before - after - bare if re.fullmatch(form, word)}

    roots = {part for path in old for part in PurePosixPath(path).parts[:-1]}
    made = {word: {word} for file in old.values() for word in _CLASS.findall(file.written)}
    texts = _texts_of_left(components, old, new)
    after, left = _words(new), lost()
    left_of = {owner: lost(owner) - left for owner, _ in gone}
    for path, file in sorted(found.items()):
        generated = set(split(new.get(path, File(b"")).written))
        text = plain(file.written)
        lines, stem = split(text), PurePosixPath(path).stem
        near = {
            owner
            for owner in left_of
            if owner in stem or re.search(rf"\b{owner}_(?:interface|impl|types)\b", text)
        }
        known = language(path, text)
        origin = origins(known, text, roots, (), made, holders)
        seen = set()
        for word in words(known, text):
            holder = word.chain[-1] if word.chain else ""
            is_member = holder.strip("_") in holders and origin.is_holder(holder, word.line)
            is_member = is_member or origin.is_argument(word)
            owners = {owner for owner, name in gone if name == word.text and is_member}
            is_own = bool(owners) and (word.text not in after or bool(owners & near))
            is_left = word.text in left or any(word.text in left_of[owner] for owner in near)
            if (is_left or is_own) and lines[word.line] not in generated:
                seen.add(word.line)
                yield f"{path}:{word.line + 1}: {word.text}, which has left"
        given = [*_given(settings(known, text, roots), gone, stem, after)]
        for number, said in dict.fromkeys([*texts(known, text), *given]):
            if number not in seen and lines[number] not in generated:
                yield f"{path}:{number + 1}: {said}, which has left"


def _imports_of_left(components: set[str], old: Tree, new: Tree, found: Tree) -> Iterator[str]:
    """Yield where files use what is no component's and left: the runtime, or another package."""
    gone = [path for path in old.keys() - new.keys() if not _of(components, path)]
    parts = (PurePosixPath(path).parts for path in gone)
    ends = {"/".join(each[at:]) for each in parts for at in range(len(each) - 1)}  # of two names
    packages = _dependencies(old) - _dependencies(found)
    for path, file in sorted(found.items()) if gone or packages else ():
        generated = set(split(new.get(path, File(b"")).written))
        text = plain(file.written)
        lines = split(text)
        used = (
            (number, package if package in packages else said)
            for number, package, said, end in _imports(path, text)
            if package in packages or end in ends
        )
        for number, said in dict.fromkeys(used):
            if lines[number] not in generated:
                yield f"{path}:{number + 1}: {said}, which has left"


def _messages_of_left(names: set[str], old: Tree, found: Tree) -> Iterator[str]:
    """Yield where messages, services and actions have a field of a message that left."""
    form = re.compile(rf"\s*(?:{_project(_cmake(old))}/)?({'|'.join(names)})\b(?!/)")
    for path, file in sorted(found.items()) if names else ():
        for number, line in enumerate(split(plain(file.written)), 1):
            if path.endswith((".msg", ".srv", ".action")) and (match := form.match(line)):
                yield f"{path}:{number}: {match[1]}, which has left"


def _dependencies(tree: Tree) -> set[str]:
    """Return the packages that a package declares in its `package.xml`."""
    text = tree.get("package.xml", File(b"")).written
    return set(re.findall(r"depend\b[^>]*>\s*([\w-]+)", text))


def _of(components: Iterable[str], path: str) -> bool:
    return any(name in PurePosixPath(path).stem for name in components)


def _imports(path: str, text: str) -> Iterator[tuple[int, str, str, str]]:
    """Yield what a file uses of others: its line, the package, its name, and its path's end."""
    known = language(path, text)
    if known is CPP:
        for match in re.finditer(r'(?m)^[ \t]*#[ \t]*include[ \t]*[<"]([^">\n]+)', text):
            line = text.count("\n", 0, match.start(1))
            yield line, match[1].partition("/")[0], match[1], match[1]
    elif known is PYTHON:
        for line, _, module in python_blocks.imports(text, PurePosixPath(path).parent.parts):
            yield line, module.partition(".")[0], module, module.replace(".", "/") + ".py"
    elif known is CMAKE:
        for line, said in enumerate(split(text)):
            for word in re.findall(r"\w+", said.partition("#")[0]):
                parts = word.split("_")  # of `geometry_msgs_TARGETS`
                names = ("_".join(parts[:end]) for end in range(1, len(parts) + 1))
                yield from ((line, name, name, "") for name in names)


_CLASS = re.compile(r"\b(?:class|struct) (\w+)")


def _given(
    found: Iterable[Setting], gone: Collection[tuple[str, str]], stem: str, after: set[str]
) -> Iterator[tuple[int, str]]:
    """Yield where a file, of this stem, gives a value to what left; `after` are all words now."""
    names = [(owner, dotted(name)) for owner, name in gone]
    for line, node, name, written, *_ in found:
        owners = {owner for owner, other in names if other == (name or owner)}
        owners -= {name}  # a node that left is no parameter
        is_lost = not after.issuperset(re.findall(r"\w+", name))
        is_near = node is None and any(owner in stem for owner in owners)
        if node in owners or is_near or (owners and node == EVERY and is_lost):
            yield line, written


def _texts_of_left(
    components: set[str], old: Tree, new: Tree
) -> Callable[[Language, str], Iterator[tuple[int, str]]]:
    """Return what finds files of components that left in texts, in launch files their nodes."""
    gone = [path for path in old if path not in new and _of(components, path)]
    gone += [path.removesuffix(".py").replace("/", ".") for path in gone if path.endswith(".py")]
    form = re.compile(rf"(?<![\w.])(?:{'|'.join(map(re.escape, gone)) or '(?!)'})(?!\w)")
    nodes = _started_in_xml(old) - _started_in_xml(new)
    started = {(tag.rpartition(" of ")[2], name) for tag, _, name in nodes}
    before, after = map(_cmake, (old, new))
    package = _project(before)
    names = {*_targets(before, package)} - {*_targets(after, package)}
    targets = re.compile(
        rf"(?<![\w./-])(?:{'|'.join(map(re.escape, names)) or '(?!)'})(?![\w./-])"
    )

    def find(known: Language, text: str) -> Iterator[tuple[int, str]]:
        if known not in (PYTHON, CPP, CMAKE, XML) or not gone:
            return
        if known is XML:
            found = (each for each in xml_blocks.attributes(text) if each[0] in nodes)
            yield from ((text.count("\n", 0, at), value) for (_, _, value), at in found)
        if known is PYTHON:
            yield from _started(text, started)
        for number, line in enumerate(split(text)):
            yield from ((number, word) for word in form.findall(line))
            yield from ((number, word) for word in targets.findall(line) if known is CMAKE)

    return find


def _project(text: str) -> str:
    """Return the name that a `CMakeLists.txt` gives its project; nothing where it gives none."""
    return "".join(re.findall(r"\bproject\(\s*(\w+)", text)[:1])


def _cmake(tree: Tree) -> str:
    return "".join(f.written for path, f in tree.items() if language(path, "") is CMAKE)


def _targets(text: str, package: str) -> list[str]:
    """Return the targets that a `CMakeLists.txt` makes."""
    text = text.replace("${PROJECT_NAME}", package)
    return re.findall(r"\badd_(?:executable|library)\(\s*([\w.-]+)", text)


def _started(text: str, nodes: set[tuple[str, str]]) -> Iterator[tuple[int, str]]:
    """Yield where a launch file in Python starts some nodes, and their programs.

    `nodes` are packages, each with a program.
    """
    with contextlib.suppress(ValueError):
        for _, package, program in node_calls(text):
            if (package, program.value) in nodes:
                yield program.lineno - 1, str(program.value)


def _started_in_xml(tree: Tree) -> set[xml_blocks.Attribute]:
    """Return what names the programs of a package in files of XML."""
    texts = (f.written for path, f in tree.items() if language(path, f.written) is XML)
    found = (each for text in texts for each, _ in xml_blocks.attributes(text))
    return {each for each in found if " of " in each[0] and each[1] in ("exec", "type")}


def _words(tree: Tree, owner: str = "") -> set[str]:
    """Return the words of files, of those alone that have the name of a component in theirs."""
    files = (file for path, file in tree.items() if owner in PurePosixPath(path).stem)
    return {word for file in files for word in re.findall(r"\w+", file.written)}


def _exchanged(mine: Tree, renaming: Renaming) -> dict[tuple[str, str], set[str]]:
    """Return the words that lines have by the rename alone, as those are afterwards."""
    found: dict[tuple[str, str], set[str]] = {}
    for path, file in mine.items():
        text = plain(file.written)
        lines, after = split(text), split(renaming.text(path, text))
        for line, now in zip(lines, after, strict=True) if len(lines) == len(after) else ():
            before, later = ({*re.findall(r"\w+", each)} for each in (line, now))
            found.setdefault((renaming.path(path), now), later).difference_update(before)
    return found


def _uses_of_taken(mine: Tree, old: Tree, renaming: Renaming) -> dict[tuple[str, str], list[str]]:
    """Return the identifiers of what left in the developer's lines, as those are afterwards."""
    found: dict[tuple[str, str], list[str]] = {}
    for path, file in mine.items() if renaming.taken else ():
        text = plain(file.written)
        generated = set(split(old.get(path, File(b"")).written))
        known, taken = language(path, text), renaming.taken.get(path, set())
        after = split(renaming.text(path, text))
        for number, line in enumerate(split(text) if taken else ()):
            if line not in generated:
                for word in taken & {word.text for word in words(known, line)}:
                    found.setdefault((renaming.path(path), after[number]), []).append(word)
    return found
