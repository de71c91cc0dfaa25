"""A rename exchanges what the model makes of a name, and no other word."""

import itertools
import re

import pytest

from hooks.changes import GONE, Mark
from hooks.merge.renaming import plan
from hooks.merge.tree import File, encode
from hooks.merge.uses import uses
from hooks.merge.versions import Versions
from support.arm import SPEC
from support.laboratory.trials import tree_of
from support.packages import changed
from support.repository import commit, git

CYCLE = '        """Compute the outputs of one cycle from the latest inputs."""\n'
LOGIC = """\
        for i in range(3):
            total = config.range + i
        data.out_pose.data = data.out_pose.data + total
        frame = "map"  # the map frame, not the topic map
        point = data.in_map.pose.position
"""
NAMES = SPEC.replace('name="goal"', 'name="map"').replace('name="gain"', 'name="range"')


@pytest.fixture
def update(copier_command):
    def run(package, *changes):
        (spec,) = package.glob("*.ros_package")
        spec.write_text(changed(spec.read_text(), *changes))
        commit(package, "Rename")
        result = copier_command("update", "--trust", "--defaults", cwd=package)
        assert result.returncode == 0, result.stderr
        assert "CONFLICT" not in result.stderr, result.stderr
        return result.stderr

    return run


@pytest.fixture
def merge(laboratory):
    """Merge changes of a spec into a package with edits; return the files, and uses of old names.

    `edits` are, by path, the text of a file of the developer's or pairs of old and new text.
    """

    def run(spec, changes, edits, model="python_model", distro="kilted"):
        own = [path for path, edit in edits.items() if isinstance(edit, str)]
        specs = (spec, changed(spec, *changes))
        pair = laboratory.pair(*specs, model, (distro, distro), "1.0.0", own=own)
        edited = {
            path: edit if path in own else changed(pair.old[path], *edit)
            for path, edit in edits.items()
        }
        mine = {**pair.old, **edited, "lab.ros_package": specs[1]}
        old, new = (side | {"lab.ros_package": ""} for side in (pair.old, pair.new))
        trees = [tree_of(texts) for texts in (mine, old, new)]
        result, doubts = Versions(*trees, pair.renaming, pair.is_kept).merged()
        assert (doubts, result.conflicts) == ([], {})
        files = {path: file.text for path, file in result.tree.items()}
        return files, [*uses(*trees, result.tree, pair.renaming)]

    return run


def test_was_itself_is_no_use_of_the_old_name(arm, update):
    (arm / "arm/notes.txt").write_text("reach, as was='reach' says\n")
    commit(arm, "Take notes")
    said = update(
        arm,
        ('<node name="reach"', '<node\n    was = "reach" name="grasp"'),
        ('name="store"', 'was=\'store\' description="to store" name="keep"'),
        ('name="gain"', 'name="factor" was="gain"'),
    )
    still = re.findall(r"still +(\S+: \w+)", said)
    assert [use for use in still if "arm.ros_package" in use] == ["arm.ros_package:9: store"]
    assert "arm/notes.txt:1: reach" in still


@pytest.mark.parametrize("name", ["kp", "a_gain_whose_name_is_longer"])
def test_bounds_that_the_developer_gave_stay_with_a_parameter(merge, name):
    """In ROS 1, where its name is a text in Python."""
    spec = SPEC.replace('value="1"', 'value="1" min="0" max="10"')
    changes = [('"gain"', f'"{name}" was="gain"')]
    edits = [("min=0.0", "min=-5.0"), ("max=10.0", "max=50.0"), ("    '',", "    'Mine',")]
    (files, said), (new, _) = (
        merge(spec, changes, {"cfg/Reach.cfg": each}, distro="noetic") for each in (edits, [])
    )
    assert files["cfg/Reach.cfg"] == changed(new["cfg/Reach.cfg"], *edits)
    assert f"    '{name}',\n" in files["cfg/Reach.cfg"]
    assert not [use for use in said if use.startswith("cfg")]


GROUPED = [*itertools.pairwise(["gain", "control.gain", "control.factor", "factor"])]


@pytest.mark.parametrize(("old", "new"), GROUPED)
def test_parameter_in_a_group(merge, old, new):
    """Its value in config/ and its name in the logic follow, into a group and out of it."""
    before, after = (name.replace(".", "_") for name in (old, new))
    files, _ = merge(
        SPEC.replace('"gain"', f'"{old}"'),
        [(f'name="{old}"', f'name="{new}" was="{old}"')],
        {
            "config/reach.yaml": [(f"{old}: 1.0", f"{old}: 7.5  # tuned")],
            "arm/reach_impl.py": [(CYCLE, f"{CYCLE}        config.{before}.hex()\n")],
        },
    )
    assert f"    {new}: 7.5  # tuned\n" in files["config/reach.yaml"]
    assert f"config.{after}.hex()" in files["arm/reach_impl.py"]


def test_words_that_only_look_alike_stay(merge):
    changes = [
        ('name="range"', 'name="distance" was="range"'),
        ('name="map"', 'name="costmap" was="map"'),
        ('name="pose"', 'name="turtle_pose" was="pose"'),
    ]
    files, said = merge(NAMES, changes, {"arm/reach_impl.py": [(CYCLE, CYCLE + LOGIC)]})
    impl = files["arm/reach_impl.py"]
    assert "for i in range(3):" in impl
    assert "config.distance + i" in impl
    assert "data.out_turtle_pose.data = data.out_turtle_pose.data" in impl
    assert "data.in_costmap.pose.position" in impl
    assert 'frame = "map"  # the map frame, not the topic map' in impl
    assert 'was="pose"' in files["lab.ros_package"]
    number = impl.split("\n").index('        frame = "map"  # the map frame, not the topic map')
    assert f"arm/reach_impl.py:{number + 1}: map" in said


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_file_that_the_developer_has_moved_is_renamed_too(render, update, model):
    """What imports, includes or compiles it says the new name."""
    package = render(SPEC, model=model, name="arm")
    source = {"python_model": "arm/reach_impl.py", "cpp_model": "src/reach_impl.cpp"}[model]
    moved = source.replace("reach", "logic/reach")
    (package / moved).parent.mkdir()
    git(package, "mv", source, moved)
    for file in ("arm/reach_ros.py", "test/test_reach_impl.py", "CMakeLists.txt"):
        if (path := package / file).exists():
            text = path.read_text().replace("arm.reach_impl", "arm.logic.reach_impl")
            path.write_text(text.replace(source, moved))
    update(package, ('<node name="reach"', '<node name="grasp" was="reach"'))
    assert (package / moved.replace("reach", "grasp")).exists()
    assert not (package / moved).exists()
    files = [path for path in package.rglob("*.*") if path.suffix in (".py", ".txt")]
    assert not any("reach_impl" in path.read_text() for path in files)


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize(
    "change",
    [('<node name="reach"', '<node name="grasp" was="reach"'), ('="gain"', '="kp" was="gain"')],
)
def test_parameter_files_that_the_developer_has_moved_are_loaded(render, update, distro, change):
    package = render(SPEC, name="arm", ros_distro=distro)
    git(package, "mv", "config", "params")
    (launch,) = (package / "launch").iterdir()
    launch.write_text(launch.read_text().replace("/config/", "/params/"))
    said = update(package, change)
    files = sorted(path.name for path in (package / "params").iterdir())
    assert sorted(re.findall(r"/params/(\w+\.yaml)", launch.read_text())) == files
    assert ("grasp.yaml" in files) == ("grasp" in change[1])
    assert "missing" not in said
    assert "launch" not in "".join(re.findall("still.*", said))


