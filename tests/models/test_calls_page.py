"""The table of what the logic can call is what the packages have, in both languages."""

import ast
import re

import pytest

from support.packages import all_kinds, model_of
from support.repository import ROOT

OBJECTS = {
    "log": ("Log", "logger.hpp", "Logger"),
    "diagnostics": ("LogicStatus", "logic_status.hpp", "LogicStatus"),
    "pub_NAME": ("Publisher", "publisher.hpp", "Publisher"),
    "client_NAME": ("ServiceClient", "service_client.hpp", "ServiceClient"),
    "action_NAME": ("ActionClient", "action_client.hpp", "ActionClient"),
    "listener_NAME": ("TransformListener", "transforms.hpp", "TransformListener"),
    "broadcaster_NAME": ("TransformBroadcaster", "transforms.hpp", "TransformBroadcaster"),
    "goal": ("Goal", "goal.hpp", "Goal"),
}

LEVELS = "debug", "info", "warning", "error"
ROS_NEUTRAL = "protocols", "logic_status", "log"


@pytest.fixture(scope="module")
def calls():
    """Return the calls of each object of the table."""
    page = (ROOT / "docs/developers.md").read_text()
    table = page.split("\n## What the logic can call\n")[1].split("\n## ")[0]
    found = {}
    for name, cell in re.findall(r"^\| (?:`(\w+)`|itself)[^|]* \| (.*?) \|", table, re.MULTILINE):
        found.setdefault(name, set()).update(re.findall(r"`([^`]+)`", cell))
    return found


def render(renderers, model, distro):
    context = model_of(model).context(all_kinds().encode(), "spec", distro)
    return renderers[model].render(context, distro)


def arguments(function):
    """Return the names of a function's arguments."""
    return [each.arg for each in (*function.args.posonlyargs, *function.args.args)]


def python_calls(tree, name):
    """Yield the public members of a class, methods with their arguments."""
    (class_,) = (x for x in tree.body if isinstance(x, ast.ClassDef) and x.name == name)
    made = {x.name: x for x in ast.walk(class_) if isinstance(x, ast.FunctionDef)}
    for item in class_.body:
        if isinstance(item, ast.AnnAssign):
            is_method = ast.unparse(item.annotation).startswith("Callable")
            yield item.target.id + ("()" if is_method else "")
        if isinstance(item, ast.FunctionDef) and item.name == "__init__":  # what writes to the log
            members = (x for x in ast.walk(item) if isinstance(x, ast.AnnAssign))
            yield from (f"{x.target.attr}(text)" for x in members if x.target.attr in LEVELS)
            for pair in (x for x in ast.walk(item) if isinstance(x, ast.Tuple)):
                for each in (x.attr for x in pair.elts if isinstance(x, ast.Attribute)):
                    names = ", ".join(arguments(made[each.partition("_")[2]]))  # once, throttle
                    yield f"{each}({names})"
        if isinstance(item, ast.FunctionDef) and not item.name.startswith("_"):
            names = ", ".join(arguments(item)[1:])
            yield item.name if item.decorator_list else f"{item.name}({names})"


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_python(renderers, calls, distro):
    files = render(renderers, "python_model", distro)
    protocols = ast.parse("".join(files[f"all_kinds/ros/{file}.py"] for file in ROS_NEUTRAL))
    found = {name: {*python_calls(protocols, word)} for name, (word, *_) in OBJECTS.items()}
    found["diagnostics"] -= {"read()"}  # of the node and of tests
    interface = ast.parse(files["all_kinds/worker_interface.py"])
    own = {x for x in python_calls(interface, "WorkerPassthrough") if x.endswith("()")}
    told = {re.sub(r"\(.*", "()", call) for call in calls[""]}
    assert own == told
    assert found == {name: told for name, told in calls.items() if name}


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_cpp(renderers, calls, distro):
    files = render(renderers, "cpp_model", distro)
    for name, (_, file, word) in OBJECTS.items():
        text = files[f"include/all_kinds/ros/{file}"]
        body = re.search(
            rf"class {word}\n{{\npublic:\n(.*?)\n(?:private:|protected:|}};)", text, re.S
        )[1]
        names = {*re.findall(r"^  (?:virtual )?\w[\w:<>, ]* (\w+)\(", body, re.MULTILINE)}
        names |= {*re.findall(r"^  [\w: ]*\bAction::\w+ (\w+);", body, re.MULTILINE)}
        names -= {"outcome", "here", "read", word}
        assert names == {call.split("(")[0] for call in calls[name]}, name
