"""What is said of a wrong spec, letter by letter, by a dictionary that has each rule once."""

import pytest

from hooks.faults import SpecError
from hooks.model import Model

DICTIONARY = """\
package_attributes:
  - name: {format: package_name}
  - template: {ignored: true}
  - mail: {format: email, optional: true}
aliases: {limb: arm}
arm_attributes:
  - name: {doc: its name, format: component_name, unique: true}
  - rate: {doc: how often, format: number, minimum: 1, maximum: 10, optional: true}
  - mode:
      choices: {slow: [s], fast: [], best_available: []}
      elsewhere: {speed: , hurry: mode="fast"}
      default: slow
  - gear: {format: int, above: 0, when: {mode: [fast]}, default: 3}
  - moves: {format: bool, default: false}
  - low: {format: int, optional: true}
  - high: {format: int, minimum: low, optional: true}
  - note: {format: text, pattern: "[a-z ]*", reserved: [none], optional: true}
arm_interface:
  joint:
    attributes:
      - name: {format: identifier, unique: true}
      - side: {choices: [left, right], elsewhere: [hand]}
    elsewhere: [hinge]
    most: 2
    interface:
      bolt: {attributes: [name, {size: {format: int}}]}
  tool: {once: true, attributes: [kind]}
  servo: {attributes: [name], requires: [rate, moves]}
  directServo: [name]
  dynText: {attributes: [name], requires: [moves]}
  text: [name, {words: {format: raw}}]
  value:
    attributes:
      - name
      - type: {choices: [int, string]}
      - list: {format: literal, of: type, several: true, optional: true}
      - value: {format: literal, of: type, among: list, maximum: 9}
  sees: {attributes: [name, {type: {format: field_type}}]}
  use: {takes: true, attributes: [name: {refers_to: group}]}
  link: {attributes: [name, {to: {refers_to: joint, whose: {side: [left]}}}]}
pair_attributes: [name]
pair_interface: {half: {attributes: [name], least: 2, interface: {bolt: [name]}}}
group_attributes: [name]
folder_attributes: [name]
message_attributes: [name: {format: interface_name, declares: msg}]
message_interface:
  field: {attributes: [name, {type: {format: field_type}}]}
"""


@pytest.fixture(scope="module")
def values(tmp_path_factory):
    folder = tmp_path_factory.mktemp("model")
    (folder / "dictionary.yaml").write_text(DICTIONARY)
    model = Model(folder, folder)
    return lambda spec: model.context(spec.encode(), "spec", "humble")


@pytest.fixture
def said(values):
    def run(spec):
        with pytest.raises(SpecError) as error:
            values(spec)
        return str(error.value).replace("spec:", "")

    return run


@pytest.mark.parametrize(
    ("spec", "says"),
    [
        ("<arm/>", "1: <arm>: a spec starts with <package>, not <arm> [wrong-root]"),
        (
            "<package><name>p</name></package>",
            '1: <package>: a spec has attributes, as <package name="...">, not elements as a '
            "package.xml of ROS [wrong-root]",
        ),
        (
            "<package name='pp'/>",
            '1: <package name="pp">: has no <arm> or <pair> or <message>; it needs one at '
            "least [missing-tag]",
        ),
        (
            "<package name='pp' mail='x'><arm name='a'/></package>",
            '1: <package name="pp">: mail: "x" is not a mail address; allowed: '
            "name@host.domain [invalid-value]",
        ),
        (
            "<package mail='x@y.de'><arm name='a'/></package>",
            '1: <package mail="x@y.de">: attribute "name" is missing [missing-attribute]',
        ),
    ],
)
def test_fault_of_a_package(said, spec, says):
    assert said(spec) == says