@pytest.mark.parametrize("name", ["/hall/goal", "~/goal", "hall/goal"])
def test_name_with_strokes_is_listed_where_it_stays(merge, name):
    """So is that of a parameter with dots."""
    spec = SPEC.replace('"goal"', f'"{name}"').replace('"gain"', '"motor.gain"')
    changes = [(f'"{name}"', f'"aim" was="{name}"'), ('"motor.gain"', '"kp" was="motor.gain"')]
    tool = f"echo {name}\nset motor.gain 1\necho /other{name}\n"
    _, said = merge(spec, changes, {"tool.sh": tool})
    assert said == [f"tool.sh:1: {name}", "tool.sh:2: motor.gain"]


CPP_CYCLE = "  [[maybe_unused]] const ReachConfig & config)\n{\n"
USES = {
    "python_model": ("arm/reach_impl.py", CYCLE, "        use(data.in_{}.data, config.{})\n"),
    "cpp_model": ("src/reach_impl.cpp", CPP_CYCLE, "  use(data.in_{}.data, config.{});\n"),
}


@pytest.mark.parametrize("model", USES)
def test_what_the_logic_has_of_a_group_takes_the_new_name(merge, model):
    """The classes of its objects have it by those that they derive from, of another file."""
    path, place, use = USES[model]
    lines = [re.search(f'.*name="{name}".*\n', SPEC)[0] for name in ("goal", "gain")]
    taken = [("  <node", f'  <group name="all">\n{"".join(lines)}  </group>\n  <node')]
    taken += [(lines[0], '<use group="all"/>'), (lines[1], "")]
    spec = changed(SPEC, *taken[1:], taken[0])
    changes = [('"goal"', '"aim" was="goal"'), ('"gain"', '"kp" was="gain"')]
    edits = {path: [(place, place + use.format("goal", "gain"))]}
    files, said = merge(spec, changes, edits, model)
    assert use.format("aim", "kp") in files[path]
    assert not [line for line in said if line.startswith(path)]


FIRST, SECOND = (f'    <instance name="{side}/reach"/>\n' for side in ("left", "right"))
INSTANCES = {
    "rear/reach": {FIRST: '<instance name="rear/reach" was="left/reach"/>'},
    "base": {FIRST: '<instance name="base" was="left/reach"/>'},
    "right/reach": {
        FIRST: '<instance name="right/reach" was="left/reach"/>',
        SECOND: '<instance name="left/reach" was="right/reach"/>',
    },
}


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("left", INSTANCES)
def test_renamed_instance_keeps_its_parameters_and_what_starts_it(merge, distro, left):
    """Its name is that of a file below a folder; what else is there stays."""
    spec = SPEC.replace('    <publisher name="pose"', f'{FIRST}{SECOND}    <publisher name="pose"')
    launch = {"noetic": "launch/arm.launch", "kilted": "launch/arm.launch.xml"}[distro]
    end = "</node>\n"
    made, _ = merge(spec, [], {}, distro=distro)
    nodes = re.findall(r"<node [^>]*\"reach\"[^>]*>.*?</node>\n", made[launch], re.DOTALL)
    mine = [node.replace(end, f'<remap from="a" to="{n}"/>{end}') for n, node in enumerate(nodes)]
    edits = {
        f"config/{side}/reach.yaml": [("gain: 1.0", f"gain: {n}.5")]
        for n, side in enumerate(("left", "right"))
    }
    edits |= {launch: [*zip(nodes, mine, strict=True)], "config/left/own.yaml": "a: 1\n"}
    files, _ = merge(spec, [*INSTANCES[left].items()], edits, distro=distro)
    right = "left/reach" if left == "right/reach" else "right/reach"
    for n, name in enumerate((left, right)):
        assert f"gain: {n}.5" in files[f"config/{name}.yaml"]
        start = files[launch].index(f"config/{name}.yaml")
        if "/" in left:  # else it has another name for ROS
            assert re.search('to="(.)"', files[launch][start:])[1] == str(n)
    assert "config/left/own.yaml" in files


def test_swapped_names_swap_their_code(arm, update):
    text = (arm / "arm/reach_impl.py").read_text()
    assert text.index("serve_load") < text.index("'loaded'") < text.index("serve_store")
    update(
        arm,
        (
            'name="load" type="std_srvs::Trigger"/>\n    <serviceServer name="store"',
            'name="store" was="load" type="std_srvs::Trigger"/>\n'
            '    <serviceServer name="load" was="store"',
        ),
    )
    text = (arm / "arm/reach_impl.py").read_text()
    loaded = text.index("'loaded'")
    assert "def serve_store" in text[:loaded]
    assert "def serve_load" not in text[:loaded] or text.rindex("def ", 0, loaded) == text.index(
        "def serve_store"
    )
    commit(arm, "Swapped")
    again = update(arm)
    assert "Nothing has changed." in again


def test_line_that_took_the_name_of_another_node_does_not_say_the_old_one(merge):
    """`reach` was `watch`, which is `reach` now."""
    changes = [
        ('<node name="reach"', '<node name="watch" was="reach"'),
        ('<node name="watch" f', '<node name="reach" was="watch" f'),
    ]
    own = "from arm.{0}_impl import {1}Impl\n\n# {1}Impl\n"
    files, said = merge(SPEC, changes, {"arm/own.py": own.format("reach", "Reach")})
    assert files["arm/own.py"].startswith("from arm.watch_impl import WatchImpl\n")
    assert [use for use in said if use.startswith("arm/")] == ["arm/own.py:3: ReachImpl"]


def test_node_named_like_its_package(merge):
    spec = SPEC.replace('<node name="reach"', '<node name="arm"')
    edit = ("        return True\n", "        self.mine = 1\n        return True\n")
    change = ('<node name="arm"', '<node name="grasp" was="arm"')
    files, _ = merge(spec, [change], {"arm/arm_impl.py": [edit]})
    assert "self.mine = 1" in files["arm/grasp_impl.py"]
    assert "from arm.grasp_interface import" in files["arm/grasp_impl.py"]
    assert "arm/arm_impl.py" not in files


def test_renamed_package_keeps_its_code(arm, update):
    git(arm, "mv", "arm.ros_package", "robot_arm.ros_package")
    spec = arm / "robot_arm.ros_package"
    text = spec.read_text().replace('<package name="arm"', '<package name="robot_arm" was="arm"')
    spec.write_text(text)
    commit(arm, "Rename the package")
    result = update(arm)
    assert "> package, was arm" in result
    impl = (arm / "robot_arm/reach_impl.py").read_text()
    assert "from robot_arm.reach_interface import" in impl
    assert "config.gain * data.in_goal.data" in impl
    helper = (arm / "robot_arm/helper.py").read_text()
    assert helper == "from robot_arm.reach_interface import ReachData\n"
    assert not (arm / "arm").exists()


def test_docstrings_of_the_developer_stay_where_the_node_is_renamed(merge):
    """Of those of a module and a class one is the developer's, one is the model's."""
    own = ('    """The logic of reach."""\n', '    """Moves the arm; see reach."""\n')
    changes = [('<node name="reach"', '<node name="grasp" was="reach"')]
    files, _ = merge(SPEC, changes, {"arm/reach_impl.py": [own]})
    text = files["arm/grasp_impl.py"]
    assert "\nThe logic of grasp.\n" in text
    assert text.count("reach") == 1
    assert own[1] in text


@pytest.mark.parametrize(
    ("path", "line"),
    [
        ("README.md", '  topic_goal(["goal"]) --> node_reach\n'),
        (".gitattributes", "/arm/reach_ros.py gitlab-generated linguist-generated\n"),
    ],
)
def test_generated_lines_beside_a_deleted_one_take_the_new_name(merge, path, line):
    changes = [('<node name="reach"', '<node name="grasp" was="reach"')]
    (files, _), (new, _) = (merge(SPEC, changes, {path: e}) for e in ([(line, "")], []))
    assert files[path] == changed(new[path], (line.replace("reach", "grasp"), ""))


