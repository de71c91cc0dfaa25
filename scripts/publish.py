"""Publish a model of the collection as a git repository of its own.

    python scripts/publish.py python_model git@github.com:org/python_model.git

Every version tag of the collection that has the model becomes one commit there, with the same tag,
message, author and date: the model's folder is its root, beside hooks, extensions, shared and the
licence. A link out of the model's folder becomes the file or folder it leads to. The commits are
the same whoever publishes them, so publishing again adds only what is new.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from packaging.version import InvalidVersion, Version

SHARED = ("hooks", "extensions", "shared")


def publish(repository: Path, model: str, target: str) -> list[str]:
    """Push each version of `model` to the repository at `target`; return the tags.

    Raises:
        subprocess.CalledProcessError: git refused; its message went to standard error.

    """
    parent = ""
    refs = []
    for tag in _version_tags(repository):
        if _git(repository, "ls-tree", "--name-only", tag, f"{model}/copier.yml"):
            parent = _commit(repository, model, tag, parent)
            refs.append(f"{parent}:refs/tags/{tag}")
    if refs:
        _git(repository, "push", "--quiet", target, *refs, f"{parent}:refs/heads/main")
    return [ref.rpartition("/")[2] for ref in refs]


def _version_tags(repository: Path) -> list[str]:
    tags = []
    for tag in _git(repository, "tag", "--merged", "HEAD").split():
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
        beside = {name: name for name in SHARED if name not in links.values()}
        for path, source in {**links, **beside, "LICENSE": "LICENSE"}.items():
            _git(repository, "update-index", "--force-remove", path, **index)
            mode, kind, blob = _git(repository, "ls-tree", tag, source).split()[:3]
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
    return _git(repository, "commit-tree", tree, *parents, "-m", values[6].strip(), **identity)


def _links(repository: Path, tag: str, model: str) -> dict[str, str]:
    """Return the model's symbolic links, each with the path in the collection it leads to."""
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
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    return result.stdout.strip()


def main() -> int:
    """Publish what the command line names."""
    parser = argparse.ArgumentParser(description="Publish a model as a repository of its own.")
    parser.add_argument("model", help="a model's folder, such as python_model")
    parser.add_argument("target", help="the address of its repository")
    arguments = parser.parse_args()
    try:
        tags = publish(Path(__file__).parents[1], arguments.model, arguments.target)
    except subprocess.CalledProcessError as error:
        return int(error.returncode)
    print(f"{arguments.model}: {', '.join(tags) or 'no version tag has this model'}")
    return 0 if tags else 1


if __name__ == "__main__":
    sys.exit(main())
