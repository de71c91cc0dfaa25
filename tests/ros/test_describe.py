"""scripts/describe_node.py: what it says of a node makes a package with the same graph."""

import contextlib
import re
import runpy
import xml.etree.ElementTree as ET
from types import SimpleNamespace

import pytest
import yaml

from support import ros
from support.packages import DATA, model_of
from support.repository import ROOT
from support.ros import PEERS

SCRIPT = ROOT / "scripts/describe_node.py"
MODELS = ["python_model", "cpp_model"]
PREFIX = "from ament_index_python import get_package_prefix as find; print(find('tf2_ros'))"
PLAIN = f"{{}} {PEERS}/plain_ros2.py"
STATIC = f'$(python3 -c "{PREFIX}")/lib/tf2_ros/static_transform_publisher'
STATIC += " --x 1 --frame-id map --child-frame-id base --ros-args"


def describe(ros_, folder, *nodes):
    command = f"{ros_.python} {SCRIPT} {' '.join(nodes)} 2>/dev/null"
    return ros_.run(command, folder, folder, check=False).stdout


def wait_for(text, ros_, folder, *nodes):
    """Describe nodes until it says a text: of a node that has just been started, it may not."""
    return ros.wait_for(re.escape(text), lambda: describe(ros_, folder, *nodes))


def tags(spec):
    return {element.tag for element in ET.fromstring(spec.encode()).iter()}


VALUES = [
    True,
    0,
    -3,
    1.5,
    1e22,
    2**40,
    "",
    'it\'s "so" <&>',
    "日本\n\t👍",
    [False],
    [1, 2],
    [1, 0.5],
]
VALUES += [["a, b", '"', "", "üb\\er"]]
NOT_SAID = [None, [], [1, "a"], [[1]], {"a": 1}, float("nan"), [float("inf")], "--> \0", b"x"]


@pytest.mark.parametrize("ros_name", ["Ros1", "Ros2"])
def test_node_that_is_not_there(ros_name, monkeypatch):
    asker = runpy.run_path(str(SCRIPT))[ros_name]
    monkeypatch.setitem(asker.describe.__globals__, "PATIENCE", 0)
    ask = asker.__new__(asker)
    ask.master = SimpleNamespace(getSystemState=lambda: [[], [], []])
    ask.graph = dict
    with pytest.raises(SystemExit, match=r"/arm: no such node; .* \[no-such-node\]$"):
        list(ask.describe(["/arm"]))


def test_values():
    """Values are what they were, whatever is in them; comments tell of those that no spec has."""
    script = runpy.run_path(str(SCRIPT))
    items = [script["parameter"]("parameter", f"p{n}", value) for n, value in enumerate(VALUES)]
    items += [script["parameter"]("parameter", "odd", value) for value in NOT_SAID]
    items += [script["parameter"]("parameter", name, 1) for name in ("2nd", "a b", "a..b", "")]
    text = "\n".join(script["spec"]({"/arm/Driver2": items}))
    assert text.count("<!-- parameter ") == len(NOT_SAID) + 4
    hook = model_of("python_model")
    context = hook.context(text.encode(), "spec", "kilted")
    assert (context["name"], context["nodes"][0]["name"]) == ("driver2", "Driver2")
    assert [each["value"] for each in context["nodes"][0]["parameters"]] == VALUES


def test_names():
    """A name is private, relative or absolute, as its node would have it in another place."""
    relative = runpy.run_path(str(SCRIPT))["relative"]
    names = ["/arm/driver/state", "/arm/speed", "/arm/driver2/x", "/tf", "/armor/x"]
    found = [relative(name, "/arm/driver") for name in names]
    assert found == ["~/state", "speed", "driver2/x", "/tf", "/armor/x"]
    assert [relative(name, "/driver") for name in ("/driver/x", "/a/b")] == ["~/x", "a/b"]


@pytest.mark.parametrize("model", MODELS)
def test_nodes_of_ros1(ros1, render, tmp_path, model):
    """One of rospy with an interface of each kind, and one in C++ that Debian has."""
    plain = f"{ros1.python} {PEERS}/plain_ros1.py"
    throttle = "/usr/lib/topic_tools/throttle messages /speed 5.0 /slow __name:=throttle"
    nodes = ("/plain", "/throttle")
    with ros.master(ros1):
        with ros1.running(plain), ros1.running(throttle):
            spec = wait_for('<directPublisher name="slow"', ros1, tmp_path, *nodes)
        kinds = {"dynParameter", "parameter", "listener", "directPublisher", "directSubscriber"}
        assert kinds | {"serviceServer", "actionServer", "actionClient"} <= tags(spec)
        for text in (
            'name="limit" type="int" min="1" value="7"/>',
            'name="mode" type="int" choices="[1, 2]" description="How fast" value="2"/>',
            'name="~/state" type="std_msgs/String" durability="transient_local"/>',
            "<!-- parameter empty: no spec can say [] -->",
        ):
            assert text in spec
        render(spec, model=model, ros_distro="noetic", name="src/plain")
        ros1.build(tmp_path)
        said = re.sub("\n *<!--.*-->", "", spec)
        ros1.run("rosparam delete /plain", tmp_path)  # which outlive their node
        with ros1.running("roslaunch plain plain.launch", tmp_path):
            wait_for(said, ros1, tmp_path, *nodes)


