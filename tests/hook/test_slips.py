"""What everyday slips in XML are called, and that each message names the cure."""

import pytest

from hooks.faults import SpecError
from hooks.parse import parse
from support.packages import model_of

PACKAGE = '<package name="p" author="A">\n  <node name="n"{}\n</package>'
AFTER = "after the value of an attribute comes a blank, > or />"
QUOTES = "after frequency= comes the value in quotes: frequency="


@pytest.mark.parametrize(
    ("rest", "says"),
    [
        (' description="a & b"/>', "2: write & as &amp;"),
        (' description="R&D"/>', "2: write & as &amp;"),
        (">a & b</node>", "2: write & as &amp;"),
        (' description="90&deg;"/>', "2: &deg; is no word of XML; write the character itself"),
        (' description="a < b"/>', "2: write < as &lt; in a value"),
        (' description="a<b"/>', "2: write < as &lt; in a value"),
        (
            ">a < b</node>",
            "2: after < comes the name of a tag, with no blank between; write < itself as &lt;",
        ),
        (
            "/>\n  < node name='m'/>",
            "3: after < comes the name of a tag, with no blank between; write < itself as &lt;",
        ),
        (
            "/>\n  <1node/>",
            "3: after < comes the name of a tag, with no blank between; write < itself as &lt;",
        ),
        (
            r"><\node>",
            "2: after < comes the name of a tag, with no blank between; write < itself as &lt;",
        ),
        (" frequency=10/>", f'2: {QUOTES}"10"'),
        (" frequency=10.5 />", f'2: {QUOTES}"10.5"'),
        (' frequency=10"/>', f'2: {QUOTES}"10"'),
        (' frequency =10"/>', f'2: {QUOTES}"10"'),
        (' frequency=="10"/>', f'2: {QUOTES}"..."'),
        (" frequency=/>", f'2: {QUOTES}"..."'),
        (" frequency=“10”/>", '2: "“" is no quote of XML; write "'),
        (' frequency=”10"/>', '2: "”" is no quote of XML; write "'),
        (" frequency=«10»/>", '2: "«" is no quote of XML; write "'),
        (
            ' frequency="10/>\n  <node name="m"/>',
            "3: the value of frequency in line 2 is not closed; its quotes must be the same",
        ),
        (
            ' frequency="10/> <node/>',
            "2: the value of frequency in line 2 is not closed; its quotes must be the same",
        ),
        (
            ' description="a\n  <node/>',
            "3: the value of description in line 2 is not closed; its quotes must be the same",
        ),
        (
            " frequency='10\"/>",
            "3: the value of frequency in line 2 is not closed; its quotes must be the same",
        ),
        (
            ' frequency="10"description="x"/>',
            "2: after the value of an attribute comes a blank, > or />; a quote in a value is "
            "&quot; or &apos;",
        ),
        (
            ' frequency=""10""/>',
            "2: after the value of an attribute comes a blank, > or />; a quote in a value is "
            "&quot; or &apos;",
        ),
        (', frequency="10"/>', '2: blanks separate attributes; drop ","'),
        (' frequency="10";/>', '2: blanks separate attributes; drop ";"'),
        ('\N{NO-BREAK SPACE}frequency="10"/>', "2: U+00A0 is no blank and no text; drop it"),
        (" description='a\x01'/>", "2: U+0001 is no blank and no text; drop it"),
        (" diagnostics/>", '2: an attribute has a value: diagnostics="..."'),
        (" diagnostics >", '2: an attribute has a value: diagnostics="..."'),
        (' frequency: "10"/>', '2: an attribute has a value: frequency="..."'),
        *((f' frequency="10" /{x}>', "2: / and > of /> stand together") for x in (" ", "\n", "5")),
        (' frequency="10"<x/>', "2: <node> of line 2 lacks its > or />"),
        (' frequency="10"', "3: <node> of line 2 lacks its > or />"),
        (' frequency="10"\n  <node name="m"/>', "3: <node> of line 2 lacks its > or />"),
        ("\n  <node/>", "3: <node> of line 2 lacks its > or />"),
        ("/> <!-- a -- b -->", "2: a comment has no -- inside; write - there"),
        ("/> <!-- a --->", "2: a comment has no -- inside; write - there"),
        ("/> <!-- a", "2: the comment is not closed; end it with -->"),
        ("/> <![CDATA[ a", "3: <![CDATA[ is not closed; end it with ]]>"),
        (' name="m"/>', "2: name is given twice"),
        ("/>\n<!- a -->", "3: a comment begins with <!-- and ends with -->"),
        ("/>\n<! a >", "3: a comment begins with <!-- and ends with -->"),
        ("></node name>", "2: </node> has nothing but its name"),
        ("></node/>", "2: </node> has nothing but its name"),
        (' 1st="m"/>', '2: the name of an attribute begins with a letter, not with "1"'),
        (
            ' frequency="10" -x="m"/>',
            '2: the name of an attribute begins with a letter, not with "-"',
        ),
        (
            ' description="the "best" of all"/>',
            f"2: {AFTER}; a quote in a value is &quot; or &apos;",
        ),
        (" description='it's'/>", f"2: {AFTER}; a quote in a value is &quot; or &apos;"),
    ],
)
def test_slip_in_a_tag(rest, says):
    assert said(PACKAGE.format(rest)) == f"{says} [not-well-formed]"


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "1: the file is empty; a spec begins with <package"),
        ("  \n\n", "3: the file is empty; a spec begins with <package"),
        (
            '{"package": {}}',
            '1: a spec is XML and begins with <package, not with "{"package": {}}"',
        ),
        (
            "package:\n  name: p\n",
            '1: a spec is XML and begins with <package, not with "package:"',
        ),
        ("- package", '1: a spec is XML and begins with <package, not with "- package"'),
        ("# Robot\n<package/>", '1: a spec is XML and begins with <package, not with "# Robot"'),
        ('\n<?xml version="1.0"?><package/>', "2: nothing may stand before <?xml"),
        ("<package/>\n<package/>", "2: nothing may follow </package>"),
        ("<package/>\nend", "2: nothing may follow </package>"),
        ("<package></Package>", "1: <package> of line 1 is not closed"),
        ("<package></package></package>", "1: nothing may follow </package>"),
        ("<package/>\n</package>", "2: nothing may follow </package>"),
        ("<package></package", "1: </package> lacks its >"),
        ("<package", "1: <package> of line 1 lacks its > or />"),
        ("<package name=", '1: after name= comes the value in quotes: name="..."'),
        (
            '\n<package name="a',
            "2: the value of name in line 2 is not closed; its quotes must be the same",
        ),
        (
            "</package>",
            "1: after < comes the name of a tag, with no blank between; write < itself as &lt;",
        ),
        (
            "<?xml version=1.0?><package/>",
            '1: after version= comes the value in quotes: version="1.0"',
        ),
    ],
)
def test_slip_outside(text, says):
    assert said(text) == f"{says} [not-well-formed]"


