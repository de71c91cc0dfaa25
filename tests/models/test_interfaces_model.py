"""Packages of messages, services and actions: their files, and what updates do to them."""

import xml.etree.ElementTree as ET

import pytest

from support.packages import DATA
from support.repository import EXAMPLES, commit

SPEC = (EXAMPLES / "contact_msgs.ros_package").read_text()
ODD = DATA / "odd_msgs.ros_package"


@pytest.fixture
def make(render):
    def run(spec, distro="kilted", name="contact_msgs"):
        return render(spec, model="interfaces_model", ros_distro=distro, name=name)

    return run


def test_action(make):
    assert (
        (make(SPEC) / "action/EvaluateContact.action").read_text()
        == """\
# Tell which of the contacts learned is taking place

# A duration without an end
float64 UNTIL_CANCELED=0

# How long to evaluate, in s
float64 duration 0.0
---

# The name of the contact; empty if it is none of them
string contact
---

# The latest center of pressure, in m
geometry_msgs/Point cop
"""
    )


@pytest.mark.parametrize(("distro", "told"), [("kilted", "# Of the feedback\n"), ("noetic", "")])
def test_constants_that_are_alike(make, distro, told):
    """rosidl gives constants of two parts that are alike, comments included, to the first part."""
    none = '<constant name="NONE" type="uint8" value="0" description="Nothing"/>'
    parts = f"<result>{none}</result><feedback>{none}</feedback>"
    package = make(
        SPEC.replace("</package>", f'<action name="Go">{parts}</action></package>'), distro
    )
    one = "# Nothing\nuint8 NONE=0\n"
    assert (package / "action/Go.action").read_text() == f"---\n\n{one}---\n\n{told}{one}"


def test_defaults_of_ros1_are_comments(make):
    assert (
        (make(SPEC, "noetic") / "srv/SetString.srv").read_text()
        == """\
# Hand a string, such as the name of a folder, to a node

# The string
string data
---

# Whether the node could use it
# Default: false
bool success
# Why it could not
string message
"""
    )


def test_default_of_ros1_does_not_end_a_comment(make):
    """genmsg repeats comments in those of C++."""
    spec = SPEC.replace('type="bool" default="false"', 'type="string" default="*/ b"')
    assert '# Default: "* / b"' in (make(spec, "noetic") / "srv/SetString.srv").read_text()


TEXTS = """<package name="text_msgs" author="Ada" author_email="ada@example.org"
         description="Texts" license="MIT">
  <message name="Texts">
    <constant name="HASH" type="string" value="#1"/>
    <constant name="QUOTES" type="string" value='a "b"'/>
    <constant name="LIMIT" type="uint8" value="0x0f"/>
    <constant name="YES" type="bool" value="True"/>
    <field name="text" type="string" default="#ä=\\t&quot;"/>
    <field name="texts" type="string[]" default="['#ö', b]"/>
    <field name="flags" type="bool[]" default="[yes, no]"/>
  </message>
  <message name="Nothing"/>
  <service name="Call"><request/></service>
</package>"""


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_texts_are_shown_as_they_are(make, distro):
    """And not with the escapes that rosidl needs."""
    package = make(TEXTS, distro, "text_msgs")
    readme = (package / "README.md").read_text()
    rows = {row.split("`")[1]: row.split(" | ")[2] for row in readme.splitlines() if "| `" in row}
    assert rows["HASH"] == r'"\#1"'
    assert rows["QUOTES"] == '"a "b""'
    assert (rows["LIMIT"], rows["YES"]) == ("15", "true")
    assert rows["text"] == r'"\#ä=\\t""'
    assert rows["texts"] == r'\["\#ö", "b"\]'
    assert rows["flags"] == r"\[true, false\]"
    assert "## Message Nothing\n\nIt has no fields.\n" in readme
    assert "Request: no fields." in readme
    if distro == "noetic":
        lines = (package / "msg/Texts.msg").read_text().splitlines()
        defaults = [line for line in lines if line.startswith("# Default: ")]
        assert defaults == [
            '# Default: "#ä=/t""',
            '# Default: ["#ö", "b"]',
            "# Default: [true, false]",
        ]


@pytest.mark.parametrize("spec", [SPEC, ODD.read_text()], ids=["contact_msgs", "odd_msgs"])
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_files_end_with_their_last_line(make, spec, distro):
    name = "odd_msgs" if "odd_msgs" in spec else "contact_msgs"
    for file in make(spec, distro, name).glob("*/*.*"):
        text = file.read_text()
        assert text == text.rstrip() + "\n" * bool(text), file


def test_comments_of_the_first_message_differ(make):
    """What the message is for is one thing, what its field is another."""
    lines = (make(None, name="arm_msgs") / "msg/Example.msg").read_text().splitlines()
    comments = [line for line in lines if line.startswith("# ")]
    assert len({*comments}) == len(comments) == 2


