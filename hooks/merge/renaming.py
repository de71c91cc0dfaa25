"""What a rename exchanges: identifiers that the model makes of a name, the paths, the keys.

The old package is rendered once more with a mark for each name that changed. Where the marks come
out, there the model has used the name, and in which form.
"""

from __future__ import annotations

import contextlib
import posixpath
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any

import yaml

from ..changes import GONE, Contexts, Mark, marked
from ..dictionary import Dictionary
from ..names import member
from ..package import SUFFIX
from . import xml_blocks
from .blocks import Block, collapsed, every
from .depth import Shift, compose, shifts
from .languages import CMAKE, CPP, MARKDOWN, MESSAGE, PYTHON, TEXT, XML, YAML, Language, language
from .lines import split
from .origins import SELF, Class, Names, classes_in, origins, related
from .python_blocks import definitions, imports
from .references import References, edited, with_packages
from .render import Renderer
from .scopes import MARK, Declared, declared, is_shared, marked_in_cpp, marked_in_python, with_ends
from .settings import STARTED
from .tokens import Word, all_words, exchange, quoted
from .tree import File, Tree

_DEEPEST = 3
"""How often a class may derive from another one: a node's of a group's of the runtime's."""
_MARK = re.compile(r"zq(\d+)[xy]", re.IGNORECASE)
_GROUPED = re.compile(r"(?m)^\s*(\w+(?:[./]\w+)+):")
_MADE = "_interface"
_OF_NODE = re.compile(r"\b([a-z]\w*)_(?:interface|impl|types|ros|harness)\b")
"""The node whose module or header, or whose namespace, is named."""
_OTHER_SIGN = str.maketrans("./", "/.")
"""Between nested names: a dot in ROS 2, a stroke in ROS 1."""
_ABOUT_TARGETS = re.compile(
    r"target_|set_target_|ament_target_|add_executable$|add_dependencies$", re.IGNORECASE
)


_Holder = tuple[str, ...]


