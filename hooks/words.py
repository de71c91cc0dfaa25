"""Words that already have a meaning in generated code, so that no name of a spec can be one."""

from __future__ import annotations

import functools
import keyword
import sys
from collections.abc import Iterable

from .data import load_data

KEYWORDS = ("a keyword of Python", "a keyword of C++")
CPP_NAMES = (*KEYWORDS, "a macro of C++")
DEVICES = ("a device of Windows",)
MODULES = ("a module of Python", "a module that packages import")
PACKAGES = (*CPP_NAMES, *MODULES, "a name of C or C++", "a package of ROS itself")


@functools.cache
def _lists() -> dict[str, frozenset[str]]:
    """Return for each meaning the words that have it."""
    texts = {**load_data("words.yaml"), **load_data("macros.yaml")}
    return {
        "a keyword of Python": frozenset(keyword.kwlist),
        "a module of Python": frozenset(sys.stdlib_module_names),
        **{meaning: frozenset(text.split()) for meaning, text in texts.items()},
    }


def meanings() -> list[str]:
    """Return what words may mean already; some do in one of the ROS generations alone."""
    return sorted({name.partition(" in ROS")[0] for name in _lists()})


def meaning(word: str, meanings: Iterable[str], generations: Iterable[int] = (1, 2)) -> str:
    """Return what a word means already, of the given meanings; nothing if it is free.

    A word may have a meaning in one of the ROS generations alone.
    """
    lists = _lists()
    forms = ("", *(f" in ROS {generation}" for generation in generations))
    known = (each + form for each in meanings for form in forms)
    found = " and ".join(each for each in known if word in lists.get(each, ()))
    return found.replace(" and a keyword of", " and")
