"""What several nodes have in common: code stays where elements go into a group, and out."""

import pytest

from support.repository import commit

SPEC = """<package name="arm" author="A" author_email="a@example.org"
         description="D" license="MIT">
  <group name="output">
    <parameter name="unit" type="string" value="m"/>
  </group>
  <node name="reach">
    <use group="output"/>
    <directPublisher name="pose" type="std_msgs::String"/>
    <parameter name="frame" type="string" value="base"/>
    <directSubscriber name="say" type="std_msgs::String"/>
  </node>
  <node name="grasp">
    <use group="output"/>
  </node>
</package>
"""
MEMBERS = """    <directPublisher name="pose" type="std_msgs::String"/>
    <parameter name="frame" type="string" value="base"/>
    <directSubscriber name="say" type="std_msgs::String"/>
"""
RECEIVE = '''"""Handle a message of topic say."""\n'''
CODE = """        text = f'{message.data} {self.frame}'
        self.passthrough.pub_pose.publish(PubPose(data=text))
"""
COMMON = '''"""What both nodes do."""

from arm.output_interface import OutputConfig, OutputPassthrough


class Output:
    """Knows the unit."""

    def __init__(self, passthrough: OutputPassthrough, config: OutputConfig) -> None:
        self.unit = config.unit
        passthrough.log.info(self.unit)
'''


@pytest.fixture
def package(render):
    package = render(SPEC, name="arm")
    impl = package / "arm/reach_impl.py"
    text = impl.read_text()
    line = "from arm.reach_interface import (\n"
    assert line in text
    text = text.replace(line, f"{line}    PubPose,\n")
    start = text.index("    def receive_say")
    end = text.index('"""\n', text.index('"""', start) + 3) + 4
    impl.write_text(text[:end] + CODE + text[end:])
    (package / "arm/output.py").write_text(COMMON)
    commit(package, "Write the logic")
    return package


@pytest.fixture
def update(package, copier_command):
    def run(change):
        spec = package / "arm.ros_package"
        text = change(spec.read_text())
        assert text != spec.read_text()
        spec.write_text(text)
        commit(package, "Change the spec")
        result = copier_command("update", "--trust", "--defaults", cwd=package)
        assert result.returncode == 0, result.stderr
        assert "without conflicts" in result.stderr, result.stderr
        commit(package, "Update")
        return result.stderr

    return run


def into_the_group(text):
    return text.replace(MEMBERS, "").replace("  </group>", f"{MEMBERS}  </group>")


def test_what_moves_into_a_group_and_out_of_it_keeps_its_code(package, update):
    impl = package / "arm/reach_impl.py"
    before, interface = impl.read_text(), (package / "arm/reach_interface.py").read_text()
    said = update(into_the_group)
    assert impl.read_text() == before
    assert "left" not in said
    assert "def receive_say" in (package / "arm/grasp_impl.py").read_text()
    assert "frame: str = 'base'" in (package / "arm/output_interface.py").read_text()
    update(lambda text: text.replace(MEMBERS, "").replace('"reach">\n', f'"reach">\n{MEMBERS}'))
    assert impl.read_text() == before
    assert (package / "arm/reach_interface.py").read_text() == interface
    assert "def receive_say" not in (package / "arm/grasp_impl.py").read_text()


def test_names_before_count_in_a_group(package, update):
    """Of what is in it, in all nodes; of the group itself, in code for all of them, too."""
    update(into_the_group)
    said = update(
        lambda text: (
            text.replace('name="pose"', 'name="place" was="pose"')
            .replace('name="unit"', 'name="scale" was="unit"')
            .replace('name="say"', 'name="tell" was="say"')
        )
    )
    assert "> directPublisher place on output, was pose" in said
    impl = (package / "arm/reach_impl.py").read_text()
    new = CODE.replace("pub_pose", "pub_place").replace("PubPose", "PubPlace")
    assert "def receive_tell" in impl
    assert new in impl
    assert "config.scale" in (package / "arm/output.py").read_text()
    said = update(
        lambda text: text.replace(
            '<group name="output"', '<group name="result" was="output"'
        ).replace('use group="output"', 'use group="result"')
    )
    assert "> group result, was output" in said
    common = (package / "arm/output.py").read_text()
    assert "from arm.result_interface import ResultConfig, ResultPassthrough" in common
    assert "passthrough: ResultPassthrough, config: ResultConfig" in common
    assert not (package / "arm/output_interface.py").exists()
    assert new in (package / "arm/reach_impl.py").read_text()


def test_a_group_and_what_is_in_it_are_renamed_at_once(package, update):
    update(
        lambda text: (
            into_the_group(text)
            .replace('name="frame"', 'name="origin" was="frame"')
            .replace('name="pose"', 'name="place" was="pose"')
        )
    )
    assert "pub_place.publish(PubPlace" in (package / "arm/reach_impl.py").read_text()
    update(
        lambda text: (
            text.replace('group name="output"', 'group name="result" was="output"')
            .replace('group="output"', 'group="result"')
            .replace('name="place" was="pose"', 'name="spot" was="place"')
        )
    )
    assert "pub_spot.publish(PubSpot" in (package / "arm/reach_impl.py").read_text()
    assert "ResultConfig" in (package / "arm/output.py").read_text()
