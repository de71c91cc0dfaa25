"""The steps of an update, and its renders, with a function in the place of Copier."""

import time
from pathlib import Path

import pytest
import yaml

from hooks import model
from hooks.faults import SpecError
from hooks.merge import render as module
from hooks.merge.moves import FILE, moved_files
from hooks.merge.render import Renderer, begin, recorded_answers
from hooks.merge.tree import read_folder, write
from hooks.package import Package
from hooks.run import Run
from hooks.steps import Steps
from support.repository import ROOT, commit, git
from support.small_model import ANSWERS, SPEC, Model, answers


class Copies:
    """Makes packages of the small model, as Copier would, and keeps how it was asked to."""

    def __init__(self):
        self.asked = []

    def __call__(self, source, folder, data, answers_file, version, without):
        self.asked.append((source, version, folder.name, {*data}, answers_file))
        self.template = {*read_folder(Path(source))} if Path(source).is_dir() else set()
        for path, file in Model().fresh(data).tree.items():
            write(folder / path, file)
        return lambda path: path == Path(SPEC)


@pytest.fixture
def copies():
    begin()
    yield Copies()
    begin()


@pytest.fixture
def template(tmp_path):
    folder = tmp_path / "model"
    (folder / ".git").mkdir(parents=True)
    (folder / ".git/config").write_text("")
    (folder / "copier.yml").write_text("a: 1\n")
    return folder


def test_a_render_is_made_once(copies, template):
    """From a copy of the template without its repository, which Copier would clone."""
    renderer = Renderer(copies, template, "model", "1.0.0", "arm", ANSWERS)
    given = answers("load")
    made = renderer.fresh(given)
    assert renderer.recorded(given) is made
    assert renderer.fresh(dict(reversed(given.items()))) is made
    assert made.tree == Model().fresh(given).tree
    assert [made.is_kept(path) for path in (SPEC, "arm.py")] == [True, False]
    ((source, *others),) = copies.asked
    assert others == [None, "arm", {"spec"}, ANSWERS]
    assert (Path(source) != template, Path(source).name) == (True, "model")
    assert copies.template == {"copier.yml"}
    begin()
    assert renderer.fresh(given).tree == made.tree
    assert len(copies.asked) == 2


def test_template_on_another_disk_is_copied(copies, template, monkeypatch):
    """Where no file can be a link to one of it."""

    def link(*_):
        raise OSError

    monkeypatch.setattr("os.link", link)
    Renderer(copies, template, "model", "1.0.0", "arm", ANSWERS).fresh(answers("load"))
    assert copies.template == {"copier.yml"}


@pytest.mark.parametrize(
    ("url", "commit_"), [("~/model", "1.0.0"), ("model", "0.9.0"), ("model", None)]
)
def test_recorded_version_is_rendered_from_where_it_is(
    copies, template, monkeypatch, url, commit_
):
    monkeypatch.setenv("HOME", "/home/ada")
    renderer = Renderer(copies, template, "model", "1.0.0", "arm", ANSWERS)
    given = answers("load", _src_path=url, _commit=commit_)
    assert renderer.recorded(given) is renderer.recorded(given)
    assert copies.asked == [(url.replace("~", "/home/ada"), commit_, "arm", {"spec"}, ANSWERS)]
    renderer.fresh(given)
    assert len(copies.asked) == 2


def test_other_answers_and_other_names_are_other_renders(copies, template):
    about = [(template, "a", None, "arm", ANSWERS), (template, "a", None, "leg", ANSWERS)]
    about += [(template, "a", None, "arm", "other.yml"), (template, "a", "1", "arm", ANSWERS)]
    for each in about:
        renderer = Renderer(copies, *each)
        renderer.fresh(answers("load"))
        renderer.fresh(answers("store"))
        renderer.fresh(answers("store"))
    assert len(copies.asked) == 8
    Renderer(copies, template, "b", None, "arm", ANSWERS).fresh(answers("load"))
    assert len(copies.asked) == 8  # of a folder without a version, its place tells


