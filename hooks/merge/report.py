"""What an update has to say, line by line."""

from __future__ import annotations

import contextlib
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from . import git, xml_blocks
from .blocks import Block, every
from .languages import CMAKE, CPP, PYTHON, XML, YAML, Language, language
from .merging import block_name
from .package import Result
from .proof import Proof
from .renaming import key_nodes
from .tree import File, Tree


@dataclass(frozen=True)
class Report:
    """The lines of the summary, the proof last; and the files in conflict."""

    lines: list[str]
    conflicts: list[str]


def report(
    package: Path,
    before: Tree,
    after: Tree,
    result: Result,
    changes: list[str],
    uses: Iterable[str],
    proof: Proof,
    more: Iterable[str] = (),
) -> Report:
    """Say what became of the files of a package, `before` and `after` an update.

    `more` is what there is to say of another branch's files.
    """
    conflicts = sorted(result.conflicts)
    files = [*_files(package, before, after, result), *_returned(package, before, after, result)]
    commit = git.last_commit(package)
    files += removed(commit, package, before, after, result)
    files += left_behind(f"{commit}:./{{}}".format, proof.left)
    files += more
    files += _unnamed(after, proof.left)
    others = [f"missing   {path}{part and ': '}{part}" for path, part in _missing(after, result)]
    own = "which the model makes now, too: compare"
    others += [f"back      {part}, which you had deleted" for part in _parts(result.back)]
    others += [f"yours     {part}, {own}" for part in _parts(result.own)]
    others += [f"still     {use}" for use in dict.fromkeys(uses)]
    others += [f"CONFLICT  {path}" for path in conflicts]
    if not changes and not files and not conflicts:
        others.append("Nothing has changed.")
    return Report([*changes, *files, *others, proof.sentence], conflicts)


def _parts(found: Mapping[str, list[str]]) -> Iterator[str]:
    return (f"{path}: {part}" for path, parts in sorted(found.items()) for part in parts)


def _files(package: Path, before: Tree, after: Tree, result: Result) -> Iterator[str]:
    sources = {new: old for old, new in result.moved.items()}
    added = [path for path in after if path not in sources and path not in before]
    deleted = git.once_there(package, added)
    for path, file in sorted(after.items()):
        if path in result.conflicts:
            continue
        old = before.get(sources.get(path, path))
        if path in sources:
            yield f"moved     {sources[path]} -> {path}"
        elif old is None:
            commit = git.commit_that_had(package, path) if path in deleted else ""
            was = f"      (as it was: git show {commit}:./{path})" if commit else ""
            yield f"added     {path}{was}"
        elif old != file:
            yield f"merged    {path}"


def _returned(package: Path, before: Tree, after: Tree, result: Result) -> Iterator[str]:
    """Name the callbacks that came, and were there earlier with other code."""
    sources = {new: old for old, new in result.moved.items()}
    came = []
    for path, file in sorted(after.items()):
        source = sources.get(path, path)
        old, known = before.get(source), language(path, file.written)
        if old is not None and old != file:
            had, has = _functions(known, old), _functions(known, file)
            for key in sorted(has.keys() - had.keys()):
                word = f"{key.removesuffix('()')}("
                came.append((path, source, known, key, word, has[key]))
    paths, words = {one[1]: None for one in came}, {one[4]: None for one in came}
    there = git.once_there(package, [*paths], [*words])
    for path, source, known, key, word, text in came:
        commit = git.commit_that_had(package, source, word) if source in there else ""
        if commit:
            past = _functions(known, File(git.committed(package, source, commit))).get(key)
            if past and not known.same(past, text):
                what = f"{block_name(key)} to {path}"
                yield f"added     {what}      (as it was: git show {commit}:./{source})"


def _functions(known: Language, file: File) -> dict[str, str]:
    """Return the text of each function of a file by its key."""
    found = _code(known, file)
    return {b.key: b.text for b in found if b.key.startswith("def ") or b.key.endswith("()")}


def _code(known: Language, file: File) -> list[Block]:
    """Return the blocks of a file of code, those inside of others, too."""
    with contextlib.suppress(ValueError, RecursionError):
        return [*every(known.blocks(file.written))] if known in (CPP, PYTHON) else []
    return []