def test_own_lines_of_a_diagram_say_the_new_names(merge):
    """But not those of a label, of another block, or what another node has, too."""
    changes = [
        ('<node name="reach"', '<node name="grasp" was="reach"'),
        ('name="goal"', 'name="aim" was="goal"'),
        ('name="load"', 'name="fetch" was="load"'),
    ]
    own = '  node_{} --> box["node_reach"]\n  box --> topic_{} & service_load\n'
    sh = "```sh\nnode_reach\n```\n\n"
    node = '  node_watch["watch"]\n'
    edits = [(node, node + own.format("reach", "goal")), ("## Use\n", sh + "## Use\n")]
    files, _ = merge(SPEC, changes, {"README.md": edits})
    assert own.format("grasp", "aim") in files["README.md"]
    assert sh in files["README.md"]


def test_edited_callback_leaves_a_node_that_is_renamed(merge):
    """Its lines had another name than those that are counted."""
    changes = [
        ('<node name="reach"', '<node name="grasp" was="reach"'),
        (re.search('.*name="load".*\n', SPEC)[0], ""),
    ]
    end = "reach_types::LoadService::Response & response"
    own = {
        "include/arm/reach_impl.hpp": [(f"{end});", f"{end}) override;")],
        "src/reach_impl.cpp": [(f"{end})\n{{", f"{end})\n{{\n  ReachData data;")],
    }
    files, _ = merge(SPEC, changes, own, "cpp_model")
    assert not any("Load" in files[path.replace("reach", "grasp")] for path in own)


def test_renamed_in_cpp(merge):
    changes = [
        ('<node name="reach"', '<node name="grasp" was="reach"'),
        ('name="goal" type="std_msgs::Float64"', 'name="aim" was="goal" type="std_msgs::Float32"'),
        ('name="gain"', 'name="factor" was="gain"'),
        ('name="load"', 'name="fetch" was="load"'),
    ]
    start = "  [[maybe_unused]] const ReachConfig & config)\n{\n"
    body = "  int load = 1;\n  data.out_pose.data = load * config.gain * data.in_goal.data;\n"
    files, _ = merge(SPEC, changes, {"src/reach_impl.cpp": [(start, start + body)]}, "cpp_model")
    text = files["src/grasp_impl.cpp"]
    assert "  int load = 1;" in text
    assert "data.out_pose.data = load * config.factor * data.in_aim.data;" in text
    assert "GraspImpl::serve_fetch(" in text
    assert "ARM__GRASP_IMPL_HPP_" in files["include/arm/grasp_impl.hpp"]


def test_uses_of_what_left_are_said_where_its_name_is_taken(merge):
    """The developer's `in_goal` was the old goal, and is the new one now."""
    goal = '    <subscriber name="goal" type="std_msgs::Float64"/>\n'
    aim = goal.replace("goal", "aim")
    code = "        data.out_pose.data = data.in_goal.data + data.in_aim.data\n"
    edits = {
        "arm/reach_impl.py": [(CYCLE, CYCLE + code)],
        "arm/helper.py": "def reached(data):\n    return data.in_goal\n",
    }
    taken = goal.replace('"goal"', '"goal" was="aim"')
    files, said = merge(SPEC.replace(goal, aim + goal), [(aim + goal, taken)], edits)
    lines = files["arm/reach_impl.py"].split("\n")
    assert "data.in_goal.data + data.in_goal.data" in files["arm/reach_impl.py"]
    number = next(i for i, line in enumerate(lines, 1) if "data.in_goal.data" in line)
    assert [use for use in said if "in_goal" in use] == [
        "arm/helper.py:2: in_goal, which is another's now",
        f"arm/reach_impl.py:{number}: in_goal, which is another's now",
    ]


FIELDS = """<package name="m_msgs" author="A" author_email="a@b.org" description="The name"
  license="MIT">
  <message name="Pose">
    <field name="name" type="string"/>
  </message>
  <message name="Other" description="Another, without a type">
    <field name="name" type="string"/>
    <field name="type" type="string"/>
  </message>
</package>
"""


def test_words_of_xml_are_no_uses_of_a_name(merge):
    """A field may have the name of an attribute or of a tag."""
    changes = [
        ('<field name="name"', '<field name="label" was="name"'),
        ('<field name="type"', '<field name="kind" was="type"'),
    ]
    launch = '<launch>\n  <arg name="a" doc="name"/>\n</launch>\n'
    _, said = merge(FIELDS, changes, {"view.launch": launch}, "interfaces_model")
    spec = "lab.ros_package"
    assert said == [f"{spec}:1: name", f"{spec}:6: type", f"{spec}:7: name", "view.launch:2: name"]


MOVE = """<package name="m_msgs" author="A" author_email="a@b.org" description="Moves"
  license="MIT">
  <message name="Move">
    <field name="speed" type="float64" description="How fast [m/s]"/>
    <field name="angle" type="float64" description="Which way [rad]"/>
    <field name="name" type="string"/>
  </message>
  <service name="Plan">
    <request><field name="speed" type="float64"/></request>
    <response><field name="speed" type="float64"/></response>
  </service>
</package>
"""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_comments_go_with_fields_that_change_places(merge, distro):
    """In the response alone the field keeps its name."""
    speed, angle = ('name="speed" type="float64"', 'name="angle" type="float64"')
    changes = [
        (speed, angle.replace("type", 'was="speed" type')),
        (f'{angle} description="W', speed + ' was="angle" description="W'),
        ('<field name="name"', '<field name="title" was="name"'),
        (f"<request><field {speed}", '<request><field name="pace" was="speed" type="float64"'),
    ]
    of_speed, of_angle = (f"# my {name}\nfloat64 {name}\n" for name in ("speed", "angle"))
    edits = {
        "msg/Move.msg": [("float64 speed\n", of_speed), ("float64 angle\n", of_angle)],
        "srv/Plan.srv": [("float64 speed\n---\nfloat64 speed\n", f"{of_speed}---\n{of_speed}")],
    }
    files, _ = merge(MOVE, changes, edits, "interfaces_model", distro)
    assert files["msg/Move.msg"].lstrip() == (
        "# How fast [m/s]\n# my speed\nfloat64 angle\n"
        "# Which way [rad]\n# my angle\nfloat64 speed\nstring title\n"
    )
    assert files["srv/Plan.srv"].split() == (
        "# my speed float64 pace --- # my speed float64 speed".split()
    )


LAUNCH = """\
<launch>
  <node pkg="arm" type="{0}" name="{0}" output="screen">
    <rosparam command="load" file="$(find arm)/config/{0}.yaml"/>
  </node>
  <composable_node plugin='arm::{1}Node' name='{1}' ns="x"/>
</launch>
"""
LEFT = ("</launch>", '  <node pkg="arm" type="{}" name="left"/>\n</launch>')
RESPAWN = ('output="screen"', 'output="screen" respawn="true"')
OTHER = (
    "</launch>",
    '  <node pkg="b" type="reach" name="reach"/><!-- <node name="reach"/> -->\n</launch>',
)


