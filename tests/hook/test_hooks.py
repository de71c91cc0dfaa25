"""The hook by itself: parse, check, complete, skeleton."""

import re
import string

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hooks import formats
from hooks.dictionary import load, nested
from hooks.faults import SpecError
from hooks.model import Model
from hooks.parse import parse
from hooks.ros import DISTROS, is_lacking, nearest_available, translate_dependency
from support.packages import model_of
from support.repository import EXAMPLES

FIGURE_4 = """
package_attributes: ["name", "author", "author_email",
                    "description", "license", "copyright"]
node_attributes: ["name", "frequency"]

node_interface:
  publisher: ["name", "type", "description"]
  directPublisher: ["name", "type", "description"]
  subscriber: ["name", "type", "description"]
  directSubscriber: ["name", "type", "description"]
  serviceClient: ["name", "type", "description"]
  serviceServer: ["name", "type", "description"]
  parameter: ["name", "type", "value", "description"]
  dynParameter: ["name", "type", "value", "description"]
  actionServer: ["name", "type", "description"]
  actionClient: ["name", "type", "description"]
  listener: ["name", "description"]
  broadcaster: ["name", "description"]
"""
PACKAGE = (
    '<package name="pkg" author="A" author_email="a@example.org" description="d"'
    ' license="MIT">{}</package>'
)
FIGURE_4_SPEC = """
<package name="pkg" author="A" author_email="a" description="d" license="MIT" copyright="2026">
<node name="n" frequency="1"><listener name="l" description="d"/></node></package>
"""
NODE = PACKAGE.format('<node name="n" frequency="1">{}</node>')


@pytest.fixture(scope="module")
def model():
    return model_of("python_model")


def context(model, xml, distro="kilted"):
    return model.context(xml.encode(), "spec.xml", distro)


def faults(model, xml):
    with pytest.raises(SpecError) as error:
        context(model, xml)
    return str(error.value).splitlines()


def test_figure_1_of_the_paper(model):
    xml = (EXAMPLES / "contact_analysis.ros_package").read_bytes()
    for distro in DISTROS:
        spec = model.context(xml, "spec", distro)
        node = spec["nodes"][0]
        assert node["frequency"] == 1000.0
        assert node["subscribers"][0]["type"] == "geometry_msgs/msg/Point"
        assert [server["name"] for server in node["actionServers"]] == ["learn", "evaluate"]
        assert node["dynParameters"][0]["value"] is True
        assert spec["license"] == "GPL-3.0-only"
        assert {"contact_msgs", "geometry_msgs"} <= set(spec["depends"])
        assert ("actionlib" in spec["depends"]) == (distro == "noetic")


def test_figure_4_of_the_paper(tmp_path):
    """The dictionary of the paper is valid as it stands, and accepts the spec of the paper."""
    (tmp_path / "dictionary.yaml").write_text(FIGURE_4)
    model = Model(tmp_path, tmp_path)
    assert list(model.dictionary.components["node"].interfaces) == re.findall(
        r"^  (\w+):", FIGURE_4, re.MULTILINE
    )
    xml = (EXAMPLES / "contact_analysis.ros_package").read_bytes()
    spec = model.context(xml, "spec", "noetic")
    assert spec["nodes"][0]["subscribers"][0]["type"] == "geometry_msgs::Point"


def test_unknown_distribution(model):
    xml = NODE.format("").encode()
    with pytest.raises(SpecError, match=r'^ros_distro: unknown "melodic"; .* \[unknown-choice\]$'):
        model.context(xml, "spec.xml", "melodic")


def test_a_default_counts_where_the_attribute_has_a_meaning(model):
    server = '<actionServer name="x" type="a::B" {}/>'
    for said, most in [("", None), ('goal="queue"', None), ('goal="parallel"', 8)]:
        found = context(model, NODE.format(server.format(said)))
        assert found["nodes"][0]["actionServers"][0]["max_goals"] == most


