"""Which block of one version is which of another, wherever the developer has put it.

Several blocks may have one name: an `if(UNIX)` for each node. And a developer may put a container
of their own around generated blocks: `if`, `#ifdef`, `<group>`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain, count, islice, takewhile

from .blocks import THEN, Block, every, is_condition, walk
from .lines import ALIKE, depth, margin, split
from .python_blocks import is_same_import
from .xml_blocks import is_same_dependency

Blocks = Sequence[Block]
_NUMBER = re.compile(r" #\d+$")
_MAY_OPEN = re.compile(r"#?if|namespace |group ")
_HEADING = re.compile(r"#+ ")
_ABOVE = re.compile(r"\s*(?://|#|<!--|$)")
"""A line that may stand above an item: a comment, an empty one."""
_RELATIVE = re.compile(r"\s*from \.\S* import")


class BothAroundError(ValueError):
    """Both sides have put containers of their own around one thing: `if`, `#ifdef`, `<group>`."""


def align(
    mine: Blocks, old: Blocks, new: Blocks, of_people: bool = False
) -> tuple[list[Block], list[Block], list[Block]]:
    """Return three versions in which a key is that of one thing, at one place.

    `of_people`: both sides are developers', who may put containers around what is there.
    Where both sides have put some around one thing, it raises BothAroundError.
    """
    match(new, old)
    old, new = opened(mine, old, new)
    mine = identify(mine, old, new)
    tell_apart(mine, old, new)
    _refuse_both(mine, old, new)
    known = (old,) if of_people else (old, new)
    base, theirs = (wrap(side, mine, *known, is_between=of_people) for side in (old, new))
    ours, base = (wrap(side, new, old, is_between=True) for side in (mine, base))
    return ours, base, theirs


def opened(mine: Blocks, old: Blocks, new: Blocks) -> tuple[list[Block], list[Block]]:
    """Return two versions in which nothing is around what the developer has taken out of it.

    What is new in a namespace comes in one of its own: code out of it may name that each time.
    """
    return [*_opened(old, mine, old)], [*_opened(new, mine, old)]


def _opened(side: Blocks, mine: Blocks, old: Blocks) -> Iterator[Block]:
    ours, base = _by_key(mine, _name), _by_key(old)
    alone = ours.keys() - map(_name, base)
    for block in side:
        same, was = ours.get(_name(block.key), []), base.get(block.key, [block])[0]
        items = _items(was) if _MAY_OPEN.match(block.key) else ()
        made = {_name(item.key): item for item in items}
        out = (alone & made.keys()).difference(*map(_names_in, same)) if made else set()
        children = block.children
        if out:
            by = next(_depth(ours[name][0]) - _depth(made[name]) for name in made if name in out)
            names = out if same else made.keys()
            is_scope = block.key.startswith("namespace ")
            children = [
                i for i in _items(block) if _name(i.key) not in names and (same or is_scope)
            ]
            taken = [_shifted(item, by) for item in _items(block) if item not in children]
            if taken:
                taken[0].lines[:0] = takewhile(str.isspace, block.lines)
            yield from taken
            if children and is_condition(block):
                children = [Block(THEN, [], children)]
        else:
            theirs = [child for one in same for child in one.children]
            children = [*_opened(children, theirs, was.children)]
        if children or not out:
            yield Block(block.key, block.lines, children, block.tail)


def _items(block: Block) -> Blocks:
    """Return what a container holds; nothing of a condition with alternatives."""
    if not is_condition(block):
        return block.children
    return block.children[0].children if len(block.children) == 1 else []


def identify(blocks: Blocks, old: Blocks, new: Blocks) -> list[Block]:
    """Return the developer's blocks with the keys of what they are in other versions."""
    match(blocks, old, new)
    return _unsplit(_retitled(blocks, old, new), old, new)


