"""A move to another ROS: what the developer has tuned comes along, or is listed."""

import re
from xml.etree import ElementTree

import pytest
import yaml

from support.packages import changed
from support.repository import commit, git

ABOUT = 'author="A" author_email="a@example.org" license="MIT"'
NODE = """<node name="{0}" frequency="10"{1}>
    <publisher name="pose" type="std_msgs::Float64"/>
    <parameter name="frame" type="string" value="map" description="The frame"/>
    <parameter name="axis.x" type="int" value="1"/>
    <parameter name="gains" type="double[]" value="[1.0, 2.0]"/>
    <dynParameter name="limit" type="double" value="1.0" description="Limit, m/s"/>
  </node>"""
SPECS = {
    "python_model": NODE.format("think", ""),
    "cpp_model": NODE.format("think", ""),
    "mixed_model": NODE.format("think", ' language="python"')
    + NODE.format("act", ' language="cpp"'),
    "interfaces_model": '<message name="Grip"><field name="force" type="float64"/></message>'
    '<service name="Hold"/>',
}
SPECS = {
    model: f'<package name="hand" description="Grips" {ABOUT}>{inside}</package>'
    for model, inside in SPECS.items()
}
MODELS = [model for model in SPECS if model != "interfaces_model"]
OTHER = {"noetic": "kilted", "kilted": "noetic"}
each_way = pytest.mark.parametrize("distro", OTHER)


@pytest.fixture
def move(copier_command):
    """Commit, move to another ROS, commit; return what was said."""

    def run(package, distro, *options):
        commit(package, "Edit")
        option = f"ros_distro={distro}"
        command = ("update", "--trust", "--defaults", "-d", option, *options)
        result = copier_command(*command, cwd=package)
        assert result.returncode == 0, result.stderr
        assert "CONFLICT" not in result.stderr, result.stderr
        commit(package, f"Move to {distro}")
        return result.stderr

    return run


def change(package, path, *pairs):
    file = package / path
    file.write_text(changed(file.read_text(), *pairs))


def left(said):
    """Return the lines that were left behind: file, first number, text."""
    return re.findall(r"^left +(\S+?):(\d+)\S*: (.*?)      \(git show", said, re.MULTILINE)


@each_way
@pytest.mark.parametrize("model", MODELS)
def test_what_cannot_move_is_listed(render, move, model, distro):
    """By file and number of before, with the command that shows it; not the model's own lines."""
    package = render(SPECS[model], model=model, ros_distro=distro, name="hand")
    launch = "launch/hand.launch" + (".xml" if distro == "kilted" else "")
    odd = "  <group if=\"$(eval '1 + 1 == 2')\"><odd/></group>\n"
    change(package, launch, ("</launch>", odd + "</launch>"))
    number = (package / launch).read_text().split("\n").index(odd.rstrip()) + 1
    said = move(package, OTHER[distro])
    assert (launch, str(number), odd.strip()) in left(said)
    assert len(left(said)) == 1
    shown = re.search(r"left .*\(git show (\S+)\)", said)[1]
    assert odd.rstrip() in git(package, "show", shown).split("\n")
    assert "1 left with what was removed" in said


def test_lines_of_the_developer_in_what_was_removed_are_listed(arm, update_with):
    said = update_with(('<serviceServer name="load" type="std_srvs::Trigger"/>', ""))
    (found,) = left(said)
    assert found[0] == "arm/reach_impl.py"
    assert found[2] == "response.message = 'loaded'"


def tune(package, distro):
    """Tune the parameters of every node as developers do; return the values."""
    for file in sorted((package / "config").glob("*.yaml")):
        change(
            package,
            f"config/{file.name}",
            ('frame: "map"', "frame: odom  # of the wheels"),
            ("x: 1", "x: 7  # not y"),
            ("gains: [1.0, 2.0]", "# Measured on Monday\ngains:\n- 3.0\n- 4.5"),
            ("# Limit, m/s", "# Limit, m/s, as the law has it"),
            ("limit: 1.0", "limit: 3.25"),
            ("stop_timeout: 2.0", "stop_timeout: 0.5\n\nown:\n  text: |\n    two\n      lines"),
        )
        text = file.read_text()
        margin = "    " if distro == "kilted" else ""
        for own in ("gains", "- 3", "- 4", "own:", "  text", "    two", "      lines"):
            text = text.replace(f"\n{own}", f"\n{margin}{own}")
        file.write_text(text)
    return values(package, distro)


