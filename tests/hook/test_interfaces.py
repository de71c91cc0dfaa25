"""Specs of messages, services and actions: what they mean, and every refusal."""

import pytest

from hooks.faults import SpecError
from support.packages import model_of

MODEL = model_of("interfaces_model")
ABOUT = 'author="A" author_email="a@example.org" description="d" license="MIT"'


def context(inside, distro="kilted"):
    xml = f'<package name="arm_msgs" {ABOUT}>\n{inside}\n</package>'
    return MODEL.context(xml.encode(), "spec.xml", distro)


def message(inside, name="Pose"):
    return f'<message name="{name}">\n{inside}\n</message>'


def field(type_="int8", name="x", **more):
    shown = "".join(f' {key}="{value}"' for key, value in more.items())
    return f'<field name="{name}" type="{type_.replace("<", "&lt;")}"{shown}/>'


def constant(type_="int8", name="X", value="1"):
    return f'<constant name="{name}" type="{type_}" value="{value}"/>'


def refusal(inside, distro="kilted"):
    with pytest.raises(SpecError) as error:
        context(inside, distro)
    return str(error.value)


@pytest.mark.parametrize(
    ("written", "type_", "depends"),
    [
        ("float64", "float64", []),
        ("float64[3]", "float64[3]", []),
        ("Pose[]", "Pose[]", []),
        ("arm_msgs/Pose", "arm_msgs/msg/Pose", []),
        ("geometry_msgs::Point[]", "geometry_msgs/msg/Point[]", ["geometry_msgs"]),
        ("geometry_msgs::msg::Point", "geometry_msgs/msg/Point", ["geometry_msgs"]),
        ("geometry_msgs/msg/Point[2]", "geometry_msgs/msg/Point[2]", ["geometry_msgs"]),
        ("Header", "std_msgs/msg/Header", ["std_msgs"]),
        ("std_msgs/Header", "std_msgs/msg/Header", ["std_msgs"]),
    ],
)
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_types_of_both_ros(written, type_, depends, distro):
    other = message(field(written), "Arm") + message("")
    spec = context(other, distro)
    assert spec["messages"][0]["fields"][0]["type"] == type_
    assert spec["depends"] == depends


@pytest.mark.parametrize(
    "written", ["time", "builtin_interfaces::Time", "builtin_interfaces/msg/Time"]
)
def test_one_time_for_both_ros(written):
    for distro, depends in (("noetic", []), ("kilted", ["builtin_interfaces"])):
        spec = context(message(field(f"{written}[]")), distro)
        assert spec["messages"][0]["fields"][0]["type"] == "time[]"
        assert spec["depends"] == depends


@pytest.mark.parametrize(
    ("type_", "nearest"),
    [
        ("int8[<=3]", "bounds"),
        ("string<=10", "bounds"),
        ("string<=10[<=3]", "bounds"),
        ("wstring", "string"),
    ],
)
def test_types_of_ros2_alone(type_, nearest):
    context(message(field(type_)))
    text = refusal(message(field(type_)), "noetic")
    assert text.startswith('spec.xml:3: <field name="x">: type: ROS 1 has no ')
    assert nearest in text


def test_type_that_a_ros_lacks():
    assert "builtin_interfaces" in refusal(message(field("std_msgs::Time[]")))
    context(message(field("std_msgs::Time[]")), "noetic")


