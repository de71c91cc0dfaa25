"""A second proof, with eyes of its own: it knows no block and no matching of the merge.

It counts. A line is there as often as the new version has it, more what the developer has added,
less what they have deleted. And what was sound is so: brackets, conditions, fences, keys, names.
Decision 29: each proof sees faults that the other does not.
"""

from __future__ import annotations

import ast
import builtins
import functools
import re
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from itertools import accumulate
from pathlib import PurePosixPath

import yaml

from ..data import LOADER
from .blocks import unicode
from .lines import plain, split
from .package import Result
from .python_blocks import imports, nodes
from .renaming import Renaming
from .tree import LINK, File, Tree

_WORD = re.compile(r"(?<=\bfrom )\s*\w*\.(?=\w)|(\w+|[<>=!&|+.:~%${}-])")
"""What is no form: words and signs, without what makes an import relative."""
_IMPORT = re.compile(r"\tfrom\n\t\w+\n(\t\.\n\t\w+\n)*\timport\n")
"""An import, which one may split; that each used name has one is looked for below."""
_NAMES = re.compile(r"\bfrom \S+ import \([^)]*\)")
"""Names that are imported, of which a line may have several."""
_ROW = re.compile(r"(?m)^\|.*\|$")
"""A row of a table, of which both sides may have changed cells."""
_NAMESPACE = re.compile(r"(?m)^[ \t]*(namespace\b[^;{]*\{|\}[ \t]*//.*\bnamespace\b.*$)")
"""What begins and ends a namespace, which may be opened again; its braces are counted below."""
_CLOSES = re.compile(r"end\w+ *\(.*\)|</.*>|\W+")
"""What ends something, and says not what."""
_PROGRAM = re.compile(r"[\"']([\w.-]+) *= *[\w.]+:\w+[\"']")
"""A program in `setup.py`: of two with one name, the last one is installed."""
Places = list[tuple[str, str]]
Member = tuple[str, str]
"""A class of C++, and a function of it."""
_CMAKE = ("CMakeLists.txt", ".cmake")
_STRING = r'"(?:\\.|[^"\\\n])*"'
_COMMENTS = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_NO_CODE = re.compile(
    rf"(?m){_COMMENTS.pattern}|^[ \t]*#[ \t]*if[ \t]+0\b.*?^[ \t]*#[ \t]*endif", re.DOTALL
)
_WORDS = r"\b{}(?:if|foreach|while|function|macro|block)\s*\("
_DEFINITION = re.compile(
    r"(?m)^(?:\[\[[^\]\n]*\]\]\s*)*[A-Za-z_][^\n;={}#]*?\b(\w+)::(~?\w+)\s*\("
)


def _lower(text: str) -> str:
    return re.sub(r"(?m)^\s*\w+(?=\s*\()", lambda found: found[0].lower(), text)


@functools.lru_cache(maxsize=1 << 15)  # most lines are those of all sides
def _tight(line: str) -> str:
    """Return a line without what a formatter changes: blanks, quotes, brackets, commas, rules."""
    words = _WORD.findall(re.sub("(?<=/[/*])[!<]+", "", re.sub("-{3,}", "", line)))
    return "".join(f"\t{word}\n" for word in words if word)


class _Text(dict[str, int]):
    """A text, and how often something stands in it, whatever the form of both."""

    def __init__(self, text: str) -> None:
        text = _NAMES.sub(
            lambda found: re.sub(r"(?<=,)[ \t]*(?=\w)|(?=\)$)", "\n", found[0]), text
        )
        self.tight = "".join(map(_tight, text.split("\n")))
        text = _ROW.sub(lambda found: found[0].replace("|", "\n"), text)
        lines = ((line.strip(), _tight(line)) for line in text.split("\n"))
        self.lines = [(line, tight) for line, tight in lines if tight and not _IMPORT.match(tight)]

    def __missing__(self, tight: str) -> int:
        self[tight] = self.tight.count(tight)
        return self[tight]


_text = functools.lru_cache(maxsize=512)(_Text)
"""The same texts are counted for each of two branches, and after each attempt to merge them."""


