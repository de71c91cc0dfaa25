"""Three versions of a package: merged, and proved."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from .builds import carry_build_files
from .launch import carry_launch_files
from .merging import Way, by_line, conflict
from .package import Result, merge_package
from .proof import Proof, prove
from .recount import Places, recount
from .renaming import Renaming
from .tree import Tree


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
        """Merge; what the proofs doubt is merged by line, then the developer's (decision 109).

        Returns what they doubt even then.
        """
        ways: dict[str, Way] = {}
        result = self.merge(ways)
        doubts = self.doubts(result)
        for way in (by_line, conflict):
            if doubts:
                ways |= {path: way for path, _ in doubts}
                result = self.merge(ways)
                doubts = self.doubts(result)
        return result, doubts

    def merge(self, ways: Mapping[str, Way]) -> Result:
        """Merge; in a move to another ROS, carry what other files have there."""
        trees = (self.mine, self.old, self.new, self.renaming)
        result = merge_package(*trees, self.is_kept, ways, self.of_people)
        if self.to_ros is not None:
            carry_launch_files(*trees, result, self.to_ros)
            carry_build_files(*trees, result, self.to_ros)
        return result

    def doubts(self, result: Result) -> Places:
        """Return what the proofs do not find in its place; of two people, the lines of both."""
        proof = self.proof(result, result.tree)
        found = self.wrong(result, result.tree, proof)
        if not self.of_people:
            return [*proof.lost, *found]
        theirs = replace(self, mine=self.new, new=self.mine).proof(result, result.tree)
        lost = [each for each in (*proof.lost, *theirs.lost) if each[0] not in result.conflicts]
        return lost + found

    def proof(self, result: Result, found: Tree) -> Proof:
        """Look for the developer's lines in a merged package."""
        about = (self.renaming, self.new, self.of_people)
        return prove(self.mine, self.old, result, found, *about)

    def wrong(self, result: Result, found: Tree, proof: Proof) -> Places:
        """Count all lines of a merged package."""
        trees = (self.mine, self.old, self.new, self.renaming, self.is_kept)
        return recount(*trees, result, found, proof.left)
