"""Names that would be taken twice, or that are reserved where they land, are refused."""

import ast

import pytest

from hooks.faults import SpecError
from hooks.formats import FORMATS, FORMATS_OF_ROS
from hooks.model import Model
from hooks.words import PACKAGES, meaning
from support.packages import model_of
from support.repository import EXAMPLES

MODELS = {name: model_of(name) for name in ("python_model", "cpp_model")}
TYPES = {"publisher": "std_msgs::String", "service": "std_srvs::Trigger"}


def spec(*nodes, package="arm"):
    about = 'author="A" author_email="a@example.org" description="d" license="MIT"'
    return f'<package name="{package}" {about}>\n' + "\n".join(nodes) + "\n</package>"


def node(*inside, name="n"):
    return f'<node name="{name}" frequency="1">\n' + "\n".join(inside) + "\n</node>"


def interface(kind, name, type_=None):
    folder = next((f for f in ("service", "action") if kind.startswith(f)), "message")
    example = {"service": "std_srvs::Trigger", "action": "test_msgs::Fibonacci"}
    return f'<{kind} name="{name}" type="{type_ or example.get(folder, "std_msgs::String")}"/>'


def parameter(name, kind="parameter", type_="int", value="1"):
    return f'<{kind} name="{name}" type="{type_}" value="{value}"/>'


def context(model, xml, distro="kilted"):
    return MODELS[model].context(xml.encode(), "spec.xml", distro)


def refusal(model, xml, distro="kilted"):
    with pytest.raises(SpecError) as error:
        context(model, xml, distro)
    return str(error.value)


BOTH = [
    (interface("publisher", "x"), interface("publisher", "x/active"), "out_x_active"),
    (interface("publisher", "x/active"), interface("publisher", "x"), "out_x_active"),
    (interface("subscriber", "x"), interface("subscriber", "x/updated"), "in_x_updated"),
]
CPP = [
    (interface("actionClient", "service"), interface("serviceServer", "action"), "ActionService"),
    (interface("serviceClient", "service"), interface("serviceServer", "client"), "ClientService"),
    (interface("publisher", "message"), interface("directSubscriber", "out"), "OutMessage"),
]
PYTHON = [
    (
        interface("serviceClient", "x"),
        interface("serviceServer", "client_x"),
        "ClientXRequest",
    ),
    (interface("actionClient", "x"), interface("actionServer", "action_x"), "ActionXGoal"),
    (interface("serviceServer", "x_goal"), interface("actionServer", "x"), "XGoalRequest"),
    (interface("publisher", "message"), interface("directSubscriber", "out"), "OutMessage"),
]


