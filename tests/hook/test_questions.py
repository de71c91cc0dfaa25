"""The options of a model, read from its copier.yml, and what is said of answers that changed."""

from types import SimpleNamespace

import pytest

from hooks.changes import changed_answers
from hooks.faults import SpecError
from hooks.package import Package
from hooks.questions import check_choices, check_options, check_template, questions
from hooks.specs import Specs

COPIER_YML = """
_subdirectory: template
colour: {type: str, choices: [red, 2]}
size: {type: str, choices: {Small: s, Large: l}}
parts: {type: str, multiselect: true, choices: [wheel, arm]}
nested: {type: str, choices: [[Red, r]]}
count: 3
hidden: {type: str, when: false}
silent: {type: str, ask: false}
---
!include more.yml
---
"""


@pytest.fixture
def root(tmp_path):
    (tmp_path / "copier.yml").write_text(COPIER_YML)
    (tmp_path / "more.yml").write_text("late: {type: str}\n")
    return tmp_path


def test_questions(root):
    names = ["colour", "size", "parts", "nested", "count", "hidden", "silent", "late"]
    assert [*questions(root)] == names


def test_options_that_are_asked(root):
    check_options(["colour", "count", "late", "_own"], root)
    for name in ("hidden", "silent", "color"):
        with pytest.raises(SpecError, match=f"-d {name}: no such option; .*colour"):
            check_options(["colour", name], root)


@pytest.mark.parametrize(
    "answers",
    [
        {"colour": 2},
        {"size": "l"},
        {"parts": ["wheel", "leg"]},
        {"nested": "green"},
        {"count": 7},
        {"late": "any"},
        {"kind": "b"},
    ],
)
def test_answers_that_may_be(root, answers):
    check_choices(answers, root, {"late": ["any", "one"]})


@pytest.mark.parametrize("answers", [{"colour": "blue"}, {"size": "Large"}, {"late": "none"}])
def test_answers_that_may_not_be(root, answers):
    name, answer = next(iter(answers.items()))
    with pytest.raises(SpecError, match=f'{name}: unknown "{answer}"'):
        check_choices(answers, root, {"late": ["any", "one"]})


@pytest.mark.parametrize("model", ["arm", "", None, "arms", "other"])
def test_model_that_is_a_template_by_itself(root, model):
    """It is in the folder of the collection, but none of its models."""
    for file in ("template/x", "arm/dictionary.yaml", "arm/copier.yml", "other/copier.yml"):
        (root / file).parent.mkdir(exist_ok=True)
        (root / file).touch()
    given = {} if model is None else {"model": model}
    run = SimpleNamespace(given=given, package=Package(root / "package", "answers.yml"))
    specs = Specs(root, None, None)
    if model == "other":
        with pytest.raises(SpecError, match="^model: other is a template by itself; copy it"):
            specs.check_answers(run)
    else:
        assert specs.check_answers(run) == ""


def test_spec_is_no_option(root):
    """Copier itself gives a mapping."""
    package, specs = Package(root / "package", "answers.yml"), Specs(root, None, None)
    (root / "template").mkdir()
    assert specs.check_answers(SimpleNamespace(given={"spec": {}}, package=package)) == ""
    with pytest.raises(SpecError, match="^-d spec: no such option"):
        specs.check_answers(SimpleNamespace(given={"spec": "a"}, package=package))


@pytest.mark.parametrize(("is_inner", "said"), [(False, "changed"), (True, "")])
def test_spec_that_changed_is_looked_for_where_a_file_may_be_read(root, is_inner, said):
    (root / "dictionary.yaml").write_text("node_interface: {topic: [name]}\n")
    folder = root / "arm"
    folder.mkdir()
    (folder / "arm.ros_package").write_text("<package name='arm'><node name='a'/></package>")
    about = {"given": {}, "distro": "humble", "is_inner": is_inner}
    run = SimpleNamespace(**about, package=Package(folder, "answers.yml"))
    specs = Specs(root, lambda model: None, lambda *about: None)
    assert specs.changed(run, "", {}) == said
    assert specs.changed(run, "", specs.context(run, "")) == ""


def test_template_that_copier_can_use(root):
    (root / "template").mkdir()
    more = """
made: {type: "{{ kind }}", choices: "{{ all() }}", default: x}
drawn: {type: str, choices: [a, b], default: "{{ first }}"}
chosen: {type: str, choices: {A: 1, B: b}, default: 1}
"""
    (root / "copier.yml").write_text(COPIER_YML + more)
    check_template(root)
    (root / "copier.yml").write_text("_subdirectory: '{{ model }}/template'\n")
    check_template(root)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "_subdirectory: templat",
            ': _subdirectory: no folder "templat"; did you mean "template"?',
        ),
        (
            "colour: {type: text}",
            ': colour: unknown type "text"; allowed: bool, float, int, json,',
        ),
        (
            "colour:\n  choices: [red, green]\n  default: gren",
            ': colour: default: unknown choice "gren"; did you mean "green"? allowed: red, green',
        ),
    ],
)
def test_template_that_copier_cannot_use(root, text, said):
    (root / "template").mkdir()
    (root / "copier.yml").write_text(f"{COPIER_YML}\n{text}\n")
    with pytest.raises(SpecError) as caught:
        check_template(root)
    line = COPIER_YML.count("\n") + 2
    assert str(caught.value).startswith(f"copier.yml:{line}{said}")


def test_changed_answers():
    old = {"spec": "a", "ros_distro": "humble", "_commit": "1", "same": 1}
    new = {"spec": "b", "ros_distro": "kilted", "_commit": "2", "same": 1, "new": 2}
    assert [*changed_answers(old, new)] == ["~ ros_distro: humble -> kilted"]
