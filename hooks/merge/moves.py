"""Files that a version of a model has renamed: its `moved_files.yaml`.

"{package}/ros/loop.py": "{package}/loop.py"     # new: old
"src/{node}_node.cpp": "src/{node}_ros.cpp"
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from ..data import load_yaml
from ..dictionary import PACKAGE, Dictionary
from ..faults import SpecError

FILE = "moved_files.yaml"


def moved_files(spec: Mapping[str, Any], dictionary: Dictionary) -> dict[str, str]:
    """Return the new path of each old one, for the components of a spec.

    What a model says counts for those whose dictionaries include its own.

    Raises:
        SpecError: the file is not a mapping of paths.

    """
    moved: dict[str, str] = {}
    for file in dictionary.files:
        moved |= _moved(file.with_name(FILE), list(_names(spec, dictionary)))
    return moved


def _moved(file: Path, names: list[dict[str, str]]) -> dict[str, str]:
    if not file.exists():
        return {}
    try:
        content = load_yaml(file.read_text(encoding="utf-8")) or {}
        return {
            old.format_map(name): new.format_map(name)
            for new, old in content.items()
            for name in names
            if _fits(new, name)
        }
    except (AttributeError, IndexError, KeyError, ValueError, yaml.YAMLError) as error:
        what = f"{file}: must be a mapping of new paths to old ones: {error}"
        raise SpecError(what, "wrong-shape") from error


def _names(spec: Mapping[str, Any], dictionary: Dictionary) -> Iterator[dict[str, str]]:
    """Yield what the braces of a path may stand for: the package, and a component of it."""
    package = {PACKAGE: str(spec[dictionary.naming])}
    yield package
    for component in dictionary.components.values():
        for item in spec.get(component.key, []):
            yield {**package, component.tag: str(item[component.naming])}


def _fits(path: str, names: Mapping[str, str]) -> bool:
    wanted = {part.partition("}")[0] for part in path.split("{")[1:]}
    return wanted == set(names) or wanted | {PACKAGE} == set(names)
