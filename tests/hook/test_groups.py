"""What several components have in common, said once: kinds that take what an element holds."""

import pytest

from hooks.advice import elements
from hooks.changes import changes, check_names_before, left, marked
from hooks.faults import SpecError
from hooks.model import Model

DICTIONARY = """
package_attributes: [name]
robot_attributes:
  - name: {format: component_name, unique: true, example: arm}
  - rate: {format: number, optional: true}
robot_interface:
  take:
    takes: true
    attributes:
      - set: {refers_to: bundle, unique: true, example: common}
  topic: {attributes: [name: {format: ros_name, unique: true}, type: {format: message_type}]}
  cycle: {requires: rate, attributes: [name: {unique: true}]}
  state:
    attributes: [label: {unique: true}]
    interface: {arrow: [to: {refers_to: state}]}
  once: {once: true, attributes: [word]}
bundle_attributes:
  - title: {format: identifier, unique: true, example: common}
names:
  class: {robot: ["{class_name}"], bundle: ["{class_name}"]}
  member: {in: robot, topic: ["{name:identifier}"], cycle: ["{name}"]}
skeleton: [topic]
"""
SPEC = """<package name="pkg">
  <bundle title="common">
    <topic name="front" type="std_msgs/Int64"/>
    <state label="idle"><arrow to="idle"/></state>
  </bundle>
  <robot name="arm">
    <topic name="own" type="std_msgs/Int64"/>
    <take set="common"/>
    <topic name="last" type="std_msgs/Int64"/>
  </robot>
  <robot name="leg" rate="1"><take set="common"/></robot>
</package>"""


@pytest.fixture
def model(tmp_path):
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY)
    return Model(tmp_path, tmp_path)


def context(model, spec=SPEC):
    return model.context(spec.encode(), "spec.xml", "kilted")


def test_what_takes_a_group_has_what_it_holds(model):
    spec = context(model)
    arm, leg = spec["robots"]
    assert [topic["name"] for topic in arm["topics"]] == ["own", "front", "last"]
    assert [topic["name"] for topic in leg["topics"]] == ["front"]
    assert leg["states"][0]["arrows"] == [{"to": "idle"}]
    assert arm["takes"] == [{"set": "common"}]


def test_what_was_taken_says_from_where(model):
    spec = context(model)
    assert [topic.get("bundle") for topic in spec["robots"][0]["topics"]] == [
        None,
        "common",
        None,
    ]
    (group,) = spec["bundles"]
    assert (group["title"], group["class_name"], "tag" in group) == ("common", "Common", False)
    assert group["topics"] == [{"name": "front", "type": "std_msgs/msg/Int64"}]
    assert "takes" not in group


def test_what_is_taken_needs_its_packages_and_kinds(model):
    spec = context(model)
    assert spec["kinds"] == ["arrow", "state", "take", "topic"]
    assert {owner for _, owner, _, _ in elements(spec, model.dictionary)} == {"arm", "leg"}


def test_a_group_may_stand_after_what_takes_it(model):
    lines = SPEC.splitlines()
    other = "\n".join([lines[0], *lines[5:-1], *lines[1:5], lines[-1]])
    assert context(model, other) == context(model)


def test_a_group_that_nothing_takes_makes_nothing_and_is_noted(model):
    more = '<bundle title="spare"><cycle name="x"/></bundle></package>'
    spec = context(model, SPEC.replace("</package>", more))
    assert [group["title"] for group in spec["bundles"]] == ["common"]
    note = '<bundle title="spare"> is not taken by any <take>; nothing is made of it'
    assert spec["notes"] == [f"{note} [not-taken]"]