@pytest.mark.parametrize(
    ("model", "one", "other", "name"),
    [(model, *case) for model in MODELS for case in BOTH]
    + [("cpp_model", *case) for case in CPP]
    + [("python_model", *case) for case in PYTHON],
)
def test_two_of_the_same_are_refused_with_both_lines(model, one, other, name):
    text = refusal(model, spec(node(one, other)))
    assert text.startswith("spec.xml:4: ")
    assert f'"{name}", as {one[:-2].split(" type")[0]}> at line 3 does' in text
    context(model, spec(node(one), node(other, name="m")))


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    "inside",
    [
        parameter("NConfig"),
        *[
            parameter(name, "dynParameter")
            for name in ("linux", "unix", "NULL", "EOF", "M_PI", "Sequence", "str", "autostart")
        ],
        interface("serviceServer", "~/change_state"),
    ],
)
def test_reserved_inside_of_a_node(model, inside):
    assert "spec.xml:3: <" in refusal(model, spec(node(inside)))
    assert "reserved" in refusal(model, spec(node(inside)))


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("one", "other", "said"),
    [
        (
            *("axis", "axis.x"),
            '"axis" is a parameter itself, at line 3, so that nothing can be below it; rename one',
        ),
        ("axis.x", "axis.x.max", '"axis.x" is a parameter itself, at line 3'),
        ("axis.x", "axis", '"axis" is a parameter itself, at line 4'),
        ("axis.x", "axis_x", '"axis_x" is already taken by "axis.x" at line 3'),
        ("axis.x", "axis/x", '"axis.x" is already taken'),
        (
            *("x", "autostart.x"),
            '"autostart.x" is reserved as parameter: every node has it; choose another',
        ),
        ("x", "qos_overrides.x", "is reserved as parameter"),
        ("x", "axis..x", "is not a valid name"),
        ("x", ".axis", "is not a valid name"),
        ("x", "nullptr.", "is not a valid name"),
    ],
)
def test_groups_of_parameters(model, one, other, said):
    """The name of a group is that of no parameter, and each has a name of its own in the logic."""
    assert said in refusal(model, spec(node(parameter(one), parameter(other))))
    found = context(model, spec(node(parameter("axis.x"), parameter("axis/class"))))
    assert [p["name"] for p in found["nodes"][0]["parameters"]] == ["axis.x", "axis.class"]


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    "name", ["lambda", "namespace", "class", "str", "std", "Sequence", "linux", "NULL", "a.b"]
)
def test_parameters_keep_names_that_code_has_already(model, name):
    """Parameter files of nodes in use have them; the logic has them with an underscore behind."""
    word = name.replace(".", "_")
    own = word if "." in name else f"{word}_"
    found = context(model, spec(node(parameter(name), parameter("x"))))
    assert found["nodes"][0]["parameters"][0]["name"] == name
    said = refusal(model, spec(node(parameter(name), parameter(own))))
    assert "taken" in said if "." in name else f'"{own}", as <parameter name="{name}">' in said


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("name", ["config", "launch", "nodl"])
def test_folder_that_is_installed_anyway(model, name):
    said = refusal(model, spec('<folder name="x"/>', f'<folder name="{name}"/>', node()))
    why = "config, launch and nodl are installed anyway, and ROS has folders of its own"
    assert f'"{name}" is reserved as folder of the package: {why}; choose another' in said


RESERVED_NODES = "uninstall edit_cache INSTALL install preinstall gencfg gtest test lifecycle"


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("name", RESERVED_NODES.split())
def test_reserved_node(model, name):
    assert "reserved" in refusal(model, spec(node(name=name)))


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("one", "other", "name"),
    [
        ("driver", "arm_driver", "arm_driver"),
        ("n", "test_n_impl", "test_n_impl"),
        ("x", "x_dynamic", "XDynamicConfig"),
    ],
)
def test_two_nodes_that_make_the_same(model, one, other, name):
    for nodes in ((one, other), (other, one)):
        text = refusal(model, spec(*(node(name=each) for each in nodes)))
        assert f'"{name}"' in text
        assert "at line 2 does" in text
        assert text.startswith("spec.xml:5: ")


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    "name", ["test", "std_msgs", "rclpy", "threading", "dataclasses", "std", "exp", "linux"]
)
def test_reserved_package(model, name):
    assert refusal(model, spec(node(), package=name)).startswith("spec.xml:1: <package")


def modules_of(package):
    """Return the modules that a package imports, and those that its tests are."""
    for file in package.rglob("*.py"):
        if "test" in file.parts:
            yield file.stem
        for statement in ast.walk(ast.parse(file.read_text())):
            if isinstance(statement, ast.Import):
                yield from (name.name.split(".")[0] for name in statement.names)
            elif isinstance(statement, ast.ImportFrom):
                yield statement.module.split(".")[0]


@pytest.mark.parametrize("name", ["aux", "COM1", "Lpt9", "nul"])
def test_devices_of_windows_are_no_names_of_files(name):
    """Whatever has files of its name: packages, nodes, executables, messages."""
    formats = [FORMATS[each] for each in ("component_name", "package_name", "interface_name")]
    formats += [FORMATS["file_name"], FORMATS_OF_ROS[2]["interface_name"]]
    for format_, form in zip(
        formats, (name, name.lower(), name, name + ".txt", name.title()), strict=True
    ):
        with pytest.raises(SpecError, match=f'"{name.lower()}" is a device of Windows'):
            format_(form)
    assert FORMATS["ros_name"](name) == FORMATS["field_name"](name) == name