@pytest.mark.parametrize(
    ("one", "other", "mine", "wanted"),
    [
        ("grasp", "watch", RESPAWN, RESPAWN),
        ("watch", "reach", RESPAWN, RESPAWN),
        ("watch", f"watch{GONE}", RESPAWN, RESPAWN),
        (
            "grasp",
            "watch",
            [part.format("reach") for part in LEFT],
            [part.format("grasp") for part in LEFT],
        ),
        (
            "grasp",
            "see",
            (' name="reach"', '\n    name = "reach"'),
            (' name="g', '\n    name = "g'),
        ),
        ("grasp", "see", ("'watch' ns", "'watch' if=\"1\" ns"), ("'see' ns", "'see' if=\"1\" ns")),
        # What the developer has written, and what only looks like the model's
        ("grasp", "watch", ('type="reach"', 'type="mine"'), ('type="grasp"', 'type="mine"')),
        ("grasp", "watch", (' name="reach"', ' name="mine"'), (' name="grasp"', ' name="mine"')),
        ("grasp", "watch", OTHER, OTHER),
    ],
)
def test_elements_that_were_edited_take_the_new_name(one, other, mine, wanted):
    """`reach` takes the name of nothing, or that of `watch`, which takes another one or left."""
    made, text = rename_in_launch_file(one, other, mine)
    assert made.merged()[1] == []
    assert made.merged()[0].tree["arm.launch"].text == text.replace(*wanted)


def test_lines_in_a_conflict_of_names_that_were_swapped():
    made, _ = rename_in_launch_file("watch", "reach", ("screen", "log"), ("screen", "both"))
    result, doubts = made.merged()
    assert (list(result.conflicts), doubts) == (["arm.launch"], [])
    assert "<<<<<<< before updating\n  <node pkg" in result.tree["arm.launch"].text


def test_lines_of_the_model_as_they_are_afterwards():
    """Of those that are several then, or of what left, none is known."""
    marks = [
        *(Mark(name, name.upper(), "interface") for name in "ab"),
        Mark("a", "c", "interface"),
    ]
    marks.append(Mark("d", f"e{GONE}", "interface", is_gone=True))
    made = "# zq0x\n# zq2x\n  # zq1x\n# zq1x\n# zq3x\n# f\n"
    trees = [{"a.py": File(encode(text))} for text in ("# a\n# a\n  # b\n# b\n# d\n# f\n", made)]
    lines = {"# a": "", "# b": "# B", "# d": "", "# f": "# f"}
    assert plan(*trees, marks, []).generated == {"a.py": lines}


def test_names_of_interfaces_in_a_file_for_all_nodes():
    """They are exchanged where the model writes them; in another file, the word is another's."""
    marks = [Mark("goal", "aim", "interface", owner=0)]
    old, marked = (
        {"topics.py": File(encode(f"in_{name} = 1\n")), "tools.py": File(b"a = 1\n")}
        for name in ("goal", "zq0x")
    )
    renaming = plan(old, marked, marks, old)
    code = "import topics\n\nin_goal = 1\nb = in_goal\n"
    assert renaming.text("topics.py", code) == code.replace("goal", "aim")
    assert renaming.text("tools.py", code) == code


def test_identifiers_that_are_anothers_now():
    """Said in the files of their node and in the developer's own; a name alone is any word."""
    marks = [
        Mark("reach", "reach", "component"),
        Mark("goal", f"goal{GONE}", "interface", owner=0, is_gone=True),
    ]
    old, marked = (
        {
            f"{node}_impl.py": File(encode(f"in_{name} = {name}\n")),
            "watch_impl.py": File(b"a = 1\n"),
        }
        for node, name in (("reach", "goal"), ("zq0x", "zq1x"))
    )
    mine = {path: File(b"b = in_goal\ngoal = 1\n") for path in (*old, "helper.py")}
    said = [*uses(mine, old, {}, mine, plan(old, marked, marks, mine))]
    assert said == [
        f"{path}:1: in_goal, which is another's now" for path in ("helper.py", "reach_impl.py")
    ]


def test_uses_in_one_line_are_listed_by_name():
    names = ["watch", "reach", "grip", "lift", "turn"]
    marks = [Mark(name, f"{name}_2", "component") for name in names]
    made = ([f"{name}_impl.py" for name in names], [f"zq{at}x_impl.py" for at in range(5)])
    old, marked = ({path: File(b"a = 1\n") for path in paths} for paths in made)
    mine = {**old, "helper.py": File(encode(f"all = '{' '.join(names)}'\n"))}
    said = [*uses(mine, old, {}, mine, plan(old, marked, marks, mine))]
    assert said == [f"helper.py:1: {name}" for name in sorted(names)]


@pytest.mark.parametrize(("other", "wanted"), [("aim", "aim"), ("target", "goal")])
def test_identifier_that_two_nodes_rename(other, wanted):
    """In an own file nobody can tell whose it is where their new names differ."""
    marks = [Mark(name, name, "component") for name in ("reach", "watch")]
    marks += [Mark("goal", new, "interface", owner) for owner, new in enumerate(("aim", other))]
    old, marked = (
        {f"{node}_impl.py": File(encode(f"data.in_{name} = 1\n")) for node, name in nodes}
        for nodes in ((("reach", "goal"), ("watch", "goal")), (("zq0x", "zq2x"), ("zq1x", "zq3x")))
    )
    renaming = plan(old, marked, marks, [*old, "tools.py"], ["data"])
    code = "def f(data):\n    data.in_{} = 2\n"
    found = [renaming.text(path, code.format("goal")) for path in (*old, "tools.py")]
    assert found == [code.format(name) for name in ("aim", other, wanted)]


@pytest.mark.parametrize(
    ("line", "is_said"),
    [
        ("file(GLOB SOURCES src/reach_*.cpp)", True),
        ("cp out/*_reach .", True),
        ("file(GLOB SOURCES src/overreach_*.cpp)", False),
    ],
)
def test_pattern_of_files_with_the_name_is_listed(line, is_said):
    marks = [Mark("reach", "grasp", "component")]
    old, marked = ({f"src/{name}_ros.cpp": File(b"int a;\n")} for name in ("reach", "zq0x"))
    mine = {**old, "cmake/own.cmake": File(encode(line + "\n"))}
    said = [*uses(mine, old, {}, mine, plan(old, marked, marks, mine))]
    assert said == (["cmake/own.cmake:1: reach"] if is_said else [])


def test_names_of_a_renamed_project_are_listed():
    """The model writes ${PROJECT_NAME}; of what has another name it is none."""
    text = (
        "project({})\nadd_library(${{PROJECT_NAME}}_reach a.cpp)\nexport(go_${{PROJECT_NAME}})\n"
    )
    old, marked, new = (
        {"CMakeLists.txt": File(encode(text.format(name)))} for name in ("arm", "zq0x", "leg")
    )
    own = "link(a arm_reach)\nlink(a arm_tool arm_msgs go)\nlink(a go_arm)\n"
    mine = {**old, "own.cmake": File(encode(own))}
    renaming = plan(old, marked, [Mark("arm", "leg", "package")], mine)
    said = [*uses(mine, old, new, {**new, "own.cmake": mine["own.cmake"]}, renaming)]
    assert said == ["own.cmake:1: arm_reach", "own.cmake:3: go_arm"]


@pytest.mark.parametrize("top", ["reach", "/**", "mine"])
def test_keys_are_renamed_below_the_name_that_the_developer_has_given_the_node(top):
    form = "{}:\n  ros__parameters:\n    {}: 1\n"
    old, marked = (
        {"a.yaml": File(encode(form.format("reach", name)))} for name in ("gain", "zq0x")
    )
    renaming = plan(old, marked, [Mark("gain", "factor", "interface")], old)
    assert renaming.text("a.yaml", form.format(top, "gain")) == form.format(top, "factor")


def test_keys_of_a_node_in_no_section_are_none_of_one_of_the_developers():
    """In ROS 1 the file is the node's."""
    old, marked = ({"a.yaml": File(encode(f"{name}: 1\n"))} for name in ("gain", "zq0x"))
    renaming = plan(old, marked, [Mark("gain", "factor", "interface")], old)
    form = "{}: 1\nown:\n  gain: 2\n"
    assert renaming.text("a.yaml", form.format("gain")) == form.format("factor")