def values(package, distro):
    found = {}
    for file in sorted((package / "config").glob("*.yaml")):
        content = yaml.safe_load(file.read_text().replace("axis/x:", "axis.x:"))
        found[file.name] = content["/**"]["ros__parameters"] if distro == "kilted" else content
    return found


@each_way
@pytest.mark.parametrize("model", MODELS)
def test_tuned_values_move_along(render, move, model, distro):
    package = render(SPECS[model], model=model, ros_distro=distro, name="hand")
    tuned = tune(package, distro)
    assert (tuned["think.yaml"]["limit"], tuned["think.yaml"]["axis.x"]) == (3.25, 7)
    texts = {file: file.read_text() for file in (package / "config").iterdir()}
    said = move(package, OTHER[distro])
    assert values(package, OTHER[distro]) == tuned
    assert not left(said)
    assert "left with" not in said
    assert "# of the wheels" not in said
    for file in texts:
        assert "as the law has it" in file.read_text()
    move(package, distro)
    assert {file: file.read_text() for file in texts} == texts


@each_way
@pytest.mark.parametrize("model", MODELS)
def test_cell_of_a_table_that_the_developer_has_edited_moves_along(render, move, model, distro):
    """In a row whose type is written otherwise in the other ROS."""
    packages = {
        ros: render(SPECS[model], model=model, ros_distro=ros, name=f"{ros}/hand") for ros in OTHER
    }
    rows = {
        ros: next(re.finditer(r"\| `pose` .*\n", (package / "README.md").read_text()))[0]
        for ros, package in packages.items()
    }
    mine = {ros: row.replace("|  |\n", "| Where it is, m |\n") for ros, row in rows.items()}
    assert len({*rows.values(), *mine.values()}) == 4
    change(packages[distro], "README.md", (rows[distro], mine[distro]))
    said = move(packages[distro], OTHER[distro])
    text = (packages[distro] / "README.md").read_text()
    assert text == changed(
        (packages[OTHER[distro]] / "README.md").read_text(),
        (rows[OTHER[distro]], mine[OTHER[distro]]),
    )
    assert "left with" not in said


LAUNCH = {
    "noetic": """
  <arg name="side" default="left" doc="Which arm"/>
  <!-- The driver of the arm -->
  <include file="$(find arm_driver)/launch/driver.launch" if="$(arg use_sim_time)">
    <arg name="side" value="$(arg side)"/>
  </include>
  <node pkg="rviz2" type="rviz2" name="view" ns="$(arg namespace)" output="log">
    <remap from="a" to="b"/>
  </node>
""",
    "kilted": """
  <arg name="side" default="left" description="Which arm"/>
  <!-- The driver of the arm -->
  <include file="$(find-pkg-share arm_driver)/launch/driver.launch.xml" if="$(var use_sim_time)">
    <arg name="side" value="$(var side)"/>
  </include>
  <node pkg="rviz2" exec="rviz2" name="view" namespace="$(var namespace)" output="log">
    <remap from="a" to="b"/>
  </node>
""",
}
INSIDE = """      <remap from="pose" to="/robot/pose"/>
      <param name="speed" value="2.0"/>
      <env name="SIDE" value="$({} side)"/>
"""
INSIDE = {"noetic": INSIDE.format("arg"), "kilted": INSIDE.format("var")}
LOG_LEVEL = 'name="log_level" default="{}"'


def edit_launch(package, distro):
    path = "launch/hand.launch" + (".xml" if distro == "kilted" else "")
    end = "    </node>\n" if distro == "noetic" else "  </node>\n"
    change(
        package,
        path,
        (LOG_LEVEL.format("info"), LOG_LEVEL.format("debug")),
        (end, INSIDE[distro] + end),
        ("</launch>", LAUNCH[distro] + "</launch>"),
    )


def squeezed(text):
    return " ".join(text.split())


