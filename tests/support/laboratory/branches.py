"""Pairs of branches: two developers edit a package, change its spec and update; then they merge.

They have edited it together before. Each line has its mark; the judge looks for all of them, and
for the template's side.
"""

import copy
import re
from collections import Counter
from dataclasses import dataclass, field, replace

from hooks.faults import SpecError
from hooks.merge.branches import Branches, Joiner
from hooks.merge.render import Render
from hooks.merge.tree import LINK, File, encode
from hooks.merge.versions import Versions
from support.laboratory import specs
from support.laboratory.edits import edit
from support.laboratory.judge import CONFLICT, _readable, judge
from support.laboratory.trials import (
    ANSWERS,
    DISTROS,
    MODELS,
    _said,
    moves,
    renamed,
    tree_of,
)

SPEC = "lab.ros_package"


@dataclass
class Counts:
    """What a number of pairs gave."""

    pairs: int = 0
    lines: int = 0
    clean: int = 0
    both_edited: int = 0
    """Files that both developers have edited since they were one."""
    conflicts: Counter = field(default_factory=Counter)
    moved: Counter = field(default_factory=Counter)
    """The same in pairs of which one moves to the other ROS."""
    wrong: list = field(default_factory=list)
    refused: list = field(default_factory=list)

    def row(self):
        return (
            f"{self.pairs} pairs, {self.lines} lines, {self.both_edited} files edited by both:"
            f" {len(self.wrong)} wrong, {len(self.refused)} refused, {self.clean} clean,"
            f" conflicts {dict(self.conflicts)},"
            f" in moves to the other ROS {dict(self.moved)}"
        )


class Renders:
    """Renders of Jinja in the place of Copier's, by the version that answers name."""

    def __init__(self, laboratory, model):
        self.laboratory, self.model = laboratory, model
        self.known = {}

    def recorded(self, answers):
        key = repr(answers)
        if key not in self.known:
            renderer = self.laboratory.renderers[answers["_commit"], self.model]
            self.known[key] = renderer.render(answers["spec"], answers["ros_distro"])
        tree = tree_of(self.known[key])
        return Render(tree, {SPEC, "CHANGELOG.md"}.__contains__)

    fresh = recorded


class Joining(Joiner):
    """Joins commits that are in memory."""

    commits: dict
    """By name, the files of each, its answers, and the contexts that have led to it."""

    def recorded(self, commit):
        return self.commits[commit][1]

    def history(self, base, commit):
        return self.commits[commit][2]

    def files(self, commit):
        return self.commits[commit][0]


@dataclass
class Branch:
    """What a developer has made of a package, and what it was made of."""

    edited: object
    answers: dict
    pair: object
    contexts: list
    """That of each update of it."""


def grown(random, laboratory, spec, model, distros, versions, edited, number, **options):
    """Let a developer change the spec, update and edit; None where the update conflicts."""
    new_spec = specs.change(random, spec)
    pair = laboratory.pair(spec, new_spec, model, distros, versions[1], versions[0])
    edited = copy.deepcopy(edited)
    trees = (edited.tree(), tree_of(pair.old), tree_of(pair.new))
    to_ros = {"noetic": 1}.get(distros[1], 2) if distros[0] != distros[1] else None
    result = Versions(*trees, pair.renaming, pair.is_kept, to_ros).merged()[0]
    if result.conflicts:
        return None
    texts = _texts(result.tree)
    edited.follow(texts, moves(pair, edited), renamed(pair, edited))
    edited.around = edited.around if distros[0] == distros[1] else {}
    edited.number = number
    try:
        edited = edit(random, texts, edited=edited, **options)
    except StopIteration:  # a file of theirs without the imports that the laboratory wants
        return None
    edited.texts[SPEC] = pair.new[SPEC]
    if any(fault for path, text in edited.texts.items() for fault in _readable(path, text)):
        return None  # no developer would commit it
    found = answers(laboratory, model, new_spec, distros[1], versions[1])
    return Branch(edited, found, pair, [found["spec"]])


def grown_again(random, laboratory, branch, model, distro, version, **options):
    """Go on with a branch; what was renamed before may be renamed once more."""
    spec = copy.deepcopy(branch.pair.new_spec)
    if random.random() < 0.5 and not model.startswith("mixed"):  # whose languages go by names
        for _, holder, items in _holders(spec):
            for item in (holder, *items):
                item["was"] = None
    about = (model, (distro, distro), (version, version), branch.edited, branch.edited.number)
    found = grown(random, laboratory, spec, *about, **options)
    return found and replace(found, contexts=branch.contexts + found.contexts)