@pytest.mark.parametrize("text", ["é & b", "日本 & x"])
def test_letters_of_several_bytes_before_it(text):
    for start in ("", "\N{BYTE ORDER MARK}"):
        assert said(start + PACKAGE.format(f' description="{text}"/>')) == (
            "2: write & as &amp; [not-well-formed]"
        )


def test_every_prefix_of_a_spec_is_refused_with_a_sentence():
    whole = (
        '<?xml version="1.0"?>\n<!-- a -->\n<package name="p"><node b=\'x\'>\n</node></package>'
    )
    for end in range(len(whole)):
        assert said(whole[:end])


def said(text):
    with pytest.raises(SpecError) as raised:
        parse(text.encode(), "spec.xml")
    place, said = str(raised.value).split(": not well-formed XML: ")
    assert "\n" not in said
    return f"{place.removeprefix('spec.xml:')}: {said}"


ITEM = """<package name="arm" author="A" author_email="a@b.de" description="d" license="MIT">
{}</package>"""
NODE = ITEM.format('<node name="n" frequency="1">{}</node>')


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize(
    ("spec", "says"),
    [
        (NODE.format('<service name="x"/>'), 'did you mean "serviceServer" or "serviceClient"?'),
        (NODE.format('<client name="x"/>'), 'did you mean "serviceClient" or "actionClient"?'),
        (NODE.format('<pub name="x"/>'), 'did you mean "publisher" or "directPublisher"?'),
        (NODE.format('<param name="x"/>'), 'did you mean "parameter" or "dynParameter"?'),
        (NODE.format('<servicServer name="x"/>'), 'did you mean "serviceServer"?'),
        (ITEM.format('<node name="n" rate="10"/>'), '"rate"; did you mean frequency="..."?'),
        (NODE.format('<publisher topic="x" type="a::B"/>'), '"topic"; did you mean name="..."?'),
        (NODE.format('<subscriber name="x" msg="a::B"/>'), '"msg"; did you mean type="..."?'),
        (NODE.format('<serviceClient name="x" srv="a::B"/>'), '"srv"; did you mean type="..."?'),
        (
            NODE.format('<publisher name="x" type="a::B" queue_size="1"/>'),
            '"queue_size"; did you mean depth="..."?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" latch="true"/>'),
            '"latch"; did you mean durability="transient_local"?',
        ),
        (
            NODE.format('<parameter name="x" type="int" default="1"/>'),
            '"default"; did you mean value="..."?',
        ),
        (
            NODE.format('<dynParameter name="x" type="int" default="1" minimum="0"/>'),
            '"minimum"; did you mean min="..."?',
        ),
        (
            ITEM.format("<node/>").replace("author_email", "email"),
            'did you mean author_email="..."?',
        ),
        (
            NODE.format('<publisher name="x" type="std_msgs.msg.String"/>'),
            '"std_msgs.msg.String" is not a type; did you mean "std_msgs::String"? allowed: ',
        ),
        (
            NODE.format('<serviceServer name="x" type="std_srvs/Trigger.srv"/>'),
            'not a type; did you mean "std_srvs::Trigger"? allowed: ',
        ),
        (
            NODE.format('<publisher name="x" type=" std_msgs::String "/>'),
            'not a type; did you mean "std_msgs::String"? allowed: ',
        ),
        (
            NODE.format('<publisher name="x" type="sensor_msgs/Image[]"/>'),
            'not a type; did you mean "sensor_msgs::Image"? allowed: ',
        ),
        (
            NODE.format('<publisher name="x" type="String.msg"/>'),
            '"String.msg" is not a type; it lacks its package; did you mean "std_msgs::String"? ',
        ),
        (
            NODE.format('<publisher name="x" type="String"/>'),
            '"String" is not a type; it lacks its package; did you mean "std_msgs::String"? ',
        ),
        # What stands in another place there, or is called otherwise.
        (
            NODE.format('<serviceServer name="x" type="a::B" durability="volatile"/>'),
            '"durability"; it belongs to <publisher> or <subscriber> or <directPublisher> or ',
        ),
        (ITEM.format('<node name="n" group="g"/>'), '"group"; it belongs to <use>; allowed: '),
        (
            NODE.format('<publisher name="x" type="a::B" qos="best_effort"/>'),
            'did you mean reliability="best_effort"?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" qos="keep_all"/>'),
            'did you mean history="keep_all"?',
        ),
        (NODE.format('<publisher name="x" type="a::B" qos="10"/>'), 'did you mean depth="10"?'),
        (NODE.format('<subscriber name="x" type="a::B" history="5"/>'), 'did you mean depth="5"?'),
        (
            NODE.format('<subscriber name="x" type="a::B" durability="reliable"/>'),
            'did you mean reliability="reliable"?',
        ),
        (
            NODE.format('<subscriber name="x" type="a::B" qos="rmw_qos_profile_sensor_data"/>'),
            'did you mean "sensor_data"? allowed: ',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" durability="latch"/>'),
            'did you mean durability="transient_local"?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" queueSize="1"/>'),
            '"queueSize"; did you mean depth="..."?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" history_depth="1"/>'),
            'did you mean depth="..."?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" qos_profile="x"/>'),
            'did you mean qos="..."?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" namespace="x"/>'),
            'did you mean name="NAMESPACE/NAME"?',
        ),
        (
            ITEM.format('<node name="n" ns="left"/>'),
            'did you mean <instance name="NAMESPACE/NAME"/>?',
        ),
        (
            NODE.format('<timer name="x" period="0.1"/>'),
            '"period"; did you mean frequency="...", in Hz?',
        ),
        (
            NODE.format('<timer name="x" interval="0.1"/>'),
            '"interval"; did you mean frequency="...", in Hz?',
        ),
        (
            ITEM.format('<node name="n" loop_rate="10"/>'),
            '"loop_rate"; did you mean frequency="..."?',
        ),
        (
            ITEM.format('<node name="n"><rate>10</rate></node>'),
            '<rate> is not known here; did you mean frequency="..."?',
        ),
        (
            NODE.format('<publisher name="x" type="a::B" frequency="5"/>'),
            '"frequency"; it belongs to <node> or <timer>; allowed: name',
        ),
        (
            NODE.format('<actionClient name="x" type="a::B" goal="queue"/>'),
            '"goal"; it belongs to <actionServer>; allowed: name',
        ),
        (
            NODE.format('<actionServer name="x" type="a::B" goal="preempt"/>'),
            'did you mean goal="replace"?',
        ),
        (
            NODE.format('<parameter name="x" type="double_array" value="[]"/>'),
            'did you mean "double[]"? allowed: ',
        ),
        (
            NODE.format('<parameter name="x" type="std::vector&lt;int>" value="[]"/>'),
            'did you mean "int[]"? allowed: ',
        ),
        (
            NODE.format('<parameter name="x" type="int" value="1" lower_bound="0"/>'),
            'did you mean min="..."?',
        ),
        (
            ITEM.format('<license>MIT</license><node name="n"/>'),
            '<license> is not known here; did you mean license="..."?',
        ),
        (
            NODE.format('<publisher name="x"><type>a::B</type></publisher>'),
            '<type> is not known here; did you mean type="..."?',
        ),
        (
            ITEM.format('<exec_depend>a</exec_depend><node name="n"/>'),
            'did you mean <depend kind="exec">?',
        ),
        (ITEM.format('<run_depend>a</run_depend><node name="n"/>'), 'did you mean "depend"?'),
        (
            ITEM.format('<node name="n" timer="0.1"/>'),
            '"timer"; it is an element: <timer> inside <node> or <group>',
        ),
        (
            ITEM.format("<node/>").replace("<package", '<package url="x"'),
            '"url"; it is an element: <url> inside <package>',
        ),
        (NODE.format('<topic name="x"/>'), 'did you mean "publisher" or "subscriber"?'),
        (NODE.format('<tf name="x"/>'), 'did you mean "listener" or "broadcaster"?'),
        (NODE.format('<srv name="x"/>'), 'did you mean "serviceServer" or "serviceClient"?'),
        (NODE.format('<rosparam name="x"/>'), 'did you mean "parameter"?'),
        (NODE.format('<advertise name="x"/>'), 'did you mean "publisher"?'),
        (
            NODE.format('<publisher name="x" type="std_srvs/srv/Trigger"/>'),
            '"std_srvs/srv/Trigger" is the type of a service, where that of a message belongs',
        ),
        (
            NODE.format('<serviceServer name="x" type="std_msgs.msg.String"/>'),
            "is the type of a message, where that of a service belongs",
        ),
        (
            NODE.format('<actionServer name="x" type="a::msg::FibonacciAction"/>'),
            "is the type of a message, where that of an action belongs",
        ),
        (
            NODE.format('<publisher name="x" type="std::string"/>'),
            'did you mean "std_msgs::String"?',
        ),
        (NODE.format('<publisher name="x" type="double"/>'), 'did you mean "std_msgs::Float64"?'),
        (NODE.format('<publisher name="x" type="uint8"/>'), 'did you mean "std_msgs::UInt8"?'),
        (
            NODE.format('<publisher name="x" type="Twist"/>'),
            'it lacks its package; did you mean "geometry_msgs::Twist"?',
        ),
        (
            NODE.format('<publisher name="x" type="std_msgs::msg::String::SharedPtr"/>'),
            'did you mean "std_msgs::String"?',
        ),
        (
            NODE.format('<publisher name="x" type="const std_msgs::StringConstPtr &amp;"/>'),
            'did you mean "std_msgs::String"?',
        ),
        (
            NODE.format('<publisher name="x" type="std_msgs-String"/>'),
            'did you mean "std_msgs::String"?',
        ),
        (
            NODE.format('<publisher name="x" type="std_msgs String"/>'),
            'did you mean "std_msgs::String"?',
        ),
        # What code has around a type, and types of the languages.
        *(
            (NODE.format(f'<publisher name="x" type="{type_}"/>'), f'did you mean "{meant}"?')
            for type_, meant in [
                ("geometry_msgs/msg/twist.hpp", "geometry_msgs::Twist"),
                ("geometry_msgs/msg/twist_stamped.hpp", "geometry_msgs::TwistStamped"),
                ("geometry_msgs/Twist.h", "geometry_msgs::Twist"),
                ("#include &lt;std_msgs/String.h>", "std_msgs::String"),
                ("from std_msgs.msg import String", "std_msgs::String"),
                ("std::shared_ptr&lt;std_msgs::msg::String>", "std_msgs::String"),
                ("std_msgs->String", "std_msgs::String"),
                ("std_msgs::msgs::String", "std_msgs::String"),
                ("rclcpp::Publisher&lt;std_msgs::msg::String>::SharedPtr", "std_msgs::String"),
                ("rclcpp::Subscription&lt;std_msgs::msg::String>", "std_msgs::String"),
                ("std::unique_ptr&lt;std_msgs::msg::String>", "std_msgs::String"),
                ("std_msgs::float", "std_msgs::Float32"),
            ]
        ),
        (
            NODE.format('<publisher name="x" type="geometry_msgs"/>'),
            '"geometry_msgs" is not a type; it names a package alone; allowed: package::Type',
        ),
        *(
            (
                NODE.format(f'<serviceServer name="x" type="{type_}"/>'),
                'did you mean "std_srvs::Trigger"?',
            )
            for type_ in (
                "std_srvs::Trigger::Request",
                "std_srvs::Trigger::Response",
                "rclcpp::Service&lt;std_srvs::srv::Trigger>::SharedPtr",
                "rclcpp::Client&lt;std_srvs::srv::Trigger>::SharedPtr",
            )
        ),
        *(
            (
                NODE.format(f'<actionServer name="x" type="nav_msgs::MoveAction::{part}"/>'),
                'did you mean "nav_msgs::MoveAction"?',
            )
            for part in ("Goal", "Result", "Feedback")
        ),
        *(
            (NODE.format(f'<parameter name="x" type="{type_}"/>'), f'did you mean "{meant}"?')
            for type_, meant in [
                ("unsigned int", "int"),
                ("long double", "double"),
                ("const std::string&amp;", "string"),
                ("std_msgs::Float64", "double"),
                ("PARAMETER_DOUBLE", "double"),
                ("PARAMETER_STRING_ARRAY", "string[]"),
                ("float32[]", "double[]"),
                ("int[3]", "int[]"),
                ("std::array&lt;float, 3>", "double[]"),
                ("list[str]", "string[]"),
            ]
        ),
        *(
            (NODE.format(f'<publisher name="x" type="a::B" {said}/>'), f"did you mean {meant}?")
            for said, meant in [
                ('qos="rclcpp::SensorDataQoS()"', '"sensor_data"'),
                ('qos="latched"', 'durability="transient_local"'),
                ('reliability="RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT"', '"best_effort"'),
                ('best_effort="true"', 'reliability="best_effort"'),
                ('reliable="1"', 'reliability="reliable"'),
                ('transientLocal="true"', 'durability="transient_local"'),
                ('remap="/a"', "a <remap> in the launch file"),
            ]
        ),
        # What is written between tags, where an attribute is for it.
        (
            NODE.format('<parameter name="x" type="int">1</parameter>'),
            'text is not allowed here: "1"; it takes attributes: name, type, min, max, choices, v',
        ),
        (
            ITEM.format("<folder>urdf</folder>"),
            'text is not allowed here: "urdf"; did you mean name="..."?',
        ),
        (
            NODE.format("a text"),
            'text is not allowed here: "a text"; it takes attributes: name, executable, ',
        ),
        # What belongs to another file, or to Copier.
        (NODE.format('<remap from="a" to="b"/>'), "did you mean a <remap> in the launch file?"),
        (ITEM.format('<node name="n" pkg="p"/>'), '"pkg"; did you mean a <node> in the launch'),
        (
            ITEM.format('<node name="n" output="screen"/>'),
            '"output"; did you mean a <node> in the launch',
        ),
        (
            ITEM.format("<node/>").replace("<package", '<package ros_distro="humble"'),
            'did you mean copier\'s "-d ros_distro=..."?',
        ),
        (NODE.format('<output name="x"/>'), 'did you mean "publisher"?'),
        (NODE.format('<tf2 name="x"/>'), 'did you mean "listener" or "broadcaster"?'),
        # Values.
        (NODE.format('<parameter name="x" type="double" value="0,5"/>'), 'did you mean "0.5"?'),
        (
            NODE.format('<timer name="x" frequency="10 Hz"/>'),
            '"10 Hz" is not a number; allowed: a finite number without a unit, such as 12.5',
        ),
        (
            ITEM.format("<depend>nav_msgs, tf2</depend>"),
            '"nav_msgs, tf2" is not a package name; allowed: one name of letters,',
        ),
    ],
)
def test_habits_of_other_tools(spec, says, distro):
    for name in ("python_model", "cpp_model", "mixed_model"):
        if name == "mixed_model":
            spec = spec.replace("<node ", '<node language="cpp" ')
        with pytest.raises(SpecError) as raised:
            model_of(name).context(spec.encode(), "spec", distro)
        assert says in str(raised.value)