@dataclass
class Renaming:
    """What is exchanged in which file. Paths are those before the update."""

    paths: dict[str, str] = field(default_factory=dict)
    folders: dict[str, str] = field(default_factory=dict)
    keys: dict[str, dict[str, str]] = field(default_factory=dict)
    settings: dict[str, set[tuple[_Holder, str]]] = field(default_factory=dict)
    """By file, its generated keys, each with those that it is in."""
    in_file: dict[str, dict[str, str]] = field(default_factory=dict)
    everywhere: dict[str, str] = field(default_factory=dict)
    members: dict[str, dict[str, str]] = field(default_factory=dict)
    """By file, the names that count after one of the `holders` alone."""
    packages: dict[str, str] = field(default_factory=dict)
    package: str = ""
    """Its name before the update."""
    programs: dict[str, str] = field(default_factory=dict)
    """The programs of nodes, and the classes of components, as launch files have them."""
    given: dict[str, list[Mark]] = field(default_factory=dict)
    """By program, what is renamed of the parameters and topics of its node."""
    targets: dict[str, str] = field(default_factory=dict)
    """The names of nodes, which are those of targets in CMake."""
    components: dict[str, str] = field(default_factory=dict)
    """The names of nodes, wherever they stand alone."""
    taken: dict[str, set[str]] = field(default_factory=dict)
    """By file, the identifiers of what left, which are those of another interface now."""
    generated: dict[str, dict[str, str]] = field(default_factory=dict)
    """By file, the lines that the model has made of it, each as it is after the update.

    One that is several lines then is empty.
    """
    heads: dict[str, dict[str, str]] = field(default_factory=dict)
    """By file, the heads of such lines that change, each as it is after the update."""
    ids: dict[str, dict[str, str]] = field(default_factory=dict)
    """By file of Markdown, what its diagrams call nodes and topics."""
    attributes: dict[str, dict[xml_blocks.Attribute, str]] = field(default_factory=dict)
    """By file of XML, what becomes of the value of an attribute of a generated element."""
    vocabulary: dict[str, set[str]] = field(default_factory=dict)
    """By file, the words that these lines have by themselves: they are members of nothing."""
    classes: dict[str, set[str]] = field(default_factory=dict)
    """Those of the package, with their words."""
    kin: dict[str, set[str]] = field(default_factory=dict)
    """The developer's classes that derive from one of these, or the other way, with its words."""
    roots: set[str] = field(default_factory=set)
    """What imports and includes call the package."""
    holders: Names = ()
    """What the logic calls objects of these classes."""
    own: set[str] = field(default_factory=set)
    """The developer's own modules of Python, and the names that these define, in full."""
    scopes: Declared = field(default_factory=set)
    """What the developer's C++ declares of the names that are exchanged."""
    made: dict[str, Declared] = field(default_factory=dict)
    """By file, what the model's declares."""
    names: list[tuple[str, str]] = field(default_factory=list)
    moved: dict[str, str] = field(default_factory=dict)
    """What the new version of the model renames."""
    shifts: dict[str, Shift] = field(default_factory=dict)
    """What gives a file the depth that its keys have in the new version."""
    _texts: dict[tuple[str, str], str] = field(default_factory=dict, repr=False, compare=False)

    def know(self, mine: Tree, moved: Iterable[str] = ()) -> None:
        """Read what the developer's own modules define, or hand on, and all of their C++.

        `moved` are files of the model's, which the developer calls otherwise.
        """
        self.paths |= {path: self._renamed(path) for path in moved}
        given: dict[str, str] = {}
        classes: list[Class] = []
        inner: dict[str, set[str]] = {}  # by each name, itself and what is in it

        def own(name: str) -> None:
            self.own.add(name)
            for dot in re.finditer(r"\.|$", name):
                inner.setdefault(name[: dot.start()], set()).add(name)

        stems = {PurePosixPath(path).stem: path for path in self.in_file}
        nodes = {stem.removesuffix(_MADE): p for stem, p in stems.items() if stem.endswith(_MADE)}
        for path, file in mine.items() if self.names else ():
            known = language(path, "")
            near = {*_OF_NODE.findall(file.written)} & nodes.keys()
            if path not in self.paths and known in (PYTHON, CPP) and len(near) == 1:
                for exact in (self.in_file, self.members):  # several nodes may have these
                    exact[path] = {**exact.get(path, {}), **exact[nodes[min(near)]]}
            if path.endswith((".py", ".hpp", ".h")) and not path.startswith("test/"):
                classes += classes_in(known, file.written, self.roots)  # other files see them
            if known is PYTHON:
                module = path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
                is_own, folder = path not in self.paths, PurePosixPath(path).parent.parts
                names = imports(file.written, folder) if is_own else ()
                given |= {f"{module}.{name}": target for _, name, target in names if name}
                for name in ("", *definitions(file.written)):
                    if is_own or ("." in name and name.partition(".")[0] not in self.classes):
                        own(f"{module}.{name}".rstrip("."))
            elif known is CPP:
                self.scopes |= {d for d in self._scopes(path, file.written) if is_shared(d)}
        for name, target in given.items():
            for each in [*inner.get(target, ())]:
                own(name + each[len(target) :])
        kin = related(classes, self.classes)
        self.kin = {n: kin[n] for n, *_ in classes if n in kin and n not in self.classes}
        for name in [*self.own]:
            owner, _, last = name.rpartition(".")
            if last in self.kin.get(owner.rpartition(".")[2], ()):
                self.own.remove(name)

    def _scopes(self, path: str, text: str) -> Declared:
        """Return what a file of C++ declares that the model's have nowhere, or elsewhere."""
        names = self._exact() - {name for _, name in self.made.get(path, ())}
        spaces = self.packages.keys() if path not in self.paths else set()
        own = declared(text, names, spaces).difference(*self.made.values())
        # A namespace in itself is one that two branches of a condition open.
        return own - {(around, space) for space in spaces for around in ((), (space,))}

    def _exact(self) -> set[str]:
        """Return all identifiers that are exchanged somewhere."""
        return {*self.everywhere}.union(*self.in_file.values())

    def follow(self, moved: Mapping[str, str], old: Iterable[str], new: Collection[str]) -> None:
        """Take files along that the new version of the model renames; `moved` says how."""
        before = {self._renamed(path) for path in old}
        self.moved = {
            path: target
            for path, target in moved.items()
            if path in before and path not in new and target in new and target not in before
        }

    def move(self, old: Tree, new: Tree) -> None:
        """Give the files of before the form that they have in another ROS."""
        self.shifts = shifts(old, new, self.path)
        for path, file in old.items():
            if language(path, file.written) is YAML:
                other = new.get(self.path(path), File(b""))
                before, after = ({*_GROUPED.findall(each.written)} for each in (file, other))
                keys = {**dict(zip(before, before, strict=True)), **self.keys.get(path, {})}
                swapped = {key: name.translate(_OTHER_SIGN) for key, name in keys.items()}
                found = {key: name for key, name in swapped.items() if name in after}
                self.keys[path] = self.keys.get(path, {}) | found

    def path(self, path: str) -> str:
        """Return where a file of before the update is after it."""
        renamed = self._renamed(path)
        return self.moved.get(renamed, renamed)

    def _renamed(self, path: str) -> str:
        if path in self.paths:
            return self.paths[path]
        for folder in sorted(self.folders, key=len, reverse=True):
            if path.startswith(f"{folder}/"):
                return self.folders[folder] + path[len(folder) :]
        return path

    def text(self, path: str, text: str) -> str:
        """Return a file with its identifiers exchanged."""
        if (path, text) not in self._texts:
            exchanged = with_packages(path, self._exchanged(path, text), self.packages)
            self._texts[path, text] = self._shifted(path, exchanged)
        return self._texts[path, text]

    def _shifted(self, path: str, text: str) -> str:
        found = self.shifts[path](text) if path in self.shifts else None
        return found[0] if found else text

    @property
    def references(self) -> References:
        """What becomes of the things of the package, where its name is beside theirs."""
        paths = (self._path_of_now, self._names_in)
        return References(self.package, self.programs, *paths, self.given)

    def _path_of_now(self, path: str) -> str:
        found = self.path(path)
        return path if GONE in found else found

    def _names_in(self, path: str) -> Mapping[str, str]:
        return {**self.everywhere, **self.in_file[path]} if path in self.in_file else {}

    def behind(self, path: str, text: str) -> list[int] | None:
        """Return the numbers of the lines that a file of another ROS cannot have, from 1.

        None of a file that cannot have the depth that its keys have in the new version.
        """
        if path not in self.shifts:
            return []
        found = self.shifts[path](self._exchanged(path, text))
        return found[1] if found else None

    def _exchanged(self, path: str, text: str) -> str:
        known = language(path, text)
        if known is XML:
            made, references = self.attributes.get(path, {}), self.references
            return xml_blocks.exchange(
                references.in_xml(text), lambda one: made.get(one) or references.attribute(one)
            )
        text = self.references.exchanged(known, text)
        if known is YAML:
            for keys, holders in self._parameters(path, text):
                text = _with_keys(text, keys, holders)
            return _with_nodes(text, self.components)
        if path in self.ids:
            text = _with_ids(text, self.ids[path], self.generated[path])
        exact = {**self.everywhere, **self.in_file.get(path, {})}
        members = self.members.get(path, {})
        names = {*exact, *members, *self.packages, *self.targets}
        generated = self.generated.get(path, {})
        heads = self.heads.get(path, {}) if known in _ENDS else {}
        lines = [line.strip() for line in split(text)]
        is_same = all(generated.get(line) in (None, "", line) for line in lines)
        if is_same and not heads and names.isdisjoint(re.findall(r"[A-Za-z_]\w*", text)):
            return text

        before, is_marked = text, MARK not in text
        if is_marked and known is CPP:
            own = self.scopes | self._scopes(path, text)
            text = marked_in_cpp(text, own, set().union(*self.made.values()), names)
        elif is_marked and known is PYTHON:
            with contextlib.suppress(ValueError):
                text = marked_in_python(path, text, self.own, exact, members, self.classes)
        lines = [line.strip() for line in split(text)]
        roots = self.roots | self.packages.keys()
        classes = {**self.kin, **self.classes}
        origin = origins(known, text, roots, exact.keys(), classes, self.holders)
        is_made = [line in generated for line in lines]
        owners = {(name,) for name in self.classes}
        vocabulary = (self.vocabulary.get(path, set()) & exact.keys()) | roots

        def by(word: Word) -> str:
            is_include = word.before == ("#", "include")
            is_other = is_include and word.chain and word.chain[0] not in roots
            if is_other and not (is_made[word.line] or self._includes(path, lines[word.line])):
                return word.text
            is_ours = is_made[word.line] or is_include or known not in (CPP, PYTHON)
            is_ours = is_ours or origin.has(word, vocabulary)
            if word.text in exact:
                return exact[word.text] if is_ours else word.text
            is_member = bool(word.chain) and word.before[1] != "::"
            is_member = is_member or word.before[1] == "def" or word.chain[-1:] in owners
            if word.text in members and (is_member or origin.is_argument(word)):
                return members[word.text] if origin.has(word, vocabulary) else word.text
            holder, sign = word.before
            is_target = sign == "TARGETS" or (sign == "(" and _ABOUT_TARGETS.match(holder))
            if is_target and known is CMAKE and word.text in self.targets:
                return self.targets[word.text]
            if word.text in self.packages and not word.chain and is_ours:
                is_module = sign == "import" and not lines[word.line].startswith("from ")
                is_root = word.after == "::" or sign in ("namespace", "from") or is_module
                is_root = is_root or lines[word.line].startswith("namespace ")
                is_use = word.line not in origin.from_imports
                is_root = is_root or (is_use and word.text in origin.modules)
                is_root = is_root or (known is CMAKE and holder.lower() == "project")
                return self.packages[word.text] if is_root else word.text
            return word.text

        sign = _COMMENT.get(known, "\n")
        told = {n for n in quoted(known, text) if lines[n].startswith(sign)}
        pairs = zip(split(text), split(exchange(known, text, by, names)), strict=True)
        found = "".join(
            pair[0] if n in told else _as_made(known, *pair, generated, heads)
            for n, pair in enumerate(pairs)
        )
        found = found.replace(MARK, "") if is_marked else found
        return with_ends(before, found) if known is CPP else found

    def _includes(self, path: str, line: str) -> bool:
        """Say whether a line includes a file of the model's, from the folder of its own."""
        named = re.findall('"(.*)"', line)
        return any(posixpath.normpath(f"{path}/../{each}") in self.paths for each in named)

    def _parameters(
        self, path: str, text: str
    ) -> Iterator[tuple[dict[str, str], set[_Holder] | None]]:
        """Yield the keys of a file that are exchanged, and where they are; nowhere else.

        In one of the developer's they are those of nodes' parameters; a section, or else the name
        of the file, says of which node.
        """
        if path in self.keys:
            here = {holder for holder, _ in self.settings[path]} if path in self.settings else None
            yield self.keys[path], here
            return
        nodes = {PurePosixPath(one).stem: one for one in self.settings}
        stem = re.sub("[.-]", "_", PurePosixPath(path).stem) + "_"
        of_file = max((node for node in nodes if stem.startswith(f"{node}_")), default="")
        for top in {holder[:1] for holder, _ in _settings(text)}:
            name = top[0].rpartition("/")[2] if top else "*"
            made = nodes.get(of_file if "*" in name else name, "")
            holders = {holder for holder, _ in self.settings.get(made, ())}
            inner = {h[1:] for h in holders if h} if _is_ros2(holders) else holders
            yield self.keys.get(made, {}), {(*top, *holder) for holder in inner}

    def blocks(self, known: Language, path: str, text: str) -> list[Block]:
        """Return the blocks of a file, with the names and lines that they have after the update.

        It raises ValueError where a file is not of this language.
        """
        exchanged = known.blocks(self.text(path, text))
        if path in self.keys:
            # Only the names of before tell two blocks apart, one of which has the other's name.
            before = known.blocks(self._shifted(path, text))
            shows = known in (CPP, PYTHON, XML, YAML) and not path.endswith(".cfg")
            rename(exchanged, before, self.keys[path], shows)
        return exchanged

    def words(self) -> dict[str, str]:
        """Return every word that has been exchanged somewhere."""
        found = {**dict(self.names), **self.everywhere}
        for exact in self.in_file.values():
            found |= exact
        return {before: after for before, after in found.items() if before != after}