def test_a_tree_says_what_differs_from_a_default(model):
    """So does NoDL, and whatever else is made of a context."""
    node = '<node name="n" executable="n" node_name="m" reconfigure="true" diagnostics="false"/>'
    _, _, [(_, said, _)] = model.tree(context(model, PACKAGE.format(node)))
    assert said == {"name": "n", "node_name": "m", "reconfigure": True}


def test_component_and_template_are_understood(model):
    node = context(model, NODE.format(""))
    component = NODE.format("").replace("node", "component")
    assert context(model, component) == node
    assert context(model, NODE.format("").replace(" author=", ' template="cpp" author=')) == node


@pytest.mark.parametrize(
    ("inside", "message"),
    [
        ('<publisher nam="x" type="a::B"/>', 'unknown attribute "nam"; did you mean "name"?'),
        ('<publisher type="a::B"/>', 'attribute "name" is missing'),
        ('<publisher name="x" type="a::B" value="1"/>', 'unknown attribute "value"'),
        ('<publsher name="x" type="a::B"/>', 'did you mean "publisher"?'),
        ('<publisher name="x" type="B"/>', '"B" is not a type; it lacks its package; '),
        ('<publisher name="x" type="a::msg/B"/>', "is not a type"),
        ('<publisher name="x" type="a/srv/B"/>', "package/msg/Type"),
        ('<serviceServer name="x" type="a/msg/B"/>', "package/srv/Type"),
        ('<publisher name="1x" type="a::B"/>', "is not a valid ROS name"),
        ('<publisher name="a//b" type="a::B"/>', "is not a valid ROS name"),
        ('<publisher name="a__b" type="a::B"/>', "is not a valid ROS name"),
        ('<publisher name="" type="a::B"/>', "is not a valid ROS name"),
        ('<publisher name="lambda" type="a::B"/>', "keyword of Python"),
        ('<publisher name="template" type="a::B"/>', "keyword of C++"),
        ('<publisher name="class" type="a::B"/>', "keyword of Python and C++"),
        ('<publisher name="x" type="a::B"/>' * 2, 'name: "x" is already taken at line 1'),
        ('<publisher name="a/b" type="a::B"/><publisher name="a_b" type="a::B"/>', "taken"),
        ('<parameter name="p" type="int" value="1.5"/>', '"1.5" is not an int'),
        ('<parameter name="p" type="int" value="9223372036854775808"/>', "does not fit 64 bits"),
        ('<parameter name="p" type="bool" value="maybe"/>', "allowed: true, 1, yes, on"),
        ('<parameter name="p" type="double" value="nan"/>', "is not a number"),
        ('<parameter name="p" type="int[]" value="[1, x]"/>', '"x" is not an int'),
        ('<parameter name="p" type="int[]" value="1"/>', "a list such as"),
        ('<parameter name="p" type="strin" value="1"/>', 'did you mean "string"?'),
        ('<parameter name="autostart" type="bool" value="1"/>', "is reserved"),
        (
            '<parameter name="p" type="int" value="1"/>'
            '<dynParameter name="p" type="int" value="1"/>',
            "already taken",
        ),
        ('<dynParameter name="p" type="int" min="2" value="1"/>', "value: 1 must be at least 2"),
        ('<dynParameter name="p" type="int" max="2" value="3"/>', "value: 3 must be at most 2"),
        ('<dynParameter name="p" type="bool" max="1" value="1"/>', '"max" has no meaning'),
        ('<parameter name="p" type="double" max="2" value="3"/>', "value: 3.0 must be at most 2"),
        ('<parameter name="p" type="int[]" max="[2]"/>', "has no meaning where type is"),
        ('<parameter name="p" type="int[]" max="2"/>', '"max" has no meaning where type is'),
        ('<parameter name="p" type="int[]" value="[1]" choices="[1]"/>', "has no meaning where"),
        ('<parameter name="p" type="int[]" value="[1]" min="[3]"/>', "has no meaning where"),
        ('<parameter name="p" type="int" choices="[]"/>', "choices: a list must not be empty; d"),
        (
            '<parameter name="p" type="string" choices="[a, b, a]"/>',
            'choices: "a" is there twice; drop one [already-taken]',
        ),
        (
            '<parameter name="p" type="double" choices="[1, 1.0]"/>',
            'choices: "1" is there twice; drop one [already-taken]',
        ),
        ('<timer name="a" was="a" frequency="1"/>', 'was: "a" is the name it has; drop it [name'),
        ('<instance name="/a/b"/>', 'name: "/a/b" is not relative; did you mean "a/b"? [invalid-'),
        ('<instance name="~/a"/>', 'name: "~/a" is not relative; did you mean "a"? [invalid-'),
        ('<instance name="a//b"/>', 'name: "a//b" is not a valid ROS name; allowed: '),
        ('<parameter name="p" type="int" choices="[1, x]"/>', 'choices: "x" is not an int'),
        (
            '<parameter name="p" type="int" max="2" choices="[1, 3]"/>',
            "choices: 3 must be at most",
        ),
        (
            '<parameter name="p" type="string" choices="[slow, fast]" value="slwo"/>',
            'value: "slwo" is none of choices; did you mean "slow"? allowed: slow, fast',
        ),
        ('<dynParameter name="p" type="int" choices="[1, 2]" value="3"/>', "allowed: 1, 2"),
        ('<dynParameter name="p" type="int"/>', 'attribute "value" is missing'),
        ('<publisher name="x" type="a::B">text</publisher>', "text is not allowed here"),
        ('<publisher name="x" type="a::B"><x/></publisher>', "<x> is not known here; none"),
        ("<depend>std_msgs</depend>", "it belongs inside <package>"),
    ],
)
def test_fault_in_a_node(model, inside, message):
    found = faults(model, NODE.format(inside))
    assert any(message in line for line in found), found
    assert all(line.startswith("spec.xml:1: <") for line in found)


