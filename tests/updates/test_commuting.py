"""Edits of two developers that do not meet are joined to what the one makes of the other's file.

The files are those of an example; the edits are made of their blocks, the results are texts.
"""

import ast
import functools
from dataclasses import dataclass
from random import Random

import pytest

from hooks.merge.branches import people
from hooks.merge.languages import CMAKE, CPP, PYTHON, XML, language
from hooks.merge.tree import File
from hooks.package import SUFFIX
from support.repository import EXAMPLES

MARKS = {PYTHON: "  # {}", CPP: "  // {}", XML: "  <!-- {} -->", CMAKE: "  # {}"}
"""What a developer may write at the end of a line."""
OWN = {PYTHON: "{} = 1", CPP: "int {};", XML: '<arg name="{}"/>', CMAKE: "set({} 1)"}
"""What they may write beside a block."""
AROUND = {
    PYTHON: ("if {}:", "", "    "),
    CPP: ("#ifdef {}", "#endif", ""),
    XML: ('<group if="{}">', "</group>", ""),
    CMAKE: ("if({})", "endif()", ""),
}
"""What they may put around blocks: before, behind, and how far these move to the right."""
FIXED = ("#ifndef", "#define", "header", "docstring")
"""What stands first in a file, in this order."""


def margin(block):
    line = next(line for line in block.text.split("\n") if line.strip())
    return line[: len(line) - len(line.lstrip())]


def shift(block, by):
    block.lines, block.tail = (
        [by * bool(line.strip()) + line for line in part] for part in (block.lines, block.tail)
    )
    for child in block.children:
        shift(child, by)


@dataclass
class Place:
    """A block, the list that it is in, and the lines that it has, the empty ones not counted."""

    block: object
    level: list
    start: int
    end: int


def places(blocks, start=0):
    """Yield all blocks of a file, from its first to its last line."""
    for block in blocks:
        end = start + sum(bool(line.strip()) for line in block.text.split("\n"))
        yield Place(block, blocks, start, end)
        head = sum(bool(line.strip()) for line in block.lines)
        yield from places(block.children, start + head)
        start = end


KINDS = ("behind", "beside", "around", "move", "delete")
"""What a developer may do to a block, in the order in which one edit leaves another its places."""


@dataclass
class Edit:
    """What a developer does to a block: which one, what, the word that they write, and the end."""

    number: int
    kind: str
    word: str
    last: int = 0

    def lines(self, found):
        """Return the lines that it needs as they are."""
        place = found[self.number]
        last = found[self.last].end
        if self.kind == "around":
            return {place.start - 1, place.start, last - 1, last}
        if self.kind in ("move", "delete"):
            return {*range(place.start - 1, place.end + 1), last - 1, last}
        return {place.end - 1, place.end} if self.kind == "beside" else {place.start}

    def apply(self, known, found):
        place = found[self.number]
        block, level = place.block, place.level
        at = next(i for i, other in enumerate(level) if other is block)
        if self.kind == "behind":
            line = next(i for i, line in enumerate(block.lines) if line.strip())
            block.lines[line] = f"{block.lines[line].rstrip()}{MARKS[known].format(self.word)}\n"
        elif self.kind == "beside":
            own = f"{margin(block)}{OWN[known].format(self.word)}\n"
            level.insert(at + 1, type(block)("own", [own]))
        elif self.kind == "delete":
            level.remove(block)
        else:
            last = next(i for i, each in enumerate(level) if each is found[self.last].block)
        if self.kind == "move":
            level.insert(last + 1, block)
            del level[at]
        if self.kind == "around":
            inside = level[at : last + 1]
            before, behind, by = AROUND[known]
            heads = [text for text in (before.format(self.word), behind) if text]
            lines = [f"{margin(block)}{text}\n" for text in heads]
            for each in inside:
                shift(each, by)
            level[at : last + 1] = [type(block)("around", lines[:1], inside, lines[1:])]


def edited(known, text, edits):
    """Return a text with edits, or nothing where these cannot be, as of two that cross."""
    blocks = known.blocks(text)
    found = [*places(blocks)]
    try:
        for edit in sorted(edits, key=lambda edit: (KINDS.index(edit.kind), -edit.number)):
            edit.apply(known, found)
        result = "".join(block.text for block in blocks)
        known.blocks(result)
        return result if known is not PYTHON else ast.unparse(ast.parse(result)) and result
    except (StopIteration, SyntaxError, ValueError):
        return None


def an_edit(random, found, own):
    """Choose one; what two of them put around blocks may be alike, as `if(BUILD_TESTING)`."""
    parts = [i for i, place in enumerate(found) if place.start < place.end]
    number = random.choice([i for i in parts if found[i].block.key not in FIXED])
    level = found[number].level
    after = [i for i, place in enumerate(found) if place.level is level and i >= number]
    kind = random.choice(KINDS)
    word = random.choice(["one", "two"]) if kind == "around" else own
    return Edit(number, kind, word, random.choice(after[:3]))


@functools.cache
def files():
    """Return the texts of an example by their paths, of those that have what edits need."""
    folders = [EXAMPLES / f"all_kinds/{model}_model/noetic" for model in ("python", "cpp")]
    paths = [path for folder in folders for path in sorted(folder.rglob("*")) if path.is_file()]
    texts = [(path.name, path.read_text()) for path in paths if path.stat().st_size > 500]
    texts = [(name, text) for name, text in texts if not name.endswith(SUFFIX)]
    return [(name, text) for name, text in texts if language(name, text) in OWN]


@pytest.mark.parametrize("seed", range(8))
def test_edits_that_do_not_meet_are_joined(seed):
    random, tried = Random(seed), 0
    while tried < 20:
        path, text = random.choice(files())
        known = language(path, text)
        found = [*places(known.blocks(text))]
        words = [f"own_{number}" for number in range(random.choice([2, 4]))]
        edits = [an_edit(random, found, word) for word in words]
        lines = [line for edit in edits for line in edit.lines(found)]
        sides = [edited(known, text, part) for part in (edits[::2], edits[1::2])]
        wanted = edited(known, text, edits)
        if len(lines) > len({*lines}) or None in (*sides, wanted):
            continue
        tried += 1
        trees = [{path: File(each.encode())} for each in (sides[0], text, sides[1])]
        result, wrong = people(*trees).merged()
        assert (wrong, result.conflicts) == ([], {}), (path, edits)
        both = (each.split("\n") for each in (result.tree[path].text, wanted))
        lines, expected = ([*filter(str.strip, each)] for each in both)
        assert lines == expected, (path, edits)