def recount(
    mine: Tree,
    old: Tree,
    new: Tree,
    renaming: Renaming,
    is_kept: Callable[[str], bool],
    result: Result,
    found: Tree,
    left: Iterable[tuple[str, int, str]],
) -> Places:
    """Return what is wrong with `found`: paths, and what is there too often, or is not.

    `left` are the developer's lines that left with what the summary names.
    """
    leaving: dict[str, set[int]] = {}  # with those beside them, in which such a text may go on
    for path, number, _ in left:
        leaving.setdefault(path, set()).update(range(number - 1, number + 2))
    carried = {path for targets, _ in result.carried.values() for path in targets}
    places = {renaming.path(path): path for path in old}
    trees = (mine, old, new, found)
    wrong = [*_files(trees, renaming, is_kept, result)]
    for path, file in mine.items():
        target = renaming.path(path)
        origin = result.origins.get(target) or places.get(target, path)
        paths = (path, origin, renaming.path(origin), target)
        files = [tree.get(at, File(b"")) for tree, at in zip(trees, paths, strict=True)]
        texts = [one.text for one in files]
        if None in texts or not texts[3] or target in result.conflicts or is_kept(target):
            continue
        if files[0] == files[1] and files[2] == files[3]:
            continue
        ours, base, theirs, there = (plain(text or "") for text in texts)
        if target.endswith(_CMAKE):  # its commands may be in capitals
            ours, base, theirs, there = map(_lower, (ours, base, theirs, there))
        ours, base = (renaming.text(origin, text) for text in (ours, base))
        if target not in carried:
            sides = [_text(_NAMESPACE.sub("", text)) for text in (ours, base, theirs, there)]
            parts = [*result.own.get(target, []), *result.missing.get(target, [])]
            raw, renamed = split(plain(file.written)), split(ours)
            numbered = enumerate(renamed if len(raw) == len(renamed) else raw, 1)
            excuse = "".join(line for n, line in numbered if n in leaving.get(path, ()))
            excuse += "".join(result.reworded.get(target, []))
            excuse += _about(theirs, parts)
            gone = [*result.missing.get(target, []), *result.removed.get(path, [])]
            gone += result.gone.get(path, [])
            taken = _about(base, gone)
            lines = _lines(sides, _text(excuse), _text(taken))
            wrong += ((target, line) for line in lines)
        faults = _faults(target, there)
        for side in (ours, theirs) if faults else ():
            faults -= _faults(target, side)
        faults -= {*_left(target, base, places, new)} if faults else set()
        wrong += ((target, fault) for fault in sorted(faults))
    return wrong + _halves(trees, renaming, result)


def _files(
    trees: Sequence[Tree], renaming: Renaming, is_kept: Callable[[str], bool], result: Result
) -> Iterator[tuple[str, str]]:
    """Yield the files that should be there, or should not, or are of another sort."""
    *before, new, found = trees
    have, had = ({renaming.path(path): tree[path] for path in tree} for tree in before)
    moved = {renaming.path(path): target for target, path in result.origins.items()}
    due = {
        moved.get(path, path) for path in new if path not in had or moved.get(path, path) in have
    }
    due |= {p for p in have if p not in had or is_kept(p) or (have[p].mode == LINK and p in new)}
    may = due | {path for path in new if is_kept(path)} | {*result.conflicts}
    for path in sorted(due ^ {*found}):
        if path in due or path not in may:
            yield path, "the file"
    for path, file in have.items():
        there = found.get(path, file)
        is_windows = [0 < d.count(b"\n") == d.count(b"\r\n") for d in (file.data, there.data)]
        wanted = new.get(path) if file == had.get(path) else file
        if LINK in (file.mode, there.mode) and there != wanted:
            yield path, "the link"
        elif path not in result.conflicts and file.text and is_windows == [True, False]:
            yield path, "the ends of its lines"


def _about(text: str, parts: Iterable[str]) -> str:
    """Return the paragraphs of a text that have the names of parts."""
    names = {name for part in parts for name in re.findall(r"\w+", part)[-1:]}
    found: list[str] = []
    is_inside = False  # what a first line with a name opens
    for paragraph in re.split(r"\n\s*\n", text):
        head, *_ = paragraph.split("\n")
        is_inside = bool(names & {*re.findall(r"\w+", head)} or (is_inside and head[:1] == " "))
        if is_inside or names & {*re.findall(r"\w+", paragraph)}:
            found.append(paragraph)
    return "\n".join(found)


