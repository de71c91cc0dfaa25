"""Words that already have a meaning in generated code, so that no name of a spec can be one."""

from __future__ import annotations

import functools
import keyword
import re
import sys
from collections.abc import Iterable

from .data import load_data

KEYWORDS = ("a keyword of Python", "a keyword of C++")
CPP_NAMES = (*KEYWORDS, "a macro of C++")
MODULES = ("a module of Python", "a module that packages import")
PACKAGES = (*CPP_NAMES, *MODULES, "a name of C or C++", "a package of ROS itself")


@functools.cache
def _lists() -> dict[str, tuple[frozenset[str], re.Pattern[str]]]:
    """Return for each meaning the words that have it, and a pattern for others that have it."""
    words = {meaning: text.split() for meaning, text in load_data("words.yaml").items()}
    words["a keyword of Python"] = list(keyword.kwlist)
    words["a module of Python"] = list(sys.stdlib_module_names)
    return {
        meaning: (
            frozenset(filter(str.isidentifier, found)),
            re.compile("|".join(word for word in found if not word.isidentifier()) or r"(?!)"),
        )
        for meaning, found in words.items()
    }


def meaning(word: str, meanings: Iterable[str]) -> str:
    """Return what a word means already, of the given meanings; nothing if it is free."""
    lists = _lists()
    found = " and ".join(
        each for each in meanings if word in lists[each][0] or lists[each][1].fullmatch(word)
    )
    return found.replace(" and a keyword of", " and")
