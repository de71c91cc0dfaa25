"""Messages, services and actions of a package of nodes itself."""

import re

import pytest

from hooks.faults import SpecError
from support.packages import model_of
from support.repository import EXAMPLES

MODELS = ("python_model", "cpp_model", "mixed_model")
ABOUT = 'author="A" author_email="a@example.org" description="d" license="MIT"'
LANGUAGE = {"mixed_model": 'language="python"'}


def spec(inside, model="cpp_model", package="arm"):
    node = f'<node name="reach" frequency="1" {LANGUAGE.get(model, "")}>'
    return f'<package name="{package}" {ABOUT}>\n{inside.format(node=node)}\n</package>'


def context(model, inside, distro="noetic"):
    return model_of(model).context(spec(inside, model).encode(), "spec.xml", distro)


def refusal(model, inside, distro="noetic"):
    with pytest.raises(SpecError) as error:
        context(model, inside, distro)
    return str(error.value)


OWN = """<message name="Grip"><field name="force" type="float64"/></message>
<service name="Reset"/>
<action name="Move"><goal><field name="to" type="Grip"/></goal></action>
{node}<publisher name="grip" type="arm::Grip"/><serviceServer name="reset" type="arm::Reset"/>
<actionServer name="move" type="arm/action/Move"/></node>"""


@pytest.mark.parametrize("model", MODELS)
def test_node_has_the_types_of_its_package(model):
    made = context(model, OWN)
    assert [each["name"] for each in made["messages"]] == ["Grip"]
    assert made["nodes"][0]["publishers"][0]["type"] == "arm/msg/Grip"
    assert {"actionlib_msgs", "std_msgs"} <= {*made["depends"]}
    assert "arm" not in made["depends"]


def test_types_of_ros_2():
    inside = """<message name="Grip"><field name="age" type="duration"/></message>
<action name="Move"/>{node}</node>"""
    assert {"action_msgs", "builtin_interfaces"} <= {
        *context("cpp_model", inside, "kilted")["depends"]
    }


@pytest.mark.parametrize("model", ["python_model", "mixed_model"])
@pytest.mark.parametrize("tag", ["message", "service", "action"])
def test_package_with_python_has_none_in_ros_2(model, tag):
    """Its build installs a Python package of the name that rosidl's has."""
    text = refusal(model, f'<{tag} name="Grip"/>{{node}}</node>', "kilted")
    what = "in ROS 2 a package with Python has no types of its own; make one of interfaces_model"
    assert text == f'spec.xml:2: <{tag} name="Grip">: {what} [not-in-ros]'


@pytest.mark.parametrize("model", MODELS)
def test_package_of_types_alone_is_one_of_interfaces_model(model):
    text = refusal(model, '<message name="Grip"/>')
    assert "has no <node>; it needs one at least [missing-tag]" in text


@pytest.mark.parametrize("model", MODELS)
def test_members_are_checked_as_those_of_interfaces_model(model):
    inside = '<message name="Grip"><field name="name" type="wstring"/></message>{node}</node>'
    assert "ROS 1 has no wstring" in refusal(model, inside)


@pytest.mark.parametrize("model", MODELS)
def test_parameters_are_checked_beside_them(model):
    inside = '{node}<dynParameter name="gains" type="double[]" value="[1.0]"/></node>'
    assert "dynamic_reconfigure has no lists" in refusal(model, inside)


@pytest.mark.parametrize(
    ("model", "distro"), [*((model, "noetic") for model in MODELS), ("cpp_model", "kilted")]
)
def test_type_of_the_name_of_a_class(model, distro):
    text = refusal(model, '<message name="ReachConfig"/>{node}</node>', distro)
    assert 'makes the class "ReachConfig", as <message name="ReachConfig"> at line 2 does' in text


@pytest.mark.parametrize("name", ["Time", "GoalPolicy", "std_msgs", "ros"])
def test_type_of_the_name_of_a_class_or_namespace_of_cpp(name):
    """In ROS 1 both are in the namespace of the package."""
    inside = f'<message name="{name}"/>{{node}}</node>'
    assert f'"{name}"' in refusal("cpp_model", inside)
    context("python_model", inside)


def test_classes_of_the_runtime_are_reserved():
    folder = EXAMPLES / "all_kinds/cpp_model/noetic"
    files = [*folder.glob("src/ros/*.hpp"), *folder.glob("include/*/ros/*.hpp")]
    texts = "\n".join(file.read_text() for file in files)
    found = {*re.findall(r"^(?:class|struct|enum class|using) (\w+)", texts, re.MULTILINE)}
    assert len(found) > 20
    for name in found:
        assert f'"{name}"' in refusal("cpp_model", f'<message name="{name}"/>{{node}}</node>')