OF_THE_NODE = {
    "config/reach_lab.yaml": "{top}\n{i}gain: 2.0  # gain\n{i}frequency: 5.0\n",
    "config/lab.yaml": "{own}\n  {i}gain: 2.0\n",
    "config/vendor.yaml": "vendor:\n{i}gain: 2.0\n{i}own: {{gain: 1.0}}\n",
    "config/reaching.yaml": "{top}\n{i}gain: 2.0\n{i}own: {{gain: 1.0}}\n",
}


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_parameters_in_own_files_about_a_node_are_renamed(merge, distro):
    """A section says whose they are, or the name of the file; else they stay."""
    forms = {"top": "# Mine", "own": "reach:", "i": ""}
    if distro == "kilted":
        forms = {"top": "/**:\n  ros__parameters:", "own": "/left/reach:\n  ros__parameters:"}
        forms["i"] = "    "
    own = {path: text.format(**forms) for path, text in OF_THE_NODE.items()}
    change = ('name="gain"', 'name="factor" was="gain"')
    files, _ = merge(SPEC, [change], own, distro=distro)
    for path, text in own.items():
        is_ours = path in ("config/reach_lab.yaml", "config/lab.yaml")
        assert files[path] == (text.replace("gain:", "factor:") if is_ours else text), path


def test_what_a_text_of_yaml_has_like_a_key_stays():
    text = "    text: |\n      gain: 2\n    own: '\n      gain: 3'\n"
    form = f"reach:\n  ros__parameters:\n    {{}}: 1\n{text}"
    old, marked = ({"a.yaml": File(encode(form.format(name)))} for name in ("gain", "zq0x"))
    renaming = plan(old, marked, [Mark("gain", "factor", "interface")], old)
    assert renaming.text("a.yaml", form.format("gain")) == form.format("factor")


@pytest.mark.parametrize(
    "code",
    [
        "import arm.tools as t\n\nt.arm = 1\n",
        "from arm.tools import a\n\narm = 1\n",
        "import arm.tools\n\narm.tools.arm = 1\n",
    ],
)
def test_imports_of_a_package_that_is_renamed(code):
    old, marked = (
        {f"{name}/a.py": File(encode(f"import {name}.tools\n"))} for name in ("arm", "zq0x")
    )
    renaming = plan(old, marked, [Mark("arm", "leg", "package")], old)
    assert renaming.text("arm/a.py", code) == code.replace("arm.tools", "leg.tools")


def test_folders_take_along_what_the_developer_has_in_them():
    """The innermost that the model has made says where to."""
    paths = ("{0}/a.py", "{0}/{1}/b.py", "{0}/{1}/data/c.py", "docs/{0}.md")
    old, marked = (
        {path.format(*names): File(b"a = 1\n") for path in paths}
        for names in (("arm", "reach"), ("zq0x", "zq1x"))
    )
    marks = [Mark("arm", "leg", "package"), Mark("reach", "grasp", "component")]
    renaming = plan(old, marked, marks, old)
    folders = {"arm": "leg", "arm/reach": "leg/grasp", "arm/reach/data/x": "leg/grasp/data/x"}
    for before, after in {**folders, "docs": "docs", "army": "army", "reach": "reach"}.items():
        assert renaming.path(f"{before}/own.py") == f"{after}/own.py"
    assert renaming.path("own.py") == "own.py"


def test_project_of_cmake_that_has_a_version():
    old, marked = (
        {"CMakeLists.txt": File(encode(f"project({name})\n"))} for name in ("arm", "zq0x")
    )
    renaming = plan(old, marked, [Mark("arm", "leg", "package")], old)
    form = "PROJECT({} VERSION 1.2.3)\n"
    assert renaming.text("CMakeLists.txt", form.format("arm")) == form.format("leg")


def test_targets_of_cmake():
    """A file, a variable that has the name of a node is none."""
    old, marked = (
        {"CMakeLists.txt": File(encode(f"add_executable({name} a.cpp)\n"))}
        for name in ("reach", "zq0x")
    )
    renaming = plan(old, marked, [Mark("reach", "grasp", "component")], old)
    form = "target_link_libraries({0} b)\ninstall(TARGETS  # mine\n  {0})\n"
    own = "set(reach 1)\nset(files target_a/reach.cpp)\n"
    text = renaming.text("CMakeLists.txt", form.format("reach") + own)
    assert text == form.format("grasp") + own


def test_spec_says_itself_what_was_renamed():
    old, marked = (
        {path: File(encode(f'<node name="{name}"/>\n')) for path in ("a.launch", "a.ros_package")}
        for name in ("reach", "zq0x")
    )
    renaming = plan(old, marked, [Mark("reach", "grasp", "component")], old)
    texts = {path: renaming.text(path, file.text) for path, file in old.items()}
    assert texts == {
        "a.launch": '<node name="grasp"/>\n',
        "a.ros_package": '<node name="reach"/>\n',
    }


def rename_in_launch_file(one, other, mine, change=("", "")):
    """Return the versions of one whose nodes take other names, and the new one."""
    marks = [
        Mark("reach", one, "component"),
        Mark("watch", other, "component", is_gone=other.endswith(GONE)),
    ]
    old, marked = LAUNCH.format("reach", "watch"), LAUNCH.format("zq0x", "zq1x")
    new = LAUNCH.format(one, other).replace(*change)
    trees = [{"arm.launch": File(encode(text))} for text in (old.replace(*mine), old, new, marked)]
    renaming = plan(trees[1], trees[3], marks, ["arm.launch"])
    return Versions(*trees[:3], renaming), new


