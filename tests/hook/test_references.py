"""Values that name another element of the spec, such as the `to` of an arrow between states."""

import pytest

from hooks.faults import SpecError
from hooks.model import Model

DICTIONARY = """
package_attributes:
  - name
  - main: {refers_to: node, optional: true}
node_attributes:
  - name: {format: component_name, unique: true, example: brain}
  - after: {refers_to: node, optional: true}
node_interface:
  state:
    attributes:
      - label: {format: identifier, unique: true, example: work}
    interface:
      arrow:
        attributes:
          - to: {doc: where it leads, refers_to: state, example: work}
      alarm: {attributes: [name, topic: {refers_to: topic}]}
  topic: [name, kind: {optional: true}]
  horn: [name, sound: {refers_to: topic, whose: {kind: [loud]}}]
skeleton: [state]
"""
SPEC = """<package name="pkg" main="brain">
  <node name="brain">
    <state label="idle"><arrow to="work"/></state>
    <state label="work"><arrow to="work"/><alarm name="x" topic="/sound"/></state>
    <topic name="/sound"/>
    <topic name="/horn" kind="loud"/>
    <horn name="h" sound="/horn"/>
  </node>
  <node name="arm" after="brain"><state label="rest"/></node>
</package>"""


@pytest.fixture
def model(tmp_path):
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY)
    return Model(tmp_path, tmp_path)


def test_values_that_name_an_element(model):
    spec = model.context(SPEC.encode(), "spec.xml", "kilted")
    assert [state["arrows"] for state in spec["nodes"][0]["states"]] == [[{"to": "work"}]] * 2
    assert (spec["main"], spec["nodes"][0]["after"], spec["nodes"][1]["after"]) == (
        "brain",
        None,
        "brain",
    )


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        (
            'idle"><arrow to="work"',
            'idle"><arrow to="wrk"',
            'spec.xml:3: <arrow to="wrk">: to: "wrk" is no <state> of this <node>;'
            ' did you mean "work"? allowed: idle, work',
        ),
        ('to="work"', 'to="rest"', 'to: "rest" is no <state> of this <node>; allowed: idle, work'),
        ('topic="/sound"', 'topic="/snd"', 'topic: "/snd" is no <topic> of this <node>; did you'),
        (
            '    <topic name="/sound"/>\n',
            "",
            '"/sound" is no <topic> of this <node>; allowed: /horn',
        ),
        (
            'sound="/horn"',
            'sound="/sound"',
            '"/sound" is no <topic> of this <node> whose kind is loud; a',
        ),
        ('main="brain"', 'main="pkg"', 'spec.xml:1: <package name="pkg">: main: "pkg" is no <no'),
        ('after="brain"', 'after="leg"', 'after: "leg" is no <node> of this <package>; allowed'),
    ],
)
def test_values_that_name_nothing(model, right, wrong, message):
    assert right in SPEC
    with pytest.raises(SpecError) as error:
        model.context(SPEC.replace(right, wrong, 1).encode(), "spec.xml", "kilted")
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        (
            "refers_to: state",
            "refers_to: stat",
            'arrow to: unknown tag to refer to "stat"; did you',
        ),
        ("refers_to: state", "refers_to: [state]", "refers_to: ['state'] must be a text"),
        (
            "refers_to: state",
            "refers_to: package",
            'arrow to: unknown tag to refer to "package"; allowed:',
        ),
        (
            "refers_to: state",
            "refers_to: state, whose: {lable: [a]}",
            'arrow to: unknown attribute of <state> "lable"; did you mean "label"?',
        ),
        (
            "refers_to: state",
            "refers_to: state, gives: {label: topic}",
            'arrow to: unknown format "topic"; did you mean',
        ),
    ],
)
def test_dictionary_that_names_no_tag(tmp_path, right, wrong, message):
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY.replace(right, wrong))
    with pytest.raises(SpecError) as error:
        Model(tmp_path, tmp_path)
    assert str(error.value).startswith("dictionary.yaml:15: arrow to: ")
    assert message in str(error.value)


GIVEN = """
package_attributes: [name]
node_attributes: [name]
node_interface:
  value:
    - name
    - type: {choices: [string, "string[]"]}
    - text: {format: literal, of: type, optional: true}
  topic: [name, from: {refers_to: value, gives: {text: topic_name}, optional: true}]
skeleton: [topic]
"""
NAMES = """<package name="pkg"><node name="a">
  <value name="x" type="string" text="/scan"/>
  <topic name="scan" from="x"/>
</node></package>"""
TOPIC = 'text, which is from of <topic name="scan">: '


@pytest.mark.parametrize(
    ("given", "distro", "message"),
    [
        ('"string" text="/scan"', "kilted", ""),
        ('"string" text="~/a/b_1"', "noetic", ""),
        ('"string" text="{node}/scan"', "kilted", ""),
        ('"string" text="{node}/scan"', "noetic", '"{node}/scan" is not the name of a topic'),
        ('"string" text="/camera/0"', "noetic", ""),
        ('"string" text="/camera/0"', "kilted", '"/camera/0" is not the name of a topic'),
        ('"string" text="a b"', "kilted", '"a b" is not the name of a topic; allowed: what'),
        ('"string" text=""', "noetic", '"" is not the name of a topic'),
        ('"string" text="a//b"', "kilted", '"a//b" is not the name of a topic'),
        ('"string"', "kilted", ""),
        ('"string[]" text="[a, b]"', "kilted", ""),
        ('"string[]" text="[a, \'b c\']"', "kilted", '"b c" is not the name of a topic'),
        ('"string[]" text="[a, a]"', "kilted", '"a" is there twice; drop one [already-taken]'),
    ],
)
def test_what_a_named_element_gives(tmp_path, given, distro, message):
    """A default that the node would refuse is refused where it is written."""
    (tmp_path / "dictionary.yaml").write_text(GIVEN)
    spec = NAMES.replace('"string" text="/scan"', given)
    try:
        Model(tmp_path, tmp_path).context(spec.encode(), "spec", distro)
        said = ""
    except SpecError as error:
        said = str(error)
    assert said.startswith(message and f'spec:2: <value name="x">: {TOPIC}{message}')
    assert bool(said) == bool(message)


def test_skeleton_and_schema_say_what_is_named(model):
    meant = "where it leads; the name of a state"
    assert meant in model.skeleton({})
    assert meant in model.schema()
