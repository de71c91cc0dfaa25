"""What a text of a spec is worth, by the format of its attribute, or why it is refused."""

import re
import sys

import pytest

from hooks.faults import SpecError
from hooks.formats import FORMATS, FORMATS_OF_ROS, comparable, split_type
from hooks.literals import literal, spelled

LONG = "a" * 100
LETTERS = "letters, digits and underscores, a letter first"
SINGLE = "and single underscores, a letter first"
TYPE = "allowed: package::Type, package/Type, package/msg/Type, such as std_msgs/String"
FIELD = "allowed: a primitive type, Type, package::Type; [], [3] or [<=3] after it"
TAKEN = '"for" is a keyword of Python and C++; choose another [reserved-name]'
NAME = "a letter, then letters, digits and single underscores"


@pytest.mark.parametrize(
    ("format_", "text", "value"),
    [
        ("raw", " a\tb\n\r", " a\tb\n\r"),
        ("raw", "\u200d\ufeff\ufffd", "\u200d\ufeff\ufffd"),
        ("text", " a b ", "a b"),
        ("string", " a b ", " a b "),
        ("identifier", "a1_B2_", "a1_B2_"),
        ("identifier", LONG, LONG),
        ("component_name", "con1", "con1"),
        ("grouped_name", "a/b_c.d1_", "a.b_c.d1_"),
        ("dotted_name", "a/b_c.d1_", "a.b_c.d1_"),
        ("dotted_name", "for", "for"),
        ("package_name", "a1_b2", "a1_b2"),
        ("ros_name", "a/b_c", "a/b_c"),
        ("ros_name", "/a1/b", "/a1/b"),
        ("ros_name", "~a/b", "~/a/b"),
        ("ros_name", "~/a", "~/a"),
        ("ros_name", "a_", "a_"),
        ("message_type", "a::B_1", "a/msg/B_1"),
        ("message_type", "a::msg::b", "a/msg/b"),
        ("service_type", "a/srv/B", "a/srv/B"),
        ("action_type", "a::B", "a/action/B"),
        ("stamped_type", "geometry_msgs::PoseStamped", "geometry_msgs/msg/PoseStamped"),
        ("stamped_type", "a::B", "a/msg/B"),
        ("field_type", "uint8", "uint8"),
        ("field_type", "uint8[03]", "uint8[3]"),
        ("field_type", "string<=10[<=2147483647]", "string<=10[<=2147483647]"),
        ("field_type", "wstring<=1[]", "wstring<=1[]"),
        ("field_type", "Pose", "Pose"),
        ("field_type", "a::Pose[]", "a/msg/Pose[]"),
        ("field_type", "Header", "std_msgs/msg/Header"),
        ("field_type", "builtin_interfaces::Time", "time"),
        ("field_type", "builtin_interfaces/Duration[]", "duration[]"),
        ("number", " 1e3 ", 1000.0),
        ("double", "0", 0.0),
        ("double", str(-sys.float_info.min), -sys.float_info.min),
        ("bool", " YES\n", True),
        ("bool", "on", True),
        ("bool", "false", False),
        ("bool", "OFF", False),
        ("int", " -0x1f ", -31),
        ("int", "+0b11", 3),
        ("int", "0O17", 15),
        ("int", "0", 0),
        ("int", str(-(2**63)), -(2**63)),
        ("int", str(2**63 - 1), 2**63 - 1),
        ("email", "a.b-c+d@e-f.g.de", "a.b-c+d@e-f.g.de"),
        ("version", "0.10.2", "0.10.2"),
        ("url", "https://a.b/c?d=e#f", "https://a.b/c?d=e#f"),
        ("file_name", "_a-b.1", "_a-b.1"),
        ("license", " Apache License 2.0 ", "Apache-2.0"),
        ("license", "https://opensource.org/licenses/MIT", "MIT"),
        ("license", "http://www.gnu.org/licenses/gpl-3.0.en.html", "GPL-3.0-only"),
        ("dependency", "a-b.c+d_1", "a-b.c+d_1"),
        ("interface_name", "A_b", "A_b"),
        ("field_name", "A__b", "A__b"),
        ("field_name", "module", "module"),
        ("constant_name", "a_B", "a_B"),
        ("ROS 2 interface_name", "AbC1", "AbC1"),
        ("ROS 2 field_name", "a1_b2", "a1_b2"),
        ("ROS 2 constant_name", "A1_B2", "A1_B2"),
    ],
)
def test_value(format_, text, value):
    found = format_named(format_)(text)
    assert (found, type(found)) == (value, type(value))


