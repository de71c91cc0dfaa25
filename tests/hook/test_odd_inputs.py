"""What is no spec at all, or too much of one: a sentence each, soon and without a traceback."""

import codecs
import os
import subprocess
import sys

import pytest

from hooks import package
from hooks.faults import SpecError
from hooks.package import Package
from support.packages import model_of
from support.repository import EXAMPLES, ROOT, commit, git

resource = pytest.importorskip("resource", reason="Windows: no limits of processes, no FIFOs")
MODEL = model_of("python_model")
ABOUT = 'author="A" author_email="a@example.org" description="d" license="MIT"'
SPEC = f'<package name="arm" {ABOUT}>\n<node name="n" frequency="1">\n%s\n</node>\n</package>'
SECONDS = 10
BYTES = 500 * 2**20


def refusal(xml):
    with pytest.raises(SpecError) as error:
        MODEL.context(xml if isinstance(xml, bytes) else xml.encode(), "spec.xml", "kilted")
    return str(error.value)


def parameter(type_, value):
    return SPEC % f'<parameter name="p" type="{type_}" value="{value}"/>'


@pytest.mark.parametrize(
    ("xml", "message"),
    [
        ('<?xml version="1.0" encoding="foo"?>' + SPEC % "", 'spec.xml:1: encoding "foo"'),
        ('<?xml version="1.0" encoding="ISO-8859-1"?>' + SPEC % "", "save the spec as UTF-8"),
        ('<?xml version="1.0" encoding="UTF-16"?>' + SPEC % "", "save the spec as UTF-8"),
        (
            '<?xml version="1.0" encoding="ASCII"?>' + SPEC.replace('"d"', '"größe"') % "",
            'encoding "ASCII" is not read',
        ),
        (
            "<!DOCTYPE package [ %units; ]>" + parameter("double", "1&dot;5"),
            "spec.xml:1: a DOCTYPE with parts in another file is not read; drop it",
        ),
        (parameter("double", "5e-324"), '"5e-324" is too small; allowed: 0, or at least 2.2250'),
        (parameter("string[]", "[&quot;\\uFFFE&quot;]"), "U+FFFE is no character"),
        ((SPEC % "").encode("utf-16"), "not UTF-8 text"),
        ((SPEC % "").encode("utf-16-le"), "1: not UTF-8 text"),  # is UTF-8, too
        ((SPEC % "").encode("utf-16-be"), "1: not UTF-8 text"),
        ((SPEC % "").encode("utf-32-be"), "1: not UTF-8 text"),
        ((SPEC % "\n\0").encode(), "4: not well-formed XML: U+0000 is no blank and no text; drop"),
        ((SPEC % 'a="\0"').encode(), "3: not well-formed XML: U+0000 is no blank and no text"),
        ((SPEC % "<\0a/>").encode(), "3: not well-formed XML: U+0000 is no blank and no text"),
        ('<!DOCTYPE package SYSTEM "x.dtd">' + SPEC.replace('"d"', '"&foo;"') % "", "DOCTYPE"),
        (parameter("int[]", "[" * 500), 'spec.xml:3: <parameter name="p">: value: "[[['),
        (parameter("string[]", "[&quot;\\Uffffffff&quot;]"), "is not a string[]"),
        (parameter("string[]", "[&quot;\\ud800&quot;]"), "U+D800 is a control character"),
        (parameter("string", "a\u0085b"), "U+0085 is a control character"),
        (parameter("string", "a\u202eb"), "U+202E is a control character"),
        (parameter("int", "9" * 5000), "is too long"),
        (SPEC.replace('"MIT"', '""') % "", "license: must not be empty"),
        (SPEC.replace('"d"', '"a\u007fb"') % "", "U+007F is a control character"),
        (
            (SPEC % "").replace("</package>", ""),
            "spec.xml:5: not well-formed XML: <package> of line 1 is not closed",
        ),
        (
            SPEC.partition("</node>")[0] % "<!-- <a> --><b/>",
            "spec.xml:4: not well-formed XML: <node> of line 2 is not closed",
        ),
        (
            (SPEC % "").replace("</node>", ""),
            "spec.xml:5: not well-formed XML: <node> of line 2 is not closed",
        ),
        ('<package name="', "spec.xml:1: not well-formed XML: the value of name in line 1"),
        ("", "spec.xml:1: not well-formed XML: the file is empty"),
    ],
)
def test_message(xml, message):
    assert message in refusal(xml)
    assert len(refusal(xml)) < 1000


def test_control_characters_reach_no_terminal():
    text = refusal(SPEC % '<publisher name="a\u009b2Jb" type="\u202eT"/><x\u200e/>')
    assert all(line.isprintable() for line in text.split("\n"))


