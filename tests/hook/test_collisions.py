"""Names that would be taken twice, or that are reserved where they land, are refused."""

import pytest

from hooks.faults import SpecError
from hooks.model import Model
from support.repository import ROOT

MODELS = {name: Model(ROOT / name, ROOT) for name in ("python_model", "cpp_model")}
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


@pytest.mark.parametrize(
    ("model", "one", "other", "name"),
    [(model, *case) for model in MODELS for case in BOTH] + [("cpp_model", *case) for case in CPP],
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
        *[parameter(name) for name in ("linux", "unix", "NULL", "EOF", "Sequence", "NConfig")],
        *[parameter(name, "dynParameter") for name in ("linux", "M_PI", "autostart")],
        interface("serviceServer", "~/change_state"),
    ],
)
def test_reserved_inside_of_a_node(model, inside):
    assert "spec.xml:3: <" in refusal(model, spec(node(inside)))
    assert "reserved" in refusal(model, spec(node(inside)))


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
    assert 'spec.xml:3: <publisher name="x">: needs arm, which is this package' in text


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
