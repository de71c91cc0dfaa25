"""An update changes all or nothing, and nothing that git could not bring back."""

import os

import pytest
import yaml

from hooks.merge.package import Result
from hooks.merge.transaction import Guard, take
from hooks.merge.tree import File, write
from support.arm import SPEC
from support.packages import QUIET
from support.repository import commit, git

MORE = SPEC.replace('name="stop"', 'name="halt"')


def files(folder):
    """Return every file with its bytes, links as what they lead to."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if ".git" not in path.relative_to(folder).parts and not path.is_dir():
            found[path] = path.readlink() if path.is_symlink() else path.read_bytes()
    return found


@pytest.fixture
def refused(copier_command):
    """Run a command that must fail with a sentence, and change nothing."""

    def run(package, *messages, command="update", options=(), around=None):
        before = files(around or package)
        status = git(package, "status", "--short", "--ignored")
        result = copier_command(command, *QUIET, *options, cwd=package)
        assert result.returncode == 1, result
        assert "Traceback" not in result.stderr
        for message in messages:
            assert message in result.stderr, result.stderr
        assert files(around or package) == before
        assert git(package, "status", "--short", "--ignored") == status

    return run


def change_spec(package, text=MORE):
    (package / "arm.ros_package").write_text(text)
    commit(package, "Change the spec")


@pytest.mark.parametrize("command", ["update", "recopy"])
def test_ignored_files_are_not_lost(render, refused, tmp_path, command):
    """A workspace that ignores src/*: nothing of the package is in git."""
    (tmp_path / ".gitignore").write_text("src/*\nspecs\n")
    commit(tmp_path, "Ignore")
    package = render(SPEC, name="src/arm")
    (package / "arm.ros_package").write_text(MORE)
    options = ("--overwrite",) if command == "recopy" else ()
    refused(package, "not in git", "git add -f", command=command, options=options)


def test_one_ignored_file_is_not_lost(arm, refused):
    (arm / ".gitignore").write_text("halt*\narm/watch_ros.py\n")
    git(arm, "rm", "-q", "--cached", "arm/watch_ros.py")
    change_spec(arm)
    refused(arm, "arm/watch_ros.py: not in git")


def test_untracked_file_is_not_overwritten_by_recopy(arm, refused):
    git(arm, "rm", "-q", "--cached", "arm/watch_ros.py")
    git(arm, "commit", "-q", "-m", "Forget a file")
    options = ("--overwrite",)
    refused(arm, "arm/watch_ros.py: not in git", command="recopy", options=options)


def test_links_out_of_the_package_are_not_written_through(arm, refused, tmp_path):
    outside = tmp_path / "outside.py"
    impl = arm / "arm/reach_impl.py"
    outside.write_bytes(impl.read_bytes())
    impl.unlink()
    impl.symlink_to(outside)
    change_spec(arm)
    refused(arm, "arm/reach_impl.py: a link to", "put the file itself", around=tmp_path)


def test_version_with_an_undefined_name_changes_nothing(own_collection, render, refused):
    package = render(SPEC, template=own_collection, name="arm")
    readme = own_collection / "shared/README.md.jinja"
    readme.write_text(readme.read_text() + "{{ nobody_knows_this }}\n")
    (own_collection / "python_model/template/AAA.md").write_text("New.\n")
    commit(own_collection, "Break it", tag="2.0.0")
    refused(package, "'nobody_knows_this' is undefined")


def test_was_that_names_nothing_is_refused(arm, refused):
    change_spec(arm, SPEC.replace('<node name="reach"', '<node name="grasp" was="raech"'))
    refused(arm, 'arm.ros_package:3: <node name="grasp">: was="raech"', 'did you mean "reach"?')
    change_spec(arm, SPEC.replace('name="arm"', 'name="arm" was="amr"'))
    refused(arm, 'arm.ros_package:1: <package name="arm">: was="amr"', "remove was")


def test_module_with_the_new_name_is_not_overwritten(arm, refused):
    (arm / "arm/grasp_impl.py").write_text("MINE = 1\n")
    change_spec(arm, SPEC.replace('<node name="reach"', '<node name="grasp" was="reach"'))
    refused(arm, "arm/grasp_impl.py: arm/reach_impl.py is to have this name")


def test_settings_of_git_do_not_count(arm, copier_command):
    impl = arm / "arm/reach_impl.py"
    text = impl.read_text().replace("return True", "self.ready = 1   \n        return True", 1)
    impl.write_text(text)
    for key, value in {
        "apply.whitespace": "error",
        "core.whitespace": "trailing-space",
        "merge.conflictStyle": "zdiff3",
        "diff.noprefix": "true",
        "status.showUntrackedFiles": "no",
    }.items():
        git(arm, "config", key, value)
    change_spec(arm)
    result = copier_command("update", "--trust", "--defaults", cwd=arm)
    assert result.returncode == 0, result.stderr
    assert "self.ready = 1   \n" in impl.read_text()
    assert "config.gain * data.in_goal.data" in impl.read_text()
    assert "def receive_halt" in impl.read_text()


def test_bytes_stay(arm, copier_command):
    """Line ends, other encodings and modes, of files that the update merges and others."""
    impl, helper = arm / "arm/reach_impl.py", arm / "arm/helper.py"
    impl.write_bytes(impl.read_bytes().replace(b"\n", b"\r\n"))
    helper.write_bytes(b"# caf\xe9\r\nX = 1\n")
    helper.chmod(0o755)
    change_spec(arm, SPEC.replace('name="load" type', 'name="fetch" was="load" type', 1))
    assert copier_command("update", *QUIET, cwd=arm).returncode == 0
    assert helper.read_bytes() == b"# caf\xe9\r\nX = 1\n"
    assert helper.stat().st_mode & 0o111
    data = impl.read_bytes()
    assert b"def serve_fetch" in data
    assert data.count(b"\r\n") == data.count(b"\n")


def test_another_answers_file(arm, copier_command):
    (arm / ".copier-answers.yml").rename(arm / "answers.yml")
    change_spec(arm, SPEC.replace('<node name="reach"', '<node name="grasp" was="reach"'))
    command = ("update", "--trust", "--defaults", "-a", "answers.yml")
    result = copier_command(*command, cwd=arm)
    assert result.returncode == 0, result.stderr
    assert "config.gain * data.in_goal.data" in (arm / "arm/grasp_impl.py").read_text()
    answers = yaml.safe_load((arm / "answers.yml").read_text())
    assert answers["spec"]["nodes"][0]["name"] == "grasp"
    assert not (arm / ".copier-answers.yml").exists()


def test_submodule_in_the_package_stays(arm, copier_command, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (other / "reach.py").write_text("import reach\n")
    commit(other, "Another repository")
    git(arm, "-c", "protocol.file.allow=always", "submodule", "add", "-q", str(other), "reach")
    change_spec(arm, SPEC.replace('<node name="reach"', '<node name="grasp" was="reach"'))
    result = copier_command("update", *QUIET, cwd=arm)
    assert result.returncode == 0, result.stderr
    assert (arm / "reach/reach.py").read_text() == "import reach\n"
    assert "reach_impl" not in git(arm / "reach", "status", "--short")
    assert (arm / "arm/grasp_impl.py").exists()


def test_rejected_conflict_is_said(arm, copier_command):
    node = arm / "arm/reach_ros.py"
    node.write_text(node.read_text().replace("FREQUENCY = 10", "FREQUENCY = 12"))
    change_spec(arm, SPEC.replace('frequency="10"', 'frequency="20"'))
    command = ("update", "--trust", "--defaults", "--conflict", "rej")
    result = copier_command(*command, cwd=arm)
    assert "CONFLICT  arm/reach_ros.py" in result.stderr
    assert "FREQUENCY = 12" in node.read_text()
    assert "+FREQUENCY = 20" in (arm / "arm/reach_ros.py.rej").read_text()


def test_file_that_is_as_it_was_is_not_written_again(tmp_path):
    """Editors and builds look at its time."""
    paths = ["a.py", "b/c/d.py", "e.py", "f/g.py"]
    for path in paths:
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text("MINE = 1\n")
        os.utime(tmp_path / path, (1e9, 1e9))
    commit(tmp_path, "Begin")
    taken = take(tmp_path)
    taken.put(Result(dict.fromkeys(paths, File(b"MINE = 1\n"))), set(), inline=True)
    assert [(tmp_path / path).stat().st_mtime for path in paths] == [1e9] * 4
    for path in ("e.py", "f/g.py"):  # as Copier does
        (tmp_path / path).unlink()
    (tmp_path / "f").rmdir()
    taken.put(Result({"a.py": File(b"MINE = 1\n")}), set(), inline=True)
    assert {path.name for path in tmp_path.iterdir()} == {".git", "a.py"}
    assert (tmp_path / "a.py").stat().st_mtime == 1e9


def test_file_in_the_place_of_a_link_is_not_written_through_it(tmp_path):
    (tmp_path / "mine").write_text("1")
    (tmp_path / "a").symlink_to("mine")
    write(tmp_path / "a", File(b"2"))
    assert files(tmp_path) == {tmp_path / "a": b"2", tmp_path / "mine": b"1"}


@pytest.mark.parametrize(("end", "text"), [(Guard.release, "new\n"), (Guard.undo, "old\n")])
def test_update_that_has_ended_leaves_nothing_in_the_folder_of_git(tmp_path, end, text):
    (tmp_path / "a").write_text("old\n")
    commit(tmp_path, "Begin")
    before = {path.name for path in (tmp_path / ".git").iterdir()}
    guard = Guard(take(tmp_path))
    (tmp_path / "a").write_text("new\n")
    end(guard)
    assert (tmp_path / "a").read_text() == text
    assert {path.name for path in (tmp_path / ".git").iterdir()} == before


@pytest.mark.parametrize("way", ["put", "restore"])
def test_git_sees_a_file_of_the_same_size_that_is_written_in_the_same_second(tmp_path, way):
    """It compares contents where a file is not older than its index."""
    file, index = tmp_path / "config.yaml", tmp_path / ".git/index"
    git(tmp_path, "init", "-q")
    git(tmp_path, "config", "core.trustctime", "false")
    file.write_text("a: 1\n")
    moment = file.stat().st_mtime_ns - 10**10
    os.utime(file, ns=(moment, moment))
    commit(tmp_path, "Begin")
    os.utime(index, ns=(moment, moment))
    snapshot = take(tmp_path)
    if way == "put":
        snapshot.put(Result({"config.yaml": File(b"a: 2\n")}), set(), inline=True)
    else:
        snapshot.restore()
        file.write_text("a: 2\n")
    os.utime(file, ns=(moment, moment))
    assert git(tmp_path, "status", "--short") == "M config.yaml"