def removed(
    commit: str, package: Path, before: Tree, after: Tree, result: Result
) -> Iterator[str]:
    """Name the files and parts that left."""
    parts = [(path, "") for path in before if path not in result.moved and path not in after]
    parts += [(path, part) for path, names in result.removed.items() for part in names]
    for path, part in sorted(parts):
        if part or not (package / path).exists():
            what = f"{part} from {path}" if part else path
            yield f"removed   {what}      (see it again: git show {commit}:./{path})"


def left_behind(
    shown: Callable[[str], str], left: Iterable[tuple[str, int, str]]
) -> Iterator[str]:
    """Name the developer's own lines among those that left, those of a place together.

    `shown` gives what `git show` wants for a path.
    """
    places: list[tuple[str, list[int], str]] = []
    for path, number, line in sorted(left):
        if places and places[-1][0] == path and number <= places[-1][1][-1] + 2:
            places[-1][1].append(number)
        else:
            places.append((path, [number], line.strip()))
    for path, numbers, text in places:
        span = f"{numbers[0]}-{numbers[-1]}" if len(numbers) > 1 else f"{numbers[0]}"
        text = text if len(text) <= 60 else f"{text[:57]}..."
        more = f" and {len(numbers) - 1} more" if len(numbers) > 1 else ""
        yield f"left      {path}:{span}: {text}{more}      (git show {shown(path)})"


def _unnamed(after: Tree, left: Iterable[tuple[str, int, str]]) -> Iterator[str]:
    """Name the files that only lines which left have named: nothing builds or installs them."""
    texts = {path: file.text for path, file in after.items() if file.text is not None}
    words = {word for _, _, line in left for word in re.findall(r"[\w.-]+", line)}
    for path in sorted(after):
        name = PurePosixPath(path).name
        if name in words and not any(name in text for text in texts.values()):
            yield f"unnamed   {path}: only lines that left have named it"


def _missing(after: Tree, result: Result) -> Iterator[tuple[str, str]]:
    """Name the generated parts that are not there.

    Any source may have a member of a class, a header may define it, a base may have it, and in
    Python another one may have its name. In YAML an anchor may give a key, or a mapping in one
    line, or its group has it; in CMake a loop may find packages.
    """
    found = [(path, part) for path, parts in sorted(result.missing.items()) for part in parts]
    bases: dict[str, set[str]] = {}
    has: set[tuple[str, str]] = set()
    for path, file in after.items() if found else ():
        if language(path, "") is XML:
            with contextlib.suppress(IndexError):
                has |= {(path, key) for key in xml_blocks.keys(file.written)}
                bases[path] = {path}
        if language(path, "") is YAML and path in result.missing:
            keys = key_nodes(file.written)  # those of an anchor for each of its uses, too
            often = Counter(key for _, key in keys)
            has |= {(path, key.value) for above, key in keys if "<<" in above or often[key] > 1}
            starts = ((key.value, file.written[: key.start_mark.index]) for _, key in keys)
            has |= {(path, key) for key, before in starts if before.rstrip().endswith(("{", ","))}
            ends = [(*above[at:], key.value) for above, key in keys for at in range(len(above))]
            has |= {(path, sign.join(names)) for names in ends for sign in "./"}
            bases[path] = {path}
        if language(path, "") is CMAKE and _FIND_EACH.search(file.written):
            words = {word for found in _LISTS.findall(file.written) for word in found.split()}
            has |= {(path, f"find_package {word}") for word in words}
            bases[path] = {path}
        for block in _code(language(path, ""), file):
            owner, _, name = block_name(block.key).rpartition("::")
            has |= {(owner, name)} | ({(path, name[:-2])} if name.endswith(" =") else set())
            if block.key.startswith("class "):
                name = block.key.removeprefix("class ")
                words = {*re.findall(r"\w+", "".join(block.lines))}
                bases |= {name: words, path: bases.get(path, {path}) | words - {name}}
                has |= {
                    (name, block_name(b.key)) for b in block.children if _DEFINED.search(b.text)
                }
    for path, part in found:
        owner, _, name = part.rpartition("::")
        if not any((one, name) in has for one in bases.get(owner or path, {owner})):
            yield path, part


_FIND_EACH = re.compile(r"(?i)\bfind_package\s*\(\s*\$\{")
_LISTS = re.compile(r"(?i)\b(?:set|list|foreach)\s*\(([^()]*)\)")
_DEFINED = re.compile(r"\{|\bdef ")
"""What a member has that is more than declared."""