_COMMENT = {PYTHON: "#", CPP: "//", CMAKE: "#"}
_ENDS = {
    PYTHON: re.compile(r" =(?= |$)"),
    CPP: re.compile(r" =(?= |$)"),
    MARKDOWN: re.compile(r" \|(?=(?:[^|\\]|\\.)*\|$)"),
    MESSAGE: re.compile(r"\s*(?=#|$)"),
}
"""Where the head of a line ends, that may go on as the developer likes: before a value, before the
last cell of a table, before a comment."""


def _heads(known: Language, generated: Mapping[str, str]) -> dict[str, str]:
    """Return the heads of generated lines that change, each as it will be."""
    found: dict[str, str] = {}
    ends = _ENDS.get(known)
    if not ends:
        return found
    for before, after in generated.items():
        line, made = collapsed(before), collapsed(after)
        one, other = ends.search(line), ends.search(made)
        if one and other and " " in line[: one.start()]:
            head, new = line[: one.start()], made[: other.start()]
            found[head] = new if found.get(head, new) == new else ""
    return {head: new for head, new in found.items() if new not in ("", head)}


def _as_made(
    known: Language, before: str, after: str, generated: dict[str, str], heads: dict[str, str]
) -> str:
    """Return a line whose words are exchanged; of a generated one, comment and head, too."""
    line, changed = before.strip(), after.strip()
    made, sign = generated.get(line), _COMMENT.get(known)
    is_code = known is PYTHON and re.search("['\"]", line.strip('"'))  # may be laid out anew
    is_text = known in (PYTHON, TEXT, MARKDOWN) and line == changed and not is_code
    if made and (is_text or (sign and made.partition(sign)[0] == changed.partition(sign)[0])):
        return after.replace(changed, made)
    end = _ENDS[known].search(changed) if heads else None
    was = _ENDS[known].search(line) if end else None
    start = line[: was.start()] if was else ""
    head, gap = heads.get(collapsed(start).rstrip()), start[len(start.rstrip()) :]
    return after.replace(changed, head + gap + changed[end.start() :]) if head and end else after


