"""python_model rendered over its choices, without ROS."""

import ast
import re
import runpy
import sys
import types
import xml.etree.ElementTree as ET
import xmlrpc.client
from xml.sax.saxutils import quoteattr

import pytest
import yaml

from support.linters import ruff_faults
from support.packages import DISTROS, MODELS, SPECS, files
from support.soundness import check_sound

ALONE = """<package name="arm" author="A" author_email="a@example.org" description="d"
         license="MIT"><node name="reach" {}/></package>"""


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


def test_parameter_file_has_what_ros1_can_store(render):
    """The server of parameters speaks XML-RPC; of a wider integer the node has the default."""
    package = render(SPECS["hostile"], ros_distro="noetic")
    parameters = yaml.safe_load((package / "config/first_one.yaml").read_text())
    assert xmlrpc.client.dumps((parameters,))
    assert {"huge", "counts"} <= parameters.keys()
    assert not {"big", "stamps"} & parameters.keys()


@pytest.mark.parametrize(
    ("distro", "ending"), [("noetic", "launch"), ("kilted", "launch.xml")], ids=["ros1", "ros2"]
)
@pytest.mark.parametrize("model", MODELS)
def test_readme_names_the_arguments_of_the_launch_file(render, model, distro, ending):
    package = render(SPECS["paper"], model=model, ros_distro=distro)
    (launch_file,) = files(package, f"*.{ending}")
    arguments = [item.get("name") for item in ET.parse(launch_file).getroot().findall("arg")]
    text = (package / "README.md").read_text()
    sentence = re.search(r"^The launch file takes (.*?)\.$", text, re.DOTALL | re.MULTILINE)[1]
    assert re.findall(r"`(\w+)`", sentence) == arguments
    assert ("autostart" in arguments) == (distro == "kilted")
    assert ("composition" in arguments) == ((model, distro) == ("cpp_model", "kilted"))


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


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_runtime_of_a_node_with_diagnostics_alone_is_whole(render, distro):
    package = render(ALONE.format('diagnostics="true"'), ros_distro=distro)
    assert "time.wait_for_start()" in (package / "arm/ros/loop.py").read_text()
    assert "def wait_for_start(" in (package / "arm/ros/ros_time.py").read_text()


def test_script_with_the_ending_of_python_has_the_layout_of_ruff(render):
    package = render(ALONE.format('executable="reach.py"'), ros_distro="noetic")
    assert (package / "scripts/reach.py").is_file()
    assert ruff_faults(package) == ""


def test_readme_shows_every_interface(render):
    package = render(SPECS["all kinds"])
    readme = (package / "README.md").read_text()
    for element in ET.parse(SPECS["all kinds"]).getroot().iter():
        if element.tag not in ("package", "node"):
            parameter = element.get("topic_parameter")
            name = f"`{element.get('name')}`"
            name += f", by the name in `{parameter}`" if parameter else ""
            listed = element.get("for_each")
            name += f", by each name in `{listed}`" if listed else ""
            assert f"| {name} |" in readme, name
    assert "```mermaid" in readme
    assert 'topic_speed(["speed"]) --> node_worker' in readme


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_readme_says_what_a_node_does_beside_its_interfaces(render, distro):
    """What becomes of a new goal, and what is published on /diagnostics."""
    action = '    <actionServer name="{0}" goal="{0}" type="test_msgs::Fibonacci"/>\n'
    actions = "".join(map(action.format, ("replace", "queue", "reject", "parallel")))
    spec = SPECS["all kinds"].read_text()
    spec = re.sub(r"(<node )(.*?>\n)", rf"\1\2{actions}", spec, count=1)
    text = (render(spec, ros_distro=distro) / "README.md").read_text()
    assert "state, rate, late and missed cycles, and what its logic adds, on `/diag" in text
    assert "| `replace` | action served; a new goal replaces the current one |" in text
    assert "| `queue` | action served; a new goal waits |" in text
    assert "| `reject` | action served; a new goal is rejected |" in text
    assert (
        "| `parallel` | action served; a new goal is executed beside the others, 8 in all |"
        in text
    )


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
    assert "~/" not in text.replace(".replace('~/', '~', 1)", "")


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_copyright_is_no_encoding(render, distro):
    """Python takes `coding: NAME` in the first two lines for the encoding of the file."""
    text = 'author="Encoding: utf-7 +AAo- coding=labs" license="coding:labs"'
    about = f'{text} author_email="a@example.org" description="d"'
    node = '<node name="n" frequency="1"><parameter name="p" type="int" value="1"/></node>'
    package = render(f'<package name="arm" {about}>{node}</package>', ros_distro=distro)
    sources = [*package.rglob("*.py"), *package.glob("scripts/*")]
    assert len(sources) > 5
    for file in sources:
        compile(file.read_bytes(), file, "exec")


