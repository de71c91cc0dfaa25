"""Interface kinds with kinds inside of them: context, refusals, skeleton, summary of changes."""

import re

import pytest

from hooks.changes import changes, check_names_before, marked
from hooks.faults import SpecError
from hooks.model import Model

DICTIONARY = """
package_attributes: [name]
robot_attributes:
  - name: {format: identifier, unique: true}
robot_interface:
  arm:
    doc: an arm
    once: true
    attributes:
      - payload: {format: double, default: 1.0}
      - held: {format: bool, default: false}
    interface:
      joint:
        doc: a joint to move
        attributes:
          - label: {format: identifier, unique: true, example: joint}
          - limit: {format: double, optional: true, example: 2}
        interface:
          topic:
            requires: limit
            attributes:
              - name: {format: ros_name, unique: true, example: angle}
              - type: {format: message_type, example: "std_msgs::Float64"}
  base:
    once: true
    interface: {wheel: [label]}
names:
  motor: {in: [arm, base], ignore_case: true, joint: ["{label}"], wheel: ["{label}"]}
skeleton: [arm, joint]
"""


@pytest.fixture
def model(tmp_path):
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY)
    return Model(tmp_path, tmp_path)


def robot(inside, name="r"):
    return f'<robot name="{name}">\n{inside}\n</robot>'


def context(model, *robots):
    xml = '<package name="pkg">\n' + "\n".join(robots) + "\n</package>"
    return model.context(xml.encode(), "spec.xml", "kilted")


def refusal(model, *robots):
    with pytest.raises(SpecError) as error:
        context(model, *robots)
    return str(error.value)


TOPIC = '<topic name="{}" type="std_msgs::{}"/>'
ARM = (
    '<arm><joint label="elbow" limit="2">\n' + TOPIC.format("angle", "Float64") + "</joint></arm>"
)


def test_context(model):
    spec = context(model, robot(ARM), robot("<base/>", "s"))
    joint = {"label": "elbow", "limit": 2.0, "topics": [TOPIC_VALUES]}
    arm = {"payload": 1.0, "held": False, "joints": [joint]}
    first, second = spec["robots"]
    assert (first["arm"], first["base"]) == (arm, None)
    assert (second["arm"], second["base"]) == (None, {"wheels": []})
    assert spec["kinds"] == ["arm", "base", "joint", "topic"]


TOPIC_VALUES = {"name": "angle", "type": "std_msgs/msg/Float64"}


@pytest.mark.parametrize(
    ("inside", "message"),
    [
        ("<arm/>\n<arm/>", "spec.xml:4: <arm>: there is one at line 3"),
        ('<arm was="x"/>', 'spec.xml:3: <arm was="x">: unknown attribute "was"'),
        ('<base was="x"/>', 'spec.xml:3: <base was="x">: unknown attribute "was"'),
        ("<base>x</base>", "spec.xml:3: <base>: text is not allowed here"),
        (
            '<joint label="x"/>',
            'spec.xml:3: <joint label="x">: <joint> is not known here; it belongs inside <arm>',
        ),
        ("<arm><wheel/></arm>", "it belongs inside <base>"),
        (
            '<arm><joint label="x"/>\n<joint label="x"/></arm>',
            'spec.xml:4: <joint label="x">: label: "x" is already taken at line 3',
        ),
        (
            '<arm><joint label="x"/>\n<joint label="X"/></arm>',
            'makes the motor "X", as <joint label="x"> at line 3 does',
        ),
        ('<arm><joint label="x" limit="fast"/></arm>', "limit: "),
        (
            '<arm><joint label="x">' + TOPIC.format("y", "String") + "</joint></arm>",
            'its <joint> at line 3 must have the attribute "limit"',
        ),
    ],
)
def test_refusals(model, inside, message):
    assert message in refusal(model, robot(inside))


def test_the_same_name_in_two_places(model):
    """A name is unique inside of what holds it."""
    context(model, robot('<arm><joint label="x"/></arm><base><wheel label="x"/></base>'))
    context(
        model, robot('<arm><joint label="x"/></arm>'), robot('<arm><joint label="x"/></arm>', "s")
    )


def test_dependencies_and_notes(model):
    two = ARM.replace(
        "</joint>",
        '</joint><joint label="hand" limit="1">' + TOPIC.format("angle", "Bool") + "</joint>",
    )
    assert "topic /angle has more than one type" in context(model, robot(two))["notes"][0]


def test_skeleton(model):
    text = model.skeleton({})
    lines = [line.strip() for line in text.splitlines()]
    assert '<joint label="joint" limit="2">' in lines
    assert '<!-- <topic name="angle" type="std_msgs::Float64"/> -->' in lines
    model.context(text.encode(), "spec.xml", "kilted")
    opened = re.sub(r"<!-- (<.*?>) -->", r"\1", text, flags=re.DOTALL)
    assert len(model.context(opened.encode(), "spec.xml", "kilted")["robots"][0]["base"]["wheels"])


