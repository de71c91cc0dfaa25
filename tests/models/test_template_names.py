"""The tree of a template looks like the package it makes, in names that any system takes."""

import re

import copier
import pytest
from jinja2 import Template

from support.model_checks import Model
from support.packages import MODELS as BOTH
from support.packages import all_kinds
from support.repository import EXAMPLES, ROOT, commit, git
from support.ros import SYNCHRONIZER

FILES = git(ROOT, "ls-files", "-co", "--exclude-standard", "-z").split("\0")
TEMPLATES = sorted(name for name in FILES if re.match(r"\w+_model/template/", name))
PARTS = [name for name in FILES if re.search(r"\.jinja$|^shared/gitignore$", name)]
MODELS = sorted(file.parent for file in ROOT.glob("*_model/dictionary.yaml"))
LONGEST_PATH = 101
LONGEST_FILE = 300


@pytest.mark.parametrize("name", TEMPLATES)
def test_names_of_templates_are_plain(name):
    """Windows refuses some characters; a rule in a name is a rule nobody finds."""
    assert not re.search(r'[<>:"|?*\\\x00-\x1f]|\{%|[ .](/|$)', name)
    assert len(name) <= LONGEST_PATH


@pytest.mark.parametrize("name", PARTS)
def test_templates_are_short(name):
    """A part has a name by which a reader finds it."""
    assert len((ROOT / name).read_text().splitlines()) < LONGEST_FILE


def test_every_part_is_included():
    texts = "".join((ROOT / name).read_text() for name in PARTS)
    texts += (ROOT / "copier.yml").read_text()
    texts = "".join(texts.replace('" ~ spec.ros ~ "', ros) for ros in "12")
    included = set(
        re.findall(r"""(?:include|from|extends) (?:\[.*, )?["'](shared/[^"']+)["']""", texts)
    )
    parts = {name for name in PARTS if name.startswith("shared/")}
    assert included >= parts
    assert all((ROOT / name).exists() for name in included)


def helpers():
    """Return the files of the table, each with the interface kinds that it is for."""
    table = (ROOT / "shared/files.jinja").read_text()
    part = Template(re.search(r"\{% set helpers = .*?\} %\}", table, re.DOTALL)[0])
    ros1, ros2 = (part.make_module({"spec": {"ros": ros}}).helpers for ros in (1, 2))
    return {name: [*ros1[name], *ros2[name]] for name in ros1}


@pytest.mark.parametrize("name", helpers())
def test_table_of_files_is_true(name):
    """What it names is a template, and the kinds are those of a dictionary."""
    assert any(re.search(rf"/{name}\.[ch]?pp\.jinja$|/{name}\.py\.jinja$", f) for f in TEMPLATES)
    kinds = {
        kind
        for model in MODELS
        for component in Model(model).hook.dictionary.components.values()
        for kind in component.interfaces
    }
    assert set(helpers()[name]) <= kinds


TEMPLATE = {
    "copier.yml": """
spec:
  type: json
  default:
    nodes:
      - {tag: node, name: a, places: [{name: x}], topics: [{name: s/t}]}
      - {tag: node, name: b, places: []}
    places: [{name: y}]
words: {type: str, default: "see [node.name] or a[node.name]"}
_subdirectory: template
_envops: {undefined: jinja2.StrictUndefined}
_jinja_extensions:
  - copier_template_extensions.TemplateExtensionLoader
  - extensions/paths.py:PathsExtension
""",
    "template/[node.name]_one/{{ spec.places[0].name }}.[node.name].txt.jinja": (
        "[node.name] {{ node.name }}"
    ),
    "template/[place.name].jinja": "{{ place.name }}{% include 'part' %}",
    "template/in/[topic.name].txt.jinja": "{{ topic.name }} of {{ topic.node.name }}",
    "template/whole.txt.jinja": (
        "a[node.name]\n{% set node = {'name': 3} %}{{ 'abcd'[node.name] }} {{ words }}"
    ),
    "template/[plain]_[0].txt": "plain",
    "part": "[node.name]",
}


