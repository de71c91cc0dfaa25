"""The second proof counts: it sees what the first does not, and stays silent where all is well."""

import re
from collections import Counter
from random import Random

import pytest

from hooks.merge.package import Result, merge_package
from hooks.merge.proof import prove
from hooks.merge.recount import _bodies as bodies
from hooks.merge.recount import _faults, recount
from hooks.merge.renaming import Renaming
from hooks.merge.tree import LINK, PLAIN, File, encode
from hooks.merge.versions import Versions
from support.arm import PATH
from support.laboratory import specs
from support.laboratory.edits import edit
from support.laboratory.mutants import MUTANTS, OF_HABITS
from support.laboratory.trials import MODELS, ahead, tree_of

CMAKE = "project(arm)\n\nadd_library(core src/core.cpp)\n"
README = "# Arm\n\nMoves.\n\n## Use\n\nRun it.\n"
HPP = """#pragma once
namespace arm {
class WorkerImpl
{
public:
  // Service load
  void serve_load(Request & request);
#ifdef ARM_RESET
  // Service reset
  void serve_reset(Request & request);
#endif
};
}
"""
CPP = """#include "arm/worker_impl.hpp"

void arm::WorkerImpl::serve_load(Request & request)
{
  use(request);
}

void arm::WorkerImpl::serve_reset(Request & request)
{
  reset(request);
}
"""
PYTHON = """from arm.reach_interface import ReachData


def run():
    return ReachData()
"""
NEW = {
    "CMakeLists.txt": CMAKE + "\ninstall(TARGETS core DESTINATION lib)\n",
    "README.md": README.replace("Run it.", "Run it.\n\n```sh\nrun --all\n```"),
    "include/arm/worker_impl.hpp": HPP.replace("Service load", "The service load"),
    "src/worker_impl.cpp": CPP,
    "arm/tools.py": PYTHON.replace("import ReachData", "import ReachConfig, ReachData").replace(
        "ReachData()", "ReachData(ReachConfig())"
    ),
    "config/worker.yaml": "rate: 10  # Hz\ngain: 1\n",
}
OLD = {
    "CMakeLists.txt": CMAKE,
    "README.md": README,
    "include/arm/worker_impl.hpp": HPP,
    "src/worker_impl.cpp": CPP,
    "arm/tools.py": PYTHON,
    "config/worker.yaml": "rate: 10\ngain: 1\n",
}
MINE = {
    "CMakeLists.txt": CMAKE.replace("\n\n", "\n\noption(OWN on)\n\n"),
    "README.md": README.replace("Moves.", "Moves well."),
    "include/arm/worker_impl.hpp": HPP.replace("};", "  int mine_;\n};"),
    "src/worker_impl.cpp": CPP.replace("  use", "  mine();\n  use"),
    "arm/tools.py": PYTHON.replace("    return", "    mine = 1  # counted\n    return"),
    "config/worker.yaml": "rate: 10\ngain: 7\n",
}


def trees(**changes):
    return [{path: File(encode(t)) for path, t in side.items()} for side in (MINE, OLD, NEW)]


def counted(change=lambda tree: None):
    sides = (*trees(), Renaming(), {"arm.ros_package"}.__contains__)
    result = merge_package(*sides)
    assert not result.conflicts
    change(result.tree)
    return recount(
        *sides, result, result.tree, prove(*sides[:2], result, result.tree, sides[3]).left
    )


def test_right_merge_is_right():
    assert counted() == []