# What starts or loads the node, in files of the developer's: in lines with `vendor` another's.
STARTED = {
    "launch/own.launch.xml": """\
<launch>
  <arg name="file" default="$(find-pkg-share arm)/config/reach.yaml"/>
  <node pkg='arm' exec='reach' args="--params-file $(find-pkg-share arm)/config/reach.yaml">
    <param from="$(find-pkg-share arm)/config/reach.yaml"/>
    <param from="$(find-pkg-share vendor)/config/reach.yaml"/>
  </node>
  <node pkg="vendor" exec="reach"/>
</launch>
""",
    "launch/own.launch": """\
<launch>
  <node pkg="arm" type="reach" name="first">
    <rosparam command="load" file="$(find arm)/config/reach.yaml"/>
    <rosparam command="load" file="$(eval find('arm') + '/config/reach.yaml')"/>
    <rosparam command="load" file="$(find vendor)/config/reach.yaml"/>
  </node>
  <node pkg="vendor" type="reach"/>
</launch>
""",
    "launch/own.launch.yaml": """\
launch:
- node:
    pkg: arm
    exec: reach
    param:
    - from: $(find-pkg-share arm)/config/reach.yaml
    - from: $(find-pkg-share vendor)/config/reach.yaml
- node: {exec: "reach", pkg: "arm"}
- node: {exec: reach, pkg: vendor}
""",
    "launch/own.launch.py": """\
own = 'arm'
share = get_package_share_directory(own)
folder = PathJoinSubstitution([FindPackageShare('arm'), 'config'])
other = get_package_share_directory('vendor')
twice = get_package_share_directory('arm')
twice = get_package_share_directory('vendor')
files = [
    os.path.join(get_package_share_directory('arm'), 'config', 'reach.yaml'),
    'é', os.path.join(share, 'config', "reach.yaml"),
    os.path.join(share, 'config/reach.yaml'),
    share + '/config/reach.yaml',
    Path(share) / 'config' / 'reach.yaml',
    get_package_share_path('arm').joinpath('config', 'reach.yaml'),
    str(get_package_share_path('arm')) + '/config/reach.yaml',
    PathJoinSubstitution([FindPackageShare(package='arm'), 'config', 'reach.yaml']),
    PathJoinSubstitution([folder, 'reach.yaml']),
    [FindPackageShare("arm"), '/config/reach.yaml'],
    os.path.join(rospkg.RosPack().get_path('arm'), 'config', 'reach.yaml'),
    os.path.join(other, 'config', 'reach.yaml'),  # of vendor
    os.path.join(twice, 'config', 'reach.yaml'),  # of vendor
    os.path.join(share, 'config', vendor, 'reach.yaml'),
    os.path.join(share, 'vendor', 'reach.yaml'),
]
Node(package='arm', executable='reach', parameters=files)
Node(package=own, executable='reach')
Node(package='vendor', executable='reach')
Node(package=other, executable='reach')  # of vendor


def one():
    near = get_package_share_directory('arm')
    return os.path.join(near, 'config', 'reach.yaml')


def two(far):
    near = get_package_share_directory('arm')
    far = far or get_package_share_directory('arm')
    use(os.path.join(near, 'config', 'reach.yaml'))
    return os.path.join(far, 'config', 'reach.yaml')  # of vendor, perhaps
""",
    "docs/run.md": """\
Either `ros2 run arm reach --ros-args` or `rosrun arm reach`, with package://arm/config/reach.yaml
`ros2 run vendor reach`, `ros2 run arm vendor_reach`, package://vendor/config/reach.yaml
`ros2 launch arm vendor/reach.yaml`
""",
}
LOADED = {
    "python_model": {
        "arm/load.py": """\
module = import_module("arm.reach_impl")
patch('arm.reach_impl.ReachImpl.use', use)
import_module("vendor.reach_impl")
patch('arm.vendor.reach_impl')
"""
    },
    "cpp_model": {
        "src/load.cpp": """\
auto file = get_package_share_directory("arm") + "/config/reach.yaml";
auto other = get_package_share_directory("vendor") + "/config/reach.yaml";
""",
        "launch/composed.launch.xml": """\
<launch>
  <load_composable_node target="a">
    <composable_node pkg="arm" plugin="arm::ReachNode" name="b"/>
    <composable_node pkg="vendor" plugin="arm::ReachNode"/>
  </load_composable_node>
</launch>
""",
        "launch/composed.launch.py": """\
ComposableNode(package='arm', plugin='arm::ReachNode')
ComposableNode(package='vendor', plugin='arm::ReachNode')
""",
    },
}


@pytest.mark.parametrize("model", LOADED)
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_own_files_start_and_load_what_was_renamed(merge, model, distro):
    """Where they say that it is of the package; another's stays, and is listed."""
    own = {**STARTED, **LOADED[model]}
    if distro == "noetic":  # which has no components
        own = {path: text for path, text in own.items() if "composed" not in path}
    change = ('<node name="reach"', '<node name="grasp" was="reach"')
    files, said = merge(SPEC, [change], own, model=model, distro=distro)
    for path, text in own.items():
        lines = text.splitlines()
        kept = [n for n, line in enumerate(lines) if "vendor" in line]
        for number, line in enumerate(lines):
            if number not in kept:
                lines[number] = line.replace("Reach", "Grasp").replace("reach", "grasp")
        assert files[path].splitlines() == lines
        listed = {f"{path}:{n + 1}" for n in kept if "reach" in re.findall(r"\w+", lines[n])}
        assert listed <= {use.rpartition(":")[0] for use in said}


def test_own_lines_start_what_has_changed_places(merge):
    """Generated lines beside them do, too, each once."""
    changes = [
        ('name="reach"', 'name="watch" was="reach"'),
        ('"watch" f', '"reach" was="watch" f'),
    ]
    launch, end = "launch/arm.launch.xml", "</launch>"
    own = '<node pkg="arm" exec="{0}"><param from="$(find-pkg-share arm)/config/{0}.yaml"/></node>'
    both = "".join(map(own.format, ("reach", "watch")))
    program = "            'own = arm.reach_ros:main',\n"
    setup = ("        'console_scripts': [\n", f"        'console_scripts': [\n{program}")
    (files, _), (made, _) = (
        merge(SPEC, changes, edits)
        for edits in ({launch: [(end, both + end)], "setup.py": [setup]}, {})
    )
    swapped = "".join(map(own.format, ("watch", "reach")))
    assert files[launch] == changed(made[launch], (end, swapped + end))
    lines = [*made["setup.py"].splitlines(), program.replace("reach", "watch").rstrip()]
    assert sorted(files["setup.py"].splitlines()) == sorted(lines)


@pytest.mark.parametrize("program", ["", "            'mine = arm.{}_ros:main',\n"])
def test_program_that_was_changed_follows_its_node(merge, program):
    """One that the developer has deleted stays away."""
    change = ('<node name="reach"', '<node name="grasp" was="reach"')
    made, line = "            '{0} = arm.{0}_ros:main',\n", program.format
    (files, _), (fresh, _) = (
        merge(SPEC, [change], edits)
        for edits in ({"setup.py": [(made.format("reach"), line("reach"))]}, {})
    )
    assert files["setup.py"] == changed(fresh["setup.py"], (made.format("grasp"), line("grasp")))


def test_class_that_setup_names_for_others_is_renamed(merge):
    end = "        ],\n    },\n"
    plugins = "        ],\n        'arm.plugins': ['a = arm.reach_impl:ReachImpl'],\n    },\n"
    change = ('<node name="reach"', '<node name="grasp" was="reach"')
    files, said = merge(SPEC, [change], {"setup.py": [(end, plugins)]})
    assert "['a = arm.grasp_impl:GraspImpl']" in files["setup.py"]
    assert not [use for use in said if use.startswith("setup.py")]


def test_own_lines_start_what_is_renamed_with_its_package(render, update):
    package = render(SPEC, name="arm")
    own = package / "launch/own.launch.py"
    text = "share = FindPackageShare('arm')\nNode(package='arm', executable='reach')\n"
    text += "[share, '/config/reach.yaml']\nshare / 'launch' / 'arm.launch.xml'\nreach = 'arm'\n"
    own.write_text(text)
    git(package, "mv", "arm.ros_package", "robot.ros_package")
    update(package, ('name="arm"', 'name="robot" was="arm"'), ('"reach"', '"grasp" was="reach"'))
    assert own.read_text() == changed(
        text,
        ("Share('arm')", "Share('robot')"),
        ("='arm'", "='robot'"),
        ("'reach'", "'grasp'"),
        ("reach.yaml", "grasp.yaml"),
        ("arm.launch.xml", "robot.launch.xml"),
    )


OF_ONE_NODE = {
    "python_model": {
        "arm/base.py": "from arm.reach_interface import LoadRequest\n\n\nclass Base:\n"
        "    def serve_load(self, request: LoadRequest):\n        request\n",
        "arm/both.py": "from arm import reach_interface, watch_interface\n\n"
        "reach_interface.LoadRequest, watch_interface.LoadRequest\n",
    },
    "cpp_model": {
        "include/arm/base.hpp": '#include "arm/reach_interface.hpp"\nnamespace arm\n{\n'
        "void load(reach_types::LoadService::Request & request);\n}\n",
        "test/test_own.cpp": '#include "support/reach_harness.hpp"\n\nTEST(Own, Serves) {\n'
        "  arm::ReachHarness harness;\n  harness.impl.serve_load(a, b);\n}\n",
        "include/arm/both.hpp": '#include "arm/reach_interface.hpp"\n'
        '#include "arm/watch_interface.hpp"\nnamespace arm\n{\n'
        "void load(watch_types::LoadService a, reach_types::LoadService b);\n}\n",
    },
}