def _lines(sides: Sequence[_Text], excused: _Text, taken: _Text) -> Iterator[str]:
    """Yield the lines that are there too often, or not often enough.

    `excused` has those that left, and those in whose place is what the developer has written;
    `taken` those of generated parts that are perhaps in the developer's own.
    """
    mine, old, new, found = sides
    above = [""] * 3
    seen: set[str] = set()
    for side in (new, mine, found):
        for line, tight in side.lines:
            ours, before, theirs, there = (text[tight] for text in sides)
            is_first, above = tight not in seen, [*above[1:], tight]
            seen.add(tight)
            if side is new and before:
                place = "".join(above)
                came = max(0, new[place] - old[place])
                is_shown = ours < before and not _CLOSES.fullmatch(line)
                if is_shown and old[place] and found[place] > mine[place] + came:
                    yield f"{line} (deleted)"
            if is_first and any(letter.isalnum() for letter in tight):
                added, deleted = max(0, ours - before), max(0, before - ours)
                both = added and theirs > before
                least = max(theirs, ours) if both else theirs + added - deleted
                most = theirs + added + min(ours, taken[tight])
                if not least - excused[tight] <= there <= most:
                    yield f"{line} ({there} times)"


@functools.lru_cache(maxsize=512)
def _faults(path: str, text: str) -> frozenset[str]:
    """Return what is not sound in a text."""
    finders = (find for suffixes, find in _SOUND if path.endswith(suffixes))
    return frozenset(next((find(text) for find in finders), ()))


def _left(path: str, text: str, places: Collection[str], new: Tree) -> Iterator[str]:
    """Yield that names of the package's files, which have left, are not defined: uses are listed.

    `text` is that of the file at a path, with its imports of before.
    """
    for _, name, imported in imports(text, PurePosixPath(path).parent.parts):
        module, _, word = imported.rpartition(".")
        file = f"{module.replace('.', '/')}.py"
        if file in places and word not in re.findall(r"\w+", new.get(file, File(b"")).written):
            yield f"{name} is not defined"


def _unbound(text: str) -> set[str]:
    """Return the names of Python that are used and bound nowhere."""
    try:
        found = nodes(text)
    except ValueError:
        return {"cannot be read any more"}
    names = [node for node in found if isinstance(node, ast.Name)]
    bound = {*dir(builtins), "__file__"} | {n.id for n in names if isinstance(n.ctx, ast.Store)}
    for node in found:
        name = getattr(node, "asname", None) or getattr(node, "name", getattr(node, "arg", None))
        bound |= {name.split(".")[0]} if isinstance(name, str) else set()
    used = {node.id for node in names if isinstance(node.ctx, ast.Load)}
    unbound = set() if "*" in bound else {f"{name} is not defined" for name in used - bound}
    return unbound | _twice(_PROGRAM.findall(text))


def _keys_twice(text: str) -> set[str]:
    try:
        open_ = [*yaml.compose_all(unicode(text), LOADER)]
    except yaml.YAMLError:
        return {"cannot be read any more"}
    twice: set[str] = set()
    while open_:
        node = open_.pop()
        if isinstance(node, yaml.CollectionNode):
            is_map = isinstance(node, yaml.MappingNode)
            twice |= _twice(str(key.value) for key, _ in (node.value if is_map else ()))
            open_ += [value for _, value in node.value] if is_map else node.value
    return twice


def _twice(names: Iterable[str]) -> set[str]:
    return {f"{name} is there {n} times" for name, n in Counter(names).items() if n > 1}