@pytest.mark.parametrize("name", ["con", "left/NUL", "com1/arm", "Aux"])
@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_devices_of_windows_are_no_names_of_parameter_files(name, model):
    """A node that is started by a name has config/NAME.yaml."""
    inside = f'<instance name="{name}"/>', '<timer name="aux" frequency="1"/>'
    assert "is a device of Windows, so reserved as file in config" in refusal(
        model, spec(node(*inside))
    )
    assert context(model, spec(node(inside[0].replace(name, "left/base"), inside[1])))


def test_what_packages_import_is_reserved():
    """A package of that name would hide it from itself."""
    folders = list(EXAMPLES.glob("all_kinds/*/*"))
    modules = {module for folder in folders for module in modules_of(folder)}
    own = {module for module in modules if module.startswith(("all_kinds", "test_"))}
    assert {module for module in modules - own if not meaning(module, PACKAGES)} == set()


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    "type_", ["class::T", "std_msgs::None", "dataclasses::T", "linux::T", "a::NULL"]
)
def test_type_that_cannot_be_one(model, type_):
    assert "spec.xml:3: <publisher" in refusal(
        model, spec(node(interface("publisher", "x", type_)))
    )


@pytest.mark.parametrize("model", MODELS)
def test_type_of_the_package_itself(model):
    text = refusal(model, spec(node(interface("publisher", "x", "arm::T"))))
    what = 'type: "T" is not declared in this package; add <message name="T">'
    assert f'spec.xml:3: <publisher name="x">: {what}' in text


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("distro", "kind", "type_", "nearest"),
    [
        ("kilted", "actionServer", "actionlib::TwoInts", "example_interfaces::Fibonacci"),
        ("kilted", "subscriber", "std_msgs::Time", "builtin_interfaces::Time"),
        ("noetic", "subscriber", "builtin_interfaces::Time", "std_msgs::Time"),
    ],
)
def test_type_that_the_chosen_ros_is_known_not_to_have(model, distro, kind, type_, nearest):
    xml = spec(node(interface(kind, "x", type_)))
    text = refusal(model, xml, distro)
    assert text.startswith("spec.xml:3: <")
    assert nearest in text
    context(model, xml, "noetic" if distro == "kilted" else "kilted")


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("kind", "type_", "meant"),
    [
        ("subscriber", "geometry_msgs/twist", "geometry_msgs/Twist"),
        ("publisher", "std_msgs::uint8", "std_msgs::UInt8"),
        ("directSubscriber", "geometry_msgs/msg/pose_stamped", "geometry_msgs/msg/PoseStamped"),
        ("serviceServer", "std_srvs::trigger", "std_srvs::Trigger"),
        ("actionServer", "test_msgs::fibonacci", "test_msgs::Fibonacci"),
    ],
)
def test_type_that_begins_with_a_small_letter(model, kind, type_, meant):
    """ROS 2 has none, though texts may look like one; ROS 1 has a few, such as tf/tfMessage."""
    item = interface(kind, "x", type_).replace("/>", ' description="std_msgs/msg/string"/>')
    text = refusal(model, spec(node(item)), "kilted")
    assert text.startswith(f'spec.xml:3: <{kind} name="x">: type: "{type_}": a type begins')
    assert text.endswith(f'with a capital; did you mean "{meant}"? [type-without-capital]')
    (note,) = context(model, spec(node(item)), "noetic")["notes"]
    said = f'"{type_}" begins with a small letter; is "{meant}" meant?'
    assert note == f'<{kind} name="x">: {said} [type-without-capital]'


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_small_type_that_is_a_keyword(distro):
    text = refusal(
        "python_model", spec(node(interface("publisher", "x", "std_msgs/bool"))), distro
    )
    said = 'type: "std_msgs/bool": a type begins with a capital; did you mean "std_msgs/Bool"?'
    assert text.endswith(f"{said} [type-without-capital]")


