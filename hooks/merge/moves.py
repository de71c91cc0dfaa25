"""Files that a version of a model has renamed: its `moved_files.yaml`.

"{package}/ros/loop.py": "{package}/loop.py"     # new: old
"src/{node}_node.cpp": "src/{node}_ros.cpp"
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import yaml

from ..data import load_yaml
from ..dictionary import PACKAGE
from ..faults import SpecError
from ..model import Model

FILE = "moved_files.yaml"


def moved_files(spec: Mapping[str, Any], model: Model) -> dict[str, str]:
    """Return the new path of each old one, for the components of a spec.

    What a model says counts for those whose dictionaries include its own.
    Where that is no mapping of paths, it raises SpecError.
    """
    # What the braces of a path may stand for: the package, and a component of it.
    names = [{PACKAGE: model.name(spec)}]
    for component in model.dictionary.components.values():
        items = spec.get(component.key, [])
        names += [{**names[0], component.tag: str(item[component.naming])} for item in items]
    moved: dict[str, str] = {}
    for file in (folder / FILE for folder in model.folders):
        if not file.exists():
            continue
        try:
            content = load_yaml(file.read_text(encoding="utf-8")) or {}
            moved |= {
                old.format_map(name): new.format_map(name)
                for new, old in content.items()
                for name in names
                if _fits(new, name)
            }
        except (AttributeError, IndexError, KeyError, ValueError, yaml.YAMLError) as error:
            what = f"{file}: must be a mapping of new paths to old ones: {error}"
            raise SpecError(what, "wrong-shape") from error
    return moved


def _fits(path: str, names: Mapping[str, str]) -> bool:
    wanted = {part.partition("}")[0] for part in path.split("{")[1:]}
    return wanted | {PACKAGE} == {*names}
