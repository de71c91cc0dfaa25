"""Templates compiled once: their byte code lasts from one render, or one command, to the next."""

from __future__ import annotations

import contextlib
import functools
import hashlib
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from types import CodeType
from typing import Any

from jinja2 import Environment, FileSystemBytecodeCache
from jinja2.bccache import Bucket
from jinja2.ext import Extension

_LIBRARIES = ("copier", "jinja2", "jinja2-ansible-filters")
_known: dict[str, Any] = {}
"""Byte code by the keys of templates and the digests of their texts, or by version and text."""


class CompiledExtension(Extension):
    """Keep compiled templates in the folder where Jinja keeps them: by default, a temporary one.

    An update renders a package several times, and each render has an environment of its own
    (decision 4).
    """

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        # Jinja refuses a temporary folder that others could write to; a library may be there
        # without its metadata.
        with contextlib.suppress(ImportError, OSError, RuntimeError):
            root = Path(environment.loader.searchpath[0])  # type: ignore[union-attr]
            cache = environment.bytecode_cache = _Cache(_version(root))
            compiled = functools.partial(_compile, environment, cache, environment.compile)
            environment.compile = compiled  # type: ignore[assignment, method-assign]


class _Cache(FileSystemBytecodeCache):
    """Tells templates apart by their name and version, since their folder is another each time."""

    def __init__(self, version: str) -> None:
        super().__init__()
        self.version = version

    def get_cache_key(self, name: str, filename: str | None = None) -> str:
        return super().get_cache_key(f"{self.version} {name}")

    def get_bucket(
        self, environment: Environment, name: str, filename: str | None, source: str
    ) -> Bucket:
        bucket = super().get_bucket(environment, name, filename, source)
        if bucket.code and filename:  # which faults name; of the functions in it they name none
            bucket.code = bucket.code.replace(co_filename=filename)
        return bucket

    def load_bytecode(self, bucket: Bucket) -> None:
        """Read it once in an update, which renders several times."""
        key = f"{bucket.key} {bucket.checksum}"
        if key not in _known:
            super().load_bytecode(bucket)
            if bucket.code is None:
                return
            _known[key] = bucket.code
        bucket.code = _known[key]

    def dump_bytecode(self, bucket: Bucket) -> None:
        _known[f"{bucket.key} {bucket.checksum}"] = bucket.code
        with contextlib.suppress(OSError):  # a full disk
            super().dump_bytecode(bucket)


def _compile(
    environment: Environment,
    cache: _Cache,
    compiler: Callable[..., CodeType],
    source: Any,
    name: str | None = None,
    *options: Any,
) -> CodeType:
    """Compile a template; one without a file, which no loader looks up, by its text."""
    if name is not None or not isinstance(source, str) or options:
        return compiler(source, name, *options)
    # Copier (9.19) forgets the `yield` of the text before when it preprocesses the next one.
    environment.preprocess(source)
    key = f"{cache.version} {source}"
    if key not in _known:
        bucket = cache.get_bucket(environment, source, None, source)
        if bucket.code is None:
            lines = source.strip().splitlines() or [""]
            bucket.code = compiler(source, None, f'"{lines[0]}"')  # what faults have for a file
            cache.set_bucket(bucket)
        _known[key] = bucket.code
    known: CodeType = _known[key]
    return known


def _version(root: Path) -> str:
    """Return what stands for all that compiled templates depend on but their texts.

    Jinja calls a filter while compiling where all that it is given is constant.
    """
    digest = hashlib.sha1(" ".join(map(version, _LIBRARIES)).encode())
    for pattern in ("*.py", "*.yaml", "*.yml"):
        for file in sorted({*root.glob(pattern), *root.glob(f"*/{pattern}")}):
            digest.update(file.read_bytes())
    return digest.hexdigest()
