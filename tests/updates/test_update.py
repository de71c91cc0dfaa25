"""What an update says, and what it keeps: renames, removals, conflicts."""

import contextlib
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from random import Random

import pytest

from support.arm import EDITS, SPEC
from support.laboratory.trials import second_version
from support.packages import MADE_BY, QUIET
from support.repository import EXAMPLES, commit, git


def test_summary_says_what_changed(update_with):
    said = update_with(
        ('frequency="10"', 'frequency="20"'),
        ('    <directSubscriber name="stop" type="std_msgs::Empty"/>\n', ""),
        ('  <node name="watch"', '  <node name="look" frequency="5"/>\n  <node name="watch"'),
        ('name="pose" type="std_msgs::Float64"', 'name="pose" type="std_msgs::Float32"'),
        ('"An arm"', '"A long arm"'),
    )
    for line in (
        "~ package: description An arm -> A long arm",
        "~ node reach: frequency 10 -> 20",
        "- directSubscriber stop on reach",
        "+ node look",
        "~ publisher pose on reach: type std_msgs/msg/Float64 -> std_msgs/msg/Float32",
        "merged    arm/reach_interface.py",
        "added     arm/look_impl.py",
        "removed   receive_stop from arm/reach_impl.py",
        "17 of 18 of your lines are in their place; 1 left with what was removed",
    ):
        assert line in said, said


def test_nothing_to_do_is_said(arm, copier_command):
    result = copier_command("update", "--trust", "--defaults", cwd=arm)
    assert "Nothing has changed." in result.stderr


def test_changed_answer_is_said(arm, copier_command):
    update = ("update", "--trust", "--defaults", "-d", "ros_distro=jazzy")
    result = copier_command(*update, cwd=arm)
    assert re.search(r"~ ros_distro: \w+ -> jazzy", result.stderr), result.stderr
    assert "Nothing has changed." not in result.stderr


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        ("ros_distro: foxy", 'ros_distro: unknown "foxy"; allowed: noetic, '),
        ("ci: jenkins", 'ci: unknown "jenkins"; allowed: none, github, gitlab'),
        ("model: my_model", 'model: unknown "my_model"; '),
    ],
)
def test_recorded_answer_that_is_no_choice(render, collection, copier_command, answer, message):
    """The package would become another one without a word."""
    arm = render(SPEC, template=collection, name="arm")
    file = arm / ".copier-answers.yml"
    text = file.read_text()
    name = answer.partition(":")[0]
    file.write_text(re.sub(f"^{name}: .*\n", "", text, flags=re.MULTILINE) + f"{answer}\n")
    commit(arm, "Choose")
    result = copier_command("update", "--trust", "--defaults", cwd=arm)
    assert message in result.stderr
    assert "Traceback" not in result.stderr
    assert result.returncode != 0
    assert git(arm, "status", "--short") == ""


def test_removed_logic_is_said(arm, update_with):
    before = git(arm, "rev-parse", "--short", "HEAD")
    start = SPEC.index('  <node name="reach"')
    end = SPEC.index('  <node name="watch"')
    said = update_with((SPEC[start:end], ""))
    assert "- node reach" in said
    (line,) = (line for line in said.splitlines() if "removed   arm/reach_impl.py" in line)
    command = line.partition("git show ")[2].rstrip(")")
    assert "config.gain * data.in_goal.data" in git(arm, "show", command)
    assert before != command.partition(":")[0]


def test_uses_of_what_left_are_listed(arm, update_with):
    """By where they come from, as those of a rename are; not what only looks like them."""
    helper = "import gain\n\nprint(gain.gain, gain.out_pose_limit)  # out_pose of reach\n"
    (arm / "arm/other.py").write_text(helper)
    said = update_with(
        ('    <publisher name="pose" type="std_msgs::Float64"/>\n', ""),
        ('    <dynParameter name="gain" type="double" value="1"/>\n', ""),
    )
    text = (arm / "arm/reach_impl.py").read_text().split("\n")
    number = 1 + next(i for i, line in enumerate(text) if "out_pose.data = config.gain" in line)
    assert re.findall("^still +(.*)$", said, re.MULTILINE) == [
        f"arm/reach_impl.py:{number}: {word}, which has left" for word in ("out_pose", "gain")
    ]