@pytest.mark.parametrize(
    ("type_", "said"),
    [
        ("floa64", 'did you mean "float64"? allowed: bool, '),
        ("int", '"int" is no type of ROS; did you mean "int32"?'),
        ("double[3]", '"double" is no type of ROS; did you mean "float64"?'),
        ("std::string", '"std::string" is no type of ROS; did you mean "string"?'),
        ("uint8_t", 'did you mean "uint8"?'),
        ("std::uint8_t[]", 'did you mean "uint8"?'),
        ("ros::Time", '"ros::Time" is no type of ROS; did you mean "time"?'),
        ("rclcpp::Time", '"rclcpp::Time" is no type of ROS; did you mean "time"?'),
        ("rclpy::Time", '"rclpy::Time" is no type of ROS; did you mean "time"?'),
        ("rospy::Time", '"rospy::Time" is no type of ROS; did you mean "time"?'),
        ("intt", 'did you mean "int'),
        ("", "not a field type"),
        ("int8[", "not a field type"),
        ("int8[3][3]", "not a field type"),
        ("int8[<=]", "not a field type"),
        ("int8[x]", "not a field type"),
        ("int8[0]", "a size must be from 1"),
        ("int8[99999999999]", "a size must be from 1"),
        ("int8<=3", "only a string has a bound"),
        ("Pose<=3", "only a string has a bound"),
        ("string<=0", "a size must be from 1"),
        ("geometry_msgs::point", 'did you mean "geometry_msgs::Point"?'),
        ("std_msgs::bool", 'did you mean "std_msgs::Bool"?'),
        ("geometry_msgs::srv::Point", "the type of a service"),
        ("a::b::c::D", "not a type"),
        (
            "Point",
            'not declared in this package; did you mean "geometry_msgs::Point"? allowed: Pose',
        ),
        (
            "arm_msgs::Poze[]",
            '"Poze" is not declared in this package; did you mean "Pose"? allowed: Pose',
        ),
        ("NULL", '"NULL" is not declared in this package'),
        ("std_msgs::String; int8 y", "not a field type"),
        ("int8\n", "not a field type"),
    ],
)
def test_types_that_are_refused(type_, said):
    text = refusal(message(field(type_)))
    assert text.startswith('spec.xml:3: <field name="x">: type: ')
    assert said in text


@pytest.mark.parametrize("type_", ["Pose", "Pose[]", "arm_msgs::Pose"])
def test_message_that_would_contain_itself(type_):
    text = refusal(message(field(type_)))
    assert text.startswith('spec.xml:3: <field name="x">: type: "Pose" would contain itself')
    text = refusal(message(field("Arm")) + "\n" + message(field(type_), "Arm"))
    assert text.startswith('spec.xml:6: <field name="x">: type: "Pose" would contain itself')
    context(message(field("Arm")) + message("", "Arm") + message(field(type_), "Leg"))


def test_service_is_no_type_of_a_field():
    assert "not declared" in refusal('<service name="Ask"/>' + message(field("Ask")))


@pytest.mark.parametrize(
    "name",
    "X x__y x_ _x 1x x-y xY class from int errno linux assert self check_fields builtins"
    " get_fields_and_field_types fields_and_field_types".split(),
)
def test_field_names_that_ros2_refuses(name):
    assert refusal(message(field(name=name))).startswith(f'spec.xml:3: <field name="{name}">: ')


@pytest.mark.parametrize(
    "name", "_x 1x x-y class int errno serialize deserialize_numpy Ptr Type".split()
)
def test_field_names_that_ros1_refuses(name):
    said = refusal(message(field(name=name)), "noetic")
    assert said.startswith(f'spec.xml:3: <field name="{name}">: ')


@pytest.mark.parametrize("name", "x x_y x1 x_1 map sequence data interface string final".split())
def test_field_names(name):
    """Some are keywords of IDL, which rosidl takes, and interfaces of ROS itself use."""
    for distro in ("noetic", "kilted"):
        context(message(field(name=name)), distro)


@pytest.mark.parametrize("name", "D K R P X x__y x_ xY from self check_fields".split())
def test_field_names_of_ros1(name):
    """CameraInfo has four of a letter; genpy gives keywords of Python another name."""
    context(message(field(name=name)), "noetic")


@pytest.mark.parametrize("name", "serialize deserialize Ptr1 s6_addr h_errno".lower().split())
def test_field_names_of_ros2(name):
    context(message(field(name=name)))


@pytest.mark.parametrize("name", ["x", "X_", "X__Y", "1X", "Xy", "EOF", "SLOT_TYPES", "NULL"])
def test_constant_names_that_are_refused(name):
    assert refusal(message(constant(name=name))).startswith("spec.xml:3: <constant name=")


@pytest.mark.parametrize(
    "name",
    "PRISM PRIMARY_STATE_ACTIVE CHAR_CONST PRIORITY_LOW PRIVATE SYS_OK M_PER_S INT_OVERFLOW"
    " SCN_OK DBL_CLICK SIG_OK CLOCK_SKEW SA_MODE MSG_SENT FE_X ASSERT MIN MAX".split(),
)
def test_constant_names_that_only_look_like_macros(name):
    for distro in ("noetic", "kilted"):
        context(message(constant(name=name)), distro)


