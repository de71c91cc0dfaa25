"""The proof of an update sees a wrong merge, and all is undone; without Copier, so quickly."""

import gc
import re
from dataclasses import dataclass, replace
from types import SimpleNamespace

import pytest

from hooks.dictionary import load
from hooks.faults import SpecError
from hooks.merge import versions as module
from hooks.merge.lines import MARKS
from hooks.merge.merging import by_line, conflict
from hooks.merge.package import Result, merge_package
from hooks.merge.proof import places, prove
from hooks.merge.renaming import Renaming
from hooks.merge.render import Render
from hooks.merge.transaction import Snapshot
from hooks.merge.tree import File, Tree, encode
from hooks.merge.update import Update
from hooks.merge.uses import uses_of_left
from hooks.merge.versions import Versions
from support.arm import MINE, NEW, OLD, PATH
from support.laboratory.trials import tree_of
from support.repository import ROOT, commit, git

SPEC = {"name": "arm", "nodes": []}


@dataclass
class Renders:
    """Stands in for Copier."""

    old: Tree
    new: Tree
    answers_file: str = "answers.yml"

    def recorded(self, answers):
        return Render(self.old, {"arm.ros_package"}.__contains__)

    def fresh(self, answers):
        return Render(self.new, {"arm.ros_package"}.__contains__)


@pytest.fixture
def package(tmp_path):
    (tmp_path / "arm").mkdir()
    (tmp_path / PATH).write_text(MINE, newline="\n")
    (tmp_path / "answers.yml").write_text("_src_path: model\nspec: {name: arm, nodes: []}\n")
    commit(tmp_path, "Write the logic")
    return tmp_path


def finish(package):
    """Update as Copier would have us do, which has written by now."""
    update = Update(package, "answers.yml", quiet=True)
    (package / PATH).write_text("what Copier has merged\n")
    (package / "new.py").write_text("what Copier has added\n")
    renders = Renders({PATH: File(OLD.encode())}, {PATH: File(NEW.encode())})
    dictionary = load(ROOT / "python_model/dictionary.yaml", ROOT)
    return update.finish({"spec": SPEC}, renders, dictionary, {}, True)


def test_result_is_put_in_place(package):
    report = finish(package)
    assert report.lines[-1] == "1 of 1 of your lines are in their place"
    text = (package / PATH).read_text()
    assert text == MINE.replace("Fill in", "Complete")
    assert git(package, "status", "--short") == "M arm/reach_impl.py"


def test_what_has_left_the_spec_is_said(package):
    (package / "answers.yml").write_text("_src_path: model\nspec: {nodes: [{name: watch}]}\n")
    commit(package, "Have a node")
    assert "- node watch" in finish(package).lines


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("        response.ok = True\n", ""),
        ("serve_load", "serve_other"),
        ("class ReachImpl:", "class ReachImpl:\n  x"),
    ],
)
@pytest.mark.parametrize("how", ["by block", "by line too"])
def test_file_that_was_merged_wrong(package, monkeypatch, right, wrong, how):
    """It is merged by line; what is wrong then, too, becomes a conflict."""

    def spoil(*trees):
        result, ways = merge_package(*trees), trees[5]
        if not ways or (how == "by line too" and ways[PATH] is by_line):
            text = result.tree[PATH].text.replace(right, wrong)
            result.tree[PATH] = replace(result.tree[PATH], data=text.encode())
        return result

    monkeypatch.setattr(module, "merge_package", spoil)
    report = finish(package)
    text = (package / PATH).read_text()
    if how == "by block":
        assert report.conflicts == []
        assert text == MINE.replace("Fill in", "Complete")
    else:
        assert report.conflicts == [PATH]
        assert MINE in text


def test_conflict_of_a_file_shows_what_differs():
    """The table is the developer's by block, for it is below their heading; the model has none."""
    table = "| Transforms | Use |\n|---|---|\n| `store` | broadcaster |\n\n"
    old = f"# Arm\n\nAn arm.\n\n## Node arm\n\nMoves it.\n\n{table}## Licence\n\nMIT\n\nOf all.\n"
    mine = old.replace(table, f"### Mine\n\n{table}") + "\nWords of mine.\n"
    new = old.replace(table, "")
    trees = ({"README.md": File(text.encode())} for text in (mine, old, new))
    merged = module.Versions(*trees).merge({"README.md": conflict}).tree["README.md"].text
    parts = re.findall(r"(?s)<{7}[^\n]*\n(.*?)={7}\n(.*?)>{7}", merged)
    assert parts == [(f"### Mine\n\n{table}", ""), ("\nWords of mine.\n", "")]
    assert re.sub(r"(?m)^(<{7}|={7}|>{7}).*\n", "", merged) == mine