def test_last_line_says_whether_there_are_conflicts(arm, update_with, copier_command):
    assert update_with(('frequency="10"', 'frequency="20"')).rstrip().split("\n")[-1] == (
        "Done, without conflicts. To commit it, new files too: git add -A . && git commit"
    )
    commit(arm, "Update")
    package_xml = arm / "package.xml"
    text = package_xml.read_text()
    package_xml.write_text(text.replace("An arm", "My arm"))
    spec = arm / "arm.ros_package"
    spec.write_text(spec.read_text().replace("An arm", "The arm"))
    commit(arm, "Describe")
    for way, word in (("rej", ".rej"), ("inline", "<<<<<<<")):
        options = ("update", "--trust", "--defaults", f"--conflict={way}")
        said = copier_command(*options, cwd=arm).stderr
        assert said.rstrip().split("\n")[-1].startswith("Done, with conflicts. ")
        assert [sign in said for sign in (".rej", "<<<<<<<")] == [
            sign == word for sign in (".rej", "<<<<<<<")
        ]
        git(arm, "reset", "--hard", "--quiet")
        git(arm, "clean", "-fdq")


def test_logic_of_a_removed_interface_is_said(arm, update_with):
    said = update_with(
        ('    <serviceServer name="load" type="std_srvs::Trigger"/>\n    <s', "    <s")
    )
    assert "CONFLICT" not in said
    (line,) = (line for line in said.splitlines() if "serve_load from arm/reach_impl.py" in line)
    command = line.partition("git show ")[2].rstrip(")")
    assert "response.message = 'loaded'" in git(arm, "show", command)
    impl = (arm / "arm/reach_impl.py").read_text()
    assert "loaded" not in impl
    assert "def serve_store" in impl


def test_a_changed_generated_line_conflicts(arm, update_with):
    """Both sides give the frequency's line another text: the developer must choose."""
    node = arm / "arm/reach_ros.py"
    text = node.read_text()
    assert "FREQUENCY = 10" in text
    node.write_text(text.replace("FREQUENCY = 10", "FREQUENCY = 12"))
    commit(arm, "Tune")
    said = update_with(('frequency="10"', 'frequency="20"'))
    assert "CONFLICT  arm/reach_ros.py" in said
    assert "UU arm/reach_ros.py" in git(arm, "status", "--short")
    text = node.read_text()
    assert "FREQUENCY = 12" in text
    assert "FREQUENCY = 20" in text


@pytest.mark.parametrize("keep_was", [True, False])
def test_renamed_node_keeps_its_code(arm, update_with, copier_command, keep_was):
    said = update_with(('<node name="reach"', '<node name="grasp" was="reach"'))
    assert "> node grasp, was reach" in said
    assert "CONFLICT" not in said
    impl = (arm / "arm/grasp_impl.py").read_text()
    assert "class GraspImpl:" in impl
    assert "def update(\n        self,\n        data: GraspData,\n" in impl
    for code in (*EDITS.values(), "response.message = 'loaded'"):
        assert code in impl
    assert not (arm / "arm/reach_impl.py").exists()
    assert "GraspData" in (arm / "arm/helper.py").read_text()
    assert 'exec="grasp"' in (arm / "launch/arm.launch.xml").read_text()
    commit(arm, "Rename")
    if not keep_was:
        spec = arm / "arm.ros_package"
        spec.write_text(spec.read_text().replace(' was="reach"', ""))
        commit(arm, "Drop was")
    again = copier_command("update", *QUIET, cwd=arm)
    assert again.returncode == 0, again.stderr
    changed = git(arm, "diff", "--name-only")
    assert changed == ("" if keep_was else ".copier-answers.yml")