def _rejoined(mine: Blocks, *versions: Blocks) -> list[Block]:
    """Return blocks with generated comments above them that the developer's lines part off."""
    known = _by_key(chain(*versions))
    whole: list[Block] = []
    for block in mine:
        if block.key in known:
            heads = (takewhile(_ABOVE.match, was.lines) for was in known[block.key])
            above = {*chain.from_iterable(heads)} - {*block.lines, "\n"}
            own = [*takewhile(lambda part: _may_join(part, known), reversed(whole))][::-1]
            first = next((n for n, part in enumerate(own) if above & {*part.lines}), len(own))
            _join(block, own[first:], above)
            whole = [part for part in whole if part.lines or part.children]
            block.children = _rejoined(block.children, *(was.children for was in known[block.key]))
        else:
            block.children = _rejoined(block.children, *versions)
            _take_comment(block, whole, known)
        whole.append(block)
    return whole


def _take_comment(container: Block, above: Blocks, known: Mapping[str, Blocks]) -> None:
    """Take the comment of what leaves out of the lines above a container that begins with it."""
    for key, (*_, first) in islice(_places([container], known), 1):
        if len(known[key]) > 1:  # it stays
            return
        generated = {*known[key][0].lines} - {*first.lines}
        comments = {line for line in generated if line.lstrip().startswith(("// ", "# "))}
        for part in takewhile(lambda part: _may_join(part, known), reversed(above)):
            part.lines = [line for line in part.lines if line not in comments]


def _may_join(part: Block, known: Mapping[str, Blocks]) -> bool:
    return part.key not in known and not _HEADING.match(part.key)


def _join(block: Block, own: Blocks, above: set[str]) -> None:
    """Take what is above a block into it; of a function of the developer's, the comment alone.

    Decision 141.
    """
    if any(re.match("def |class ", part.key) or part.key.endswith("()") for part in own):
        taken = [line for line in own[0].lines if line in above]
        own[0].lines = [line for line in own[0].lines if line not in above]
    else:
        taken = [line for part in own for line in split(part.text)]
        for part in own:
            part.lines, part.children = [], []
    gap = [*takewhile(str.isspace, block.lines)] if own and own[0].lines else []
    block.lines[: len(gap)] = gap + taken


def _unsplit(mine: Blocks, old: Blocks, new: Blocks) -> list[Block]:
    """Return blocks in which what the developer has put there does not part what is generated.

    So does a heading, and an empty line between an item and the comment above it.
    """
    mine = _rejoined(mine, old, new)
    made: dict[str, set[str]] = {}
    for block in (*old, *new):
        made.setdefault(block.key, set()).update({*block.lines} - {"\n"})
    whole: list[Block] = []
    own: list[Block] = []
    for block in mine:
        if block.key in made or not whole or not _HEADING.match(block.key):
            whole, own = [*whole, *own, block], []
            continue
        own.append(block)
        if made.get(whole[-1].key, set()) & {*block.lines}:
            whole[-1].lines += [line for part in own for line in part.lines]
            own = []
    return [*whole, *own]


def _retitled(mine: Blocks, old: Blocks, new: Blocks) -> Blocks:
    """Match sections whose headings the developer has changed, and maybe the new version, too.

    So with what else holds others at the top of a file: a class, the name of a node in a file of
    parameters. What is below tells (decision 142).
    """
    ours, base, theirs = ({b.key: b for b in side if _is_titled(b)} for side in (mine, old, new))
    titles = {_title(block): key for key, block in theirs.items()}
    for key, block in ours.items():
        if key not in base and key not in theirs:
            have = {*(one.key for one in mine), *_names_in(block)}
            was = _most_like(block, (o for k, o in base.items() if k not in have))
            if not was and key.startswith("# "):
                was = _below_title(ours, base)
            came = _most_like(was, (n for k, n in theirs.items() if k not in base))
            if was and came and was.key not in theirs:
                came.key = was.key
            same = titles.get(_title(block), key)
            block.key = same if same not in have else (was or block).key
            known = (side for side in (*old, *new) if side.key == block.key)
            match(block.children, *(each.children for each in known))
    return mine