@pytest.mark.parametrize("fault", ["line", "file", "more", "error"])
def test_wrong_merge_is_undone(package, monkeypatch, fault):
    def spoil(*trees):
        result = merge_package(*trees)
        if fault == "line":
            result.tree[PATH] = File(NEW.encode())
        elif fault == "file":
            del result.tree[PATH]
        elif fault == "more":  # what neither side has, and no line of the developer's
            result.tree["more.py"] = File(b"")
        else:
            raise RuntimeError("anything")
        return result

    monkeypatch.setattr(module, "merge_package", spoil)
    with pytest.raises(RuntimeError if fault == "error" else SpecError) as caught:
        finish(package)
    if fault != "error":
        assert str(caught.value).splitlines()[0].endswith(": [merge-not-proved]")
    if fault == "line":
        assert "\n  arm/reach_impl.py:4: response.ok = True\n" in str(caught.value)
        assert "take these lines out and commit; update; put them in again" in str(caught.value)
    if fault == "more":
        assert "these files would not be what both sides made of them" in str(caught.value)
        assert "\n  more.py: the file\n" in str(caught.value)
        assert not (package / "more.py").exists()
    assert caught.traceback  # the update is alive: not its end undoes all
    assert git(package, "status", "--short") == ""
    assert (package / PATH).read_text() == MINE
    assert not (package / "new.py").exists()


def test_joined_files_that_were_not_written(package, monkeypatch):
    update = Update(package, "answers.yml", quiet=True)
    monkeypatch.setattr(Snapshot, "put", lambda *_: None)
    joined = SimpleNamespace(result=SimpleNamespace(tree={"new.py": File(b"")}), sides=[None] * 2)
    with pytest.raises(SpecError, match=r"not all files could be written \[not-written\]"):
        update._joined(None, None, joined, inline=True)


def test_package_comes_back_when_copier_fails(package):
    update = Update(package, "answers.yml", quiet=True)
    (package / PATH).write_text("half of it\n")
    (package / "new.py").write_text("what Copier has added\n")
    del update
    gc.collect()
    assert git(package, "status", "--short") == ""
    assert (package / PATH).read_text() == MINE


def test_later_update_is_not_undone_by_an_earlier_one(package):
    earlier = Update(package, "answers.yml", quiet=True)
    finish(package)
    merged = (package / PATH).read_text()
    del earlier
    gc.collect()
    assert (package / PATH).read_text() == merged


def test_update_ends_after_a_later_one_has_ended(package):
    earlier = Update(package, "answers.yml", quiet=True)
    finish(package)
    earlier.guard.release()
    assert git(package, "status", "--short") == "M arm/reach_impl.py"


def test_file_that_cannot_be_read_any_more_is_seen():
    """Not a line of it is the developer's, who has but deleted some."""
    lines = OLD.split("\n")
    mine, old = ({PATH: File(text.encode())} for text in ("\n".join(lines[:4]) + "\n", OLD))
    result = merge_package(mine, old, {PATH: File(NEW.encode())}, Renaming(), {""}.__contains__)
    assert prove(mine, old, result, result.tree, Renaming()).lost == []
    found = {PATH: File(result.tree[PATH].data + b"  (\n")}
    lost = [(PATH, "cannot be read any more")]
    assert prove(mine, old, result, found, Renaming()).lost == lost


def test_line_is_lost_whatever_else_was_removed():
    own = OLD.replace("return response", "a = 1\n        return response")
    mine, old = ({PATH: File(text.encode())} for text in (own, OLD))
    new = {PATH: File(OLD.partition("\n    def serve_store")[0].encode())}
    result = merge_package(mine, old, new, Renaming(), {""}.__contains__)
    proof = prove(mine, old, result, result.tree, Renaming())
    assert (proof.lost, proof.left) == ([], [(PATH, 9, "        a = 1\n")])
    found = {PATH: File(result.tree[PATH].text.replace("a = 1", "a = 2").encode())}
    assert prove(mine, old, result, found, Renaming()).lost == [(PATH, "a = 1")]