FAULTS = {
    "line of the model dropped": ("CMakeLists.txt", "install(TARGETS core DESTINATION lib)\n", ""),
    "line of the developer dropped": ("CMakeLists.txt", "option(OWN on)\n", ""),
    "section twice": ("README.md", "## Use\n", "## Use\n\nRun it.\n\n## Use\n"),
    "deleted line back": ("config/worker.yaml", "gain: 7", "gain: 1\nown_gain: 7"),
    "end of a condition gone": ("include/arm/worker_impl.hpp", "#endif\n", ""),
    "brace gone": ("include/arm/worker_impl.hpp", "};\n", ""),
    "declaration gone": ("include/arm/worker_impl.hpp", "void serve_load(", "void serve_other("),
    "definition gone": ("src/worker_impl.cpp", "::serve_reset(", "::serve_other("),
    "import gone": ("arm/tools.py", "ReachConfig, ReachData\n", "ReachData\n"),
    "name of another": ("arm/tools.py", "ReachData()", "SpeakData()"),
    "fence open": ("README.md", "run --all\n```", "run --all"),
    "key twice": ("config/worker.yaml", "gain: 7", "gain: 7\nrate: 10"),
    "parenthesis gone": ("CMakeLists.txt", "DESTINATION lib)", "DESTINATION lib"),
}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_fault_is_seen(fault):
    path, before, after = fault

    def spoil(tree):
        assert before.split("(")[0] in tree[path].text
        text = tree[path].text
        text = (
            text.replace("ReachData(ReachConfig())", "ReachData()")
            if "SpeakData" in after
            else text
        )
        tree[path] = File(encode(text.replace(before, after)))

    assert path in {place for place, _ in counted(spoil)}


def test_deleted_line_that_stands_elsewhere_too_is_not_to_come_back():
    texts = ["a:\n  gain: 1\n  rate: 2\nb:\n  gain: 1\n  rate: 2\n"]
    texts.append(texts[0].replace("gain: 1", "gain: 3", 1))
    mine = texts[0].replace("b:\n  gain: 1\n", "b:\n")
    sides = [{"a.yaml": File(encode(text))} for text in (mine, *texts)]
    result = merge_package(*sides, Renaming(), {""}.__contains__)
    right = recount(*sides, Renaming(), {""}.__contains__, result, result.tree, [])
    wrong = recount(*sides, Renaming(), {""}.__contains__, result, sides[2], [])
    assert (right, {*wrong}) == ([], {("a.yaml", "gain: 1 (deleted)")})