def test_small_type_that_ros1_has():
    xml = spec(node(interface("publisher", "x", "tf/tfMessage")))
    assert "the nearest it has is tf2_msgs::TFMessage" in refusal("python_model", xml, "kilted")
    context("python_model", xml, "noetic")


@pytest.mark.parametrize(
    ("kind", "type_", "says"),
    [
        ("serviceServer", "std_msgs/String", "std_msgs has messages alone, no services"),
        ("actionServer", "geometry_msgs/Pose", "geometry_msgs has messages alone, no actions"),
        ("publisher", "std_srvs/Trigger", "std_srvs has services alone, no messages"),
    ],
)
def test_type_of_a_kind_that_its_package_lacks(kind, type_, says):
    text = refusal("python_model", spec(node(interface(kind, "x", type_))))
    assert text.endswith(f'<{kind} name="x">: type: {says} [wrong-kind-of-type]')


@pytest.mark.parametrize("text", ["std_msgs/srv/String", "std_msgs/msg/Time"])
def test_text_that_looks_like_a_type(text):
    one = parameter("p", type_="string", value=text)
    other = f'<publisher name="x" type="std_msgs/String" description="{text}"/>'
    context("python_model", spec(node(one, other)))


@pytest.mark.parametrize("model", MODELS)
def test_numbers_of_dynamic_reconfigure(model):
    xml = spec(node(parameter("p", "dynParameter", "int", "3000000000")))
    context(model, xml, "kilted")
    assert "32 bits" in refusal(model, xml, "noetic")


@pytest.mark.parametrize("frequency", ["5e-324", "1e300"])
def test_frequency_that_no_clock_keeps(frequency):
    text = refusal(
        "python_model", spec(node()).replace('frequency="1"', f'frequency="{frequency}"')
    )
    assert "frequency: " in text


def test_names_of_another_model(tmp_path):
    (tmp_path / "dictionary.yaml").write_text("""
arm_attributes: [label]
arm_interface: {joint: [{name: {unique: true}}], hand: [name]}
names:
  file: {reserved: [README], arm: ["{label}"], joint: ["{arm[label]}_{name}"]}
  motor: {in: arm, joint: ["{name}"], hand: ["{name:shout}"]}
""")
    functions = tmp_path / "functions.py"
    functions.write_text("def shout(word):\n    return word.upper()\n")
    model = Model(tmp_path, tmp_path)

    def says(*inside):
        xml = '<package name="pkg">\n' + "\n".join(inside) + "\n</package>"
        try:
            model.context(xml.encode(), "spec.xml", "kilted")
        except SpecError as error:
            return str(error)
        return ""

    assert says('<arm label="a"><joint name="b"/></arm>', '<arm label="b"/>') == ""
    assert says('<arm label="a"><joint name="b"/></arm>', '<arm label="a_b"/>').startswith(
        'spec.xml:3: <arm label="a_b">: makes the file "a_b", as <joint name="b"> at line 2 does'
    )
    assert '"README" is reserved as file' in says('<arm label="README"/>')
    assert 'the motor "B"' in says('<arm label="a"><joint name="B"/><hand name="b"/></arm>')
    assert (
        says('<arm label="a"><joint name="B"/></arm>', '<arm label="c"><hand name="b"/></arm>')
        == ""
    )
    functions.write_text("")
    model = Model(tmp_path, tmp_path)
    assert "names: motor" in says('<arm label="a"><hand name="b"/></arm>')


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("names: {file: [a]}", "names: file: must be a mapping"),
        ("names: {file: {nod: [a]}}", 'did you mean "node"?'),
        ("names: {file: {in: nod, node: [a]}}", 'did you mean "node"?'),
    ],
)
def test_fault_in_the_names_of_a_dictionary(tmp_path, text, message):
    (tmp_path / "dictionary.yaml").write_text(f"node_interface: {{topic: [name]}}\n{text}\n")
    with pytest.raises(SpecError) as error:
        Model(tmp_path, tmp_path)
    assert message in str(error.value)


