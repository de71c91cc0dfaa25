"""Names of template files that stand for one file of each component, or for a part of the spec."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from jinja2 import Environment, TemplateRuntimeError
from jinja2.ext import Extension

_ITEM = re.compile(r"\[(\w+)\.(\w+)\]")
_NAME = re.compile(r"([\w.-]|\{\{[^/\n]+?\}\}|\[\w+\.\w+\])+")
_PART = re.compile(r"\[spec\.(\w+)\]")


class PathsExtension(Extension):
    """Turn `[node.name]_impl.py` into Copier's own way to make a file of each of `spec.nodes`.

    Decision 15: names of template files are plain.
    `[topic.name]` does so for what stands inside of components, too: the file sees it as `topic`.
    A folder `[spec.arm]` is the package itself, for the part of the spec that the model's function
    `parts` gives for `arm`: what is in the folder sees it as `part`, and has its components
    (decision 87).
    """

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        environment.filters["all_of"] = all_of
        environment.filters["value_of"] = value_of

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:
        """Rewrite the name of a file or folder; a text that comes from a file has a name."""
        item = _ITEM.search(source)
        if name is not None or not item or not _NAME.fullmatch(source):
            return source
        if part := _PART.fullmatch(source):
            parts = f"spec | parts('{part[1]}', ros_distro)"
            return f"{{% yield part from {parts} %}}.{{% endyield %}}"
        # Inside of a folder of a component, the names are those of this component alone.
        spec = "(part if part is defined else spec)"
        known = f"known_tags | default([]), {item[1]} | default(none)"
        components = f"{spec} | all_of('{item[1]}', {known})"
        shown = _ITEM.sub(r"{{ \1 | value_of('\2', '\1') }}", source)
        return f"{{% yield {item[1]} from {components} %}}{shown}{{% endyield %}}"


def value_of(item: Any, name: str, tag: str) -> Any:
    """Return an attribute of what a name is for; Copier would pass over one that is not there."""
    if isinstance(item, Mapping) and name not in item:
        known = ", ".join(sorted(key for key, each in item.items() if isinstance(each, str)))
        raise TemplateRuntimeError(f'{tag} has no attribute "{name}"; allowed: {known}')
    return item[name] if isinstance(item, Mapping) else item


def all_of(
    spec: Mapping[str, Any], tag: str, known: Sequence[str] = (), given: Any = None
) -> list[Any]:
    """Return the components of a tag, or what they have of a kind, each with its component.

    A tag must be one of those that are known, if any are. What components take from others is
    among what they have. What is `given` is that of the folder which the file is in.
    """
    if known and tag not in known:
        raise TemplateRuntimeError(f'unknown tag "{tag}"; allowed: {", ".join(known)}')
    if isinstance(given, Mapping):
        return [given]
    if given is not None:  # Copier knows no two things of one name
        raise TemplateRuntimeError(f'"{tag}" is an answer, too; give the tag another name')
    key = f"{tag}s"
    if key in spec:
        return list(spec[key])
    components = [item for items in spec.values() if isinstance(items, list) for item in items]
    return [
        {**item, component["tag"]: component}
        for component in components
        if isinstance(component, Mapping) and "tag" in component
        for item in component.get(key, [])
    ]
