"""Every definition that is installed can be written as a spec, and comes out the same."""

import json
from xml.sax.saxutils import quoteattr

import pytest

from support import ros
from support.packages import model_of
from support.repository import ROOT

READ = ROOT / "tests/support/read_definitions.py"
MODEL = model_of("interfaces_model")
PARTS = {
    "msg": ("message", []),
    "srv": ("service", ["request", "response"]),
    "action": ("action", ["goal", "result", "feedback"]),
}
ABOUT = 'author="A" author_email="a@example.org" description="d" license="MIT"'


def read(ros_, *folder):
    """Return the definitions in a folder of packages, or all installed, as ROS reads them."""
    command = " ".join(map(str, (ros_.python, READ, *folder)))
    return json.loads(ros_.run(command, ROOT).stdout)


def made_by_actions(files):
    """Return the messages that genmsg makes of actions, which it installs beside them."""
    parts = ("", "Goal", "Result", "Feedback")
    ends = {f"{action}{part}" for action in ("", "Action") for part in parts} - {""}
    names = [file[7:-7] for file in files if file.startswith("action/")]
    return {f"msg/{name}{end}.msg" for name in names for end in ends}


def attributes(**given):
    """Return attributes as XML, in which a line break is written as a reference."""
    found = {key: value for key, value in given.items() if value not in (None, "")}
    shown = " ".join(f"{key}={quoteattr(value)}" for key, value in found.items())
    return shown.replace("\n", "&#10;")


def text_of(value):
    """Return a value as a spec writes it."""
    if isinstance(value, list):
        return json.dumps(value, ensure_ascii=False)
    return json.dumps(value) if isinstance(value, bool) else str(value)


def about(item):
    """Return the description of what rosidl has read."""
    unit = f" [{item['unit']}]" if item.get("unit") else ""
    return "\n".join(item.get("comment", [])) + unit


def members(part):
    """Return the fields and constants of a part as XML."""
    found = []
    for item in part["constants"]:
        value = item["val_text"] if "val_text" in item else text_of(item["value"])
        more = attributes(type=item["type"], description=about(item))
        found.append(f"<constant name={quoteattr(item['name'])} value={quoteattr(value)} {more}/>")
    for item in part["fields"]:
        value = item.get("value")
        default = "" if value is None else f"default={quoteattr(text_of(value))}"
        more = attributes(type=item["type"], description=about(item))
        found.append(f"<field name={quoteattr(item['name'])} {default} {more}/>")
    return "\n".join(found)


def spec(name, files):
    """Return the spec of a package with the definitions that its ROS has read."""
    found = []
    for file, parts in files.items():
        folder, _, word = file.rpartition(".")[0].rpartition("/")
        tag, names = PARTS[folder]
        inside = [members(part) for part in parts]
        if names:
            pairs = zip(names, inside, strict=True)
            inside = [f"<{part}>\n{each}\n</{part}>" for part, each in pairs]
        more = attributes(name=word, description=about(parts[0]))
        found.append(f"<{tag} {more}>\n" + "\n".join(inside) + f"\n</{tag}>")
    return f'<package name="{name}" {ABOUT}>\n' + "\n".join(found) + "\n</package>\n"


def compared(files):
    """Return definitions with what must be the same, comments by their words."""
    found = json.loads(json.dumps(files))
    for parts in found.values():
        for number, part in enumerate(parts):
            for item in [part, *part["fields"], *part["constants"]]:
                words = " ".join(item.pop("comment", [])).replace("\\", "/").split()
                if item is not part or number == 0:  # only the first part has a description
                    item["words"] = words
    return found


def put(renderers, xml, distro, folder):
    """Write the definitions of a package of a spec into a folder."""
    context = MODEL.context(xml.encode(), "spec.xml", distro)
    for path, text in renderers["interfaces_model"].render(context, distro).items():
        if path.split("/")[0] in PARTS:
            file = folder / context["name"] / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)


@pytest.fixture(params=["noetic", "kilted"])
def ros_(request):
    """Each ROS; what the tests need of it is its parser."""
    found = ros.ros1() if request.param == "noetic" else ros.ros2()
    return found or pytest.skip(f"{request.param} is not installed")