def test_lines_that_exchange_their_places_are_seen():
    own = OLD.replace("    return", "    a = 1\n        b = a\n        return", 1)
    mine, old = ({PATH: File(text.encode())} for text in (own, OLD))
    result = merge_package(mine, old, {PATH: File(NEW.encode())}, Renaming(), {""}.__contains__)
    assert prove(mine, old, result, result.tree, Renaming()).lost == []
    swapped = result.tree[PATH].text.replace("a = 1\n        b = a", "b = a\n        a = 1")
    found = {PATH: File(swapped.encode())}
    assert prove(mine, old, result, found, Renaming()).lost == [(PATH, "b = a")]


TWO = "def f():\n    a()\n\n\ndef g():\n    b()\n"
OWN = TWO.replace("a()\n", "a()\n    c()\n")
IN_CONFLICT = TWO.replace("    a()\n", "{}\n    a()\n%s{}\n    d()\n%s{}\n".format(*MARKS))
IF = "if(A)\n  b()\nendif()\n"
IMPORT = "from arm import (\n    A,\n    B,\n)\n\nx = 1\n"
FOUND = [
    ("a.py", OWN, TWO, OWN, 1, []),
    ("a.py", OWN, TWO, OWN.replace("\n", "\r\n"), 1, []),
    ("a.py", OWN, TWO, "\ufeff" + OWN, 1, []),
    ("a.py", OWN, TWO, TWO, 1, ["c()"]),
    ("a.py", OWN, TWO, TWO + "    c()\n", 1, ["c()"]),
    ("a.py", OWN, TWO, IN_CONFLICT % ("    c()\n", ""), 1, []),
    ("a.py", OWN, TWO, IN_CONFLICT % ("", "    c()\n"), 1, ["c()"]),
    ("a.py", OWN.replace("    c()\n", "    c()\n" * 2), TWO, OWN, 2, ["c()"]),
    ("a.py", TWO.replace("a()", "a( )"), TWO, TWO, 0, []),
    ("a.py", OWN, TWO, "def f(:\n    c()\n", 1, ["c()", "cannot be read any more"]),
    ("a.py", "def (\nx\n", "", "def (\n  x\n", 2, ["x"]),
    ("a.py", "def (\nx = 1\n", "", "x = 1\n", 2, ["def ("]),
    ("a.py", f"# mine\n\n{TWO}", TWO, f"y = 1\n\n# mine\n\n{TWO}", 1, []),
    ("a.py", "# mine\n\n" * 2 + TWO, TWO, f"# mine\n\n{TWO}", 2, ["# mine"]),
    (
        "a.py",
        IMPORT.replace("B", "B,\n    C"),
        IMPORT,
        "from arm import A, B, C\n\nx = 1\n",
        1,
        [],
    ),
    ("a.py", IMPORT.replace("B", "B,\n    C"), IMPORT, IMPORT, 1, ["C,"]),
    ("a.cmake", IF[:-1] + "  # mine\n", IF, IF[:-1] + "  # mine\n", 1, []),
    ("a.cmake", IF[:-1] + "  # mine\n", IF, IF, 1, ["endif()  # mine"]),
    ("a.txt", f"a\n{MARKS[1]}\n", "a\n", f"a\n{MARKS[1]}\n", 1, []),
    ("a.txt", f"a\n{MARKS[1]}\n", "a\n", "a\n", 1, [MARKS[1]]),
    ("a.txt", "x\ny\n", None, "x\n\ny", 2, []),
    ("a.txt", "x\ny\n", None, "y\nx\n", 2, ["y"]),
    ("a.txt", "x\ny\n", "x\n", None, 1, ["y"]),
    ("a.txt", "x\n", "x\n", None, 0, []),
    ("a.bin", "a\0", "b\0", None, 0, ["the file"]),
    ("a.bin", "a\0", "b\0", "c\0", 0, []),
    ("a.bin", "a\0", None, None, 0, ["the file"]),
    ("a.bin", "a\0", "a\0", None, 0, []),
]


def test_row_of_a_table_in_a_conflict_is_there_as_the_developer_has_written_it():
    """Each side has changed another cell of it, which a merge would have joined."""
    mine, old, new = ("# A\n\n| a | b | c |\n".replace(*cell) for cell in ("bx", "bb", "cy"))
    found = "".join(f"{line}\n" for line in (MARKS[0], mine, MARKS[1], new, MARKS[2]))
    trees = ({"a.md": File(encode(text))} for text in (mine, old, found, new))
    mine, old, found, new = trees
    proof = prove(mine, old, Result(), found, Renaming(), new)
    assert (proof.total, proof.in_place, proof.lost) == (1, 1, [])


