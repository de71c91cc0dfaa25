"""Carry the code of what was renamed to its new name: a migration of `copier update`.

    python rename.py RENAMES      in the package, after the update; RENAMES as JSON

Copier sees a renamed file as one that left and one that came. So each file is merged again, from
three texts: the developer's (HEAD), the old render and the new one, the first two with the
old words exchanged for the new. Which words those are, the renders tell: a word that left, and
that the new names turn into a word that came.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Container, Mapping
from pathlib import Path
from typing import Any

import copier
import yaml

ANSWERS = ".copier-answers.yml"
Names = list[tuple[str, str]]


def carry(package: Path, renames: list[dict[str, str]]) -> None:
    """Merge the developer's code of HEAD into the files that now have other names or words.

    `renames` is what `hooks.changes.renames` returns.
    """
    old_answers = yaml.safe_load(_git(package, "show", f"HEAD:./{ANSWERS}"))
    new_answers = yaml.safe_load((package / ANSWERS).read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        old = _render(Path(folder) / "old", old_answers)
        new = _render(Path(folder) / "new", new_answers)
    names = [pair for rename in renames for pair in _forms(rename["before"], rename["after"])]
    everywhere = _exchanges(old, new, names)
    of_owner = [
        (
            rename["owner_before"],
            _exchanges(
                _named(old, rename["owner_before"]),
                _named(new, rename["owner_after"]),
                _forms(rename["before"], rename["after"]),
            ),
        )
        for rename in renames
    ]
    for path in _git(package, "ls-tree", "-r", "--name-only", "-z", "HEAD", ".").split("\0"):
        if not path or path == ANSWERS:
            continue
        try:
            mine = _git(package, "show", f"HEAD:./{path}")
        except UnicodeDecodeError:
            continue
        words = dict(everywhere)
        for owner, exchanges in of_owner:
            words |= exchanges if owner in path else {}
        target = path if path in new or path not in old else _new_path(path, new, names)
        if path in old and target in new:
            if target != path or _exchange(mine, words) != mine:
                _merge(package, path, target, [mine, old[path], new[target]], words)
        elif path not in old and (package / path).exists():
            _write(package / path, _exchange(mine, words))


def _merge(
    package: Path, path: str, target: str, texts: list[str], words: Mapping[str, str]
) -> None:
    """Write the merge of three texts, the developer's, the old and the new, to `target`."""
    mine, old, new = texts
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder) / name for name in ("mine", "old", "new")]
        for file, text in zip(
            files, (_exchange(mine, words), _exchange(old, words), new), strict=True
        ):
            _write(file, text)
        labels = ("before updating", "last update", "after updating")
        options = [option for label in labels for option in ("-L", label)]
        _git(package, "merge-file", *options, *map(str, files), accepted=range(128))
        _write(package / target, files[0].read_bytes().decode())
    if target != path:
        (package / path).unlink(missing_ok=True)
    _git(package, "reset", "--quiet", "--", path)


def _named(files: Mapping[str, str], owner: str) -> dict[str, str]:
    """Return the files of a component, which carry its name."""
    return {path: text for path, text in files.items() if owner in path}


def _new_path(path: str, new: Mapping[str, str], names: Names) -> str:
    for before, after in names:
        if path.replace(before, after) in new:
            return path.replace(before, after)
    return path


def _forms(before: str, after: str) -> Names:
    """Return the ways a name is written in code: as a word, and as a class."""
    plain = [re.sub(r"\W+", "_", name).strip("_") for name in (before, after)]
    classes = ["".join(w[:1].upper() + w[1:] for w in name.split("_")) for name in plain]
    upper = [name.upper() for name in plain]
    forms = [[before, after], plain, classes, upper]
    return list(dict.fromkeys((old, new) for old, new in forms))


def _exchanges(old: Mapping[str, str], new: Mapping[str, str], names: Names) -> dict[str, str]:
    """Return the words that left some files, each with the word that came in its place."""
    gone, come = _words(old) - _words(new), _words(new) - _words(old)
    return {
        word: word.replace(before, after)
        for word in gone
        for before, after in names
        if word.replace(before, after) in come
    }


def _words(files: Mapping[str, str]) -> set[str]:
    return {word for text in files.values() for word in re.findall(r"[A-Za-z_]\w*", text)}


def _exchange(text: str, words: Mapping[str, str]) -> str:
    return re.sub(r"[A-Za-z_]\w*", lambda word: words.get(word[0], word[0]), text)


def _render(folder: Path, answers: dict[str, Any]) -> dict[str, str]:
    """Render what some answers gave, and return the text of each file by its path."""
    copier.run_copy(
        answers["_src_path"],
        folder,
        data={key: value for key, value in answers.items() if not key.startswith("_")},
        vcs_ref=answers.get("_commit"),
        defaults=True,
        unsafe=True,
        quiet=True,
    )
    files = [path for path in folder.rglob("*") if path.is_file()]
    return {str(path.relative_to(folder)): path.read_bytes().decode() for path in files}


def _write(file: Path, text: str) -> None:
    file.write_bytes(text.encode())


def _git(folder: Path, *arguments: str, accepted: Container[int] = (0,)) -> str:
    result = subprocess.run(["git", *arguments], cwd=folder, capture_output=True, check=False)
    if result.returncode not in accepted:
        raise RuntimeError(f"git {' '.join(arguments)}: {result.stderr.decode()}")
    return result.stdout.decode()


if __name__ == "__main__":
    carry(Path.cwd(), json.loads(sys.argv[1]))
