"""The first screen of the README: in the package of its spec its logic does what it says."""

import re

import pytest

from support.repository import ROOT

README = (ROOT / "README.md").read_text()
CYCLES = """
import sys

sys.path.insert(0, 'test')

from mypkg.cruise_control_impl import CruiseControlImpl
from mypkg.cruise_control_interface import CruiseControlConfig, CruiseControlPassthrough
from std_msgs.msg import Float64
from support.harness import fake, run_cycle

logic = CruiseControlImpl(fake(CruiseControlPassthrough))
for gain in CruiseControlConfig().gain, {gain}:
    config = CruiseControlConfig(gain=gain)
    data = run_cycle(logic, config=config, in_speed=Float64(data={speed}))
    print('data:', data.out_throttle.data)
"""


def block(language):
    return re.search(rf"```{language}\n(.*?)```", README, re.DOTALL)[1]


@pytest.mark.parametrize(
    "version", [pytest.param(1, marks=pytest.mark.ros1), pytest.param(2, marks=pytest.mark.ros2)]
)
def test_first_screen(request, render, version):
    ros = request.getfixturevalue(f"ros{version}")
    package = render(block("xml"), ros_distro=ros.distro, name="mypkg")
    logic = package / "mypkg/cruise_control_impl.py"
    stub = r"    def update\(.*?\n(?=\n    def )"
    text, count = re.subn(stub, lambda _: block("python"), logic.read_text(), flags=re.DOTALL)
    assert count == 1
    logic.write_text(text)
    shown = block("console")
    speed, gain = (re.search(f"{word} ([\\d.]+)", shown)[1] for word in ("data:", "gain"))
    script = package / "cycles.py"
    script.write_text(CYCLES.format(speed=speed, gain=gain))
    printed = ros.run(f"{ros.python} cycles.py", package).stdout
    assert re.findall("^data: .*", printed, re.M) == re.findall("^data: .*", shown, re.M)