@pytest.mark.parametrize("more", ['value="2"', 'choices="[2]" value="2"'])
def test_bounds_that_exclude_all_are_one_fault(model, more):
    inside = f'<parameter name="p" type="int" min="3" max="1" {more}/>'
    assert faults(model, NODE.format(inside)) == [
        'spec.xml:1: <parameter name="p">: max: 1 must be at least 3 [out-of-range]'
    ]


@pytest.mark.parametrize(
    ("xml", "message"),
    [
        (NODE.replace('frequency="1"', 'frequency="fast"'), '"fast" is not a number'),
        (NODE.replace('frequency="1"', 'frequency="-1"'), "must be at least 0.001"),
        (NODE.replace('frequency="1"', 'frequency="0"'), "must be at least 0.001"),
        (NODE.replace('frequency="1"', 'frequency="inf"'), "is not a number"),
        *(
            (
                NODE.replace(' frequency="1"', "").format(text),
                f'<{kind} name="x">: its <node> at line 1 must have the attribute "frequency" (how'
                f" often update runs, in Hz; a node without it has no update){other}>",
            )
            for text, kind, other in [
                ('<publisher name="x" type="a::B"/>', "publisher", ", or use <directPublisher"),
                ('<subscriber name="x" type="a::B"/>', "subscriber", ", or use <directSubscriber"),
                (
                    '<dynParameter name="x" type="int" value="1"/>',
                    "dynParameter",
                    ' or "reconfigure" (whether the logic gets changed parameters by its method'
                    " reconfigure, which may refuse them), or use <parameter",
                ),
            ]
        ),
        (
            NODE.replace('frequency="1"', 'reconfigure="false"').format(
                '<dynParameter name="x" type="int" value="1"/>'
            ),
            'must have the attribute "frequency"',
        ),
        (NODE.replace('name="n"', 'name="for"'), "keyword of Python and C++"),
        (NODE.replace('name="n"', 'name="a-b"'), "is not a valid name"),
        (NODE.replace('name="n"', 'name="test"'), '"test" is reserved'),
        (NODE.replace('"pkg"', '"My-Pkg"'), "REP 144"),
        (NODE.replace('"pkg"', '"p"'), "REP 144"),
        (NODE.replace('"pkg"', '"a__b"'), "REP 144"),
        (NODE.replace('"pkg"', '"class"'), "keyword"),
        (NODE.replace("a@example.org", "a@b"), "is not a mail address"),
        (NODE.replace('"d"', '" "'), "description: must not be empty"),
        (NODE.replace(' license="MIT"', ""), 'attribute "license" is missing'),
        (PACKAGE.format(""), "has no <node>"),
        (PACKAGE.format("<nod/>"), 'did you mean "node"?'),
        (PACKAGE.format('<publisher name="x" type="a::B"/>'), "it belongs inside <node>"),
        (PACKAGE.format("<depend>a b</depend>"), '"a b" is not a package name'),
        (PACKAGE.format("<depend/>"), '"" is not a package name'),
        (PACKAGE.format("<depend name='x'>x</depend>"), "takes a package name: "),
        (
            PACKAGE.format("<depend kind='exe'>x</depend>"),
            'kind: unknown "exe"; did you mean "exec"?',
        ),
        (PACKAGE.format('<maintainer name="B" email="b"/>'), '"b" is not a mail address'),
        (PACKAGE.format('<maintainer name="B" email="b@c.de"/>'), "has no <node>; it needs"),
        (PACKAGE.format('<url address="example.org"/>'), "not an address of the web"),
        (PACKAGE.format('<node name="a"/><folder name="config"/>'), '"config" is reserved'),
        (PACKAGE.format('<folder name="../urdf"/>'), "not a file name"),
        (
            PACKAGE.format('<node name="a" executable="b"/><node name="b"/>'),
            'makes the executable "b"',
        ),
        (PACKAGE.replace("author=", 'version="1.2" author=').format("<node/>"), "not a version"),
        (
            PACKAGE.format('<node name="a_b" frequency="1"/><node name="aB" frequency="1"/>'),
            "already taken",
        ),
        ("<robot/>", "a spec starts with <package>, not <robot>"),
        ("<package", "not well-formed XML"),
        ("", "not well-formed XML"),
        ('<!DOCTYPE package [<!ENTITY x "y">]>' + NODE, "entities are disabled"),
    ],
)
def test_fault_in_a_package(model, xml, message):
    assert any(message in line for line in faults(model, xml.replace("{}", "")))