def plan_renames(
    answers: Mapping[str, Any],
    contexts: Contexts,
    dictionary: Dictionary,
    old: Tree,
    mine: Iterable[str],
    renderer: Renderer,
) -> Renaming:
    """Find what the renames of a spec exchange; nothing where it has none."""
    tree, marks = render_marked(answers, contexts, dictionary, renderer)
    return plan(old, tree, marks, mine, dictionary.holders) if marks else Renaming()


def render_marked(
    answers: Mapping[str, Any], contexts: Contexts, dictionary: Dictionary, renderer: Renderer
) -> tuple[Tree, Sequence[Mark]]:
    """Render a package with marks for the names of its spec, where any of them changes."""
    context, marks = marked(*contexts, dictionary)
    if not any(mark.before != mark.after for mark in marks):
        return {}, ()
    return renderer.recorded({**answers, "spec": context}).tree, marks


def rename(
    blocks: Iterable[Block], before: Iterable[Block], keys: Mapping[str, str], shows: bool = False
) -> None:
    """Give blocks the names that they have after the update; `before` are the same ones.

    `shows`: their texts show it, and one that stays only looks like the model's. What left shows
    nothing, nor does a parameter in `cfg/`, whose name is in quotes.
    """
    for block, same in zip(blocks, before, strict=True):
        key = keys.get(same.key, block.key)
        if not shows or block.text != same.text or GONE in key:
            block.key = key
        rename(block.children, same.children, keys, shows)


