"""Compare two contexts: what came, left, changed, and what was renamed."""

from __future__ import annotations

import copy
import itertools
import types
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from .check import CheckedSpec
from .dictionary import PACKAGE, WAS, Attribute, Component, Dictionary, Interface, nested
from .faults import SpecError, nearest
from .literals import spelled
from .names import class_name

Values = Mapping[str, Any]
Contexts = tuple[Values, Values]
"""What a package was made of, and what it is to be."""


def changed_answers(old: Values, new: Values) -> Iterator[str]:
    """Say in a line which of the answers changed, other than the spec and Copier's own."""
    for name in new:
        if name != "spec" and not name.startswith("_") and old.get(name, new[name]) != new[name]:
            yield f"~ {name}: {_shown(old[name])} -> {_shown(new[name])}"


def changes(old: Values, new: Values, dictionary: Dictionary) -> Iterator[str]:
    """Say in a line what came (+), left (-), changed (~) or was renamed (>).

    What components take from another is said of that alone.
    """
    for pair in _pairs(old, new, dictionary):
        if pair.origin:
            continue
        if pair.before is None:
            yield f"+ {pair.label}"
        elif pair.after is None:
            yield f"- {pair.label}"
        else:
            if pair.is_renamed and not pair.is_reference:
                yield f"> {pair.label}, was {pair.was}"
            yield from _attributes(pair, pair.before, pair.after)


def left(old: Values, new: Values, dictionary: Dictionary) -> Iterator[tuple[str, str]]:
    """Yield the names of the components and interfaces that left, each after its component's."""
    owner = ""
    for pair in _pairs(old, new, dictionary):
        owner = pair.name if pair.level == "component" else owner
        if pair.after is None and pair.name and not pair.is_reference:
            yield owner, pair.name


@dataclass(frozen=True)
class Mark:
    """A name that was exchanged for a mark, so that a render shows what depends on it.

    The mark is `zq<number>x`, the number being its place in the list of marks; where the filter
    `member` writes it, `zq<number>y`. Of an interface, `owner` is the number of its component's
    mark. Decision 25: no text is searched for names.
    """

    before: str
    after: str
    level: str
    owner: int | None = None
    is_gone: bool = False
    """It left, and another one has its name now; `after` is then a name that nothing has."""
    sort: str = field(default="", compare=False)
    """The format that says what it is in the ROS graph, if it is there."""
    called: tuple[str, ...] = field(default=(), compare=False)
    """Its other names before, such as that of its program."""


GONE = "__gone"
_SORTS = ("action_type", "ros_name", "dotted_name", "grouped_name")


def marked(old: Values, new: Values, dictionary: Dictionary) -> tuple[dict[str, Any], list[Mark]]:
    """Return the old context with marks for the names that changed; and the marks.

    A component whose interface was renamed has a mark too. No marks: nothing was renamed.
    """
    context = copy.deepcopy(dict(old))
    marks: list[Mark] = []
    owner: _Pair | None = None
    number: int | None = None
    pairs = list(_pairs(context, new, dictionary))
    taken = {(pair.level, pair.name) for pair in pairs if pair.is_renamed}
    for pair in pairs:
        if pair.level == "component":
            owner, number = pair, None
        is_gone = pair.after is None and (pair.level, pair.name) in taken
        if pair.is_reference or (not pair.is_renamed and not is_gone):
            continue
        if pair.level == "interface" and owner and number is None:
            number = _mark(owner, marks, None)
            _follow(owner, marks[number].before, context, dictionary)
        found = _mark(pair, marks, number if pair.level == "interface" else None)
        _follow(pair, marks[found].before, context, dictionary)
        if pair.level == "component":
            number = found
    return context, marks


def _mark(pair: _Pair, marks: list[Mark], owner: int | None) -> int:
    name = pair.was or pair.name
    prefix = name[: len(name) - len(name.lstrip("~/"))]
    is_gone = pair.after is None
    after = pair.name + GONE if is_gone else pair.name
    item: Any = pair.before
    formats = {attribute.format for attribute in pair.attributes.values()}
    sort = next((each for each in _SORTS if each in formats), "")
    if any(each.gives and item.get(each.name) for each in pair.attributes.values()):
        sort = ""  # a parameter has its name there
    others = [each.name for each in pair.attributes.values() if each.same_as == pair.naming]
    called = tuple(item[each] for each in others if each in item)
    marks.append(Mark(name, after, pair.level, owner, is_gone, sort, called))
    mark = f"zq{len(marks) - 1}x"
    item[pair.naming] = prefix + mark
    for attribute in pair.attributes.values():
        if attribute.same_as == pair.naming and item.get(attribute.name) == name:
            item[attribute.name] = prefix + mark
    if "class_name" in item:
        item["class_name"] = class_name(mark)
    return len(marks) - 1