def _below_title(*sides: Mapping[str, Block]) -> Block | None:
    """Return what the last of some files has below its title, where each has one title."""
    titles = [[side[key] for key in side if key.startswith("# ")] for side in sides]
    return titles[-1][0] if all(len(found) == 1 for found in titles) else None


def _is_titled(block: Block) -> bool:
    is_container = bool(block.lines and block.children) and not is_condition(block)
    return is_container or bool(_HEADING.match(block.key))


def _title(block: Block) -> str:
    return block.lines[-1 if block.children else 0]


def _most_like(block: Block | None, others: Iterable[Block]) -> Block | None:
    """Return that of some blocks which has most of what a block holds."""
    if block is None:
        return None
    alike = {_likeness(block, other): other for other in others}
    return alike[max(alike)] if alike and max(alike) > ALIKE else None


def match(blocks: Blocks, *versions: Blocks) -> None:
    """Give blocks the keys of those that they are in other versions; the rest has its own keys.

    What a container of the developer's holds is looked for around that container.
    """
    known = _by_key(chain(*versions))
    _match(blocks, {key: same[0] for key, same in known.items()}, known)


def _match(blocks: Blocks, free: dict[str, Block], known: Mapping[str, Blocks]) -> None:
    """Match blocks with those that are `free`, which become less."""
    others = _by_key((same[0] for same in known.values()), _name)
    for name, ours in _by_key(blocks, _name).items():
        namesakes = others.get(name)
        if namesakes:
            pairs = _pairs(ours, namesakes, free)
            for place, block in enumerate(ours):
                if place in pairs:
                    _take_key(block, pairs[place], free)
                else:
                    block.key = _own_key(name, {*known, *(other.key for other in blocks)})
    for block in blocks:
        _match_changed(block, free, known)
        if block.key in known:
            match(block.children, *(same.children for same in known[block.key]))
        else:
            _match(block.children, free, known)


def _match_changed(block: Block, free: dict[str, Block], known: Mapping[str, Blocks]) -> None:
    """Match a condition that reads otherwise now, but most of what it holds is what it held.

    An import may be relative now, or its module elsewhere; a dependency may be in general now.
    """
    for is_it in (_is_relative_to, is_same_import, is_same_dependency):
        ways = [key for key, other in free.items() if is_it(block, other)]
        if block.key not in known and len(ways) == 1:
            _take_key(block, free[ways[0]], free)
    if is_condition(block) and _name(block.key) not in map(_name, known):
        inside = _names_in(block)
        alike = _most_like(
            block, (o for k, o in free.items() if is_condition(o) and _name(k) not in inside)
        )
        if alike:
            _take_key(block, alike, free)


def _is_relative_to(block: Block, other: Block) -> bool:
    module = re.fullmatch(r"from \.+(.*)", block.key)
    return bool(module and other.key.endswith(f".{module[1]}"))


def _names_in(block: Block) -> set[str]:
    return {_name(inner.key) for inner in every(block.children)}


def _likeness(one: Block, other: Block) -> float:
    """Return which part of the lines in a condition another one has."""
    ours, theirs = map(_lines_in, (one, other))
    return (ours & theirs).total() / max(ours.total(), 1)


def _lines_in(block: Block) -> Counter[str]:
    inside = "".join(child.text for child in block.children) or "".join(block.lines[1:])
    lines = inside.split("\n")
    return Counter(line.partition(": ")[0].strip() for line in lines if line.strip())


def _take_key(block: Block, other: Block, free: dict[str, Block]) -> None:
    block.key = other.key
    del free[other.key]