BIG = {
    "nested tags": "<a>" * 100_000 + "</a>" * 100_000,
    "list": parameter("int[]", f"[{'1, ' * 300_000}1]"),
    "name": SPEC.replace('"n"', f'"{"n" * 1_000_000}"') % "",
    "bad name": SPEC.replace('"n"', f'"{"n" * 1_000_000}-"') % "<a/>" * 2,
    "names": SPEC % '<publisher name="x" type="a::B"/>' * 25_000,
    "unknown tags": SPEC % ("<a/>" * 200_000),
    "attribute": SPEC % f'<publisher {"a" * 900_000}="x"/>',
    "text": SPEC % ("&lt;x" * 190_000),
    "nodes": SPEC.replace("\n", "") % "" * 5_000,
}


@pytest.mark.parametrize("name", BIG)
def test_no_input_takes_long(tmp_path, name):
    """The limits are of the operating system, on the time and the memory of a process."""
    (tmp_path / "spec.xml").write_text(BIG[name])
    code = f"""
import sys
from pathlib import Path
from hooks.faults import SpecError
from hooks.model import Model
root = Path({str(ROOT)!r})
try:
    Model(root / "cpp_model", root).context(Path("spec.xml").read_bytes(), "spec.xml", "kilted")
except SpecError as error:
    print(error)
"""

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        resource.setrlimit(resource.RLIMIT_DATA, (BYTES, BYTES))

    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    found = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=environment,
        preexec_fn=limit,
        capture_output=True,
        text=True,
    )
    assert found.returncode == 0, found.stderr[-2000:]
    assert 0 < len(found.stdout) < 20_000
    assert found.stdout.startswith("spec.xml:1: ") or "spec.xml:" in found.stdout


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda path: path.mkdir(), "not a file; spec_file must name the XML of a package"),
        (lambda path: path.symlink_to(EXAMPLES), r"did you mean .*/\w+.ros_package\?"),
        (lambda path: path.symlink_to("nowhere"), "no such file"),
        (os.mkfifo, "not a file"),
        (lambda path: None, "no such file"),
    ],
    ids=["folder", "folder of specs", "dangling link", "fifo", "nothing"],
)
def test_what_is_no_file(tmp_path, make, message):
    make(tmp_path / "arm.ros_package")
    with pytest.raises(SpecError, match=message):
        package.read(tmp_path / "arm.ros_package")


@pytest.mark.parametrize("name", ["~nosuchuser/x", "x" * 5000, "a\0b"])
def test_what_is_no_path(name):
    with pytest.raises(SpecError) as error:
        package.read(name)
    assert len(str(error.value)) < 300


@pytest.mark.parametrize("destination", ["taken", "taken/arm", "link", "link/arm"])
def test_destination_that_is_no_folder(tmp_path, destination):
    (tmp_path / "taken").touch()
    (tmp_path / "link").symlink_to("nowhere")
    with pytest.raises(SpecError, match=r"(taken|link): not a folder.* \[not-a-folder\]"):
        Package(tmp_path / destination, ".copier-answers.yml").spec_file("")


def test_lost_spec_comes_back_by_the_command_that_is_told(tmp_path, monkeypatch):
    folder = tmp_path / "ws" / "arm 1"
    folder.mkdir(parents=True)
    (folder / ".copier-answers.yml").write_text("spec: {}\n")
    (folder / "arm.ros_package").write_text("<package/>\n")
    commit(folder)
    git(folder, "rm", "-q", "arm.ros_package")
    git(folder, "commit", "-qm", "Lose it")
    git(folder, "commit", "-q", "--allow-empty", "-m", "More")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SpecError, match="has lost its spec") as error:
        Package(folder, ".copier-answers.yml").spec_file("")
    command = str(error.value).partition("; ")[2].partition(" brings it back [lost-spec]")[0]
    subprocess.run(command, shell=True, check=True)
    assert (folder / "arm.ros_package").read_text() == "<package/>\n"


def test_same_spec_with_another_mark_of_its_encoding(tmp_path):
    (tmp_path / "arm.ros_package").write_text("<package/>\n")
    other = tmp_path / "other.xml"
    other.write_bytes(codecs.BOM_UTF8 + b"<package/>\r\n")
    assert Package(tmp_path, "answers").spec_file(str(other)) == other
    other.write_bytes(b"<package />\n")
    with pytest.raises(SpecError, match="is the spec of this package"):
        Package(tmp_path, "answers").spec_file(str(other))


def test_no_git_and_no_name_of_the_user(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("getpass.getuser", lambda: {}["uid"])
    about = Package(tmp_path / "test", ".copier-answers.yml").about()
    assert about["user"] == "user"
    assert about["email"] == "user@todo.todo"
    assert about["folder"] == "test_pkg"
    MODEL.context(MODEL.skeleton(about).encode(), "skeleton spec", "kilted")


def test_unknown_distribution():
    with pytest.raises(SpecError, match='ros_distro: unknown "foxy".*noetic'):
        MODEL.context((SPEC % "").encode(), "spec.xml", "foxy")
