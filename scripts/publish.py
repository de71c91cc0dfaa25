"""Publish a model of the collection as a git repository of its own.

    python scripts/publish.py python_model git@github.com:org/python_model.git

Every version tag of the collection that has the model becomes one commit there, with the same tag,
message, author and date: the model's folder is its root, beside hooks, extensions, shared, house
(if there is one) and the licence. A link out of the model's folder becomes the file or folder it
leads to. `main` there is the highest version. The commits are the same whoever publishes them, so
publishing again adds only what is new; and where one is refused, nothing is pushed.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path

from packaging.version import InvalidVersion, Version

SHARED = ("hooks", "extensions", "shared", "house")


class PublishError(Exception):
    """Why nothing was published, in a sentence that ends with its id."""

    def __init__(self, text: str, id_: str) -> None:
        super().__init__(f"{text} [{id_}]")


class GitError(PublishError):
    """A command of git that failed, with the line in which git says why."""

    def __init__(self, result: subprocess.CompletedProcess[str]) -> None:
        self.stderr = result.stderr
        lines = self.stderr.splitlines()
        said = [line for line in lines if line.startswith(("fatal:", "error:"))]
        text = said[0] if said else f"git ends with exit code {result.returncode}"
        super().__init__(text, "git-fails")


def publish(repository: Path, model: str, target: str) -> list[str]:
    """Push each version of `model` to the repository at `target`, or nothing; return the tags.

    Raises:
        PublishError: a version cannot be made, or the repository does not take it.

    """
    if _git(repository, "rev-parse", "--is-shallow-repository") == "true":
        what = "the clone is shallow; git fetch --unshallow --tags completes it"
        raise PublishError(what, "shallow-clone")
    made = _versions(repository, model)
    if not made:
        return []
    there = _published(repository, target)
    for tag in made.keys() & there.keys():
        if made[tag] != there[tag]:
            what = f"{tag} is published with other content; give it a new number"
            raise PublishError(what, "changed-tag")
    latest = list(made.values())[-1]
    new = [f"{commit}:refs/tags/{tag}" for tag, commit in made.items() if tag not in there]
    try:
        _git(repository, "push", "--quiet", "--atomic", target, *new, f"{latest}:refs/heads/main")
    except GitError as error:
        if "rejected" not in error.stderr:
            raise
        what = "main there has commits that were not published from here"
        raise PublishError(what, "foreign-commits") from error
    return list(made)


def _versions(repository: Path, model: str) -> dict[str, str]:
    """Make the commit of each version that has the model, in the order of the versions.

    It follows the highest version that it is built upon: one that is mended later, as 1.0.1 after
    1.1.0, changes no other.
    """
    is_folder = re.fullmatch(r"[\w-]+/?", model)  # and not the collection itself
    tags = [
        tag
        for tag in _version_tags(repository)
        if is_folder and _git(repository, "ls-tree", "--name-only", tag, f"{model}/copier.yml")
    ]
    for one, other in pairwise(tags):
        if Version(one) == Version(other):
            raise PublishError(f"{one} and {other} are one version; delete one", "version-twice")
    places = {tag: _git(repository, "rev-parse", f"{tag}^{{commit}}") for tag in tags}
    made: dict[str, str] = {}

    def make(tag: str) -> str:
        if tag not in made:
            merged = _git(repository, "tag", "--merged", tag).split()
            is_later = tags[tags.index(tag) :]  # may be on the same commit
            before = [
                each
                for each in tags
                if each in merged and (places[each] != places[tag] or each not in is_later)
            ]
            made[tag] = _commit(repository, model, tag, make(before[-1]) if before else "")
        return made[tag]

    return {tag: make(tag) for tag in tags}


def _published(repository: Path, target: str) -> dict[str, str]:
    """Return the tags at `target`, each with its commit."""
    lines = _git(repository, "ls-remote", "--tags", "--refs", target).splitlines()
    return {ref.removeprefix("refs/tags/"): hash_ for hash_, ref in map(str.split, lines)}


def _version_tags(repository: Path) -> list[str]:
    tags = []
    for tag in _git(repository, "tag").split():
        try:
            tags.append((Version(tag), tag))
        except InvalidVersion:
            continue
    return [tag for _, tag in sorted(tags)]


def _commit(repository: Path, model: str, tag: str, parent: str) -> str:
    """Make the commit of one version, without touching the index or the work tree."""
    with tempfile.TemporaryDirectory() as folder:
        index = {"GIT_INDEX_FILE": f"{folder}/index"}
        _git(repository, "read-tree", f"{tag}:{model}", **index)
        links = _links(repository, tag, model)
        own = _git(repository, "ls-tree", "--name-only", f"{tag}:{model}").split("\n")
        beside = {name: name for name in SHARED if name not in links.values()}
        if taken := beside.keys() & set(own):
            what = f"{tag}: {model} has {taken.pop()} already; call it otherwise"
            raise PublishError(what, "path-taken")
        for path, source in {**links, **beside, "LICENSE": "LICENSE"}.items():
            _git(repository, "update-index", "--force-remove", path, **index)
            if not (found := _git(repository, "ls-tree", tag, source)):
                continue  # of an early version
            mode, kind, blob = found.split()[:3]
            if kind == "tree":
                _git(repository, "read-tree", f"--prefix={path}/", blob, **index)
            else:
                entry = f"{mode},{blob},{path}"
                _git(repository, "update-index", "--add", "--cacheinfo", entry, **index)
        tree = _git(repository, "write-tree", **index)
    form = "%an%n%ae%n%aI%n%cn%n%ce%n%cI%n%B"
    values = _git(repository, "log", "-1", f"--format={form}", tag).split("\n", 6)
    people = (f"GIT_{who}_{what}" for who in ("AUTHOR", "COMMITTER") for what in _PERSON)
    parents = ("-p", parent) if parent else ()
    identity = dict(zip(people, values[:6], strict=True))
    whence = f"Collection-commit: {_git(repository, 'rev-parse', f'{tag}^{{commit}}')}"
    message = ("-m", values[6].strip(), "-m", whence)
    return _git(repository, "commit-tree", tree, *parents, *message, **identity)


def _links(repository: Path, tag: str, model: str) -> dict[str, str]:
    """Return the model's symbolic links, each with the path in the collection it leads to.

    Decisions 91 and 93: the mixed model and the starter have links to what they carry.
    """
    links = {}
    for entry in _git(repository, "ls-tree", "-r", "-z", f"{tag}:{model}").split("\0"):
        if entry.startswith("120000"):
            path = entry.partition("\t")[2]
            target = _git(repository, "cat-file", "blob", f"{tag}:{model}/{path}")
            links[path] = os.path.normpath(os.path.join(model, os.path.dirname(path), target))
    return links


_PERSON = ("NAME", "EMAIL", "DATE")


def _git(repository: Path, *arguments: str, **environment: str) -> str:
    result = subprocess.run(
        ["git", *arguments],
        cwd=repository,
        env=os.environ | environment,
        capture_output=True,
        text=True,
    )
    if result.returncode:
        raise GitError(result)
    return result.stdout.strip()


def main() -> int:
    """Publish what the command line names."""
    parser = argparse.ArgumentParser(description="Publish a model as a repository of its own.")
    parser.add_argument("model", help="a model's folder, such as python_model")
    parser.add_argument("target", help="the address of its repository")
    arguments = parser.parse_args()
    try:
        tags = publish(Path(__file__).parents[1], arguments.model, arguments.target)
    except PublishError as error:
        address = re.sub("//[^/@]*@", "//", arguments.target)  # without a token
        print(f"{arguments.model}: nothing is pushed to {address}: {error}", file=sys.stderr)
        return 1
    print(f"{arguments.model}: {', '.join(tags) or 'no version tag has this model'}")
    return 0 if tags else 1


if __name__ == "__main__":
    sys.exit(main())
