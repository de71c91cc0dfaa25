"""What the code and the tests of a package import is in the package or in its package.xml."""

import xml.etree.ElementTree as ET

import pytest

from support import model_checks
from support.fuzz import check_own_files
from support.packages import MODELS, SPECS, files
from support.repository import ROOT
from support.soundness import check_imports

KINDS = [
    (model.name, owner)
    for model in model_checks.models()
    if model.name in MODELS
    for owner in model.owners
    if owner.kind
]
each_ros = pytest.mark.parametrize("distro", ["noetic", "kilted"])


@each_ros
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("name", SPECS)
def test_of_examples(render, name, model, distro):
    check_imports(render(SPECS[name], model=model, ros_distro=distro), distro)


@each_ros
@pytest.mark.parametrize(("model", "owner"), KINDS, ids=str)
def test_of_each_kind_alone(render, model, owner, distro):
    checked = model_checks.Model(ROOT / model)
    spec = checked.spec([(owner, checked.base(owner))])
    check_parts(render(spec, model=model, ros_distro=distro), distro)


@each_ros
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("attribute", ['frequency="10"', 'diagnostics="true"'])
def test_of_a_node_without_interfaces(render, model, attribute, distro):
    spec = f"""<package name="bare" author="A" author_email="a@b.org" license="MIT"
      description="Bare"><node name="idler" {attribute}/></package>"""
    check_parts(render(spec, model=model, ros_distro=distro), distro)


def check_parts(package, distro):
    check_imports(package, distro)
    code = files(package, "*.[hc]pp") + files(package, "*.py")
    texts = {str(file.relative_to(package)): file.read_text() for file in code}
    check_own_files(texts, ET.parse(package / "package.xml").findtext("name"))
