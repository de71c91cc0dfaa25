"""The proof of an update sees a wrong merge, and all is undone; without Copier, so quickly."""

import gc
from dataclasses import dataclass, replace

import pytest

from hooks.dictionary import load
from hooks.faults import SpecError
from hooks.merge import update as module
from hooks.merge.package import merge_package
from hooks.merge.renaming import Renaming
from hooks.merge.render import Render
from hooks.merge.tree import File, Tree
from hooks.merge.update import Update
from support.repository import ROOT, commit, git

OLD = '''class ReachImpl:
    def serve_load(self, request, response):
        """Fill in the response and return it."""
        return response

    def serve_store(self, request, response):
        """Fill in the response and return it."""
        return response
'''
NEW = OLD.replace("Fill in", "Complete")
MINE = OLD.replace("return response", "response.ok = True\n        return response", 1)
PATH = "arm/reach_impl.py"
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
    (tmp_path / PATH).write_text(MINE)
    (tmp_path / "answers.yml").write_text("spec: {name: arm, nodes: []}\n")
    commit(tmp_path, "Write the logic")
    return tmp_path


def finish(package):
    """Update as Copier would have us do, which has written by now."""
    update = Update(package, "answers.yml")
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


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("        response.ok = True\n", ""),
        ("serve_load", "serve_other"),
        ("class ReachImpl:", "class ReachImpl:\n  x"),
    ],
)
def test_file_that_was_merged_wrong_becomes_a_conflict(package, monkeypatch, right, wrong):
    def spoil(*trees, unmerged=()):
        result = merge_package(*trees, unmerged=unmerged)
        if not unmerged:
            text = result.tree[PATH].text.replace(right, wrong)
            result.tree[PATH] = replace(result.tree[PATH], data=text.encode())
        return result

    monkeypatch.setattr(module, "merge_package", spoil)
    report = finish(package)
    assert report.conflicts == [PATH]
    assert MINE in (package / PATH).read_text()


@pytest.mark.parametrize("fault", ["line", "file", "error"])
def test_wrong_merge_is_undone(package, monkeypatch, fault):
    def spoil(*trees, unmerged=()):
        result = merge_package(*trees, unmerged=unmerged)
        if fault == "line":
            result.tree[PATH] = File(NEW.encode())
        elif fault == "file":
            del result.tree[PATH]
        else:
            raise RuntimeError("anything")
        return result

    monkeypatch.setattr(module, "merge_package", spoil)
    with pytest.raises(RuntimeError if fault == "error" else SpecError):
        finish(package)
    assert git(package, "status", "--short") == ""
    assert (package / PATH).read_text() == MINE
    assert not (package / "new.py").exists()


def test_package_comes_back_when_copier_fails(package):
    update = Update(package, "answers.yml")
    (package / PATH).write_text("half of it\n")
    (package / "new.py").write_text("what Copier has added\n")
    del update
    gc.collect()
    assert git(package, "status", "--short") == ""
    assert (package / PATH).read_text() == MINE


def test_later_update_is_not_undone_by_an_earlier_one(package):
    earlier = Update(package, "answers.yml")
    finish(package)
    merged = (package / PATH).read_text()
    del earlier
    gc.collect()
    assert (package / PATH).read_text() == merged


@pytest.mark.parametrize("path", ["a.yaml", "package.xml", "a.py", "a.hpp", "CMakeLists.txt"])
def test_file_that_is_not_of_its_language_merges_by_line(path):
    old = "".join(f"line {n}: of {{ (\n" for n in range(9))
    mine, new = "mine\n" + old, old.replace("line 7", "new line")
    trees = [{path: File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert not result.conflicts
    assert result.tree[path].text == "mine\n" + new


def test_file_that_the_developer_has_moved_is_updated_where_it_is():
    trees = [{path: File(text.encode())} for path, text in (("arm/logic/reach_impl.py", MINE),)]
    old, new = {PATH: File(OLD.encode())}, {PATH: File(NEW.encode())}
    result = merge_package(trees[0], old, new, Renaming(), {""}.__contains__)
    assert list(result.tree) == ["arm/logic/reach_impl.py"]
    text = result.tree["arm/logic/reach_impl.py"].text
    assert text == MINE.replace("Fill in", "Complete")
    proof = module.prove(trees[0], old, result, result.tree, Renaming())
    assert (proof.total, proof.in_place, proof.lost) == (1, 1, [])


@pytest.mark.parametrize("order", [[0, 1, 2], [2, 0, 1], [1, 2, 0]])
def test_order_of_the_developer_stays(order):
    """So does a block of their own, after the one it followed."""
    method = "    def serve_{}(self):\n        return {}\n".format
    methods = [method(name, name) for name in ("load", "store", "home")]
    own = "\n    def own(self):\n        return 0\n"
    old = "class A:\n" + "\n".join(methods)
    mine = "class A:\n" + "\n".join(methods[i] for i in order).replace("load\n", "load\n" + own, 1)
    new = old.replace("return store", "return 'stored'") + "\n" + method("stop", "stop")
    trees = [{"a.py": File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    text = result.tree["a.py"].text
    assert not result.conflicts
    wanted = [("load", "store", "home")[i] for i in order]
    names = [line.strip()[4:-7] for line in text.splitlines() if "def " in line]
    assert [
        name.removeprefix("serve_") for name in names if name not in ("own", "serve_stop")
    ] == wanted
    assert names[names.index("serve_load") + 1] == "own"
    assert "return 'stored'" in text