def test_latched_is_a_word_for_transient_local():
    spec = NODE.format('<publisher name="x" type="a::B" durability="latched"/>')
    context = model_of("cpp_model").context(spec.encode(), "spec", "kilted")
    assert context["nodes"][0]["publishers"][0]["durability"] == "transient_local"


MESSAGES = "interfaces_model"


@pytest.mark.parametrize(
    ("model", "inside", "says"),
    [
        (
            MESSAGES,
            '<service name="S"><field name="x" type="bool"/></service>',
            "<field> is not known here; it belongs inside <request> or <response>; allowed: ",
        ),
        (
            MESSAGES,
            '<action name="A"><field name="x" type="bool"/></action>',
            "it belongs inside <goal> or <result> or <feedback>; allowed: goal, result, feedback",
        ),
        (
            MESSAGES,
            '<action name="A"><request/></action>',
            'it belongs inside <service>; did you mean "result"? allowed: goal, result',
        ),
        ("cpp_model", '<Node name="n"/>', '<Node> is not known here; did you mean "node"?'),
        (
            "cpp_model",
            '<node name="my_node"/>\n<node name="MyNode"/>',
            '"MyNode" is already taken by "my_node" at line 2; each must have its own',
        ),
    ],
)
def test_cure_of_what_stands_elsewhere(model, inside, says):
    with pytest.raises(SpecError) as raised:
        model_of(model).context(ITEM.format(inside).encode(), "spec", "kilted")
    (message,) = str(raised.value).splitlines()
    assert says in message


