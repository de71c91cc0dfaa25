"""examples/driver: what a spec says of the package itself, and the client library in its logic."""

import os
import re
import xml.etree.ElementTree as ET
from time import sleep

import pytest

from support import ros
from support.repository import EXAMPLES

SPEC = (EXAMPLES / "driver.ros_package").read_text()
MODELS = ["python_model", "cpp_model", "mixed_model python", "mixed_model cpp"]
FILES = [
    "config/left/sensor.yaml",
    "config/old/device.yaml",
    "launch/old/driver.txt",
    "urdf/hand/finger.urdf",
]
PROGRAMS = ["calibrate", "replay", "sensor-driver"]
each_model = pytest.mark.parametrize("model", MODELS)


def make(render, model, distro, folder="src"):
    """Make the package, with files of the developer's in its folders."""
    model, _, language = model.partition(" ")
    spec = SPEC.replace("<node ", f'<node language="{language}" ') if language else SPEC
    package = render(spec, model=model, ros_distro=distro, name=f"{folder}/driver")
    for name in (*FILES[1:], "tools/calibrate"):
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text("#!/bin/sh\necho calibrated\n")
    (package / "tools/calibrate").chmod(0o755)
    (package / "tools/parts").mkdir()
    return package


def check_installed(prefix):
    for name in FILES:
        assert (prefix / "share/driver" / name).is_file(), name
    for name in PROGRAMS:
        assert os.access(prefix / "lib/driver" / name, os.X_OK), name


def check_tests(ros_, workspace, model):
    if model.startswith("mixed"):
        return  # they are those of the language alone; test_mixed.py runs such ones
    results = ros_.test(workspace)
    assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures", results), results


@each_model
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_package_xml(render, model, distro):
    root = ET.parse(make(render, model, distro) / "package.xml").getroot()

    def found(tag):
        return [element.text for element in root.iter(tag)]

    assert found("version") == ["1.2.0"]
    assert found("maintainer") == ["Ada Lovelace", "Grace Hopper"]
    assert [url.get("type") for url in root.iter("url")] == ["website", "repository"]
    assert found("url")[1] == "https://example.org/driver.git?a=1&b=2"
    assert found("exec_depend").count("robot_state_publisher") == 1
    assert found("test_depend").count("python3-numpy") == 1


@each_model
def test_dependency_has_each_kind_once(render, model):
    """catkin_pkg refuses a package that has a <depend> and, say, a <build_depend> on another."""
    kinds = [*("build", "build_export", "exec", "test", "doc", "group", "buildtool_export"), ""]
    more = "".join(
        f"  <depend{kind and f' kind={kind!r}'}>{name}</depend>\n"
        for kind in kinds
        for name in ("std_msgs", "eigen")
    )
    model, _, language = model.partition(" ")
    spec = SPEC.replace("<node ", f'<node language="{language}" ') if language else SPEC
    package = render(spec.replace("</package>", f"{more}</package>"), model=model)
    root = ET.parse(package / "package.xml").getroot()
    for name in ("std_msgs", "eigen"):
        tags = [element.tag for element in root if element.text == name]
        assert len(tags) == len(set(tags))
        assert "depend" not in tags or not {"build_depend", "exec_depend", "test_depend"} & {*tags}
        assert {"doc_depend", "group_depend", "buildtool_export_depend"} <= set(tags)


@pytest.mark.ros1
@pytest.mark.parametrize("model", [*MODELS[:2], "mixed_model cpp"])
def test_driver_in_ros1(ros1, render, tmp_path, model):
    package = make(render, model, "noetic")
    ros1.run("catkin_make install", tmp_path, timeout=1800)
    check_installed(tmp_path / "install")
    launch = f"roslaunch {package}/launch/driver.launch"
    nodes = ros1.run(f"{launch} --nodes namespace:=arm", tmp_path, tmp_path).stdout.split()
    assert sorted(nodes) == ["/arm/left/sensor", "/arm/replay", "/arm/right/sensor"]
    printed = ros1.run(f"{launch} --dump-params", tmp_path, tmp_path).stdout
    for parameter in ("device: /dev/ttyUSB0", "serial/baud: 9600", "serial/timeout: 0.5"):
        assert f"/left/sensor/{parameter}" in printed
    lint = ros1.run("catkin_lint -W1 .", package, check=False).stdout
    assert "error" not in lint.replace("0 errors", ""), lint
    check_tests(ros1, tmp_path, model)


@pytest.mark.ros2
@pytest.mark.parametrize("model", [*MODELS[:2], "mixed_model python"])
def test_driver_in_ros2(ros2, render, tmp_path, model):
    if "cpp" in model and not ros.has_package(ros2, "rclcpp"):
        pytest.skip("rclcpp is not installed")
    package = make(render, model, ros2.distro)
    ros2.build(tmp_path)
    check_installed(tmp_path / "install/driver")
    # NoDL's tools find what a node is in the index, or in the folder of the package.
    document = (package / "nodl/sensor.nodl.yaml").read_text()
    assert (tmp_path / "install/driver/share/driver/nodl/sensor.nodl.yaml").read_text() == document
    code = "from ament_index_python import get_resource as found;"
    code += " print(found('nodl', 'driver__sensor')[0])"
    assert ros2.run(f'{ros2.python} -c "{code}"', tmp_path, tmp_path).stdout == f"{document}\n"
    program = tmp_path / "install/driver/lib/driver/sensor-driver"
    with ros2.running(program, tmp_path, ends_well=False):
        sleep(3)  # it ends by itself where it cannot start
    if ros.has(ros2, "launch_ros"):
        ask = "ros2 lifecycle get /right/sensor --no-daemon"
        with ros2.running("ros2 launch driver driver.launch.xml", tmp_path):
            ros.wait_for("^active", lambda: ros2.run(ask, tmp_path, check=False).stdout)
    check_tests(ros2, tmp_path, model)


