"""What an update says, line by line."""

import pytest

from hooks.git import git as run_git
from hooks.merge.package import Result
from hooks.merge.proof import Proof
from hooks.merge.report import left_behind, report
from hooks.merge.tree import File, read_folder
from support.repository import commit, git

LOAD = "def load():\n    return {}\n"


@pytest.fixture
def package(tmp_path):
    (tmp_path / "arm.py").write_text(LOAD.format(1) + "\n\ndef store():\n    return 1\n")
    (tmp_path / "other.py").write_text("a = 1\n")
    commit(tmp_path)
    return tmp_path


def said(package, after, before=None, changes=(), uses=(), left=(), **about):
    after = {path: File(text.encode()) for path, text in after.items()}
    before = read_folder(package) if before is None else before
    result = Result(tree=after, **about)
    proof = Proof(1, 1, [*left])
    found = report(package, before, after, result, [*changes], uses, proof)
    assert found.conflicts == sorted(result.conflicts)
    assert found.lines[-1] == proof.sentence
    return found.lines[:-1]


def texts(package):
    return {path: file.text for path, file in read_folder(package).items()}


def test_nothing_has_changed(package):
    assert said(package, texts(package)) == ["Nothing has changed."]
    assert said(package, texts(package), changes=["+ node n"]) == ["+ node n"]
    assert said(package, texts(package), uses=["a:1: b"]) == [
        "still     a:1: b",
        "Nothing has changed.",
    ]


def test_function_that_is_in_another_source_is_not_missing(package):
    """The class has its declaration; what no source defines is."""
    after = texts(package) | {"src/services.cpp": "void arm::Reach::serve_load()\n{\n}\n"}
    missing = {"src/reach.cpp": ["Reach::serve_load", "Reach::serve_store", "main"]}
    assert said(package, after, missing=missing)[1:] == [
        "missing   src/reach.cpp: Reach::serve_store",
        "missing   src/reach.cpp: main",
    ]


def test_member_that_a_base_has_or_a_header_defines_is_not_missing(package):
    """Another class that has it is none of these. A member may have the name of another one."""
    mixin = "class {}:\n    def {}(self):\n        pass\n"
    after = {
        "arm.py": "import mixins\n\n\nclass Arm(mixins.Mixin):\n    a = 1\n    home = run\n",
        "mixins.py": mixin.format("Mixin", "load") + mixin.format("Other", "store"),
        "arm.hpp": "class Reach : public Services\n{\n  void home() {}\n  void go();\n};\n",
        "services.hpp": "class Services\n{\n  void load();\n};\n",
        "services.cpp": "void Services::load()\n{\n}\n",
    }
    has = ["Reach::home", "Reach::load"]
    missing = {
        "arm.py": ["load", "store", "home"],
        "arm.hpp": ["load"],
        "arm.cpp": [*has, "Reach::go"],
    }
    found = said(package, after, missing=missing)
    assert [line for line in found if line.startswith("missing")] == [
        "missing   arm.cpp: Reach::go",
        "missing   arm.py: store",
    ]


def test_element_that_shares_its_line_is_not_missing(package):
    line = "<depend>a</depend> <depend>b</depend><!-- <depend>d</depend> -->"
    text = f"<package>\n  {line}\n</package>\n"
    missing = {"package.xml": ["depend b", "depend c", "depend d"]}
    assert said(package, {"package.xml": text}, missing=missing)[1:] == [
        "missing   package.xml: depend c",
        "missing   package.xml: depend d",
    ]


@pytest.mark.parametrize(
    "text",
    [
        "a: &a\n  gain: 1\nb:\n  <<: *a\n",
        "a: &a\n  gain: 1\nb: *a\n",
        "a: &a {gain: 1}\nc: &c\n  d: 1\nb:\n  <<: [*a, *c]\n",
        "a: &a\n  gain: 1\nc: &c\n  <<: *a\nb:\n  <<: *c\n",
        "b:\n  <<: {gain: 1}\n",
        "b: {gain: 1}\n",
        "b: {c: 1,\n  gain: 1}\n",
    ],
)
def test_key_that_an_anchor_or_a_flow_gives_is_not_missing(package, text):
    for content, missing in ((text, ["other"]), ("a: &a\n  gain: 1\nb: 2\n", ["gain", "other"])):
        found = said(package, {"a.yaml": content}, missing={"a.yaml": ["gain", "other"]})
        assert found[1:] == [f"missing   a.yaml: {key}" for key in missing]


@pytest.mark.parametrize("name", ["motor.limit", "motor/limit"])
def test_key_that_is_nested_is_not_missing(package, name):
    text = "b:\n  motor:\n    limit: 1\nlimit: 2\n"
    missing = {"a.yaml": [name, name.replace("motor", "b")]}
    (_, line) = said(package, {"a.yaml": text}, missing=missing)
    assert line == f"missing   a.yaml: {missing['a.yaml'][1]}"