@pytest.mark.parametrize("text", ["// a note", "# a note", "/* a note */", "-- a note"])
def test_comment_of_another_language(text):
    with pytest.raises(SpecError) as raised:
        model_of("cpp_model").context(ITEM.format(text).encode(), "spec", "kilted")
    assert f'not allowed here: "{text}"; a comment is <!-- ... -->' in str(raised.value)


@pytest.mark.parametrize(
    ("spec", "says"),
    [
        (NODE.format('<publisher nmae="x" type="a::B"/>'), 'did you mean "name"?'),
        (NODE.format('<publisher name="x" msg="a::B"/>'), 'did you mean type="..."?'),
        (NODE.format('<timer name="x" period="1"/>'), 'did you mean frequency="...", in Hz?'),
        (NODE.format('<publisher name="x" type="std_msgs::str"/>'), '"std_msgs::String"?'),
        (NODE.format('<publisher name="x" type="std_msgs/uint8"/>'), '"std_msgs/UInt8"?'),
        (ITEM.format('<depend name="tf2"/><node name="n"/>'), "takes a package name: <depend>"),
        (ITEM.format("<folder>urdf</folder><node name='n'/>"), 'did you mean name="..."?'),
        (
            NODE.format('<synchronizer name="x"><subscriber name="a"/></synchronizer>'),
            '<subscriber> is not known here; did you mean "input"?',
        ),
        (
            '<package format="3"><name>arm</name><version>0.1.0</version><license>MIT</license>'
            '<maintainer email="a@b.de">A</maintainer></package>',
            'a spec has attributes, as <package name="...">, not elements as a package.xml of ROS',
        ),
        ("<package><name>arm</name><license>MIT</license></package>", "as a package.xml of ROS"),
    ],
)
def test_one_slip_is_one_message(spec, says):
    with pytest.raises(SpecError) as raised:
        model_of("cpp_model").context(spec.encode(), "spec", "kilted")
    (message,) = str(raised.value).splitlines()
    assert says in message