@pytest.mark.parametrize("model", OF_ONE_NODE)
def test_own_files_about_one_node_follow_where_another_node_has_the_name_too(
    render, update, model
):
    package = render(SPEC, model=model, name="arm")
    own = OF_ONE_NODE[model]
    for path, text in own.items():
        (package / path).write_text(text)
    if model == "python_model":  # whose logic derives from one of these
        logic = package / "arm/reach_impl.py"
        text = changed(logic.read_text(), ("class ReachImpl:", "class ReachImpl(Base):"))
        logic.write_text(text.replace("from arm.", "from arm.base import Base\nfrom arm.", 1))
    said = update(package, ('name="load"', 'name="fetch" was="load"'))
    *about_one, about_both = own
    for path in about_one:
        wanted = own[path].replace("Load", "Fetch").replace("serve_load", "serve_fetch")
        assert (package / path).read_text() == wanted
    assert (package / about_both).read_text() == own[about_both]
    assert f"still     {about_both}" in said


# What own launch files give nodes: what is between « and » is exchanged, lines with `still` are
# listed.
GIVEN = {
    "launch/own.launch.xml": """\
<launch>
  <param name="gain" value="still"/>
  <node pkg="arm" exec="reach" name="arm1">
    <!-- <param name="gain" value="still"/> -->
    <param name="«gain»" value="2.0"/><remap from="«goal»" to="/far"/>
    <param
      value="é"
      name='«motor.limit»'/>
    <param name="motor"><param value="1" name="«limit»"/></param>
    <param name="other"><param name="limit" value=""/></param>
    <param name="goal" value="still"/><remap from="gain" to="still"/>
    <remap from="/«goal»" to="a"/>
    <remap from="~/goal" to="still"/>
    <remap from="map" to="still"/>
    <remap from="«load»" to="goals"/>
    <remap from="«swing»/_action/send_goal" to="a"/>
  </node>
  <node pkg="arm" exec="watch"><remap from="load" to="still"/></node>
  <node pkg="vendor" exec="reach"><param name="gain" value="still"/></node>
  <node pkg="arm" exec="$(var reach)"><param name="gain" value="still"/></node>
</launch>
""",
    "launch/own.launch": """\
<launch>
  <param name="gain" value="still"/>
  <node pkg="arm" type="reach" name="first" args="_gain:=still">
    <param name="«gain»" value="2.0"/>
    <param name="~«gain»" value="2.0"/>
    <param name="/gain" value="still"/>
    <param name="«motor/limit»" value="2.0"/>
    <rosparam param="«gain»">2.0</rosparam>
    <rosparam>
      # gain: still
      «gain»: 2.0
      motor:
        «limit»: 3.0
      other: {limit: 3}
    </rosparam>
    <rosparam ns="motor">«limit»: 3</rosparam><rosparam ns="other">gain: still</rosparam>
    <rosparam><![CDATA[{'«gain»': 5, other: {limit: 2}}]]></rosparam>
    <remap from="«goal»" to="far"/>
    <remap from="/«load»" to="far"/>
    <remap from="map" to="still"/>
    <remap from="«swing»/goal" to="a"/>
  </node>
  <node pkg="vendor" type="reach"><rosparam>gain: still</rosparam></node>
</launch>
""",
    "launch/own.launch.yaml": """\
launch:
- node:
    pkg: "arm"
    exec: reach
    param:
    - name: «gain»  # still not the gain of others
      value: 1.0
    - {value: 1.0, name: "«gain»"}
    - name: motor
      param:
      - name: «limit»
        value: 2.0
    remap:
    - from: «goal»
      to: far
    - {to: still, from: gain}
    - {from: map, to: still}
- node: {exec: reach, pkg: vendor, param: [{name: gain, value: still}]}
""",
    "launch/own.launch.py": """\
gains = {'gain': 'still'}
package = 'arm'
own = {'«gain»': 1}
Node(
    package='arm', executable='reach', parameters=[file, {'é': 1, '«gain»': 1}], name='goals',
    remappings=[('«goal»', 'far'), ("«load»", a), ('gain', 'still'), ('map', b)],
)
LifecycleNode(
    remappings=[('/«goal»', 'far'), ('«swing»/_action/status', 'b')] + more, executable='reach',
    parameters=[
        {
            '«gain»': LaunchConfiguration('still'), **gains, 'x': {'gain': 'still'},
            'motor': {'«limit»': 3, 'other': {'limit': 3}},
            "«motor.limit»": 2 if sim else 3,
        },
        {'other': {'limit': 'far'}},
        gains, own,
    ] if x else [{'«gain»': 1.0}],
    package=package,
)
Node(package='vendor', executable='reach', parameters=[{'gain': 'still'}])
Node(package='arm', executable='watch', remappings=[('load', 'still')])
Node(package='arm', executable=reach, parameters=[{'gain': 'still'}])
SetParameter(name='gain', value='still')
""",
    "launch/composed.launch.xml": """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container">
    <param name="gain" value="still"/>
    <composable_node pkg="arm" plugin="arm::ReachNode"><param name="«gain»" value="1"/>
      <remap from="«goal»" to="a"/>
    </composable_node>
    <composable_node pkg="vendor" plugin="arm::ReachNode">
      <param name="gain" value="still"/>
    </composable_node>
  </node_container>
</launch>
""",
    "launch/composed.launch.yaml": """\
launch:
- node_container:
    pkg: rclcpp_components
    exec: component_container
    composable_node:
    - pkg: arm
      plugin: arm::ReachNode
      param:
      - name: «gain»
        value: 1
""",
    "launch/composed.launch.py": """\
ComposableNode(package='arm', plugin='arm::ReachNode', parameters=[{'«gain»': 1}])
ComposableNode(package='vendor', plugin='arm::ReachNode', parameters=[{'gain': 'still'}])
""",
}
GIVING = SPEC.replace(
    "    <dynParameter",
    '    <actionServer name="swing" type="tf2_msgs::LookupTransform"/>\n'
    '    <parameter name="motor.limit" type="double" value="1"/>\n'
    '    <parameter name="map_topic" type="string" value="map"/>\n'  # which keeps its value
    '    <directPublisher name="map" type="std_msgs::Empty" topic_parameter="map_topic"/>\n'
    "    <dynParameter",
)
NOW = {
    "map": "chart",
    "goal": "aim",
    "gain": "kp",
    "load": "fetch",
    "swing": "swipe",
    "motor.limit": "motor.top",
}


@pytest.mark.parametrize("program", ["reach", "reach-it"])
@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_what_own_launch_files_give_a_node_follows(merge, model, distro, program):
    """Parameters and remapped topics, services and actions; another's stay, and are listed."""
    is_composed = (model, distro) == ("cpp_model", "kilted")
    own = {
        path: re.sub(r"(?<==['\"])reach(?=['\"])|(?<=exec: )reach", program, text)
        for path, text in GIVEN.items()
        if ("composed" not in path or is_composed) and (path[-1] == "h") == (distro == "noetic")
    }
    given = f'name="reach" executable="{program}"' if program != "reach" else 'name="reach"'
    spec = GIVING.replace('name="reach"', given)
    before, *after = spec.partition('  <node name="watch"')
    changes = [(f'"{old}" type', f'"{new}" was="{old}" type') for old, new in NOW.items()]
    now = NOW | {"limit": "top", "motor/limit": "motor/top"}
    edits = {path: re.sub("«(.*?)»", r"\1", text) for path, text in own.items()}
    change = (spec, changed(before, *changes) + "".join(after))
    files, said = merge(spec, [change], edits, model, distro)
    for path, text in own.items():
        assert files[path] == re.sub("«(.*?)»", lambda name: now[name[1]], text)
        lines = enumerate(text.splitlines(), 1)
        listed = {f"{path}:{number}" for number, line in lines if "still" in line}
        assert listed <= {use.rpartition(":")[0] for use in said}