def _texts(tree):
    files = ((path, file.text) for path, file in tree.items() if file.mode != LINK)
    return {path: text.replace("\r\n", "\n") for path, text in files if text is not None}


def answers(laboratory, model, spec, distro, version):
    xml = specs.xml(spec, model)
    context = laboratory.models[model].context(xml.encode(), SPEC, distro)
    return {"_commit": version, "ros_distro": distro, "spec": context}


def identified(spec):
    """Give each named thing an identity that its names do not have."""
    spec = copy.deepcopy(spec)
    for _, holder, items in _holders(spec):
        for item in (holder, *items):
            item["id"] = item["name"]
    return spec


def _holders(spec):
    """Yield each node with its interfaces, and each type with the fields of each of its parts."""
    for node in spec["nodes"]:
        yield _identity(node), node, node["items"]
    for type_ in spec.get("types", ()):
        for part, fields in type_["parts"].items():
            yield (type_["kind"], _identity(type_), part), type_, fields


def _identity(item):
    return item.get("id") or f"{item['name']}, which is new"


def merged_spec(base, ours, theirs):
    """Resolve the spec as developers would: what both have done; of two changes of one, ours."""
    sides = (base, ours, theirs)
    holders = "types" if "types" in ours else "nodes"
    merged = _merged(*(side[holders] for side in sides))
    return {**ours, holders: merged or ours[holders]}


def _merged(base, ours, theirs):
    known, one, other = ({_identity(item): item for item in s} for s in (base, ours, theirs))
    found = []
    for key in [*one, *(key for key in other if key not in one)]:
        sides = [side.get(key) for side in (known, one, other)]
        if sides[0] and not (sides[1] and sides[2]):
            continue  # one has removed it
        item = _merged_item(*sides) if sides[1] and sides[2] else sides[1] or sides[2]
        if not specs.names_of(item) & {name for each in found for name in specs.names_of(each)}:
            found.append(item)
        elif item.get("was") and item["name"] not in {each["name"] for each in found}:
            found.append(item)  # two that swap names, or one that takes the name of another
    return found


def _merged_item(base, ours, theirs):
    if base is None:
        base = {}
    item = {
        name: ours.get(name) if ours.get(name) != base.get(name) else theirs.get(name)
        for name in {*ours, *theirs} - {"items", "parts"}
    }
    renamed_by = ours if ours["name"] != base.get("name") else theirs
    item |= {name: renamed_by.get(name) for name in ("name", "was")}
    if "items" in ours:
        items = _merged(*(side.get("items", []) for side in (base, ours, theirs)))
        item["items"] = items
    if "parts" in ours:
        sides = [side.get("parts", {}) for side in (base, ours, theirs)]
        item["parts"] = {
            part: _merged(*(side.get(part, []) for side in sides)) for part in sides[1]
        }
    return item


def pair_of_branches(random, laboratory, model, distro, counts, **options):
    """Make two branches, join and judge them; return the complaints.

    There are none, and nothing is counted, where the two have made what cannot be.
    """
    made = joined(random, laboratory, model, distro, counts, **options)
    return judged(*made, counts) if made else []


