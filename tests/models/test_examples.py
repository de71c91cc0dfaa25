"""The packages that examples/ shows are those that the models make."""

import re
import shutil
import subprocess
import sys

import pytest
import yaml

from support.packages import MADE_BY, MODELS
from support.repository import EXAMPLES, ROOT

PACKAGES = sorted(EXAMPLES.glob("*/*_model/*"))


def check(root):
    command = [sys.executable, root / "scripts/accept.py", "--check"]
    return subprocess.run(command, cwd=root, capture_output=True, text=True)


def test_examples_are_current():
    result = check(ROOT)
    assert result.returncode == 0, f"{result.stdout}\nRun make accept, and review the diff."


def test_change_of_a_template_is_seen(own_collection):
    """In text, in mode, and where a file comes or goes."""
    shutil.copytree(EXAMPLES, own_collection / "examples", dirs_exist_ok=True)
    template = own_collection / "python_model/template"
    (template / "NEW.md").write_text("A file that comes.\n")
    (template / "config/[node.name].yaml.jinja").unlink()
    setup = template / "{{ ros2 }}/setup.cfg.jinja"
    setup.write_text(setup.read_text().replace("[develop]", "[developed]"))
    setup.chmod(0o755)
    result = check(own_collection)
    assert result.returncode == 1
    package = "serving/python_model/kilted"
    for line in (
        f"--- examples/{package}/setup.cfg",
        "-[develop]",
        "+[developed]",
        f"+++ made anew/{package}/NEW.md",
        f"--- examples/{package}/config/clerk.yaml",
        f"{package}/setup.cfg: executable before: False, after: True",
    ):
        assert f"\n{line}\n" in result.stdout
    assert not (EXAMPLES / package / "NEW.md").exists()


def test_every_spec_has_its_packages():
    shown = {path.relative_to(EXAMPLES).as_posix() for path in PACKAGES}
    specs = [file.stem for file in EXAMPLES.glob("*.ros_package")]
    pairs = {(spec, model) for spec in specs if spec not in MADE_BY for model in MODELS}
    pairs |= set(MADE_BY.items())
    assert shown == {f"{spec}/{model}/{d}" for spec, model in pairs for d in ("noetic", "kilted")}
    links = re.findall(r"\]\(([^)]+_model/[^)]+)\)", (EXAMPLES / "README.md").read_text())
    assert sorted(links) == sorted(shown)


@pytest.mark.parametrize("package", PACKAGES, ids=lambda path: "-".join(path.parts[-3:]))
def test_answers_tell_nothing_of_a_machine(package):
    answers = yaml.safe_load((package / ".copier-answers.yml").read_text())
    assert set(answers) == {"_src_path", "ci", "ros_distro", "spec"}
    assert answers["_src_path"] == f"gh:org/{package.parent.name}"