def _unbalanced(ignored: str, **pairs: tuple[str, str]) -> Callable[[str], set[str]]:
    """Return what finds the signs that open or close nothing, but for those in what is ignored."""
    skip = re.compile(ignored, re.DOTALL)
    forms = {
        name: re.compile(f"(?m)({opens})|{closes}") for name, (opens, closes) in pairs.items()
    }

    def find(text: str) -> set[str]:
        code = skip.sub(" ", text)
        found: set[str] = set()
        for name, form in forms.items():
            steps = (1 if match[1] else -1 for match in form.finditer(code))
            depths = [*accumulate(steps, initial=0)]
            if min(depths) < 0 or depths[-1]:
                found.add(f"its {name} do not match")
        return found

    return find


_SOUND: tuple[tuple[str | tuple[str, ...], Callable[[str], set[str]]], ...] = (
    (".py", _unbound),
    ((".yaml", ".yml"), _keys_twice),
    (
        ".md",
        lambda text: {"a fence is open"} if len(re.findall(r"(?m)^ *```", text)) % 2 else set(),
    ),
    (
        (".cpp", ".hpp", ".h", ".cc"),
        _unbalanced(
            rf"{_COMMENTS.pattern}|{_STRING}|'(?:\\.|[^'\\\n])'",
            braces=(r"\{", r"\}"),
            parentheses=(r"\(", r"\)"),
            conditions=(r"^[ \t]*#[ \t]*if", r"^[ \t]*#[ \t]*endif"),
        ),
    ),
    (
        _CMAKE,
        _unbalanced(
            rf"#?\[(=*)\[.*?\]\1\]|#[^\n]*|{_STRING}",
            parentheses=(r"\(", r"\)"),
            commands=(_WORDS.format(""), _WORDS.format("end")),
        ),
    ),
)


def _halves(trees: Sequence[Tree], renaming: Renaming, result: Result) -> Places:
    """Return the functions of C++ that are but declared, or but defined, and were both."""
    kinds = (".cpp", ".hpp")
    if any(path.endswith(kinds) for path in result.conflicts):
        return []
    codes = [
        {p: _NO_CODE.sub("", by.text(p, f.written)) for p, f in tree.items() if p.endswith(kinds)}
        for by, tree in zip((renaming, renaming, Renaming(), Renaming()), trees, strict=True)
    ]
    defined = [_defined(code) for code in codes]
    sides = [*zip(defined, codes, strict=True)]
    wrong: Places = []
    made = {*codes[2], *result.origins}  # what the developer has made is not merged
    classes = {cls for cls, _ in defined[2]}  # a file of another may be the developer's now
    for name in {one for one in {*defined[1], *defined[2]} if one[0] in classes}:
        is_new = _is_half(*sides[3], name) and not any(_is_half(*sides[i], name) for i in (0, 2))
        if is_new and any(name in names and _declared(code, name) for names, code in sides[1:3]):
            places = {renaming.path(defined[1].get(name, "")), defined[2].get(name, "")}
            places = {defined[3][name]} if name in defined[3] else places
            what = f"{'::'.join(name)} is but half there"
            wrong += ((path, what) for path in places if path in made)
    return wrong


def _is_half(defined: Mapping[Member, str], code: dict[str, str], member: Member) -> bool:
    return (member in defined) != _declared(code, member)


def _defined(code: dict[str, str]) -> dict[Member, str]:
    """Return the members that sources define, each with its path."""
    sources = {path: text for path, text in code.items() if path.endswith(".cpp")}
    return {member: path for path in sources for member in _DEFINITION.findall(sources[path])}


def _declared(code: dict[str, str], member: Member) -> bool:
    """Say whether a header declares a member of a class."""
    named = re.compile(rf"(?:[>&*]|\w\s)\s*(?<!return\s){member[1]}\s*\(")  # not a call
    headers = (t for path, t in code.items() if path.endswith(".hpp") and member[0] in t)
    return any(named.search(body) for text in headers for body in _bodies(text, member[0]))


@functools.lru_cache(maxsize=4096)  # of a class, whose members are asked for one after the other
def _bodies(text: str, name: str) -> list[str]:
    """Return the classes of a name, each to the bracket that ends it."""
    body = re.compile(
        rf"(?ms)^([ \t]*)[^\n;{{}}]*\b(?:class|struct)\b(?:[^;:{{]|::)*\b{name}\b[^;{{]*\{{"
        r".*?(?:^\1\}|\Z)"
    )
    return [found[0] for found in body.finditer(text)]
