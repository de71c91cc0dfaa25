"""Join two branches, each brought to the merged spec before (decision 104)."""

from __future__ import annotations

import contextlib
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import permutations
from pathlib import Path
from typing import Any

from packaging.version import InvalidVersion, Version

from ..changes import Contexts, Values, as_parted
from ..dictionary import Dictionary
from ..faults import SpecError
from ..package import SUFFIX
from . import git
from .indentation import indented
from .lines import changed, plain, split
from .package import Result, moves
from .proof import Proof
from .renaming import plan_renames
from .render import Renderer, recorded_answers
from .tree import LINK, File, Tree, encode
from .versions import Versions

_UNDER_WAY = {
    "MERGE_HEAD": "MERGE_HEAD",
    "CHERRY_PICK_HEAD": "CHERRY_PICK_HEAD",
    "REBASE_HEAD": "rebase-merge",
}
"""What names the commit that git is about to join, and what is there while it is."""
_GITS_MARKS = ("<<<<<<< ", "=======", ">>>>>>> ", "||||||| ")
AROUND = 3
"""How many lines tell the place of a change."""


@dataclass(frozen=True)
class Branches:
    """Two commits that are to be one, and what they come from.

    `merge` is the commit that has made one of them, but wrong; `files` are those that show it.
    """

    ours: str
    theirs: str
    bases: list[str]
    merge: str = ""
    files: tuple[str, ...] = ()


def under_way(package: Path, answers_file: str) -> Branches | None:
    """Return what git is about to join: a merge, a rebase or a cherry-pick that is not ended.

    Of a merge of more than two it raises SpecError.
    """
    for name, folder in _UNDER_WAY.items():
        file = git.own_file(package, name)
        if not (git.own_file(package, folder).exists() and file.is_file()):
            continue
        commits = file.read_text(encoding="ascii").split()
        if commits and all(git.name_in(package, one, answers_file) for one in ("HEAD", *commits)):
            _refuse_octopus(commits)
            theirs = commits[0]
            if name == "MERGE_HEAD":
                return Branches("HEAD", theirs, git.merge_bases(package, "HEAD", theirs))
            return Branches("HEAD", theirs, git.parents(package, theirs)[:1])
    return None


def _refuse_octopus(others: Sequence[str]) -> None:
    if len(others) > 1:
        raise SpecError(
            f"{len(others) + 1} branches are merged at once here, and an update joins two; undo"
            " this (git merge --abort, or git reset --hard HEAD^), and merge one after the other",
            "several-branches",
        )


@dataclass(frozen=True)
class Side:
    """A commit that was brought to the merged spec."""

    commit: str
    versions: Versions
    result: Result
    proof: Proof

    @property
    def tree(self) -> Tree:
        """Its files, with the developer's side of each conflict."""
        return {**self.result.tree, **self.result.settled}


@dataclass(frozen=True)
class Joined:
    """Two sides that have become one."""

    sides: tuple[Side, Side]
    versions: Versions
    result: Result
    own: Tree
    """What stood in the place of the joined files: where git, or a hand, has merged them."""


