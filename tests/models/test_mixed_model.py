"""mixed_model makes each node as the model of its language does, and says nothing again."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
import yaml

from hooks.faults import SpecError
from hooks.model import Model
from support.packages import DATA, model_of
from support.repository import EXAMPLES, ROOT, commit, git
from support.soundness import check_imports, check_sound

MIXED = ROOT / "mixed_model/template"
LANGUAGES = ("python", "cpp")
DRIVING = (EXAMPLES / "driving.ros_package").read_text()
# What a package has once, whatever the languages of its nodes.
WHOLE = re.compile(
    r"\.git|README|AGENTS|package\.xml|launch/|config/|CMakeLists|_copier_conf|ros_package"
    r"|\{\{ ros2 \}\}/(setup\.|resource|nodl/)"
    r"|^(msg|srv|action)/|test/support/(node_tests\.py|peer\.py|running\.py|fastdds\.xml)"
)


def templates(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def of_language(language):
    """Return the files of a language, each with the template of its model that it includes."""
    folder = MIXED / f"[spec.{language}]"
    form = rf'{{% set spec = part %}}{{% include "({language}_model/template/[^"]+)" %}}\n'
    found = {}
    for name in templates(folder):
        text = (folder / name).read_text()
        match = re.fullmatch(form, text)
        assert match or text == "", name
        found[name] = match[1] if match else f"{language}_model/template/{name}"
    return found


@pytest.mark.parametrize("language", LANGUAGES)
def test_files_of_a_language_are_those_of_its_model(language):
    """Each is one include; no file of the model is forgotten, none has another path or mode.

    Decision 145.
    """
    model = ROOT / f"{language}_model/template"
    found = of_language(language)
    included = {
        Path(source).relative_to(f"{language}_model/template") for source in found.values()
    }
    expected = {Path(name) for name in templates(model) if not WHOLE.search(name)}
    assert included == expected
    for name, source in found.items():
        # ROS 2 starts a node in Python by the program that ROS 1 has.
        assert source.endswith(name) or name == "scripts/[node.executable].jinja"
        mode = (MIXED / f"[spec.{language}]" / name).stat().st_mode
        assert mode == (ROOT / source).stat().st_mode, name


@pytest.mark.parametrize(
    "name", [n for n in sorted(templates(MIXED)) if not n.startswith("[spec.")]
)
def test_files_of_the_whole_package_repeat_nothing(name):
    """They include, extend, and say what only a package with both languages has."""
    text = re.sub(r"\{%.*?%\}", "", (MIXED / name).read_text(), flags=re.DOTALL)
    own = {line.strip() for line in text.splitlines() if len(line.strip()) > len("</package>")}
    others = [ROOT / f"{language}_model/template" / name for language in LANGUAGES]
    said = {line.strip() for file in others if file.exists() for line in file.open()}
    once = {"{{ spec_schema() }}", "catkin_python_setup()", "DESTINATION lib/${PROJECT_NAME}"}
    once |= {"find_package(ament_cmake_pytest REQUIRED)", "TIMEOUT 600"}  # for other tests
    once |= {line for line in said if "build" in line}  # the tool, and how colcon knows it
    assert not (own & said) - once
    assert len(own) <= 14


def context(spec, distro="kilted"):
    model = model_of("mixed_model")
    return model.functions, model.context(spec.encode(), "driving.ros_package", distro)


def test_each_part_is_what_its_model_sees():
    functions, spec = context(DRIVING)
    for language in LANGUAGES:
        (part,) = functions["parts"](spec, language, "kilted")
        alone = re.sub(f'<node (?![^>]*"{language}").*?</node>', "", DRIVING, flags=re.DOTALL)
        alone = re.sub(' language="[a-z]+"', "", alone)
        own = Model(ROOT / f"{language}_model", ROOT).context(alone.encode(), "spec", "kilted")
        assert part["kinds"] == own["kinds"]
        assert [node["name"] for node in part["nodes"]] == [node["name"] for node in own["nodes"]]
        assert part["depends"] == own["depends"]
        assert functions["parts"](part, language, "kilted")[0]["nodes"] == part["nodes"]
    only = re.sub(r"<node [^>]*python.*?</node>", "", DRIVING, flags=re.DOTALL)
    functions, spec = context(only)
    assert functions["parts"](spec, "python", "kilted") == []
    assert "rclpy" not in spec["depends"]


def test_what_depend_adds_is_for_both_languages():
    functions, spec = context(DRIVING.replace("</package>", "<depend>nav_msgs</depend></package>"))
    for language in LANGUAGES:
        assert "nav_msgs" in functions["parts"](spec, language, "kilted")[0]["depends"]


# Packages that a node in Python alone needs, of messages and of its runtime.
PYTHON_ALONE = """
    <serviceServer name="reset" type="std_srvs::SetBool"/>
    <directSubscriber name="map" type="nav_msgs::OccupancyGrid"/>
    <serviceClient name="ask" type="std_srvs::Empty"/>
    <actionClient name="go" type="control_msgs::FollowJointTrajectory"/>
    <dynParameter name="gain" type="double" value="1.0"/>
    <listener name="tf"/>
  </node>"""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_what_python_alone_needs_is_not_built_with(render, distro):
    """It is there to run: no target in C++ is linked with it, none of its users gets it."""
    spec = DRIVING.replace(' name="stop" type="std_srvs', ' name="stop" type="diagnostic_msgs')
    spec = spec.replace("</node>", PYTHON_ALONE, 1)
    package = render(spec, model="mixed_model", ros_distro=distro)
    cmake = (package / "CMakeLists.txt").read_text()
    names = {"std_srvs", "nav_msgs", "control_msgs"}
    ros1 = {"roslaunch", "rospy", "actionlib", "rosgraph", "tf2_ros"}
    names |= ros1 if distro == "noetic" else {"rclpy", "tf2_ros_py"}
    tree = ET.parse(package / "package.xml").getroot()
    for name in names:
        assert not re.search(rf"\b{name}\b", cmake), name
        assert {e.tag for e in tree if e.text == name} == {"exec_depend"}, name
    assert {e.tag for e in tree if e.text == "diagnostic_msgs"} == {"depend"}
    assert {e.tag for e in tree if e.text == "tf2_msgs"} == {"test_depend"}


def test_package_of_python_alone_asks_catkin_for_no_component(renderers):
    spec = DRIVING.replace('language="cpp"', 'language="python"')
    files = renderers["mixed_model"].render(context(spec, "noetic")[1], "noetic")
    cmake = files["CMakeLists.txt"]
    assert "find_package(catkin REQUIRED)\n" in cmake
    assert "catkin_package()\n" in cmake
    assert "DEPENDS" not in cmake


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("model", ["cpp_model", "mixed_model"])
def test_what_starts_nodes_is_for_running_alone(render, model, distro):
    spec = DRIVING if model == "mixed_model" else re.sub(' language="[a-z]+"', "", DRIVING)
    package = render(spec, model=model, ros_distro=distro)
    tree = ET.parse(package / "package.xml").getroot()
    tags = {(e.text, e.tag) for e in tree if "launch" in (e.text or "") and "depend" in e.tag}
    names = {"roslaunch"} if distro == "noetic" else {"launch_ros", "launch_xml"}
    assert tags == {(name, "exec_depend") for name in names}
    assert not re.search("roslaunch|launch_", (package / "CMakeLists.txt").read_text())


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("hostile", [False, True])
def test_packages_are_sound(render, distro, hostile):
    spec = DRIVING
    if hostile:
        text = (DATA / "hostile.ros_package").read_text()
        numbers = iter(range(1000))
        pick = lambda match: f'{match[0]} language="{LANGUAGES[next(numbers) % 2]}"'  # noqa: E731
        spec = re.sub(r"<(node|component)(?= )", pick, text)
        assert next(numbers) > 1
    package = render(spec, model="mixed_model", ros_distro=distro)
    check_sound(package)
    check_imports(package, distro)


REFUSED = {
    # A name that Python alone makes twice, and one that C++ alone does, whatever the language.
    '<serviceClient name="x" type="std_srvs::Trigger"/>'
    '<serviceServer name="client_x" type="std_srvs::Trigger"/>': "ClientXRequest",
    '<serviceClient name="service" type="std_srvs::Trigger"/>'
    '<serviceServer name="client" type="std_srvs::Trigger"/>': "ClientService",
    '<dynParameter name="EOF" type="int" value="1"/>': "a macro of C",
}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("inside", "name"), REFUSED.items())
def test_names_are_checked_for_both_languages(language, inside, name):
    node = f'<node name="n" language="{language}" frequency="1">{inside}</node></package>'
    with pytest.raises(SpecError, match=name):
        context(DRIVING.replace("</package>", node))


@pytest.mark.parametrize(
    ("one", "other", "message"),
    [
        ("planner", "planner", "already taken at line"),
        ("test_planner_impl", "planner", 'CMake target "test_planner_impl"'),
        ("ament_cmake_python_copy_driving", "planner", "reserved as CMake target"),
    ],
)
def test_languages_share_the_names_of_the_package(one, other, message):
    nodes = f'<node name="{one}" language="cpp"/><node name="{other}" language="python"/>'
    with pytest.raises(SpecError, match=message):
        context(re.sub(r"<node.*</node>", nodes, DRIVING, flags=re.DOTALL))


def test_language_is_asked_for():
    with pytest.raises(SpecError, match='attribute "language" is missing'):
        context(DRIVING.replace(' language="cpp"', ""))
    with pytest.raises(SpecError, match="allowed: python, cpp"):
        context(DRIVING.replace('"cpp"', '"rust"'))


def names(package):
    return set(git(package, "ls-files").splitlines())


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_files_come_and_go_with_the_language(render, copier_command, distro):
    """The logic of a node that changes its language leaves, and the update says how to see it."""
    options = {"model": "mixed_model", "ros_distro": distro}
    package = render(DRIVING, **options)
    git(package, "apply", str(DATA / "logic/driving.patch"))
    commit(package, "Fill in the logic")
    filled = git(package, "rev-parse", "HEAD")
    before, logic = names(package), (package / "driving/planner_impl.py").read_text()
    other = {"cpp": "python", "python": "cpp"}
    texts = {to: DRIVING.replace(f'"{other[to]}"', f'"{to}"') for to in other}
    for language in ("cpp", "python"):
        (package / "driving.ros_package").write_text(texts[language])
        commit(package, f"Write all in {language}")
        result = copier_command("update", "--trust", "--defaults", cwd=package)
        assert result.returncode == 0, result.stderr
        commit(package, "Update")
        fresh = render(texts[language], name=f"{language}/package", **options)
        assert names(package) == names(fresh)
        if language == "cpp":
            assert "~ node planner: language python -> cpp\n" in result.stderr
            removed = r"removed +driving/planner_impl\.py .*git show (\S+)\)"
            shown = re.search(removed, result.stderr)[1]
            assert git(package, "show", shown) == logic.strip()
            code = (package / "src/controller_impl.cpp").read_text()
            assert "std::min(data.in_target_speed.data, config.speed_limit)" in code
    (package / "driving.ros_package").write_text(DRIVING)
    commit(package, "Write each in its own again")
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 0, result.stderr
    commit(package, "Update")
    assert names(package) == before
    assert (package / "scripts/planner").stat().st_mode & 0o111
    assert git(package, "diff", "--stat", filled, "--", "driving/planner_impl.py")


def test_answers_record_the_language(render):
    package = render(DRIVING, model="mixed_model")
    answers = yaml.safe_load((package / ".copier-answers.yml").read_text())
    assert [node["language"] for node in answers["spec"]["nodes"]] == ["python", "cpp"]
