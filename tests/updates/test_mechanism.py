"""From a spec to the answers and back: copy, recopy, update, and every way they can fail."""

import os
import re
import shlex
import subprocess
import sys

import pytest

from support.packages import HOSTILE, QUIET, answers
from support.repository import EXAMPLES, commit, git

SPEC = """<?xml version="1.0" encoding="UTF-8"?>
<package name="robot" author="Ada" author_email="ada@example.org" description="A robot"
         license="MIT">
  <node name="driver" frequency="10">
    <publisher name="speed" type="std_msgs::Float64"/>
  </node>
</package>
"""
MORE = SPEC.replace(
    "  </node>", '    <subscriber name="goal" type="std_msgs::Float64"/>\n  </node>'
)
BAD = MORE.replace("subscriber", "subscribr")


@pytest.fixture
def package(render):
    return render(SPEC, name="robot")


def write(package, text, message="Change the spec"):
    (package / "robot.ros_package").write_text(text)
    commit(package, message)


def has_goal(package):
    return "self.in_goal" in (package / "robot/driver_interface.py").read_text()


def test_copy_records_the_context(package, tmp_path):
    recorded = answers(package)
    assert recorded["spec"]["nodes"][0]["publishers"][0]["type"] == "std_msgs/msg/Float64"
    assert recorded["ros_distro"] == "kilted"
    assert "spec_file" not in recorded
    assert str(tmp_path / "specs") not in (package / ".copier-answers.yml").read_text()


@pytest.mark.parametrize(
    "text", [SPEC, SPEC.replace("\n", "\r\n"), "\ufeff" + SPEC, SPEC + "\n\n"]
)
def test_copy_keeps_the_text_of_the_spec(collection, copier_command, tmp_path, text):
    (tmp_path / "spec.xml").write_bytes(text.encode())
    data = ("-d", "model=python_model", "-d", "spec_file=spec.xml")
    result = copier_command("copy", *QUIET, *data, collection, "out", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "out/robot.ros_package").read_bytes() == text.lstrip("\ufeff").encode()