def test_every_installed_definition(ros_, renderers, tmp_path):
    distro = "noetic" if ros_.distro == "noetic" else "kilted"
    expected = {}
    for name, files in read(ros_).items():
        made = made_by_actions(files)
        expected[f"own_{name}"] = {f: parts for f, parts in files.items() if f not in made}
        put(renderers, spec(f"own_{name}", expected[f"own_{name}"]), distro, tmp_path)
    assert len(expected) >= 15
    found = read(ros_, tmp_path)
    for own, files in expected.items():
        same = compared(found[own])
        assert same.keys() == files.keys()
        for file, parts in compared(files).items():
            assert same[file] == parts, f"{own}/{file}"


COMMENTED = """
<message name="Speed"><field name="x" type="int8" description="Speed [m/s]"/></message>
<message name="Both" description="Of two&#10;&#10;paragraphs">
  <constant name="X" type="int8" value="1" description="A&#10;&#10;B [rad]"/>
  <field name="x" type="int8" description="Speed [m/s]"/>
</message>
<service name="Ask">
  <request><field name="x" type="int8" description="Speed [m/s]"/></request>
  <response><field name="x" type="int8" description="Speed [m/s]"/></response>
</service>
<action name="Go">
  <goal><constant name="X" type="int8" value="1" description="Speed [m/s]"/></goal>
  <result><field name="x" type="int8" description="Speed [m/s]"/></result>
  <feedback><field name="x" type="int8" description="Speed [m/s]"/></feedback>
</action>
"""


def test_comments_as_rosidl_reads_them(renderers, tmp_path):
    """The comment of the first member of a part is not that of the whole."""
    ros2 = ros.ros2() or pytest.skip(ros.NO_ROS2)
    put(renderers, f'<package name="own" {ABOUT}>{COMMENTED}</package>', "kilted", tmp_path)
    found = read(ros2, tmp_path)["own"]
    both = found.pop("msg/Both.msg")[0]
    assert [both["comment"], both["constants"][0]["comment"]] == [
        ["Of two", "", "paragraphs"],
        ["A", "", "B"],
    ]
    parts = [part for parts in found.values() for part in parts]
    assert len(parts) == 6
    for part in parts:
        (member,) = (*part["fields"], *part["constants"])
        assert (part["comment"], member["comment"], member["unit"]) == ([], ["Speed"], "m/s")


def test_header_of_the_package_itself(ros_, renderers, tmp_path):
    types = ("Header", "own::Header")
    fields = "".join(f'<field name="{x}" type="{t}"/>' for x, t in zip("ab", types, strict=True))
    xml = f'<message name="Header"/><message name="Own">{fields}</message>'
    put(renderers, f'<package name="own" {ABOUT}>{xml}</package>', ros_.distro, tmp_path)
    (part,) = read(ros_, tmp_path)["own"]["msg/Own.msg"]
    assert [field["type"] for field in part["fields"]] == ["std_msgs/Header", "Header"]


@pytest.mark.parametrize(
    ("type_", "value", "ros1", "ros2"),
    [
        ("float32", "1.50", "1.50", 1.5),
        ("float64", "5", "5", 5.0),
        ("int8", "+5", "+5", 5),
        ("bool", "1", "1", True),
        ("bool", "True", "True", True),
        ("bool", "yes", "True", True),
        ("uint8", "0xFF", "255", 255),
        ("uint8", "0b11", "3", 3),
        ("string", "it's &quot;a&quot; b?", 'it\'s "a" b?', 'it\'s "a" b?'),
        ("string", "für", "für", "für"),
        ("string", "x # y = z", "x # y = z", None),
    ],
)
def test_constants_as_written(ros_, renderers, tmp_path, type_, value, ros1, ros2):
    """The checksum of ROS 1 is made of the text of a constant, not of its value."""
    xml = f'<message name="M"><constant name="X" type="{type_}" value="{value}"/></message>'
    put(renderers, f'<package name="own" {ABOUT}>{xml}</package>', ros_.distro, tmp_path)
    (constant,) = read(ros_, tmp_path)["own"]["msg/M.msg"][0]["constants"]
    if ros_.distro == "noetic":
        assert constant["val_text"] == ros1
    elif ros2 is not None:
        assert constant["value"] == ros2