@pytest.mark.parametrize("names", ["a b", "IN ITEMS ${ALL}"])
def test_package_that_a_loop_finds_is_not_missing(package, names):
    loop = f"foreach(one {names})\n  find_package(${{one}} REQUIRED)\nendforeach()\n"
    for text, missing in ((f"set(ALL\n  a  # 1\n  b)\n{loop}", "cd"), ("set(ALL a b)\n", "abcd")):
        parts = [f"find_package {name}" for name in "abcd"]
        found = said(package, {"CMakeLists.txt": text}, missing={"CMakeLists.txt": parts})
        assert found[1:] == [f"missing   CMakeLists.txt: find_package {one}" for one in missing]


def test_use_that_a_line_has_twice_is_said_once(package):
    said_twice = said(package, texts(package), changes=["+ node n"], uses=["a:1: b", "a:1: b"])
    assert said_twice == ["+ node n", "still     a:1: b"]


def test_what_became_of_files(package):
    """Of one that is in conflict, that alone."""
    head = git(package, "rev-parse", "--short", "HEAD")
    (package / "gone.py").write_text("")
    before = read_folder(package)
    (package / "gone.py").unlink()
    after = {"new.py": "", "arm.py": "b = 1\n", "there.py": "a = 1\n", "clash.py": ""}
    lines = said(
        package, after, before, moved={"other.py": "there.py"}, conflicts={"clash.py": {}}
    )
    assert lines == [
        "merged    arm.py",
        "added     new.py",
        "moved     other.py -> there.py",
        f"removed   gone.py      (see it again: git show {head}:./gone.py)",
        "CONFLICT  clash.py",
    ]


def test_parts_of_files(package):
    head = git(package, "rev-parse", "--short", "HEAD")
    lines = said(
        package,
        texts(package),
        removed={"arm.py": ["load"]},
        missing={"b.py": ["x", ""], "a.py": [""]},
        back={"c.txt": ["y"]},
        own={"d.py": ["z"]},
    )
    assert lines == [
        f"removed   load from arm.py      (see it again: git show {head}:./arm.py)",
        "missing   a.py",
        "missing   b.py: x",
        "missing   b.py",
        "back      c.txt: y, which you had deleted",
        "yours     d.py: z, which the model makes now, too: compare",
    ]


def test_what_comes_back_is_in_the_history(package):
    """A file, and a function where it read otherwise; where it is what it was, nothing is said."""
    had = git(package, "rev-parse", "--short", "HEAD")
    (package / "other.py").unlink()
    (package / "arm.py").write_text("def store():\n    return 1\n")
    commit(package, "Remove")
    assert said(package, {**texts(package), "other.py": "a = 1\n"}) == [
        f"added     other.py      (as it was: git show {had}:./other.py)"
    ]
    store = "def store():\n    return 1\n"
    assert said(package, {"arm.py": f"{store}\n\n{LOAD.format(2)}"}) == [
        "merged    arm.py",
        f"added     load to arm.py      (as it was: git show {had}:./arm.py)",
    ]
    for new in (LOAD.format(1), "def never():\n    return 1\n"):
        assert said(package, {"arm.py": f"{store}\n\n{new}"}) == ["merged    arm.py"]


def test_history_is_asked_once_of_all_that_is_new(package, monkeypatch):
    """And of what was there before, by itself: not of each file and function that came."""
    (package / "other.py").unlink()
    commit(package, "Remove")
    asked = []
    monkeypatch.setattr(
        "hooks.merge.git.git", lambda *a, **b: asked.append(a[1]) or run_git(*a, **b)
    )
    functions = "".join(f"\n\ndef new_{i}():\n    return 1\n" for i in range(9))
    files = {f"new_{i}.py": "a = 1\n" for i in range(9)}
    after = texts(package) | files
    after["arm.py"] += functions
    said(package, after)
    assert asked.count("log") == 2
    asked.clear()
    said(package, after | {"other.py": "a = 1\n"})
    assert asked.count("log") == 3


def test_lines_that_left_are_said_by_place():
    left = [
        ("b.py", 9, "x"),
        ("a.py", 3, "  y = 1\n"),
        ("a.py", 1, "f" * 61),
        ("a.py", 6, "z" * 60),
    ]
    shown = "HEAD:./{}".format
    assert [*left_behind(shown, left)] == [
        f"left      a.py:1-3: {'f' * 57}... and 1 more      (git show HEAD:./a.py)",
        f"left      a.py:6: {'z' * 60}      (git show HEAD:./a.py)",
        "left      b.py:9: x      (git show HEAD:./b.py)",
    ]


def test_file_that_only_lines_which_left_have_named(package):
    left = [("arm.py", 1, "use('tool.py', 'named.py', other.py)")]
    after = {**texts(package), "tool.py": "", "named.py": "", "list.txt": "named.py\n"}
    lines = said(package, after, left=left)
    assert [line for line in lines if line.startswith("unnamed")] == [
        "unnamed   other.py: only lines that left have named it",
        "unnamed   tool.py: only lines that left have named it",
    ]
