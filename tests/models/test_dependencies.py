"""What the code and the tests of a package import is in the package or in its package.xml."""

import re
import xml.etree.ElementTree as ET

import pytest

from support.fuzz import check_own_files
from support.linters import write
from support.model_checks import Model
from support.packages import MODELS, SPECS
from support.repository import ROOT
from support.soundness import check_imports

MADE = {name: Model(ROOT / name) for name in MODELS}
OTHERWISE = {"launch_ros", "launch_xml", "tf2_ros_py"}
"""What reads launch files, and has a module of another name."""
KINDS = [
    (name, owner, distro)
    for name, model in MADE.items()
    for owner in model.owners
    for distro in ("noetic", "kilted")
    if owner.kind
    # Python has no types of its own package in ROS 2.
    if owner.component == "node" or (name, distro) != ("python_model", "kilted")
]
each_ros = pytest.mark.parametrize("distro", ["noetic", "kilted"])


@each_ros
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("name", SPECS)
def test_of_examples(render, name, model, distro):
    check_imports(render(SPECS[name], model=model, ros_distro=distro), distro)


@pytest.mark.parametrize(("model", "owner", "distro"), KINDS, ids=str)
def test_of_each_kind_alone(renderers, tmp_path, model, owner, distro):
    spec = MADE[model].spec([(owner, MADE[model].base(owner))])
    check_parts(renderers, tmp_path, spec, model, distro)


@each_ros
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("attribute", ['frequency="10"', 'diagnostics="true"'])
def test_of_a_node_without_interfaces(renderers, tmp_path, model, attribute, distro):
    spec = f"""<package name="bare" author="A" author_email="a@b.org" license="MIT"
      description="Bare"><node name="idler" {attribute}/></package>"""
    check_parts(renderers, tmp_path, spec, model, distro)


def check_needed(texts):
    """What the package itself depends on, and not its tests alone, is named outside of those."""
    kinds = ("depend", "build_depend", "exec_depend")
    wanted = {e.text for e in ET.fromstring(texts["package.xml"]) if e.tag in kinds}
    used = "".join(
        text
        for path, text in texts.items()
        if path.endswith((".cfg", ".cpp", ".hpp", ".launch", ".py", ".xml"))
        and not path.startswith(("test/", "package.xml"))
    )
    cmake = texts.get("CMakeLists.txt", "")
    if made := re.search(r"\bgenerate_messages\(.*?\)", cmake, re.DOTALL):
        used += f" message_generation message_runtime {made[0]}"
    if made := re.search(r"rosidl_generate_interfaces\(.*?\)", cmake, re.DOTALL):
        used += " rosidl_default_runtime " + made[0].replace("action/", "action_msgs ")
    assert {name for name in wanted - OTHERWISE if not re.search(rf"\b{name}\b", used)} == set()


def check_parts(renderers, folder, spec, model, distro):
    texts = renderers[model].render(MADE[model].context(spec, distro), distro)
    write(folder, texts)
    check_imports(folder, distro)
    check_needed(texts)
    code = {path: text for path, text in texts.items() if path.endswith((".cpp", ".hpp", ".py"))}
    check_own_files(code, ET.fromstring(texts["package.xml"]).findtext("name"))
