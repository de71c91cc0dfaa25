"""Nodes without a frequency: they have no loop, no update and no Data, whatever they serve."""

import re

import pytest

from support.fuzz import check_own_files
from support.packages import DISTROS, MODELS, files, fill_in_serving
from support.repository import EXAMPLES, commit
from support.soundness import check_imports, check_sound

SPEC = EXAMPLES / "serving.ros_package"
LOGIC = {"python_model": "serving/clerk_impl.py", "cpp_model": "src/clerk_impl.cpp"}
HOME = '    <serviceServer name="go_home" type="std_srvs::Empty"/>\n'
each_model = pytest.mark.parametrize("model", MODELS)


@pytest.mark.parametrize("distro", ["noetic", "humble", "lyrical"])
def test_rendered_code_is_sound(render, distro):
    package = render(SPEC, ros_distro=distro)
    check_sound(package)
    check_imports(package, distro)


# The same for nodes with a loop and without.
RUNTIME = ("managed_node.py", "logic_thread.py", "recorder.py", "recorder.hpp")


@each_model
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_nothing_of_a_loop_is_left(render, model, distro):
    package = render(SPEC, model=model, ros_distro=distro)
    words = r"\bupdate\(|_update\b|\w+Data\b|\bdata_?\b|FREQUENCY|[Ll]oop\b|frequency"
    for file in package.rglob("*"):
        own = {".git", ".copier-answers.yml", "serving.ros_package", *RUNTIME}
        if file.is_file() and not own & set(file.parts):
            text = file.read_text().replace("add_data", "").replace("data_files", "")
            assert not re.search(words, text), f"{file}: {re.search(words, text)}"


@each_model
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_diagnostics_need_no_loop(render, model, distro):
    spec = SPEC.read_text().replace('<node name="clerk"', '<node name="clerk" diagnostics="true"')
    package = render(spec, model=model, ros_distro=distro)
    texts = {str(file.relative_to(package)): file.read_text() for file in files(package, "*.?pp")}
    texts |= {str(file.relative_to(package)): file.read_text() for file in files(package, "*.py")}
    assert any("diagnostics" in name for name in texts)
    check_own_files(texts, "serving")


@each_model
def test_logic_is_the_same_for_all_ros(render, model):
    packages = [
        render(SPEC, model=model, ros_distro=distro, name=f"{distro}/same") for distro in DISTROS
    ]
    first, *others = [
        {file.name: file.read_bytes() for file in files(package, "*_impl.*")}
        for package in packages
    ]
    assert {name.split(".")[0] for name in first} == {
        "clerk_impl",
        "idler_impl",
        "test_clerk_impl",
        "test_idler_impl",
    }
    assert all(other == first for other in others)


@each_model
def test_new_service_is_merged(render, update, model):
    package = render(SPEC, model=model)
    fill_in_serving(package, model)
    text = (package / LOGIC[model]).read_text()
    file = package / "serving.ros_package"
    file.write_text(file.read_text().replace("    <actionServer", HOME + "    <actionServer", 1))
    commit(package)
    update(package)
    new = (package / LOGIC[model]).read_text()
    assert "serve_go_home(" in new
    assert "<<<<<<<" not in new
    assert set(text.splitlines()) <= set(new.splitlines())


@each_model
def test_frequency_comes_and_goes(render, update, model):
    """A node gets its update when it gets a frequency, and an update that was filled in stays."""
    package = render(SPEC, model=model)
    fill_in_serving(package, model)
    text = (package / LOGIC[model]).read_text()
    file = package / "serving.ros_package"
    spec = file.read_text()
    file.write_text(spec.replace('name="clerk"', 'name="clerk" frequency="5"'))
    commit(package)
    update(package)
    commit(package)
    new = (package / LOGIC[model]).read_text()
    assert "update(" in new
    assert set(text.splitlines()) <= set(new.splitlines())
    file.write_text(spec)
    commit(package)
    update(package)
    assert (package / LOGIC[model]).read_text() == text
