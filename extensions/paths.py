"""Names of template files that stand for one file of each component, or for a part of the spec."""

from __future__ import annotations

import re

from jinja2.ext import Extension

_ITEM = re.compile(r"\[(\w+)\.(\w+)\]")
_NAME = re.compile(r"([\w.-]|\{\{[^/\n]+?\}\}|\[\w+\.\w+\])+")
_PART = re.compile(r"\[spec\.(\w+)\]")


class PathsExtension(Extension):
    """Turn `[node.name]_impl.py` into Copier's own way to make a file of each of `spec.nodes`.

    A folder `[spec.arm]` is the package itself, for the part of the spec that the model's function
    `parts` gives for `arm`: what is in the folder sees it as `part`, and has its components.
    """

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
        components = f"[{item[1]}] if {item[1]} is defined else {spec}.{item[1]}s"
        shown = _ITEM.sub(r"{{ \1.\2 }}", source)
        return f"{{% yield {item[1]} from {components} %}}{shown}{{% endyield %}}"
