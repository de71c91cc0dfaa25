"""Topics that have their names from parameters."""

import re

import pytest

from hooks.faults import SpecError
from support.packages import MODELS, model_of
from support.soundness import check_sound

SPEC = """<package name="arm" author="A" author_email="a@example.org" description="d"
         license="MIT">
  <node name="reach" frequency="10">
    {}
  </node>
</package>"""
KINDS = ("publisher", "subscriber", "directPublisher", "directSubscriber")


def spec(name, type_="string"):
    stem = name[:-1].replace(".", "_")
    topics = "\n".join(
        f'<{kind} name="{stem}{number}" type="std_msgs::String" topic_parameter="{name}"/>'
        for number, kind in enumerate(KINDS)
    )
    return SPEC.format(f'{topics}<parameter name="{name}" type="{type_}" value="a"/>')


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("distro", ["noetic", "humble", "kilted"])
def test_code_is_sound(render, model, distro):
    """However long the name, the code is folded."""
    package = render(spec("a" * 60), model=model, ros_distro=distro)
    if model == "python_model":
        check_sound(package)
    for path in package.rglob("*_ros.*pp"):
        lines = path.read_text().splitlines()
        assert not [line for line in lines if len(line) > 100], path


def test_readme_names_the_parameter(render):
    text = (render(spec("rooms.topic"), name="arm") / "README.md").read_text()
    assert len(re.findall(r'named_reach_rooms_topic\(\["parameter rooms.topic"\]\)', text)) == 4
    assert text.count(", by the name in `rooms.topic`") == len(KINDS)


@pytest.mark.parametrize("type_", ["int", "string[]"])
@pytest.mark.parametrize("model", MODELS)
def test_it_must_be_a_text(model, type_):
    text = spec("topic", type_).replace('value="a"', "")
    message = 'topic_parameter: "topic" is no <parameter> of this <node> whose type is string'
    with pytest.raises(SpecError, match=re.escape(message)):
        model_of(model).context(text.encode(), "spec", "kilted")


def listed(name, type_="string[]"):
    stem = name[:-1].replace(".", "_")
    topics = "\n".join(
        f'<{kind} name="{stem}{number}" type="std_msgs::Bool" depth="1" for_each="{name}"/>'
        for number, kind in enumerate(KINDS[2:])
    )
    return SPEC.format(f'{topics}<parameter name="{name}" type="{type_}" value="[a]"/>')


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("distro", ["noetic", "humble", "kilted"])
def test_code_for_a_list_is_sound(render, model, distro):
    package = render(listed("a" * 60), model=model, ros_distro=distro)
    if model == "python_model":
        check_sound(package)
    for path in package.rglob("*.[ch]pp"):
        lines = path.read_text().splitlines()
        assert not [line for line in lines if len(line) > 100], path


def test_readme_names_the_list(render):
    text = (render(listed("rooms.topics"), name="arm") / "README.md").read_text()
    assert len(re.findall(r'named_reach_rooms_topics\(\["parameter rooms.topics"\]\)', text)) == 2
    assert text.count(", by each name in `rooms.topics`") == 2


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            '"string[]"',
            '"string"',
            '"topics" is no <parameter> of this <node> whose type is string[',
        ),
        (
            '"string[]" value="[a]"',
            '"int[]"',
            '"topics" is no <parameter> of this <node> whose type is string[',
        ),
        (
            '<parameter name="topics"',
            '<dynParameter name="topics"',
            'for_each: "topics" is no <parameter> of this <node> whose',
        ),
        (
            '2" ',
            '2" topic_parameter="one" ',
            'attribute "for_each" has no meaning where topic_parameter is "one"; drop it',
        ),
        ("<directPublisher", "<publisher", 'unknown attribute "for_each"'),
    ],
)
@pytest.mark.parametrize("model", MODELS)
def test_a_list_of_texts_alone(model, old, new, message):
    one = '<parameter name="one" type="string" value="1"/></node>'
    text = listed("topics").replace("</node>", one)
    model_of(model).context(text.encode(), "spec", "kilted")
    text = text.replace("topic0", "topic2").replace(old, new, 1)
    with pytest.raises(SpecError, match=re.escape(message)):
        model_of(model).context(text.encode(), "spec", "kilted")


@pytest.mark.parametrize("topics", [spec, listed])
def test_python_in_ros1_needs_what_checks_names(render, topics):
    package = render(topics("topics"), ros_distro="noetic")
    assert "<exec_depend>rosgraph</exec_depend>" in (package / "package.xml").read_text()