@pytest.mark.parametrize(
    ("format_", "text", "says"),
    [
        ("raw", "a\x07", "U+0007 is a control character; drop it [control-character]"),
        ("raw", "\u2028", "U+2028 is a control character; drop it [control-character]"),
        ("raw", "\u202e", "U+202E is a control character; drop it [control-character]"),
        ("raw", "\ud800", "U+D800 is a control character; drop it [control-character]"),
        ("raw", "\uffff", "U+FFFF is no character; drop it [control-character]"),
        ("text", "\x07", "U+0007 is a control character; drop it [control-character]"),
        ("identifier", "a__b", f'"a__b" is not a valid name; allowed: {NAME} [invalid-name]'),
        ("identifier", "é", f'"é" is not a valid name; allowed: {NAME} [invalid-name]'),
        (
            "identifier",
            f"{LONG}a",
            f'"{"a" * 60}..." is too long; allowed: 100 characters [too-long]',
        ),
        ("identifier", "for", TAKEN),
        ("component_name", "CON", '"con" is a device of Windows; choose another [reserved-name]'),
        (
            "grouped_name",
            "a..b",
            f'"a..b" is not a valid name; allowed: {NAME}; a "." between nested ones'
            " [invalid-name]",
        ),
        ("grouped_name", "for", TAKEN),
        (
            "dotted_name",
            "a__b",
            f'"a__b" is not a valid name; allowed: {NAME}; a "." between nested ones'
            " [invalid-name]",
        ),
        (
            "package_name",
            "a",
            '"a" is not a package name of REP 144; allowed: two or more of a-z, 0-9 and single'
            " underscores, a letter first [invalid-name]",
        ),
        ("package_name", "os", '"os" is a module of Python; choose another [reserved-name]'),
        ("package_name", "nul", '"nul" is a device of Windows; choose another [reserved-name]'),
        ("file_name", "nul.txt", '"nul" is a device of Windows; choose another [reserved-name]'),
        (
            "file_name",
            ".a",
            '".a" is not a file name; allowed: letters, digits, "_", "." and "-", no "." or "-"'
            " first [invalid-name]",
        ),
        (
            "dependency",
            "1a",
            '"1a" is not a package name; allowed: one name of letters, digits and "_", a letter'
            " first [invalid-name]",
        ),
        ("email", "a@b", '"a@b" is not a mail address; allowed: name@host.domain [invalid-value]'),
        (
            "version",
            "1.02.0",
            '"1.02.0" is not a version; allowed: three numbers, such as 1.2.0 [invalid-value]',
        ),
        (
            "url",
            "ftp://a",
            '"ftp://a" is not an address of the web; allowed: https://host/path, without blanks'
            " and quotes [invalid-value]",
        ),
        (
            "ros_name",
            "a/1",
            '"a/1" is not a valid ROS name; allowed: letters, digits, single underscores and "/"'
            ' between words that start with a letter, after "/" or "~/" if at all [invalid-name]',
        ),
        ("ros_name", "~/for", TAKEN),
        (
            "ros_name",
            "co/await",
            '"co_await" is a keyword of C++; choose another [reserved-name]',
        ),
        (
            "message_type",
            "std_msgs/bool",
            '"std_msgs/bool": a type begins with a capital; did you mean "std_msgs/Bool"?'
            " [type-without-capital]",
        ),
        (
            "message_type",
            "String",
            '"String" is not a type; it lacks its package; did you mean "std_msgs::String"?'
            f" {TYPE} [invalid-type]",
        ),
        (
            "message_type",
            "std_srvs/srv/Empty",
            '"std_srvs/srv/Empty" is the type of a service, where that of a message belongs;'
            f" {TYPE} [invalid-type]",
        ),
        (
            "message_type",
            "std_msgs",
            f'"std_msgs" is not a type; it names a package alone; {TYPE} [invalid-type]',
        ),
        (
            "service_type",
            "a.b.c.d",
            '"a.b.c.d" is not a type; allowed: package::Type, package/Type, package/srv/Type,'
            " such as std_srvs/Trigger [invalid-type]",
        ),
        (
            "message_type",
            "std::string",
            '"std::string" is not a type; it lacks its package; did you mean "std_msgs::String"? '
            f"{TYPE} [invalid-type]",
        ),
        ("message_type", "for::B", TAKEN),
        ("message_type", "os::B", '"os" is a module of Python; choose another [reserved-name]'),
        (
            "message_type",
            "a::True",
            '"True" is a keyword of Python; choose another [reserved-name]',
        ),
        (
            "stamped_type",
            "std_msgs::String",
            '"std_msgs::String" has no header, and so no stamp; choose a type with one'
            " [type-without-stamp]",
        ),
        (
            "field_type",
            "uint8[0]",
            '"uint8[0]": a size must be from 1 to 2147483647 [invalid-type]',
        ),
        (
            "field_type",
            "string<=0",
            '"string<=0": a size must be from 1 to 2147483647 [invalid-type]',
        ),
        (
            "field_type",
            "uint8[2147483648]",
            '"uint8[2147483648]": a size must be from 1 to 2147483647 [invalid-type]',
        ),
        (
            "field_type",
            "uint8[<=]",
            f'"uint8[<=]" is not a field type; {FIELD} [invalid-type]',
        ),
        (
            "field_type",
            "int8<=3",
            f'"int8<=3": only a string has a bound; {FIELD} [invalid-type]',
        ),
        (
            "field_type",
            "float",
            f'"float" is no type of ROS; did you mean "float32"? {FIELD} [invalid-type]',
        ),
        (
            "field_type",
            "list(int)",
            f'"list(int)" is not a field type; did you mean "int32[]"? {FIELD} [invalid-type]',
        ),
        ("field_type", "for::A", TAKEN),
        (
            "field_type",
            "a::srv::B",
            '"a::srv::B" is the type of a service, where that of a message belongs;'
            f" {TYPE} [invalid-type]",
        ),
        (
            "number",
            "1,5",
            '"1,5" is not a number; did you mean "1.5"? allowed: a finite number without a unit,'
            " such as 12.5 [invalid-value]",
        ),
        (
            "number",
            "1_0",
            '"1_0" is not a number; allowed: a finite number without a unit, such as 12.5'
            " [invalid-value]",
        ),
        (
            "double",
            "1e-310",
            f'"1e-310" is too small; allowed: 0, or at least {sys.float_info.min} [out-of-range]',
        ),
        (
            "bool",
            "2",
            '"2" is not a bool; allowed: true, 1, yes, on, false, 0, no, off [invalid-value]',
        ),
        (
            "int",
            "1.5",
            '"1.5" is not an int; allowed: a whole number, such as -3 or 0xff [invalid-value]',
        ),
        (
            "int",
            "-010",
            '"-010" begins with 0, which C and YAML read in base 8, messages in base 10;'
            " write -10, or 0o10 if it is octal [leading-zero]",
        ),
        (
            "int",
            "09",
            '"09" begins with 0, which C and YAML read in base 8, messages in base 10; write 9'
            " [leading-zero]",
        ),
        *(
            (
                "int",
                str(n),
                f'"{n}" does not fit 64 bits; allowed: {-(2**63)} to {2**63 - 1} [out-of-range]',
            )
            for n in (2**63, -(2**63) - 1)
        ),
        (
            "interface_name",
            "1",
            f'"1" is not a name of a type; allowed: {LETTERS} [invalid-name]',
        ),
        (
            "interface_name",
            "True",
            '"True" is a keyword of Python; choose another [reserved-name]',
        ),
        (
            "field_name",
            "1",
            f'"1" is not a field name; allowed: {LETTERS} [invalid-name]',
        ),
        (
            "constant_name",
            "1",
            f'"1" is not a constant name; allowed: {LETTERS} [invalid-name]',
        ),
        (
            "ROS 2 interface_name",
            "A_b",
            '"A_b" is not a name of a type; allowed: letters and digits, a capital first'
            " [invalid-name]",
        ),
        (
            "ROS 2 interface_name",
            "Con",
            '"con" is a device of Windows; choose another [reserved-name]',
        ),
        (
            "ROS 2 field_name",
            "A",
            f'"A" is not a field name; allowed: a-z, 0-9 {SINGLE} [invalid-name]',
        ),
        (
            "ROS 2 constant_name",
            "a",
            f'"a" is not a constant name; allowed: A-Z, 0-9 {SINGLE} [invalid-name]',
        ),
    ],
)
def test_refusal(format_, text, says):
    assert refusal(format_named(format_), text) == says


