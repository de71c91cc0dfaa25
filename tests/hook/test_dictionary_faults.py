"""Mistakes in a dictionary: each is one line with the file, the line and what is allowed."""

import re

import pytest

from hooks.dictionary import load
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
        (
            "node_attributes:",
            "nod_attributes:",
            'nod_attributes: there is no node_attributes; did you mean "node_attributes", or '
            '"nod_interface" for "node_interface"? if neither, add it [missing-key]',
        ),
        (
            "node_interface:",
            "nod_interface:",
            'node_attributes: there is no nod_attributes; did you mean "nod_attributes", or '
            '"node_interface" for "nod_interface"? if neither, add it [missing-key]',
        ),
        (
            "package_attributes:",
            "pkg_attributes:",
            'pkg_attributes: there is no package_attributes; did you mean "package_attributes"? '
            "if not, add it [missing-key]",
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
        ("above: 0", "declares: message", 'declares: unknown kind of type "message"'),
        ("above: 0", "whose: {type: [a]}", "timer period: whose needs refers_to [missing-key]"),
        ("above: 0", "gives: {type: text}", "timer period: gives needs refers_to [missing-key]"),
        ("format: number, ", "", "timer period: above needs a format of numbers: number, int"),
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
        ("above: 0", "default: [1]", "default: [1] must be a text or a number or true or false"),
        ("example: 1.0", "example: {a: b}", "example: {'a': 'b'} must be a text or a number"),
        ("above: 0", "maximum: 5, default: 6", "period: default: 6.0 must be at most 5 [out-of"),
        ("example: 1.0", "example: 0", "period: example: 0.0 must be above 0 [out-of-range]"),
        ("format: number, above: 0", "reserved: ['1']", 'example: "1" is reserved; choose'),
        (NAME, f"{NAME}\n  - items: {{default: a}}", 'the context needs the key "items"; rename'),
        (NAME, f"{NAME}\n  - was: {{default: a}}", 'the context needs the key "was"; rename it'),
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
        (
            "skeleton:",
            "names: {x: {node: ['{nam}']}}\nskeleton:",
            '"{nam}" has no meaning: unknown attribute "nam"; did you mean "name"? allowed: ',
        ),
        (
            "skeleton:",
            "names: {x: {publisher: ['{node[nam]}']}}\nskeleton:",
            '"{node[nam]}" has no meaning: unknown attribute "nam"; did you mean "name"? '
            "allowed: tag, name, class_name [form-without-meaning]",
        ),
        (
            "skeleton:",
            "names: {x: {node: ['{name[up]}']}}\nskeleton:",
            '"{name[up]}" has no meaning: string indices must be integers',
        ),
        (
            "skeleton:",
            "names: {x: {node: ['{name']}}\nskeleton:",
            '"{name" has no meaning: expected ',
        ),
        (
            "skeleton:",
            "names: {x: {node: ['{name:up}']}}\nskeleton:",
            '"{name:up}" has no meaning: unknown filter "up"; allowed: identifier, ',
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


def test_tags_with_one_half_that_are_nothing_alike(tmp_path):
    """One says more of the package, the other has a name alone."""
    dictionary = "licence_attributes: [text]\nmotor_interface: {topic: [name]}\n"
    for more in ("", "note_attributes: [text]\nnode_attributes: [name]\nnode_interface: {}\n"):
        (tmp_path / "dictionary.yaml").write_text(dictionary + more)
        assert {"licence", "motor"} <= {*Model(tmp_path, tmp_path).dictionary.components}


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
        (
            "def ",
            "import sys\nsys.exit('bye')\ndef ",
            "functions.py:5: SystemExit: bye [function-f",
        ),
        (
            'return ["rclpy"]',
            "raise SystemExit",
            "functions.py:6: dependencies_from_template('kilted'): SystemExit (called",
        ),
    ],
)
def test_mistake_in_a_function(tmp_path, right, wrong, message):
    functions = (STARTER / "functions.py").read_text().replace(right, wrong, 1)
    found = faults(tmp_path, (STARTER / "dictionary.yaml").read_text(), functions)
    assert found.startswith(message)
    assert found.endswith(" [function-fails]")