@pytest.mark.parametrize(
    ("name", "distro", "other"),
    [
        ("NO_DATA", "noetic", "kilted"),
        ("TRY_AGAIN", "noetic", "kilted"),
        ("UUID_SIZE", "kilted", "noetic"),
    ],
)
def test_macros_of_one_ros(name, distro, other):
    said = f'"{name}" is a macro of C++ in ROS {1 if distro == "noetic" else 2}, so reserved'
    assert said in refusal(message(constant(name=name)), distro)
    context(message(constant(name=name)), other)


@pytest.mark.parametrize("kind", ["message", "service", "action"])
@pytest.mark.parametrize(
    "name", ["pose", "My_Pose", "1Pose", "None", "EOF", "Pöse", "../Pose", ""]
)
def test_interface_names_that_are_refused(kind, name):
    assert refusal(f'<{kind} name="{name}"/>').startswith(f'spec.xml:2: <{kind} name="{name}">: ')


@pytest.mark.parametrize("kind", ["message", "service", "action"])
@pytest.mark.parametrize("name", ["tfMessage", "My_Pose", "Header"])
def test_interface_names_of_ros1(kind, name):
    context(f'<{kind} name="{name}"/>', "noetic")


def test_kinds_have_names_of_their_own():
    """In ROS 1 a message and a service have the same header, a service and an action do not."""
    kinds = [f'<{kind} name="GetMap"/>' for kind in ("message", "service", "action")]
    context("".join(kinds))
    context("".join(kinds[1:]), "noetic")
    context("".join(kinds[::2]), "noetic")
    assert "GetMap" in refusal("".join(kinds[:2]), "noetic")


@pytest.mark.parametrize(
    ("one", "other", "said"),
    [
        ('<message name="Pose"/>', '<message name="POSE"/>', 'already taken by "Pose" at line 2'),
        (
            '<message name="Pose"/>',
            '<service name="Pose"/>',
            'makes the type "Pose", as <message name="Pose"> at line 2 does',
        ),
        (
            '<service name="Ask"/>',
            '<message name="AskRequest"/>',
            '"AskRequest", as <service name="Ask"> at line 2',
        ),
        ('<action name="Go"/>', '<message name="GOgoal"/>', 'as <action name="Go"> at line 2'),
        ('<action name="Go"/>', '<service name="GoAction"/>', '"GoAction"'),
    ],
)
def test_two_of_the_same(one, other, said):
    text = refusal(f"{one}\n{other}", "noetic")
    assert text.startswith("spec.xml:3: ")
    assert said in text


def test_two_members_of_the_same():
    for twice in (field(), constant()):
        assert "is already taken at line 3" in refusal(message(f"{twice}\n{twice}"))
    parts = "".join(f"<{part}>{field()}</{part}>" for part in ("request", "response"))
    context(f'<service name="Ask">{parts}</service>')


@pytest.mark.parametrize(
    ("type_", "text", "value"),
    [
        ("bool", "yes", True),
        ("uint8", "255", 255),
        ("int64", "-9223372036854775808", -(2**63)),
        ("uint64", "18446744073709551615", 2**64 - 1),
        ("float32", "0.5", 0.5),
        ("float64", "1e300", 1e300),
        ("string", "a b", "a b"),
        ("string", "", ""),
        ("uint8", "0xFF", 255),
        ("int8", "-0x10", -16),
        ("uint8", "0b101", 5),
        ("uint8", "0o17", 15),
        ("string[]", "['', a]", ["", "a"]),
        ("wstring", "Hellö wörld!", "Hellö wörld!"),
        ("wstring[]", "[ハロー]", ["ハロー"]),
        ("string", " it's # = ", " it's # = "),
        ("string<=3", "abc", "abc"),
        ("int8[2]", "[1, -2]", [1, -2]),
        ("int8[<=2]", "[1]", [1]),
        ("string[]", "['a, b', c]", ["a, b", "c"]),
    ],
)
def test_defaults(type_, text, value):
    spec = context(message(field(type_, default=text)))
    assert spec["messages"][0]["fields"][0]["default"] == value