@each_way
@pytest.mark.parametrize("model", MODELS)
def test_what_starts_nodes_moves_along(render, move, model, distro):
    package = render(SPECS[model], model=model, ros_distro=distro, name="hand")
    edit_launch(package, distro)
    other = OTHER[distro]
    paths = {"noetic": "launch/hand.launch", "kilted": "launch/hand.launch.xml"}
    before = (package / paths[distro]).read_text()
    said = move(package, other)
    assert left(said) == []
    text = (package / paths[other]).read_text()
    tree = ElementTree.fromstring(text)
    assert squeezed(INSIDE[other]) in squeezed(text)
    for part in LAUNCH[other].split("\n  <"):
        assert squeezed(part) in squeezed(text), part
    assert LOG_LEVEL.format("debug") in text
    args = [child.get("name") for child in tree if child.tag == "arg"]
    assert args[-1] == "side"
    nodes = [node.get("name") for node in tree.iter("node")]
    assert nodes.index("think") < nodes.index("view")
    number = len(re.findall(r"of your lines", said))
    assert number == 1
    said = move(package, distro)
    assert left(said) == []
    again = (package / paths[distro]).read_text()
    assert set(map(str.strip, again.split("\n"))) == set(map(str.strip, before.split("\n")))
    both = distro == "kilted" and model == "cpp_model"  # in a process of its own, and composed
    assert again.count('<remap from="pose"') == 1 + both
    assert again.count("<env ") == 1


CMAKE = {
    "noetic": (
        ("  roscpp\n", "  roscpp\n  tf2_geometry_msgs\n"),
        (
            "\ncatkin_package(",
            "\nfind_package(Eigen3 REQUIRED)\nset(LIMIT 3)\n"
            "add_library(${PROJECT_NAME}_core src/core.cpp)  # ours\n"
            "target_link_libraries(${PROJECT_NAME}_core Eigen3::Eigen)\n\ncatkin_package(",
        ),
        ("  src/think_ros.cpp\n", "  src/think_ros.cpp\n  src/helper.cpp\n"),
        ("  ${catkin_LIBRARIES}\n", "  ${catkin_LIBRARIES}\n  ${PROJECT_NAME}_core\n"),
        ("    launch\n", "    launch\n    maps\n"),
        (
            "\nif(CATKIN_ENABLE_TESTING)",
            "\n# For pluginlib\ninstall(FILES plugin.xml\n"
            "  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})\n"
            "install(PROGRAMS scripts/tool DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"
            "catkin_add_env_hooks(50.hand)\n\nif(CATKIN_ENABLE_TESTING)",
        ),
    ),
    "kilted": (
        (
            "find_package(rclcpp REQUIRED)\n",
            "find_package(rclcpp REQUIRED)\nfind_package(tf2_geometry_msgs REQUIRED)\n"
            "find_package(Eigen3 REQUIRED)\nset(LIMIT 3)\n"
            "add_library(${PROJECT_NAME}_core src/core.cpp)  # ours\n"
            "target_link_libraries(${PROJECT_NAME}_core Eigen3::Eigen)\n",
        ),
        ("  src/think_ros.cpp\n", "  src/think_ros.cpp\n  src/helper.cpp\n"),
        (
            "  PUBLIC\n    ${std",
            "  PUBLIC\n    ${PROJECT_NAME}_core\n    ${tf2_geometry_msgs_TARGETS}\n    ${std",
        ),
        ("    launch\n", "    launch\n    maps\n"),
        (
            "\nif(BUILD_TESTING)",
            "\n# For pluginlib\ninstall(FILES plugin.xml\n  DESTINATION share/${PROJECT_NAME})\n"
            "install(PROGRAMS scripts/tool DESTINATION lib/${PROJECT_NAME})\n"
            "ament_python_install_module(tool.py)\n\nif(BUILD_TESTING)",
        ),
    ),
}
WANTED = {
    "noetic": (
        r"COMPONENTS\n[^)]*  tf2_geometry_msgs\n[^)]*\)[\s\S]*?\nfind_package\(Eigen3 REQUIRED\)",
        r"\nset\(LIMIT 3\)\n[\s\S]*\ncatkin_package\([\s\S]*add_library\(\$\{PROJECT_NAME\}_core",
        r"\nadd_executable\(\$\{PROJECT_NAME\}_think\n[^)]*  src/helper.cpp\n",
        r"target_link_libraries\(\$\{PROJECT_NAME\}_think\n[^)]*  \$\{PROJECT_NAME\}_core\n",
        r"    launch\n    maps\n  DESTINATION \$\{CATKIN_PACKAGE_SHARE_DESTINATION\}",
        r"# For pluginlib\ninstall\(FILES plugin.xml\n  DESTINATION \$\{CATKIN_PACKAGE_SHARE_DEST",
        r"install\(PROGRAMS scripts/tool DESTINATION \$\{CATKIN_PACKAGE_BIN_DESTINATION\}\)",
    ),
    "kilted": (
        r"\nfind_package\(ament_cmake REQUIRED\)\n[\s\S]*\nfind_package\(tf2_geometry_msgs REQ",
        r"\nfind_package\(std_msgs REQUIRED\)\n[\s\S]*\nfind_package\(Eigen3 REQUIRED\)\nset\(LIM",
        r"\nadd_library\(\$\{PROJECT_NAME\}_think SHARED\n[^)]*  src/helper.cpp\n",
        r"PUBLIC\n[^)]*    \$\{PROJECT_NAME\}_core\n",
        r"PUBLIC\n[^)]*    \$\{tf2_geometry_msgs_TARGETS\}\n",
        r"\ntarget_link_libraries\(\$\{PROJECT_NAME\}_core Eigen3::Eigen\)\n[\s\S]*if\(BUILD_TES",
        r"    launch\n    maps\n    nodl\n  DESTINATION share/\$\{PROJECT_NAME\}",
        r"# For pluginlib\ninstall\(FILES plugin.xml\n  DESTINATION share/\$\{PROJECT_NAME\}\)",
        r"install\(PROGRAMS scripts/tool DESTINATION lib/\$\{PROJECT_NAME\}\)[\s\S]*ament_package",
    ),
}