@pytest.mark.parametrize(("distro", "ros"), [("noetic", 1), ("kilted", 2)])
def test_types_as_each_ros_writes_them(make, distro, ros):
    package = make(ODD.read_text(), distro, "odd_msgs")
    arrays = (package / "msg/Arrays.msg").read_text().splitlines()
    time = "time" if ros == 1 else "builtin_interfaces/Time"
    for line in ("std_msgs/Header header", f"{time}[2] stamps", "Primitives[2] own"):
        assert line in arrays
    assert "Primitives[] same_own" in arrays
    assert "geometry_msgs/Pose[] poses" in arrays
    tree = ET.parse(package / "package.xml").getroot()
    depends = [element.text for element in tree.iter("depend")]
    added = {1: ["actionlib_msgs"], 2: ["action_msgs", "builtin_interfaces"]}[ros]
    assert depends == [*added, "geometry_msgs", "std_msgs"]
    group = [element.text for element in tree.iter("member_of_group")]
    assert group == (["rosidl_interface_packages"] if ros == 2 else [])


def test_texts_stay_comments(make):
    package = make(ODD.read_text(), name="odd_msgs")
    for file in package.glob("*/*.*"):
        for line in file.read_text().splitlines():
            if line.startswith("#"):
                assert not {"*/", "/*", "\\", "??/"} & {
                    line[i : i + n] for n in (1, 2, 3) for i in range(len(line))
                }
            else:
                assert "int x" not in line


def test_generators_named_as_dependencies_are_said_once(make):
    for distro, depend in (("noetic", "message_generation"), ("kilted", "rosidl_default_runtime")):
        spec = SPEC.replace("</package>", f"<depend>{depend}</depend></package>")
        text = (make(spec, distro, distro + "/contact_msgs") / "package.xml").read_text()
        assert f"<depend>{depend}</depend>" not in text


def test_every_field_is_in_the_readme(make):
    readme = (make(SPEC) / "README.md").read_text()
    for row in (
        "| `points` | `geometry_msgs/Point[]` |  | Each in the frame of the sensor, in m |",
        "| `success` | `bool` | false | Whether the node could use it |",
        "| `UNTIL_CANCELED` | `float64` | 0 | A duration without an end |",
    ):
        assert f"\n{row}\n" in readme
    assert "#include <contact_msgs/msg/point_array.hpp>" in readme


def test_update_keeps_edits_and_follows_a_rename(make, copier_command):
    package = make(SPEC)
    message = package / "msg/PointArray.msg"
    message.write_text(f"# By hand\n{message.read_text()}")
    spec = package / "contact_msgs.ros_package"
    text = spec.read_text().replace('"PointArray"', '"Points" was="PointArray"')
    text = text.replace('name="data"', 'name="text" was="data"')
    added = '<field name="count" type="uint8"/>\n    </result>'
    spec.write_text(text.replace("</result>", added, 1))
    commit(package)
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 0, result.stderr
    for line in (
        "> message Points, was PointArray",
        "> field text on SetString.request, was data",
        "+ field count on LearnContact.result",
        "moved     msg/PointArray.msg -> msg/Points.msg",
    ):
        assert line in result.stderr
    assert (package / "msg/Points.msg").read_text().startswith("# By hand\n")
    assert not message.exists()
    assert "string text\n" in (package / "srv/SetString.srv").read_text()
    assert "uint8 count\n" in (package / "action/LearnContact.action").read_text()
    assert "CONFLICT" not in result.stderr


def test_update_of_what_has_not_changed(make, update):
    """Every value that a spec can have is the same when it is read from the recorded answers."""
    assert update(make(ODD.read_text(), name="odd_msgs")) == ""


def test_update_to_the_other_ros(make, update):
    package = make(SPEC, "noetic")
    update(package, ros_distro="kilted")
    assert "rosidl_generate_interfaces" in (package / "CMakeLists.txt").read_text()
    assert "bool success false" in (package / "srv/SetString.srv").read_text()


@pytest.mark.parametrize(
    ("distro", "command"), [("noetic", "rosmsg package"), ("kilted", "ros2 interface package")]
)
def test_words_while_copying(collection, copier_command, tmp_path, distro, command):
    """A package of interfaces has nothing to run; one sees what is in it."""
    data = ("-d", "model=interfaces_model", "-d", f"ros_distro={distro}")
    result = copier_command(
        "copy", "--trust", "--defaults", *data, collection, "arm_msgs", cwd=tmp_path
    )
    assert result.returncode == 0, result.stderr
    assert f"{command} arm_msgs" in result.stderr
    assert "EXECUTABLE" not in result.stderr
    assert (tmp_path / "arm_msgs/srv/ExampleService.srv").exists()