@pytest.mark.parametrize("model", MODELS[:2])
def test_instances_of_the_launch_file(render, model):
    """Each has its namespace below that of the launch file, and its own parameter file."""
    package = make(render, model, "kilted")
    root = ET.parse(package / "launch/driver.launch.xml").getroot()
    nodes = [*root.iter("node"), *root.iter("composable_node")]
    nodes = [node for node in nodes if node.get("name") != "replay"]
    assert [node.get("name") for node in nodes] == ["sensor"] * (2 if model[0] == "p" else 4)
    for node, side in zip(nodes, ["left", "right"] * 2, strict=False):
        text = re.fullmatch(r"\$\(eval '(.*)'\)", node.get("namespace"))[1].replace("\\'", "'")
        for outer, whole in (("", side), ("arm", f"arm/{side}"), ("/arm", f"arm/{side}")):
            assert eval(text.replace("$(var namespace)", outer)) == whole
        assert f"/config/{side}/sensor.yaml" in node.find("param[@from]").get("from")
    assert not (package / "config/sensor.yaml").exists()
    assert "Parameters of left/sensor" in (package / "config/left/sensor.yaml").read_text()


LOGIC = """
        self.assertEqual(self.ros.node.mock_calls, [])
        self.ros.node.METHOD('about')
        self.ros.node.METHOD.assert_called_once_with('about')
        with self.assertRaises(AttributeError):
            self.ros.node.misspelt()
"""


@pytest.mark.parametrize("version", [1, 2])
def test_fake_of_the_client_library(request, render, version):
    """The harness has a fake with the methods of the real one, which records its calls."""
    ros_ = request.getfixturevalue(f"ros{version}")
    package = make(render, "python_model", ros_.distro)
    test = package / "test/test_sensor_impl.py"
    method = "get_param" if version == 1 else "get_parameter"
    added = "\n    def test_node(self):" + LOGIC.replace("METHOD", method)
    test.write_text(test.read_text() + added)
    python = f"PYTHONPATH={package}:{package}/test:$PYTHONPATH {ros_.python}"
    printed = ros_.run(f"env {python} -m unittest test_sensor_impl", package).stdout
    assert re.search(r"Ran [2-9] tests", printed), printed


SERIAL = """
class SerialException(Exception):
    pass

class Serial:
    lines = [b'1.5\\n', b'', None, b'2.5\\n']
    opened = []

    def __init__(self, *arguments, timeout):
        if len(Serial.opened) == 1:
            Serial.opened.append(None)
            raise SerialException('unplugged')
        Serial.opened.append((*arguments, timeout))

    def readline(self):
        line = Serial.lines.pop(0)
        if line is None:
            raise SerialException('unplugged')
        return line

    def close(self):
        pass
"""
DRIVER = """
    def test_page(self):
        for turn in range(5):
            self.impl.read()
        readings = [message.data for message in self.ros.pub_reading.published]
        self.assertEqual(readings, [1.5, 2.5])
        device = ('/dev/ttyUSB0', 9600, 0.5)
        self.assertEqual(serial.Serial.opened, [device, None, device])
        self.assertEqual(self.ros.clock.time, 1.0)
"""


@pytest.mark.parametrize("version", [1, 2])
def test_page_about_drivers(request, render, version):
    """The logic of docs/driver.md reads its device, loses it, and opens it again."""
    ros_ = request.getfixturevalue(f"ros{version}")
    package = make(render, "python_model", ros_.distro)
    page = (EXAMPLES.parent / "docs/driver.md").read_text()
    methods = re.search(r"as generated\n\n(.*?)```", page, re.DOTALL)[1]
    logic = package / "driver/sensor_impl.py"
    head, rest = logic.read_text().split("    def configure(")
    head = head.replace("    SensorConfig,\n", "    PubReading,\n    SensorConfig,\n")
    head = head.replace("SensorPassthrough,\n)", "SensorPassthrough,\n)\nimport serial", 1)
    rest = rest[rest.index("    def activate(") : rest.index("    # Thread read")]
    last = '    def deactivate(self) -> None:\n        """Leave the device open."""\n'
    logic.write_text(f"{head}{rest}{methods}\n{last}")
    if version == 2:
        ros_.run("ament_flake8 driver/sensor_impl.py", package)
    (package / "serial.py").write_text(SERIAL)
    test = package / "test/test_sensor_impl.py"
    text = test.read_text().replace("import unittest", "import serial\nimport unittest", 1)
    test.write_text(text + DRIVER)
    python = f"PYTHONPATH={package}:{package}/test:$PYTHONPATH {ros_.python}"
    printed = ros_.run(f"env {python} -m unittest test_sensor_impl -k page", package).stdout
    assert re.search(r"Ran 1 test", printed), printed


@pytest.mark.parametrize("model", MODELS[:2])
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_package_without_the_client_library_has_no_line_of_it(render, model, distro):
    """Nothing but what is asked for: each line of the others is in a package that asks, too."""
    without = render(SPEC.replace(' client_library="true"', ""), model=model, ros_distro=distro)
    text = "".join(file.read_text() for file in without.rglob("*interface.[hp]*"))
    text += "".join(file.read_text() for file in (without / "test/support").glob("*.[hp]*"))
    words = r"client library|\bNode = |: Node\b|lifecycle_node|NodeHandle|autospec"
    words += r"|passthrough_?\.node\b"
    assert not re.search(words, text), re.search(words, text)
