"""Interfaces that contradict each other get a note, and never a refusal."""

import pytest

from hooks.model import Model
from support.model_checks import models
from support.packages import model_of
from support.repository import EXAMPLES, ROOT

SPEC = """<package name="robot" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="driver" frequency="10">{}</node>
  <node name="watch" frequency="10">{}</node>
</package>"""
FLOAT, BOOL, TRIGGER = "std_msgs::Float64", "std_msgs::Bool", "std_srvs::Trigger"


def notes(one, other, distro="lyrical", model="python_model"):
    spec = SPEC.format(*("".join(map(element, items)) for items in (one, other)))
    return model_of(model).context(spec.encode(), "spec", distro)["notes"]


def element(item):
    kind, name, type_ = item
    return f'<{kind} name="{name}" type="{type_}"/>'


@pytest.mark.parametrize("distro", ["noetic", "lyrical"])
@pytest.mark.parametrize(
    ("one", "other", "note"),
    [
        (
            ("publisher", "speed", FLOAT),
            ("subscriber", "speed", BOOL),
            "topic /speed has more than one type: std_msgs/msg/Float64 in node driver,"
            " std_msgs/msg/Bool in node watch; they cannot connect",
        ),
        (
            ("directPublisher", "/driver/speed", FLOAT),
            ("directSubscriber", "driver/speed", BOOL),
            "topic /driver/speed has more than one type",
        ),
        (
            ("publisher", "~/speed", FLOAT),
            ("subscriber", "/driver/speed", BOOL),
            "topic /driver/speed has more than one type",
        ),
        (
            ("serviceServer", "go", TRIGGER),
            ("serviceClient", "go", "std_srvs::SetBool"),
            "service /go has more than one type",
        ),
        (
            ("actionServer", "go", "test_msgs::Fibonacci"),
            ("actionClient", "go", "test_msgs::NestedMessage"),
            "action /go has more than one type",
        ),
        (
            ("publisher", "speed", FLOAT),
            ("subscriber", "sped", FLOAT),
            "topics /speed and /sped differ only by a letter; is one a slip?",
        ),
        (
            ("publisher", "arm/target", FLOAT),
            ("subscriber", "arm/taregt", FLOAT),
            "topics /arm/target and /arm/taregt differ only by a letter; is one a slip?",
        ),
        (
            ("serviceServer", "reset", TRIGGER),
            ("serviceClient", "Reset", TRIGGER),
            "services /reset and /Reset differ only by case; is one a slip?",
        ),
    ],
)
def test_contradiction_is_noted(one, other, note, distro):
    (found,) = notes([one], [other], distro)
    assert note in found


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (("publisher", "speed", FLOAT), ("subscriber", "/speed", FLOAT)),
        (("publisher", "~/speed", FLOAT), ("publisher", "~/speed", BOOL)),
        (("publisher", "speed", FLOAT), ("serviceServer", "speed", TRIGGER)),
        (("publisher", "arm_1/goal", FLOAT), ("subscriber", "arm_2/goal", FLOAT)),
        (("publisher", "pos_x", FLOAT), ("subscriber", "pos_y", FLOAT)),
        (("publisher", "pose", "geometry_msgs::Pose"), ("publisher", "poses", FLOAT)),
        (("publisher", "left", FLOAT), ("publisher", "right", FLOAT)),
        (("publisher", "arm", FLOAT), ("subscriber", "army", FLOAT)),
        (("publisher", "wheel_left", FLOAT), ("publisher", "wheels_left_x", FLOAT)),
    ],
)
def test_what_fits_is_not_noted(one, other):
    assert notes([one], [other]) == []


@pytest.mark.parametrize("file", sorted(EXAMPLES.rglob("*.ros_package")), ids=lambda f: f.stem)
def test_examples_get_no_advice(file):
    contexts = [
        model.context(file.read_text(), distro)
        for model in models()
        for distro in ("noetic", "lyrical")
    ]
    found = [note for context in contexts if context for note in context["notes"]]
    assert any(contexts)
    assert [note for note in found if "<depend>" not in note] == []


def test_own_words_of_a_model(tmp_path):
    """It is told from the formats of a dictionary, whatever its words."""
    (tmp_path / "dictionary.yaml").write_text(
        """
package_attributes: [title]
part_attributes: [label]
part_interface:
  port:
    - at: {format: ros_name}
    - carries: {format: message_type}
  colour: [hue]
"""
    )
    spec = """<package title="arm"><part label="one"><port at="x" carries="a/B"/><colour hue="1"/>
    </part><part label="two"><port at="/x" carries="a/C"/></part></package>"""
    (note,) = Model(tmp_path, ROOT).context(spec.encode(), "spec", "jazzy")["notes"]
    assert note.startswith("topic /x has more than one type: a/msg/B in part one, a/msg/C in")