_DIAGRAM = re.compile(r"^ *```mermaid\n.*?^ *```", re.MULTILINE | re.DOTALL)
_LABEL = r'"[^"\n]*"'
_LABEL_OR_WORD = re.compile(rf"{_LABEL}|\w+")


def _with_ids(text: str, ids: Mapping[str, str], generated: Collection[str]) -> str:
    """Exchange the ids of diagrams in the developer's lines."""

    def exchanged(line: re.Match[str]) -> str:
        if line[0].strip() in generated:
            return line[0]
        return _LABEL_OR_WORD.sub(lambda m: ids.get(m[0], m[0]), line[0])

    return _DIAGRAM.sub(lambda diagram: re.sub(".+", exchanged, diagram[0]), text)


_ABOVE_PARAMETERS = r"[^\n]*\n(?:\s*#[^\n]*\n)*\s+ros__parameters:"


def _with_nodes(text: str, names: Mapping[str, str]) -> str:
    """Exchange the names of nodes above their parameters, in files of ROS 2."""
    pattern = "|".join(map(re.escape, names))
    form = rf"(?m)^([\"']?(?:[\w*/]*/)?)({pattern})(?=[\"']?:{_ABOVE_PARAMETERS})"
    return re.sub(form, lambda m: m[1] + names[m[2]], text) if names else text