@pytest.mark.parametrize(("path", "mine", "old", "found", "total", "lost"), FOUND)
def test_what_became_of_the_lines_of_a_file(path, mine, old, found, total, lost):
    """In another function, or on the new side of a conflict, a line is lost."""
    mine, old, found = (
        {} if text is None else {path: File(encode(text))} for text in (mine, old, found)
    )
    proof = prove(mine, old, Result(), found, Renaming())
    assert proof.lost == [(path, line) for line in lost]
    lines = [line for line in lost if line not in ("the file", "cannot be read any more")]
    assert (proof.total, proof.in_place) == (total, total - len(lines))


def test_lines_that_would_be_lost_are_said_where_the_developer_has_them():
    """A name there is still that of before; a file that is none of theirs has no such line."""
    mine = {"arm/other.py": File(b"x = 1\n"), PATH: File(MINE.encode())}
    renaming = Renaming(paths={PATH: "arm/grasp_impl.py"}, everywhere={"ReachImpl": "GraspImpl"})
    renaming.generated = {PATH: {"class ReachImpl:": "class GraspImpl:"}}
    lost = [("arm/grasp_impl.py", "class GraspImpl:"), ("arm/grasp_impl.py", "response.ok = True")]
    lost += [("new.py", "x = 1")]
    assert [*places(mine, lost, renaming)] == [
        f"{PATH}:1: class GraspImpl:",
        f"{PATH}:4: response.ok = True",
        "new.py: x = 1",
    ]


@pytest.mark.parametrize(
    ("code", "is_there"),
    [(b"if a: response.ok = 1\n", True), (b"if a: pass\n", False), (b"", False)],
)
def test_line_that_another_file_has_now_is_in_its_place(code, is_there):
    mine, old = ({PATH: File(text.encode())} for text in (MINE, OLD))
    result = Result(carried={PATH: (["b.py", "gone.py"], {4: ("if a", "response.ok =")})})
    proof = prove(mine, old, result, {"b.py": File(code)}, Renaming())
    assert (proof.total, proof.in_place, proof.lost) == (1, is_there, [])
    assert proof.left == ([] if is_there else [(PATH, 4, "        response.ok = True\n")])


def test_file_without_lines_that_leaves_is_no_lost_one():
    """The summary says that it has left."""
    mine, old = ({"a.png": File(data)} for data in (b"mine\0", b"a\0"))
    assert prove(mine, old, Result(left=["a.png"]), {}, Renaming()).lost == []


@pytest.mark.parametrize("path", ["arm/reach_impl.py", "src/reach_impl.cpp", "arm/tools.py"])
@pytest.mark.parametrize("name", ["t", "~/t", "/t"])
def test_uses_of_what_left(path, name):
    """A member of the logic's objects, and words made of the name; not look-alikes."""
    old = {"arm/reach_interface.py": File(b"self.out_t = 1\nself.k = 2\nself.my_k = 3\nhat = k\n")}
    new = {"arm/reach_interface.py": File(b"self.my_k = 3\nhat = k\n")}
    code = "data.out_t = config.k\nother.k = config.my_k + hat + k\nthis(data.out_t)\n"
    found, gone = {path: File(code.encode())}, [("reach", "k"), ("reach", name)]
    said = [*uses_of_left(gone, old, new, found, ["config", "data"])]
    left = [f"{path}:1: out_t", f"{path}:1: k", f"{path}:3: out_t"]
    left = left if "reach" in path else [left[0], left[2]]  # another node may have k still
    assert said == [f"{use}, which has left" for use in left]


def test_uses_of_what_left_in_quotes():
    """Of a type, or in `__all__`, and in no other text."""
    old, new = (tree_of({"arm/reach_interface.py": text}) for text in ("class InT:\n  a\n", ""))
    code = "__all__ = [\n  'InT',\n]\na: 'list[InT]' = 'InT'\nb = 'InT'\n"
    said = [*uses_of_left([("reach", "t")], old, new, tree_of({"arm/reach_impl.py": code}))]
    assert said == [f"arm/reach_impl.py:{line}: InT, which has left" for line in (2, 4)]


