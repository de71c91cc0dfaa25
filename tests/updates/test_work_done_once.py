"""What takes time is done once: renders, compiled templates. Never with another version's."""

import os
import re
import sys
import tempfile

import copier
import copier._main
import copier._template
import jinja2.environment
import pytest
from jinja2.nodes import Template

from support import copier_once
from support.arm import SPEC
from support.repository import commit

CHANGES = {
    "nothing": (SPEC, 0),
    "an interface": (SPEC.replace('name="stop"', 'name="halt"'), 1),
    "a rename": (SPEC.replace('<node name="reach"', '<node name="grasp" was="reach"'), 2),
}


@pytest.fixture(autouse=True)
def cloned_each_time(monkeypatch):
    """Each copy and update has a folder of its own for the template, as users have."""
    monkeypatch.setattr(copier._template, "clone", copier_once.CLONE)


@pytest.mark.parametrize(("spec", "expected"), CHANGES.values(), ids=CHANGES)
def test_renders_of_an_update(arm, update, monkeypatch, spec, expected):
    """Besides Copier's own, one of which is as it was: as it is to be, as a rename marks it."""
    (arm / "arm.ros_package").write_text(spec)
    commit(arm, "Change the spec")
    made = []
    copy = copier.run_copy
    monkeypatch.setattr(copier, "run_copy", lambda *a, **b: made.append(b) or copy(*a, **b))
    update(arm)
    assert len([how for how in made if how["exclude"] != ["*"]]) == expected


def test_old_render_that_says_where_it_is_made(own_collection, render, update):
    """A template may write the name of the folder, which is another one where Copier renders."""
    template = own_collection / "python_model/template/PLACE.md.jinja"
    template.write_text("# {{ _folder_name }}\n{{ spec.description }}\n")
    commit(own_collection, "Name the folder", tag="1.1.0")
    package = render(SPEC, template=own_collection, name="arm")
    (package / "PLACE.md").write_text("# arm\nAn arm\nMine\n")
    (package / "arm.ros_package").write_text(SPEC.replace("An arm", "A leg"))
    commit(package, "Change the spec, and add a line")
    update(package)
    assert (package / "PLACE.md").read_text() == "# arm\nA leg\nMine\n"


def test_old_render_without_what_the_user_excludes(arm, copier_command):
    """Copier leaves that out of the version before, too, where the developer's file comes from."""
    store = '    <serviceServer name="store" type="std_srvs::Trigger"/>\n'
    (arm / "arm.ros_package").write_text(SPEC.replace(store, ""))
    commit(arm, "Change the spec")
    options = ("--trust", "--defaults", "--exclude", "reach_impl.py")
    result = copier_command("update", *options, cwd=arm)
    assert result.returncode == 0, result.stderr
    assert "serve_store" not in (arm / "arm/reach_impl.py").read_text()


def test_old_render_before_hooks_of_git_change_it(arm, copier_command, tmp_path):
    """Copier commits it, and hooks that a developer has for all repositories may format it."""
    (arm / "arm.ros_package").write_text(CHANGES["an interface"][0])
    commit(arm, "Change the spec")
    hook = tmp_path / "hooks/pre-commit"
    hook.parent.mkdir()
    hook.write_text("#!/bin/sh\nsed -i 's/    /  /' $(git ls-files '*.py')\n")
    hook.chmod(0o755)
    how = {"GIT_CONFIG_KEY_0": "core.hooksPath", "GIT_CONFIG_VALUE_0": str(hook.parent)}
    options = ("update", "--trust", "--defaults")
    result = copier_command(*options, cwd=arm, GIT_CONFIG_COUNT="1", **how)
    assert result.returncode == 0, result.stderr
    assert "17 of 18 of your lines" in result.stderr


def test_own_renders_ask_git_of_no_file(arm, update, monkeypatch):
    """Copier does, for each file that it writes, and goes on to do so where there is an index."""
    asked = []
    monkeypatch.setattr(
        copier._main.Worker,
        "_sync_git_index_executable_bit",
        lambda worker, *_: asked.append(worker.dst_path.parent.name),
    )
    update(arm)
    assert arm.parent.name in asked
    assert not [name for name in asked if name.startswith("ros_package.")]