def test_changes(model):
    old = context(model, robot(ARM))
    renamed = ARM.replace('label="elbow"', 'label="knee" was="elbow"').replace("Float64", "Bool")
    new = context(model, robot(renamed.replace("</arm>", '<joint label="hand"/></arm><base/>')))
    assert list(changes(old, new, model.dictionary)) == [
        "> joint knee on r.arm, was elbow",
        "~ topic angle on r.arm.knee: type std_msgs/msg/Float64 -> std_msgs/msg/Bool",
        "+ joint hand on r.arm",
        "+ base on r",
    ]
    heavy = context(model, robot(ARM.replace("<arm>", '<arm payload="5">')))
    assert list(changes(old, heavy, model.dictionary)) == ["~ arm on r: payload 1 -> 5"]
    held = context(model, robot(ARM.replace("<arm>", '<arm held="yes">')))
    assert list(changes(old, held, model.dictionary)) == ["~ arm on r: held false -> true"]
    assert "- arm on r" in list(changes(new, context(model, robot("<base/>")), model.dictionary))
    marks = [(mark.before, mark.after) for mark in marked(old, new, model.dictionary)[1]]
    assert marks == [("r", "r"), ("elbow", "knee")]
    check_names_before(old, new, model.dictionary, {})


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "<arm/>",
            '<arm>\n<joint label="hand"/>\n<joint label="knee" was="elbow"/></arm>',
            'spec.xml:5: <joint label="knee">: was="elbow": the last update knew no such joint,'
            " or it has gone to another; remove was",
        ),
        (
            '<arm><joint label="elbow"/><joint label="hip"/></arm>',
            '<arm><joint label="hip"/><joint label="knee" was="elbwo"/></arm>',
            'spec.xml:3: <joint label="knee">: was="elbwo": the last update knew no such joint, or'
            ' it has gone to another; did you mean "elbow"? remove was, or name one that is'
            " renamed: elbow",
        ),
        (
            '<base><wheel label="left"/></base>',
            '<arm><joint label="knee"/></arm>\n<base>\n<wheel label="knee" was="right"/></base>',
            'spec.xml:5: <wheel label="knee">: was="right": the last update knew no such wheel, or'
            " it has gone to another; remove was, or name one that is renamed: left",
        ),
    ],
)
def test_was_that_names_nothing(model, old, new, said):
    old, xml = context(model, robot(old)), f'<package name="pkg">\n{robot(new)}\n</package>'
    places = model.places(xml.encode(), "spec.xml")
    with pytest.raises(SpecError) as error:
        check_names_before(old, context(model, robot(new)), model.dictionary, places)
    assert str(error.value) == f"{said} [unknown-was]"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{arm: {doc: an arm}}", "arm: has no attributes to tell one from another; it needs once"),
        (
            "{arm: {once: true, inside: {}}}",
            "doc, elsewhere, requires, once, least, most, takes, interface",
        ),
        ("{arm: {once: true, interface: [joint]}}", "must be a mapping of interface kinds"),
        ("{arm: {attributes: [joints], interface: {joint: [name]}}}", 'needs the key "joints"'),
        (
            "{arm: {attributes: [name], interface: {joint: {attributes: [name], requires: nam}}}}",
            'joint: requires "nam", which is no attribute of <arm>; did you mean "name"?',
        ),
    ],
)
def test_faults_of_a_dictionary(tmp_path, text, message):
    (tmp_path / "dictionary.yaml").write_text(f"node_interface: {text}\n")
    with pytest.raises(SpecError) as error:
        Model(tmp_path, tmp_path)
    assert message in str(error.value)


def test_own_types_of_a_model_with_nodes(tmp_path):
    """`declares` works for every model: a node may use a message of its own package."""
    (tmp_path / "dictionary.yaml").write_text("""
message_attributes: [name: {format: interface_name, declares: msg}]
message_interface: {field: [name: {format: field_name}, type: {format: field_type}]}
node_interface: {publisher: [name, type: {format: message_type}]}
""")
    functions = "def dependencies_from_interface(kind, values, ros_distro):\n"
    functions += '    return [values["type"].split("/")[0]] if "/" in values["type"] else []\n'
    (tmp_path / "functions.py").write_text(functions)
    model = Model(tmp_path, tmp_path)
    xml = """<package name="pkg"><message name="Pose"/>
<node name="n">
<publisher name="p" type="{}"/></node></package>"""
    spec = model.context(xml.format("pkg::Pose").encode(), "spec.xml", "kilted")
    assert spec["depends"] == []
    with pytest.raises(SpecError) as error:
        model.context(xml.format("pkg::Post").encode(), "spec.xml", "kilted")
    assert str(error.value) == (
        'spec.xml:3: <publisher name="p">: type: "Post" is not declared in this package;'
        ' did you mean "Pose"? allowed: Pose [undeclared-type]'
    )
