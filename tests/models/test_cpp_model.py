"""cpp_model without rclcpp: as far as the wheels of ROS 2 reach.

Covered here: messages, interface layer and logic are compiled and their unit tests run;
every file is held against ROS 2's linters, `<node>_ros.cpp` among them. Not covered: compiling
`<node>_ros.cpp` and the headers it includes from src/, which needs rclcpp; test_ros2.py does that
where rclcpp is installed, and test_ros1.py compiles their twins of ROS 1. For Humble, the headers
whose code depends on its signatures are compiled with the declarations of data/humble.
"""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
import yaml

from support.packages import DATA, DISTROS, HOSTILE, SPECS, all_kinds, files, fill_in
from support.repository import EXAMPLES

MESSAGES = {"geometry_msgs", "std_msgs", "std_srvs", "test_msgs"}


@pytest.mark.ros2
@pytest.mark.parametrize("spec", [all_kinds(), HOSTILE], ids=["all_kinds", "hostile"])
def test_logic_compiles_and_passes_its_tests(ros2, render, tmp_path, spec):
    package = render(spec, model="cpp_model", ros_distro=ros2.distro)
    if spec != HOSTILE:  # tests as a developer adds them, of a logic that does something
        fill_in(package, "cpp_model")
        own = package / "test/test_worker_impl.cpp"
        own.write_text(own.read_text() + (DATA / "logic/worker_tests.cpp").read_text())
    recorded = yaml.safe_load((package / ".copier-answers.yml").read_text())["spec"]
    nodes = ";".join(node["name"] for node in recorded["nodes"])
    depends = ";".join(sorted(MESSAGES & {*recorded["depends"], "std_msgs"}))
    build = tmp_path / "build"
    build.mkdir()
    options = f"-DPACKAGE={package} '-DNODES={nodes}' '-DDEPENDS={depends}'"
    ros2.run(f"cmake {DATA}/logic_only {options}", build)
    ros2.run("make -j2", build)
    result = ros2.run("ctest", build).stdout
    assert "100% tests passed" in result, result


@pytest.mark.ros2
@pytest.mark.parametrize("distro", ["noetic", "humble", "rolling"])
@pytest.mark.parametrize("spec", [all_kinds(), HOSTILE, None], ids=["all", "hostile", "starter"])
def test_linters(ros2, render, spec, distro):
    package = render(spec, model="cpp_model", ros_distro=distro)
    ros2.run("ament_cpplint .", package)
    for linter in ("uncrustify", "cppcheck"):
        if not shutil.which(linter):
            pytest.skip(f"{linter} is not installed")
        options = "--language C++ " if linter == "uncrustify" else ""
        ros2.run(f"ament_{linter} {options}include src test", package)


@pytest.mark.parametrize("name", SPECS)
def test_logic_is_the_same_for_all_ros(render, name):
    packages = [
        render(SPECS[name], model="cpp_model", ros_distro=distro, name=f"{distro}/same")
        for distro in DISTROS
    ]
    first, *others = [
        {
            file.name: file.read_bytes()
            for file in files(package, "*_impl.?pp")
            if "recorder" not in file.parts
        }
        for package in packages
    ]
    assert first
    assert all(other == first for other in others)


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_logic_names_no_client_library(render, distro):
    """The interface and the logic include messages alone, so that they compile without ROS."""
    package = render(SPECS["all kinds"], model="cpp_model", ros_distro=distro)
    logic = [*(package / "include").rglob("*.hpp"), *(package / "src").glob("*_impl.cpp")]
    for file in logic:
        text = file.read_text()
        for word in ("rclcpp", "roscpp", "ros/ros.h", "ros::", "tf2_ros", "actionlib/"):
            assert word not in text, f"{file.name} names {word}"


REPORTING = """
<package name="shop" author="Ada" author_email="ada@example.org" description="Counts"
         license="Apache-2.0" copyright="2026 Ada">
  <node name="idler"/>
  <node name="clerk" diagnostics="true"/>
  <node name="ticker" frequency="10"/>
  <node name="gauge" frequency="10" diagnostics="true"/>
</package>
"""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("spec", [all_kinds(), REPORTING], ids=["all_kinds", "reporting"])
def test_node_includes_what_it_uses(render, spec, distro):
    """Of the headers beside it, each defines something that the node names."""
    package = render(spec, model="cpp_model", ros_distro=distro)
    for file in (package / "src").glob("*_ros.cpp"):
        text = file.read_text()
        included = re.findall(r'^#include "(ros/.*\.hpp)"', text, re.MULTILINE)
        code = re.sub("(?m)^#include.*|//.*", "", text)
        assert included
        for header in included:
            defined = re.findall(DEFINED, (package / "src" / header).read_text(), re.MULTILINE)
            assert any(re.search(rf"\b{name}\b", code) for name in defined), (file.name, header)