def test_all_faults_are_told_with_their_lines(model):
    xml = NODE.format('\n<publisher name="1" type="x"/>\n\n<nothing/>\n<dynParameter name="p"/>')
    assert [line.split(" ")[0] for line in faults(model, xml)] == [
        "spec.xml:2:",
        "spec.xml:2:",
        "spec.xml:4:",
        "spec.xml:5:",
        "spec.xml:5:",
    ]


@pytest.mark.parametrize("written", ["pkg::T", "pkg/T", "pkg/msg/T", "pkg::msg::T"])
def test_ways_to_write_a_type(written):
    assert formats.FORMATS["message_type"](written) == "pkg/msg/T"


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("apache-2.0", "Apache-2.0"),
        ("BSD", "BSD-3-Clause"),
        ("https://www.gnu.org/licenses/gpl.txt", "GPL-3.0-only"),
        ("http://www.apache.org/licenses/LICENSE-2.0", "Apache-2.0"),
        ("MIT OR Apache-2.0", "MIT OR Apache-2.0"),
        ("Our own", "Our own"),
    ],
)
def test_licences(written, meant):
    assert formats.license_name(written) == meant


def test_dependencies_are_translated(model):
    depends = "".join(
        f"<depend>{name}</depend>" for name in ("roscpp", "tf", "actionlib", "nav_msgs", "rospy")
    )
    xml = NODE.format("").replace("<node", depends + "<node")
    ros2 = context(model, xml)
    assert {"rclcpp", "tf2_ros", "nav_msgs", "rclpy"} <= set(ros2["depends"])
    assert not {"roscpp", "tf", "actionlib", "rospy"} & set(ros2["depends"])
    assert len(ros2["notes"]) == 4
    for name, meaning in (("tf", "became tf2_ros"), ("actionlib", "was left out")):
        note = f"<depend>{name}</depend> has no meaning in ROS 2: it {meaning}"
        assert f"{note} [dependency-of-other-ros]" in ros2["notes"]
    ros1 = context(model, xml, "noetic")
    assert {"roscpp", "tf", "actionlib", "nav_msgs", "rospy"} <= set(ros1["depends"])
    assert ros1["notes"] == []
    xml = xml.replace("<node", '<depend kind="exec">rosconsole</depend><node')
    assert context(model, xml)["other_depends"] == {}
    assert context(model, xml, "noetic")["other_depends"] == {"exec": ["rosconsole"]}
    assert translate_dependency("rclpy", 1)[0] == "rospy"
    assert translate_dependency("rclcpp_lifecycle", 1)[0] == "roscpp"
    near = {name: nearest_available(name, 2) for name in ("rospy", "rosconsole", "nav_msgs")}
    assert near == {"rospy": "rclpy", "rosconsole": None, "nav_msgs": None}