def test_copy_without_spec_starts_from_an_example(collection, copier_command, tmp_path):
    data = ("-d", "model=python_model")
    result = copier_command("copy", *QUIET, *data, collection, "My-Robot 2", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    package = tmp_path / "My-Robot 2"
    spec = (package / "my_robot_2.ros_package").read_text()
    assert 'author="Test Er"' in spec
    assert 'author_email="test@example.org"' in spec
    assert answers(package)["spec"]["nodes"][0]["name"] == "example"
    assert (package / "my_robot_2/example_impl.py").exists()
    commit(package)
    assert copier_command("update", *QUIET, cwd=package).returncode == 0
    assert git(package, "status", "--short") == ""


@pytest.mark.parametrize(
    ("folder", "name"),
    [
        ("2nd", "pkg_2nd"),
        ("class", "class_pkg"),
        ("日本", "pkg"),
        ("x", "x_pkg"),
        ("con", "con_pkg"),
        ("r" * 120, "r" * 100),
    ],
)
def test_folder_names_become_package_names(collection, copier_command, tmp_path, folder, name):
    data = ("-d", "model=python_model")
    result = copier_command("copy", *QUIET, *data, collection, folder, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert answers(tmp_path / folder)["spec"]["name"] == name


def test_copy_uses_a_spec_that_is_there(collection, copier_command, tmp_path):
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/robot.ros_package").write_text(SPEC)
    data = ("-d", "model=python_model")
    result = copier_command("copy", *QUIET, *data, collection, "robot", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "robot/robot/driver_impl.py").exists()


def test_ros_distro_of_the_environment(collection, copier_command, tmp_path):
    data = ("-d", "model=python_model")
    for given, meant in (("jazzy", "jazzy"), ("noetic", "noetic"), ("dapper", "lyrical")):
        arguments = ("copy", *QUIET, *data, collection, given)
        result = copier_command(*arguments, cwd=tmp_path, ROS_DISTRO=given)
        assert result.returncode == 0, result.stderr
        assert answers(tmp_path / given)["ros_distro"] == meant


@pytest.mark.parametrize("options", [(), ("--vcs-ref=:current:",)])
@pytest.mark.parametrize("place", ["inside", "outside"])
def test_update_merges_a_changed_spec(package, copier_command, tmp_path, options, place):
    impl = package / "robot/driver_impl.py"
    impl.write_text(
        impl.read_text().replace("return True", "self.ready = True\n        return True")
    )
    write(package, MORE)
    where = {"cwd": package} if place == "inside" else {"cwd": tmp_path}
    target = () if place == "inside" else (package,)
    result = copier_command("update", *QUIET, *options, *target, **where)
    assert result.returncode == 0, result.stderr
    assert has_goal(package)
    assert "self.ready = True" in impl.read_text()
    assert (package / "robot.ros_package").read_text() == MORE
    assert [s["name"] for s in answers(package)["spec"]["nodes"][0]["subscribers"]] == ["goal"]


def test_update_asks_nothing_without_a_terminal(package, copier_command):
    write(package, MORE)
    result = copier_command("update", "--trust", cwd=package)
    assert result.returncode == 0, result.stderr
    assert has_goal(package)


def test_update_with_nothing_to_do_changes_nothing(package, copier_command):
    result = copier_command("update", *QUIET, cwd=package)
    assert result.returncode == 0, result.stderr
    assert git(package, "status", "--short") == ""


@pytest.mark.parametrize("model", ["python_model", "cpp_model"])
def test_hostile_text_survives_the_answers(render, copier_command, model):
    """Quotes, braces, newlines, huge numbers: recorded, read again, and found unchanged."""
    package = render(HOSTILE, model=model, name="hostile")
    result = copier_command("update", *QUIET, cwd=package)
    assert result.returncode == 0, result.stderr
    assert git(package, "status", "--short") == ""


def test_update_in_a_subfolder_of_a_repository(collection, copier_command, tmp_path):
    workspace = tmp_path / "workspace"
    (workspace / "src").mkdir(parents=True)
    (tmp_path / "spec.xml").write_text(SPEC)
    (workspace / "notes.txt").write_text("mine\n")
    commit(workspace)
    data = ("-d", "model=python_model", "-d", "spec_file=../spec.xml")
    result = copier_command("copy", *QUIET, *data, collection, "src/robot", cwd=workspace)
    assert result.returncode == 0, result.stderr
    commit(workspace, "Add the package")
    (workspace / "src/robot/robot.ros_package").write_text(MORE)
    commit(workspace, "Change the spec")
    result = copier_command("update", *QUIET, "src/robot", cwd=workspace)
    assert result.returncode == 0, result.stderr
    assert has_goal(workspace / "src/robot")
    assert (workspace / "notes.txt").read_text() == "mine\n"


def test_recopy_uses_the_changed_spec(package, copier_command):
    write(package, MORE)
    result = copier_command("recopy", *QUIET, "--overwrite", cwd=package)
    assert result.returncode == 0, result.stderr
    assert has_goal(package)
    assert (package / "robot.ros_package").read_text() == MORE


def test_change_of_ros(package, copier_command):
    result = copier_command("update", *QUIET, "-d", "ros_distro=noetic", cwd=package)
    assert result.returncode == 0, result.stderr
    assert (package / "CMakeLists.txt").exists()
    assert not (package / "setup.cfg").exists()
    assert answers(package)["spec"]["ros"] == 1


def test_each_version_has_its_own_hook(own_collection, render, update):
    """Version 2 completes the context in another way, which version 1 could not render."""
    package = render(SPEC, template=own_collection, name="robot")
    assert answers(package)["_commit"] == "1.0.0"
    complete = own_collection / "hooks/complete.py"
    complete.write_text(
        complete.read_text().replace(
            '"ros": generation,', '"ros": generation, "new_key": "hello",'
        )
    )
    readme = own_collection / "shared/README.md.jinja"
    readme.write_text(readme.read_text().replace("## Use\n", "## {{ spec.new_key }}\n"))
    template = own_collection / "python_model/functions.py"
    template.write_text(template.read_text() + "\n\ndef shout(text):\n    return text.upper()\n")
    added = own_collection / "python_model/template/LOUD.md.jinja"
    added.write_text("{{ 'loud' | shout }}\n")
    commit(own_collection, "Second version", tag="2.0.0")
    text = (package / "README.md").read_text()
    (package / "README.md").write_text(text + "\nMy own words.\n")
    write(package, MORE)
    update(package)
    readme = (package / "README.md").read_text()
    assert "## hello\n" in readme
    assert "My own words." in readme
    assert "<<<<<<<" not in readme
    assert (package / "LOUD.md").read_text() == "LOUD\n"
    assert answers(package)["spec"]["new_key"] == "hello"
    assert has_goal(package)


def fails(result, *messages):
    """Check that a command failed with messages, and without a traceback."""
    assert result.returncode == 1, result
    assert "Traceback" not in result.stderr
    for message in messages:
        assert message in result.stderr, result.stderr


def test_bad_spec_on_copy_writes_nothing(collection, copier_command, tmp_path):
    (tmp_path / "bad.xml").write_text(BAD)
    data = ("-d", "model=python_model", "-d", "spec_file=bad.xml")
    result = copier_command("copy", *QUIET, *data, collection, "robot", cwd=tmp_path)
    fails(result, 'bad.xml:6: <subscribr name="goal">', 'did you mean "subscriber"?')
    assert not (tmp_path / "robot").exists()


@pytest.mark.parametrize("command", ["update", "recopy"])
def test_bad_spec_on_update_changes_nothing(package, copier_command, command):
    write(package, BAD)
    fails(copier_command(command, *QUIET, cwd=package), "robot.ros_package:6: <subscribr")
    assert git(package, "status", "--short") == ""


def test_template_that_is_no_model(collection, copier_command, tmp_path):
    data = ("-d", "model=starter_model")
    fails(
        copier_command("copy", *QUIET, *data, collection, "new", cwd=tmp_path),
        "starter_model is a template by itself; copy it from its own address",
    )
    assert not (tmp_path / "new").exists()


def test_faults_around_the_spec_file(collection, package, copier_command, tmp_path):
    data = ("-d", "model=python_model", "-d")
    copy = ("copy", *QUIET, *data)
    fails(
        copier_command(*copy, "spec_file=none.xml", collection, "new", cwd=tmp_path),
        "none.xml: no such file",
    )
    address = "https://example.org/robot.xml"
    fails(
        copier_command(*copy, f"spec_file={address}", collection, "new", cwd=tmp_path),
        f"{address}: an address is not read; download the file",
    )
    (tmp_path / "parameters.yaml").write_text("/**: {ros__parameters: {gain: 1}}")
    fails(
        copier_command(*copy, "spec_file=parameters.yaml", collection, "new", cwd=tmp_path),
        "parameters.yaml:1: it has no nodl_version; a spec is XML, or NoDL of version 2",
    )
    (tmp_path / "latin.xml").write_bytes(SPEC.replace("Ada", "Zoë").encode("latin-1"))
    fails(
        copier_command(*copy, "spec_file=latin.xml", collection, "new", cwd=tmp_path),
        "latin.xml:1: not UTF-8 text",
    )
    (tmp_path / "more.xml").write_text(MORE)
    fails(
        copier_command("update", *QUIET, "-d", "spec_file=../more.xml", cwd=package),
        "robot.ros_package is the spec of this package",
    )
    (package / "robot.ros_package").rename(package / "other.ros_package")
    commit(package)
    fails(copier_command("update", *QUIET, cwd=package), "robot.ros_package; rename the file")
    (package / "robot.ros_package").write_text(SPEC)
    commit(package)
    fails(copier_command("update", *QUIET, cwd=package), "other.ros_package, robot.ros_package")
    for file in package.glob("*.ros_package"):
        file.unlink()
    commit(package)
    fails(copier_command("update", *QUIET, cwd=package), "lost its spec", "checkout")
    assert git(package, "status", "--short") == ""
    assert not (tmp_path / "new").exists()


def test_template_must_be_trusted(collection, copier_command, tmp_path):
    result = copier_command("copy", "--defaults", collection, "robot", cwd=tmp_path)
    assert result.returncode == 4
    assert not (tmp_path / "robot").exists()
    config = tmp_path / "config/copier"
    config.mkdir(parents=True)
    (config / "settings.yml").write_text(f"trust:\n  - {collection.parent}/\n")
    arguments = ("copy", "--defaults", "--quiet", collection, "robot")
    environment = {"XDG_CONFIG_HOME": str(tmp_path / "config")}
    result = copier_command(*arguments, cwd=tmp_path, **environment)
    assert result.returncode == 0, result.stderr


def test_notes_are_shown(collection, copier_command, tmp_path):
    """The paper's example depends on packages that ROS 2 has no use for."""
    spec = EXAMPLES / "contact_analysis.ros_package"
    data = ("-d", "model=python_model", "-d", f"spec_file={spec}")
    result = copier_command(
        "copy", "--trust", "--defaults", *data, collection, "out", cwd=tmp_path
    )
    note = "<depend>actionlib</depend> has no meaning in ROS 2: it was left out"
    assert f"Note: {note} [dependency-of-other-ros]\n" in result.stderr
    assert re.search(r"contact_analysis is ready for ROS 2", result.stderr)


def test_unknown_distribution(collection, copier_command, tmp_path):
    distro = ("-d", "ros_distro=foxy")
    result = copier_command("copy", *QUIET, *distro, collection, "new", cwd=tmp_path)
    fails(result, 'ros_distro: unknown "foxy"; allowed: noetic, ')
    assert not (tmp_path / "new").exists()


def test_unknown_ci(collection, copier_command, tmp_path):
    result = copier_command("copy", *QUIET, "-d", "ci=jenkins", collection, "new", cwd=tmp_path)
    fails(result, 'ci: unknown "jenkins"; allowed: none, github, gitlab')
    assert not (tmp_path / "new").exists()


def test_unknown_model(collection, copier_command, tmp_path):
    for given in ("pyton_model", "../python_model", "shared"):
        data = ("-d", f"model={given}")
        result = copier_command("copy", *QUIET, *data, collection, "new", cwd=tmp_path)
        known = "cpp_model, interfaces_model, mixed_model, python_model, runtime_model"
        fails(result, f'model: unknown "{given}"; ', f"allowed: {known} [unknown-choice]\n")
        assert ('did you mean "python_model"?' in result.stderr) == (given != "shared")
        assert not (tmp_path / "new").exists()


def test_unknown_option(collection, package, copier_command, tmp_path):
    data = ("-d", "spec_fil=arm.xml", "-d", "ros_distr=noetic")
    result = copier_command("copy", *QUIET, *data, collection, "new", cwd=tmp_path)
    options = "allowed: model, spec_file, ros_distro, ci, agents, runtime [unknown-option]\n"
    fails(result, f'-d spec_fil: no such option; did you mean "spec_file"? {options}')
    fails(result, f'-d ros_distr: no such option; did you mean "ros_distro"? {options}')
    for given in ("spec=arm.xml", 'spec={"name": "arm"}', "ros1=there"):  # computed, not asked
        result = copier_command("copy", *QUIET, "-d", given, collection, "new", cwd=tmp_path)
        fails(result, f"-d {given.partition('=')[0]}: no such option; ", options)
    assert not (tmp_path / "new").exists()
    result = copier_command("update", *QUIET, "-d", "ros_distr=noetic", cwd=package)
    options = "allowed: spec_file, ros_distro, ci, agents, runtime [unknown-option]\n"
    fails(result, f'-d ros_distr: no such option; did you mean "ros_distro"? {options}')
    assert git(package, "status", "--short") == ""


@pytest.mark.parametrize("version", ["9.20.0", "10.0.1", "9.19.7", "9.20.0.dev3+g1234"])
@pytest.mark.parametrize("command", ["copy", "update"])
def test_copier_that_is_newer_than_those_tested(collection, package, tmp_path, version, command):
    """It may work another way: nothing is written. What mends the newest is taken."""
    new = [collection, tmp_path / "new"] if command == "copy" else [package]
    code = f"import copier, runpy; copier.__version__ = {version!r}; runpy.run_module('copier')"
    code = code.replace("'copier')", "'copier', run_name='__main__')")

    def run(**environment):
        return subprocess.run(
            [sys.executable, "-c", code, command, *QUIET, *new],
            env=os.environ | environment,
            capture_output=True,
            text=True,
        )

    result = run()
    if version == "9.19.7":
        assert result.returncode == 0, result.stderr
        return
    fails(result, f"Copier {version} is newer than 9.19, ", '"copier==9.19.*"', "[newer-copier]\n")
    assert not (tmp_path / "new").exists()
    assert git(package, "status", "--short") == ""
    if version == "9.20.0":
        assert run(UNTESTED_COPIER="1").returncode == 0


def test_option_that_a_version_has_of_its_own(own_collection, render, copier_command):
    """What is remembered of a question that is asked no more is no option of the user's."""
    package = render(SPEC, template=own_collection, name="robot")
    questions = own_collection / "copier.yml"
    text = questions.read_text()
    questions.write_text("colour:\n  type: str\n  default: red\n---\n" + text)
    commit(own_collection, "Ask for a colour", tag="2.0.0")
    update = ("update", *QUIET)
    result = copier_command(*update, "-d", "colour=blue", cwd=package)
    assert result.returncode == 0, result.stderr
    assert answers(package)["colour"] == "blue"
    commit(package, "Update")
    questions.write_text(text)
    commit(own_collection, "Ask for none", tag="3.0.0")
    fails(copier_command(*update, "-d", "colour=red", cwd=package), "-d colour: no such option")
    assert copier_command(*update, cwd=package).returncode == 0
    assert "colour" not in answers(package)


def test_copy_with_closed_input(collection, tmp_path):
    command = [sys.executable, "-m", "copier", "copy", *QUIET, str(collection), "robot"]
    quoted = " ".join(map(shlex.quote, command))
    found = subprocess.run(f"{quoted} <&-", shell=True, cwd=tmp_path, capture_output=True)
    assert found.returncode == 0, found.stderr
    assert (tmp_path / "robot/robot.ros_package").exists()