TALKATIVE = """
import os, rclpy, runpy, sys
init, sys.argv = rclpy.init, sys.argv[1:]
rclpy.init = lambda *args, **more: (os.write(1, b"[RTPS Error] said"), init(*args, **more))
runpy.run_path(sys.argv[0], run_name="__main__")
"""


def test_what_the_middleware_says_is_not_in_the_spec(ros2, tmp_path):
    (tmp_path / "talkative.py").write_text(TALKATIVE)
    with ros2.running(PLAIN.format(ros2.python), ends_well=False):
        command = f"{ros2.python} talkative.py {SCRIPT} plain 2>/dev/null"
        done = ros2.run(command, tmp_path, tmp_path)
    assert done.stdout.startswith("<?xml ")


@pytest.mark.parametrize("model", MODELS)
def test_nodes_of_ros2(ros2, render, tmp_path, model):
    """One of rclpy with an interface of each kind, and, where it is there, one of tf2_ros."""
    has_rclcpp = ros.has_package(ros2, "rclcpp")
    if model == "cpp_model" and not has_rclcpp:
        pytest.skip("rclcpp is not installed")
    names = ["plain"]
    with contextlib.ExitStack() as stack:
        stack.enter_context(ros2.running(PLAIN.format(ros2.python), ends_well=False))
        if has_rclcpp:
            stack.enter_context(ros2.running(f"{STATIC} -r __node:=fixed"))
            names.append("fixed")
        spec = describe(ros2, tmp_path, *names)
    kinds = {"parameter", "directPublisher", "directSubscriber", "serviceServer", "serviceClient"}
    assert kinds | {"actionServer", "actionClient"} <= tags(spec)
    for text in (
        'name="axis.gain" type="double" min="0.0" max="2.5" description=\'"Gain" &lt;of&gt; it\'',
        'name="~/state" type="std_msgs/msg/String" durability="transient_local"/>',
        'name="speed" type="std_msgs/msg/Float64" reliability="best_effort" deadline="0.5"'
        ' lifespan="2.0" liveliness="manual_by_topic" liveliness_lease_duration="3.0"/>',
        'name="label" type="string" value=""/>',
    ):
        assert text in spec
    render(spec, model=model, ros_distro=ros2.distro, name="src/plain")
    ros2.build(tmp_path)
    with contextlib.ExitStack() as stack:
        for name in names:
            program = tmp_path / "install/plain/lib/plain" / name
            stack.enter_context(ros2.running(program, tmp_path))
        wait_for(spec, ros2, tmp_path, *names)


def test_package_of_nodl(ros2, render, tmp_path):
    """What NoDL's own `describe` has said of a node becomes one that has it all."""
    text = (DATA / "nodl/described/s2_node.nodl.yaml").read_text()
    text = text.replace("example_interfaces/action", "test_msgs/action")
    text = text.replace("example_interfaces/srv/AddTwoInts", "std_srvs/srv/SetBool")
    (tmp_path / "s2_node.nodl.yaml").write_text(text)
    render(tmp_path / "s2_node.nodl.yaml", ros_distro=ros2.distro, name="src/package")
    ros2.build(tmp_path)
    with ros2.running(tmp_path / "install/package/lib/package/s2_node", tmp_path):
        spec = wait_for('name="s2/compute"', ros2, tmp_path, "s2_node")
    found = {element.get("name"): element.tag for element in ET.fromstring(spec.encode()).iter()}
    document = yaml.safe_load(text)
    kinds = {"publishers": "directPublisher", "subscriptions": "directSubscriber"}
    kinds |= {"service_servers": "serviceServer", "service_clients": "serviceClient"}
    kinds |= {"action_servers": "actionServer", "action_clients": "actionClient"}
    wanted = {each["name"][1:]: kind for key, kind in kinds.items() for each in document[key]}
    wanted |= dict.fromkeys(document["parameters"], "parameter")
    assert found == {**wanted, "s2_node": "node"}