@pytest.mark.parametrize(
    ("seconds", "options", "lines"), [("0.0", (), 3), ("0.0", ("--quiet",), 0), ("1000.0", (), 0)]
)
def test_progress_of_an_update(arm, own_collection, copier_command, seconds, options, lines):
    """Renders that take long are told one by one; others go by in silence, and all in --quiet."""
    render = own_collection / "hooks/merge/render.py"
    render.write_text(render.read_text().replace("SILENT = 2.0", f"SILENT = {seconds}"))
    commit(own_collection, "Another patience", tag="1.1.0")
    answers = arm / ".copier-answers.yml"
    answers.write_text(
        re.sub("_src_path: .*", f"_src_path: {own_collection}", answers.read_text())
    )
    (arm / "arm.ros_package").write_text(CHANGES["a rename"][0])
    commit(arm, "Change the spec")
    result = copier_command("update", "--trust", "--defaults", *options, cwd=arm)
    assert result.returncode == 0, result.stderr
    assert result.stderr.count("Rendering the package for the merge") == lines


@pytest.fixture
def compiled(monkeypatch, tmp_path):
    """Return the templates that Jinja compiles, beginning with an empty cache."""
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    templates = []
    generate = jinja2.environment.generate

    def count(node, *more, **options):
        if isinstance(node, Template):  # Copier renders what is no text, too, and takes the fault
            templates.append(more[1] or node)
        return generate(node, *more, **options)

    monkeypatch.setattr(jinja2.environment, "generate", count)
    return templates


@pytest.fixture
def package(own_collection, render):
    """Return a package with a text that Jinja computes while it compiles the template."""
    change_greeting(own_collection, "hello")
    template = own_collection / "python_model/template/GREETING.md.jinja"
    template.write_text("{{ 'you' | greeting }}\n")
    commit(own_collection, "Greet", tag="1.1.0")
    return render(SPEC, template=own_collection, name="arm")


def change_greeting(collection, word):
    file = collection / "python_model/functions.py"
    text = file.read_text().partition("\n\ndef greeting")[0]
    file.write_text(f"{text}\n\ndef greeting(name):\n    return f'{word} {{name}}'\n")


def test_templates_are_compiled_once(compiled, package, own_collection, render, update):
    update(package)
    assert compiled
    compiled.clear()
    render(SPEC, template=own_collection, name="again")
    update(package)
    assert compiled == []


def test_what_was_compiled_is_of_its_version(compiled, package, own_collection, update):
    assert (package / "GREETING.md").read_text() == "hello you\n"
    change_greeting(own_collection, "goodbye")
    commit(own_collection, "Say goodbye", tag="2.0.0")
    update(package)
    assert (package / "GREETING.md").read_text() == "goodbye you\n"


def test_folder_that_jinja_refuses(compiled, package, own_collection, render):
    """Where it cannot keep what it compiled, a package is made all the same."""
    for folder in (package.parent / "temporary").glob("_jinja2-cache-*"):
        for file in folder.iterdir():
            file.unlink()
        folder.rmdir()
        folder.write_text("no folder")
    compiled.clear()
    again = render(SPEC, template=own_collection, name="again")
    assert (again / "arm/reach_impl.py").exists()
    assert compiled
    assert os.listdir(again) == os.listdir(package)


def test_spec_is_told_as_a_tree_once(own_collection, render):
    """The file of each node asks for it, and it has all nodes."""
    nodes = [f'  <node name="n{number}" frequency="5"/>\n' for number in range(3)]
    asked = []

    def note(frame, event, _):
        code = frame.f_code
        if event == "call" and (code.co_name, code.co_filename[-8:]) == ("tree", "trees.py"):
            asked.append(frame)

    sys.setprofile(note)
    try:
        spec = re.sub("  <node.*</node>\n", "".join(nodes), SPEC, flags=re.DOTALL)
        render(spec, template=own_collection)
    finally:
        sys.setprofile(None)
    assert len(asked) == 1
