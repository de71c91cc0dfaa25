"""The QoS of a topic: from a spec, over policies, to the code of each ROS."""

import itertools
import re

import pytest

from hooks.faults import SpecError
from hooks.model import load_functions
from support.packages import MODELS, model_of
from support.repository import ROOT
from support.soundness import check_sound

SPEC = """<package name="arm" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="reach" frequency="10">
{}
  </node>
</package>
"""
MODEL = {model: model_of(model) for model in MODELS}
FUNCTIONS = load_functions(ROOT / "extensions/qos.py")
KINDS = ("publisher", "subscriber", "directPublisher", "directSubscriber")
SERVICES = ("serviceServer", "serviceClient")
POLICIES = ("reliability", "durability", "history", "depth")
DEFAULT = ("reliable", "volatile", "keep_last", 10)
NODE = {"python_model": "arm/reach_ros.py", "cpp_model": "src/reach_ros.cpp"}


def context(kind, model="python_model", distro="kilted", **attributes):
    """Return an interface of a spec with these attributes."""
    words = " ".join(f'{name}="{value}"' for name, value in attributes.items())
    spec = SPEC.format(f'    <{kind} name="a" type="std_msgs::String" {words}/>')
    values = MODEL[model].context(spec.encode(), "spec", distro)
    return values["nodes"][0][f"{kind}s"][0]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("attributes", "policies"),
    [
        ({}, DEFAULT),
        ({"qos": "default"}, DEFAULT),
        ({"qos": "sensor_data"}, ("best_effort", "volatile", "keep_last", 5)),
        ({"qos": "system_default"}, ("system_default", "system_default", "system_default", 0)),
        ({"qos": "best_available"}, ("best_available", "best_available", "keep_last", 10)),
        (
            {"durability": "transient_local", "depth": 1},
            ("reliable", "transient_local", "keep_last", 1),
        ),
        (
            {"qos": "sensor_data", "reliability": "reliable"},
            ("reliable", "volatile", "keep_last", 5),
        ),
        ({"qos": "sensor_data", "depth": 1}, ("best_effort", "volatile", "keep_last", 1)),
        ({"history": "keep_all"}, ("reliable", "volatile", "keep_all", 0)),
        (
            {"qos": "system_default", "history": "keep_last"},
            ("system_default", "system_default", "keep_last", 10),
        ),
    ],
)
def test_profile_changed_by_policies(kind, attributes, policies):
    topic = context(kind, **attributes)
    assert FUNCTIONS["qos"](topic) == dict(zip(POLICIES, policies, strict=True))


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("distro", "attributes", "message"),
    [
        ("kilted", {"history": "keep_all", "depth": 5}, 'no meaning where history is "keep_all"'),
        ("kilted", {"depth": 0}, "depth: 0 must be at least 1"),
        ("kilted", {"qos": "sensor"}, 'unknown "sensor"; did you mean "sensor_data"?'),
        ("humble", {"qos": "best_available"}, 'qos: Humble has no "best_available"'),
        (
            "humble",
            {"reliability": "best_available"},
            'reliability: Humble has no "best_available"',
        ),
        ("humble", {"durability": "best_available"}, 'durability: Humble has no "best_available"'),
    ],
)
def test_contradictions_are_refused(model, distro, attributes, message):
    with pytest.raises(SpecError, match=re.escape(message)):
        context("subscriber", model, distro, **attributes)


def every_qos():
    """Return the attributes of all QoS that the dictionary allows."""
    known = MODEL["python_model"].dictionary.components["node"].interfaces
    attributes = known["publisher"].attributes
    names = ("qos", *POLICIES)
    words = [[None, *(attributes[name].choices or (3,))] for name in names]
    for values in itertools.product(*words):
        topic = dict(zip(names, values, strict=True))
        if not (topic["history"] == "keep_all" and topic["depth"]):
            yield topic


def test_every_qos_can_be_written():
    written = set()
    for topic in every_qos():
        python = FUNCTIONS["rclpy_qos"](topic, 12)
        cpp = FUNCTIONS["rclcpp_qos"](topic, 6)
        assert bool(python) == bool(cpp) == bool(FUNCTIONS["qos_words"](topic))
        assert all(len(line) < 100 for line in (python + "\n" + cpp).split("\n"))
        names = re.findall(r"\w+Policy\b|QoSProfile", python)
        assert {*names} == {*FUNCTIONS["rclpy_qos_names"]([topic])}
        written.add((tuple(FUNCTIONS["qos"](topic).values()), python, cpp))
    # One text for each QoS, and one QoS for each text.
    for column in range(3):
        assert len({item[column] for item in written}) == len(written)