def test_names_for_each_component(tmp_path):
    """`[node.name]` makes a file of each node, in a folder of a node its own; contents stay."""
    source = tmp_path / "source"
    for name, text in TEMPLATE.items():
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        (source / name).write_text(text)
    (source / "extensions").mkdir()
    (source / "extensions/paths.py").write_text((ROOT / "extensions/paths.py").read_text())
    copier.run_copy(str(source), tmp_path / "out", defaults=True, unsafe=True, quiet=True)
    files = {
        str(file.relative_to(tmp_path / "out")): file.read_text()
        for file in (tmp_path / "out").rglob("*")
        if file.is_file()
    }
    assert files == {
        "a_one/y.a.txt": "[node.name] a",
        "b_one/y.b.txt": "[node.name] b",
        "y": "y[node.name]",
        "in/s/t.txt": "s/t of a",
        "whole.txt": "a[node.name]\nd see [node.name] or a[node.name]",
        "[plain]_[0].txt": "plain",
    }


def names(package):
    return set(git(package, "ls-files").splitlines())


@pytest.mark.parametrize("model", BOTH)
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_helper_files_come_and_go(render, update, model, distro):
    """With the interfaces that need them, in an update as in a new package."""
    full = all_kinds()
    package = render(full, model=model, ros_distro=distro)
    everything = names(package)
    few = re.sub(SYNCHRONIZER, "", full, flags=re.DOTALL)
    few = re.sub(r" *<(?!/|[?]|package|node|parameter|subscriber).*\n", "", few)
    file = package / "all_kinds.ros_package"
    for spec in (few, full):
        file.write_text(spec)
        commit(package)
        update(package)
        commit(package)
        assert names(package) == names(
            render(spec, model=model, ros_distro=distro, name=f"{len(spec)}/fresh")
        )
    assert names(package) == everything


def test_update_from_a_version_without_the_table(own_collection, render, update):
    """Copier renders the exclusions of the new version in the environment of the old one."""
    questions = own_collection / "copier.yml"
    tables = [own_collection / f"shared/{name}.jinja" for name in ("files", "ci/files")]
    texts = [file.read_text() for file in (questions, *tables)]
    for table in tables:
        table.unlink()
    questions.write_text(re.sub(r"\{% include.*?%\}", "none", texts[0]))
    commit(own_collection, tag="1.1.0")
    package = render(all_kinds(), template=own_collection)
    for file, text in zip((questions, *tables), texts, strict=True):
        file.write_text(text)
    commit(own_collection, tag="1.2.0")
    update(package)
    commit(package)
    assert names(package) == names(render(all_kinds(), template=own_collection, name="fresh/same"))


OWN = (
    r"(README|AGENTS)\.md|CMakeLists\.txt|package\.xml|setup\.(py|cfg)|mypy\.ini|ruff\.toml|resource/.*"
    r"|\.git.*|(config|launch)/.*|.*\.ros_package|.*_impl\.(py|[ch]pp)|.*\.test"
    r"|.*/(__init__\.py|py\.typed)|test/test_(flake8|pep257)\.py"
)
"""What people edit, or is too short to fold away."""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("model", ["python_model", "cpp_model", "mixed_model"])
def test_what_no_one_edits_is_folded_in_reviews(render, model, distro):
    spec = EXAMPLES / ("driving" if model == "mixed_model" else "all_kinds")
    package = render(spec.with_suffix(".ros_package"), model=model, ros_distro=distro)
    paths = sorted(names(package))
    marked = git(package, "check-attr", "--all", "--", *paths)
    for attribute in ("linguist-generated", "gitlab-generated"):
        folded = set(re.findall(rf"^(.*): {attribute}: set$", marked, re.MULTILINE))
        made = {
            p for p in paths if re.match("test/support/|.*/ros/", p) or not re.fullmatch(OWN, p)
        }
        assert folded == made
