"""Messages that belong together: the code of their callback stays as inputs come and change."""

import pytest

from support.repository import commit, git

SPEC = """<package name="arm" author="A" author_email="a@example.org"
         description="D" license="MIT">
  <node name="reach">
    <directSubscriber name="say" type="std_msgs::String"/>
    <synchronizer name="stereo" slop="0.02">
      <input name="left" type="sensor_msgs::Image"/>
      <input name="right" type="sensor_msgs::Image"/>
    </synchronizer>
  </node>
</package>
"""
CODE = {
    "python_model": """        width = messages.left.width + messages.right.width
        self.passthrough.log.info(f'{width}')
""",
    "cpp_model": """  const auto width = messages.left.width + messages.right.width;
  passthrough_.log.info(std::to_string(width));
""",
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
    start = text.index("receive_stereo")
    sign = '"""\n' if model == "python_model" else "{\n"
    end = (
        text.index(sign, text.index('"""', start) + 3)
        if sign[0] == '"'
        else text.index(sign, start)
    )
    end += len(sign)
    impl.write_text(text[:end] + CODE[model] + text[end:])
    commit(package, "Write the logic")
    return package


def change(package, update, *pairs):
    """Change the spec and update; return the logic before and after."""
    spec = package / "arm.ros_package"
    text = spec.read_text()
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    spec.write_text(text)
    commit(package, "Change the interface")
    update(package)
    git(package, "diff", "--check")
    (logic,) = [*package.rglob("reach_impl.py"), *package.rglob("src/*_impl.cpp")]
    return logic.read_text()


def test_an_input_comes(package, update, model):
    before = (package / LOGIC[model]).read_text()
    more = '<input name="info" type="sensor_msgs::CameraInfo"/>\n    </synchronizer>'
    assert change(package, update, ("</synchronizer>", more)) == before


def test_an_input_has_another_type_and_the_slop_goes(package, update, model):
    before = (package / LOGIC[model]).read_text()
    pairs = (
        (' slop="0.02"', ""),
        ('"right" type="sensor_msgs::Image', '"right" type="sensor_msgs::Imu'),
    )
    assert change(package, update, *pairs) == before


def test_names(package, update, model):
    """The code follows new names of a synchronizer and of an input."""
    after = change(
        package,
        update,
        ('name="stereo"', 'name="pair" was="stereo"'),
        ('name="left"', 'name="port" was="left"'),
    )
    assert "receive_pair(" in after
    assert "messages: PairMessages" in after or "PairMessages & messages" in after
    assert "messages.port.width + messages.right.width" in after
    assert "stereo" not in after.lower()


def test_a_synchronizer_goes(package, update, model):
    start = SPEC.index("    <synchronizer")
    end = SPEC.index("  </node>")
    after = change(package, update, (SPEC[start:end], ""))
    assert "stereo" not in after.lower()
    assert "receive_say" in after
