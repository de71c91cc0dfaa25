"""Files that a version of a model calls otherwise than versions before: its `moved_files.yaml`.

"{package}/callbacks.py": "{package}/worker.py"     # new: old
"src/{node}_node.cpp": "src/{node}_ros.cpp"
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from ..dictionary import PACKAGE, Dictionary
from ..faults import SpecError

FILE = "moved_files.yaml"


def moved_files(folder: Path, spec: Mapping[str, Any], dictionary: Dictionary) -> dict[str, str]:
    """Return the new path of each old one, for the components of a spec.

    Raises:
        SpecError: the file is not a mapping of paths.

    """
    file = folder / FILE
    if not file.exists():
        return {}
    try:
        content = yaml.safe_load(file.read_text(encoding="utf-8")) or {}
        names = list(_names(spec, dictionary))
        return {
            str(old).format_map(name): str(new).format_map(name)
            for new, old in content.items()
            for name in names
            if _fits(str(new), name)
        }
    except (AttributeError, KeyError, ValueError, yaml.YAMLError) as error:
        raise SpecError(f"{file}: must be a mapping of new paths to old ones: {error}") from error


def _names(spec: Mapping[str, Any], dictionary: Dictionary) -> Iterator[dict[str, str]]:
    """Yield what the braces of a path may stand for: the package, and a component of it."""
    package = {PACKAGE: str(spec[next(iter(dictionary.package))])}
    yield package
    for component in dictionary.components.values():
        for item in spec.get(component.key, []):
            yield {**package, component.tag: str(item[next(iter(component.attributes))])}


def _fits(path: str, names: Mapping[str, str]) -> bool:
    wanted = {part.partition("}")[0] for part in path.split("{")[1:]}
    return wanted == set(names) or wanted | {PACKAGE} == set(names)
