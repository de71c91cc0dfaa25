"""A house model takes all of upstream, each file once, and its versions are its own."""

import os
import subprocess
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[1]
UPSTREAM = ROOT / "upstream"
LEFT_OUT = set()
"""What this model does without, on purpose: names in upstream, files of the template as there."""


def files(template):
    """Return how often a template has each file, by the path in a package, links followed."""
    found = [
        os.path.relpath(os.path.join(folder, name), template).replace("{{ upstream }}/", "")
        for folder, _, names in os.walk(template, followlinks=True)
        for name in names
    ]
    return Counter(path.removesuffix(".jinja") for path in found)


def test_nothing_of_upstream_is_missed():
    names = {path.name for path in UPSTREAM.iterdir()} - {".git", "__pycache__"}
    missed = sorted(names - {path.name for path in ROOT.iterdir() if path.exists()} - LEFT_OUT)
    assert not missed, f"ln -s upstream/{missed[0]} . or name it in LEFT_OUT: {missed}"
    missed = sorted(files(UPSTREAM / "template") - files(ROOT / "template"))
    missed = [path for path in missed if path not in LEFT_OUT]
    assert not missed, f"link them into template, or name them in LEFT_OUT: {missed}"


def test_no_file_is_made_twice():
    twice = [path for path, times in files(ROOT / "template").items() if times > 1]
    assert not twice, f"upstream has these files, too: {twice}"


def test_links_lead_somewhere():
    links = [path for path in ROOT.rglob("*") if path.is_symlink() and not path.exists()]
    assert not links, f"upstream has these no more: {links}"


def test_upstream_has_the_places():
    known = "".join(path.read_text() for path in UPSTREAM.rglob("*.jinja"))
    filled = [path.name for path in ROOT.glob("house/*.jinja")]
    unknown = [name for name in filled if f'"house/{name}"' not in known]
    assert not unknown, f"no template of upstream includes these: {unknown}"


def test_versions_are_of_the_house():
    """Copier takes the highest: a tag of upstream's would outrank those before it."""
    command = ["git", "tag"]
    tags = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    foreign = [tag for tag in tags.split() if "+" not in tag]
    assert not foreign, f"git tag -d, and git push --delete origin: {foreign}"