@dataclass
class Joiner:
    """Brings commits of a package to new answers, and joins them there.

    `moved` has the new paths of files that the new version of the model renames.
    """

    package: Path
    answers_file: str
    answers: Mapping[str, Any]
    renderer: Renderer
    dictionary: Dictionary
    moved: Mapping[str, str]
    histories: dict[str, list[Values]] = field(default_factory=dict)
    """The contexts of each branch that is joined, from that of the base on."""

    def recorded(self, commit: str) -> dict[str, Any]:
        """Return the answers that a commit has."""
        return recorded_answers(self.package, self.answers_file, commit)

    def made(self, commit: str) -> Tree:
        """Render what the model has made of a commit."""
        return self.renderer.recorded(self.recorded(commit)).tree

    def files(self, commit: str) -> Tree:
        """Return the files of a commit, but for its answers."""
        found = git.files_of(self.package, commit)
        return {path: file for path, file in found.items() if path != self.answers_file}

    def versions(self, mine: Tree, answers: Mapping[str, Any], contexts: Contexts) -> Versions:
        """Render what a package was made of, and what it is to be.

        `contexts` say what was renamed.
        """
        old, new = self.renderer.recorded(answers), self.renderer.fresh(self.answers)
        about = (self.dictionary, old.tree, mine, self.renderer)
        renaming = plan_renames(answers, contexts, *about)
        renaming.know(mine, _moves(old.tree, mine).values())
        renaming.follow(self.moved, old.tree, new.tree)
        before, after = indented(mine, old.tree, new.tree, renaming.path)
        renaming.move(before, after)
        ros = [context.get("ros") for context in contexts]
        to_ros = int(ros[1] or 0) if ros[0] != ros[1] else None
        return Versions(mine, before, after, renaming, new.is_kept, to_ros)

    def check(self, branches: Branches, given: Iterable[str]) -> None:
        """Insist that the answers are those of both sides; `given` are the ones that `-d` gives.

        Else it raises SpecError, which says what to do.
        """
        sides = [self.recorded(one) for one in (branches.ours, branches.theirs)]
        base = self.recorded(branches.bases[0]) if branches.bases else {}
        for name in sorted({*sides[0], *sides[1]} - {"spec", *given}):
            was, (ours, theirs) = base.get(name), (side.get(name) for side in sides)
            due = {str(side) for side in (ours, theirs) if side != was} or {str(ours)}
            if name == "_commit":
                _refuse_older(str(self.answers.get("_commit")), (str(ours), str(theirs)))
            elif name[0] != "_" and due != {str(self.answers.get(name))}:
                raise SpecError(
                    f"{name}: one branch has {ours}, the other {theirs}; say which one the package"
                    f" is to have: -d {name}={theirs if theirs != was else ours}",
                    "answers-differ",
                )

    def history(self, base: str, commit: str) -> list[Values]:
        """Return the contexts of a branch, from that of its base on."""
        commits = git.changing(self.package, self.answers_file, base, commit)
        found = (self.recorded(one).get("spec") for one in (base, *commits, commit))
        return [context for context in found if isinstance(context, Mapping)]

    def contexts(self, commit: str) -> Contexts:
        """Return that of a commit and the new one, named as both began (decision 121)."""
        spec = self.answers["spec"]
        own = self.histories.get(commit)
        if not own:
            return self.recorded(commit).get("spec") or {}, spec
        others = (history for one, history in self.histories.items() if one != commit)
        return as_parted([own, *others], spec, self.dictionary)

    def side(self, commit: str) -> Side:
        """Bring a commit to the new answers; SpecError if a line would not be in its place."""
        made = self.versions(self.files(commit), self.recorded(commit), self.contexts(commit))
        result = settle(made)
        return Side(commit, made, result, made.proof(result, result.tree))

    def join(self, branches: Branches, now: Tree) -> Joined:
        """Bring two commits to the new answers, and join them; `now` is the package as it is.

        It raises SpecError as above.
        """
        for start in branches.bases[:1]:
            commits = (branches.ours, branches.theirs, start)
            histories = {commit: self.history(start, commit) for commit in commits}
            self.histories = histories if all(histories.values()) else {}
        sides = (self.side(branches.ours), self.side(branches.theirs))
        base = self.base(branches.bases)
        made = people(sides[0].tree, base, sides[1].tree)
        result = settle(made)
        for side, other in zip(sides, sides[::-1], strict=True):
            if side.result.conflicts:
                _keep_conflicts(result, side, _moves(base, other.tree))
        own = self.files(branches.merge) if branches.merge else now
        if own != now:  # what came after the merge
            whole = {path for path in result.conflicts if own.get(path) == now.get(path)}
            # Marks are no code: what came after is merged with what was ours alone.
            joined = result.tree | _only(result.settled, {*result.conflicts} - whole)
            trees = (_only(tree, {*tree} - whole) for tree in (joined, own, now))
            later = settle(people(*trees))
            for path in result.conflicts.keys() & later.tree.keys() - later.conflicts.keys():
                later.conflicts[path] = result.conflicts[path]
                versions = (_only(tree, {path}) for tree in (later.tree, made.old, made.new))
                _ask_again(later, path, people(*versions))
            _take(later, result, whole)
            result = later
        result.tree |= {path: file for path, file in now.items() if path.endswith(SUFFIX)}
        return Joined(sides, made, result, own)

    def base(self, commits: Sequence[str]) -> Tree:
        """Return what two commits have in common, brought to the new answers."""
        known = [commit for commit in commits if self.recorded(commit)]
        if not known:
            return self.renderer.fresh(self.answers).tree
        tree = self.side(known[0]).tree
        for commit in known[1:]:
            before = self.base(git.merge_bases(self.package, known[0], commit))
            tree = people(tree, before, self.side(commit).tree).merged()[0].tree
        return tree

    def own_lines(self, joined: Joined) -> Iterator[tuple[str, int, str]]:
        """Yield the lines that neither branch has, only what a hand has made of both."""
        trees = [joined.result.tree, joined.versions.old]
        trees += [tree for side in joined.sides for tree in (side.versions.mine, side.result.tree)]
        known = {line.strip() for tree in trees for f in tree.values() for line in _lines(f)}
        for path, file in sorted(joined.own.items()):
            lines = _lines(file) if not path.endswith(SUFFIX) else []
            for number, line in enumerate(lines, 1):
                if line.strip() not in known and not line.startswith(_GITS_MARKS):
                    yield path, number, line