def test_node_with_a_door_to_rospy_alone_imports_it(render):
    """No topic of its own needs it."""
    spec = """<package name="pkg" author="A" author_email="a@example.org" license="MIT"
                       description="d"><node name="n" client_library="true"/></package>"""
    package = render(spec, ros_distro="noetic", name="pkg")
    assert "\nimport rospy\n" in (package / "pkg/n_ros.py").read_text()


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_folders_of_the_developer_are_installed(render, monkeypatch, distro):
    """`setup.py` names no folder that a rename of the package would have to find there."""
    package = render(SPECS["hostile"], ros_distro=distro)
    (package / "hostile/own").mkdir()
    (package / "hostile/own/__init__.py").touch()
    given = {}
    monkeypatch.setattr("setuptools.setup", lambda **options: given.update(options))
    catkin = types.SimpleNamespace(generate_distutils_setup=lambda **options: options)
    monkeypatch.setitem(sys.modules, "catkin_pkg", types.ModuleType("catkin_pkg"))
    monkeypatch.setitem(sys.modules, "catkin_pkg.python_setup", catkin)
    monkeypatch.chdir(package)
    runpy.run_path("setup.py")
    assert set(given["packages"]) == {"hostile", "hostile.ros", "hostile.own"}


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
@pytest.mark.parametrize(
    ("type_", "choices", "names"),
    [
        ("string", "[slow, very-fast]", ["p__slow", "p__very_fast"]),
        ("int", "[-1, 2]", ["p___1", "p__2"]),
        ("double", "[0.5, 2]", ["p__0_5", "p__2_0"]),
        ("string", "[a b, a-b]", []),  # no two names
        ("string", "[it's, b]", []),  # dynamic_reconfigure would break the text in C++
        ("string", "['x\\n', b]", []),
        ("string", "[ü, b]", []),
    ],
)
def test_choices_are_offered_by_dynamic_reconfigure(render, model, type_, choices, names):
    value = yaml.safe_load(choices)[1]
    spec = f"""<package name="lab" author="A" author_email="a@b.org" description="d" license="MIT">
  <node name="n" frequency="1"><dynParameter name="p" type="{type_}" value="{value}"
    choices={quoteattr(choices)}/></node></package>"""
    (file,) = (render(spec, model=model, ros_distro="noetic", name="lab") / "cfg").iterdir()
    calls = [each for each in ast.walk(ast.parse(file.read_text())) if isinstance(each, ast.Call)]
    constants = [each.args for each in calls if getattr(each.func, "attr", "") == "const"]
    assert [ast.literal_eval(name) for name, *_ in constants] == names
    assert [ast.literal_eval(each[2]) for each in constants] == yaml.safe_load(choices)[
        : len(names)
    ]


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_tests_of_ros1_give_no_integer_that_it_cannot_store(render, model):
    spec = ALONE.format("").replace(
        "/></package>",
        """><parameter name="size" type="int" value="8589934592" min="0" max="99999999999"/>
        <parameter name="far" type="int" value="8589934592"/></node></package>""",
    )
    package = render(spec, model=model, ros_distro="noetic")
    text = (package / "test/test_reach_node.py").read_text()
    (given,) = re.findall(r"^    parameters = (\{.*?^    \})", text, re.M | re.S)
    values = ast.literal_eval(given)
    assert {name: default for name, (default, *_) in values.items()} == dict.fromkeys(
        values, 2**33
    )
    for name, (_, others, refused) in values.items():
        assert others, name
        assert refused, name
        assert all(-(2**31) <= each < 2**31 for each in others + refused), name
