"""The packages that examples/ shows are those that the models make."""

import re
import shutil
import subprocess
import sys

import pytest

from scripts import accept
from support.packages import MODELS, answers
from support.repository import EXAMPLES

WHOLE = [
    f"{package}/{distro}"
    for package in (
        "all_kinds/python_model",
        "all_kinds/cpp_model",
        "contact_msgs/interfaces_model",
    )
    for distro in ("noetic", "kilted")
]
PARTS = [
    "contact_analysis/python_model/kilted",
    "contact_analysis/cpp_model/kilted",
    "driver/python_model/kilted",
    "driver/cpp_model/kilted",
    "serving/python_model/kilted",
    "serving/cpp_model/kilted",
    "driving/mixed_model/kilted",
]


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The packages that examples/ shows, whole, as `make accept` makes them."""
    folder = tmp_path_factory.mktemp("made")
    accept.render(folder)
    return folder


def names(folder):
    return {file.relative_to(folder).as_posix() for file in folder.rglob("*") if file.is_file()}


def test_examples_are_current(made, tmp_path):
    accept.show(made, tmp_path)
    lines = "\n".join(accept.differences(tmp_path))
    assert not lines, f"{lines}\nRun make accept, and review the diff."


def run(root, *options):
    command = [sys.executable, root / "scripts/accept.py", *options]
    return subprocess.run(command, cwd=root, capture_output=True, text=True)


def test_change_of_a_template_is_seen(own_collection):
    """In text, in mode, and where a file comes or goes."""
    examples = own_collection / "examples"
    shutil.copytree(EXAMPLES, examples, dirs_exist_ok=True)
    for spec in (
        "contact_analysis",
        "contact_msgs",
        "driver",
        "driving",
    ):  # two specs tell as much as six
        shutil.rmtree(examples / spec)
        (examples / f"{spec}.ros_package").unlink()
    template = own_collection / "python_model/template"
    (template / "NEW.md").write_text("A file that comes.\n")
    (template / "config/[node.name].yaml.jinja").unlink()
    stale = examples / "serving/cpp_model/noetic/CMakeLists.txt"
    stale.parent.mkdir()
    stale.write_text("Not shown any more\n")
    setup = template / "{{ ros2 }}/setup.cfg.jinja"
    setup.write_text(setup.read_text().replace("[develop]", "[developed]"))
    setup.chmod(0o755)
    before = accept.files(examples)
    result = run(own_collection, "--check")
    assert result.returncode == 1
    package = "all_kinds/python_model/kilted"
    for line in (
        f"--- examples/{package}/setup.cfg",
        "-[develop]",
        "+[developed]",
        f"+++ made anew/{package}/NEW.md",
        f"--- examples/{package}/config/worker.yaml",
        "--- examples/serving/python_model/kilted/config/clerk.yaml",
        "--- examples/serving/cpp_model/noetic/CMakeLists.txt",
        f"{package}/setup.cfg: executable before: False, after: True",
    ):
        assert f"\n{line}\n" in result.stdout
    assert accept.files(examples) == before
    assert run(own_collection).returncode == 0
    assert (examples / package / "NEW.md").exists()
    assert not stale.exists()
    assert run(own_collection, "--check").returncode == 0


def test_every_spec_has_its_packages(made):
    """One spec is whole in all variants; a part of another has only what that lacks, no tests."""
    shown = {path.relative_to(EXAMPLES).as_posix() for path in EXAMPLES.glob("*/*_model/*")}
    assert shown == {*WHOLE, *PARTS}
    assert {name.split("/")[0] for name in shown} == {
        file.stem for file in EXAMPLES.glob("*.ros_package")
    }
    links = re.findall(r"\]\(([^)]+_model/[^)]+)\)", (EXAMPLES / "README.md").read_text())
    assert sorted(links) == sorted(shown)
    for package in WHOLE:
        assert names(EXAMPLES / package) == names(made / package)
    for package in PARTS:
        spec, model, distro = package.split("/")
        languages = MODELS if model == "mixed_model" else [model]
        known = {
            name.replace("all_kinds", spec)
            for language in languages
            for name in names(EXAMPLES / "all_kinds" / language / distro)
        }
        if model == "mixed_model":
            known.remove("CMakeLists.txt")  # its own: it builds both languages
        known |= {name for name in names(made / package) if name.startswith("test/")}
        assert names(EXAMPLES / package) == names(made / package) - known


@pytest.mark.parametrize("package", [*WHOLE, *PARTS])
def test_answers_tell_nothing_of_a_machine(package, made):
    """Those of the parts are not shown, but made alike."""
    recorded = answers(made / package)
    asked = {"agents", "runtime"} if "nodes" in recorded["spec"] else set()
    assert set(recorded) == {"_src_path", "ci", "ros_distro", "spec"} | asked
    assert recorded["_src_path"] == f"gh:org/{package.split('/')[1]}"
    file = EXAMPLES / package / ".copier-answers.yml"
    assert file.exists() == (package in WHOLE)