@pytest.mark.parametrize(
    ("code", "is_said"),
    [
        ('#include "arm/reach_interface.hpp"\nint a = config.k;\n', True),
        ("from .reach_interface import ReachConfig\na = config.k\n", True),
        ("from .watch_interface import WatchConfig\na = config.k\n", False),
    ],
)
def test_parameter_of_one_node_that_left_is_said_in_files_of_that_node(code, is_said):
    """Another node has one of the same name still."""
    path = "src/a.cpp" if "include" in code else "arm/a.py"
    watch = {"arm/watch_interface.py": "k = 1\n"}
    old = tree_of({**watch, "arm/reach_interface.py": "k = 1\n"})
    new, found = tree_of({**watch, "arm/reach_interface.py": ""}), tree_of({path: code})
    said = uses_of_left([("reach", "k")], old, new, found, ["config"])
    assert [*said] == ([f"{path}:2: k, which has left"] if is_said else [])


@pytest.mark.parametrize(
    ("path", "code", "is_used"),
    [
        ("arm/a.py", "import geometry_msgs.msg as msgs\n", True),
        ("arm/a.py", "try:\n  from geometry_msgs.msg import Twist\n", False),
        ("arm/a.py", "if a: from geometry_msgs.msg import Twist\n", True),
        ("arm/a.py", "from std_msgs.msg import Empty\nfrom arm.geometry_msgs import a\n", False),
        ("src/a.cpp", "#  include <geometry_msgs/Twist.h>\n", True),
        ("src/a.cpp", '#include "arm/geometry_msgs.hpp"\n', False),
        ("CMakeLists.txt", "link(a ${geometry_msgs_TARGETS})\n", True),
        ("CMakeLists.txt", "link(a geometry_msgs::all)\n# my_geometry_msgs\n", True),
        ("launch/a.xml", '<arg name="a" default="geometry_msgs"/>\n', False),
    ],
)
@pytest.mark.parametrize("is_declared", [False, True])
def test_uses_of_a_package_that_left(path, code, is_used, is_declared):
    """Its last interface has left, and the dependency with it, which the developer may keep."""
    kept = "<depend>std_msgs</depend>\n"
    gone = "<exec_depend condition='1'>geometry_msgs</exec_depend>\n"
    old, new = ({"package.xml": File(text.encode())} for text in (kept + gone, kept))
    found = {path: File(code.encode()), **(old if is_declared else new)}
    said = [*uses_of_left([("reach", "pose")], old, new, found)]
    is_said = is_used and not is_declared
    assert said == ([f"{path}:1: geometry_msgs, which has left"] if is_said else [])


NODE = '<node pkg="arm" exec="{}"\n  name="{}"/>\n'
OF_A_NODE = {
    "setup.py": (
        "x = ['a = arm.watch_ros:main', 'arm.watch_rosy', 'b.arm.watch_ros']\n",
        "arm.watch_ros",
    ),
    "launch/a.xml": (
        '<param from="$(find-pkg-share arm)/config/watch.yaml"/>\n',
        "config/watch.yaml",
    ),
    "launch/b.xml": (NODE.format("watch", "left") + NODE.format("b", "watch_2"), "watch"),
    "launch/c.xml": (NODE.replace("arm", "vendor").format("watch", "watch"), ""),
    "launch/d.launch.py": (
        "Node(name='watch', executable='watch',\n  package='arm')\nNode(package=a, **b)\n",
        "watch",
    ),
    "a/CMakeLists.txt": ("depend(tool watch)\nset(a watch_2 watch.cpp a/watch)\n", "watch"),
    "b/CMakeLists.txt": ("link(tool arm_watch)\nlink(arm_reach)\n", "arm_watch"),
    "launch/e.launch.py": ("Node(package='vendor', executable='watch')\n", ""),
    "launch/f.launch.py": ("Node(package='arm', executable='reach', name='watch')\n", ""),
    "config/a.yaml": ("/lab/watch:\n  ros__parameters:\n    watch: 1\n", "/lab/watch"),
    "config/b.yaml": ("watch: {a: 1}\n", "watch"),
    "config/c.yaml": ("watch: 1\na: {watch: 1}\nreach:\n  watch: {a: 1}\n", ""),
}


