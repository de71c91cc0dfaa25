"""Mistakes in a dictionary: each is one line with the file, the line and what is allowed."""

import re

import pytest

from hooks.faults import SpecError
from hooks.model import Model
from support.repository import ROOT

STARTER = ROOT / "starter_model/template"
NAME = "- name: {doc: node name, format: component_name, unique: true, example: example_node}"
SUBSCRIBER = "  subscriber: {doc: a topic the node handles, attributes: *topic}"
SOURCES = {"folder": "pkg", "user": "Ada", "email": "ada@example.org", "year": "2026"}


def faults(folder, dictionary, functions=None):
    """Return what the model says of its starter spec."""
    (folder / "dictionary.yaml").write_text(dictionary)
    written = functions or (STARTER / "functions.py").read_text()
    (folder / "functions.py").write_text(written)
    with pytest.raises(SpecError) as error:  # noqa: PT012
        model = Model(folder, folder)
        model.context(model.skeleton(SOURCES).encode(), "skeleton spec", "kilted")
    return str(error.value).removeprefix(f"{folder}/")


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        # What YAML itself refuses, or would pass over.
        ("[publisher, timer]", "[publisher, timer", "not YAML: did not find expected ',' or ']'"),
        ("node_attributes:", "\tnode_attributes:", "not YAML: found character"),
        ("skeleton:", "skeleton: []\nskeleton:", '"skeleton" is there twice, first at line'),
        (SUBSCRIBER, f"{SUBSCRIBER}\n{SUBSCRIBER}", '"subscriber" is there twice'),
        (NAME, NAME.replace("doc:", "doc: x, doc:"), '"doc" is there twice'),
        (NAME, f"- name\n  {NAME}", 'node: attribute "name" is there twice, first at line 18'),
        ("- period:", "- 1:", '"1" as a key is no text; put it in quotes'),
        ("  subscriber:", "  on:", '"on" as a key is no text; put it in quotes'),
        # Names of nothing.
        (
            "[publisher, timer]",
            "[publisher, tmer]",
            'interface kind "tmer"; did you mean "timer"?',
        ),
        ("skeleton:", "aliases: {part: nod}\nskeleton:", 'tag "nod"; did you mean "node"?'),
        ("skeleton:", "aliases: {node: node}\nskeleton:", '"node" is a tag itself'),
        ("skeleton:", "include: shared/x.yaml\nskeleton:", "include: shared/x.yaml: no such file"),
        ("skeleton:", "include: dictionary.yaml\nskeleton:", "includes this file itself"),
        ("above: 0", "minimum: least", 'timer period: unknown attribute of <timer> "least"'),
        ("above: 0", "when: {nam: [a]}", 'attribute of <timer> "nam"; did you mean "name"?'),
        ("format: number, above: 0", "same_as: description", 'attribute above it "description"'),
        ("format: number, above: 0", "format: literal, of: nam", 'above it "nam"; did you mean'),
        ("format: number, above: 0", "format: literal", "a literal needs of: the attribute"),
        ("format: number", "format: numbr", 'format "numbr"; did you mean "number"?'),
        ("format: number", "declares: message", 'declares: unknown kind of type "message"'),
        (
            "work that is done again and again",
            "x\n    requires: nam",
            'requires "nam", which is no',
        ),
        # Values that are of another kind.
        ("[publisher, timer]", "publisher", "skeleton: 'publisher' must be a list of texts"),
        (NAME, "- name: text", "node name: 'text' must be a mapping"),
        (NAME, "- 3", "node: 3 must be a name or a mapping"),
        ("doc: node name", "doc: 3", "node name: doc: 3 must be a text"),
        ("doc: node name", "doc: [a]", "node name: doc: ['a'] must be a text"),
        ("unique: true", "unique: [1]", "unique: [1] must be true or false or a text"),
        ("above: 0", "above: small", "above: 'small' must be a number"),
        ("above: 0", "minimum: [1]", "minimum: [1] must be a number or a text"),
        ("above: 0", "optional: maybe", "optional: 'maybe' must be true or false"),
        ("above: 0", "reserved: fast", "reserved: 'fast' must be a list of texts"),
        ("above: 0", "when: [name]", "when: ['name'] must be a mapping to lists"),
        ("above: 0", "elsewhere: 3", "elsewhere: 3 must be a list, or a mapping"),
        (
            "format: number, above: 0",
            "choices: fast",
            "choices: 'fast' must be a list, or a mapping",
        ),
        ("format: number, above: 0", "choices: {a: b}", "must be a list, or a mapping to lists"),
        ("format: number, above: 0", "choices: [[a]]", "choices: [['a']] must be a list"),
        ("above: 0", "elsewhere: [{a: b}]", "elsewhere: [{'a': 'b'}] must be a list"),
        ("format: number, above: 0", "choices: []", "choices must be words"),
        ("format: number, above: 0", "choices: [on, off]", "choices must be words, in quotes"),
        ("format: number, above: 0", "pattern: 3", "pattern: 3 must be a text"),
        ("format: number, above: 0", "pattern: '['", "'[' is no regular expression"),
        ("format: number, above: 0", "pattern: a+", '"1" does not match the pattern a+'),
        ("format: number, above: 0", "choices: [a, b]", 'example: unknown choice "1"'),
        ("above: 0", "default: fast", 'default: "fast" is not a number'),
        ("example: 1.0", "example: fast", 'example: "fast" is not a number'),
        (
            "format: number, above: 0, example: 1.0",
            "format: bool, default: 'no'",
            "write false, wit",
        ),
        (
            "work that is done again and again",
            "x\n    once: maybe",
            "once: 'maybe' must be true or",
        ),
        ("- period:", "- per iod:", "timer: 'per iod' is no name"),
        ("  subscriber:", "  sub-scriber:", "'sub-scriber' is no name"),
        # Names that land in a package.
        ("skeleton:", "names: [x]\nskeleton:", "names: ['x'] must be a mapping"),
        ("skeleton:", "names: {x: {ros: 3}}\nskeleton:", "names: x: ros must be 1 or 2"),
        (
            "skeleton:",
            "names: {x: {node: [3]}}\nskeleton:",
            "x: node: [3] must be a list of texts",
        ),
        ("skeleton:", "names: {x: {reserved: ['(']}}\nskeleton:", "'(' is no regular expression"),
        (
            "skeleton:",
            "names: {x: {reserved: [a macro of C+]}}\nskeleton:",
            'unknown meaning of words "a macro of C+"; did you mean "a macro of C++"?',
        ),
        ("skeleton:", "names: {x: {node: ['{nam}']}}\nskeleton:", '"{nam}" has no meaning'),
        (
            "skeleton:",
            "names: {x: {node: ['{name:up}']}}\nskeleton:",
            '"{name:up}" has no meaning',
        ),
    ],
)
def test_mistake(tmp_path, right, wrong, message):
    text = (STARTER / "dictionary.yaml").read_text()
    assert right in text
    found = faults(tmp_path, text.replace(right, wrong, 1))
    assert re.match(r"dictionary\.yaml:\d+: ", found), found
    assert message in found
    assert "\n" not in found


