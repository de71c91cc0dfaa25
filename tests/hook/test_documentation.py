"""What the documentation says of the hook is so."""

import re
from dataclasses import fields

import pytest

from hooks import dictionary
from hooks.dictionary import Attribute
from hooks.faults import SpecError
from hooks.formats import FORMATS
from hooks.ros import DISTROS
from support.packages import model_of
from support.repository import ROOT

DESIGNERS = (ROOT / "docs/designers.md").read_text()
DEVELOPERS = (ROOT / "docs/developers.md").read_text()
README = (ROOT / "README.md").read_text()


def rows(page, heading):
    """Return the words in backticks of the first column of the table below a heading."""
    section = page.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    first = re.findall(r"^\| (`.*?) \|", section, re.MULTILINE)
    return [word for cell in first for word in re.findall(r"`([^`]+)`", cell)]


def test_options_of_an_attribute():
    options = {field.name for field in fields(Attribute)} - {"name"}
    assert sorted(rows(DESIGNERS, "dictionary.yaml")) == sorted(options)


def test_formats():
    listed = re.search(r"^Formats: (.*?)\. `hooks", DESIGNERS, re.DOTALL | re.MULTILINE)[1]
    assert set(re.findall(r"`(\w+)`", listed)) == {*FORMATS, "literal"}


def test_keys_of_a_dictionary():
    section = DESIGNERS.split("\n## dictionary.yaml\n")[1].split("\n## ")[0]
    for key in dictionary._KEYS:
        assert f"`{key}`" in section or f"\n{key}:" in section, key


def test_keys_of_the_context():
    told = rows(DESIGNERS, "What templates see")
    assert {f"spec.{key}" for key in dictionary.RESERVED_KEYS} <= {*told}
    assert "node.class_name" in told


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_interface_kinds(model):
    known = model_of(model).dictionary.components["node"].interfaces
    table = rows(README, "The spec")
    assert [word for word in table if word in known] == [word for word in table if word[0] != "<"]
    assert {*table} == {*known}
    needy = {kind for kind, interface in known.items() if interface.requires}
    told = re.search(r"it cannot have the kinds that\n`update` works with, (.*?);", README)[1]
    assert {*re.findall(r"`(\w+)`", told)} == needy


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_attributes_of_interfaces(model):
    known = model_of(model).dictionary.components["node"].interfaces
    qos = rows(DEVELOPERS, "QoS")
    section = README.split("\n## The spec\n")[1].split("\n## ")[0]
    for kind, told in re.findall(r"^\| `(\w+)` \| (.*?)\|", section, re.MULTILINE):
        words = [word.strip() for word in told.split(",") if word.strip()]
        told_names = {name for word in words for name in (qos if word == "QoS" else [word])}
        assert told_names == {*known[kind].attributes} - {"name", "description"}, kind


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_words_of_qos(model):
    topic = model_of(model).dictionary.components["node"].interfaces["publisher"]
    section = DEVELOPERS.split("\n## QoS\n")[1].split("\n## ")[0]
    for name in rows(DEVELOPERS, "QoS"):
        told = re.search(rf"^\| `{name}` \| (.*?) \|", section, re.MULTILINE)[1]
        assert re.findall(r"`(\w+)`", told) == list(topic.attributes[name].choices), name


def test_distributions():
    listed = re.search(r"chooses the ROS \((.*?)\)", README)[1]
    assert listed.split(", ") == list(DISTROS)


def test_message_for_a_fault():
    start, end = re.search(r"^```text\n(mypkg.*subscribr.*)…(.*)$", README, re.MULTILINE).groups()
    spec = """<package name="mypkg" author="Ada" author_email="ada@example.org"
  description="D" license="MIT"
>
  <node name="reach"
        frequency="10">
    <subscribr name="goal"/>
  </node>
</package>"""
    shown = f"^{re.escape(start)}allowed: publisher, .*{re.escape(end)}$"
    with pytest.raises(SpecError, match=shown):
        model_of("python_model").context(spec.encode(), "mypkg.ros_package", "kilted")


def test_files_that_an_update_of_the_starter_leaves_alone():
    kept = (ROOT / "starter_model/copier.yml").read_text().split("== 'update' %]")[1]
    names = [line.strip().strip("/") for line in kept.split("[% endif %]")[0].split()]
    assert "template" in names
    readme = (ROOT / "starter_model/README.md").read_text().replace("changelog", "CHANGELOG")
    for name in names:
        assert name.removesuffix(".md") in readme, name