def _lines(file: File) -> list[str]:
    return plain(file.written).split("\n")


def _only(files: Mapping[str, Any], paths: Collection[str]) -> dict[str, Any]:
    """Return what is said of some paths."""
    return {path: said for path, said in files.items() if path in paths}


def settle(made: Versions) -> Result:
    """Merge in memory; SpecError if lines would not be in their place."""
    result, wrong = made.merged()
    refuse(
        (f"{path}: {what}" for path, what in wrong),
        "nothing was joined, for these lines would not be where you have written them; take"
        " them out on their branch, join, and put them in again",
        "merge-not-proved",
    )
    return result


def refuse(lines: Iterable[str], why: str, id_: str) -> None:
    """Insist that there are no such lines; else SpecError says why, and the first of them."""
    if found := [f"\n  {line}" for line in lines][:20]:
        raise SpecError(f"{why}:{''.join(found)}\n", id_)


def people(mine: Tree, old: Tree, new: Tree) -> Versions:
    """Return three versions of which two are developers'; files they moved have one path.

    The spec is not among them: the developers have resolved it.
    """
    mine, old, new = (
        {path: file for path, file in tree.items() if not path.endswith(SUFFIX)}
        for tree in (mine, old, new)
    )
    for _ in range(2):
        moved = {path: to for path, to in _moves(old, mine).items() if to not in new}
        old, new = ({moved.get(p, p): file for p, file in tree.items()} for tree in (old, new))
        mine, new = new, mine
    return Versions(mine, old, new, of_people=True)


def _moves(old: Tree, side: Tree) -> dict[str, str]:
    """Return the files that a developer has given another name; a link may lead there."""
    is_link = {path for path, file in side.items() if file.mode == LINK}
    away = [path for path in old if path not in side or path in is_link]
    return moves(old, side, away, side.keys() - old.keys())


def _keep_conflicts(result: Result, side: Side, moved: Mapping[str, str]) -> None:
    """Bring in the conflicts of one developer and the model, where the two have none.

    `moved` has the files that the other developer has moved.
    """
    made = side.versions
    sources = {made.renaming.path(path): path for path in made.old}
    for path, stages in side.result.conflicts.items():
        target = moved.get(path, path)
        if target in result.conflicts or target not in result.tree:
            continue
        result.conflicts[target] = stages
        source = sources.get(path, path)
        file, new = made.old.get(source), made.new.get(path)
        if new and file and file.text is not None:
            old = File(encode(made.renaming.text(source, file.text)))
            mine = {target: result.tree[target]}
            _ask_again(result, target, Versions(mine, {target: old}, {target: new}))


def _ask_again(result: Result, path: str, made: Versions) -> None:
    """Put the conflict of a file into what it has become since."""
    again = made.merged()[0]
    if path in again.rejected:
        _take(result, again, {path})


def _take(result: Result, other: Result, paths: Collection[str]) -> None:
    """Put what another result says of some paths into a result."""
    for name in ("tree", "conflicts", "rejected", "settled"):
        getattr(result, name).update(_only(getattr(other, name), paths))


def _refuse_older(version: str, others: Iterable[str]) -> None:
    for other in others:
        with contextlib.suppress(InvalidVersion):  # a commit without a tag
            if Version(version) < Version(other):
                raise SpecError(
                    f"one branch was made by version {other} of the model, newer than {version};"
                    f" add --vcs-ref={other}",
                    "older-version",
                )