def _with_keys(text: str, keys: Mapping[str, str], holders: Collection[_Holder] | None) -> str:
    """Exchange the keys of YAML, not its values, in `holders` alone; those of what left stay.

    Those of a group may be nested.
    """
    exact = {before: after for before, after in keys.items() if not after.endswith(GONE)}
    found = key_nodes(text) if exact else []
    tops = {holder[0] for holder, _ in found if holder}
    made = {holder[0] for holder in holders or () if holder}
    others = tops - made if made and not made & tops else set()  # the developer has named the node

    def is_ours(holder: _Holder) -> bool:
        is_own = holder and holder[0] in others and (*made, *holder[1:]) in (holders or ())
        return holders is None or holder in holders or bool(is_own)

    def now(holder: _Holder, name: str) -> str | None:
        for at in range(len(holder), -1, -1):
            group = "".join(f"{each}." for each in holder[at:])
            after = exact.get(group + name)
            if after is not None and is_ours(holder[:at]):
                is_there = after.replace("/", ".").startswith(group)
                return after[len(group) :] if is_there else None
        return None

    edits = {  # one of an anchor is there for each of its uses
        (node.start_mark.index, node.end_mark.index): (node.value, after)
        for holder, node in found
        if (after := now(holder, node.value))
    }
    return edited(text, ((*place, *names) for place, names in edits.items()))


def _is_ros2(holders: Iterable[_Holder]) -> bool:
    return any("ros__parameters" in holder for holder in holders)


def _settings(text: str) -> set[tuple[_Holder, str]]:
    return {(holder, str(key.value)) for holder, key in key_nodes(text)}


def key_nodes(text: str) -> list[tuple[_Holder, yaml.ScalarNode]]:
    """Return the keys of YAML, each with those that it is in; none of a text that is no YAML."""
    found: list[tuple[_Holder, yaml.ScalarNode]] = []

    def visit(node: yaml.Node | None, holder: _Holder) -> None:
        if isinstance(node, yaml.SequenceNode):
            for item in node.value:
                visit(item, (*holder, ""))
        for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
            if isinstance(key, yaml.ScalarNode):
                found.append((holder, key))
                visit(value, (*holder, str(key.value)))

    visit(compose(text), ())
    return found


def plan(
    old: Tree, marked: Tree, marks: Sequence[Mark], mine: Iterable[str], holders: Names = ()
) -> Renaming:
    """Find what depends on the names that changed; `mine` are the paths of the package."""
    reader = _Reader(marks)
    names = [(mark.before, mark.after) for mark in marks if not mark.is_gone]
    renaming = Renaming(names=names, holders=holders)
    nodes = (mark for mark in marks if mark.level == "component" and not mark.is_gone)
    renaming.components = {mark.before: mark.after for mark in nodes}
    owned: dict[str, set[int]] = {}
    tokens: dict[str, set[str]] = {}
    started: dict[str, set[int]] = {}  # by program, or class of a component, the marks of its node
    for path, before in _place(renaming, old, marked, reader).items():
        owned[before] = reader.numbers(path)
        text = marked[path].written
        known = language(before, text)
        found = all_words(known, text)
        tokens[before] = {word.text for word in found}
        if known in (CPP, PYTHON):
            tokens[before].add(PurePosixPath(path).stem)  # an import may name it
        plain = {
            w.text for w in found if not w.chain or w.before[1] == "::" or w.chain[-1] in SELF
        }
        renaming.vocabulary[before] = {reader.both(word)[0] for word in plain}
        renaming.generated[before] = reader.lines(text)
        renaming.heads[before] = _heads(known, renaming.generated[before])
        first, *rest = PurePosixPath(before).parts
        if known is PYTHON and f"{first}/__init__.py" in old:
            renaming.roots.add(first)
        elif known is CPP and first == "include":
            renaming.roots.add(rest[0])
        renaming.keys[before] = _keys(reader, before, text)
        if known is MARKDOWN:
            renaming.ids[before] = reader.ids(text)
        if known is YAML:
            renaming.settings[before] = _settings(old[before].written)
        if known is XML and not before.endswith(SUFFIX):  # a spec says itself what was renamed
            renaming.attributes[before] = reader.attributes(text)
            for (_, sort, value), _ in xml_blocks.attributes(text):
                if sort in STARTED:
                    started.setdefault(reader.both(value)[0], set()).update(reader.numbers(value))
    name = re.search(r"<name>\s*([\w-]+)", old.get("package.xml", File(b"")).written)
    renaming.package = name[1] if name else ""
    values = [pair for each in renaming.attributes.values() for pair in each.items()]
    renaming.programs = {before: after for (_, sort, before), after in values if sort in STARTED}
    for number, mark in enumerate(marks):
        for program in (mark.before, *mark.called):
            started.setdefault(program, set()).add(number)
    for program, numbers in started.items():
        own = [mark for mark in marks if mark.owner in numbers and mark.sort and not mark.is_gone]
        renaming.given |= {program: own} if own else {}
    renaming.classes = _classes(old, [*renaming.paths], renaming.roots)
    mine = {*mine}
    _follow_moved(renaming, mine - old.keys(), mine)
    _exchanges(renaming, reader, owned, tokens, old.keys() | mine)
    for path, file in old.items():
        if language(path, "") is CPP:
            renaming.made[path] = declared(file.written, renaming._exact())
    return renaming


