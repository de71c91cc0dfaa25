"""Packages pass their own linters whatever their spec: each interface kind alone, long names."""

import itertools
import re
import string

import pytest

from support.linters import cpp_faults, leave_news, python_faults, ruff_faults, write
from support.model_checks import Model
from support.packages import DATA
from support.repository import ROOT

MODELS = {name: Model(ROOT / name) for name in ("cpp_model", "mixed_model", "python_model")}
ROS = ("noetic", "kilted")
MORE = ({}, {"frequency": "10"}, {"diagnostics": "true"})
TOPIC = re.compile(r" +'\w+(\.\w+)?': \(")
"""An interface in a test of a node, with the name of its type."""
WORD = "long_name_of_a_part_that_has_many_words_and_still_goes_on_and_on"


def put(renderers, folder, model, elements, distro):
    """Write the package of a spec into a folder; say whether the dictionary allows the spec."""
    spec = model.context(model.spec(elements), distro)
    if spec:
        write(folder, renderers[model.name].render(spec, distro))
    return bool(spec)


def bare(model, node, more):
    """Return the attributes of a node, of those that some kinds require only `more`."""
    values = model.base(node, more)
    left_out = model.required(node) - more.keys()
    return {name: value for name, value in values.items() if name not in left_out}


@pytest.mark.parametrize("name", MODELS)
def test_interface_kinds_alone(renderers, tmp_path, name):
    """Nothing is imported for another kind, or missing without it."""
    model = MODELS[name]
    node = next(owner for owner in model.owners if owner.path == ("node",))
    made = {
        owner.kind
        for owner, (number, more), distro in itertools.product(model.owners, enumerate(MORE), ROS)
        if owner.path[:1] == ("node",)
        and put(
            renderers,
            tmp_path / f"{owner.kind}_{number}_{distro}",
            model,
            [
                (node, bare(model, node, more)),
                *([(owner, model.base(owner))] if owner.kind else []),
            ],
            distro,
        )
    }
    assert made == {owner.kind for owner in model.owners if owner.component == "node"}
    faults = ruff_faults(tmp_path)
    assert not faults, faults


@pytest.mark.parametrize("distro", ROS)
@pytest.mark.parametrize("name", ["cpp_model", "python_model"])
def test_short_names_need_no_folding(renderers, monkeypatch, name, distro):
    """It parses a file three times; templates have no line that is too long without them."""
    renderer, folded = renderers[name], []
    monkeypatch.setattr(renderer, "made", {})
    monkeypatch.setitem(
        renderer.env.filters, "fold_python", lambda text: folded.append(text) or text
    )
    spec = (DATA / "fast.ros_package").read_text()
    renderer.render(MODELS[name].context(spec, distro), distro)
    assert folded
    long = [line for text in folded for line in text.splitlines() if len(line) > 99]
    assert not [line for line in long if not TOPIC.match(line)], long


@pytest.mark.parametrize("name", MODELS)
def test_bounds_of_any_size(renderers, tmp_path, name):
    """In the form of ruff, in .cfg files, too, which are Python."""
    model = MODELS[name]
    owners = {owner.kind or owner.component: owner for owner in model.owners}
    node = (owners["node"], model.base(owners["node"], {"frequency": "10"}))
    elements = [node]
    for number, (low, high) in enumerate((("-1e300", "1e300"), ("1e-300", "1e22"))):
        more = {"type": "double", "min": low, "value": high, "max": high}
        for kind in ("parameter", "dynParameter"):
            values = model.base(owners[kind], {**more, "name": f"{kind}{number}"})
            elements.append((owners[kind], values))
    for distro in ROS:
        assert put(renderers, tmp_path / distro, model, elements, distro)
    for file in tmp_path.rglob("cfg/*.cfg"):
        file.with_suffix(".py").write_text(file.read_text() + "# ruff: noqa: F401\n")
    faults = ruff_faults(tmp_path)
    assert not faults, faults


def long_names(model, size):
    """Return the elements of a spec with one of each interface, with names of so many letters."""
    package = model.owners[0]
    elements = [(package, model.base(package))]
    small = [item for item in model.small() if item[0].component == "node"]
    elements += [item for item in small if "name" in item[0].attributes]
    for number, (owner, values) in enumerate(elements):
        name = (string.ascii_lowercase[number] + WORD)[:size].rstrip("_").ljust(size, "x")
        attribute = owner.attributes["name"]
        is_private = attribute.format == "ros_name" and not attribute.pattern and number % 3 == 0
        values["name"] = f"~/{name}" if is_private else name
    return elements


@pytest.mark.parametrize("name", MODELS)
def test_names_of_any_length(renderers, tmp_path, name):
    for size, distro in itertools.product((3, 12, 19, 27, 30, 36, 40, 47, 54, 60), ROS):
        elements = long_names(MODELS[name], size)
        assert put(renderers, tmp_path / f"{size}_{distro}", MODELS[name], elements, distro)
    faults = ruff_faults(tmp_path)
    assert not faults, faults


def test_linters_accept_long_names(renderers, tmp_path, ros2):
    variants = itertools.product(MODELS.items(), ROS, (19, 60))
    for number, ((name, model), distro, size) in enumerate(variants):
        elements = long_names(model, size)
        assert put(renderers, tmp_path / f"{number}_{name}", model, elements, distro)
    leave_news(tmp_path, {})
    faults = python_faults(ros2, tmp_path) + cpp_faults(ros2, tmp_path)
    assert not faults, faults


def test_linters_accept_callbacks_with_long_names(renderers, tmp_path, ros2):
    """Signatures about as long as a line: of what the logic hears, accepts, does in threads."""
    text = """<package name="arm" description="Arm" author="A" author_email="a@b.org"
      license="MIT">
      <node name="{}">
        <parameter name="topics" type="string[]" value="[a]"/>
        <directSubscriber name="hear" type="std_msgs::String" for_each="topics"/>
        <actionServer name="move" type="test_msgs::Fibonacci" accept="true"/>
        <thread name="{}"/>
        <thread name="{}"/>
      </node>
    </package>"""
    for size, distro in itertools.product((36, 42, 48, 49, 51, 54, 57, 60), ROS):
        spec = text.format("a" * size, "b" * (88 - size), "c" * (89 - size)).encode()
        context = MODELS["cpp_model"].hook.context(spec, "spec.xml", distro)
        files = renderers["cpp_model"].render(context, distro)
        code = {name: lines for name, lines in files.items() if re.match(r"src/\w+\.cpp", name)}
        write(tmp_path / f"{size}_{distro}", code)
    faults = cpp_faults(ros2, tmp_path)
    assert not faults, faults
