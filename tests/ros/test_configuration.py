"""What configures a node, with real middleware: the QoS of its topics, its parameters."""

import re
import time

import pytest

from support import ros
from support.packages import MODELS

SPEC = """<package name="station" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="station" frequency="50">
    <subscriber name="order" type="std_msgs::String"/>
    <subscriber name="lidar" type="std_msgs::String" qos="sensor_data"/>
    <publisher name="range" type="std_msgs::String" history="keep_all"/>
    <directSubscriber name="camera" type="std_msgs::String" qos="sensor_data" depth="1"/>
    <directPublisher name="map" type="std_msgs::String" durability="transient_local" depth="1"/>
    <directPublisher name="seen" type="std_msgs::String"/>
    <parameter name="limit" type="int" value="3"/>
    <dynParameter name="gain" type="double" value="0.5"/>
  </node>
</package>
"""
# An order is drawn on the map; what the camera and the lidar give is published again.
LOGIC = {
    "python_model": (
        "station/station_impl.py",
        ('of one cycle from the latest inputs."""',)
        + (
            """
        data.out_range = data.in_lidar
        if data.in_order_updated:
            data.in_order.data += ' %d' % config.limit
            self.passthrough.pub_map.publish(data.in_order)
            self.passthrough.pub_seen.publish(data.in_order)""",
        ),
        (
            'Handle a message when it arrives, in a thread of its own."""',
            "\n        self.passthrough.pub_seen.publish(message)",
        ),
    ),
    "cpp_model": (
        "src/station_impl.cpp",
        (
            "const StationConfig & config)\n{\n}",
            """
  data.out_range = data.in_lidar;
  if (data.in_order_updated) {
    auto drawn = data.in_order;
    drawn.data += " " + std::to_string(config.limit);
    passthrough_.pub_map->publish(drawn);
    passthrough_.pub_seen->publish(drawn);
  }
}""",
        ),
        ("& message)\n{\n}", "\n  passthrough_.pub_seen->publish(message);\n}"),
    ),
}
each_model = pytest.mark.parametrize("model", MODELS, scope="module")


def built(ros_, put, model, workspace):
    """Return a workspace with the package, its logic filled in."""
    spec = workspace / "station.ros_package"
    spec.write_text(SPEC)
    put(spec, model, ros_.distro, workspace)
    name, *edits = LOGIC[model]
    file = workspace / "src/station" / name
    text = file.read_text()
    for place, code in edits:
        assert place in text, text
        text = text.replace(place, place.removesuffix("\n}") + code)
    file.write_text(text)
    ros_.build(workspace)
    return workspace


@pytest.fixture(scope="module")
def ros1_station(put, model, tmp_path_factory):
    ros1 = ros.ros1() or pytest.skip(ros.NO_ROS1)
    return built(ros1, put, model, tmp_path_factory.mktemp("ros1_station"))


@pytest.fixture(scope="module")
def ros2_station(put, model, tmp_path_factory):
    ros2 = ros.ros2() or pytest.skip(ros.NO_ROS2)
    if model == "cpp_model" and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    return built(ros2, put, model, tmp_path_factory.mktemp("ros2_station"))


def station(ros2, workspace, *parameters):
    """Run the node in ROS 2 with parameters."""
    given = "".join(f" -p {parameter}" for parameter in parameters)
    executable = workspace / "install/station/lib/station/station"
    return ros2.running(f"{executable} --ros-args{given}", workspace)


def wait_for(log, *texts):
    end = time.monotonic() + 20
    while missing := [text for text in texts if not re.search(text, log())]:
        assert time.monotonic() < end, f"no {missing} in {log()}"
        time.sleep(0.1)


@pytest.mark.ros1
@each_model
def test_qos_in_ros1(ros1, ros1_station, model):
    command = f"{ros1.python if model == 'python_model' else ''}"
    command = f"{command} {ros1_station}/devel/lib/station/station"
    with ros.master(ros1), ros1.running(command.strip(), ros1_station):
        ros1.talk(ros1_station, "station", "qos")


@pytest.mark.ros2
@each_model
def test_qos_in_ros2(ros2, ros2_station, model):
    with station(ros2, ros2_station) as log:
        ros2.talk(ros2_station, "station", "qos")
    assert "incompatible QoS" not in log()


@pytest.mark.ros2
@each_model
def test_overridden_qos(ros2, ros2_station, model):
    """All four policies, by the standard parameters; what then does not fit is logged."""
    overrides = (
        "qos_overrides./map.publisher.durability:=volatile",
        "qos_overrides./map.publisher.history:=keep_all",
        "qos_overrides./camera.subscription.reliability:=reliable",
        "qos_overrides./camera.subscription.depth:=7",
    )
    with station(ros2, ros2_station, *overrides) as log:
        ros2.talk(ros2_station, "station", "overridden")
        wait_for(
            log,
            "New subscription discovered on topic '/?map', requesting incompatible QoS. "
            "No messages will be sent to it. Last incompatible policy: DURABILITY",
            "New publisher discovered on topic '/?camera', offering incompatible QoS. "
            "No messages will be (received|sent) (from|to) it. "
            "Last incompatible policy: RELIABILITY",
        )


@pytest.mark.ros2
@each_model
def test_parameters_change_while_unconfigured(ros2, ros2_station, model):
    with station(ros2, ros2_station, "autostart:=false"):
        ros2.talk(ros2_station, "station", "parameters")