def plan_moves(old: Tree, marked: Tree, marks: Sequence[Mark], mine: Iterable[str]) -> Renaming:
    """Find, in a fraction of the time, what becomes of paths alone."""
    renaming, paths = Renaming(), {*mine}
    _place(renaming, old, marked, _Reader(marks))
    _follow_moved(renaming, paths - old.keys(), paths)
    return renaming


def _place(renaming: Renaming, old: Tree, marked: Tree, reader: _Reader) -> dict[str, str]:
    """Say where the files of before go; return their paths by those of the marked ones."""
    found: dict[str, str] = {}
    for path in marked:
        before, after = next((one for one in reader.ways(path) if one[0] in old), ("", ""))
        if before:
            found[path] = before
            renaming.paths[before] = after
            if (before, after) == reader.both(path):  # else others may be there, too
                parents = (map(str, PurePosixPath(side).parents) for side in (before, after))
                renaming.folders |= zip(*parents, strict=False)
    return found


def _classes(tree: Tree, paths: Iterable[str], roots: Names) -> dict[str, set[str]]:
    """Return the classes of files, each with its words and those of what it derives from."""
    found: dict[str, set[str]] = {}
    derived: list[tuple[str, set[str]]] = []
    for path in paths:
        lines = split(tree[path].written)
        for name, bases, places in classes_in(language(path, ""), tree[path].written, roots):
            is_class = bool(places)  # no other name of one
            if is_class and (name not in found or not path.startswith("test/")):  # no stand-in
                inside = "".join(lines[places.start : places.stop])
                found.setdefault(name, set()).update(re.findall(r"\w+", inside))
                derived.append((name, bases))
    for _ in range(_DEEPEST):
        for name, bases in derived:
            found[name].update(*(found[base] for base in bases & found.keys()))
    return found


def _follow_moved(renaming: Renaming, own: Collection[str], mine: Collection[str]) -> None:
    """Rename a generated file that the developer has moved to another folder, too."""
    for before, after in [*renaming.paths.items()]:
        name, new = (PurePosixPath(path).name for path in (before, after))
        if name != new and before not in mine:
            moved = [path for path in own if PurePosixPath(path).name == name]
            for path in moved if len(moved) == 1 else ():
                target = str(PurePosixPath(renaming.path(path)).with_name(new))
                renaming.paths[path] = target
                for values in renaming.attributes.values():  # which say where it is
                    values |= {
                        (tag, name, value.replace(before, path)): made.replace(after, target)
                        for (tag, name, value), made in [*values.items()]
                        if before in value
                    }


def _exchanges(
    renaming: Renaming,
    reader: _Reader,
    owned: Mapping[str, set[int]],
    tokens: Mapping[str, set[str]],
    paths: Iterable[str],
) -> None:
    """Say which identifiers are exchanged in which files."""
    all_words = {word for file in tokens.values() for word in file}
    found = {word for word in all_words if _MARK.search(word)}
    gone = {token for token in found if reader.is_gone(token)}
    found -= gone
    inner = {token for token in found if reader.owners(token)}
    ambiguous = _ambiguous(reader, inner, all_words - found - gone)
    for token in found - inner:
        before, after = reader.both(token)
        if not reader.is_bare(token):
            renaming.everywhere[before] = after
        elif reader.level(token) == "package":
            renaming.packages[before] = after
        else:
            renaming.targets[before] = after
    for path in paths:
        exact: dict[str, str] = {}
        members: dict[str, str] = {}
        for token in inner:
            before, after = reader.both(token)
            is_here = reader.owners(token) & owned.get(path, set()) or token in tokens.get(
                path, ()
            )
            if is_here or (path not in owned and before not in ambiguous):
                (members if reader.is_bare(token) else exact)[before] = after
        for token in gone:
            before, _ = reader.both(token)
            is_here = reader.owners(token) & owned.get(path, set()) or path not in owned
            if is_here and not reader.is_bare(token):
                renaming.taken.setdefault(path, set()).add(before)
        renaming.in_file[path] = exact
        renaming.members[path] = members


