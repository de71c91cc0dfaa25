"""What the developer wrote into a launch file, carried into that of another ROS.

The two are different files, with other generated elements. An element of the developer's is put
where the other file has the element that it stands in; an attribute is exchanged in the element
that has it. What means nothing in the other ROS stays behind. Decision 92: the new file
is the base.
"""

from __future__ import annotations

import contextlib
import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence

from ..data import load_data
from .blocks import Block, every
from .languages import XML
from .lines import plain, split
from .matching import Blocks, match, set_beside
from .package import Result
from .renaming import Renaming
from .tree import File, Tree, encode
from .xml_blocks import ATTRIBUTE, COMMENTS, MARKUP

_KNOWN = load_data("launch.yaml")
_SUBSTITUTION = re.compile(r"\$\(\s*([\w-]+)")
INNER = ("include",)
"""Elements whose inside is about another file."""
_ARGUMENT = re.compile(r"""<arg\s+name="(\w+)"\s+value="\$\((?:arg|var) \1\)"\s*/>""")


class ForeignError(Exception):
    """Something has no meaning in the other ROS."""


def carry_launch_files(
    mine: Tree, old: Tree, new: Tree, renaming: Renaming, result: Result, ros: int
) -> None:
    """Carry what the developer wrote into the launch files that a ROS, `ros`, calls otherwise."""
    before, after = (_KNOWN["suffixes"][n] for n in (3 - ros, ros))
    for path in result.left:
        if path not in old:
            continue
        target = renaming.path(path).removesuffix(before) + after
        if target not in new or result.tree.get(target) != new[target]:
            continue
        with contextlib.suppress(ValueError, RecursionError):
            ours, base = (
                renaming.blocks(XML, path, plain(side[path].written)) for side in (mine, old)
            )
            carried = carry(ours, base, new[target].written, ros)
            result.back[target] = carried.back
            XML.blocks(carried.text)
            result.tree[target] = File(encode(carried.text), new[target].mode)
            result.carried[path] = ([target], carried.lines)


def carry(mine: Sequence[Block], old: Sequence[Block], new: str, ros: int) -> Carrier:
    """Carry what `mine` has more than `old` into a file of another ROS, which is `new`."""
    lines = {line.strip() for block in old for line in split(block.text)}
    carrier = Carrier(XML.blocks(new), ros, lines)
    match(mine, old)
    carrier.back = deleted(mine, old, carrier.new)
    carrier.children(mine, old, [], 1)
    return carrier


def deleted(mine: Blocks, old: Blocks, new: Blocks) -> list[str]:
    """Return what the developer has deleted, and the file of another ROS has."""
    gone = Counter(keys(old)) - Counter(keys(mine))
    return sorted(key for key in gone.keys() & {*keys(new)} if " " in key)


def keys(blocks: Sequence[Block]) -> list[str]:
    """Return the keys of blocks, and of those inside of them."""
    return [block.key for block in every(blocks)]


class Carrier:
    """A launch file of the new ROS, into which is put what was written into the old one."""

    def __init__(self, new: list[Block], ros: int, generated: Collection[str]) -> None:
        self.new, self.ros, self.generated = new, ros, generated
        self.lines: dict[int, tuple[str, ...]] = {}
        """Which lines of the old one came along, and as what."""
        self.back: list[str] = []
        """What the developer had deleted from the old one."""

    @property
    def text(self) -> str:
        """Return all of it."""
        return "".join(block.text for block in self.new)

    def children(
        self, mine: Sequence[Block], old: Sequence[Block], around: list[Block], number: int
    ) -> None:
        """Carry what is in elements, `around`; `number` is that of the first line of it."""
        known = {block.key: block for block in old}
        generated = set(keys(old))
        before: list[Block] = []
        for at, block in enumerate(mine):
            base = known.get(block.key)
            with contextlib.suppress(ForeignError):
                if base is None and generated.isdisjoint(keys([block])):
                    self._insert(block, around, (before, mine[at + 1 :]), number)
                elif base:
                    self._set_attributes(block, base, number)
            if block.children:
                inner = number + len(block.lines)
                if base:
                    self.children(block.children, base.children, [*around, block], inner)
                elif not generated.isdisjoint(keys([block])):  # around what is generated
                    self.children(block.children, old, around, inner)
            before.append(block)
            number += len(split(block.text))

    def _insert(
        self, block: Block, around: list[Block], beside: tuple[Blocks, Blocks], number: int
    ) -> None:
        """Insert an element; `beside` is what stands before it, and behind it."""
        own = split(block.text)
        while own[0].strip() in self.generated and not re.match(r"\s*<\w", own[0]):
            number += 1
            del own[0]  # of a comment above, which is about a generated element
        text = translate("".join(own), self.ros, around[-1].key.split()[0] if around else "")
        passed = _ARGUMENT.fullmatch(block.text.strip())
        if passed and any(_found(self.new, f"arg {passed[1]}")):
            self._note(number, text)  # the generated file passes its arguments on by itself
            return
        places = list(self._places(block, around, *beside))
        if not places:
            raise ForeignError
        for level, at in places:
            other = level[0] if level else block
            if not any(same.key == block.key for same in level):
                level.insert(at, set_beside(Block(block.key, split(text)), other))
        self._note(number, text)

    def _note(self, number: int, text: str) -> None:
        self.lines |= {number + i: (line.strip(),) for i, line in enumerate(split(text))}

    def _places(
        self, block: Block, around: list[Block], before: Blocks, behind: Blocks
    ) -> Iterator[tuple[list[Block], int]]:
        """Yield the levels of the new file where an element belongs, each with its place."""
        outer = around[-1].key if len(around) > 1 else ""
        found = [same for same in _found(self.new, outer) if same.children]
        if outer and (found or not outer.startswith("group")):
            tag = block.key.split()[0]
            for same in found:
                if tag in _KNOWN["holds"].get(same.key.split()[0], [tag]):
                    yield same.children, len(same.children)
            return
        (root,) = (one for one in self.new if one.key == "launch")
        if block.key.startswith("arg "):
            are = [child.key.startswith("arg ") for child in root.children]
            yield root.children, len(are) - are[::-1].index(True) if any(are) else 0
            return
        # A remapping is for the nodes that come after it.
        is_for_more = block.key.split()[0].removeprefix("set_") in _KNOWN["beside_nodes"]
        siblings = keys(behind) if is_for_more else (one.key for one in reversed(before))
        for sibling in siblings:
            for level in (block.children for block in every([root])):
                names = [child.key for child in level]
                if sibling in names and not sibling.startswith("arg "):
                    yield level, names.index(sibling) + (not is_for_more)
                    return
        yield root.children, len(root.children)

    def _set_attributes(self, block: Block, base: Block, number: int) -> None:
        """Give an element of the new file the attributes that the developer has changed."""
        ours, theirs = map(_attributes, ("".join(block.lines), "".join(base.lines)))
        tag = block.key.split()[0]
        changed = {
            name: _attribute(tag, name, value, self.ros)
            for name, value in ours.items()
            if theirs.get(name) != value
        }
        found = list(_found(self.new, block.key)) if theirs.keys() <= ours.keys() else []
        for same in found:
            text = "".join(same.lines)
            for name, value in changed.values():
                if same.key == block.key or name in _attributes(text):
                    text = _with_attribute(text, name, value)
            same.lines = split(text)
        for i, line in enumerate(block.lines if found else ()):
            given = {name for name, *_ in ATTRIBUTE.findall(COMMENTS.sub("", line))}
            new = [f"{n}={v}" for name, (n, v) in changed.items() if name in given]
            if new:
                self.lines[number + i] = tuple(new)