FAULTS = {
    "a fault of the group itself is said once, at its line": (
        ('"front" type="std_msgs/Int64"', '"front" type="Int64"'),
        'spec.xml:3: <topic name="front">: type: "Int64" is not a type; it lacks its package;',
    ),
    "a name that the component has, too": (
        ('name="last"', 'name="front"'),
        'spec.xml:9: <topic name="front">: name: "front" is already taken at line 3, used at'
        " line 8; each must have its own",
    ),
    "a name that the component has before it": (
        ('name="own"', 'name="front"'),
        'spec.xml:3: <topic name="front"> (used at line 8): name: "front" is already taken at'
        " line 7; each must have its own",
    ),
    "what the component lacks": (
        ('"front" type="std_msgs/Int64"/>', '"front" type="std_msgs/Int64"/><cycle name="own"/>'),
        'spec.xml:3: <cycle name="own"> (used at line 8): its <robot> at line 6 must have the'
        ' attribute "rate"',
    ),
    "a member that is made twice": (
        (
            'rate="1"><take set="common"/>',
            'rate="1"><take set="common"/><cycle name="front"/>',
        ),
        'spec.xml:11: <cycle name="front">: makes the member "front", as <topic name="front"> at'
        " line 3, used at line 11 does; rename one of them",
    ),
    "no such group": (
        ('set="common"/>\n', 'set="comon"/>\n'),
        'spec.xml:8: <take set="comon">: set: "comon" is no <bundle> of this <package>; did you'
        ' mean "common"?',
    ),
    "a group that is taken twice": (
        ('<take set="common"/></robot>', '<take set="common"/><take set="common"/></robot>'),
        'spec.xml:11: <take set="common">: set: "common" is already taken at line 11; each must'
        " have its own",
    ),
    "two groups with one name": (
        ("</package>", '<bundle title="common"/></package>'),
        'spec.xml:12: <bundle title="common">: title: "common" is already taken at line 2;',
    ),
    "a group with the class of a component": (
        ('title="common"', 'title="arm"'),
        'spec.xml:6: <robot name="arm">: makes the class "Arm", as <bundle title="arm"> at line 2',
    ),
    "a group in a group": (
        ("  </bundle>", '<take set="common"/></bundle>'),
        'spec.xml:5: <take set="common">: <take> is not known here; it belongs inside <robot>;',
    ),
    "what stands in a group once": (
        ('<topic name="front"', '<once word="a"/><once word="b"/><topic name="front"'),
        'spec.xml:3: <once word="b">: there is one at line 3; put all into one',
    ),
}


@pytest.mark.parametrize("case", FAULTS)
def test_faults_are_said_at_the_group_and_at_its_use(model, case):
    (right, wrong), message = FAULTS[case]
    spec = SPEC.replace(right, wrong)
    if "comon" in wrong or 'title="arm"' in wrong:
        spec = SPEC.replace(right, wrong, 1)
    assert spec != SPEC
    if 'title="arm"' in wrong:
        spec = spec.replace('set="common"', 'set="arm"')
    with pytest.raises(SpecError) as error:
        context(model, spec)
    lines = str(error.value).splitlines()
    assert lines[0].startswith(message) or message in lines
    assert len(set(lines)) == len(lines)
    if "said once" in case:
        assert len(lines) == 1


def test_only_groups_are_no_package(model):
    with pytest.raises(SpecError, match="has no <robot>; it needs one at least"):
        context(model, '<package name="pkg"><bundle title="common"/></package>')


WRONG = {
    "take: what a kind takes is named by refers_to of its first attribute": (
        "refers_to: bundle, ",
        "",
    ),
    "take: takes <robot>, which has an interface of its own; it needs robot_attributes alone": (
        "refers_to: bundle",
        "refers_to: robot",
    ),
    'topic: the context needs the key "bundle"; rename it': (
        "type: {format: message_type}]",
        "type: {format: message_type}, bundle: {optional: true}]",
    ),
    "arrow: only a kind of a component takes": (
        "{arrow: [to: {refers_to: state}]}",
        "{arrow: {takes: true, attributes: [to: {refers_to: bundle}]}}",
    ),
}