NESTED = {
    "noetic": (
        "launch/own.launch",
        """\
<launch>
  <node pkg="arm" type="reach" name="one">
    <param name="{}" value="1"/>
    <rosparam>
      motor:
        limit: 2  # listed
    </rosparam>
  </node>
</launch>
""",
    ),
    "kilted": (
        "launch/own.launch.py",
        """\
Node(package='arm', executable='reach', parameters=[
    {{'{}': 1, 'motor': {{
        'limit': 2,  # listed
    }}}}])
""",
    ),
}


@pytest.mark.parametrize("distro", NESTED)
@pytest.mark.parametrize("name", ["drive.limit", "limit"])
def test_parameter_nested_in_a_launch_file_that_leaves_its_group_is_listed(merge, distro, name):
    path, text = NESTED[distro]
    change = ('"motor.limit"', f'"{name}" was="motor.limit"')
    sign = "/" if distro == "noetic" else "."
    before, after = (text.format(each.replace(".", sign)) for each in ("motor.limit", name))
    files, said = merge(GIVING, [change], {path: before}, distro=distro)
    assert files[path] == after
    number = 1 + next(n for n, line in enumerate(after.splitlines()) if "listed" in line)
    assert said == [f"{path}:{number}: motor.limit"]


METHODS = {
    "python_model": (
        "arm/reach_impl.py",
        "    def poll(self) -> None:\n",
        ["    def {}(self):\n", "    async def {}(self) -> None:  # often\n"],
    ),
    "cpp_model": (
        "src/reach_impl.cpp",
        "void ReachImpl::poll()\n{\n",
        [
            "void ReachImpl::{}() {{\n",
            "auto arm::ReachImpl::{}() -> void\n{{\n",
            "void ReachImpl::{}()\n{{\n  bind(&ReachImpl::{}, this); Own::poll(); own.poll();\n",
        ],
    ),
}


@pytest.mark.parametrize(
    ("model", "form"), [(model, form) for model in METHODS for form in METHODS[model][2]]
)
def test_method_that_is_named_by_nothing_else_follows_in_another_form(merge, model, form):
    """That of a timer or a thread, of which the developer has changed the first line."""
    path, made, _ = METHODS[model]
    spec = SPEC.replace("    <dynP", '    <timer name="poll" frequency="2"/>\n    <dynP', 1)
    before, after = (form.format(name, name) for name in ("poll", "tick"))
    files, _ = merge(spec, [('"poll"', '"tick" was="poll"')], {path: [(made, before)]}, model)
    assert after in files[path]
    assert len(re.findall(r"\bpoll\b", files[path])) == form.count("poll")


NESTED_KEYS = """\
{top}{i}own: {{limit: 1}}
{i}motor:  # those of it
{i}  other: 2
{i}  "«limit»": 3.0
{i}drive: {{«gain»: 5}}
"""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("path", ["config/reach.yaml", "config/reach_lab.yaml"])
@pytest.mark.parametrize(("limit", "gain"), [("motor.top", "drive.kp"), ("arm.limit", "speed")])
def test_parameters_nested_in_a_file_are_renamed(merge, distro, path, limit, gain):
    """In their group; what leaves it stays, and is listed."""
    top = "/**:\n  ros__parameters:\n" if distro == "kilted" else ""
    text = NESTED_KEYS.format(top=top, i="    " if top else "")
    spec = GIVING.replace(
        "    <dynParameter",
        '    <parameter name="drive.gain" type="int" value="1"/>\n    <dynParameter',
    )
    mine = re.sub("«(.*?)»", r"\1", text)
    made, _ = merge(spec, [], {}, distro=distro)
    edit = [(made[path], mine)] if path in made else mine
    changes = [
        (f'"{old}" type', f'"{new}" was="{old}" type')
        for old, new in (("motor.limit", limit), ("drive.gain", gain))
    ]
    files, said = merge(spec, changes, {path: edit}, distro=distro)
    names = {"limit": limit, "gain": gain}
    is_in = limit == "motor.top"
    wanted = re.sub("«(.*?)»", lambda m: names[m[1]].rpartition(".")[2] if is_in else m[1], text)
    for line in wanted.splitlines():
        assert line in files[path].splitlines()
    listed = {use.partition(": ")[2] for use in said if use.startswith(path)}
    assert {"motor.limit", "drive.gain"} & listed == (
        set() if is_in else {"motor.limit", "drive.gain"}
    )


@pytest.mark.parametrize("comment", ["  # the name", "\t#the name", "# the name"])
def test_field_with_a_comment_of_the_developers_beside_it_is_renamed(merge, comment):
    """Its comment stays as it is."""
    changes = [('<field name="name"', '<field name="label" was="name"')]
    edits = {"msg/Pose.msg": [("string name", f"string name{comment}")]}
    (files, _), (made, _) = (
        merge(FIELDS, changes, each, "interfaces_model") for each in (edits, {})
    )
    wanted = changed(made["msg/Pose.msg"], ("string label", f"string label{comment}"))
    assert files["msg/Pose.msg"] == wanted


@pytest.mark.parametrize("names", [("mode", "lambda"), ("lambda", "mode"), ("str", "namespace")])
@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_parameter_whose_name_code_has_a_meaning_for_follows_as_code_has_it(merge, model, names):
    before, after = names
    line = '    <parameter name="{}" type="int" value="1"/>\n'
    spec = SPEC.replace("    <dynParameter", f"{line.format(before)}    <dynParameter", 1)
    path = {"python_model": "arm/tools.py", "cpp_model": "src/tools.cpp"}[model]
    text = {
        "python_model": "from .reach_interface import ReachConfig\n\n\n"
        "def f(config: ReachConfig):\n    config.{}\n",
        "cpp_model": '#include "arm/reach_interface.hpp"\nnamespace arm\n{{\n'
        "int f(const ReachConfig & config) {{return config.{};}}\n}}\n",
    }[model]
    own = {
        path: text.format(before if before == "mode" else f"{before}_"),
        "config/own.yaml": f"/**/reach:\n  ros__parameters:\n    {before}: 2\n",
    }
    change = (f'"{before}" type', f'"{after}" was="{before}" type')
    files, _ = merge(spec, [change], own, model)
    assert files[path] == text.format(after if after == "mode" else f"{after}_")
    assert files["config/own.yaml"] == own["config/own.yaml"].replace(before, after)


@pytest.mark.parametrize("place", ["arm/reach_logic.py", "arm/logic/reach_impl.py"])
def test_logic_in_a_file_that_the_developer_calls_otherwise_is_renamed_with_what_uses_it(
    arm, update, place
):
    """The class, the node and the tests that import it; the file has the developer's name."""
    (arm / place).parent.mkdir(exist_ok=True)
    git(arm, "mv", "arm/reach_impl.py", place)
    module = place.removesuffix(".py").replace("/", ".")
    for path in ("arm/reach_ros.py", "test/test_reach_impl.py"):
        file = arm / path
        file.write_text(changed(file.read_text(), ("arm.reach_impl", module)))
    said = update(arm, ('<node name="reach"', '<node name="grasp" was="reach"'))
    module = module.replace("reach_impl", "grasp_impl")
    assert "class GraspImpl:" in (arm / f"{module.replace('.', '/')}.py").read_text()
    for path in ("arm/grasp_ros.py", "test/test_grasp_impl.py"):
        text = (arm / path).read_text()
        assert f"from {module} import GraspImpl\n" in text
        assert "ReachImpl" not in text
    assert "ReachImpl" not in said