def _follow(pair: _Pair, name: str, context: Values, dictionary: Dictionary) -> None:
    """Give what components take from an element of a name the mark that this name has now."""
    kind = dictionary.components.get(pair.label.split()[0])
    if pair.level != "component" or not kind or not kind.is_shared:
        return
    item: Any = pair.before
    mark = item[kind.naming]
    for component in dictionary.components.values():
        for inner in component.interfaces.values():
            key = inner.naming if inner.taken == kind.tag else kind.tag
            for owner in component.of(context):
                for user in inner.of(owner):
                    if user.get(key) == name:
                        user[key] = mark


def places(spec: CheckedSpec, dictionary: Dictionary) -> dict[str, str]:
    """Return where each element of a spec is, for messages, by what `changes` calls it."""
    kinds: dict[str, Component | Interface] = {}
    for component in dictionary.components.values():
        kinds[component.tag] = component
        kinds |= {kind.kind: kind for kind in nested(component.interfaces)}
    found = {}
    for item in [*spec.elements, *spec.shared]:
        owners = [each for each in item.owners.values() if each.tag in kinds]
        names = [_name(each.values, kinds[each.tag].naming) or each.tag for each in owners]
        kind = kinds.get(item.tag)
        own = _name(item.values, kind.naming) if kind else ""
        found[_label(item.tag, own, ".".join(names))] = spec.place(item.element)
    return found


def check_names_before(
    old: Values, new: Values, dictionary: Dictionary, places: Mapping[str, str]
) -> None:
    """Insist that every `was` names something, and no two the same.

    That of what components take counts where any of them has known it.

    Raises:
        SpecError: one does not; `places` says where it is, as the function of this name gives it.

    """
    pairs = list(_pairs(old, new, dictionary))
    lines = {pair.label: places.get(pair.label, "").split(" (")[0] for pair in pairs}
    right = {lines[pair.label] for pair in pairs if _is_right(pair)}
    for pair in pairs:
        was = (pair.after or {}).get(WAS)
        if was is None or lines[pair.label] in right:
            continue
        others = [name for name in pair.others if name != pair.name]
        remedy = f", or name one that is renamed: {', '.join(others)}" if others else ""
        raise SpecError(
            f'{places[pair.label]}: was="{was}": the last update knew no such'
            f" {pair.label.split()[0]}, or it has gone to another;"
            f" {nearest(str(was), others)}remove was{remedy}",
            "unknown-was",
        )


def _is_right(pair: _Pair) -> bool:
    """Tell whether a name before is that of something, or has been carried out before."""
    was = (pair.after or {}).get(WAS)
    is_done = pair.before is not None and pair.before.get(WAS) == was
    return was is not None and (pair.is_renamed or was == pair.name or is_done)


def as_parted(
    histories: Sequence[Sequence[Values]], new: Values, dictionary: Dictionary
) -> Contexts:
    """Return where the first history ends, and what it is to be, with names as all began.

    Histories are contexts that follow one another, from one that all have in common. One may have
    renamed a thing more than once, and `new` says the last of the names before, which the others
    never had.
    """
    memos: tuple[dict[int, Any], dict[int, Any]] = ({}, {})
    ends = (histories[0][-1], new)
    context, spec = (copy.deepcopy(end, memo) for end, memo in zip(ends, memos, strict=True))
    for number, history in enumerate(histories):
        names = _first_names(history, dictionary)
        for pair in _pairs(history[-1], new, dictionary):
            before, after = pair.before, pair.after
            first = names.get(id(before))
            if before is None or first is None:  # it came on the branch
                continue
            items = [(before, memos[0][id(before)])] if number == 0 else []
            name = _name(before, pair.naming)
            has = (after or {}).get(WAS)
            if has in (name, before.get(WAS)):
                items.append((after or {}, memos[1].get(id(after), {})))
            for given, item in items:
                if given.get(WAS) is not None or first != name:  # else another history may say it
                    item[WAS] = first
    return context, spec


def _first_names(history: Sequence[Values], dictionary: Dictionary) -> dict[int, str]:
    """Return, by the identity of an item of the last context, its name in the first one.

    One in between may lack an item, where the branch has merged another one later.
    """
    names: dict[int, str] = {}
    for old, new in itertools.pairwise([history[0], *history]):
        begun, gone_on = (
            [p for p in _pairs(before, new, dictionary) if p.before and p.after]
            for before in (history[0], old)
        )
        found = {id(p.after): _name(p.before, p.naming) for p in begun if p.before}
        found |= {id(p.after): names[id(p.before)] for p in gone_on if id(p.before) in names}
        names = found
    return names


def _label(kind: str, name: str, path: str) -> str:
    """Name an item in a line: `node arm`, `publisher pose on arm`."""
    return " ".join(filter(None, (kind, name, path and f"on {path}")))