def joined(random, laboratory, model, distro, counts, **options):
    """Make two branches and join them; return what `judged` takes, if it is anything."""
    has_nodes = model != "interfaces_model"
    spec = identified((specs.random_spec if has_nodes else specs.random_interfaces)(random))
    versions, distros = ["1.0.0", "1.0.0"], [distro, distro]
    if model in MODELS and random.random() < 0.2:
        versions[random.randint(0, 1)] = "2.0.0"
    if random.random() < 0.1:
        distros[1] = next(one for one in DISTROS if one != distro)
    start = laboratory.pair(spec, spec, model, (distro, distro), "1.0.0")
    together = edit(random, start.old, **options)
    together.texts[SPEC] = start.old[SPEC]
    sides = []
    for number, (to, version) in enumerate(zip(distros, versions, strict=True), 1):
        about = (model, (distro, to), ("1.0.0", version), together, 1000 * number)
        side = grown(random, laboratory, spec, *about, **options)
        if side and random.random() < 0.3:
            about = (laboratory, side, model, to, version)
            side = grown_again(random, *about, **options)
        sides.append(side)
    if None in sides:
        return None
    new_spec = merged_spec(spec, *(side.pair.new_spec for side in sides))
    version = max(versions)
    try:
        new = answers(laboratory, model, new_spec, distros[1], version)
        layout = laboratory.pair(spec, new_spec, model, (distro, distros[1]), version).layout
    except SpecError:  # the two have made what no package can have
        return None
    renders = Renders(laboratory, model)
    dictionary = laboratory.models[model].dictionary
    joiner = Joining(None, ANSWERS, new, renders, dictionary, layout)
    before = answers(laboratory, model, spec, distro, "1.0.0")
    joiner.commits = {
        name: (side.edited.tree(), side.answers, [before["spec"], *side.contexts])
        for name, side in zip(("ours", "theirs"), sides, strict=True)
    }
    joiner.commits["base"] = (together.tree(), before, [before["spec"]])
    now = {SPEC: File(encode(specs.xml(new_spec, model)))}
    try:
        result = joiner.join(Branches("ours", "theirs", ["base"]), now)
    except SpecError as error:
        counts.refused.append(str(error))
        return None
    fresh = {path: file.text for path, file in renders.fresh(new).tree.items()}
    return sides, result, new_spec, fresh | _texts(now), {*together.lines}


def spoiled(mutate, sides, join, *more):
    """Return what `joined` gave as a mutant makes it, which leaves that as it is.

    There is nothing where the mutant has changed nothing of the developers'.
    """
    join = replace(join, result=replace(join.result, tree={**join.result.tree}))
    return (sides, join, *more) if mutate(join) else None


def judged(sides, joined, new_spec, fresh, together, counts):
    """Judge each side, brought to the new spec, and then both as one."""
    complaints, parts, said = [], [], set()
    for branch, side in zip(sides, joined.sides, strict=True):
        edited = copy.deepcopy(branch.edited)
        spec, renaming = branch.pair.new_spec, side.versions.renaming
        pair = replace(
            branch.pair,
            spec=spec,
            new_spec=seen_from(spec, new_spec),
            old=branch.pair.new,
            new=fresh,
            renaming=renaming,
            layout=dict(renaming.moved),
        )
        left = {m for *_, line in side.proof.left for m in re.findall(r"\bmine_\d+\b", line)}
        said |= left
        left |= {*side.result.left, *_said(side.result.removed)}
        missing = {path for path, parts in side.result.missing.items() if "" in parts}
        missing |= {*_said(side.result.missing)}
        places, names = moves(pair, edited), renamed(pair, edited)
        edited.texts[SPEC] = fresh[SPEC]
        tree = {**side.result.tree, SPEC: File(encode(fresh[SPEC]))}
        found = judge(edited, pair.old, fresh, tree, left, missing, places, names)
        complaints += [f"side: {line}" for line in found]
        texts = _texts(tree)
        edited.follow(texts, places, names)
        edited.texts = texts
        parts.append(edited)
    for part, other in zip(parts, reversed(parts), strict=True):
        _take_over_moves(part, other, joined.result.tree)
    both, result = union(*parts, together), joined.result
    tree = result.tree
    conflicts = {*result.conflicts} | {p for p, text in _texts(tree).items() if CONFLICT in text}
    gone = {f"{p[0]}: {p[1]}" if isinstance(p, tuple) else p for p in both.deleted}
    found = judge(both, fresh, fresh, tree, said, gone, {}, {})
    in_conflict = tuple(f"{path}:" for path in conflicts)
    complaints += [line for line in found if not line.startswith(in_conflict)]
    counts.pairs += 1
    counts.lines += len(both.lines)
    counts.clean += not conflicts
    one, other = (part.texts for part in parts)
    counts.both_edited += sum(
        len({text, other.get(path), fresh.get(path)}) == 3 for path, text in one.items()
    )
    is_move = len({side.answers["ros_distro"] for side in sides}) > 1
    for path in conflicts:
        where = counts.moved if is_move else counts.conflicts
        where[re.sub(r"\w+(?=_(impl|ros|interface|node))", "node", path)] += 1
    counts.wrong += complaints
    return complaints