def test_long_arguments_of_a_function_are_shortened(tmp_path):
    (tmp_path / "functions.py").write_text("def half(text): return text / 2\n")
    (tmp_path / "dictionary.yaml").write_text("node_attributes: [name]\n")
    half = Model(tmp_path, tmp_path).functions["half"]
    with pytest.raises(SpecError, match=rf"half\('{'x' * 39}\.\.\.\): TypeError: "):
        half("x" * 100)


@pytest.mark.parametrize(
    ("dictionary", "says"),
    [
        ("- a\n", " must be a mapping with package_attributes and <tag>_interface [wrong-shape]"),
        ("", " must be a mapping with package_attributes and <tag>_interface [wrong-shape]"),
        ("include: x.yaml\n", "1: include: x.yaml: no such file; a model needs it [no-such-file]"),
        (
            "a_attributes: [name]\ninclude:\n- dictionary.yaml\n",
            "3: include: dictionary.yaml includes this file itself; drop one [circular-include]",
        ),
        (
            "a_atributes: []\n",
            '1: unknown key "a_atributes"; did you mean "package_attributes"? allowed: '
            "<component>_attributes, <component>_interface, aliases, definitions, holders, "
            "include, names, optional, package_attributes, skeleton [unknown-key]",
        ),
        ("a_attributes: x\n", "1: a: the attributes must be a list [wrong-shape]"),
        ("a_attributes:\n- [x]\n", "1: a: ['x'] must be a name or a mapping [wrong-shape]"),
        (
            "a_attributes:\n- 3x\n",
            "2: a: '3x' is no name; allowed: letters, digits and underscores, a letter "
            "first [invalid-name]",
        ),
        (
            "a_attributes:\n- name\n- name\n",
            '3: a: attribute "name" is there twice, first at line 2; keep one [key-twice]',
        ),
        (
            "a_attributes:\n- name: text\n",
            "2: a name: 'text' must be a mapping of what it is [wrong-shape]",
        ),
        (
            "a_attributes:\n- name: {choices: []}\n",
            "2: a name: choices must be words, in quotes where YAML reads something else, "
            'such as "on" [wrong-shape]',
        ),
        (
            "a_attributes:\n- name: {choices: [[x]]}\n",
            "2: a name: choices: [['x']] must be a list [wrong-shape]",
        ),
        (
            "a_attributes:\n- name: {elsewhere: x}\n",
            "2: a name: elsewhere: 'x' must be a list, or a mapping [wrong-shape]",
        ),
        (
            "a_attributes:\n- name: {format: literal}\n",
            "2: a name: a literal needs of: the attribute that names its type [missing-key]",
        ),
        (
            "a_attributes:\n- name: {declares: x}\n",
            '2: a name: declares: unknown kind of type "x"; allowed: msg, srv, action '
            "[unknown-word]",
        ),
        (
            "a_attributes:\n- name: {pattern: '('}\n",
            "2: a name: pattern: '(' is no regular expression: missing ), unterminated "
            "subpattern at position 0 [not-a-pattern]",
        ),
        (
            "a_attributes:\n- name: {pattern: a+, default: b}\n",
            '2: a name: default: "b" does not match the pattern a+ [pattern-mismatch]',
        ),
        (
            "a_attributes:\n- name: {format: bool, default: 'true'}\n",
            "2: a name: default: write true, without quotes [wrong-shape]",
        ),
        (
            "a_attributes:\n- name: {format: int, example: x}\n",
            '2: a name: example: "x" is not an int; allowed: a whole number, such as -3 or '
            "0xff [invalid-value]",
        ),
        (
            "a_attributes:\n- name: {choices: [x], default: y}\n",
            '2: a name: default: unknown choice "y"; allowed: x [unknown-word]',
        ),
        (
            "a_attributes:\n- name: {same_as: other}\n- other\n",
            '2: a name: same_as: unknown attribute above it "other"; none is allowed '
            "[unknown-word]",
        ),
        (
            "a_attributes:\n- name: {among: name}\n",
            '2: a name: among: unknown attribute above it "name"; none is allowed [unknown-word]',
        ),
        (
            "a_attributes:\n- name: {format: literal, of: x}\n",
            '2: a name: of: unknown attribute above it "x"; none is allowed [unknown-word]',
        ),
        (
            "a_attributes:\n- name: {format: int, maximum: mst}\n- most\n",
            '2: a name: unknown attribute of <a> "mst"; did you mean "most"? allowed: '
            "name, most [unknown-word]",
        ),
        (
            "a_attributes:\n- name: {when: {other: [y]}}\n- other: {choices: [x]}\n",
            '2: a name: when: unknown word of "other" "y"; allowed: x [unknown-word]',
        ),
        (
            "a_attributes:\n- name: {when: {x: [y]}}\n",
            '2: a name: unknown attribute of <a> "x"; allowed: name [unknown-word]',
        ),
        (
            "a_attributes:\n- name: {refers_to: x}\na_interface: {b: [name]}\n",
            '2: a name: unknown tag to refer to "x"; allowed: a, b [unknown-word]',
        ),
        (
            "a_attributes:\n- name: {}\n- other: {refers_to: x}\n",
            '3: a other: unknown tag to refer to "x"; allowed: a [unknown-word]',
        ),
        (
            "package_attributes:\n- name: {refers_to: b}\na_interface: {b: {once: true}}\n",
            '2: package name: unknown tag to refer to "b"; allowed: a [unknown-word]',
        ),
        (
            "a_interface: x\n",
            "1: a_interface: 'x' must be a mapping of interface kinds [wrong-shape]",
        ),
        (
            "a_interface:\n  b: 3\n",
            "2: b: must be a list of attributes, or a mapping of attributes, doc, "
            "elsewhere, requires, once, least, most, takes, interface [wrong-shape]",
        ),
        (
            "a_interface:\n  b: {attribute: []}\n",
            "2: b: must be a list of attributes, or a mapping of attributes, doc, "
            "elsewhere, requires, once, least, most, takes, interface [wrong-shape]",
        ),
        (
            "a_interface:\n  b c: []\n",
            "2: interface kinds: 'b c' is no name; allowed: letters, digits and "
            "underscores, a letter first [invalid-name]",
        ),
        (
            "a_interface:\n  b: []\n",
            "2: b: has no attributes to tell one from another; it needs once [missing-key]",
        ),
        (
            "a_interface:\n  b: {attributes: [x], most: x}\n",
            "2: b: most: 'x' must be a whole number [wrong-shape]",
        ),
        (
            "a_interface:\n  b: {attributes: [x], requires: y}\na_attributes: [name, z]\n",
            '2: b: requires "y", which is no attribute of <a>; allowed: name, z [unknown-word]',
        ),
        (
            "a_interface:\n  b: {attributes: [x], doc: 3}\n",
            "2: b: doc: 3 must be a text [wrong-shape]",
        ),
        (
            "a_interface:\n  b:\n    attributes: [cs]\n    interface: {c: [x]}\n",
            '2: b: the context needs the key "cs"; rename it [reserved-name]',
        ),
        (
            "a_interface:\n  b: {attributes: [x], interface: {c: []}}\n",
            "2: c: has no attributes to tell one from another; it needs once [missing-key]",
        ),
        (
            "a_attributes: [class_name]\na_interface: {}\n",
            '1: a: the context needs the key "class_name"; rename it [reserved-name]',
        ),
        (
            "names:\n  x: {reserved: y}\n",
            "2: names: x: must be a mapping with lists of names, or in and a tag [wrong-shape]",
        ),
        (
            "a_interface: {b: [name]}\na_attributes: [name, bs]\n",
            '1: a: the context needs the key "bs"; rename it [reserved-name]',
        ),
        (
            "a_attributes: [name, bs]\na_interface: {b: [name]}\n",
            '1: a: the context needs the key "bs"; rename it [reserved-name]',
        ),
        (
            "package_attributes: [ros]\n",
            '1: package: the context needs the key "ros"; rename it [reserved-name]',
        ),
        (
            "package_attributes: [name, as]\na_attributes: [name]\n",
            '1: package: the context needs the key "as"; rename it [reserved-name]',
        ),
        ("skeleton: x\n", "1: skeleton: 'x' must be a list of texts [wrong-shape]"),
        (
            "skeleton: [b]\na_interface: {c: [name]}\nd_interface: {c: [name], e: [name]}\n",
            '1: skeleton: unknown interface kind "b"; allowed: c, e [unknown-word]',
        ),
        ("holders: x\n", "1: holders: 'x' must be a list of texts [wrong-shape]"),
        ("aliases: x\n", "1: aliases: 'x' must be a mapping of texts [wrong-shape]"),
        (
            "aliases: {x: y}\na_attributes: [name]\n",
            '1: aliases: x: unknown component tag "y"; allowed: a, depend [unknown-word]',
        ),
        (
            "aliases: {a: depend}\na_attributes: [name]\n",
            '1: aliases: "a" is a tag itself; choose another [reserved-name]',
        ),
        (
            "aliases: {depend: a}\na_attributes: [name]\n",
            '1: aliases: "depend" is a tag itself; choose another [reserved-name]',
        ),
        ("names: x\n", "1: names: 'x' must be a mapping [wrong-shape]"),
        (
            "names:\n  x: y\n",
            "2: names: x: must be a mapping with lists of names, or in and a tag [wrong-shape]",
        ),
        (
            "names:\n  x: {a: y}\na_attributes: [name]\n",
            "2: names: x: must be a mapping with lists of names, or in and a tag [wrong-shape]",
        ),
        (
            "names:\n  x: {b: [y]}\na_attributes: [name]\n",
            '2: names: x: unknown key "b"; allowed: a, package [unknown-key]',
        ),
        (
            "names:\n  x: {in: b}\na_attributes: [name]\n",
            '2: names: x: unknown key "b"; allowed: a, package [unknown-key]',
        ),
        (
            "names:\n  x: {in: [3]}\na_attributes: [name]\n",
            "2: names: x: in: [3] must be a list of texts [wrong-shape]",
        ),
        (
            "names:\n  x: {a: [3]}\na_attributes: [name]\n",
            "2: names: x: a: [3] must be a list of texts [wrong-shape]",
        ),
        (
            "names:\n  x: {ros: 3}\n",
            "2: names: x: ros must be 1 or 2, ignore_case true or false [wrong-shape]",
        ),
        (
            "names:\n  x: {ignore_case: 3}\n",
            "2: names: x: ros must be 1 or 2, ignore_case true or false [wrong-shape]",
        ),
        ("names:\n  x: {parts: 3}\n", "2: names: x: parts: 3 must be a text [wrong-shape]"),
        ("names:\n  x: {because: 3}\n", "2: names: x: because: 3 must be a text [wrong-shape]"),
        (
            "names:\n  x: {reserved: ['(']}\n",
            "2: names: x: '(' is no regular expression: missing ), unterminated subpattern "
            "at position 0 [not-a-pattern]",
        ),
        (
            "names:\n  x: {reserved: [3]}\n",
            "2: names: x: reserved: [3] must be a list of texts [wrong-shape]",
        ),
        (
            "a_interface:\n  b: {takes: true, attributes: [x]}\n",
            "2: b: what a kind takes is named by refers_to of its first attribute [wrong-takes]",
        ),
        (
            "a_interface:\n"
            "  b: {takes: true, attributes: [x: {refers_to: c}]}\n"
            "c_interface: {d: [x]}\n",
            "2: b: takes <c>, which has an interface of its own; it needs c_attributes "
            "alone [wrong-takes]",
        ),
        (
            "a_interface:\n"
            "  b:\n"
            "    attributes: [x]\n"
            "    interface: {c: {takes: true, attributes: [x: {refers_to: d}]}}\n"
            "d_attributes: [name]\n",
            "4: c: only a kind of a component takes [wrong-takes]",
        ),
        (
            "a_interface:\n"
            "  b: {takes: true, attributes: [x: {refers_to: d}]}\n"
            "  e: [x, d]\n"
            "d_attributes: [name]\n",
            '3: e: the context needs the key "d"; rename it [reserved-name]',
        ),
    ],
)
def test_whole_message(tmp_path, dictionary, says):
    """With its line and its id; no more of the dictionary than it takes."""
    file = tmp_path / "dictionary.yaml"
    file.write_text(dictionary)
    with pytest.raises(SpecError) as error:
        load(file, tmp_path)
    assert str(error.value) == f"dictionary.yaml:{says}"


def test_what_names_may_say(tmp_path):
    file = tmp_path / "dictionary.yaml"
    says = 'a: ["{name}"], in: package, ignore_case: true, ros: 1, parts: "/", reserved: ["{x}+"]'
    file.write_text(f"a_attributes: [name]\nnames: {{files: {{{says}}}}}\n")
    (scope,) = load(file, tmp_path).scopes
    assert (scope.made_by, scope.owners, scope.reserved) == (
        {"a": ["{name}"]},
        ["package"],
        ["{x}+"],
    )
    assert (scope.ignore_case, scope.ros, scope.parts) == (True, 1, "/")
    assert scope.said_at == "dictionary.yaml:2"
