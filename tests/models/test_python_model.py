"""python_model rendered over its choices, without ROS."""

import ast
import xml.etree.ElementTree as ET

import pytest
import yaml

from support.packages import DISTROS, SPECS, files
from support.soundness import check_imports, check_sound


@pytest.mark.parametrize("distro", ["noetic", "humble", "lyrical"])
@pytest.mark.parametrize("name", SPECS)
def test_rendered_code_is_sound(render, name, distro):
    check_sound(render(SPECS[name], ros_distro=distro))


@pytest.mark.parametrize("name", SPECS)
def test_logic_is_the_same_for_all_ros(render, name):
    packages = [
        render(SPECS[name], ros_distro=distro, name=f"{distro}/same") for distro in DISTROS
    ]
    first, *others = [
        {file.name: file.read_bytes() for file in files(package, "*_impl.py")}
        for package in packages
    ]
    assert first
    assert all(other == first for other in others)


def test_values_arrive_as_they_are(render):
    """A string value of the spec is the same in the code, the parameter file and the answers."""
    package = render(SPECS["hostile"])
    root = ET.parse(SPECS["hostile"]).getroot()
    written = {p.get("name"): p.get("value") for p in root.iter("parameter")}
    interface = ast.parse((package / "hostile/first_one_interface.py").read_text())
    config = next(n for n in interface.body if getattr(n, "name", "") == "FirstOneConfig")
    code = {
        n.target.id: ast.literal_eval(n.value) for n in config.body if isinstance(n, ast.AnnAssign)
    }
    parameters = yaml.safe_load((package / "config/first_one.yaml").read_text())
    parameters = parameters["/**"]["ros__parameters"]
    assert code["text"] == parameters["text"] == written["text"]
    assert "{{ z }}" in code["text"]
    assert code["words"][1] == parameters["words"][1] == 'a "b"'
    assert code["huge"] == parameters["huge"] == 1e22
    assert code["big"] == parameters["big"] == -(2**63)


def test_dependencies_follow_the_ros(render):
    def depends(distro):
        package = render(SPECS["paper"], ros_distro=distro, name=f"{distro}/depends")
        tree = ET.parse(package / "package.xml")
        return {element.text for element in tree.iter() if element.tag.endswith("depend")}

    ros1, ros2 = depends("noetic"), depends("kilted")
    assert {"actionlib", "dynamic_reconfigure", "rospy", "catkin", "contact_msgs"} <= ros1
    assert {"rclpy", "rcl_interfaces", "contact_msgs", "geometry_msgs"} <= ros2
    assert not ros2 & {"actionlib", "actionlib_msgs", "dynamic_reconfigure", "rospy", "catkin"}
    assert "rclpy" not in ros1


def test_readme_shows_every_interface(render):
    package = render(SPECS["all kinds"])
    readme = (package / "README.md").read_text()
    for element in ET.parse(SPECS["all kinds"]).getroot().iter():
        if element.tag not in ("package", "node"):
            assert f"| `{element.get('name')}` |" in readme, element.get("name")
    assert "```mermaid" in readme
    assert 'topic_speed(["speed"]) --> node_worker' in readme


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_package_xml_keeps_to_its_schema(render, distro):
    """REP 149 in the parts that catkin_pkg checks: names, order-free tags, licence, people."""
    tree = ET.parse(render(SPECS["hostile"], ros_distro=distro) / "package.xml").getroot()
    assert tree.get("format") == "3"
    assert tree.findtext("name") == "hostile"
    assert tree.findtext("maintainer") == 'Zoë "O\'Neill" <Łukasz> & Søn'
    assert tree.find("maintainer").get("email") == "zoe@example.org"
    allowed = {
        "name", "version", "description", "maintainer", "license", "buildtool_depend", "depend",
        "exec_depend", "test_depend", "export",
    }  # fmt: skip
    assert {child.tag for child in tree} <= allowed
    paper = ET.parse(render(SPECS["paper"], ros_distro=distro, name="paper") / "package.xml")
    assert paper.findtext("license") == "GPL-3.0-only"


def test_private_names_in_ros1(render):
    """The way that rospy takes them: it would make a global name of `~/empty`."""
    package = render(SPECS["all kinds"], ros_distro="noetic")
    text = (package / "all_kinds/worker_ros.py").read_text()
    assert "'~empty'" in text
    assert "~/" not in text


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("name", SPECS)
def test_every_import_is_a_dependency(render, name, distro):
    """What the code of a package imports stands in its package.xml."""
    check_imports(render(SPECS[name], ros_distro=distro), distro)