@pytest.mark.parametrize(("path", "text", "word"), [(p, *case) for p, case in OF_A_NODE.items()])
def test_uses_of_a_node_that_left_in_texts(path, text, word):
    """By the files that it had, and by what the launch file has said of it."""
    launch = NODE.format("reach", "reach")
    made = "project(arm)\nadd_library(${PROJECT_NAME}_reach a.cpp)\n"
    left = "add_executable(watch\n  b.cpp)\nadd_library(${PROJECT_NAME}_watch a.cpp)\n"
    old = {
        "CMakeLists.txt": made + left,
        "arm/watch_ros.py": "",
        "config/watch.yaml": "",
        "l.xml": launch + NODE.format("watch", "watch"),
    }
    new = {"l.xml": launch, "CMakeLists.txt": made}
    old, new, found = map(tree_of, (old, new, {path: text}))
    said = [*uses_of_left([("watch", "watch")], old, new, found)]
    assert said == ([f"{path}:1: {word}, which has left"] if word else [])


@pytest.mark.parametrize(
    ("path", "code"),
    [
        (
            "a.py",
            "from arm.reach_interface import ReachConfig\n\nuse(\n  ReachConfig(k=1),\n  k=2)\n",
        ),
        ("a.cpp", "int k = 1;\n\nuse(k,\n  arm::ReachConfig{.k = k});\n"),
    ],
)
def test_parameter_that_left_is_said_where_it_is_given_a_value(path, code):
    old = tree_of({"arm/reach_interface.py": "class ReachConfig:\n    k: int = 1\n"})
    new = dict.fromkeys(old, File(b""))
    said = [*uses_of_left([("reach", "k")], old, new, tree_of({path: code}), ["config"])]
    assert said == [f"{path}:4: k, which has left"]


def test_many_generated_lines_that_are_alike_are_not_the_developers():
    """Some of them may leave."""
    old, new = "x\n" * 300, "x\n" * 299
    files = (tree_of({"a.txt": text}) for text in (f"mine\n{old}mine too\n", old, new))
    result, doubts = Versions(*files).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["a.txt"].text == f"mine\n{new}mine too\n"


IMPORTS = {
    "test/test_mine.py": (
        "from support.harness import (\n    fake)\nimport a, support.peer\n",
        ["1: support.harness", "3: support.peer"],
    ),
    "test/support/mine.py": (
        "from . import harness as h\nfrom .peer import Peer\n",
        [
            "1: test.support.harness",
            "2: test.support.peer",
        ],
    ),
    "arm/tools.py": (
        "from arm.ros.stop import Stop\nfrom .ros import stop, mine\nimport arm.ros.mine\n",
        ["1: arm.ros.stop", "2: arm.ros.stop"],
    ),
    "arm/own/tools.py": (
        "from ..ros import stop\nfrom ..ros.stop import Stop\nfrom ..stop import a\n",
        ["1: arm.ros.stop", "2: arm.ros.stop"],
    ),
    "arm/other.py": ("from vendor.ros.stop import a\nfrom .stop import b\nimport peer\n", []),
    "src/a.cpp": (
        '#include "ros/stop.hpp"\n#include "arm/ros/time.hpp"\n#include "vendor/ros/time.hpp"\n',
        ["1: ros/stop.hpp", "2: arm/ros/time.hpp"],
    ),
    "src/b.cpp": ('#include "stop.hpp"\n#include <vector>\n// "ros/stop.hpp"\n', []),
}


@pytest.mark.parametrize(("path", "text", "uses"), [(p, *case) for p, case in IMPORTS.items()])
def test_imports_of_files_that_left(path, text, uses):
    """As those of the runtime do when another package has them."""
    gone = ("test/support/harness.py", "test/support/peer.py", "arm/ros/stop.py")
    gone += ("src/ros/stop.hpp", "include/arm/ros/time.hpp")
    old = tree_of({**dict.fromkeys(gone, ""), "arm/__init__.py": "", "arm/ros/mine.py": ""})
    new = tree_of({"arm/__init__.py": "", "arm/ros/mine.py": ""})
    said = uses_of_left([], old, new, tree_of({path: text}), [])
    assert [*said] == [f"{path}:{use}, which has left" for use in uses]