@pytest.mark.parametrize(
    ("format_", "one", "other", "is_same"),
    [
        ("component_name", "a_b", "AB", True),
        ("interface_name", "AB", "Ab", True),
        ("interface_name", "A_B", "AB", False),
        ("ros_name", "a/b", "a_b", True),
        ("ros_name", "a/b", "A/b", False),
    ],
)
def test_names_that_are_one(format_, one, other, is_same):
    assert (comparable(format_, one) == comparable(format_, other)) is is_same


def test_parts_of_a_type():
    assert split_type("a/msg/B[3]") == ("a", "msg", "B")
    assert split_type("B[]") == ("", "msg", "B")
    assert split_type("string<=3[]") is None


@pytest.mark.parametrize(
    ("type_", "text", "value"),
    [
        ("bool", "yes", True),
        ("int", "-3", -3),
        ("double", "1", 1.0),
        ("float32", "-3.4028234663852886e38", -3.4028234663852886e38),
        ("float64", "1e300", 1e300),
        ("byte", "-128", -128),
        ("byte", "255", 255),
        ("char", "0", 0),
        ("int8", "-128", -128),
        ("int8", "127", 127),
        ("uint64", str(2**64 - 1), 2**64 - 1),
        ("string", " a ", " a "),
        ("string<=2", "ab", "ab"),
        ("wstring", "", ""),
        ("int[]", "[]", []),
        ("int[2]", "[1, 2]", [1, 2]),
        ("int[<=2]", "[1]", [1]),
        ("int[<=2]", "[1, 2]", [1, 2]),
        ("string[]", "[a, '1', \"b c\"]", ["a", "1", "b c"]),
        ("string<=2[]", "[ab]", ["ab"]),
        ("string[]", f"[{'a' * 99_998}]", ["a" * 99_998]),
    ],
)
def test_literal(type_, text, value):
    found = literal(text, type_)
    assert (found, type(found)) == (value, type(value))