@each_way
@pytest.mark.parametrize("model", ["cpp_model", "mixed_model"])
def test_what_is_built_and_installed_moves_along(render, move, model, distro):
    """Below what it uses; nothing is in the file that its ROS does not know."""
    spec = SPECS[model].replace('"act"', '"idle"').replace('"think"', '"act"', 1)
    spec = spec.replace('"idle"', '"think"') if model == "mixed_model" else SPECS[model]
    package = render(spec, model=model, ros_distro=distro, name="hand")
    fresh = render(spec, model=model, ros_distro=OTHER[distro], name="other/hand")
    change(package, "CMakeLists.txt", *CMAKE[distro])
    said = move(package, OTHER[distro])
    text = (package / "CMakeLists.txt").read_text()
    for wanted in WANTED[OTHER[distro]]:
        assert re.search(wanted, text), f"{wanted} is not in {text}"
    ((_, _, behind),) = left(said)
    assert behind.startswith(("catkin_add_env_hooks", "ament_python_install_module"))
    lines = text.split("\n")
    for line in (fresh / "CMakeLists.txt").read_text().split("\n"):
        assert line in lines
    said = move(package, distro)
    assert left(said) == []
    again = (package / "CMakeLists.txt").read_text()
    for wanted in WANTED[distro]:
        assert re.search(wanted, again), f"{wanted} is not in {again}"


@each_way
def test_what_a_package_in_python_installs_moves_along(render, move, distro):
    package = render(SPECS["python_model"], ros_distro=distro, name="hand")
    if distro == "noetic":
        change(package, "CMakeLists.txt", *CMAKE["noetic"][-2:])
    else:
        entry = "        *installed('launch'),\n"
        own = entry.replace("launch", "maps")
        own += "        ('share/' + package_name + '/urdf', glob('urdf/*')),\n"
        own += "        ('share/' + package_name, ['plugin.xml']),\n"
        own += "        ('lib/' + package_name, ['scripts/tool']),\n        ('/etc', ['odd']),\n"
        change(package, "setup.py", (entry, entry + own))
    said = move(package, OTHER[distro])
    texts = [text for _, _, text in left(said)]
    if distro == "noetic":
        assert texts == ["# For pluginlib", "catkin_add_env_hooks(50.hand)"]
        setup = (package / "setup.py").read_text()
        for entry in (
            "*installed('maps'),",
            "('share/' + package_name, ['plugin.xml']),",
            "('lib/' + package_name, ['scripts/tool']),",
        ):
            assert f"        {entry}\n" in setup
    else:
        assert texts == ["('/etc', ['odd']),"]
        cmake = (package / "CMakeLists.txt").read_text()
        assert "    launch\n    maps\n    urdf\n" in cmake
        share, programs = ("${CATKIN_PACKAGE_" + place for place in ("SHARE", "BIN"))
        assert f"install(FILES plugin.xml DESTINATION {share}_DESTINATION}})\n" in cmake
        assert f"install(PROGRAMS scripts/tool DESTINATION {programs}_DESTINATION}})\n" in cmake
    assert left(move(package, distro)) == []


