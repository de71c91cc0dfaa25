"""service_model: nodes that only serve, without ROS and in both."""

import re
import shlex
import shutil

import pytest

from support import ros
from support.packages import DATA, DISTROS, files
from support.repository import EXAMPLES, commit
from support.soundness import check_imports, check_sound

SPECS = {"example": EXAMPLES / "serving.ros_package", "starter": None}
LOGIC = {
    "greet": """response.success = True
        response.message = self.greeting
        return response
""",
    "open": """response.message = f"open: {request.data}"
        return response
""",
    "count": """for number in range(goal.request.order):
            if goal.cancel_requested:
                goal.canceled()
                return
            goal.feedback.sequence = [*goal.feedback.sequence, number]
            goal.publish_feedback()
            time.sleep(self.patience)
        goal.result.sequence = goal.feedback.sequence
        goal.succeed()
""",
    "configure": """self.greeting, self.patience = config.greeting, config.patience
        return True
""",
}
HOME = '    <serviceServer name="go_home" type="std_srvs::Empty"/>\n'


@pytest.mark.parametrize("distro", ["noetic", "humble", "lyrical"])
@pytest.mark.parametrize("name", SPECS)
def test_rendered_code_is_sound(render, name, distro):
    package = render(SPECS[name], model="service_model", ros_distro=distro)
    check_sound(package)
    check_imports(package, distro)


def test_logic_is_the_same_for_all_ros(render):
    packages = [
        render(SPECS["example"], model="service_model", ros_distro=distro, name=f"{distro}/same")
        for distro in DISTROS
    ]
    first, *others = [
        {file.name: file.read_bytes() for file in files(package, "*_impl.py")}
        for package in packages
    ]
    assert set(first) == {
        "clerk_impl.py",
        "idler_impl.py",
        "test_clerk_impl.py",
        "test_idler_impl.py",
    }
    assert all(other == first for other in others)


def fill_in(package):
    """Write the logic of the clerk, and give its parameters other values than the spec."""
    file = package / "serving/clerk_impl.py"
    text = file.read_text().replace("from serving", "import time\n\nfrom serving", 1)
    for name, body in LOGIC.items():
        method = re.compile(rf'(    def \w*{name}\(.*\n        """.*"""\n        ).*\n')
        text, count = method.subn(lambda found, body=body: found[1] + body, text)
        assert count == 1, name
    file.write_text(text)
    config = package / "config/clerk.yaml"
    config.write_text(config.read_text().replace('"hello"', '"good day"').replace("0.5", "0.05"))
    commit(package, "Fill in the logic")
    return text


def test_new_service_is_merged(render, update):
    package = render(SPECS["example"], model="service_model")
    text = fill_in(package)
    file = package / "serving.ros_package"
    file.write_text(file.read_text().replace("    <actionServer", HOME + "    <actionServer", 1))
    commit(package)
    update(package)
    new = (package / "serving/clerk_impl.py").read_text()
    assert "def serve_go_home" in new
    assert "<<<<<<<" not in new
    assert set(text.splitlines()) <= set(new.splitlines())


def talk(ros_, workspace, peer):
    script = shlex.quote(str(ros.PEERS / "serving.py"))
    ros_.run(f"{ros_.python} {script} {peer}", workspace, workspace, timeout=120)


@pytest.mark.ros2
def test_serves_in_ros2(ros2, render, tmp_path):
    spec = (EXAMPLES / "serving.ros_package").read_text()
    package = render(spec, model="service_model", ros_distro=ros2.distro, name="src/serving")
    ros2.build(tmp_path)
    ros2.run("colcon test --event-handlers console_cohesion+", tmp_path, tmp_path)
    result = ros2.run("colcon test-result --all --verbose", tmp_path, tmp_path).stdout
    assert re.search(r"Summary: 6 tests, 0 errors, 0 failures, 0 skipped", result), result
    fill_in(package)
    ros2.build(tmp_path)
    install = "install/serving"
    command = f"{install}/lib/serving/clerk --ros-args"
    command += f" --params-file {install}/share/serving/config/clerk.yaml"
    with ros2.running(command, tmp_path, tmp_path) as log:
        talk(ros2, tmp_path, "ros2")
        assert "Traceback" not in log()


@pytest.mark.ros1
def test_serves_in_ros1(ros1, render, tmp_path):
    shutil.copytree(DATA / "test_msgs", tmp_path / "src/test_msgs")
    spec = EXAMPLES / "serving.ros_package"
    package = render(spec, model="service_model", ros_distro="noetic", name="src/serving")
    ros1.build(tmp_path)
    ros1.run("catkin_make run_tests", tmp_path, tmp_path)
    result = ros1.run("catkin_test_results", tmp_path, tmp_path).stdout
    assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", result), result
    lint = ros1.run("catkin_lint --strict -W1 .", package).stdout
    assert "found 0 problems" in lint, lint
    fill_in(package)
    with ros.master(ros1), ros1.running("roslaunch serving serving.launch", tmp_path) as log:
        talk(ros1, tmp_path, "ros1")
        assert "Traceback" not in log()