@pytest.mark.parametrize(
    ("inside", "says"),
    [
        (
            "<leg/>",
            "2: <leg>: <leg> is not known here; allowed: arm, pair, group, folder, message, "
            "depend [unknown-tag]",
        ),
        (
            "<amr/>",
            '2: <amr>: <amr> is not known here; did you mean "arm"? allowed: arm, pair, '
            "group, folder, message, depend [unknown-tag]",
        ),
        (
            "<arm name='a'/><depend x='y'>z</depend>",
            '2: <depend x="y">: takes a package name: <depend>std_msgs</depend>, with '
            'kind="exec" and the like [wrong-depend]',
        ),
        (
            "<arm name='a'/><depend><x/></depend>",
            '2: <depend>: takes a package name: <depend>std_msgs</depend>, with kind="exec" '
            "and the like [wrong-depend]",
        ),
        (
            "<arm name='a'/>\n<depend kind='exe'>z</depend>",
            '3: <depend kind="exe">: kind: unknown "exe"; did you mean "exec"? allowed: '
            "build, build_export, buildtool, buildtool_export, doc, exec, group, test "
            "[unknown-choice]",
        ),
        (
            "<arm name='a'/><depend kind=''>z</depend>",
            '2: <depend kind="">: kind: unknown ""; allowed: build, build_export, buildtool, '
            "buildtool_export, doc, exec, group, test [unknown-choice]",
        ),
        (
            "<arm name='a'/><depend>z z</depend>",
            '2: <depend>: "z z" is not a package name; allowed: one name of letters, digits '
            'and "_", a letter first [invalid-name]',
        ),
        (
            "<arm name='a'/>\n<exec_depend>z</exec_depend>",
            "3: <exec_depend>: <exec_depend> is not known here; did you mean <depend "
            'kind="exec">? [unknown-tag]',
        ),
        (
            "<arm name='a'/>\n<joint name='x'/>",
            '3: <joint name="x">: <joint> is not known here; it belongs inside <arm> or '
            "<group>; allowed: arm, pair, group, folder, message, depend [unknown-tag]",
        ),
        (
            "<arm name='a'/>\n<mail>x</mail>",
            '3: <mail>: <mail> is not known here; did you mean mail="..."? [unknown-tag]',
        ),
        (
            "<arm name='a'/><folder name='f'>\n<x/></folder>",
            "3: <x>: <x> is not known here; none is allowed [unknown-tag]",
        ),
        (
            "<arm name='a' rate='0'/>",
            '2: <arm name="a">: rate: 0.0 must be at least 1 [out-of-range]',
        ),
        (
            "<arm name='a' rate='11'/>",
            '2: <arm name="a">: rate: 11.0 must be at most 10 [out-of-range]',
        ),
        (
            "<arm name='a' rate='x'/>",
            '2: <arm name="a">: rate: "x" is not a number; allowed: a finite number without '
            "a unit, such as 12.5 [invalid-value]",
        ),
        (
            "<arm name='a' mode='fats'/>",
            '2: <arm name="a">: mode: unknown "fats"; did you mean "fast"? allowed: slow, '
            "fast, best_available [unknown-choice]",
        ),
        (
            "<arm name='a' mode='S'/>",
            '2: <arm name="a">: mode: unknown "S"; did you mean "slow"? allowed: slow, fast, '
            "best_available [unknown-choice]",
        ),
        (
            "<arm name='a' gear='1'/>",
            '2: <arm name="a">: attribute "gear" has no meaning where mode is "slow"; drop '
            "it [attribute-without-meaning]",
        ),
        (
            "<arm name='a' mode='fast' gear='0'/>",
            '2: <arm name="a">: gear: 0 must be above 0 [out-of-range]',
        ),
        (
            "<arm name='a' low='3' high='2'/>",
            '2: <arm name="a">: high: 2 must be at least 3 [out-of-range]',
        ),
        (
            "<arm name='a' note='A'/>",
            '2: <arm name="a">: note: "A" does not match the pattern [a-z ]* [pattern-mismatch]',
        ),
        (
            "<arm name='a' note='none'/>",
            '2: <arm name="a">: note: "none" is reserved; choose another [reserved-name]',
        ),
        (
            "<arm name='a' speed='1'/>",
            '2: <arm name="a">: unknown attribute "speed"; did you mean mode="..."? '
            "[unknown-attribute]",
        ),
        (
            "<arm name='a' hurry='1'/>",
            '2: <arm name="a">: unknown attribute "hurry"; did you mean mode="fast"? '
            "[unknown-attribute]",
        ),
        (
            "<arm name='a' fast='true'/>",
            '2: <arm name="a">: unknown attribute "fast"; did you mean mode="fast"? '
            "[unknown-attribute]",
        ),
        (
            "<arm name='a' side='left'/>",
            '2: <arm name="a">: unknown attribute "side"; it belongs to <joint>; allowed: '
            "name, rate, mode, gear, moves, low, high, note, was [unknown-attribute]",
        ),
        (
            "<arm name='a' size='1'/>",
            '2: <arm name="a">: unknown attribute "size"; it belongs to <bolt>; allowed: '
            "name, rate, mode, gear, moves, low, high, note, was [unknown-attribute]",
        ),
        (
            "<arm name='a' joint='x'/>",
            '2: <arm name="a">: unknown attribute "joint"; it is an element: <joint> inside '
            "<arm> or <group> [unknown-attribute]",
        ),
        (
            "<arm name='a' nme='b'/>",
            '2: <arm name="a">: unknown attribute "nme"; did you mean "name"? allowed: name, '
            "rate, mode, gear, moves, low, high, note, was [unknown-attribute]",
        ),
        (
            "<arm name='a' mode='best_available'/>",
            '2: <arm name="a">: mode: Humble has no "best_available"; ROS 2 has it since '
            "Iron [not-in-distro]",
        ),
        (
            "<arm name='a' mode='3'/>",
            '2: <arm name="a">: mode: unknown "3"; did you mean gear="3"? [unknown-choice]',
        ),
        (
            "<arm name='a' mail='x'/>",
            '2: <arm name="a">: unknown attribute "mail"; it belongs to <package>; allowed: '
            "name, rate, mode, gear, moves, low, high, note, was [unknown-attribute]",
        ),
        (
            "<arm name='a'>text</arm>",
            '2: <arm name="a">: text is not allowed here: "text"; it takes attributes: name, '
            "rate, mode, gear, moves, low, high, note [text-not-allowed]",
        ),
        (
            "<arm name='a'>// text</arm>",
            '2: <arm name="a">: text is not allowed here: "// text"; a comment is <!-- ... '
            "--> [text-not-allowed]",
        ),
        (
            "<arm name='a'><joint name='a' side='left'/>\n<joint name='a' side='right'/></arm>",
            '3: <joint name="a">: name: "a" is already taken at line 2; each must have its '
            "own [already-taken]",
        ),
        (
            "<arm name='a'><joint name='a'>left</joint></arm>",
            '2: <joint name="a">: text is not allowed here: "left"; did you mean side="..."? '
            "[text-not-allowed]",
        ),
        (
            "<arm name='a'><joint side='left'/></arm>",
            '2: <joint side="left">: attribute "name" is missing [missing-attribute]',
        ),
        (
            "<arm name='a'><joint name='a' side='left'/><joint name='b' side='left'/><joint "
            "name='c' side='left'/></arm>",
            '2: <arm name="a">: has 3 <joint>; it may have 2 at most [too-many]',
        ),
        (
            "<arm name='a'><tool kind='x'/>\n<tool kind='y'/></arm>",
            '3: <tool kind="y">: there is one at line 2; put all into one [only-one]',
        ),
        (
            "<arm name='a'><tool kind=''/></arm>",
            '2: <tool kind="">: kind: must not be empty [empty-value]',
        ),
        (
            "<arm name='a'><servo name='x'/></arm>",
            '2: <servo name="x">: its <arm> at line 2 must have the attribute "rate" (how '
            'often) or "moves", or use <directServo> [owner-lacks-attribute]',
        ),
        (
            "<arm name='a'><value name='x' type='int' value='y'/></arm>",
            '2: <value name="x">: value: "y" is not an int; allowed: a whole number, such as '
            "-3 or 0xff [invalid-value]",
        ),
        (
            "<arm name='a'><value name='x' type='int' list='[]' value='1'/></arm>",
            '2: <value name="x">: list: a list must not be empty; drop the attribute '
            "[empty-value]",
        ),
        (
            "<arm name='a'><value name='x' type='int' list='[1, 2]' value='3'/></arm>",
            '2: <value name="x">: value: "3" is none of list; allowed: 1, 2 [not-among]',
        ),
        (
            "<arm name='a'><value name='x' type='double' value='3'/></arm>",
            '2: <value name="x">: type: unknown "double"; allowed: int, string [unknown-choice]',
        ),
        (
            "<arm name='a'><value name='x' value='3'/></arm>",
            '2: <value name="x">: attribute "type" is missing [missing-attribute]',
        ),
        (
            "<arm name='a'><link name='x' to='y'/></arm>",
            '2: <link name="x">: to: "y" is no <joint> of this <arm> whose side is left; '
            "none is allowed [unknown-reference]",
        ),
        (
            "<arm name='a'><joint name='y' side='right'/><link name='x' to='y'/></arm>",
            '2: <link name="x">: to: "y" is no <joint> of this <arm> whose side is left; '
            "none is allowed [unknown-reference]",
        ),
        (
            "<arm name='a'><hinge name='x'/></arm>",
            '2: <hinge name="x">: <hinge> is not known here; did you mean "joint"? allowed: '
            "joint, tool, servo, directServo, dynText, text, value, sees, use, link "
            "[unknown-tag]",
        ),
        (
            "<arm name='a'><bolt name='x'/></arm>",
            '2: <bolt name="x">: <bolt> is not known here; it belongs inside <joint>; '
            "allowed: joint, tool, servo, directServo, dynText, text, value, sees, use, link "
            "[unknown-tag]",
        ),
        (
            "<arm name='a'><rate>1</rate></arm>",
            '2: <rate>: <rate> is not known here; did you mean rate="..."? [unknown-tag]',
        ),
        (
            "<arm name='a'><speed/></arm>",
            '2: <speed>: <speed> is not known here; did you mean mode="..."? [unknown-tag]',
        ),
        (
            "<arm name='a'><toll kind='x'/></arm>",
            '2: <toll kind="x">: <toll> is not known here; did you mean "tool"? allowed: '
            "joint, tool, servo, directServo, dynText, text, value, sees, use, link "
            "[unknown-tag]",
        ),
        (
            "<arm name='a'><joint name='for' side='left'/></arm>",
            '2: <joint name="for">: name: "for" is a keyword of Python and C++; choose '
            "another [reserved-name]",
        ),
        (
            "<arm name='a'><value name='x' type='string' list='[a, b]' value='aa'/></arm>",
            '2: <value name="x">: value: "aa" is none of list; did you mean "a"? allowed: a, b '
            "[not-among]",
        ),
        (
            "<arm name='a'><joint name='a' side='left'>\n"
            "<bolt name='b' size='x'/><bolt/></joint></arm>",
            '3: <bolt name="b">: size: "x" is not an int; allowed: a whole number, such as '
            "-3 or 0xff [invalid-value]\n"
            '3: <bolt>: attribute "name" is missing [missing-attribute]\n'
            '3: <bolt>: attribute "size" is missing [missing-attribute]',
        ),
        (
            "<arm name='a'><joint name='a' side='left' x='1' y='2'/>\n<x/></arm>",
            '2: <joint name="a">: unknown attribute "x"; allowed: name, side, was '
            "[unknown-attribute]\n"
            '2: <joint name="a">: unknown attribute "y"; allowed: name, side, was '
            "[unknown-attribute]\n"
            "3: <x>: <x> is not known here; allowed: joint, tool, servo, directServo, "
            "dynText, text, value, sees, use, link [unknown-tag]",
        ),
        (
            "<arm name='a'><use name='g' was='x'/></arm>\n<group name='g'><tool/></group>",
            '2: <use name="g">: unknown attribute "was"; allowed: name [unknown-attribute]\n'
            '3: <tool>: attribute "kind" is missing [missing-attribute]',
        ),
        (
            "<arm name='a'><use name='h'/></arm>",
            '2: <use name="h">: name: "h" is no <group> of this <package>; none is allowed '
            "[unknown-reference]",
        ),
        (
            "<arm name='a'><joint nmae='a' side='left'/></arm>",
            '2: <joint nmae="a">: unknown attribute "nmae"; did you mean "name"? allowed: '
            "name, side, was [unknown-attribute]",
        ),
        (
            "<arm name='a'><joint name='a' hand='left'/></arm>",
            '2: <joint name="a">: unknown attribute "hand"; did you mean side="..."? '
            "[unknown-attribute]",
        ),
        (
            "<arm name='a' rate='x'><servo name='s'/></arm>",
            '2: <arm name="a">: rate: "x" is not a number; allowed: a finite number without '
            "a unit, such as 12.5 [invalid-value]",
        ),
        (
            "<arm name='a'><joint name='a'>up</joint></arm>",
            '2: <joint name="a">: text is not allowed here: "up"; it takes attributes: name, '
            "side; elements: bolt [text-not-allowed]\n"
            '2: <joint name="a">: attribute "side" is missing [missing-attribute]',
        ),
        (
            "<message name='A'/><arm name='a'>\n"
            "<use name='g'/></arm>\n"
            "<group name='g'><sees name='x' type='B'/></group>",
            '4: <sees name="x"> (used at line 3): type: "B" is not declared in this package; '
            "allowed: A [undeclared-type]",
        ),
        (
            "<message name='A_b'/>",
            '2: <message name="A_b">: name: "A_b" is not a name of a type; allowed: letters '
            "and digits, a capital first [invalid-name]",
        ),
        (
            "<arm name='a' moves='no'><dynText name='x'/></arm>",
            '2: <dynText name="x">: its <arm> at line 2 must have the attribute "moves", or '
            "use <text> [owner-lacks-attribute]",
        ),
        (
            "<arm name='a'><value name='x' type='int'>3</value></arm>",
            '2: <value name="x">: text is not allowed here: "3"; did you mean value="..."? '
            "[text-not-allowed]",
        ),
        (
            "<arm name='a'><tooo/><tool/></arm>",
            '2: <tooo>: <tooo> is not known here; did you mean "tool"? allowed: joint, tool, '
            "servo, directServo, dynText, text, value, sees, use, link [unknown-tag]\n"
            '2: <tool>: attribute "kind" is missing [missing-attribute]',
        ),
        (
            "<limb name='a'/>\n<arm name='A'/>",
            '3: <arm name="A">: name: "A" is already taken by "a" at line 2; each must have '
            "its own [already-taken]",
        ),
        (
            "<pair name='x'>\n<half name='a'/></pair>",
            '2: <pair name="x">: has 1 <half>; it needs 2 at least [too-few]',
        ),
        (
            "<pair name='x'>\n<hlf name='a'/></pair>",
            '3: <hlf name="a">: <hlf> is not known here; did you mean "half"? allowed: half '
            "[unknown-tag]",
        ),
        ("<arm/>", '2: <arm>: attribute "name" is missing (its name) [missing-attribute]'),
        (
            "<arm name='a' mode='best_available'/><arm name='b' template='x'/>",
            '2: <arm name="a">: mode: Humble has no "best_available"; ROS 2 has it since '
            "Iron [not-in-distro]\n"
            '2: <arm name="b">: unknown attribute "template"; it belongs to <package>; '
            "allowed: name, rate, mode, gear, moves, low, high, note, was [unknown-attribute]",
        ),
        (
            "<message name='A'><field name='x' type='Bb'/></message>\n<message name='BB'/>",
            '2: <field name="x">: type: "Bb" is not declared in this package; did you mean '
            '"BB"? allowed: A, BB [undeclared-type]',
        ),
        (
            "<message name='A'><field name='x' type='A[]'/></message>",
            '2: <field name="x">: type: "A" would contain itself; choose another type '
            "[recursive-type]",
        ),
        (
            "<message name='A'><field name='x' type='B'/></message>\n"
            "<message name='B'><field name='x' type='pp::A'/></message>",
            '3: <field name="x">: type: "A" would contain itself; choose another type '
            "[recursive-type]",
        ),
        (
            "<message name='A'><field name='x' type='pp::C'/><field name='y' "
            "type='other::C'/></message>",
            '2: <field name="x">: type: "C" is not declared in this package; allowed: A '
            "[undeclared-type]",
        ),
        (
            "<message name='A'><field name='x' type='float'/></message>",
            '2: <field name="x">: type: "float" is no type of ROS; did you mean "float32"? '
            "allowed: a primitive type, Type, package::Type; [], [3] or [<=3] after it "
            "[invalid-type]",
        ),
        (
            "<message name='A'><field name='x' type='String'/></message>",
            '2: <field name="x">: type: "String" is not declared in this package; did you '
            'mean "string"? allowed: A [undeclared-type]',
        ),
    ],
)
def test_fault_inside(said, inside, says):
    """The first line is that of the package."""
    assert said(f"<package name='pp'>\n{inside}</package>") == says


