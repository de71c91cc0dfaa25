"""What Copier 9.19 does again for each copy and update, done once in a run of the tests.

It clones the template, reads copier.yml with PyYAML's parser in Python, asks git whether a folder
is a bundle, and what core.fileMode is for each file. Tests that start the command `copier` in a
process of its own have all of it.
"""

import copy
import functools
import hashlib
import os
import shutil
import tempfile
from pathlib import Path

import copier._main
import copier._template
import copier._vcs

from support.repository import git

CLONE = copier._template.clone


def use(patch, folder):
    """Let Copier keep in `folder`, for all processes of a run, what it has cloned."""
    # This is what git takes by default.
    patch.setattr(
        copier._main.Worker, "_sync_git_index_executable_bit", lambda *_: None, raising=False
    )
    patch.setattr(copier._template, "clone", functools.partial(_clone, folder))
    load = functools.partial(_load, copier._template.load_template_config, folder, {})
    patch.setattr(copier._template, "load_template_config", load)
    is_bundle = copier._vcs.is_git_bundle
    patch.setattr(copier._vcs, "is_git_bundle", lambda path: path.is_file() and is_bundle(path))


def _clone(folder, url, ref="HEAD", location=None):
    """Clone a commit of a local repository, with the tags it has now, unless that was done."""
    if ref == "HEAD" or not Path(url).is_dir():
        return CLONE(url, ref, location)
    key = f"{Path(url).resolve()} {ref}\n{git(url, 'show-ref', '--head')}"
    kept = folder / hashlib.sha1(key.encode()).hexdigest()
    if not kept.exists():
        folder.mkdir(exist_ok=True)
        made = Path(tempfile.mkdtemp(dir=folder), "clone")
        CLONE(url, ref, str(made))
        try:
            os.rename(made, kept)
        except OSError:  # another process was faster
            shutil.rmtree(made)
        made.parent.rmdir()
    return str(kept)


def _load(load, folder, known, path, quiet=False):
    """Read a copier.yml; that of what is kept, or a copy of it, once in a process."""
    key = path.parent.name
    if not (folder / key).exists():
        return load(path, quiet)
    if key not in known:
        known[key] = load(path, quiet)
    return copy.deepcopy(known[key])