def test_kinds_bring_their_dependencies(model):
    inside = '<actionServer name="a" type="x::Y"/><listener name="l"/>'
    inside += '<dynParameter name="p" type="int" value="1"/>'
    assert {"x", "actionlib", "tf2_ros", "dynamic_reconfigure", "rospy"} <= set(
        context(model, NODE.format(inside), "noetic")["depends"]
    )
    assert {"x", "tf2_ros_py", "rclpy"} <= set(context(model, NODE.format(inside))["depends"])


SOURCES = {"folder": "pkg", "user": 'A "b" <c>', "email": "a@example.org", "year": "2026"}


def test_skeleton_is_valid_and_shows_every_kind(model):
    xml = model.skeleton(SOURCES)
    spec = context(model, xml)
    (node,) = spec["nodes"]
    assert spec["author"] == SOURCES["user"]
    assert spec["copyright"] == f"2026 {SOURCES['user']}"
    assert [len(node["publishers"]), len(node["subscribers"])] == [1, 1]
    assert spec["kinds"] == ["publisher", "subscriber"]
    # Every other kind is there as a comment; with its comment signs off it is valid too.
    uncommented = re.sub(r"<!-- (<[a-zA-Z][^!]*>) -->", r"\1", xml)
    kinds = model.dictionary.components["node"].interfaces
    assert {*context(model, uncommented, "noetic")["kinds"]} == {
        kind.kind for kind in nested(kinds)
    }
    for kind in kinds.values():
        assert f"{kind.kind}: {kind.doc}" in xml
        for attribute in kind.attributes.values():
            assert attribute.doc
            assert attribute.doc in " ".join(xml.split())


@pytest.mark.parametrize("name", ["python_model", "cpp_model", "interfaces_model"])
def test_skeleton_fits_every_ros_and_spells_as_a_spec(name):
    xml = model_of(name).skeleton(SOURCES)
    assert "test_msgs" not in xml  # ROS 1 has none
    assert not re.search(r"default (True|False|None|\d+\.0)\b", xml)


def test_hint_at_an_action_type_is_of_both_ros(model):
    inside = '<actionServer name="a" type="a"/>'
    (said,) = faults(model, NODE.format(inside))
    assert said.endswith("such as tf2_msgs/LookupTransform [invalid-type]")