def test_renamed_interfaces_keep_their_code(arm, update_with):
    said = update_with(
        (
            'name="load" type="std_srvs::Trigger"/>\n    <s',
            'name="fetch" was="load" type="std_srvs::Trigger"/>\n    <s',
        ),
        ('name="goal"', 'name="target" was="goal"'),
        ('name="gain"', 'name="factor" was="gain"'),
    )
    assert "> serviceServer fetch on reach, was load" in said
    assert "CONFLICT" not in said
    impl = (arm / "arm/reach_impl.py").read_text()
    assert "data.out_pose.data = config.factor * data.in_target.data" in impl
    assert "def serve_fetch(\n        self,\n        request: FetchRequest," in impl
    assert "response.message = 'loaded'" in impl
    assert "def serve_load" not in impl
    assert "def serve_load" in (arm / "arm/watch_impl.py").read_text()


def test_reordering_needs_no_hand(arm, update_with):
    """Interfaces without a callback may be reordered, retyped and described at will."""
    pose = '    <publisher name="pose" type="std_msgs::Float64"/>\n'
    speed = '    <publisher name="speed" type="std_msgs::Int8" description="x"/>\n'
    said = update_with((pose, ""), ("    <dynParameter", speed + pose + "    <dynParameter"))
    assert "CONFLICT" not in said
    assert "self.passthrough.log.info('stop')" in (arm / "arm/reach_impl.py").read_text()


def texts(folder):
    """Return the bytes of every file of a package by its path."""
    files = (path for path in folder.rglob("*") if path.is_file())
    names = {path.relative_to(folder): path.read_bytes() for path in files}
    return {str(name): data for name, data in names.items() if ".git" not in name.parts}


def tree(package):
    """Return all that git would see of a package, and the state of its index."""
    commit(package, "Look")
    return git(package, "rev-parse", "HEAD^{tree}")


