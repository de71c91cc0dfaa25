"""An update moves a package to a runtime that others share, and back, with every edit."""

import re

import pytest

from support.packages import LOGIC, all_kinds, answers, files
from support.repository import commit, git

MODELS = [("python_model", "kilted"), ("cpp_model", "noetic"), ("mixed_model", "kilted")]
RUNTIME = {"python_model": "all_kinds/ros/loop.py", "cpp_model": "src/ros/timing.hpp"}
NODE = {"python_model": "all_kinds/worker_ros.py", "cpp_model": "src/worker_ros.cpp"}
MINE = {"python_model": "# A line of mine.\n", "cpp_model": "// A line of mine.\n"}


def change(file, line):
    """Add a line behind the imports, or the includes, of a file."""
    text = file.read_text()
    place = re.search(r"\n\n(?=\n*(class|namespace|constexpr|FREQUENCY))", text).end()
    file.write_text(f"{text[:place]}{line}{text[place:]}")


@pytest.mark.parametrize(("model", "distro"), MODELS)
def test_there_and_back(render, copier_command, collection, model, distro):
    spec = all_kinds()
    language = model
    if model == "mixed_model":
        language = "python_model"
        spec = spec.replace('name="worker"', 'name="worker" language="python"')
        spec = spec.replace('name="observer"', 'name="observer" language="cpp"')
    package = render(spec, template=collection, model=model, ros_distro=distro)
    inside = {name: (package / name).read_text() for name in tracked(package)}
    edited = [LOGIC[language], NODE[language], RUNTIME[language]]
    for name in edited:
        change(package / name, MINE[language])
    commit(package, "Edit the logic, the node and the runtime")
    written = {name: (package / name).read_text() for name in edited}
    before = git(package, "rev-parse", "--short", "HEAD")

    def update(runtime):
        options = ("--trust", "--defaults", "-d", f"runtime={runtime}")
        result = copier_command("update", *options, cwd=package)
        assert result.returncode == 0, result.stderr
        assert "CONFLICT" not in result.stderr
        commit(package, runtime)
        return result.stderr

    said = update("node_runtime")
    shown = f"git show {before}:./{RUNTIME[language]}"
    assert f"removed   {RUNTIME[language]}      (see it again: {shown})" in said
    assert re.search(
        r"\d+ of \d+ of your lines are in their place; 1 left with what was removed", said
    )
    assert git(package, *shown.split()[1:]) == written[RUNTIME[language]].strip()
    assert not [name for name in tracked(package) if "/ros/" in name]
    assert answers(package)["runtime"] == "node_runtime"
    assert (package / LOGIC[language]).read_text() == written[LOGIC[language]]
    assert MINE[language] in (package / NODE[language]).read_text()
    assert "node_runtime" in (package / "package.xml").read_text()

    said = update("inside")
    assert f"added     {RUNTIME[language]}      (as it was: git show " in said
    for name in edited[:2]:
        assert (package / name).read_text() == written[name]
    (package / LOGIC[language]).write_text(inside[LOGIC[language]])
    (package / NODE[language]).write_text(inside[NODE[language]])
    assert {name: (package / name).read_text() for name in tracked(package)} == inside


def tracked(package):
    return sorted(str(path.relative_to(package)) for path in files(package, "*") if path.is_file())


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("package", 'runtime: "package" is this package; say inside, or name another'),
        ("My runtime", "not a package name of REP 144"),
        ("class", "class"),
    ],
)
def test_names(copier_command, collection, tmp_path, name, said):
    options = ("--trust", "--defaults", "-d", f"runtime={name}")
    result = copier_command("copy", *options, collection, tmp_path / "package", cwd=tmp_path)
    assert result.returncode != 0
    assert said in result.stderr
    assert "Traceback" not in result.stderr
    assert not (tmp_path / "package").exists()


def test_packages_of_messages_have_none(copier_command, published, tmp_path):
    for model in ("interfaces_model", "runtime_model"):
        options = ("--trust", "--defaults", "-d", "runtime=other")
        source = published / f"{model}.git"
        result = copier_command("copy", *options, source, tmp_path / "package", cwd=tmp_path)
        assert "-d runtime: no such option" in result.stderr, result.stderr
