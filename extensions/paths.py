"""Names of template files that stand for one file of each component."""

from __future__ import annotations

import re

from jinja2.ext import Extension

_ITEM = re.compile(r"\[(\w+)\.(\w+)\]")
_NAME = re.compile(r"([\w.-]|\{\{[^/\n]+?\}\}|\[\w+\.\w+\])+")


class PathsExtension(Extension):
    """Turn `[node.name]_impl.py` into Copier's own way to make a file of each of `spec.nodes`."""

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:
        """Rewrite the name of a file or folder; a text that comes from a file has a name."""
        item = _ITEM.search(source)
        if name is not None or not item or not _NAME.fullmatch(source):
            return source
        # Inside of a folder of a component, the names are those of this component alone.
        components = f"[{item[1]}] if {item[1]} is defined else spec.{item[1]}s"
        shown = _ITEM.sub(r"{{ \1.\2 }}", source)
        return f"{{% yield {item[1]} from {components} %}}{shown}{{% endyield %}}"