# Types and functions at the level of the namespace, which is not indented.
DEFINED = r"^(?:(?:class|struct|enum class) (?=\w+)|[a-z][^(\n]* (?=\w+\())(\w+)"


def test_launch_file_composes_what_it_starts_alone(render):
    """The same nodes, with the same names and parameters, loaded as what CMake registers."""
    package = render(all_kinds(), model="cpp_model")
    launch = ET.parse(package / "launch/all_kinds.launch.xml").getroot()
    (composition,) = launch.findall("arg[@name='composition']")
    assert composition.get("default") == "false"
    (container,) = launch.findall("node_container")
    assert container.get("if") == "$(var composition)"
    components = container.findall("composable_node")
    alone = launch.findall("node")
    assert len(components) == len(alone) == 2
    cmake = (package / "CMakeLists.txt").read_text()
    for component, node in zip(components, alone, strict=True):
        assert node.get("unless") == "$(var composition)"
        for name in ("pkg", "name", "namespace"):
            assert component.get(name) == node.get(name)
        given, alone_given = ([p.attrib for p in x.findall("param")] for x in (component, node))
        assert given == alone_given
        assert len(given) == 3
        (extra,) = component.findall("extra_arg")
        assert extra.attrib == {"name": "use_intra_process_comms", "value": "true"}
        assert f' "{component.get("plugin")}")' in cmake


def test_launch_file_composes_the_nodes_in_cpp_alone(render):
    package = render(EXAMPLES / "driving.ros_package", model="mixed_model")
    launch = ET.parse(package / "launch/driving.launch.xml").getroot()
    composed = [item.get("name") for item in launch.iter("composable_node")]
    unless = [item.get("name") for item in launch.findall("node") if item.get("unless")]
    assert composed == unless == ["controller"]
    assert len(launch.findall("node")) == 2


FREEING = """
#include "ros/inbox.hpp"

void look();

struct Message
{
  ~Message() {look();}
};

all_kinds::Inbox<Message> inbox;
bool is_looking = true;

/// Take a message, which waits for ever while the inbox is locked.
void look()
{
  if (!is_looking) {
    is_looking = true;
    Message taken;
    inbox.take(taken);
  }
}

int main()
{
  using Pointer = decltype(inbox)::Pointer;
  inbox.put(Pointer(new Message));
  is_looking = false;
  inbox.put(Pointer(new Message));
}
"""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_inbox_frees_no_message_under_its_lock(render, tmp_path, distro):
    if distro == "noetic" and not Path("/usr/include/boost").exists():
        pytest.skip("Boost is not installed")
    package = render(all_kinds(), model="cpp_model", ros_distro=distro)
    (tmp_path / "main.cpp").write_text(FREEING)
    command = ["g++", "-std=c++17", "-pthread", "-I", package / "src", "main.cpp", "-o", "main"]
    subprocess.run(command, cwd=tmp_path, check=True)
    subprocess.run(tmp_path / "main", check=True, timeout=10)


OF_ONE_KIND = """
<package name="lab" author="A" author_email="a@example.org" description="d" license="MIT">
  <node name="talk"><{kind} name="x"{type}/></node>
</package>
"""


@pytest.mark.parametrize(
    ("kind", "type_"),
    [
        ("directPublisher", "std_msgs::String"),
        ("directSubscriber", "std_msgs::String"),
        ("serviceServer", "std_srvs::Empty"),
        ("serviceClient", "std_srvs::Empty"),
        ("actionServer", "test_msgs::Fibonacci"),
        ("actionClient", "test_msgs::Fibonacci"),
        ("listener", ""),
        ("broadcaster", ""),
    ],
)
def test_package_of_one_kind(render, tmp_path, kind, type_):
    """Its fakes and what they stand for compile, and no comment is about another kind."""
    spec = OF_ONE_KIND.format(kind=kind, type=f' type="{type_}"' if type_ else "")
    package = render(spec, model="cpp_model", name="lab")
    texts = "".join(file.read_text() for file in package.rglob("*.[hm][pd]*"))
    assert ("serve_NAME" in texts) == (kind == "serviceServer")
    found = [*package.glob("include/lab/ros/*"), *package.glob("test/support/fakes.hpp")]
    (tmp_path / "main.cpp").write_text("".join(f'#include "{path}"\n' for path in found))
    include = f"-I{package}/include"
    command = ["g++", "-std=c++17", "-fsyntax-only", "-Wall", "-Werror", include, "main.cpp"]
    subprocess.run(command, cwd=tmp_path, check=True)