@pytest.mark.parametrize("message", WRONG)
def test_dictionaries_that_cannot_be(tmp_path, message):
    right, wrong = WRONG[message]
    assert right in DICTIONARY
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY.replace(right, wrong, 1))
    with pytest.raises(SpecError) as error:
        Model(tmp_path, tmp_path)
    assert str(error.value).rpartition(" [")[0].endswith(message)


def told(model, old, new):
    old, new = context(model, old), context(model, new)
    return list(changes(old, new, model.dictionary))


def test_changes_are_told_once(model):
    other = SPEC.replace('"front" type="std_msgs/Int64"', '"front" type="std_msgs/Bool"')
    assert told(model, SPEC, other) == [
        "~ topic front on common: type std_msgs/msg/Int64 -> std_msgs/msg/Bool"
    ]
    assert told(model, SPEC, SPEC.replace('rate="1"><take set="common"/>', 'rate="1">')) == [
        "- take common on leg"
    ]
    renamed = SPEC.replace('title="common"', 'title="shared" was="common"')
    renamed = renamed.replace('set="common"', 'set="shared"')
    assert told(model, SPEC, renamed) == ["> bundle shared, was common"]


def test_what_moves_into_a_group_stays(model):
    own = SPEC.replace(
        '    <take set="common"/>\n', '    <topic name="front" type="std_msgs/Int64"/>\n'
    )
    assert told(model, own, SPEC) == ["+ take common on arm"]
    old, new = context(model, own), context(model, SPEC)
    assert list(left(old, new, model.dictionary)) == []


def test_a_renamed_member_is_renamed_wherever_it_is_taken(model):
    renamed = SPEC.replace('name="front"', 'name="back" was="front"')
    old, new = context(model), context(model, renamed)
    assert told(model, SPEC, renamed) == ["> topic back on common, was front"]
    marks = marked(old, new, model.dictionary)[1]
    assert [(m.before, m.after) for m in marks if m.before != m.after] == [("front", "back")] * 3
    check(model, SPEC, renamed)


def check(model, old, new):
    places = model.places(new.encode(), "spec.xml")
    check_names_before(context(model, old), context(model, new), model.dictionary, places)


def test_a_group_that_is_renamed_is_so_where_it_is_taken(model):
    renamed = SPEC.replace('title="common"', 'title="shared" was="common"')
    renamed = renamed.replace('set="common"', 'set="shared"')
    check(model, SPEC, renamed)
    before, marks = marked(context(model), context(model, renamed), model.dictionary)
    (mark,) = [number for number, mark in enumerate(marks) if mark.before == "common"]
    name = f"zq{mark}x"
    (group,), arm = before["bundles"], before["robots"][0]
    assert (group["title"], group["class_name"]) == (name, f"Zq{mark}x")
    assert arm["takes"] == [{"set": name}]
    assert arm["topics"][1]["bundle"] == name


def test_a_name_before_counts_where_any_that_takes_it_had_it(model):
    """A component that takes the group newly has known no such name."""
    renamed = SPEC.replace('name="front"', 'name="back" was="front"')
    none = SPEC.replace('rate="1"><take set="common"/>', 'rate="1">')
    check(model, none, renamed)
    own = SPEC.replace(
        '    <take set="common"/>\n', '    <topic name="front" type="std_msgs/Int64"/>\n'
    )
    own = "\n".join(line for line in own.splitlines() if "leg" not in line)
    lines = own.splitlines()
    check(model, "\n".join([lines[0], *lines[5:]]), renamed)
    with pytest.raises(SpecError, match=r'spec.xml:3: <topic name="front">.*was="frnt"'):
        check(model, SPEC, SPEC.replace('name="front"', 'name="front" was="frnt"'))


def test_the_schema_and_the_skeleton_have_them(model):
    schema = model.schema()
    assert '<xs:element name="bundle"' in schema
    assert '<xs:element name="take"' in schema
    skeleton = model.skeleton({})
    assert "<!-- bundle: what stands in it is in each <robot> that has <take>" in skeleton
    assert '<!-- <bundle title="common"/> -->' in skeleton
    assert '<take set="common"/>' in skeleton
