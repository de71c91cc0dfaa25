"""Read YAML whose texts know where they stand, for messages that name file and line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from .data import LOADER
from .faults import SpecError, shown

_TEXT = "tag:yaml.org,2002:str"
_MERGE = "tag:yaml.org,2002:merge"


class Located(str):
    """A text of a YAML file."""

    file = ""
    line: int

    @property
    def place(self) -> str:
        """The file and the line where the text stands; nothing if it is said nowhere."""
        return f"{self.file}:{self.line}" if self.file else ""

    def here(self, text: str) -> Located:
        """Return another text that stands where this one does."""
        other = Located(text)
        other.file, other.line = self.file, self.line
        return other


def load_located(file: Path, name: str) -> Any:
    """Return the content of a YAML file, each text in it a `Located`; messages name it so.

    Raises:
        SpecError: there is no such file, it is not YAML, or a mapping has a key twice.

    """

    class Loader(LOADER):  # type: ignore[misc, valid-type]
        pass

    def text(loader: yaml.SafeLoader, scalar: yaml.ScalarNode) -> Located:
        found = Located(scalar.value)
        found.file, found.line = name, scalar.start_mark.line + 1
        return found

    Loader.add_constructor(_TEXT, text)
    try:
        content = yaml.compose(file.read_text(encoding="utf-8"), Loader)
        _check_keys(content, name, set())
        return Loader("").construct_document(content) if content else None
    except FileNotFoundError:
        raise SpecError(f"{name}: no such file; a model needs it", "no-such-file") from None
    except UnicodeDecodeError:
        raise SpecError(f"{name}: not UTF-8 text; save it as UTF-8", "not-utf-8") from None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        why = ", ".join(filter(None, (error.problem, error.context)))
        line = f":{mark.line + 1}" if mark else ""
        raise SpecError(f"{name}{line}: not YAML: {why}", "not-yaml") from None
    except yaml.YAMLError as error:
        what = f"{name}: not YAML: {str(error).splitlines()[0]}"
        raise SpecError(what, "not-yaml") from None


def plain(value: Any) -> Any:
    """Return a value with ordinary texts in it."""
    if isinstance(value, dict):
        return {plain(key): plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [plain(item) for item in value]
    return str(value) if isinstance(value, str) else value


def _check_keys(part: Any, file: str, seen: set[int]) -> None:
    """Insist that the keys of all mappings are texts, and each there once."""
    if not isinstance(part, yaml.CollectionNode) or id(part) in seen:
        return
    seen.add(id(part))
    lines: dict[str, int] = {}
    for item in part.value:
        for each in item if isinstance(item, tuple) else (item,):
            _check_keys(each, file, seen)
        if not isinstance(item, tuple) or item[0].tag == _MERGE:
            continue
        key, line = item[0], item[0].start_mark.line + 1
        if key.tag != _TEXT:
            written = f'"{shown(key.value)}"' if isinstance(key, yaml.ScalarNode) else "a list"
            what = f"{written} as a key is no text; put it in quotes"
            raise SpecError(f"{file}:{line}: {what}", "wrong-shape")
        if key.value in lines:
            what = f'"{shown(key.value)}" is there twice, first at line {lines[key.value]}'
            raise SpecError(f"{file}:{line}: {what}; keep one", "key-twice")
        lines[key.value] = line
