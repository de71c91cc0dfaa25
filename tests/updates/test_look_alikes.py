"""What only looks like the model's, or like git's, stays the developer's; whole updates."""

import pytest

from support.arm import SPEC
from support.packages import changed
from support.repository import commit

UPDATE = '"""Compute the outputs of one cycle from the latest inputs."""\n'
GOAL = '    <subscriber name="goal" type="std_msgs::Float64"/>\n'
LOAD = '<serviceServer name="load"'
PROBE = '<node name="probe" frequency="2"><publisher name="a" type="std_msgs::Empty"/></node>\n'


@pytest.fixture
def change(render, copier_command):
    """Render, edit files by (old, new) texts, change the spec, update; return what was said."""

    def run(edits, spec, *change_of_spec, model="python_model", options=()):
        package = render(spec, name="arm", model=model)
        for path, edit in edits.items():
            (package / path).write_text(changed((package / path).read_text(), edit))
        (package / "arm.ros_package").write_text(spec.replace(*change_of_spec, 1))
        commit(package, "Edit")
        result = copier_command("update", "--trust", "--defaults", *options, cwd=package)
        assert result.returncode == 0, result.stderr
        assert "Done, without conflicts" in result.stderr, result.stderr
        return package, result.stderr

    return run


def test_underlined_heading_is_no_mark_of_a_conflict(change):
    own = "Gripper\n=======\n\nHow to change it.\n\n## Use\n"
    package, _ = change({"README.md": ("## Use\n", own)}, SPEC, 'frequency="10"', 'frequency="50"')
    assert own in (package / "README.md").read_text()


def test_use_of_what_left_is_said_though_another_node_has_one_of_that_name(change):
    both = SPEC.replace(
        '<node name="watch" frequency="1">\n', f'<node name="watch" frequency="1">\n{GOAL}'
    )
    assert both.count(GOAL) == 2
    use = UPDATE + "        data.out_pose.data = data.in_goal.data\n"
    _, said = change({"arm/reach_impl.py": (UPDATE, use)}, both, GOAL, "")
    assert "in_goal, which has left" in said


@pytest.mark.parametrize(
    "own",
    [
        "\ncamera:\n  ros__parameters:\n    gain: 7\n",
        "    tool:\n      gain: 7\n",
        "    joints:\n      - name: a\n        gain: 7\n",
    ],
    ids=["another node", "a group", "an item"],
)
def test_parameters_of_others_keep_their_names(change, own):
    end = "    stop_timeout: 2.0\n"
    edits = {"config/reach.yaml": (end, end + own)}
    package, _ = change(edits, SPEC, 'name="gain"', 'name="kp" was="gain"')
    text = (package / "config/reach.yaml").read_text()
    assert own in text
    assert "\n    kp: " in text


@pytest.mark.parametrize("top", ["reach", "/left/reach"])
def test_parameter_of_a_node_that_was_named_takes_the_new_name(change, top):
    edits = {"config/reach.yaml": ("/**:", f"{top}:")}
    package, _ = change(edits, SPEC, 'name="gain"', 'name="kp" was="gain"')
    assert "\n    kp: " in (package / "config/reach.yaml").read_text()


def test_node_of_another_package_keeps_its_name_in_a_launch_file(change):
    own = '  <node pkg="vendor" exec="driver" name="reach" namespace="left"/>\n'
    edits = {"launch/arm.launch.xml": ("</launch>", own + "</launch>")}
    package, _ = change(edits, SPEC, 'name="reach"', 'name="grasp" was="reach"')
    assert own in (package / "launch/arm.launch.xml").read_text()


@pytest.mark.parametrize("base", ["", "(list)"])
def test_method_of_another_class_keeps_its_name(change, base):
    method = "    def serve_load(self, n):\n        return n or self.serve_load(1)\n\n\n"
    own = f"class Loader{base}:\n{method}"
    edits = {"arm/reach_impl.py": ("class ReachImpl:", own + "class ReachImpl:")}
    package, _ = change(edits, SPEC, LOAD, '<serviceServer name="grab" was="load"')
    assert own in (package / "arm/reach_impl.py").read_text()