def seen_from(spec, new_spec):
    """Return the new spec with the names before that things have on a branch."""
    new_spec = copy.deepcopy(new_spec)
    known = {}
    for place, holder, items in _holders(spec):
        known[place] = holder["name"]
        known |= {(place, _identity(item)): item["name"] for item in items}
    for place, holder, items in _holders(new_spec):
        names = [known.get(place), *(known.get((place, _identity(item))) for item in items)]
        for one, was in zip((holder, *items), names, strict=True):
            one["was"] = was if was != one["name"] else None
    return new_spec


def _take_over_moves(part, other, tree):
    """Put what a developer has done in the files that the other one has moved.

    Of a file that both have moved, it goes to the place that is there.
    """
    at = {origin: path for path, origin in part.moved.items() if path not in tree}
    moves = {
        at.get(origin, origin): path
        for path, origin in other.moved.items()
        if path not in part.texts and (origin in part.texts or origin in at) and path in tree
    }
    texts = {moves.get(path, path): text for path, text in part.texts.items()}
    moved = {moves.get(path, path): origin for path, origin in part.moved.items()}
    part.follow(texts, moves, {})
    part.texts, part.moved = texts, moved


def union(ours, theirs, together):
    """Return the edits of two developers as those of one; `together` are marks both began with."""
    both = copy.deepcopy(ours)
    both.texts = {**theirs.texts, **ours.texts}
    for name in ("lines", "moved", "links", "around", "exact"):
        setattr(both, name, {**getattr(theirs, name), **getattr(ours, name)})
    both.lines = {
        mark: place
        for mark, place in both.lines.items()
        if mark not in together or (mark in ours.lines and mark in theirs.lines)
    }  # what one of them has deleted is not there
    both.around = {mark: what for mark, what in both.around.items() if mark in both.lines}
    for name in ("deleted", "crlf", "foreign", "formatted", "ahead"):
        setattr(both, name, getattr(ours, name) | getattr(theirs, name))
    for path, lines in theirs.replaced.items():
        both.replaced[path] = [*both.replaced.get(path, []), *lines]
    for path, lines in theirs.repeated.items():
        both.repeated[path] = both.repeated.get(path, Counter()) + lines
    return both


def ours_dropped(joined):
    """The other branch is taken."""
    return _taken(joined, 1)


def theirs_dropped(joined):
    return _taken(joined, 0)


def _taken(joined, number):
    before, tree = dict(joined.result.tree), joined.sides[number].result.tree
    joined.result.tree.update({path: file for path, file in tree.items() if path != SPEC})
    return _with_marks(before) != _with_marks(joined.result.tree)


def _with_marks(tree):
    return sorted(mark for text in _texts(tree).values() for mark in re.findall(r"mine_\d+", text))


def file_of_one_side(joined):
    """A file is taken from one branch, as a hand resolves a conflict."""
    ours, tree = joined.sides[0].result.tree, joined.result.tree
    for path, file in sorted(tree.items()):
        before = {path: file}
        if (
            path != SPEC
            and path in ours
            and _with_marks(before) != _with_marks({path: ours[path]})
        ):
            tree[path] = ours[path]
            return path not in joined.result.conflicts
    return False


def line_of_both_twice(joined):
    tree = joined.result.tree
    for path, file in sorted(tree.items()):
        marked = re.search(r"(?m)^.*\bmine_\d\d?\b.*\n", file.text or "")
        if marked and path not in joined.result.conflicts:
            tree[path] = replace(file, data=encode(file.text.replace(marked[0], marked[0] * 2)))
            return True
    return False


def left_as_made(joined):
    """The files are what the model makes of the merged spec."""
    made = joined.sides[0].versions.new
    before = _with_marks(joined.result.tree)
    joined.result.tree.update({p: f for p, f in made.items() if p not in joined.result.conflicts})
    return _with_marks(joined.result.tree) != before


def own_file_lost(joined):
    made, tree = joined.sides[0].versions.new, joined.result.tree
    own = [p for p in sorted(tree) if p not in made and "mine_" in (tree[p].text or "")]
    if own:
        del tree[own[0]]
    return bool(own)


MUTANTS = (
    ours_dropped,
    theirs_dropped,
    file_of_one_side,
    line_of_both_twice,
    left_as_made,
    own_file_lost,
)
"""Joins that are wrong: the judge must see each."""