@pytest.mark.parametrize(
    ("attributes", "python", "cpp"),
    [
        ({}, "", ""),
        (
            {"qos": "sensor_data"},
            "QoSProfile(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5)",
            "rclcpp::SensorDataQoS()",
        ),
        (
            {"durability": "transient_local", "depth": 1},
            "QoSProfile(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)",
            "rclcpp::QoS(1).transient_local()",
        ),
        (
            {"history": "keep_all"},
            "QoSProfile(history=HistoryPolicy.KEEP_ALL)",
            "rclcpp::QoS(rclcpp::KeepAll())",
        ),
    ],
)
def test_code_of_ros2(attributes, python, cpp):
    assert FUNCTIONS["rclpy_qos"](attributes, 12) == python
    assert FUNCTIONS["rclcpp_qos"](attributes, 6) == cpp


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("kind", SERVICES)
@pytest.mark.parametrize(
    ("distro", "attributes", "python", "cpp"),
    [
        ("kilted", "", "", ""),
        ("kilted", 'reliability="reliable" history="keep_last" depth="10"', "", ""),
        ("kilted", 'depth="99"', "QoSProfile(depth=99)", "rclcpp::QoS(99)"),
        ("humble", 'depth="99"', "QoSProfile(depth=99)", "rclcpp::QoS(99)"),
        (
            "kilted",
            'history="keep_all" reliability="best_effort"',
            "history=HistoryPolicy.KEEP_ALL",
            "rclcpp::QoS(rclcpp::KeepAll()).best_effort()",
        ),
        ("noetic", 'depth="99"', "", ""),
    ],
)
def test_code_of_services(render, kind, model, distro, attributes, python, cpp):
    """What is not the default one; a package without any has no line of it."""
    spec = SPEC.format(f'<{kind} name="a" type="std_srvs::Trigger" {attributes}/>')
    package = render(spec, model=model, ros_distro=distro)
    code = {"python_model": python, "cpp_model": cpp}[model]
    assert code in (package / NODE[model]).read_text()
    if not code:
        plain = SPEC.format(f'<{kind} name="a" type="std_srvs::Trigger"/>')
        other = render(plain, model=model, ros_distro=distro, name="plain")
        names = [path.relative_to(other) for path in other.rglob("*.[ch]pp")]
        names += [path.relative_to(other) for path in other.rglob("*.py")]
        for name in names:
            assert (package / name).read_text() == (other / name).read_text(), name


TOPICS = """
    <publisher name="map" type="std_msgs::String" durability="transient_local" depth="1"/>
    <directPublisher name="events" type="std_msgs::String" history="keep_all"/>
    <subscriber name="camera" type="std_msgs::String" qos="sensor_data"/>
    <directSubscriber name="orders" type="std_msgs::String" history="keep_all"/>
    <publisher name="plain" type="std_msgs::String"/>
    <subscriber name="simple" type="std_msgs::String"/>"""


@pytest.mark.parametrize(
    ("model", "pieces"),
    [
        (
            "python_model",
            [
                "'map',\n* std_msgs.msg.String,\n* queue_size=1,\n* latch=True,\n",
                "'events',\n* std_msgs.msg.String,\n* queue_size=0,\n *\\)",
                "_receive_camera,\n* queue_size=5,\n* tcp_nodelay=True,\n *\\)",
                "receive_orders',\n* \\).receive,\n* queue_size=None,\n *\\)",
                "'plain',\n* std_msgs.msg.String,\n* queue_size=10,\n *\\)",
                "_receive_simple,\n* queue_size=10,\n *\\)",
            ],
        ),
        (
            "cpp_model",
            [
                '"map",\n* 1,\n* true\\)',
                '"events",\n* 0\\)',
                "in_camera_,\n* 5,\n* ros::TransportHints\\(\\).tcpNoDelay\\(\\)\\)",
                "receive_orders,\n* 0\\)",
                '"plain",\n* 10\\)',
                "in_simple_\\)",
            ],
        ),
    ],
)
def test_code_of_ros1(render, model, pieces):
    code = (
        render(SPEC.format(TOPICS), model=model, ros_distro="noetic") / NODE[model]
    ).read_text()
    for piece in pieces:
        assert re.search(piece.replace("\n*", r"\n *"), code), f"{piece} in {code}"


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_code_with_qos_is_sound(render, distro):
    """The longest profile is split as ruff splits it, wherever it stands."""
    words = 'reliability="system_default" durability="transient_local" depth="1000000"'
    topics = "\n".join(
        f'<{kind} name="topic_{number}" type="std_msgs::String" {words}/>'
        for number, kind in enumerate(KINDS)
    )
    words = 'reliability="best_effort" depth="1000000"'
    topics += "\n".join(
        f'<{kind} name="service_{number}" type="std_srvs::Trigger" {words}/>'
        for number, kind in enumerate(SERVICES)
    )
    check_sound(render(SPEC.format(topics), ros_distro=distro))


@pytest.mark.parametrize(
    ("distro", "words"),
    [
        (
            "noetic",
            {
                "map": "latched, queue 1",
                "events": "queue without limit",
                "camera": r"queue 5, TCP\_NODELAY",
            },
        ),
        (
            "kilted",
            {
                "map": r"transient\_local, depth 1",
                "events": r"keep\_all",
                "camera": r"best\_effort, depth 5",
            },
        ),
    ],
)
def test_readme_names_qos_where_there_is_one(render, distro, words):
    text = (render(SPEC.format(TOPICS), ros_distro=distro) / "README.md").read_text()
    assert "| Topic | Use | Type | QoS | Description |\n|---|---|---|---|---|\n" in text
    for name, said in words.items():
        assert re.search(rf"`{name}` .* \| {re.escape(said)} \|", text), name
    assert re.search(r"`plain` .* \|  \|", text)
    plain = SPEC.format('    <publisher name="plain" type="std_msgs::String"/>')
    text = (render(plain, ros_distro=distro, name="plain") / "README.md").read_text()
    assert "QoS" not in text
