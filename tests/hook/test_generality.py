"""The hook and the extensions serve any model: they name no tag or attribute of ours."""

import ast
import re

import pytest
import yaml

from hooks import names
from hooks.dictionary import DEPEND, PACKAGE, WAS, Attribute, load, nested
from hooks.formats import FORMATS
from hooks.model import load_functions, public_functions
from support.repository import ROOT

MODELS = sorted(file.parent for file in ROOT.glob("*_model/dictionary.yaml"))
FILES = sorted([*ROOT.glob("hooks/**/*.py"), *ROOT.glob("extensions/*.py")])
BRIDGE = ROOT / "extensions/spec.py"
# The language in which dictionaries are written, and what every spec has.
# QoS is ROS's own, as the policies are that ROS 2 knows it by.
QOS = {"qos", "reliability", "durability", "history", "depth"}
QOS |= {"deadline", "lifespan", "liveliness", "liveliness_lease_duration"}
GENERAL = {*FORMATS, *QOS, *vars(Attribute)["__dataclass_fields__"], PACKAGE, DEPEND, WAS}
# Tags of interfaces that are words of Python and of ROS as well.
EVERYDAY = {"message", "service", "services", "action", "actions", "request", "response", "goal"}
EVERYDAY |= {"result", "feedback", "field", "fields", "constant", "constants", "messages"}
EVERYDAY |= {"input", "inputs", "folder", "folders", "group", "groups", "use", "uses"}
HOLDERS = {"passthrough"}  # and `config` and `data`, which are everyday words
QUESTION = {"type"}  # what a question of Copier has
# What syntax trees, YAML, C++ and ROS's own files consist of, which the merge reads.
SYNTAX = {"node", "nodes", "template", "type", "value", "holds", "group", "parameters"}
SYNTAX |= {"executable"}  # of a Node in a launch file in Python


def our_words():
    """Return what our models name: their folders, tags, interface kinds; and their attributes."""
    tags = {model.name for model in MODELS}
    attributes, holders = set(), set()
    for model in MODELS:
        dictionary = load(model / "dictionary.yaml", ROOT)
        holders |= {*dictionary.holders}
        attributes |= set(dictionary.package)
        for component in dictionary.components.values():
            tags |= {component.tag, component.key}
            attributes |= set(component.attributes)
            for interface in nested(component.interfaces):
                tags |= {interface.kind, interface.key}
                attributes |= set(interface.attributes)
    assert holders >= HOLDERS
    return (tags | HOLDERS) - GENERAL - EVERYDAY, attributes - GENERAL


def words_of(file):
    """Return the identifiers, the words of the texts, and the whole texts of some Python."""
    tree = ast.parse(file.read_text())
    prose = {
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }
    identifiers, texts = set(), set()
    for node in ast.walk(tree):
        identifiers |= {
            getattr(node, field)
            for field in ("id", "attr", "arg", "name")
            if isinstance(getattr(node, field, None), str)
        }
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in prose:
            texts.add(node.value)
    return identifiers, texts


@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(ROOT)))
def test_code_names_nothing_of_ours(file):
    tags, attributes = our_words()
    assert {"node", "nodes", "publisher", "python_model"} <= tags
    assert {"frequency", "author", "type"} <= attributes
    identifiers, texts = words_of(file)
    words = {word for text in identifiers | texts for word in re.findall(r"[a-zA-Z]+", text)}
    words |= identifiers | texts
    syntax = SYNTAX if "merge" in file.parts else set()
    syntax |= QUESTION if file.name == "questions.py" else set()
    assert sorted(words & tags - syntax) == []
    assert sorted(texts & attributes - syntax) == []


def test_one_file_knows_copier():
    """The one that Copier's next version changes (docs/copier.md)."""
    knowing = set()
    for file in FILES:
        tree = ast.parse(file.read_text())
        imported = [
            node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)
        ]
        names = {alias.name for node in imported for alias in node.names}
        names |= {str(getattr(node, "module", "")) for node in imported}
        if "copier" in {name.split(".")[0] for name in names} or words_of(file)[1] & {
            "_copier_conf",
            "_copier_answers",
        }:
            knowing.add(file)
    assert knowing == {BRIDGE}


def test_questions_name_nothing_of_ours():
    tags, attributes = our_words()
    text = yaml.safe_dump(yaml.safe_load((ROOT / "hooks/copier.yml").read_text()))
    words = set(re.findall(r"\w+", text))
    assert sorted(words & tags) == []
    assert sorted(set(re.findall(r"spec\.(\w+)", text)) & (attributes | {"name"})) == []


def test_page_tells_every_filter():
    page = (ROOT / "docs/designers.md").read_text()
    filters = public_functions(names)
    for file in ("python", "cpp", "qos", "text"):
        filters |= load_functions(ROOT / f"extensions/{file}.py")
    assert len(filters) > 20
    for name in filters:
        shown = name.removeprefix("is_")
        assert re.search(rf"`{shown}[`(]", page), name