@pytest.mark.parametrize(
    ("type_", "text", "said"),
    [
        ("bool", "2", "is not a bool"),
        ("int8", "128", "128 is no int8; allowed: -128 to 127"),
        ("uint8", "-1", "-1 is no uint8; allowed: 0 to 255"),
        ("byte", "256", "256 is no byte; allowed: -128 to 255"),
        ("char", "x", "not an int"),
        ("uint16", "65536", "allowed: 0 to 65535"),
        ("int64", "9223372036854775808", "is no int64"),
        ("uint64", "18446744073709551616", "is no uint64"),
        ("int32", "1.5", "not an int"),
        ("float32", "1e39", "is no float32"),
        ("float64", "nan", "is not a number"),
        ("string<=3", "abcd", "too long"),
        ("string<=3[2]", "[abcd, a]", "too long"),
        ("int8[2]", "[1]", "1 values do not fit int8[2]"),
        ("int8[<=2]", "[1, 2, 3]", "3 values do not fit int8[<=2]"),
        ("int8[]", "1", "is not an int8[]"),
        ("int8[]", "[300]", "300 is no int8"),
        ("time", "0", "no text is a value of time"),
        ("Pose", "0", "no text is a value of Pose"),
        ("geometry_msgs::Point[]", "[0]", "no text is a value of"),
        ("uint8", "010", "write 10, or 0o10 if it is octal"),
        ("uint8", "09", "write 9"),
        ("int8[]", "[1, 010]", "write 10"),
        ("uint8", "0xFFF", "4095 is no uint8"),
        ("uint8", "0x", "not an int"),
        ("int8[]", "[]", "must not be empty; drop the attribute"),
        ("byte", "-1", "-1 is no byte of ROS 2; allowed: 0 to 255"),
        ("string", "a&#10;b", "has a line break"),
        ("string", "a??/", "has a trigraph of C"),
        ("string", "\\\\", "has a backslash before a quote or another"),
        ("string[]", "['👍']", "has a sign beyond U+FFFF in a list"),
    ],
)
def test_defaults_that_are_refused(type_, text, said):
    shown = refusal(message(field(type_, default=text)))
    assert shown.startswith('spec.xml:3: <field name="x">: ')
    assert said in shown


@pytest.mark.parametrize(
    ("type_", "value"),
    [
        ("int8", "128"),
        ("int8", "010"),
        ("bool", "x"),
        ("string", "a&#10;b"),
        ("time", "1"),
        ("int8[]", "[1]"),
        ("Pose", "1"),
    ],
)
def test_constants_that_are_refused(type_, value):
    for distro in ("noetic", "kilted"):
        assert refusal(message(constant(type_, value=value)), distro).startswith(
            'spec.xml:3: <constant name="X">: '
        )


@pytest.mark.parametrize("value", ["a\\b", " a", "a "])
def test_texts_that_ros1_would_change(value):
    assert "which ROS 1 would change" in refusal(
        message(constant("string", value=value)), "noetic"
    )
    context(message(field("string", default=value)), "noetic")  # a comment there


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_lines_of_a_default_do_not_become_members(distro):
    inside = message(field("string", default="a&#10;int8 b"))
    assert "has a line break, which ROS 2 would change" in refusal(inside, distro)


def test_byte_of_ros1():
    for inside in (field("byte", default="200"), constant("byte", value="200")):
        context(message(inside))
        assert "200 is no byte of ROS 1" in refusal(message(inside), "noetic")
    for value in ("-1", "0x7f"):
        context(message(constant("byte", value=value)), "noetic")


@pytest.mark.parametrize(
    "inside",
    [
        '<service name="Ask"><goal/></service>',
        '<action name="Go"><request/></action>',
        '<message name="Pose"><request/></message>',
        f'<message name="Pose"><field name="y" type="int8">{field()}</field></message>',
        f'<service name="Ask">{field()}</service>',
        '<message name="Pose"/><request/>',
        '<service name="Ask"><request/><request/></service>',
        '<service name="Ask"><request name="x"/></service>',
        '<message name="Pose"/><node name="n"/>',
    ],
)
def test_elements_in_the_wrong_place(inside):
    assert refusal(inside).startswith("spec.xml:2: <")


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_skeleton(distro):
    text = MODEL.skeleton({"folder": "arm_msgs", "email": "a@example.org"})
    spec = MODEL.context(text.encode(), "spec.xml", distro)
    assert [len(spec[key]) for key in ("messages", "services", "actions")] == [1, 1, 1]
    assert spec["actions"][0]["feedback"]["fields"][0]["name"] == "example"


def test_types_of_actionlib_msgs_in_both():
    """ROS 2 has the package still; a `<depend>` of a node becomes that of its actions."""
    for distro in ("noetic", "kilted"):
        found = context(message(field("actionlib_msgs::GoalID")), distro)
        assert "actionlib_msgs" in found["depends"]
