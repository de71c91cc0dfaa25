"""A model as the hook sees it: its dictionary and its functions."""

from __future__ import annotations

import functools
import inspect
import traceback
from collections.abc import Callable, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from . import names
from .advice import contradictions
from .bytecode import compiled
from .changes import places
from .check import CheckedSpec, check
from .complete import Functions, complete
from .dictionary import Dictionary, load
from .faults import SpecError, shown
from .parse import Element, parse
from .schema import names_schema, schema
from .skeleton import skeleton
from .trees import READER, Tree, is_yaml, read_yaml, tree

_CHECK = "check_"
"""How the names of those functions begin that refuse: each of them is asked."""
_LONGEST = 40
"""How much of an argument a message shows."""


class Model:
    """What a model's folder says of specs and of the functions its templates use."""

    def __init__(self, folder: Path, root: Path) -> None:
        """Load the model in `folder`; `root` is the template that holds it.

        Raises:
            SpecError: the dictionary or the functions cannot be loaded.

        """
        self.dictionary: Dictionary = load(folder / "dictionary.yaml", root)
        self.functions: Functions = {}
        self.folders = list(dict.fromkeys((root / f).parent for f in self.dictionary.files))
        """Where its dictionary and those that this includes are."""
        for each in self.folders:
            for function, one in load_functions(each / "functions.py").items():
                known = self.functions.get(function) if function.startswith(_CHECK) else None
                self.functions[function] = _each(known, one) if known else one

    def context(
        self, xml: bytes, file: str, distro: str, root: Element | None = None
    ) -> dict[str, Any]:
        """Return the context of a spec; `file` is its name in messages.

        `root` is the outermost element where the spec was no XML.

        Raises:
            SpecError: the spec is not well-formed, or the dictionary does not allow it.

        """
        checked = self._checked(root or parse(xml, file), file, distro)
        context = complete(checked, self.functions, distro)
        context["notes"] += contradictions(context, self.dictionary)
        return {**context, "schema": names_schema(xml)}

    def places(self, xml: bytes, file: str) -> dict[str, str]:
        """Return where the elements of a spec are, by the labels of `hooks.changes`."""
        return places(self._checked(parse(xml, file), file), self.dictionary)

    def _checked(self, root: Element, file: str, distro: str = "") -> CheckedSpec:
        filters = {**public_functions(names), **self.functions}
        return check(root, self.dictionary, filters, file, distro)

    def reads_yaml(self, file: Path) -> bool:
        """Tell whether a file, or a folder, is YAML of which the model makes a spec."""
        return READER in self.functions and is_yaml(file)

    def read_yaml(self, file: Path, sources: Mapping[str, str]) -> tuple[Element, list[str]]:
        """Return the outermost element that YAML gives, and notes; see `hooks.trees`."""
        return read_yaml(file, self.functions[READER], self.dictionary, sources)

    def tree(self, context: Mapping[str, Any]) -> Tree:
        """Return what a spec must say to give a context; see `hooks.trees`."""
        return tree(context, self.dictionary)

    def name(self, context: Mapping[str, Any]) -> str:
        """Return the name of the package: the value of its first attribute."""
        return str(context[self.dictionary.naming])

    def skeleton(self, sources: Mapping[str, str]) -> str:
        """Return the XML a package starts with; see `hooks.skeleton`."""
        return skeleton(self.dictionary, sources)

    def schema(self) -> str:
        """Return the XML schema of the specs; see `hooks.schema`."""
        return schema(self.dictionary)


def load_functions(file: Path) -> Functions:
    """Return the public functions of a `functions.py`, each with faults that name it.

    The file is executed anew each time, so that two versions of a model never mix.
    """
    if not file.exists():
        return {}
    module = ModuleType(file.stem)
    module.__file__ = str(file)
    try:
        exec(compiled(file.read_text(encoding="utf-8"), str(file)), module.__dict__)
    except (Exception, SystemExit) as error:
        raise SpecError(f"{_place(file, error)}: {_why(error)}", "function-fails") from error
    return public_functions(module)


def public_functions(module: ModuleType) -> Functions:
    """Return the public functions that a module itself defines, each with faults that name it."""
    file = str(module.__file__)
    return {
        name: _reporting(Path(file), value)
        for name, value in vars(module).items()
        if inspect.isfunction(value)
        and value.__code__.co_filename == file
        and not name.startswith("_")
    }


def _each(*functions: Callable[..., None]) -> Callable[..., None]:
    def call(*arguments: Any) -> None:
        for function in functions:
            function(*arguments)

    return call


def _reporting(file: Path, function: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        try:
            return function(*arguments, **options)
        except SpecError:
            raise
        except (Exception, SystemExit) as error:
            given = ", ".join(shown(repr(argument), _LONGEST) for argument in arguments)
            raise SpecError(
                f"{_place(file, error, function.__code__.co_firstlineno)}:"
                f" {function.__name__}({given}): {_why(error)}",
                "function-fails",
            ) from error

    return call


def _why(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}".removesuffix(": ")


def _place(file: Path, error: BaseException, line: int | None = None) -> str:
    """Name the file, and the last line of it that led to the error, or else the given one."""
    lines = [
        frame.lineno
        for frame in traceback.extract_tb(error.__traceback__)
        if frame.filename == str(file)
    ]
    if isinstance(error, SyntaxError) and error.filename == str(file):
        lines.append(error.lineno)
    found = lines[-1] if lines else line
    return f"{file}:{found}" if found else str(file)