LATE = """
#include "ros/calls.hpp"

int main()
{
  const auto nothing = [] {};
  all_kinds::Calls calls([](const std::string &) {});
  calls.open();
  const auto pass = calls.pass();
  const bool is_in_time = calls.run(pass, "serve", nothing);
  calls.close();
  calls.open();
  const bool is_late = !calls.run(pass, "serve", nothing);
  return is_in_time && is_late && calls.run(calls.pass(), "serve", nothing) ? 0 : 1;
}
"""


def test_callback_of_an_earlier_activation_is_too_late(render, tmp_path):
    """Its logic may have cleaned up, though the node is active again, with another one."""
    package = render(all_kinds(), model="cpp_model", ros_distro="kilted")
    (tmp_path / "main.cpp").write_text(LATE)
    command = ["g++", "-std=c++17", "-pthread", "-I", package / "src", "main.cpp", "-o", "main"]
    subprocess.run(command, cwd=tmp_path, check=True)
    subprocess.run(tmp_path / "main", check=True, timeout=10)


SHOP = """
<package name="shop" author="Ada" author_email="ada@example.org" description="Sells"
         license="Apache-2.0" copyright="2026 Ada">
  <node name="clerk" frequency="10" diagnostics="true">
    <serviceServer name="serve" type="std_srvs::Trigger"/>
    <serviceClient name="order" type="std_srvs::Trigger"/>
  </node>
</package>
"""

SERVING = """
#include "ros/diagnostics.hpp"
#include "ros/managed_node.hpp"
#include "ros/ros_service_client.hpp"
#include "ros/service_server.hpp"
#include "ros/timing.hpp"

struct Trigger
{
  struct Request {};
  struct Response {};
};

struct Logic
{
  void serve(const Trigger::Request &, Trigger::Response &) {}
};

class Clerk : public shop::ManagedNode
{
public:
  explicit Clerk(const rclcpp::NodeOptions & options)
  : ManagedNode("clerk", options)
  {
  }

private:
  std::shared_ptr<shop::Session> make_session() override {return nullptr;}
};

int main(int argc, char ** argv)
{
  return shop::run_node<Clerk>(argc, argv);
}

void run(const rclcpp::Clock::SharedPtr & clock, const std::shared_ptr<shop::Stop> & stop)
{
  shop::Loop(shop::Sleeper(clock, stop), 10.0, rclcpp::get_logger("clerk")).run([] {});
}

void serve(shop::ManagedNode & node)
{
  shop::Diagnostics(node, nullptr);
  shop::RosServiceClient<Trigger>(node, "trigger");
  shop::create_service_server<Trigger>(
    node, "trigger", std::make_shared<Logic>(), &Logic::serve);
}
"""


def test_life_cycle_and_services_compile_in_humble(render, tmp_path):
    """Where later distributions have signatures that Humble lacks, data/humble has Humble's."""
    package = render(SHOP, model="cpp_model", ros_distro="humble")
    headers = [*(package / "src/ros").glob("*.hpp")]
    included = {name for file in headers for name in re.findall(INCLUDED, file.read_text())}
    for name in included:
        header = tmp_path / name
        header.parent.mkdir(parents=True, exist_ok=True)
        header.write_text('#include "humble.hpp"\n')
    (tmp_path / "main.cpp").write_text(SERVING)
    folders = [package / "src", package / "include", tmp_path, DATA / "humble"]
    command = ["g++", "-std=c++17", "-fsyntax-only", *(f"-I{folder}" for folder in folders)]
    subprocess.run([*command, "main.cpp"], cwd=tmp_path, check=True)


# Headers of ROS, unlike those of the package itself.
INCLUDED = r'(?m)^#include "((?:rcl\w*|\w+_msgs|rcl_interfaces)/.*)"'


PLAIN = """<package name="plain" author="A" author_email="a@example.org" license="MIT"
                  description="d">
  <node name="n" frequency="1" client_library="true">{}</node></package>"""