@pytest.mark.parametrize(
    ("inside", "says"),
    [
        *(
            (f'<field name="x" type="{type_}"/>', f'did you mean "{meant}"?')
            for type_, meant in [
                ("std::vector&lt;double>", "float64[]"),
                ("std::vector&lt;geometry_msgs::msg::Point>", "geometry_msgs::Point[]"),
                ("list[int]", "int32[]"),
                ("double[3]", "float64"),
                ("unsigned char", "uint8"),
                ("unsigned int", "uint32"),
                ("String", "string"),
                ("Point", "geometry_msgs::Point"),
                ("Point[]", "geometry_msgs::Point"),
                ("Time", "time"),
                ("ros::Time", "time"),
                ("rclcpp::Duration", "duration"),
                ("rospy.Time", "time"),
                ("rclpy.Duration", "duration"),
                ("std_msgs/Header.msg", "std_msgs::Header"),
                ("std_msgs.msg.Header", "std_msgs::Header"),
                ("geometry_msgs::msg::Point::SharedPtr", "geometry_msgs::Point"),
            ]
        ),
        ('<constant name="X" type="double" value="1"/>', 'did you mean "float64"?'),
        ('<constant name="X" type="int" value="1"/>', 'did you mean "int32"?'),
        ('<constant name="X" type="int32">5</constant>', 'did you mean value="..."?'),
        ('<enum name="X"/>', 'did you mean "constant"?'),
        ("float64 x", "it takes attributes: name, description; elements: field, constant"),
    ],
)
def test_habits_in_a_message(inside, says):
    spec = ITEM.format(f'<message name="M">{inside}</message>')
    with pytest.raises(SpecError) as raised:
        model_of(MESSAGES).context(spec.encode(), "spec", "kilted")
    (message,) = str(raised.value).splitlines()
    assert says in message


def test_node_among_messages():
    with pytest.raises(SpecError, match="did you mean a package of python_model or cpp_model?"):
        model_of(MESSAGES).context(ITEM.format("<node/>").encode(), "spec", "kilted")