IN_NODE = """<launch>
  <node pkg="{}" exec="reach">
    <{}>
  </node>
</launch>
"""
IN_PYTHON = "Node(\n    {}, executable='reach',\n    {},\n)\n"
PARAMETERS = "parameters=[{'k': 2.0, 'x': 'k'}, 'k']"
GIVEN = {
    "config/a.yaml": ("/lab/reach:\n  ros__parameters:\n    k: 2\n", ["3: k"]),
    "config/b.yaml": ("/lab/watch:\n  ros__parameters:\n    k: 2\n    x: reach\n", []),
    "config/c.yaml": ("/**:\n  ros__parameters:\n    k: 2\n    old: 1\n", ["4: old"]),
    "config/d.yaml": ("reach:\n  k: 2\n  a: {k: 1}\n", ["2: k"]),  # ROS 1
    "config/reach_lab.yaml": ("k: 2\nserial: {baud: 1}\n", ["1: k", "2: baud"]),
    "config/e.yaml": ("k: 2\nold: 1\n", []),
    "config/f.yaml": ("reach:\n  ros__parameters: {serial.baud: 1}\n", ["2: serial.baud"]),
    "config/g.yaml": ("reach: {\n", []),
    "launch/a.xml": (IN_NODE.format("arm", 'param name="k" value="2"/'), ["3: k"]),
    "launch/b.xml": (IN_NODE.format("arm", 'remap from="~/t" to="u"/'), ["3: ~/t"]),
    "launch/c.xml": (IN_NODE.format("vendor", 'param name="k"/'), []),
    "launch/d.xml": (IN_NODE.format("arm", 'param name="x" value="k"/'), []),
    "launch/e.launch": (IN_NODE.format("arm", "rosparam>\n  x: k\n  k: 2\n</rosparam"), ["5: k"]),
    "launch/f.launch": (IN_NODE.format("arm", 'rosparam param="k">[2, 3]</rosparam'), ["3: k"]),
    "launch/g.launch": (IN_NODE.format("vendor", "rosparam>k: 2</rosparam"), []),
    "launch/h.launch": (IN_NODE.format("arm", "rosparam>k: [</rosparam"), []),
    "launch/i.xml": (IN_NODE.format("arm", 'param name="k" value="\udce9"/'), []),  # no UTF-8
    "launch/j.xml": (
        '<?xml version="1.0" encoding="latin-1"?>\n'
        + IN_NODE.format("arm", 'param name="k" value="\udce9"/'),
        ["4: k"],
    ),
    "launch/e.launch.py": (IN_PYTHON.format("package='arm'", PARAMETERS), ["3: k"]),
    "launch/f.launch.py": (IN_PYTHON.format("package='arm'", "remappings=[('t', 'k')]"), ["3: t"]),
    "launch/h.launch.py": (
        IN_PYTHON.format("package='arm'", "parameters=[{'serial/baud': 1}]"),
        ["3: serial/baud"],
    ),
    "launch/g.launch.py": (IN_PYTHON.format("package='vendor'", PARAMETERS), []),
}


@pytest.mark.parametrize(("path", "text", "uses"), [(p, *case) for p, case in GIVEN.items()])
def test_parameter_or_topic_that_left_is_said_where_a_file_gives_it_a_value(path, text, uses):
    """Of its node alone, where another one may have the name, too."""
    launch = NODE.format("reach", "reach") + NODE.format("watch", "watch")
    common = {"l.launch.xml": launch, "arm/watch_interface.py": "class WatchConfig:\n    k = 1\n"}
    old = tree_of({**common, "config/reach.yaml": "k: 1\nold: 1\nserial.baud: 1\n"})
    gone = [("reach", each) for each in ("k", "t", "old", "serial.baud")]
    said = uses_of_left(gone, old, tree_of(common), tree_of({path: text}), ["config"])
    assert [*said] == [f"{path}:{use}, which has left" for use in uses]


@pytest.mark.parametrize("field", ["Path p", "lab/Path[<=3] p", "  Path[] p  # mine"])
@pytest.mark.parametrize("path", ["msg/Own.msg", "srv/Own.srv", "action/Own.action"])
def test_message_that_left_is_said_where_own_messages_have_it(field, path):
    common = {"CMakeLists.txt": "project(lab)\n"}
    old = tree_of({**common, "msg/Path.msg": "int8 a\n", "msg/Pose.msg": "int8 a\n"})
    text = f"# Path p\nnav_msgs/Path a\nPath2 b\nPose Path\n---\n{field}\n"
    new = tree_of({**common, "msg/Place.msg": "int8 a\n"})
    said = uses_of_left([("Path", "Path")], old, new, tree_of({path: text}))
    assert [*said] == [f"{path}:6: Path, which has left"]