@pytest.mark.parametrize("model", ["cpp_model", "mixed_model"])
def test_every_node_and_its_logic_tests_link_what_depend_names(render, model):
    """Though another node has types of that package, or the node links it for itself alone."""
    spec = """
<package name="lab" author="A" author_email="a@example.org" description="d" license="MIT">
  <node name="talk" language="cpp"><directPublisher name="said" type="std_msgs::String"/></node>
  <node name="look" language="cpp"><listener name="frames"/></node>
  <depend>std_msgs</depend>
  <depend>tf2</depend>
</package>
"""
    spec = spec if model == "mixed_model" else spec.replace(' language="cpp"', "")
    cmake = (render(spec, model=model, name="lab") / "CMakeLists.txt").read_text()
    for node in ("talk", "look"):
        for target in (f"${{PROJECT_NAME}}_{node}", f"test_{node}_impl"):
            (linked,) = re.findall(
                rf"target_link_libraries\({re.escape(target)}\n(.*?)\n *\)", cmake, re.S
            )
            public = linked.partition("PRIVATE")[0].split()
            assert [public.count(f"${{{name}_TARGETS}}") for name in ("std_msgs", "tf2")] == [1, 1]


def test_comment_of_the_client_library_is_broken_once(render):
    """Not in the template and then again in a line that is too long with its names."""
    package = render(PLAIN.format(""), model="cpp_model", name="plain")
    lines = (package / "include/plain/n_interface.hpp").read_text().splitlines()
    at = next(i for i, line in enumerate(lines) if "The node of rclcpp" in line)
    words = lines[at + 1].split()[1:]
    assert len(f"{lines[at]} {words[0]}") > 99
    assert words[-1] == "it."


@pytest.mark.parametrize(
    ("tag", "said"),
    [
        ("", "cycle: none."),
        ("subscriber", "in_<topic>_updated: whether it is new."),
        ("publisher", "out_<topic>_subscribers: how many subscribe to it."),
    ],
)
@pytest.mark.parametrize(
    ("model", "file"),
    [("cpp_model", "include/plain/n_interface.hpp"), ("python_model", "plain/n_interface.py")],
)
def test_data_is_explained_as_far_as_there_is_any(render, model, file, tag, said):
    inside = f'<{tag} name="t" type="std_msgs::String"/>' if tag else ""
    text = (render(PLAIN.format(inside), model=model, name="plain") / file).read_text()
    assert said in text
    for word, kind in (("in_<topic>", "subscriber"), ("out_<topic>", "publisher")):
        assert (word in text) == (tag == kind)


@pytest.mark.parametrize("model", ["cpp_model", "mixed_model"])
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_system_packages_have_the_names_of_cmake(render, model, distro):
    """What rosdep calls eigen is Eigen3 to CMake, and what it links has a name of its own."""
    spec = """
<package name="mapper" author="A" author_email="a@example.org" description="d" license="MIT">
  <node name="one" language="cpp"><directPublisher name="x" type="std_msgs::String"/></node>
  <depend>eigen</depend>
  <depend>yaml-cpp</depend>
  <depend>some_package</depend>
  <depend>some-library</depend>
  <depend kind="build">nlohmann-json-dev</depend>
</package>
"""
    text = spec if model == "mixed_model" else spec.replace(' language="cpp"', "")
    package = render(text, model=model, ros_distro=distro)
    cmake = (package / "CMakeLists.txt").read_text()
    for name in ("Eigen3", "yaml-cpp", "nlohmann_json"):
        assert cmake.count(f"find_package({name} REQUIRED)") == 1
    assert not re.search(r"(?i)\beigen_|yaml-cpp_|json-dev|some-library", cmake)
    commands = re.findall(r"target_link_libraries\((.*?)\)\n", cmake, re.S)
    users = [each for each in commands if "some_package" in each or "catkin_LIBRARIES" in each]
    assert len(users) > 1
    for each in users:
        for library in ("Eigen3::Eigen", "${YAML_CPP_LIBRARIES}", "nlohmann_json::nlohmann_json"):
            assert library in each.split(), each
    exported = cmake.partition("ament_export_dependencies(")[2].partition(")")[0].split()
    assert exported == (["Eigen3", "std_msgs", "yaml-cpp"] if distro == "kilted" else [])
    depends = {element.text for element in ET.parse(package / "package.xml").getroot()}
    assert {"eigen", "yaml-cpp", "nlohmann-json-dev"} <= depends