def test_right_spec(values):
    found = values("""<package name="pp">
<limb name="my_arm" rate="1" mode=" s " low="3" high="3" note="">
  <joint name="a" side="left" was="x"><bolt name="b" size="0x10"/></joint>
  <tool kind="k"/>
  <servo name="s"/>
  <text name="t" words=""/>
  <value name="v" type="string" list="[a, b]" value="b"/>
  <link name="l" to="a"/>
</limb>
<arm name="other" moves="yes" mode="fast"><servo name="s"/><dynText name="t"/></arm>
<folder name="f"/>
<depend kind="exec">std_msgs</depend>
</package>""")
    first, other = found["arms"]
    assert {key: each for key, each in first.items() if not isinstance(each, list)} == {
        "tag": "arm",
        "name": "my_arm",
        "class_name": "MyArm",
        "rate": 1.0,
        "mode": "slow",
        "gear": None,
        "moves": False,
        "low": 3,
        "high": 3,
        "note": "",
        "tool": {"kind": "k"},
    }
    assert first["joints"] == [
        {"name": "a", "side": "left", "was": "x", "bolts": [{"name": "b", "size": 16}]}
    ]
    assert first["values"] == [{"name": "v", "type": "string", "list": ["a", "b"], "value": "b"}]
    assert (first["links"], first["texts"]) == (
        [{"name": "l", "to": "a"}],
        [{"name": "t", "words": ""}],
    )
    assert (other["gear"], other["moves"], other["tool"]) == (3, True, None)
    assert (found["folders"], found["pairs"]) == ([{"name": "f"}], [])


def test_package_says_its_name_of_before(values):
    assert values("<package name='pp' was='p'><arm name='a'/></package>")["was"] == "p"


def test_type_that_another_element_declares_is_no_part_of_itself(values):
    spec = "<message name='A'/><arm name='a'><sees name='x' type='A'/></arm>"
    (arm,) = values(f"<package name='pp'>{spec}</package>")["arms"]
    assert arm["seess"] == [{"name": "x", "type": "A"}]