@pytest.mark.parametrize(("quiet", "silent", "said"), [(0, 0.0, 2), (1, 0.0, 0), (0, 60.0, 0)])
def test_renders_that_take_long_are_said(
    copies, template, monkeypatch, capsys, quiet, silent, said
):
    """Once all of them together do, each with its number."""
    monkeypatch.setattr(module, "SILENT", silent)
    begin(quiet=bool(quiet))

    def slow(*about):
        end = time.monotonic() + 60
        while said and "for the merge" not in seen() and time.monotonic() < end:
            time.sleep(0.01)
        return copies(*about)

    heard = []

    def seen():
        heard.append(capsys.readouterr().err)
        return heard[-1]

    for name in ("load", "store"):
        Renderer(slow, template, "model", "1", "arm", ANSWERS).fresh(answers(name))
    heard.append(capsys.readouterr().err)
    lines = "".join(heard).splitlines()
    assert lines == [f"Rendering the package for the merge ({n + 1})" for n in range(said)]


@pytest.mark.parametrize("text", ["a: [1,\n", "- a\n", ""])
def test_answers_that_are_none(tmp_path, text):
    (tmp_path / ANSWERS).write_text("spec: {name: arm}\n")
    commit(tmp_path)
    assert recorded_answers(tmp_path, ANSWERS) == {"spec": {"name": "arm"}}
    (tmp_path / ANSWERS).write_text(text)
    commit(tmp_path)
    assert recorded_answers(tmp_path, ANSWERS) == {}
    assert recorded_answers(tmp_path, ANSWERS, "HEAD^") == {"spec": {"name": "arm"}}
    assert recorded_answers(tmp_path, "other.yml") == {}


@pytest.mark.parametrize(
    ("text", "moved"),
    [
        ("", {}),
        ("'{package}/a.py': 'a.py'", {"a.py": "arm/a.py"}),
        ("'src/{node}_b.py': 'b_{node}.py'", {"b_r.py": "src/r_b.py", "b_w.py": "src/w_b.py"}),
        ("'{package}/{node}.py': '{node}.py'", {"r.py": "arm/r.py", "w.py": "arm/w.py"}),
    ],
)
def test_moved_files_of_a_version(tmp_path, text, moved):
    (tmp_path / "dictionary.yaml").write_text("node_interface: {topic: [name]}\n")
    known = model.Model(tmp_path, tmp_path)
    spec = {"name": "arm", "nodes": [{"name": "r"}, {"name": "w"}]}
    assert moved_files(spec, known) == {}
    (tmp_path / FILE).write_text(text)
    assert moved_files(spec, known) == moved


def test_moved_files_of_an_included_dictionary(tmp_path):
    """Whichever of the folders has any."""
    (tmp_path / "own").mkdir()
    (tmp_path / "own/dictionary.yaml").write_text("include: dictionary.yaml\n")
    (tmp_path / "dictionary.yaml").write_text("node_interface: {topic: [name]}\n")
    known = model.Model(tmp_path / "own", tmp_path)
    for folder in known.folders:
        (folder / FILE).write_text("'{package}/a.py': 'a.py'")
        assert moved_files({"name": "arm"}, known) == {"a.py": "arm/a.py"}
        (folder / FILE).unlink()


@pytest.mark.parametrize(
    "text",
    ["- a", "'{arm}/{node': b", "a: '{leg}'", "a: [", "'{': a", "a: [b]", "1: b", "a: '{}'"],
)
def test_moved_files_that_are_no_mapping_of_paths(tmp_path, text):
    (tmp_path / "dictionary.yaml").write_text("node_interface: {topic: [name]}\n")
    known = model.Model(tmp_path, tmp_path)
    (tmp_path / FILE).write_text(text)
    if text in ("'{arm}/{node': b", "'{': a"):
        assert moved_files({"name": "arm"}, known) == {}  # is of no component
        return
    with pytest.raises(SpecError, match=rf"{FILE}: must be a mapping of new paths.*wrong-shape"):
        moved_files({"name": "arm"}, known)


@pytest.fixture
def package(tmp_path):
    folder = tmp_path / "arm"
    given = answers("load", "store")
    for path, file in Model().fresh(given).tree.items():
        write(folder / path, file)
    (folder / ANSWERS).write_text(yaml.safe_dump(given))
    commit(folder)
    return folder