def _pairs(ours: Blocks, namesakes: Blocks, free: Mapping[str, Block]) -> dict[int, Block]:
    """Find out which of the blocks of one name are which of another version.

    Where there are several, it is the words that no other one has which tell: those of code before
    those of comments, as the comment above the first of them may be about all.
    """
    theirs = [other for other in namesakes if other.key in free]
    if len(ours) == len(namesakes) == 1:
        return dict(enumerate(theirs))
    likely = []
    for at, other in enumerate(theirs):
        rest = [each for each in namesakes if each is not other]
        in_code, special = (
            words(other).difference(*map(words, rest)) for words in (_words_of_code, _words)
        )
        for place, block in enumerate(ours):
            common = len(in_code & _words_of_code(block)), len(special & _words(block))
            is_same = block.text == other.text
            if is_same or common[1] or not special:
                likely.append((not is_same, *(-n for n in common), abs(place - at), place, at))
    pairs: dict[int, int] = {}
    for *_, place, at in sorted(likely):
        if place not in pairs and at not in pairs.values():
            pairs[place] = at
    return {place: theirs[at] for place, at in pairs.items()}


def _own_key(name: str, taken: set[str]) -> str:
    return next(key for n in count(2) if (key := f"{name} #{n}") not in taken)


def wrap(
    blocks: Blocks,
    mine: Blocks,
    old: Blocks,
    *others: Blocks,
    is_between: bool = False,
    by: int = 0,
) -> list[Block]:
    """Put blocks into the containers that the developer has put around them in `mine`.

    All versions but `mine` have what is known; a container without lines stands for the
    developer's. Decision 27: what is generated is merged as if they stood beside it. `is_between`:
    what `mine` has not goes where both its neighbours are. `by` is how far to the right all of
    `mine` is already.
    """
    known = _by_key(chain(old, *others))
    places = dict(_places(mine, known))
    base = {block.key for block in old}

    def shift(key: str) -> int:
        """Return how much further to the right the developer has a block."""
        return _depth(places[key][-1]) - _depth(known[key][0]) - by

    def level(blocks: Blocks) -> list[Block]:
        wrapped: list[Block] = []
        for at, block in enumerate(blocks):
            inside = wrapped
            if block.key in places:
                *around, same = places[block.key]
                moves = around or _RELATIVE.match(same.text)
                further = shift(block.key) if moves or block.children else 0
                if block.children:
                    sides = (same.children, *(side.children for side in known[block.key]))
                    inner = wrap(block.children, *sides, is_between=is_between, by=by + further)
                    block = Block(block.key, block.lines, inner, block.tail)
                if moves:
                    like = set_beside(same, _shifted(block, further)) if is_between else same
                    block = _set_like(like, block)
            else:
                around = _between(blocks, at, places) if is_between else []
                if block.children and block.key not in base:
                    block = Block(block.key, block.lines, level(block.children), block.tail)
                if around:
                    beside = next(one.key for one in reversed(blocks[:at]) if one.key in places)
                    block = _shifted(block, shift(beside))
            for container in around:
                inside = _inside(inside, container.key)
            inside.append(block)
        return wrapped

    return level(blocks)


def _between(blocks: Blocks, at: int, places: Mapping[str, tuple[Block, ...]]) -> list[Block]:
    """Return the containers that both neighbours of a block are in."""
    sides = (reversed(blocks[:at]), blocks[at + 1 :])
    around = [next((places[b.key][:-1] for b in side if b.key in places), ()) for side in sides]
    pairs = zip(*around, strict=False)
    return [one for one, other in takewhile(lambda pair: pair[0] is pair[1], pairs)]


def _places(
    mine: Blocks, known: Mapping[str, Blocks], around: tuple[Block, ...] = ()
) -> Iterator[tuple[str, tuple[Block, ...]]]:
    """Yield the keys of generated blocks, each with the containers it is in, and what it is."""
    for block in mine:
        if block.key in known:
            yield block.key, (*around, block)
        else:
            yield from _places(block.children, known, (*around, block))