def _ambiguous(reader: _Reader, marked: Iterable[str], others: Iterable[str]) -> set[str]:
    """Return the identifiers that more than one interface has, or had."""
    afters: dict[str, set[str]] = {}
    for token in marked:
        before, after = reader.both(token)
        afters.setdefault(before, set()).add(after)
    return {*others, *(before for before, found in afters.items() if len(found) > 1)}


def _keys(reader: _Reader, path: str, text: str) -> dict[str, str]:
    keys: dict[str, str] = {}
    if not _MARK.search(text):
        return keys
    known = language(path, text)
    with contextlib.suppress(ValueError):
        for block in every(known.blocks(text)):
            if _MARK.search(block.key):
                before, after = reader.both(block.key)
                keys |= reader.keys(block.key) if known is YAML else {before: after}
    return keys


class _Reader:
    """Reads marks: as the names before and after, in the form the mark has."""

    def __init__(self, marks: Sequence[Mark]) -> None:
        self.marks = marks

    def both(self, text: str) -> tuple[str, str]:
        """Return a marked text with the names before, and with those after."""
        before = _MARK.sub(lambda m: _form(m[0], self.marks[int(m[1])].before), text)
        after = _MARK.sub(lambda m: _form(m[0], self.marks[int(m[1])].after), text)
        return before, after

    def ways(self, text: str) -> Iterator[tuple[str, str]]:
        """Yield it with the names as identifiers, and as they are: `left/sensor` in a path."""
        yield self.both(text)
        before = _MARK.sub(lambda m: self.marks[int(m[1])].before, text)
        after = _MARK.sub(lambda m: self.marks[int(m[1])].after, text)
        yield before, after

    def lines(self, text: str) -> dict[str, str]:
        """Return the marked lines of a file, each as it was and will be; empty where in doubt."""
        found: dict[str, str] = {}
        for line in map(str.strip, split(text)):
            before, after = self.both(line)
            is_clear = found.get(before, after) == after and not self.is_gone(line)
            found[before] = after if is_clear else ""
        return found

    def attributes(self, text: str) -> dict[xml_blocks.Attribute, str]:
        """Return the marked attributes as they were, each with the value that it will have."""
        found: dict[xml_blocks.Attribute, str] = {}
        for (element, name, value), _ in xml_blocks.attributes(text):
            if _MARK.search(value) and not self.is_gone(value):
                for (holder, _), (before, after) in zip(
                    self.ways(element), self.ways(value), strict=True
                ):
                    found[re.sub(" .*/", " ", holder), name, before] = after
        return found

    def ids(self, text: str) -> dict[str, str]:
        """Return what diagrams call what is marked; not where some of one name keep theirs."""
        found: dict[str, str] = {}
        for word in re.findall(r"\w+", re.sub(_LABEL, "", "".join(_DIAGRAM.findall(text)))):
            before, after = self.both(word)
            is_clear = found.get(before, after) == after and not self.is_gone(word)
            found[before] = after if is_clear else before
        return found

    def keys(self, text: str) -> dict[str, str]:
        """Return a marked key as it was, with the sign of each ROS in its name, and will be."""
        _, (before, after) = self.ways(text)
        return {before.replace(".", sign): after for sign in "./"}

    def numbers(self, text: str) -> set[int]:
        return {int(number) for number in _MARK.findall(text)}

    def owners(self, text: str) -> set[int]:
        """Return the owners of the interfaces whose marks a text has."""
        owners = (self.marks[number].owner for number in self.numbers(text))
        return {owner for owner in owners if owner is not None}

    def is_gone(self, text: str) -> bool:
        """Say whether a text has the mark of what left, its name being taken."""
        return any(self.marks[number].is_gone for number in self.numbers(text))

    def level(self, text: str) -> str:
        return self.marks[min(self.numbers(text))].level

    def is_bare(self, text: str) -> bool:
        """Say whether a word is a name and nothing else."""
        return bool(_MARK.fullmatch(text))


def _form(mark: str, name: str) -> str:
    """Write a name as a mark is written: as a word, as a member, as a class, in capitals."""
    name, gone, _ = name.partition(GONE)
    plain = re.sub(r"\W+", "_", name).strip("_")
    if mark.endswith("y"):
        plain = member(name)
    elif mark.startswith("ZQ"):
        plain = plain.upper()
    elif mark.startswith("Zq"):
        plain = "".join(word[:1].upper() + word[1:] for word in plain.split("_"))
    return plain + gone