XML = b"""<package name="arm" author="A" author_email="a@b.de" description="d" license="MIT">
<node name="reach" frequency="1"/></package>"""


class Life:
    """Calls the steps as Copier's would be."""

    def __init__(self, package, template, copies, given, **how):
        self.package, self.spec = package, given["spec"]
        usual = {"pretend": False, "overwrite": False, "quiet": True, "inline": True}
        how = {**usual, "can_ask": False, **how}
        about = (template, Package(package, ANSWERS), {}, given, "python_model", "kilted")
        self.run = Run(*about, **how)
        self.steps, self.model = Steps(copies), model.Model(ROOT / "python_model", ROOT)

    def check(self):
        self.steps.check(self.run, self.model, XML, "arm.ros_package", self.spec)

    def __call__(self):
        """Update; return what is said."""
        self.check()
        self.steps.begin(self.run)
        if not self.run.pretend:
            (self.package / "arm.py").write_text("what Copier has merged\n")
            (self.package / ANSWERS).write_text(yaml.safe_dump(dict(self.run.answers)))
        self.steps.finish(self.run, self.model, self.spec)
        return self.steps.report(self.run, self.model, self.spec).lines


def test_an_update_is_merged_and_said(package, template, copies):
    said = Life(package, template, copies, answers("load", "home"))()
    assert "serve_home" in (package / "arm.py").read_text()
    assert "merged    arm.py" in said
    assert "added     config/home.yaml" in said
    assert not (package / "config/store.yaml").exists()


def test_an_update_that_is_pretended_says_the_same(package, template, copies):
    before = read_folder(package)
    pretended = Life(package, template, copies, answers("load", "home"), pretend=True)()
    assert read_folder(package) == before
    assert pretended == Life(package, template, copies, answers("load", "home"))()


def test_an_update_is_refused_before_it_begins(package, template, copies):
    (package / "arm.py").write_text("MINE = 1\n")
    life = Life(package, template, copies, answers("load", "home"))
    with pytest.raises(SpecError, match=r"^arm\.py: changed since"):
        life.check()
    Life(package, template, copies, answers("load", "home"), pretend=True).check()
    assert not (package.parent / "none").exists()
    Life(package.parent / "none", template, None, answers("load")).check()


def test_copy_into_a_folder_of_other_files(tmp_path, template, copies):
    folder = tmp_path / "arm"
    folder.mkdir()
    (folder / "arm.py").write_text("MINE = 1\n")
    for how in ({"overwrite": True}, {"can_ask": True}):
        Life(folder, template, copies, answers("load"), **how).check()
    with pytest.raises(SpecError, match="would be replaced"):
        Life(folder, template, copies, answers("load")).check()


@pytest.mark.parametrize(
    ("why", "whose"), [("merge", "the other branch's"), ("other", "the model's"), ("", "")]
)
def test_copy_over_a_package_joins_it(package, template, copies, why, whose):
    """With the other branch, or with what another model makes."""
    source = "other" if why == "other" else "model"
    if why == "other":
        text = (
            (package / ANSWERS).read_text().replace("_src_path: model", f"_src_path: {template}")
        )
        (package / ANSWERS).write_text(text)
        commit(package)
    life = Life(package, template, copies, answers("load", "home", _src_path=source))
    if why == "merge":
        begin_merge(package)
    life.check()
    assert life.steps.theirs == whose
    life.steps.finish_join(life.run, life.model, life.spec)
    assert ("serve_home" in (package / "arm.py").read_text()) == bool(whose)


def test_joining_of_branches_is_refused_before_it_begins(package, template, copies):
    begin_merge(package)
    (package / "config/home.yaml").write_text("mine: 1\n")
    life = Life(package, template, copies, answers("load", "home"))
    with pytest.raises(SpecError, match=r"^config/home\.yaml: not in git"):
        life.check()


def begin_merge(package):
    git(package, "checkout", "-q", "-b", "topic")
    (package / "mine.py").write_text("MINE = 1\n")
    commit(package)
    git(package, "checkout", "-q", "-")
    git(package, "merge", "-q", "--no-ff", "--no-commit", "topic")