def tell_apart(mine: Blocks, old: Blocks, new: Blocks) -> None:
    """Give containers of one name, put around other things by either side, keys of their own."""
    for ours, base, theirs in _levels(mine, old, new):
        known = _by_key(base)
        inside, others = (_by_container(side, known) for side in (ours, theirs))
        for block in theirs:
            if block.key in inside:
                here, there = inside[block.key], others[block.key]
                if here != there and not here & there:
                    taken = {*known, *(each.key for each in (*ours, *theirs))}
                    block.key = _own_key(_name(block.key), taken)


def _refuse_both(mine: Blocks, old: Blocks, new: Blocks) -> None:
    """Insist that the two sides have not put other containers around one thing."""
    for level in _levels(mine, old, new):
        known = _by_key(level[1])
        ours, theirs = (dict(_places(side, known)) for side in level[::2])
        inside, others = (_by_container(side, known) for side in level[::2])
        for key in ours.keys() & theirs.keys():
            around, other = ours[key][0].key, theirs[key][0].key
            both = around != key != other
            if both and (around != other or inside[around] != others[other]):
                raise BothAroundError(key)


def _levels(mine: Blocks, old: Blocks, new: Blocks) -> Iterator[tuple[Blocks, Blocks, Blocks]]:
    """Yield three versions, and those of what each generated block holds that all of them have."""
    yield mine, old, new
    known = _by_key(old)
    ours, theirs = (dict(_places(side, known)) for side in (mine, new))
    for key in ours.keys() & theirs.keys():
        sides = (ours[key][-1], known[key][0], theirs[key][-1])
        yield from _levels(*(side.children for side in sides))


def _by_container(side: Blocks, known: Mapping[str, Blocks]) -> dict[str, set[str]]:
    """Return the generated blocks that each block of the developer's holds."""
    own = (block for block in side if block.key not in known)
    return {block.key: {key for key, _ in _places([block], known)} for block in own}


def _inside(level: list[Block], key: str) -> list[Block]:
    """Return what a container of a level holds; put the container there if it is new."""
    found = next((block for block in level if block.key == key), None)
    if found is None:
        found = Block(key, [])
        level.append(found)
    return found.children


def _set_like(same: Block, block: Block) -> Block:
    """Return a block with the margin of another one, and as many empty lines above.

    It is a relative import where that one is.
    """
    shifted = set_beside(block, same)
    if relative := _RELATIVE.match(same.text):
        head = relative[0].lstrip()
        shifted.lines = [re.sub(r"\bfrom \S+ import", head, line) for line in shifted.lines]
    gaps, found = ([*takewhile(str.isspace, b.lines)] for b in (same, shifted))
    shifted.lines[: len(found)] = gaps
    return shifted


def _depth(block: Block) -> int:
    return depth(line for _, line in walk([block]))


def set_beside(block: Block, other: Block) -> Block:
    """Return a block with the margin of another one."""
    return _shifted(block, _depth(other) - _depth(block))


def _shifted(block: Block, by: int) -> Block:
    """Return a block further to the right, or to the left."""

    def shift(line: str) -> str:
        return " " * (margin(line) + by) + line.lstrip() if line.strip() else line

    children = [_shifted(child, by) for child in block.children]
    return Block(block.key, [*map(shift, block.lines)], children, [*map(shift, block.tail)])


def _by_key(blocks: Iterable[Block], of: Callable[[str], str] = str) -> dict[str, list[Block]]:
    """Return blocks by their keys, or by what `of` makes of these."""
    found: dict[str, list[Block]] = {}
    for block in blocks:
        found.setdefault(of(block.key), []).append(block)
    return found


def _name(key: str) -> str:
    return _NUMBER.sub("", key)


def _words(block: Block) -> set[str]:
    return set(re.findall(r"\w+", block.text))


def _words_of_code(block: Block) -> set[str]:
    return set(re.findall(r"\w+", re.sub(r"(?m)^\s*(//|# ).*", "", block.text)))
