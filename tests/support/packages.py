"""Packages of the examples: their specs, where the logic of each model is, how to fill it in."""

import functools
import re
import shutil

import yaml

from hooks import ros
from hooks.model import Model
from support.repository import EXAMPLES, ROOT, commit, git
from support.ros import TF

DATA = ROOT / "tests/data"
DISTROS = tuple(ros.DISTROS)
HOSTILE = DATA / "hostile.ros_package"
RUNTIME = DATA / "node_runtime.ros_package"
SPECS = {
    "paper": EXAMPLES / "contact_analysis.ros_package",
    "all kinds": EXAMPLES / "all_kinds.ros_package",
    "hostile": HOSTILE,
    "starter": None,
}
QUIET = ("--trust", "--defaults", "--quiet")
MODELS = ["python_model", "cpp_model"]
# The examples that are for one model alone.
MADE_BY = {"contact_msgs": "interfaces_model", "driving": "mixed_model"}
LOGIC = {"python_model": "all_kinds/worker_impl.py", "cpp_model": "src/worker_impl.cpp"}
VOLUME = '    <subscriber name="volume" type="std_msgs::Float64" description="How loud"/>\n'


@functools.cache
def model_of(name):
    """Return a model of the collection, whose dictionary is read once."""
    return Model(ROOT / name, ROOT)


def fill_in(package, model):
    """Write the logic of data/logic into a package of examples/all_kinds; return its text.

    In C++ without what asks for transforms, if the spec is without them.
    """
    git(package, "apply", str(DATA / f"logic/{model}.patch"))
    logic = package / LOGIC[model]
    if model == "cpp_model" and "<listener" not in (package / "all_kinds.ros_package").read_text():
        logic.write_text(
            re.sub(r"  \w+\.broadcaster_pose.*?\n  }\n", "", logic.read_text(), flags=re.S)
        )
    commit(package, "Fill in the logic")
    return logic.read_text()


def fill_in_serving(package, model):
    """Write the logic of the clerk, and give its parameters other values than the spec."""
    git(package, "apply", str(DATA / f"logic/serving_{model}.patch"))
    config = package / "config/clerk.yaml"
    config.write_text(config.read_text().replace('"hello"', '"good day"').replace("0.5", "0.05"))
    commit(package, "Fill in the logic")


def fill_in_contacts(package, model):
    """Put the logic of examples/logic in the place of the empty one of contact_analysis.

    Decision 20: it lies beside the packages shown, which stay what the models make.
    """
    written = {file.name: file for file in (EXAMPLES / "logic").iterdir()}
    found = files(package, "contact_evaluate_impl.*")
    empty = [f for f in found if f.name in written and "recorder" not in f.parts]
    assert len(empty) == {"python_model": 1, "cpp_model": 2}[model]
    for file in empty:
        shutil.copy(written[file.name], file)


def add_volume(package):
    """Add a subscriber to the spec of a package."""
    file = package / "all_kinds.ros_package"
    text = file.read_text()
    file.write_text(text.replace("    <directPublisher", f"{VOLUME}    <directPublisher", 1))
    commit(package, "Add a topic")


def use_volume(package, model):
    """Use the new topic in the logic, where the logic could not be written before it."""
    patch = DATA / f"logic/{model}_volume.patch"
    if patch.exists():
        git(package, "apply", str(patch))


def all_kinds():
    """Return the spec with every interface kind."""
    return (EXAMPLES / "all_kinds.ros_package").read_text()


def without_tf(text):
    return re.sub(TF, "", text)


def changed(text, *changes):
    """Exchange a text for another, once for each pair."""
    for old, new in changes:
        assert old in text, f"no {old} in:\n{text}"
        text = text.replace(old, new, 1)
    return text


def answers(package):
    return yaml.safe_load((package / ".copier-answers.yml").read_text())


def files(package, pattern):
    return [path for path in package.rglob(pattern) if ".git" not in path.parts]


def shared_runtime(make, model, workspace, distro, *specs):
    """Put a runtime into a workspace, and packages of specs that share it.

    In ROS 1 it is for both languages; a ROS 2 may lack what C++ needs.
    """
    language = "both" if distro == "noetic" else model.removesuffix("_model")
    spec = workspace / RUNTIME.name
    spec.write_text(RUNTIME.read_text().replace("/>", f' language="{language}"/>'))
    make(workspace / "src" / spec.stem, spec, model="runtime_model", ros_distro=distro)
    for spec in specs:
        data = {"model": model, "ros_distro": distro, "runtime": RUNTIME.stem}
        make(workspace / "src" / spec.stem, spec, **data)
