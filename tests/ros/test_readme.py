"""The commands of a package's README, run in a fresh workspace as they stand there."""

import re

import pytest

from support import ros

ABOUT = 'author="A" author_email="a@example.org" license="MIT"'
MESSAGES = f"""<package name="hand_msgs" description="Grips" {ABOUT}>
  <message name="Grip"><field name="force" type="float64" description="In N"/></message>
  <service name="Hold"><request><field name="grip" type="Grip"/></request></service>
  <action name="Take"><goal><field name="grip" type="hand_msgs::Grip"/></goal></action>
</package>"""
USERS = f"""<package name="arm_msgs" description="Grips of arms" {ABOUT}>
  <message name="Arm"><field name="grip" type="hand_msgs::Grip"/></message>
</package>"""
SERVICES = f"""<package name="arm_srvs" description="Services alone" {ABOUT}>
  <service name="Move"><request><field name="grip" type="hand_msgs::Grip"/></request></service>
</package>"""
NODE = """<node name="{}" frequency="10"{}>
    <publisher name="grip" type="hand_msgs::Grip"/>
    <serviceServer name="hold" type="hand_msgs::Hold"/>
    <dynParameter name="gain" type="double" value="1.0"/>
  </node>"""
MIXED = NODE.format("think", ' language="python"') + NODE.format("act", ' language="cpp"')
PACKAGE = '<package name="hand" description="Grips" {}>{}</package>'
SPECS = {
    "interfaces_model": USERS,
    "services alone": SERVICES,
    "python_model": PACKAGE.format(ABOUT, NODE.format("think", "")),
    "cpp_model": PACKAGE.format(ABOUT, NODE.format("act", "")),
    "mixed_model": PACKAGE.format(ABOUT, MIXED),
}
WITH_NODES = ("python_model", "cpp_model", "mixed_model")
DIED = r"process has died \[pid \d+, exit code (?!-2,)"
"""Other than of the signal that stops it."""
UNTIL_STOPPED = "{ timeout -k 60 -s INT 60 timeout --foreground -s INT 8 %s || [ $? = 124 ]; }"
"""Tells it again: on a busy machine, roslaunch 1.15 may miss a signal while it starts."""


def run_readme(ros_, render, workspace, kind):
    """Make a package and the messages it needs, and run what the README of the package says."""
    distro = ros_.distro
    model = kind if kind.endswith("_model") else "interfaces_model"
    render(MESSAGES, model="interfaces_model", ros_distro=distro, name="ws/src/hand_msgs")
    name = re.search('name="(.+?)"', SPECS[kind])[1]
    package = render(SPECS[kind], model=model, ros_distro=distro, name=f"ws/src/{name}")
    blocks = re.findall("```sh\n(.*?)```", (package / "README.md").read_text(), re.DOTALL)
    lines = [re.sub(" +#.*", "", line) for block in blocks for line in block.splitlines()]
    lines = [re.sub("^ros(launch|2 launch) .*", lambda m: UNTIL_STOPPED % m[0], x) for x in lines]
    script = workspace / "readme.sh"
    # What system packages a package needs is not for a test to install.
    script.write_text("rosdep() { true; }\n" + "".join(f"{line} || exit\n" for line in lines))
    return ros_.run("bash -x ../readme.sh", workspace / "ws", timeout=3600).stdout


@pytest.mark.parametrize("kind", SPECS)
def test_commands_in_ros1(ros1, render, tmp_path, kind):
    printed = run_readme(ros1, render, tmp_path, kind)
    if kind not in WITH_NODES:
        assert "arm_msgs/Arm" in printed or "arm_srvs/Move" in printed
    else:
        assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", printed)
        assert not re.search(DIED, printed), printed


@pytest.mark.parametrize("kind", SPECS)
def test_commands_in_ros2(ros2, render, tmp_path, kind):
    for package in ("rclcpp", "launch_ros") if kind in WITH_NODES else ("ros2interface",):
        if not ros.has_package(ros2, package):
            pytest.skip(f"{package} is not installed")
    printed = run_readme(ros2, render, tmp_path, kind)
    if kind not in WITH_NODES:
        assert "arm_msgs/msg/Arm" in printed or "arm_srvs/srv/Move" in printed
    else:
        assert re.search(r"Summary: [1-9]\d* tests, 0 errors, 0 failures, 0 skipped", printed)
        assert not re.search(DIED, printed), printed