@pytest.mark.lab
def test_killed_update_can_be_undone_and_done_again(arm, copier_command, tmp_path):
    """Kill an update at random moments; git brings the package back, and the next one works."""
    spec = arm / "arm.ros_package"
    spec.write_text(
        spec.read_text().replace('<node name="watch"', '<node name="look" was="watch"')
    )
    commit(arm, "Rename a node")
    undisturbed, temporary = tmp_path / "undisturbed", tmp_path / "temporary"
    shutil.copytree(arm, undisturbed)
    temporary.mkdir()  # what is killed leaves its folders there
    environment = {"TMPDIR": str(temporary)}
    assert copier_command("update", *QUIET, cwd=arm, **environment).returncode == 0
    git(arm, "reset", "--quiet", "--hard")
    git(arm, "clean", "-fdq")
    start = time.monotonic()
    assert copier_command("update", *QUIET, cwd=undisturbed, **environment).returncode == 0
    duration = time.monotonic() - start
    wanted = tree(undisturbed)
    before = git(arm, "rev-parse", "HEAD^{tree}")
    random = Random(1)
    for _ in range(int(os.environ.get("LAB_KILLS", "6"))):
        package = tmp_path / "killed"
        shutil.copytree(arm, package)
        command = [sys.executable, "-m", "copier", "update", *QUIET]
        process = subprocess.Popen(
            command,
            cwd=package,
            env=os.environ | environment,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        time.sleep(random.uniform(0.3, 1.0) * duration)
        process.kill()
        process.wait()
        with contextlib.suppress(ProcessLookupError):  # a git it has started may still run
            while True:
                os.killpg(process.pid, 0)
                time.sleep(0.01)
        git(package, "restore", "--staged", "--worktree", ".")
        git(package, "clean", "-fdq")
        assert git(package, "status", "--short") == ""
        assert git(package, "write-tree") == before
        result = copier_command("update", *QUIET, cwd=package)
        assert result.returncode == 0, result.stderr
        assert tree(package) == wanted
        shutil.rmtree(package)


@pytest.fixture(scope="session")
def versions(collection, once):
    """A collection that has a second version."""

    def make(folder):
        shutil.copytree(collection, folder, symlinks=True, dirs_exist_ok=True)
        second_version(folder)

    return once("versions", make)


@pytest.mark.parametrize("example", sorted(EXAMPLES.glob("*.ros_package")), ids=lambda e: e.stem)
@pytest.mark.parametrize("distro", ["noetic", "kilted"])
def test_update_equals_fresh(versions, render, update, example, distro):
    """An untouched package of any version, updated, is what the newest version makes."""
    options = {"template": versions, "ros_distro": distro}
    options["model"] = MADE_BY.get(example.stem, "python_model")
    fresh = render(example, name="fresh/same", **options)
    for version in git(versions, "tag").split():
        old = render(example, vcs_ref=version, name=f"{version}/same", **options)
        update(old)
        assert texts(old) == texts(fresh), version


def test_renames_in_cpp_keep_their_code(render, copier_command):
    package = render(SPEC, model="cpp_model", name="arm")
    impl = package / "src/reach_impl.cpp"
    text = impl.read_text().replace(
        "  [[maybe_unused]] const ReachConfig & config)\n{\n}",
        "  const ReachConfig & config)\n{\n"
        "  data.out_pose.data = config.gain * data.in_goal.data;\n}",
    )
    assert "data.in_goal.data" in text
    impl.write_text(text)
    header = package / "include/arm/reach_impl.hpp"
    header.write_text(header.read_text().replace("private:\n", "private:\n  int mine_ = 0;\n"))
    spec = package / "arm.ros_package"
    text = spec.read_text().replace('<node name="reach"', '<node name="grasp" was="reach"')
    spec.write_text(text.replace('name="goal"', 'name="target" was="goal"'))
    commit(package, "Rename")
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 0, result.stderr
    assert "CONFLICT" not in result.stderr
    assert not impl.exists()
    code = (package / "src/grasp_impl.cpp").read_text()
    assert "void GraspImpl::update(\n" in code
    assert "data.out_pose.data = config.gain * data.in_target.data;" in code
    header = (package / "include/arm/grasp_impl.hpp").read_text()
    assert "int mine_ = 0;" in header
    assert "#ifndef ARM__GRASP_IMPL_HPP_" in header


def test_files_that_a_version_calls_otherwise_keep_edits(own_collection, render, copier_command):
    package = render(SPEC, template=own_collection, name="arm")
    worker = package / "arm/ros/worker.py"
    worker.write_text(worker.read_text().replace("import", "# My own line.\nimport", 1))
    commit(package, "Edit a helper")
    model = own_collection / "python_model"
    folder = model / "template/{{ spec.name }}/ros"
    (folder / "worker.py.jinja").rename(folder / "jobs.py.jinja")
    (model / "moved_files.yaml").write_text('"{package}/ros/jobs.py": "{package}/ros/worker.py"\n')
    commit(own_collection, "Call the workers jobs", tag="2.0.0")
    (package / "arm/ros/jobs.py").write_text("MINE = 1\n")
    commit(package, "Write a file whose name the model takes")
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 1
    assert "arm/ros/jobs.py: arm/ros/worker.py is to have this name" in result.stderr
    (package / "arm/ros/jobs.py").unlink()
    commit(package, "Give it another one")
    result = copier_command("update", "--trust", "--defaults", cwd=package)
    assert result.returncode == 0, result.stderr
    assert "moved     arm/ros/worker.py -> arm/ros/jobs.py" in result.stderr
    assert "# My own line.\n" in (package / "arm/ros/jobs.py").read_text()
    assert not worker.exists()


def test_node_that_comes_again_names_the_commit_with_its_code(arm, update_with):
    start, end = SPEC.index('  <node name="reach"'), SPEC.index('  <node name="watch"')
    update_with((SPEC[start:end], ""))
    commit(arm, "Remove a node")
    said = update_with(("</package>", SPEC[start:end] + "</package>"))
    (line,) = (line for line in said.splitlines() if "added     arm/reach_impl.py" in line)
    command = line.partition("git show ")[2].rstrip(")")
    assert "config.gain * data.in_goal.data" in git(arm, "show", command)


def test_callback_that_comes_again_names_the_commit_with_its_code(arm, update_with):
    load = '    <serviceServer name="load" type="std_srvs::Trigger"/>\n    <s'
    update_with(
        (load, "    <s"), ('    <directSubscriber name="stop" type="std_msgs::Empty"/>\n', "")
    )
    commit(arm, "Remove callbacks")
    said = update_with(('    <serviceServer name="store"', load + 'erviceServer name="store"'))
    (line,) = (line for line in said.splitlines() if "serve_load" in line)
    assert line.startswith("added     serve_load to arm/reach_impl.py      (as it was: git show ")
    command = line.partition("git show ")[2].rstrip(")")
    assert "response.message = 'loaded'" in git(arm, "show", command)
    assert "as it was" not in said.replace(line, "")


def test_missing_generated_parts_are_named(arm, copier_command):
    (arm / "arm/watch_ros.py").unlink()
    impl = arm / "arm/watch_impl.py"
    text = impl.read_text()
    impl.write_text(text[: text.index("    def deactivate")].rstrip() + "\n")
    commit(arm, "Delete generated code")
    said = copier_command("update", "--trust", "--defaults", cwd=arm).stderr
    assert "missing   arm/watch_ros.py\n" in said
    assert "missing   arm/watch_impl.py: cleanup" in said
    assert not (arm / "arm/watch_ros.py").exists()


def test_formatted_files_do_not_conflict(arm, update_with):
    tool = Path(sys.executable).parent / "ruff"
    subprocess.run([tool, "format", "--isolated", "--quiet", arm], check=True)
    commit(arm, "Run a formatter")
    assert git(arm, "diff", "--stat", "HEAD~1")
    said = update_with(('frequency="10"', 'frequency="20"'), ('name="stop"', 'name="halt"'))
    assert "CONFLICT" not in said


def test_method_written_before_the_update_is_there_once(arm, update_with):
    impl = arm / "arm/reach_impl.py"
    method = "    def serve_estop(self, request, response):\n        return 'stopped'\n\n"
    impl.write_text(impl.read_text().replace("    def deactivate", f"{method}    def deactivate"))
    server = '    <serviceServer name="estop" type="std_srvs::Trigger"/>\n'
    said = update_with(("    <dynParameter", f"{server}    <dynParameter"))
    assert "CONFLICT" not in said
    text = impl.read_text()
    assert text.count("def serve_estop") == 1
    assert "return 'stopped'" in text


def _file_for_folder(arm):
    for file in (arm / "config").iterdir():
        file.unlink()
    (arm / "config").rmdir()
    (arm / "config").write_text("mine\n")
    return "config: a file"


def _folder_for_file(arm):
    (arm / "config/reach.yaml").unlink()
    (arm / "config/reach.yaml").mkdir()
    (arm / "config/reach.yaml/mine.yaml").write_text("mine: 1\n")
    return "config/reach.yaml: a folder"


def _other_encoding(arm):
    Path(os.fsdecode(bytes(arm) + b"/caf\xe9.txt")).write_text("mine\n")
    return "caf\\xe9.txt: a name"


def _large(arm):
    with (arm / "arm/reach_impl.py").open("a") as file:
        file.write("# a table\n" * 500_001)
    return "arm/reach_impl.py: larger than 5 MB"


@pytest.mark.parametrize(
    "situation", [_file_for_folder, _folder_for_file, _other_encoding, _large]
)
def test_package_without_place_for_a_generated_file_is_refused(arm, copier_command, situation):
    message = situation(arm)
    spec = arm / "arm.ros_package"
    spec.write_text(spec.read_text().replace("An arm", "A long arm"))
    commit(arm, "Change it")
    result = copier_command("update", "--trust", "--defaults", cwd=arm)
    assert result.returncode != 0
    assert message in result.stderr
    assert "Traceback" not in result.stderr
    assert git(arm, "status", "--short") == ""
