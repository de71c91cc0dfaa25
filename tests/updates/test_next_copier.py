"""What copier-org/copier#2376 does in another way, as the bridge is told of it."""

import copier._main as copier_main
import pytest
from jinja2 import Environment, FileSystemLoader

from extensions import spec
from extensions.spec import SpecExtension
from hooks.run import old_copies, updating
from support.arm import SPEC
from support.repository import ROOT, commit


@pytest.fixture
def bridge():
    """Return how to call a function of the bridge as one of Copier's renders does."""

    def call(name, folder, *arguments, data=None):
        environment = Environment(loader=FileSystemLoader(ROOT), extensions=[SpecExtension])
        conf = {"dst_path": folder, "answers_file": ".copier-answers.yml", "data": data or {}}
        context = {"_copier_conf": conf, "_copier_answers": {}}
        context |= {"model": "python_model", "ros_distro": "kilted"}
        return environment.globals[name](context, *arguments)

    yield call
    updating.clear()


def test_questions_are_asked_in_a_temporary_folder(bridge, arm, tmp_path, monkeypatch):
    """After the first stage of migrations, which this Copier runs there, too."""
    (arm / "arm.ros_package").write_text(SPEC.replace('name="stop"', 'name="halt"'))
    commit(arm, "Change the spec")
    old, new = (tmp_path / f"copier._main.{each}_copy.x1" for each in ("old", "new"))
    for folder in (old, new):
        folder.mkdir()
    steps = spec.hooks.steps.Steps
    monkeypatch.setattr(steps, "check", lambda *_: None)
    bridge("begin_update", arm)
    bridge("begin_update", old)
    assert bridge("has_spec", new)
    assert "halt" in str(bridge("read_spec", new, "")["nodes"])
    assert not bridge("has_spec", old, data={"spec": {}})


def test_what_copier_makes_of_the_version_before_is_kept_and_no_other_package(bridge, tmp_path):
    """A command before this one may have made that, in one process."""
    old, new = (tmp_path / f"copier._main.{each}_copy.x1" for each in ("old", "new"))
    for folder in (old, new, tmp_path / "arm"):
        bridge("finish_join", folder, {"name": "arm"})
    assert [run.package.folder for run in old_copies] == [old]
    old_copies.clear()


def test_copier_looks_for_no_index_of_git_while_it_renders(monkeypatch):
    """Where it has no such function any more, it gets none."""
    monkeypatch.setattr(copier_main, "is_git_available", lambda: True)
    with spec._without_index():
        assert not copier_main.is_git_available()
    assert copier_main.is_git_available()
    monkeypatch.delattr(copier_main, "is_git_available")
    with spec._without_index():
        pass
    assert not hasattr(copier_main, "is_git_available")