def test_lines_of_a_new_part_are_no_deleted_ones_of_another():
    one, other, third = (f"link({name}\n  x\n  core\n  tf2\n)\n" for name in "abc")
    old = one + other.replace("  x\n", "")
    mine = old.replace(one, "own(a)\n")
    trees = [{"CMakeLists.txt": File(encode(text))} for text in (mine, old, old + third)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["CMakeLists.txt"].text == mine + third
    found = {"CMakeLists.txt": File(encode(old + third))}
    again = recount(*trees, Renaming(), {""}.__contains__, result, found, [])
    assert ("CMakeLists.txt", "core (deleted)") in again


def test_files_are_counted_too():
    def remove(tree):
        del tree["src/worker_impl.cpp"]

    def link(tree):
        tree["README.md"] = File(b"docs/README.md", LINK)

    def windows(tree):
        tree["other.py"] = File(b"")

    assert ("src/worker_impl.cpp", "the file") in counted(remove)
    assert ("README.md", "the link") in counted(link)
    assert ("other.py", "the file") in counted(windows)


FIRST = {"line_at_the_end", "bodies_swapped", "condition_ends_elsewhere"}
"""Faults that the first proof alone sees: lines that are there, elsewhere."""


@pytest.fixture(scope="module")
def seen(laboratory):
    """Count by mutant how often it spoils a merge, and how often each proof sees that."""
    found = {}
    for model in MODELS * 2:
        random = Random(f"{model} {len(laboratory.versions)} {sum(map(len, found.values()))}")
        spec = specs.random_spec(random)
        pair = laboratory.pair(spec, specs.change(random, spec), model, ("kilted",) * 2, "2.0.0")
        for _ in range(4):
            edited = edit(random, pair.old, ahead(random, pair))
            sides = (edited.tree(), tree_of(pair.old), tree_of(pair.new), pair.renaming)
            result = merge_package(*sides, pair.is_kept)
            for mutant in [*MUTANTS, *OF_HABITS]:
                counts, spoiled = found.setdefault(mutant.__name__, Counter()), {**result.tree}
                if counts["all"] < 3 and mutant(random, spoiled, edited, pair):
                    proof = prove(*sides[:2], result, spoiled, pair.renaming)
                    second = recount(*sides, pair.is_kept, result, spoiled, proof.left)
                    counts.update(all=1, first=bool(proof.lost), second=bool(second))
                    counts["either"] += bool(proof.lost or second)
    return found


def test_each_proof_is_needed(seen):
    for name in FIRST:
        assert seen[name]["first"] == seen[name]["all"]
    others = [name for name in seen if name not in FIRST]
    assert any(seen[name]["second"] < seen[name]["all"] for name in FIRST)
    assert (
        sum(seen[name]["first"] < seen[name]["all"] for name in others) >= 5
    )  # the second is needed
    missed = {name: counts for name, counts in seen.items() if counts["either"] < counts["all"]}
    assert sum(counts["all"] - counts["either"] for counts in missed.values()) <= 2, missed


def test_logic_that_was_moved_may_stay_when_its_node_leaves():
    """Its header is generated, and gone: that is no fault of the merge."""
    cpp, hpp = "src/mine/worker_impl.cpp", "include/arm/worker_impl.hpp"
    mine = {cpp: File(encode(CPP)), hpp: File(encode(HPP))}
    old = {"src/worker_impl.cpp": File(encode(CPP)), hpp: File(encode(HPP))}
    sides = (mine, old, {}, Renaming(), {""}.__contains__)
    result = merge_package(*sides)
    assert list(result.tree) == [cpp]
    assert recount(*sides, result, result.tree, []) == []


UNREADABLE = {"cannot be read any more"}


@pytest.mark.parametrize(
    ("path", "text", "faults"),
    [
        ("a.py", "x = y\n", {"y is not defined"}),
        ("a.py", "from a import *\ny\n", set()),
        ("a.py", "import a.b, c.d as e\nfrom f import g\na, e, g, print, __file__\n", set()),
        ("a.py", "import a.b\nb\n", {"b is not defined"}),
        ("a.py", "def f(a, *b, c=1, **d):\n    return a, b, c, d, f\n", set()),
        ("a.py", "try:\n    1\nexcept E as e:\n    e\n", {"E is not defined"}),
        ("a.py", "(\n", UNREADABLE),
        ("a.py", "a = ['n = m:f', 'n=o.p:f', 'k = m:f', 'n: m']\n", {"n is there 2 times"}),
        ("a.yaml", "a: 1\na: 2\nb: {c: 1, c: 2}\n", {"a is there 2 times", "c is there 2 times"}),
        ("a.yml", "- {a: 1, a: 1, a: 1}\n- a: 1\n---\nb: b\n", {"a is there 3 times"}),
        ("a.yaml", "a: [\n", UNREADABLE),
        ("a.md", "```\n", {"a fence is open"}),
        ("a.md", "```\n  ```\nand ```\n", set()),
        ("a.cpp", "f() {a[0];}\n", set()),
        ("a.cpp", "}{", {"its braces do not match"}),
        (
            "a.hpp",
            "#  if A\n( {",
            {f"its {e} do not match" for e in ("braces", "parentheses")}
            | {"its conditions do not match"},
        ),
        ("a.cc", "#if A\n#endif\n'{' '\\'' \"}\" // (\n/* {\n( */", set()),
        ("CMakeLists.txt", 'if(A)\nfoo()\nendif()\n#[[ ( ]]\n# (\na("(" [=[ ) ]] ]=])\n', set()),
        ("a.cmake", "foreach(A)\n", {"its commands do not match"}),
        ("a.cmake", "message)\n", {"its parentheses do not match"}),
        ("a.txt", "(", set()),
    ],
)
def test_what_is_not_sound_in_a_file(path, text, faults):
    assert _faults(path, text) == faults


def about_files(mine, old, new, found, **said):
    """Count files alone; a text stands for a file, one that begins with -> for a link."""
    sides = (
        {
            path: File(text.removeprefix("->").encode(), LINK if text[:2] == "->" else PLAIN)
            for path, text in side.items()
        }
        for side in (mine, old, new, found)
    )
    *sides, found = sides
    result = Result(tree=found, **said)
    return recount(*sides, Renaming(), {"kept"}.__contains__, result, found, [])


LINE_ENDS = "the ends of its lines"


@pytest.mark.parametrize(
    ("mine", "old", "new", "right", "wrong", "said"),
    [
        ("->x", "->x", "->y", "->y", "->x", "the link"),
        ("->z", "->x", "->y", "->z", "->y", "the link"),
        ("->z", "", "", "->z", "", "the file"),
        ("->z", "", "", "->z", "1", "the link"),
        ("", "1", "1", "", "1", "the file"),
        ("", "", "1", "1", "", "the file"),
        ("1", "1", "", "", "1", "the file"),
        ("1", "", "", "1", "", "the file"),
        ("1\r\n", "1\n", "1\n", "1\r\n", "1\n", LINE_ENDS),
        ("1\n", "1\r\n", "1\r\n", "1\n", "", "the file"),
    ],
)
def test_files_that_have_to_be_there(mine, old, new, right, wrong, said):
    sides = [{"a": text} if text else {} for text in (mine, old, new)]
    found, other = ({"a": text} if text else {} for text in (right, wrong))
    assert about_files(*sides, found) == []
    assert ("a", said) in about_files(*sides, other)


@pytest.mark.parametrize(("old", "new"), [("2", ""), ("2", "3"), ("", "3")])
def test_file_that_is_kept_has_to_be_there(old, new):
    sides = [{"kept": text} if text else {} for text in ("1", old, new)]
    assert about_files(*sides, {"kept": "1"}) == []
    assert about_files(*sides, {}) == [("kept", "the file")]


def test_conflict_may_have_its_file_or_not():
    for found in ({"a": "1"}, {}):
        said = about_files({"a": "2"}, {"a": "0"}, {}, found, conflicts={"a": {}})
        assert said == []


def test_function_of_which_the_developer_has_one_half_is_theirs():
    """As where they have defined it in the header, or not at all."""
    hpp, cpp = "include/arm/worker_impl.hpp", "src/worker_impl.cpp"
    for taken in (
        ("  void serve_load(Request & request);\n", hpp),
        (CPP[CPP.index("void") : CPP.rindex("void")], cpp),
    ):
        old = {hpp: HPP, cpp: CPP}
        mine = {**old, taken[1]: old[taken[1]].replace(taken[0], "")}
        new = {hpp: HPP.replace("Service load", "The service load"), cpp: CPP + "\n// More\n"}
        sides = [{p: File(encode(t)) for p, t in side.items()} for side in (mine, old, new)]
        sides = (*sides, Renaming(), {""}.__contains__)
        result = merge_package(*sides)
        assert [
            said for said in recount(*sides, result, result.tree, []) if "half" in said[1]
        ] == []
        whole = [{p: File(encode(t)) for p, t in side.items()} for side in (old, old, new)]
        said = recount(*whole, *sides[3:], result, result.tree, [])
        half = "WorkerImpl::serve_load is but half there"
        assert {(hpp, half), (cpp, half)} & {*said}


@pytest.mark.parametrize("conflicts", [{}, {"README.md": {}}])
def test_function_that_leaves_leaves_whole(conflicts):
    """That another file is in conflict hides nothing."""
    hpp, cpp = "include/arm/worker_impl.hpp", "src/worker_impl.cpp"
    old = {hpp: HPP, cpp: CPP}
    new = {
        hpp: HPP.replace("  void serve_load(Request & request);\n", ""),
        cpp: CPP.replace(CPP[CPP.index("void") : CPP.rindex("void")], ""),
    }
    sides = [{p: File(encode(t)) for p, t in side.items()} for side in (old, old, new)]
    sides = (*sides, Renaming(), {""}.__contains__)
    result = merge_package(*sides)
    result.conflicts |= conflicts
    assert recount(*sides, result, result.tree, []) == []
    for path in hpp, cpp:
        found = {**result.tree, path: File(encode(old[path]))}
        said = recount(*sides, result, found, [])
        assert "WorkerImpl::serve_load is but half there" in [what for _, what in said], path


def test_each_class_is_read_once():
    """Not for each of its members, nor in the headers of others: a package may have many nodes."""
    names = [f"Node{letter}Impl" for letter in "ABCDEF"]
    old = {f"include/arm/{name}.hpp": HPP.replace("WorkerImpl", name) for name in names}
    old |= {f"src/{name}.cpp": CPP.replace("WorkerImpl", name) for name in names}
    side = {path: File(encode(text)) for path, text in old.items()}
    bodies.cache_clear()
    assert recount(side, side, side, Renaming(), {""}.__contains__, Result(), side, []) == []
    assert bodies.cache_info().misses == len(names)


def test_function_that_leaves_stays_in_a_file_of_the_developers_own():
    """No merge is at fault: the summary says that it is used and has left."""
    hpp, cpp, own = "include/arm/worker_impl.hpp", "src/worker_impl.cpp", "src/services.cpp"
    at, end = CPP.index("void"), CPP.rindex("void")
    old = {hpp: HPP, cpp: CPP}
    new = {
        hpp: HPP.replace("  void serve_load(Request & request);\n", ""),
        cpp: CPP.replace(CPP[at:end], ""),
    }
    mine = {hpp: HPP, cpp: new[cpp], own: CPP[:end]}
    trees = [{p: File(encode(t)) for p, t in side.items()} for side in (mine, old, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert {path: file.text for path, file in result.tree.items()} == {**new, own: CPP[:end]}


@pytest.mark.parametrize(
    "own",
    [
        "struct Base\n{\n  virtual void serve_load(Request & request) = 0;\n};\n",
        "class Own\n{\n  friend class WorkerImpl;\n  void serve_load(Request & request);\n};\n",
        "class Sub : public A<1>, arm::WorkerImpl\n{\n  void serve_load(Request & r);\n};\n",
        "",
    ],
)
def test_function_that_leaves_is_not_half_there_where_another_class_has_one_or_it_is_called(own):
    hpp, cpp = "include/arm/worker_impl.hpp", "src/worker_impl.cpp"
    old = {hpp: HPP, cpp: CPP}
    head = f"namespace arm {{\nclass WorkerImpl;\n{own}"
    calls = "  void all() {serve_load(r); return serve_load(r);}\n};\n}\n"
    mine = {hpp: HPP.replace("namespace arm {\n", head).replace("};\n}\n", calls), cpp: CPP}
    function = CPP[CPP.index("void") : CPP.rindex("void")]
    line = "  // Service load\n  void serve_load(Request & request);\n"
    new = {hpp: HPP.replace(line, ""), cpp: CPP.replace(function, "")}
    trees = [{p: File(encode(t)) for p, t in side.items()} for side in (mine, old, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    wanted = {hpp: mine[hpp].replace(line, ""), cpp: new[cpp]}
    assert {path: file.text for path, file in result.tree.items()} == wanted


LOGIC = """class Impl:
    # Service load
    def serve_load(self, request, response):
        return response

    # Service home
    def serve_home(self, request, response):
        return response
"""


def test_own_function_has_a_line_of_one_that_leaves():
    """The developer has moved it into a helper, above the function that stays."""
    helper = "self.filled(response)\n\n    def filled(self, response):\n        return response\n"
    mine = LOGIC.replace("response\n\n    # Service home", helper + "\n    # Service home")
    new = LOGIC[:12] + LOGIC[LOGIC.index("    # Service home") :]
    trees = [{"a/impl.py": File(encode(text))} for text in (mine, LOGIC, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.removed == {"a/impl.py": ["serve_load"]}
    assert (
        "def filled(self, response):\n        return response\n" in result.tree["a/impl.py"].text
    )


@pytest.mark.parametrize(
    ("path", "text", "item", "sign"),
    [
        (
            "a/impl.py",
            LOGIC,
            LOGIC[LOGIC.index("    def ") : LOGIC.index("\n    # Service h")],
            "    # ",
        ),
        ("src/worker_impl.cpp", CPP, CPP[CPP.index("void") : CPP.rindex("void") - 1], "// "),
        ("src/worker_impl.cpp", CPP, CPP[CPP.index("void") : CPP.rindex("void") - 1], "#if 0"),
        ("config/a.yaml", "rate: 10\n# Gain\ngain: 1\n", "gain: 1\n", "# "),
        ("CMakeLists.txt", CMAKE, "add_library(core src/core.cpp)\n", "# "),
    ],
)
def test_what_leaves_may_stay_as_the_comment_that_the_developer_has_made_of_it(
    path, text, item, sign
):
    out = "".join(f"{sign}{line}" for line in item.splitlines(keepends=True))
    out = f"{sign}\n{item}#endif\n" if sign == "#if 0" else out
    mine = text.replace(item, out)
    new = text.replace(item, "").replace("# Gain\n", "").replace("    # Service load\n", "")
    assert len({mine, text, new}) == 3
    hpp = [HPP, HPP, HPP.replace("  // Service load\n  void serve_load(Request & request);\n", "")]
    sides = zip((mine, text, new), hpp, strict=True)
    trees = [{path: File(encode(one)), "a.hpp": File(encode(two))} for one, two in sides]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert out in result.tree[path].text


def test_line_that_is_a_part_of_two_others_leaves_with_them():
    """The developer logs all nodes; that of one node is in two lines, of the container in one."""
    log = 'output="screen" args="-l $(var level)"'
    node = f'  <node pkg="arm" exec="{{0}}" name="{{0}}" namespace="$(var ns)"\n    {log}/>\n'
    container = f'  <node_container name="all"\n    namespace="$(var ns)" {log}/>\n'
    texts = (node.format("reach") + node.format("watch"), node.format("watch"))
    old, new = (f"<launch>\n{text}{container}</launch>\n" for text in texts)
    mine, wanted = (text.replace('"screen"', '"log"') for text in (old, new))
    sides = ({"launch/a.launch.xml": File(encode(text))} for text in (mine, old, new))
    result, doubts = Versions(*sides).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["launch/a.launch.xml"].text == wanted


def test_end_of_a_condition_that_stands_where_one_was_taken_away():
    rest = "\n  if(C)\n    set(c 1)\n  endif()\n"
    old = f"if(A)\n\n  if(B)\n    set(a 1)\n    set(b 1)\n  endif()\n{rest}endif()\n"
    mine = f"if(A)\n\n  set(a 1)\n  set(b 1)\n{rest}endif()\n"
    trees = [{"CMakeLists.txt": File(encode(one))} for one in (mine, old, old.replace(rest, ""))]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts, result.missing) == ([], {}, {})
    assert result.tree["CMakeLists.txt"].text == mine.replace(rest, "")


def test_commands_may_be_in_capitals():
    """As cmake-format writes them; what comes, leaves or gets another name is not in conflict."""
    old = "project(arm)\n\nif(TESTING)\n  add_executable(reach a.cpp)\nendif()\n"
    for new in (
        old.replace("a.cpp", "b.cpp"),
        old.replace("  add", "  find_package(b)\n  add"),
        old.replace("(arm)", "(robot)"),
        "project(arm)\n",
    ):
        mine = re.sub(r"\w+(?=\()", lambda command: command[0].upper(), old)
        sides = ({"CMakeLists.txt": File(encode(text))} for text in (mine, old, new))
        result, doubts = Versions(*sides).merged()
        assert (doubts, result.conflicts, result.missing) == ([], {}, {})
        assert result.tree["CMakeLists.txt"].text.lower() == new.lower()


ASIDES = {
    "a.yaml": ("/**:\n  ros__parameters:\n", "    # {}, m\n    reach: 1.0\n", "    rate: 1\n"),
    "a.hpp": ("struct Config\n{\n", "  /// {}, m\n  double reach = 1.0;\n", "};\n"),
    "a.py": ("class Config:\n", "    # {}, m\n    reach: float = 1.0\n", "    b: int = 1\n"),
    "b.py": ("class Config:\n", '    """{}."""\n\n    reach: float = 1.0\n', "    b: int = 1\n"),
    "c.py": (
        "class A:\n",
        '    def a(self):\n        """{}."""\n        return 1.0\n',
        "    b = 1\n",
    ),
    "CMakeLists.txt": ("project(a)\n", "install(FILES\n  # {}\n  1.0\n)\n", "ament_package()\n"),
    "table.md": ("# a\n\n", "| {} |\nIt takes 1.0 s.\n", "\n# b\n"),
    "fence.md": ("# a\n\n", "```\n{}\n```\nIt takes 1.0 s.\n", "\n# b\n"),
}


@pytest.mark.parametrize("value", ["1.0", "2.0"])
@pytest.mark.parametrize("path", ASIDES)
def test_what_the_developer_has_deleted_may_be_reworded(path, value):
    """A comment, table or diagram stays away, whether or not what is beside it changes."""
    head, item, tail = ASIDES[path]
    old = head + item.format("How far") + tail
    new = head + item.format("The distance that it goes").replace("1.0", value) + tail
    mine = re.sub(r"(?m)^.*(How far|```).*\n", "", old)
    result, doubts = Versions(*({path: File(encode(one))} for one in (mine, old, new))).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree[path].text == mine.replace("1.0", value)


@pytest.mark.parametrize(
    "own", ["        one()\n        two()\n", "        # Mine\n        one()\n"]
)
def test_code_in_the_place_of_a_docstring_stays_where_the_model_rewords_that(own):
    old = (
        'class A:\n    def a(self):\n        """\n        How far.\n\n        In m.\n        """\n'
    )
    mine = old.partition('        """')[0] + own
    trees = (mine, old, old.replace("How far", "The distance"))
    result, doubts = Versions(*({"a.py": File(encode(one))} for one in trees)).merged()
    assert (doubts, result.conflicts, result.tree["a.py"].text) == ([], {}, mine)


@pytest.mark.parametrize(
    ("item", "made"), [("- c: go\n", ""), ("- c: go\n", "- c: goes\n- d: stops\n")]
)
def test_words_in_the_place_of_a_list_stay_where_the_model_changes_that(item, made):
    old = "# Arm\n\n## The logic\n\nIn `a.py`:\n\n- a: is\n- b: was\n- c: go\n\nMore.\n"
    mine = re.sub("In .*go\n", "See the wiki.\n", old, flags=re.DOTALL)
    trees = (mine, old, old.replace(item, made))
    result, doubts = Versions(*({"a.md": File(encode(one))} for one in trees)).merged()
    assert (doubts, result.conflicts, result.tree["a.md"].text) == ([], {}, mine)


def test_comment_of_the_model_comes_where_the_developer_has_deleted_another():
    old = "def f():\n    # One\n    one()\n    two()\n"
    mine = old.replace("    # One\n", "")
    new = old.replace("    two", "    # Two\n    two")
    trees = ({"a.py": File(encode(one))} for one in (mine, old, new))
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["a.py"].text == new.replace("    # One\n", "")


@pytest.mark.parametrize("sign", ["//!", "/*!"])
def test_comments_may_have_the_other_form_that_doxygen_reads(sign):
    old = "class A\n{\n  /// Load.\n  void load();\n\n  /// Stop.\n  void stop();\n};\n"
    new = old.replace("};", "\n  /// Go.\n  void go();\n};")
    mine = re.sub("///(.*)", rf"{sign}\1" + " */" * (sign[1] == "*"), old)
    result, doubts = Versions(*({"a.hpp": File(encode(one))} for one in (mine, old, new))).merged()
    assert (doubts, result.conflicts, result.missing) == ([], {}, {})


def test_comment_that_the_developer_has_reworded_too_is_a_conflict():
    """As one of those that are left, beside one that was deleted."""
    old = "class Config:\n    # How far\n    # How fast\n    reach: float = 1.0\n"
    mine = old.replace("    # How far\n", "").replace("fast", "quickly")
    new = old.replace("far", "distant").replace("fast", "swiftly")
    trees = ({"a.py": File(encode(one))} for one in (mine, old, new))
    assert Versions(*trees).merged()[0].conflicts


@pytest.mark.parametrize("made", ["from arm.reach_interface", "from .reach_interface"])
@pytest.mark.parametrize("has_left", [True, False])
def test_own_code_may_have_a_type_that_has_left_but_none_that_is_there_to_be_imported(
    made, has_left
):
    interface = "class LoadRequest: ...\n\n\nclass StoreRequest: ...\n"
    old = f"{made} import (\n    LoadRequest,\n    StoreRequest,\n)\n\n\nclass ReachImpl:\n"
    for name in ("load", "store"):
        old += f"    def serve_{name}(self, request: {name.title()}Request): ...\n\n"
    own = "    def keep(self, request: StoreRequest):\n        self.kept = request\n"
    new = re.sub(".*[Ss]tore.*\n\n?", "", old)
    left = interface.replace("Store", "Other") if has_left else interface
    files = ((old + own, interface), (old, interface), (new, left))
    sides = ({PATH: one, "arm/reach_interface.py": other} for one, other in files)
    result, doubts = Versions(*map(tree_of, sides)).merged()
    assert (doubts, [*result.conflicts]) == ([], [] if has_left else [PATH])
    assert (result.tree[PATH].text == new + own) == has_left


def test_one_windows_line_end_makes_no_conflict():
    old = "class A:\n    def a(self):\n        return True\n\n    def c(self):\n        return 1\n"
    new = old.replace("    def c", "    def b(self):\n        return 3\n\n    def c")
    texts = (old.replace("True\n", "True\r\n"), old, new)
    result, doubts = Versions(*({"a.py": File(encode(text))} for text in texts)).merged()
    assert (doubts, [*result.conflicts]) == ([], [])


@pytest.mark.parametrize("head", ["[[gnu::cold]] void A::load(", "void\nA::load("])
@pytest.mark.parametrize("turned", [False, True])
def test_head_of_a_function_that_a_branch_writes_in_another_way(head, turned):
    source = "void A::load(int a)\n{\n}\n\nvoid A::cleanup()\n{\n}\n"
    header = "class A\n{\npublic:\n  void load(int a);\n\n  void cleanup();\n};\n"
    sides = source.replace("cleanup()\n{", "cleanup()\n{\n  release();"), source, source
    sides = [*sides[:2], source.replace("void A::load(", head)][:: -1 if turned else 1]
    files = [
        {"src/a.cpp": File(encode(text)), "include/a.hpp": File(encode(header))} for text in sides
    ]
    result, doubts = Versions(*files, of_people=True).merged()
    assert (doubts, [*result.conflicts]) == ([], [])