def wrong_merge(joiner: Joiner, now: Tree) -> Branches | None:
    """Return the last merge, or other change of the answers, that has left files of another spec.

    Files count which are so since then, and still are (decision 105). Of a merge of more than two
    it raises SpecError.
    """
    package, answers_file = joiner.package, joiner.answers_file
    commit, parents = _last_making(package, answers_file)
    answers = joiner.recorded(commit) if commit else {}
    recorded = {one: joiner.recorded(one) for one in parents}
    is_known = all(each.get("_src_path") == answers.get("_src_path") for each in recorded.values())
    others = [one for one in parents if recorded[one] != answers]
    if not (others and is_known):
        return None
    there, made = joiner.files(commit), joiner.renderer.recorded(answers)
    sides = {one: (joiner.files(one), joiner.made(one)) for one in parents}
    befores = [sides[one] for one in others]
    found = {path for path in _stale(there, made.tree, befores) if not made.is_kept(path)}
    if found:
        found &= _stale(now, made.tree, befores)
    if len(parents) > 1:
        bases = git.merge_bases(package, *parents[:2])
        base = joiner.files(bases[0]) if bases else {}
        dropped = {*_dropped(there, base, [sides[one] for one in parents[:2]])}
        dropped = {path for path in dropped if there.get(path) == now.get(path)}
        found |= {path for path in dropped if not path.endswith(SUFFIX)}
    if not found:
        return None
    files = tuple(sorted(found))
    if len(parents) < 2:
        return Branches("", parents[0], [], commit, files)
    _refuse_octopus(parents[1:])
    return Branches(parents[0], parents[1], git.merge_bases(package, *parents), commit, files)


def _last_making(package: Path, answers_file: str) -> tuple[str, list[str]]:
    """Return the last commit in which files may have lost their answers, and its parents."""
    commit = "HEAD"
    while commit := git.last_making(package, answers_file, commit):
        parents = git.parents(package, commit)
        names = {git.name_in(package, one, answers_file) for one in (commit, *parents)}
        same = [
            one for one in parents if git.name_in(package, one) == git.name_in(package, commit)
        ]
        if not parents or (len(names) > 1 and not same):
            return commit, parents
        commit = [*same, *parents][0]
    return "", []


def _stale(found: Tree, made: Tree, befores: Sequence[tuple[Tree, Tree]]) -> set[str]:
    """Return the files of which a part is as another spec makes it, and not as their own does.

    `befores` are packages that this one comes from, and what their specs make.
    """

    def is_as_before(path: str, there: Tree, before: Tree) -> bool:
        if path in made and path in before:
            text = found.get(path, File(b"")).written
            old, new = (tree[path].written for tree in (before, made))
            return any(
                was in text and now not in text and not _is_edited(path, now, befores)
                for was, now in _changes(old, new)
            )
        if path in made:
            is_deleted = any(path in one and path not in files for files, one in befores)
            return path not in found and not is_deleted
        return path in before and path in there and there[path] == found.get(path)

    paths = {*made, *(path for _, before in befores for path in before)}
    return {path for path in paths if any(is_as_before(path, *each) for each in befores)}


def _changes(old: str, new: str) -> Iterator[tuple[str, str]]:
    """Yield what has changed, as it was and as it is, with some lines around."""
    before, after = split(old), split(new)
    for start, end, first, last in changed(before, after):
        above, below = before[max(0, start - AROUND) : start], before[end : end + AROUND]
        yield (
            "".join([*above, *before[start:end], *below]),
            "".join([*above, *after[first:last], *below]),
        )


def _is_edited(path: str, part: str, befores: Sequence[tuple[Tree, Tree]]) -> bool:
    """Say whether a developer has changed a part of a file that the model has made."""
    return any(
        part in made[path].written and part not in there.get(path, File(b"")).written
        for there, made in befores
        if path in made
    )


def _dropped(found: Tree, base: Tree, sides: Sequence[tuple[Tree, Tree]]) -> Iterator[str]:
    """Yield the files that are those of one side, without lines that the other has written."""
    for (ours, _), (theirs, made) in permutations(sides):
        for path, file in theirs.items():
            others = (one.get(path, File(b"")) for one in (made, base, found))
            known = {line for other in others for line in _lines(other)}
            if ours.get(path) == found.get(path) and {*_lines(file)} - known:
                yield path