def test_file_and_line_of_an_included_dictionary(tmp_path):
    (tmp_path / "shared.yaml").write_text("node_attributes:\n  - name\n  - rate: {formt: int}\n")
    (tmp_path / "dictionary.yaml").write_text("include: shared.yaml\nnode_interface: {}\n")
    with pytest.raises(SpecError, match=r'shared\.yaml:3: node rate: unknown key "formt"'):
        Model(tmp_path, tmp_path)


def test_dictionary_that_is_no_text(tmp_path):
    (tmp_path / "dictionary.yaml").write_bytes(b"# \xff\n")
    with pytest.raises(SpecError, match="not UTF-8 text"):
        Model(tmp_path, tmp_path)


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        (
            '["rclpy"]',
            '"rclpy"',
            "functions.py:4: dependencies_from_template for the package: must ",
        ),
        (
            '["rclpy"]',
            '["rcl py"]',
            'functions.py:4: dependencies_from_template for the package: "rcl',
        ),
        ("(ros_distro)", "()", "functions.py:4: dependencies_from_template('kilted'): TypeError"),
    ],
)
def test_mistake_in_a_function(tmp_path, right, wrong, message):
    functions = (STARTER / "functions.py").read_text().replace(right, wrong, 1)
    found = faults(tmp_path, (STARTER / "dictionary.yaml").read_text(), functions)
    assert found.startswith(message)
