"""The collection as a git repository, and git itself."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
SPARED = re.compile(r"examples/\w+/\w+_model/|tests/(adoption|contract|data|fuzz|updates)/")
GIT = {
    f"GIT_{who}_{what}": value
    for who in ("AUTHOR", "COMMITTER")
    for what, value in (("NAME", "Test Er"), ("EMAIL", "test@example.org"))
}


def bare_repository(folder):
    """Make a bare repository, if it is not there, and return its folder."""
    if not folder.exists():
        folder.mkdir(parents=True)
        git(folder, "init", "--bare", "--quiet", "--initial-branch=main")
    return folder


def git(folder, *arguments):
    result = subprocess.run(
        ["git", *arguments], cwd=folder, check=True, capture_output=True, text=True
    )
    return result.stdout.strip()


def commit(folder, message="A change", tag=None):
    """Commit all of a folder, which becomes a repository if it is none."""
    if not (folder / ".git").exists() and not git_top(folder):
        git(folder, "init", "-q")
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "--allow-empty", "-m", message)
    if tag:
        git(folder, "tag", tag)


def publish(collection, host):
    """Publish every model of a collection in a folder of bare repositories, and return it."""
    for file in collection.glob("*_model/copier.yml"):
        bare = bare_repository(host / f"{file.parent.name}.git")
        command = [sys.executable, collection / "scripts/publish.py", file.parent.name, bare]
        subprocess.run(command, cwd=collection, check=True, capture_output=True)
    return host


def git_top(folder):
    command = ["git", "-C", str(folder), "rev-parse", "--show-toplevel"]
    return subprocess.run(command, capture_output=True, text=True).stdout.strip()


def copy_collection(target):
    """Copy the working tree and make it a repository.

    What git ignores stays out, and so do most files that no model needs, since Copier clones the
    repository for each package it makes.
    """
    names = git(ROOT, "ls-files", "-co", "--exclude-standard", "-z").split("\0")
    for name in filter(None, names):
        if (ROOT / name).exists() and not SPARED.match(name):
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, target / name, follow_symlinks=False)
    commit(target, "First version", tag="1.0.0")
    git(target, "repack", "-adq")  # which is cloned four times as fast
    return target
