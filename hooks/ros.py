"""What the hook knows about ROS itself: distributions, and packages that changed name."""

from __future__ import annotations

from collections.abc import Mapping

from .data import load_data
from .faults import SpecError, allowed, quoted, with_id

_ROS = load_data("ros.yaml")
DISTROS: dict[str, int] = {name: about["ros"] for name, about in _ROS["distros"].items()}
"""The ROS distributions that can be chosen, each with its generation."""

DEPENDENCY_KINDS: list[str] = _ROS["dependency_kinds"]
"""The kinds of dependencies that a package.xml knows besides the usual one."""


def lacks(distro: str) -> dict[str, str]:
    """Return what a distribution lacks that others of its generation have, and why."""
    return _ROS["distros"].get(distro, {}).get("lacks") or {}


def is_lacking(distro: str, feature: str) -> bool:
    """Say whether a distribution lacks a feature, which another one must lack.

    Raises:
        SpecError: none lacks it: a slip of a template.

    """
    known = sorted({name for each in DISTROS for name in lacks(each)})
    if feature not in known:
        what = f"unknown feature {quoted(feature)}; {allowed(feature, known)}"
        raise SpecError(what, "unknown-feature")
    return feature in lacks(distro)


def default_distro(environment: Mapping[str, str]) -> str:
    """Return the distribution that ROS_DISTRO names where it is one of ours."""
    distro = environment.get("ROS_DISTRO", "")
    return distro if distro in DISTROS else str(_ROS["default_distro"])


def translate_dependency(package: str, generation: int) -> tuple[str | None, str | None]:
    """Return what `package` is called in a ROS generation, and a note where that differs.

    A package that is not known to belong to the other generation keeps its name.
    """
    successor = _ROS["successors"][3 - generation].get(package, package)
    if successor == package:
        return package, None
    meaning = f"became {successor}" if successor else "was left out"
    note = f"<depend>{package}</depend> has no meaning in ROS {generation}: it {meaning}"
    return successor, with_id(note, "dependency-of-other-ros")


def nearest_available(name: str, generation: int) -> str | None:
    """Return what is nearest to a package or type that a ROS generation is known not to have."""
    if name in _ROS["both"]:
        return None
    nearest: str | None = _ROS["nearest"][generation].get(name)
    successor = translate_dependency(name, generation)[0]
    return nearest or (successor if successor != name else None)


def lacking_kind(package: str, kind: str) -> str | None:
    """Say that a package has no types of a kind, `msg`, `srv` or `action`, where that is known."""
    words = {"msg": "messages", "srv": "services", "action": "actions"}
    for only, packages in _ROS["one_kind"].items():
        if package in packages and kind != only:
            return f"{package} has {words[only]} alone, no {words[kind]}"
    return None