def _found(blocks: Sequence[Block], key: str) -> Iterator[Block]:
    """Yield the outermost elements of a name: `node a` and `composable_node a` are of one."""
    tag, _, name = key.partition(" ")
    for block in blocks:
        other, _, same = block.key.partition(" ")
        if same == name and (tag.endswith(other) or other.endswith(tag)):
            yield block
    for level in [[*block.children] for block in blocks if block.key.split(" ")[0] not in INNER]:
        yield from _found(level, key)


def translate(text: str, ros: int, around: str = "node") -> str:
    """Return elements as a ROS writes them inside of the tag `around`, or raise ForeignError."""
    open_ = [around]

    def tag(match: re.Match[str]) -> str:
        if match["close"]:
            return f"</{_tag(open_.pop(), open_[-1], ros)[1]}>"
        if not match["open"]:
            return match[0]
        known, name = _tag(match["tag"], open_[-1], ros)

        def attribute(found: re.Match[str]) -> str:
            as_what, value = _attribute(known, found["name"], found["value"], ros)
            return f"{as_what}{found['sign']}{value}"

        inside = ATTRIBUTE.sub(attribute, match["attributes"])
        if not inside.endswith("/"):
            open_.append(match["tag"])
        return f"<{name}{inside}>"

    return MARKUP.sub(tag, text)


def _tag(tag: str, around: str, ros: int) -> tuple[str, str]:
    """Return what `_KNOWN` calls a tag, and what a ROS does."""
    beside = _KNOWN["beside_nodes"] if around in ("launch", "group") else {}
    names = beside if ros == 2 else {name: known for known, name in beside.items()}
    name = names.get(tag, tag)
    known = tag if ros == 2 else name
    if known not in _KNOWN["tags"] or not name or (ros == 1 and tag in beside):
        raise ForeignError
    return known, name


def _attribute(tag: str, name: str, value: str, ros: int) -> tuple[str, str]:
    """Return an attribute as a ROS writes it."""
    names: dict[str, str] = {}
    for known in _KNOWN["tags"].get(tag, []):
        pair = known if isinstance(known, dict) else {known: known}
        names |= pair if ros == 2 else {new: old for old, new in pair.items()}
    if name not in names:
        raise ForeignError
    words: Mapping[str, str] = _KNOWN["substitutions"]
    words = words if ros == 2 else {new: old for old, new in words.items()}

    def substitution(match: re.Match[str]) -> str:
        if match[1] not in words:
            raise ForeignError
        return f"$({words[match[1]]}"

    value = _SUBSTITUTION.sub(substitution, value)
    if (tag, name) == ("include", "file"):
        # By custom, packages of both ROS differ in the suffix.
        before, after = (_KNOWN["suffixes"][n] for n in (3 - ros, ros))
        if not value[1:-1].endswith(before):
            raise ForeignError
        value = value[:-1].removesuffix(before) + after + value[-1]
    return names[name], value


def _attributes(text: str) -> dict[str, str]:
    """Return those of an element, and not those of others in its line."""
    tag = _first_tag(text)
    return {name: value for name, _, value in ATTRIBUTE.findall(tag["attributes"] if tag else "")}


def _first_tag(text: str) -> re.Match[str] | None:
    return next((match for match in MARKUP.finditer(text) if match["open"]), None)


def _with_attribute(text: str, name: str, value: str) -> str:
    """Return an element, below its comments, with an attribute in the place of the one it has."""
    found = _first_tag(text)
    if found is None:
        return text
    form = rf"""(?<=\s){re.escape(name)}\s*=\s*("[^"]*"|'[^']*')"""
    tag, count = re.subn(form, lambda _: f"{name}={value}", found[0])
    if not count:
        tag = re.sub(r"\s*(/?>)$", lambda m: f" {name}={value}{m[1]}", tag)
    return text[: found.start()] + tag + text[found.end() :]