LIST = "allowed: a list such as [1, 2]"


@pytest.mark.parametrize(
    ("type_", "text", "says"),
    [
        ("a/msg/B", "x", "no text is a value of a/msg/B; drop it [attribute-without-meaning]"),
        ("string<=2", "abc", '"abc" is too long for a string<=2 [too-long]'),
        ("string<=2[]", "[ab, abc]", '"abc" is too long for a string<=2 [too-long]'),
        ("float32", "3.5e38", "3.5e38 is no float32; allowed: up to 3.403e+38 [out-of-range]"),
        ("byte", "256", "256 is no byte; allowed: -128 to 255 [out-of-range]"),
        ("byte", "-129", "-129 is no byte; allowed: -128 to 255 [out-of-range]"),
        ("char", "-1", "-1 is no char; allowed: 0 to 255 [out-of-range]"),
        ("int16", "32768", "32768 is no int16; allowed: -32768 to 32767 [out-of-range]"),
        ("uint32", "-1", f"-1 is no uint32; allowed: 0 to {2**32 - 1} [out-of-range]"),
        ("int[]", "1, 2", f'"1, 2" is not an int[]; {LIST} [invalid-value]'),
        ("int[]", "[[1]]", f'"[[1]]" is not an int[]; {LIST} [invalid-value]'),
        ("int[]", "[1", f'"[1" is not an int[]; {LIST} [invalid-value]'),
        ("int[]", "", f'"" is not an int[]; {LIST} [invalid-value]'),
        ("int[]", "{a: 1}", f'"{{a: 1}}" is not an int[]; {LIST} [invalid-value]'),
        ("int[]", "[1]\n---\n[2]", f'"[1]\\n---\\n[2]" is not an int[]; {LIST} [invalid-value]'),
        (
            "int[]",
            "[1, x]",
            '"x" is not an int; allowed: a whole number, such as -3 or 0xff [invalid-value]',
        ),
        (
            "bool[]",
            "1",
            '"1" is not a bool[]; allowed: a list such as [true, false] [invalid-value]',
        ),
        (
            "double[]",
            "1",
            '"1" is not a double[]; allowed: a list such as [0.5, 1] [invalid-value]',
        ),
        (
            "float32[]",
            "1",
            '"1" is not a float32[]; allowed: a list such as [0.5, 1] [invalid-value]',
        ),
        ("uint8[2]", "1", f'"1" is not a uint8[2]; {LIST} [invalid-value]'),
        (
            "string<=5[]",
            "a",
            '"a" is not a string<=5[]; allowed: a list such as [first, second] [invalid-value]',
        ),
        ("int[2]", "[1]", "1 values do not fit int[2] [invalid-value]"),
        ("int[<=2]", "[1, 2, 3]", "3 values do not fit int[<=2] [invalid-value]"),
        (
            "string[]",
            f"[{'a' * 99_999}]",
            "a list of 100001 characters is too long; allowed: 100000 [too-long]",
        ),
    ],
)
def test_text_that_is_no_literal(type_, text, says):
    assert refusal(literal, text, type_) == says


@pytest.mark.parametrize(
    ("value", "text"),
    [(True, "true"), (12.0, "12"), (0.5, "0.5"), (3, "3"), ("1.0", "1.0")],
)
def test_how_a_spec_writes_a_value(value, text):
    assert spelled(value) == text


def format_named(name):
    ros = re.match(r"ROS (\d) ", name)
    return (FORMATS_OF_ROS[int(ros[1])] if ros else FORMATS)[name.split()[-1]]


def refusal(function, *arguments):
    with pytest.raises(SpecError) as raised:
        function(*arguments)
    return str(raised.value)
