"""The Python of a template is loaded once, from a copy that outlasts the folder it came in."""

import atexit
import importlib.machinery
import runpy
import shutil
import sys
import tempfile
from importlib import import_module
from pathlib import Path

import pytest
from jinja2 import Environment, FileSystemLoader

from support.repository import ROOT


@pytest.fixture(autouse=True)
def temporary(tmp_path, monkeypatch):
    """Begin with an empty folder for what is kept, and without what other tests have loaded."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    before = forget()
    yield folder
    forget()
    sys.modules.update(before)


def forget():
    """Do as another command, which has loaded nothing yet; return what was loaded."""
    names = [name for name in sys.modules if name.startswith("template_")]
    return {name: sys.modules.pop(name) for name in names}


@pytest.fixture
def clone(tmp_path):
    """Return how to get another folder with the Python of the collection."""

    def make(name):
        for folder in ("hooks", "extensions"):
            shutil.copytree(ROOT / folder, tmp_path / name / folder)
        (tmp_path / name / "copier.yml").write_text("")
        return tmp_path / name

    return make


def load(folder):
    """Let Copier's environment load the extensions of a folder; return those."""
    environment = Environment(loader=FileSystemLoader(folder))
    file = folder / "extensions/load.py"
    return runpy.run_path(str(file))["AllExtensions"](environment)._all


def package(extensions):
    return type(extensions[0]).__module__.partition(".")[0]


def test_clones_share_the_code(clone):
    one, two = (load(clone(name)) for name in ("one", "two"))
    assert [type(extension) for extension in one] == [type(extension) for extension in two]
    assert one[1].root.name == "one"
    assert two[1].root.name == "two"


def test_other_code_is_loaded_beside(clone):
    one, other = load(clone("one")), clone("other")
    with (other / "hooks/words.yaml").open("a") as file:
        file.write("# other\n")
    two = load(other)
    assert package(one) != package(two)
    (words,) = Path(sys.modules[package(two)].__path__[0]).glob("hooks/words.yaml")
    assert words.read_text().endswith("# other\n")


def test_clone_that_is_gone(clone):
    """Copier deletes it after the render; what is imported later is still there."""
    extensions = load(clone("one"))
    shutil.rmtree(extensions[1].root)
    assert import_module(f"{package(extensions)}.hooks.merge.update").Update


def test_nothing_is_compiled_again(clone, monkeypatch):
    """Not by another command either, nor where Python is told to write no byte code."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    load(clone("one"))
    forget()
    monkeypatch.setattr(importlib.machinery.SourceFileLoader, "source_to_code", None)
    assert load(clone("two"))


def test_copy_that_has_lost_a_file(clone, temporary):
    """As a temporary folder does that is cleared of old files."""
    load(clone("one"))
    forget()
    (steps,) = temporary.glob("*/*/hooks/steps.py")
    steps.unlink()
    for compiled in steps.parent.glob("__pycache__/steps.*"):
        compiled.unlink()
    load(clone("two"))
    assert steps.read_text() == (ROOT / "hooks/steps.py").read_text()


def test_folder_that_others_could_write_to(clone, temporary, monkeypatch):
    """Jinja refuses it; the copy is then in a folder of this process, and goes with it."""
    at_exit = []
    monkeypatch.setattr(atexit, "register", lambda *call, **named: at_exit.append((call, named)))
    load(clone("one"))
    (folder,) = temporary.iterdir()
    shutil.rmtree(folder)
    folder.write_text("no folder")
    with (clone("two") / "hooks/words.yaml").open("a") as file:
        file.write("# other\n")
    place = Path(sys.modules[package(load(Path(file.name).parents[1]))].__path__[0])
    assert place.parent != folder
    assert place.parent.name.startswith("template.")
    ((remove, target), named) = next(end for end in at_exit if end[0][0] is shutil.rmtree)
    remove(target, **named)
    assert not place.parent.exists()


def test_each_extension_rewrites_a_template(clone):
    folder = clone("one")
    environment = Environment(loader=FileSystemLoader(folder))
    file = folder / "extensions/load.py"
    extension = runpy.run_path(str(file))["AllExtensions"](environment)
    assert "yield node" in extension.preprocess("[node.name].py", None)
    assert "fold_python" in extension.preprocess("a = 1", "a.py.jinja")