@dataclass(frozen=True)
class _Pair:
    """An item of the old context and the same item of the new one, where there is one.

    `others` are the names that left.
    """

    before: Values | None
    after: Values | None
    attributes: Mapping[str, Attribute]
    naming: str | None
    others: tuple[str, ...] = ()
    label: str = PACKAGE
    level: str = "interface"
    origin: str | None = None
    """The tag of what components take it from."""
    is_reference: bool = False
    """It takes another element, whose name it says."""

    @property
    def was(self) -> str | None:
        return _name(self.before, self.naming) if self.before and self.after else None

    @property
    def name(self) -> str:
        return _name(self.after or self.before or {}, self.naming)

    @property
    def is_renamed(self) -> bool:
        return self.was is not None and self.was != self.name


def _pairs(old: Values, new: Values, dictionary: Dictionary) -> Iterator[_Pair]:
    """Pair the packages, components, and inside of those that stayed, interfaces."""
    naming = dictionary.naming
    name, was = _name(old, naming), str(new.get(WAS))
    package = _Pair(old, new, dictionary.package, naming, (name,), level=PACKAGE)
    if package.is_renamed and was != name:  # another package, as far as anybody has said
        same = {**new, naming: name}
        package = replace(package, after=same)
    yield package
    components = sorted(dictionary.components.values(), key=lambda each: not each.is_shared)
    renamed: dict[tuple[str, str], str] = {}
    for component in components:
        for pair in _partners(old, new, component):
            if pair.was:
                renamed[component.tag, pair.was] = pair.name
            yield replace(pair, label=_label(component.tag, pair.name, ""), level="component")
            yield from _inside(pair, component, pair.name, renamed)


def _inside(
    pair: _Pair,
    kind: Component | Interface,
    path: str,
    renamed: Mapping[tuple[str, str], str],
    origin: str | None = None,
) -> Iterator[_Pair]:
    """Pair what stands inside of two items of a kind, where both are there; `path` names them.

    `renamed` has the names of what components take, by tag and name before; `origin` is the tag
    of what the pair was taken from.
    """
    if pair.before is None or pair.after is None:
        return
    tags = {inner.taken for inner in kind.interfaces.values() if inner.taken}
    for inner_kind in kind.interfaces.values():
        tag = inner_kind.taken
        names = {was: name for (of, was), name in renamed.items() if of == tag}
        for inner in _partners(pair.before, pair.after, inner_kind, names):
            sides = [side for side in (inner.before, inner.after) if side is not None]
            own = next((t for t in tags if all(t in side for side in sides)), origin)
            label = _label(inner_kind.kind, inner.name, path)
            yield replace(inner, label=label, origin=own, is_reference=tag is not None)
            within = f"{path}.{inner.name or inner_kind.kind}"
            yield from _inside(inner, inner_kind, within, renamed, own)


def _partners(
    old: Values,
    new: Values,
    kind: Component | Interface,
    renamed: Mapping[str, str] = types.MappingProxyType({}),
) -> Iterator[_Pair]:
    """Pair what has the same name, or had it before; None where there is no partner.

    A `was` counts once: the context that an update has recorded has it already. `renamed` has
    the names now of those before that items of the kind refer to.
    """
    left: dict[str, Values] = {}
    for item in kind.of(old):
        name = _name(item, kind.naming)
        left[renamed.get(name, name)] = item
    items = kind.of(new)
    partners: dict[int, Values | None] = {}
    for number, item in enumerate(items):  # renamed before
        name, was = _name(item, kind.naming), item.get(WAS)
        if was is not None and name in left and left[name].get(WAS) == was:
            partners[number] = left.pop(name)
    for number, item in enumerate(items):
        if number not in partners and item.get(WAS) in left:
            partners[number] = left.pop(str(item[WAS]))
    for number, item in enumerate(items):
        if number not in partners:
            partners[number] = left.pop(_name(item, kind.naming), None)
    for number, item in enumerate(items):
        if partners[number] is None and item.get(WAS) is not None:  # renamed again, or by another
            same = [name for name, one in left.items() if one.get(WAS) == item[WAS]]
            partners[number] = left.pop(same[0]) if len(same) == 1 else None
    for number, item in enumerate(items):
        yield _Pair(partners[number], item, kind.attributes, kind.naming, tuple(left))
    for item in left.values():
        yield _Pair(item, None, kind.attributes, kind.naming)


def _attributes(pair: _Pair, before: Values, after: Values) -> Iterator[str]:
    """Compare the values of two items, but for their names."""
    for name, attribute in pair.attributes.items():
        source = attribute.same_as or name
        is_told = name != source and (before.get(source), after.get(source)) == (
            before.get(name),
            after.get(name),
        )
        if name == pair.naming or name not in before or is_told:
            continue
        if before[name] != after.get(name):
            yield f"~ {pair.label}: {name} {_shown(before[name])} -> {_shown(after.get(name))}"


def _shown(value: Any) -> str:
    text = " ".join(spelled(value).split())
    return f'"{text[:37]}..."' if len(text) > 40 else text or '""'


def _name(item: Values, naming: str | None) -> str:
    """Return the value of the attribute that names an item."""
    return str(item.get(naming)) if naming else ""
