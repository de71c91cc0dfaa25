"""Deadlines: the method for a topic that is late comes, is renamed and goes with them."""

import pytest

from support.repository import commit, git

SPEC = """<package name="arm" author="A" author_email="a@example.org"
         description="D" license="MIT">
  <node name="reach" frequency="10">
    <subscriber name="pose" type="geometry_msgs::Pose" deadline="0.5"/>
    <directSubscriber name="say" type="std_msgs::String"/>
  </node>
</package>
"""
STUB = {
    "python_model": '    def late_pose(self) -> None:\n        """',
    "cpp_model": "void ReachImpl::late_pose()\n{\n",
}
CODE = {
    "python_model": "        self.passthrough.log.info('late')\n",
    "cpp_model": '  passthrough_.log.info("late");\n',
}
LOGIC = {"python_model": "arm/reach_impl.py", "cpp_model": "src/reach_impl.cpp"}


@pytest.fixture(params=LOGIC)
def model(request):
    return request.param


@pytest.fixture
def package(render, model):
    package = render(SPEC, model=model, name="arm")
    impl = package / LOGIC[model]
    text = impl.read_text()
    end = text.index(STUB[model]) + len(STUB[model])
    end = text.index("\n", end) + 1 if model == "python_model" else end
    impl.write_text(text[:end] + CODE[model] + text[end:])
    commit(package, "Write the logic")
    return package


def change(package, update, model, old, new):
    """Change the spec and update; return the logic."""
    spec = package / "arm.ros_package"
    assert old in spec.read_text()
    spec.write_text(spec.read_text().replace(old, new))
    commit(package, "Change the interface")
    update(package)
    git(package, "diff", "--check")
    return (package / LOGIC[model]).read_text()


def test_another_deadline(package, update, model):
    before = (package / LOGIC[model]).read_text()
    assert change(package, update, model, 'deadline="0.5"', 'deadline="2"') == before


def test_a_new_name(package, update, model):
    after = change(package, update, model, 'name="pose"', 'name="goal" was="pose"')
    assert "late_goal(" in after
    assert "late_pose" not in after
    assert CODE[model] in after


def test_a_deadline_comes(package, update, model):
    after = change(package, update, model, 'String"', 'String" deadline="1"')
    assert "late_say(" in after
    assert CODE[model] in after


def test_a_deadline_goes(package, update, model):
    after = change(package, update, model, ' deadline="0.5"', "")
    assert "late_pose" not in after
    assert CODE[model] not in after
    assert "receive_say" in after
    assert not [*package.rglob("deadline.[hp]*")]
