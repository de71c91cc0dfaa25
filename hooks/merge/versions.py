"""Three versions of a package: merged, and proved."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from ..dictionary import Dictionary
from .builds import carry_build_files
from .launch import carry_launch_files
from .package import Result, merge_package
from .proof import Proof, prove
from .recount import Places, recount
from .renaming import Renaming, plan_renames
from .render import Renderer
from .tree import Tree

Answers = Mapping[str, Any]


@dataclass(frozen=True)
class Versions:
    """Two descendants of a package that become one, and what tells how.

    `to_ros` is the other ROS that a package moves to. `of_people`: the new version is another
    developer's, not the model's.
    """

    mine: Tree
    old: Tree
    new: Tree
    renaming: Renaming = field(default_factory=Renaming)
    is_kept: Callable[[str], bool] = frozenset().__contains__
    to_ros: int | None = None
    of_people: bool = False

    def merged(self) -> tuple[Result, Places]:
        """Merge; what a proof does not find becomes a conflict, and what it then still misses."""
        result = self._merged(set())
        doubts = self._doubts(result)
        if doubts:
            result = self._merged({path for path, _ in doubts})
            doubts = self._doubts(result)
        return result, doubts

    def _merged(self, unmerged: set[str]) -> Result:
        """Merge; in a move to another ROS, carry what other files have there."""
        trees = (self.mine, self.old, self.new, self.renaming)
        result = merge_package(*trees, self.is_kept, unmerged, self.of_people)
        if self.to_ros is not None:
            carry_launch_files(*trees, result, self.to_ros)
            carry_build_files(*trees, result, self.to_ros)
        return result

    def _doubts(self, result: Result) -> Places:
        """Return what the proofs do not find in its place; of two people, the lines of both."""
        proof = self.proof(result, result.tree)
        found = [*proof.lost, *self.wrong(result, result.tree, proof)]
        if self.of_people:
            theirs = replace(self, mine=self.new, new=self.mine).proof(result, result.tree)
            # What the one has put around code is no place that the other knows.
            found += [lost for lost in theirs.lost if self._is_less(*lost, result)]
        return found

    def _is_less(self, path: str, line: str, result: Result) -> bool:
        """Say whether a file has a line of the other developer's less often than theirs."""
        trees = (self.new, result.tree)
        texts = [(tree[path].text or "" if path in tree else "") for tree in trees]
        before, after = ([one.strip() for one in text.split("\n")].count(line) for text in texts)
        return path not in result.conflicts and after < before

    def proof(self, result: Result, found: Tree) -> Proof:
        """Look for the developer's lines in a merged package."""
        return prove(self.mine, self.old, result, found, self.renaming)

    def wrong(self, result: Result, found: Tree, proof: Proof) -> Places:
        """Count all lines of a merged package."""
        trees = (self.mine, self.old, self.new, self.renaming, self.is_kept)
        return recount(*trees, result, found, proof.left)


def versions(
    mine: Tree,
    answers: Answers,
    new_answers: Answers,
    renderer: Renderer,
    dictionary: Dictionary,
    moved: Mapping[str, str],
) -> Versions:
    """Render what a package was made of, and what it is to be."""
    spec = new_answers["spec"]
    old, new = renderer.recorded(answers), renderer.fresh(new_answers)
    renaming = plan_renames(answers, spec, dictionary, old.tree, mine, renderer)
    renaming.follow(moved, old.tree, new.tree)
    renaming.move(old.tree, new.tree)
    ros = [context.get("ros") for context in (answers.get("spec") or {}, spec)]
    to_ros = int(ros[1] or 0) if ros[0] != ros[1] else None
    return Versions(mine, old.tree, new.tree, renaming, new.is_kept, to_ros)