def test_method_that_has_the_new_name_already_is_said(change):
    """Python knows the later one alone."""
    method = "    def serve_grab(self, n):\n        return n + 1\n\n"
    edits = {"arm/reach_impl.py": ("    def deactivate", method + "    def deactivate")}
    package, said = change(edits, SPEC, LOAD, '<serviceServer name="grab" was="load"')
    text = (package / "arm/reach_impl.py").read_text()
    assert method in text
    assert text.count("def serve_grab(") == 2
    assert "yours     arm/reach_impl.py: serve_grab, which the model makes now, too" in said


def test_property_of_a_class_that_is_renamed_is_no_method_twice(change):
    own = (
        "    @property\n    def a(self):\n        return 1\n\n    @a.setter\n    def a(self, b):\n"
    )
    own += "        use(b)\n\n"
    edits = {"arm/reach_impl.py": ("    def deactivate", own + "    def deactivate")}
    package, said = change(edits, SPEC, 'name="reach"', 'name="grasp" was="reach"')
    assert own in (package / "arm/grasp_impl.py").read_text()
    assert "yours" not in said


def test_method_of_a_base_of_the_logic_takes_the_new_name(change):
    own = "class Loader:\n    def serve_load(self, request):\n        return None\n\n\n"
    edits = {"arm/reach_impl.py": ("class ReachImpl:", own + "class ReachImpl(Loader):")}
    package, _ = change(edits, SPEC, LOAD, '<serviceServer name="grab" was="load"')
    assert own.replace("load", "grab") in (package / "arm/reach_impl.py").read_text()


@pytest.mark.parametrize(
    "own",
    [
        "  struct State\n  {\n    double in_goal{0.0};\n  };\n  State state_;\n",
        "  struct State {int in_goal(int n) {return n ? in_goal(0) : this->in_goal(1);}};\n",
    ],
)
def test_member_of_another_class_keeps_its_name(change, own):
    edits = {"include/arm/reach_impl.hpp": ("private:\n", "private:\n" + own)}
    about = (SPEC, 'name="goal"', 'name="target" was="goal"')
    package, _ = change(edits, *about, model="cpp_model")
    assert own in (package / "include/arm/reach_impl.hpp").read_text()


@pytest.mark.parametrize(
    ("model", "path", "anchor", "form"),
    [
        ("python_model", "arm/reach_impl.py", "class ReachImpl:\n", 'HELP = """\n{}\n"""\n\n\n'),
        (
            "cpp_model",
            "src/reach_impl.cpp",
            "namespace arm\n{\n",
            'const char kHelp[] = R"(\n{}\n)";\n',
        ),
    ],
)
def test_generated_comment_in_a_text_stays(change, model, path, anchor, form):
    said = "{} Service load".format("#" if model == "python_model" else "//")
    edits = {path: (anchor, form.format(said) + anchor)}
    package, _ = change(edits, SPEC, LOAD, '<serviceServer name="fill" was="load"', model=model)
    text = (package / path).read_text()
    assert form.format(said) in text
    assert text.count(said) == 1


def test_command_is_carried_with_the_function_that_defines_it(change):
    own = (
        "function(add_tool name)\n  add_executable(${name} a.cpp)\nendfunction()\nadd_tool(b)\n\n"
    )
    library = "add_library(${PROJECT_NAME}_reach"
    edits = {"CMakeLists.txt": (library, own + library)}
    about = (SPEC, "", "")
    package, said = change(edits, *about, model="cpp_model", options=("-d", "ros_distro=noetic"))
    assert own.strip() in (package / "CMakeLists.txt").read_text()
    assert " left" not in said


def test_tests_that_were_deleted_in_cmake_stay_so(change, render):
    text = (render(SPEC, name="other", model="cpp_model") / "CMakeLists.txt").read_text()
    tests = text[text.index("if(BUILD_TESTING)") : text.index("ament_export_targets")]
    about = (SPEC, "</package>", PROBE + "</package>")
    package, _ = change({"CMakeLists.txt": (tests, "")}, *about, model="cpp_model")
    text = (package / "CMakeLists.txt").read_text()
    assert "BUILD_TESTING" not in text
    assert "src/probe_impl.cpp" in text