@settings(deadline=None)
@given(st.text(alphabet=string.printable))
def test_any_text_is_a_spec_or_a_fault(text):
    model = model_of("python_model")
    try:
        context(model, text)
    except SpecError as error:
        assert str(error).startswith("spec.xml:")


@settings(deadline=None)
@given(st.text(st.characters(codec="utf-8", categories=("L", "N", "P", "S", "Zs")), min_size=1))
def test_any_value_survives(text):
    from xml.sax.saxutils import quoteattr

    model = model_of("python_model")
    inside = f'<parameter name="p" type="string" value={quoteattr(text)}/>'
    assert context(model, NODE.format(inside))["nodes"][0]["parameters"][0]["value"] == text


def test_lines_and_order_are_kept():
    element = parse(b"<a>\n<b/>\n<c\n/>\n<b x='1'/></a>", "f")
    assert element.tag == "a"
    assert [(child.tag, child.line) for child in element.children] == [
        ("b", 2),
        ("c", 3),
        ("b", 5),
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("node_interface: {publisher: 1}", "publisher: must be a list"),
        ("node_interface: {publisher: [{name: {formt: text}}]}", 'did you mean "format"?'),
        ("node_interface: {publisher: [{name: {format: txt}}]}", 'did you mean "text"?'),
        ("node_interfaces: {}", "<component>_interface"),
        ("package_attributes: [name, nodes]\nnode_interface: {}", 'needs the key "nodes"'),
        ("- a", "must be a mapping"),
        ("a: [", "not YAML"),
        (
            "node_attributes: [name, rate]\nnode_interface: {out: {requires: rat}}",
            'out: requires "rat", which is no attribute of <node>; did you mean "rate"?',
        ),
        ("node_attributes: [tag]\nnode_interface: {}", 'needs the key "tag"'),
    ],
)
def test_fault_in_a_dictionary(tmp_path, text, message):
    (tmp_path / "dictionary.yaml").write_text(text)
    with pytest.raises(SpecError, match=re.escape(message)):
        load(tmp_path / "dictionary.yaml", tmp_path)


def test_what_a_distribution_lacks():
    assert is_lacking("humble", "post_set_parameters")
    assert not is_lacking("rolling", "post_set_parameters")
    with pytest.raises(SpecError, match='unknown feature "post_set"; allowed: best_') as error:
        is_lacking("rolling", "post_set")
    assert error.value.id == "unknown-feature"


def test_fault_in_functions(tmp_path):
    (tmp_path / "dictionary.yaml").write_text(FIGURE_4)
    functions = tmp_path / "functions.py"
    functions.write_text("def dependencies_from_interface(kind, attributes, distro):\n    1 / 0\n")
    with pytest.raises(SpecError) as error:
        context(Model(tmp_path, tmp_path), FIGURE_4_SPEC)
    assert f"{functions}:2: " in str(error.value)
    assert '<listener name="l">' in str(error.value)
    functions.write_text("def broken(:\n")
    with pytest.raises(SpecError, match=r"functions.py:1: SyntaxError"):
        Model(tmp_path, tmp_path)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ("'no listener today'", "no listener today [refused-by-model]"),
        ("'no listener today', 'no-listener'", "no listener today [no-listener]"),
    ],
)
def test_function_that_refuses_a_spec(tmp_path, arguments, said):
    """With an id of the model's own, if it gives one: what the page of ours need not have."""
    (tmp_path / "dictionary.yaml").write_text(FIGURE_4)
    functions = "def check_interface(kind, attributes, distro):\n"
    (tmp_path / "functions.py").write_text(f"{functions}    raise ValueError({arguments})\n")
    with pytest.raises(SpecError) as error:
        context(Model(tmp_path, tmp_path), FIGURE_4_SPEC)
    assert str(error.value) == f'spec.xml:3: <listener name="l">: {said}'