@pytest.mark.parametrize("model", MODELS)
def test_names_that_an_attribute_makes(model):
    """Only where it is given: a topic may be heard twice, if one callback at most is late_x."""
    late = '<{} name="x" type="std_msgs::String" deadline="0.5"/>'
    heard = interface("directSubscriber", "x", None), interface("subscriber", "x", None)
    context(model, spec(node(*heard)))
    context(model, spec(node(heard[0], late.format("subscriber"))))
    text = refusal(model, spec(node(late.format("directSubscriber"), late.format("subscriber"))))
    assert 'makes the method of the logic "late_x", as <directSubscriber name="x">' in text
    text = refusal(model, spec(node(late.format("subscriber"), '<thread name="late_x"/>')))
    assert '"late_x"' in text
    context(model, spec(node(heard[1], '<thread name="late_x"/>')))


def test_container_of_the_launch_file_keeps_its_name():
    text = refusal("cpp_model", spec(node(name="arm_container")))
    assert text.startswith("spec.xml:2: ")
    assert '"arm_container"' in text
    context("cpp_model", spec(node(name="container")))
    context("python_model", spec(node(name="arm_container")))


def test_package_of_a_type_that_a_namespace_hides():
    """In C++ the types of a node stand in a namespace of its own, within that of the package."""
    inside = interface("publisher", "x", "n_types::Foo")
    assert "spec.xml:3: <publisher" in refusal("cpp_model", spec(node(inside)))
    context("cpp_model", spec(node(inside, name="m")))
    context("python_model", spec(node(inside)))


@pytest.mark.parametrize("model", MODELS)
def test_parameter_that_dynamic_reconfigure_overwrites(model):
    inside = parameter("groups", "dynParameter")
    assert "spec.xml:3: <dynParameter" in refusal(model, spec(node(inside)), "noetic")
    context(model, spec(node(inside)))


@pytest.mark.parametrize(
    ("elements", "fault"),
    [
        (
            [("publisher", "x", None), ("subscriber", "/x", "std_msgs::Int64")],
            "topic /x is of type std_msgs/msg/String in this node already",
        ),
        (
            [("serviceServer", "~/x", None), ("serviceClient", "n/x", "std_srvs::SetBool")],
            "service /n/x is of type std_srvs/srv/Trigger in this node already",
        ),
        ([("publisher", "/rosout", None)], "topic /rosout is of type rcl_interfaces/msg/Log"),
        (
            [("publisher", "~/transition_event", None)],
            "msg/TransitionEvent in every node",
        ),
        ([("directSubscriber", "tf", None)], "tf2_msgs/msg/TFMessage in every node"),
        ([("serviceServer", "n/get_parameters", None)], "rcl_interfaces/srv/GetParameters"),
    ],
)
@pytest.mark.parametrize("model", MODELS)
def test_name_with_two_types_in_a_node(model, elements, fault):
    """A node with it cannot be configured; two nodes with it cannot connect, which is a note."""
    text = refusal(model, spec(node(*(interface(*element) for element in elements))))
    assert fault in text
    assert text.startswith(f"spec.xml:{2 + len(elements)}: ")


def test_what_every_node_has_can_be_used():
    inside = [
        interface("publisher", "/rosout", "rcl_interfaces::Log"),
        interface("directSubscriber", "/tf", "tf2_msgs::TFMessage"),
        interface("serviceClient", "/n/change_state", "lifecycle_msgs::ChangeState"),
        interface("serviceClient", "/change_state", "std_srvs::Trigger"),
    ]
    context("python_model", spec(node(*inside)))