@each_way
@pytest.mark.parametrize("with_service", [True, False])
def test_own_messages_are_built_after_a_move(render, move, distro, with_service):
    """Of kinds that the spec does not have, too."""
    spec = SPECS["interfaces_model"]
    spec = spec if with_service else spec.replace('<service name="Hold"/>', "")
    package = render(spec, model="interfaces_model", ros_distro=distro, name="hand")
    (package / "srv").mkdir(exist_ok=True)
    for path in ("msg/Own.msg", "srv/Mine.srv"):
        (package / path).write_text("---\n" if path.endswith("srv") else "std_msgs/Header head\n")
    if distro == "noetic":
        services = ("    Hold.srv\n", "    Hold.srv\n    Mine.srv\n")
        if not with_service:
            own = "add_service_files(\n  FILES\n    Mine.srv\n)\n\n"
            services = ("generate_messages(", own + "generate_messages(")
        change(
            package,
            "CMakeLists.txt",
            ("  message_generation\n", "  message_generation\n  std_msgs\n"),
            ("    Grip.msg\n", "    Grip.msg\n    Own.msg\n"),
            services,
            ("generate_messages(\n", "generate_messages(\n  DEPENDENCIES\n    std_msgs\n"),
            ("    message_runtime\n", "    message_runtime\n    std_msgs\n"),
        )
    else:
        change(
            package,
            "CMakeLists.txt",
            ("generators REQUIRED)\n", "generators REQUIRED)\nfind_package(std_msgs REQUIRED)\n"),
            ("  msg/Grip.msg\n", "  msg/Grip.msg\n  msg/Own.msg\n"),
            (")\n\nament_exp", "  srv/Mine.srv\n  DEPENDENCIES\n    std_msgs\n)\n\nament_exp"),
            ("_default_runtime\n", "_default_runtime\n  std_msgs\n"),
        )
    for target in (OTHER[distro], distro):
        said = move(package, target)
        assert left(said) == []
        assert "unnamed" not in said
        text = (package / "CMakeLists.txt").read_text()
        if target == "noetic":
            assert re.search(r"add_message_files\([^)]*\n    Own.msg\n", text)
            assert re.search(r"add_service_files\([^)]*\n    Mine.srv\n[\s\S]*generate_m", text)
            assert re.search(r"generate_messages\(\s+DEPENDENCIES\n    std_msgs\n", text)
            assert re.search(r"COMPONENTS\n[^)]*  std_msgs\n", text)
            assert re.search(r"CATKIN_DEPENDS\n[^)]*    std_msgs\n", text)
        else:
            files = r"rosidl_generate_interfaces\([^)]*  msg/Own.msg\n"
            assert re.search(files, text)
            assert re.search(r"interfaces\([^)]*  srv/Mine.srv\n[^)]*DEPEND", text)
            assert re.search(r"\nfind_package\(std_msgs REQUIRED\)\n[\s\S]*rosidl_generate", text)
            assert re.search(r"DEPENDENCIES\n    std_msgs\n\)", text)
            assert re.search(r"dependencies\([^)]*  std_msgs\n", text)


@each_way
def test_own_group_and_deleted_elements_are_said(render, move, distro):
    """What is around a generated element makes no second one of it; what was deleted is back."""
    package = render(SPECS["python_model"], ros_distro=distro, name="hand")
    path, other = "launch/hand.launch", "launch/hand.launch.xml"
    path, other = (path, other) if distro == "noetic" else (other, path)
    text = (package / path).read_text()
    node = re.search(r"(?m)^ *<node [\s\S]*?</node>\n", text)[0]
    level = re.search(r"(?m)^ *<arg name=.log_level. default.*\n", text)[0]
    var = "arg" if distro == "noetic" else "var"
    own = f'  <group if="$({var} use_sim_time)">\n{node}  </group>\n'
    change(package, path, (node, own), (level, ""))
    (package / path).write_bytes((package / path).read_text().replace("\n", "\r\n").encode())
    said = move(package, OTHER[distro])
    assert (package / other).read_text().count('name="think"') == 1
    assert [text for _, _, text in left(said)] == [own.split("\n")[0].strip(), "</group>"]
    assert f"back      {other}: arg log_level, which you had deleted" in said
