"""Files as developers write them, read as blocks: each side's change is in the merged file."""

import ast
import random
import re
from itertools import pairwise
from pathlib import Path

import pytest

from hooks.merge.blocks import every
from hooks.merge.languages import CPP, MARKDOWN, PYTHON, language
from hooks.merge.package import merge_package
from hooks.merge.proof import prove
from hooks.merge.python_blocks import parse
from hooks.merge.recount import recount
from hooks.merge.renaming import Renaming
from hooks.merge.settings import places
from hooks.merge.tree import File, encode
from hooks.merge.versions import Versions
from support.laboratory.trials import tree_of


def merge(path, mine, old, new):
    """Merge a file; say whether it is in conflict, and what it is."""
    trees = [{path: File(encode(text))} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    if not result.conflicts:
        assert prove(*trees[:2], result, result.tree, Renaming()).lost == []
    return not result.conflicts, result.tree[path].text, result


def changed(text, *changes):
    for before, after in changes:
        assert text.count(before) == 1, (before, text)
        text = text.replace(before, after)
    return text


HPP = """#ifndef ARM__WORKER_IMPL_HPP_
#define ARM__WORKER_IMPL_HPP_

#include "arm/worker_interface.hpp"

namespace arm
{

class WorkerImpl
{
public:
  // Prepare the logic; return whether that worked
  bool configure(const WorkerConfig & config);

  // Service load
  void serve_load(Request & request);

  // Service reset
  void serve_reset(Request & request);

private:
  int mine_ = 0;
};

}  // namespace arm

#endif  // ARM__WORKER_IMPL_HPP_
"""
CPP_FILE = """#include "arm/worker_impl.hpp"

namespace arm
{

bool WorkerImpl::configure(const WorkerConfig & config)
{
  return true;
}

// Service load
void WorkerImpl::serve_load(Request & request)
{
}

// Service reset
void WorkerImpl::serve_reset(Request & request)
{
}

}  // namespace arm
"""
PY = '''"""The logic of worker."""

from arm.worker_interface import WorkerConfig, WorkerData


class WorkerImpl:
    """The logic."""

    # Service load
    def serve_load(self, request):
        """Load."""
        return True

    # Service reset
    def serve_reset(self, request):
        """Reset."""
        return True
'''
NO_RESET = {
    "hpp": ("  // Service reset\n  void serve_reset(Request & request);\n\n", ""),
    "cpp": ("// Service reset\nvoid WorkerImpl::serve_reset(Request & request)\n{\n}\n\n", ""),
}
HOME = {
    "hpp": (
        "\nprivate:",
        "\n  // Service home\n  void serve_home(Request & request);\n\nprivate:",
    ),
    "cpp": (
        "}  // namespace arm",
        "// Service home\nvoid WorkerImpl::serve_home(Request & request)\n{\n}\n\n}"
        "  // namespace arm",
    ),
    "py": ("WorkerConfig, WorkerData", "Home, WorkerConfig, WorkerData"),
}
SOURCES = {"hpp": HPP, "cpp": CPP_FILE, "py": PY}

STAYS = {
    "indented conditional above": (
        "hpp",
        ("  // Service reset", "  #ifdef TRACE\n  int traced_;\n  #endif\n  // Service reset"),
    ),
    "empty indented conditional above": (
        "hpp",
        ("  // Service reset", "  #ifdef TRACE\n  #endif\n  // Service reset"),
    ),
    "nested conditional above": (
        "hpp",
        (
            "  // Service reset",
            "  # if A\n    #ifdef B\n  int b_;\n    #endif\n  # endif\n\n  // Service reset",
        ),
    ),
    "macro above": ("cpp", ("// Service reset", "ARM_TRACE(reset)\n\n// Service reset")),
    "macro without brackets": ("hpp", ("public:", "  Q_OBJECT\n\npublic:")),
    "attribute": (
        "cpp",
        ("// Service load", "__attribute__((hot)) void mine()\n{\n}\n\n// Service load"),
    ),
    "comment with a brace": ("cpp", ("// Service reset", "// mine: {\\\n }\n\n// Service reset")),
    "code that is off": (
        "cpp",
        ("// Service reset", "#if 0\nvoid off() {\n#endif\n\n// Service reset"),
    ),
    "branches of one head": (
        "cpp",
        (
            "// Service load\nvoid WorkerImpl::serve_load(Request & request)\n{\n",
            "// Service load\n#ifdef A\nvoid WorkerImpl::serve_load(Request & request)\n{\n"
            "#else\nvoid WorkerImpl::serve_load(Request & request, int)\n{\n  int a;\n#endif\n",
        ),
    ),
    "branches without brace": (
        "cpp",
        (
            "// Service load\nvoid WorkerImpl::serve_load(Request & request)\n{\n",
            "// Service load\n#ifdef A\nvoid WorkerImpl::serve_load(Request & request)\n"
            "#else\nvoid WorkerImpl::serve_load(Request & request, int)\n#endif\n{\n",
        ),
    ),
    "brace in a branch of a body": (
        "cpp",
        (
            "  return true;\n",
            "#ifdef A\n  if (a) {\n#else\n  if (b) {\n#endif\n  }\n  return true;\n",
        ),
    ),
    "end of a statement in branches": (
        "cpp",
        (
            "// Service reset",
            "const int mine =\n#ifdef A\n  1;\n#else\n  2;\n#endif\n// Service reset",
        ),
    ),
    "nested namespaces in one line": (
        "cpp",
        (
            "// Service reset",
            "namespace a { namespace b {\nint c = 0;\nvoid d() {}\n}}\n\n// Service reset",
        ),
    ),
    "template": (
        "hpp",
        (
            "  // Service load",
            "  template<T t>\n  T mine(T one) {return one;}\n\n  // Service load",
        ),
    ),
    "exported class": ("hpp", ("class WorkerImpl", "class ARM_API WorkerImpl")),
    "aligned class": ("hpp", ("class WorkerImpl", "class alignas(8) WorkerImpl final")),
    "class with a base": (
        "hpp",
        ("class WorkerImpl", "class ARM_API(1) WorkerImpl : public Base<int>, private Other"),
    ),
    "reopened namespace": (
        "cpp",
        ("// Service reset", "}  // namespace arm\n\nnamespace arm\n{\n\n// Service reset"),
    ),
    "namespace reopened below own code": (
        "cpp",
        (
            "// Service reset",
            "}  // namespace arm\n\nstatic int mine() {return 1;}\n\n"
            "namespace arm\n{\n\n// Service reset",
        ),
    ),
}


@pytest.mark.parametrize(("suffix", "edit"), STAYS.values(), ids=STAYS)
@pytest.mark.parametrize("change", ["remove", "add", "both"])
def test_cpp_of_the_developer_stays_whole(suffix, edit, change):
    """It is the new version's file, but for the developer's edit."""
    old = SOURCES[suffix]
    changes = [NO_RESET[suffix]] if change != "add" else []
    changes += [HOME[suffix]] if change != "remove" else []
    new = changed(old, *changes)
    merges, found, result = merge(f"arm/worker_impl.{suffix}", changed(old, edit), old, new)
    assert merges
    assert (result.removed, result.missing) == ({}, {})
    before, after = edit
    kept = after if after in found else after.removesuffix(before).rstrip()
    assert kept in found
    assert found.replace(kept, before if after in found else "").split() == new.split()


PARTS_OF_CPP = {
    "ARM_API(1)\nvoid f();\nARM_API(2)\n\nvoid g();\n": ["f()", "ARM_API ( 2 )", "g()"],
    "ARM_API(1)\nclass A\n{\n};\n": ["ARM_API ( 1 )", "class A"],
    "ARM_API(1)\n#if A\n#endif\nARM_API(1)\n\n#if B\n#endif\n": [
        *("#if A", "then", "ARM_API ( 1 )", "#if B", "then")
    ],
    "namespace a\n{\nint b;\n}\nnamespace a {int c;}\nint d;\n": ["namespace a", "variable d"],
    "namespace a {int c;}\nnamespace a\n{\nint b;\n}\n": ["namespace a"],
    "namespace a\n{\nint b;\n}\nnamespace a\n{\nint c;\n}\n": [
        *("namespace a", "variable b", "{ namespace a", "variable c")
    ],
    "namespace a {\nnamespace b {\nint c;\n}}\n": ["namespace a", "variable c"],
    "namespace a\n{\nint b;\n}\nint d;\nnamespace a\n{\nint c;\n}\n": [
        *("namespace a", "variable b", "{ namespace a", "variable c")
    ],
    "namespace a\n{\nint b;\n}\n#if D\nnamespace a\n{\nint c;\n}\n#endif\n": [
        *("namespace a", "variable b", "#if D", "then", "namespace a", "variable c")
    ],
    **{
        f"#if A\nint b;\nint c;\n#endif\n{below}\n": [
            *("#if A", "then", "variable b", "variable c"),
            name,
        ]
        for below, name in (("#define D(e) (e)", "#define D(e) (e)"), ("::a::b d;", "variable d"))
    },
    "namespace a {int b;}\nint d;\nnamespace a\n{\nint c;\n}\n": [
        *("namespace a", "variable d", "namespace a #2", "variable c")
    ],
    "namespace a { namespace b {\nint c;\n}\n}\n": ["namespace a", "variable c"],
    "namespace a {\nnamespace b {\nint c;\n}\nint d; }\n": ["namespace a"],
    "namespace a { int c;\nint d;\n}\n": ["namespace a"],
    "template<A a = A{}, class B>\nstruct C;\n": ["struct C"],
    "template<int a = (1 > 2), class B>\nstruct C;\n": ["struct C"],
    "template<int a = b[1 > 0], class B>\nstruct C;\n": ["struct C"],
    "int a;\nARM_END(1)\n": ["variable a", "ARM_END ( 1 )"],
    "int a;\nARM_END\n": ["variable a", "ARM_END"],
    "namespace a\n{\nARM_END\n}\n": ["namespace a", "ARM_END"],
    "ARM_A(1)\nARM_B(2)\nvoid f();\n": ["ARM_A ( 1 )", "f()"],
    "ARM_API(\n  1\n)\nvoid f();\n": ["f()"],
    "ARM_API(\n  1\n)\n#if A\n#endif\n": ["#if A", "then"],
    "INT\n\nf();\n": ["f()"],
    "bool A::operator==(int b) const\n{\n}\nint operator()(int b);\n": [
        *("A::operator==()", "operator()()")
    ],
    "void A::STOP(int b)\n{\n}\n": ["A::STOP()"],
    "struct A b = {\n  1,\n  2\n};\nint c;\n": ["struct b", "variable c"],
    "void f()\n{\n}\nvoid f()\n{\n}\n": ["f()", "f() #2"],
    "namespace a\n{\nnamespace b\n{\nint c;\n}\n}\n": ["namespace a", "namespace b", "variable c"],
    "A::A() : b{1}\n{\n}\nint c;\n": ["A::A()", "variable c"],
    "enum class A\n{\n  B,\n  C\n};\nint d;\n": ["class A", "variable d"],
    "inline namespace a\n{\n}\nint b;\n": ["inline namespace a", "variable b"],
    "struct A {\n  signals a;\n};\nint b;\n": ["struct A", "variable a", "variable b"],
    "ARM(a)\n: b(a)\n{\n}\nint c;\n": ["ARM ( a )", "variable c"],
    "#if 0\nvoid f()\n{\n#else\nvoid g()\n{\n#endif\n}\nint c;\n": ["g()", "variable c"],
    **{
        f"ARM_F(a)\n\n{word}\n{{\n}}\n": [f"ARM_F ( a ) {word}"]
        for word in "const noexcept override final throw mutable volatile".split()
    },
}


@pytest.mark.parametrize(("text", "names"), PARTS_OF_CPP.items())
def test_parts_of_cpp(text, names):
    """Only what has lines of its own is one; a macro is no more than the line below it."""
    assert [block.key for block in every(CPP.blocks(text))] == names


@pytest.mark.parametrize("letter", ["a", "ü", "😀", "\udcfc"])
def test_place_of_an_expression_below_and_behind_any_letters(letter):
    """The last one is a byte of another encoding."""
    text = f"# {letter}\nuse('{letter}', x='y')\n"
    (statement,) = parse(text).body
    start, end = places(text)(statement.value.keywords[0].value)
    assert text[start:end] == "'y'"


REMOVED = {
    "attribute": "__attribute__((hot)) void",
    "attribute of the standard": "[[gnu::hot]] void",
    "macro with brackets": "ARM_API(1) void",
    "macro": "ARM_API void",
    "macro on its own line": "ARM_API(1)  // traced\nvoid",
    "specifier": "__declspec(dllexport) void",
}


@pytest.mark.parametrize("head", REMOVED.values(), ids=REMOVED)
@pytest.mark.parametrize("suffix", ["hpp", "cpp"])
def test_function_in_cpp_leaves_with_what_stands_before_it(suffix, head):
    old = SOURCES[suffix]
    before, _ = NO_RESET[suffix]
    mine = changed(old, (before, before.replace("void", head)))
    merges, found, result = merge(f"arm/worker_impl.{suffix}", mine, old, old.replace(before, ""))
    assert merges
    assert "serve_reset(" not in found
    assert [*result.removed.values()] == [
        ["WorkerImpl::serve_reset" * (suffix == "cpp") or "serve_reset"]
    ]


def reset_leaves(suffix, form):
    """Return a file that a function has left; `form` makes the developer's of its two parts."""
    old = SOURCES[suffix]
    before, _ = NO_RESET[suffix]
    *above, rest = before.rpartition("// Service reset\n")
    mine = changed(old, (before, form("".join(above), rest)))
    merges, found, result = merge(f"arm/worker_impl.{suffix}", mine, old, old.replace(before, ""))
    assert merges
    assert "reset" not in found
    assert [name.endswith("serve_reset") for names in result.removed.values() for name in names]
    return found


@pytest.mark.parametrize("suffix", ["hpp", "cpp"])
@pytest.mark.parametrize("macro", ["", "ARM_HOT\n"])
def test_comment_above_the_condition_around_a_function_leaves_with_it(suffix, macro):
    found = reset_leaves(
        suffix, lambda above, rest: f"{above}{macro}#if 1\n{rest.rstrip()}\n#endif\n\n"
    )
    assert f"{macro}#if 1\n#endif\n" in found


@pytest.mark.parametrize("suffix", ["hpp", "cpp"])
def test_comment_leaves_that_a_line_parts_from_the_condition_around_its_function(suffix):
    found = reset_leaves(
        suffix, lambda above, rest: f"{above}int mine;\n#if 1\n{rest.rstrip()}\n#endif\n\n"
    )
    assert "int mine;\n#if 1\n#endif\n" in found


@pytest.mark.parametrize("around", ["{}", "#if 1\n{}#endif\n\n"])
@pytest.mark.parametrize("suffix", ["hpp", "cpp"])
def test_comment_leaves_with_its_function_where_a_line_parts_them(suffix, around):
    """The line is the function's then: it leaves, too, and the summary says so."""
    found = reset_leaves(suffix, lambda above, rest: around.format(f"{above}int mine;\n{rest}"))
    assert "int mine;\n" not in found


GUARD = "#ifndef ARM__WORKER_IMPL_HPP_\n"
DEFAULT = "#ifndef RATE\n#define RATE 10\n#endif\n"
INCLUDE = '#include "arm/worker_interface.hpp"\n'
CLASS = "class WorkerImpl\n"
AROUND_GUARDS = {
    "code before it": (GUARD, f"int mine;\n{GUARD}"),
    "a default before it": (GUARD, DEFAULT + GUARD),
    "a comment behind its name": (GUARD, f"{GUARD[:-1]}  // mine\n"),
    "a comment behind an include": (INCLUDE, f"{INCLUDE[:-1]}  // IWYU pragma: keep\n"),
}


@pytest.mark.parametrize("edit", AROUND_GUARDS.values(), ids=AROUND_GUARDS)
@pytest.mark.parametrize("is_mine", [True, False])
def test_what_is_written_around_the_guard_of_a_header_parts_nothing_in_it(edit, is_mine):
    other = (CLASS, f"int other;\n\n{CLASS}")
    mine, new = changed(HPP, edit), changed(HPP, other)
    sides = (mine, HPP, new) if is_mine else (new, HPP, mine)
    merges, found, _ = merge("arm/worker_impl.hpp", *sides)
    assert merges
    assert found == changed(HPP, edit, other)


IMPORT = "from arm.worker_interface import WorkerConfig, WorkerData\n"
IMPORTS = {
    "try": "try:\n    {}except ImportError:\n    WorkerConfig = WorkerData = None\n",
    "try, else": "try:\n    {}except E:\n    raise\nelse:\n    A = 1\nfinally:\n    B = 1\n",
    "if": "if True:\n    {}",
    "if, else": "if True:\n    {}else:\n    WorkerConfig = None\n",
    "with": "with suppress(ImportError):\n    {}",
    "type checking": "if TYPE_CHECKING:\n    {}elif A:\n    B = 1\n",
    "nested": "if True:\n    try:\n        {}    finally:\n        A = 1\n",
    "relative": "from .worker_interface import WorkerConfig, WorkerData\n",
    "wrapped": "from arm.worker_interface import (\n    WorkerConfig,\n    WorkerData,\n)\n",
    "relative in try": "try:\n    from .worker_interface import WorkerConfig, WorkerData\n"
    "except ImportError:\n    raise\n",
}


@pytest.mark.parametrize("form", IMPORTS.values(), ids=IMPORTS)
def test_import_in_python_gets_new_names_wherever_it_is(form):
    mine = changed(PY, (IMPORT, form.format(IMPORT)))
    callback = "\n    # Service home\n    def serve_home(self, request):\n        return Home()\n"
    new = changed(PY, HOME["py"]) + callback
    merges, found, result = merge("arm/worker_impl.py", mine, PY, new)
    assert merges
    assert result.missing == {}
    assert found.count("Home") == 2
    assert found.count("worker_interface import") == 1
    assert "def serve_home" in found
    compile(found, "worker_impl.py", "exec")
    assert found.index("Home") < found.index("class WorkerImpl")


LONG = "from arm.reach_interface import (\n    Load,\n    Reach,\n)\n\nuse(Load, Reach)\n"
ONE_EACH = "from arm.reach_interface import Load\nfrom arm.reach_interface import Reach\n"
IN_LINES = LONG[: LONG.index("\n\n") + 1]
IN_A_LINE = "from arm.reach_interface import "
LAYOUTS = {
    "one import for each": (IN_LINES, ONE_EACH),
    "comment": ("    Reach,\n", "    Reach,  # noqa\n"),
    "comment above": ("    Reach,\n", "    # mine\n    Reach,\n"),
    "another name": ("    Reach,\n", "    Reach as R,\n    Reach,\n"),
    "other order": ("    Load,\n    Reach,\n", "    Reach,\n    Load,\n"),
    "in a line": (IN_LINES, f"{IN_A_LINE}Load, Reach\n"),
    "in a line, with a comment": (IN_LINES, f"{IN_A_LINE}Load, Reach  # noqa: F401\n"),
    "in a line, with their own": (IN_LINES, f"{IN_A_LINE}Load, Reach, zoom\n"),
    "in a line, without one": (IN_LINES + "\n", f"{IN_A_LINE}Reach, zoom\nLoad = 1\n\n"),
    "in a line, with another name": (IN_LINES, f"{IN_A_LINE}Load, Reach, Reach as R\n"),
    "in two lines": (IN_LINES, f"{IN_A_LINE}(Load,  # mine\n    Reach, zoom)\n"),
    "in lines of its own and others'": (IN_LINES, f"{IN_A_LINE}Load\n{IN_A_LINE}Reach, zoom\n"),
    "without one": ("    Load,\n    Reach,\n)\n\n", "    Reach,\n)\nLoad = 1\n\n"),
}
OF_THE_MODEL = {
    "first": ("    Load,\n", "    Halt,\n    Load,\n"),
    "between": ("    Load,\n", "    Load,\n    Move,\n"),
    "last": ("    Reach,\n", "    Reach,\n    Stop,\n"),
}


@pytest.mark.parametrize("change", OF_THE_MODEL.values(), ids=OF_THE_MODEL)
@pytest.mark.parametrize("edit", LAYOUTS.values(), ids=LAYOUTS)
def test_import_gets_names_whatever_the_developer_made_of_it(edit, change):
    name = ({*change[1].split()} - {*change[0].split()}).pop().strip(",")
    mine, new = changed(LONG, edit), changed(LONG, change).replace("use(", f"use({name}, ")
    trees = [{"arm/reach_impl.py": File(encode(text))} for text in (mine, LONG, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts, result.missing) == ([], {}, {})
    found = result.tree["arm/reach_impl.py"].text
    before, after = (imported(text) for text in (mine, found))
    assert after == sorted([*before, name])
    assert ("import (" in found) == ("import (" in mine)
    assert all(comment in found for comment in re.findall("#.*", mine))
    assert all(line in found for line in mine.splitlines() if re.match(r"    \w+,$|\w+ =", line))


def test_import_in_a_line_stays_in_one_below_an_empty_line():
    old, new, mine = (
        f"import os\n\nfrom arm.x import {names}\n" for names in ("a, b", "c, b", "a, b, d")
    )
    trees = [tree_of({"arm/tools.py": text}) for text in (mine, old, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.tree["arm/tools.py"].text) == ([], mine.replace("a, b, d", "b, c, d"))


@pytest.mark.parametrize("edit", ["Load, Reach", "Load, Reach, zoom"])
def test_import_of_a_module_that_is_elsewhere_now_keeps_the_names_of_the_developer(edit):
    form = "from {}.harness import {}\n\nuse({})\n"
    old, new = (form.format(of, "Load, Reach", "Load, Reach") for of in ("support", "a.testing"))
    mine = form.format("support", edit, edit.strip("()"))
    trees = [{"test/test_reach.py": File(encode(text))} for text in (mine, old, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["test/test_reach.py"].text == mine.replace("support", "a.testing")


def test_message_of_another_package_takes_along_no_name():
    """A topic has another type of the same name."""
    form = "from {}.msg import {}\n\nuse(Load)\n"
    old, new = (form.format(of, "Load") for of in ("std_msgs", "arm_msgs"))
    mine = form.format("std_msgs", "Load, String") + "use(String)\n"
    trees = [{"arm/reach.py": File(encode(text))} for text in (mine, old, new)]
    result, _ = Versions(*trees).merged()
    assert "from arm_msgs.msg import Load, String" not in result.tree["arm/reach.py"].text


@pytest.mark.parametrize("gone", ["Load", "Reach", "Zoom"])
@pytest.mark.parametrize("first", ["Load", "Reach, Load", "Load, Zoom"])
@pytest.mark.parametrize("condition", ["", "if TYPE_CHECKING:\n    "])
def test_name_leaves_whichever_import_of_its_module_has_it(condition, first, gone):
    old = LONG.replace("    Reach,\n", "    Reach,\n    Zoom,\n").replace("Reach)", "Reach, Zoom)")
    new = re.sub(rf"\b{gone}\b,?", "", old.replace(f"    {gone},\n", ""))
    rest = ", ".join(name for name in ("Load", "Reach", "Zoom", "own") if name not in first)
    mine = f"{IN_A_LINE}{first}\n{condition}{IN_A_LINE}{rest}\n" + old[old.index("\n\n") :]
    trees = [{"arm/reach_impl.py": File(encode(text))} for text in (mine, old, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    found = result.tree["arm/reach_impl.py"].text
    assert imported(found) == sorted({*imported(mine)} - {gone})
    assert found.count("import") == 2 - (first == gone)


def test_condition_leaves_with_all_that_it_imports_and_is_said():
    old = "from arm import A, B\n\nuse(A)\n"
    mine = "from arm import A\n\nif TYPE_CHECKING:\n    from arm import B\n\nuse(A)\n"
    texts = (mine, old, changed(old, (", B", "")))
    result, doubts = Versions(*({"a.py": File(encode(text))} for text in texts)).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.removed == {"a.py": ["if TYPE_CHECKING"]}
    assert result.tree["a.py"].text == texts[2]


def test_name_whose_import_the_developer_has_commented_leaves_and_is_said():
    old = "from arm import (\n    A,\n    B,\n)\n\nuse(A)\n"
    texts = (changed(old, ("    B,", "    B,  # mine")), old, changed(old, ("    B,\n", "")))
    result, doubts = Versions(*({"a.py": File(encode(text))} for text in texts)).merged()
    assert (doubts, result.conflicts, result.removed) == ([], {}, {"a.py": ["B"]})
    assert result.tree["a.py"].text == texts[2]


def test_name_that_has_an_import_of_its_own_leaves_unsaid():
    old = "from arm import (\n    A,\n    B,\n)\n\nuse(A)\n"
    mine = "from arm import A\nfrom arm import B\n\nuse(A)\n"
    texts = (mine, old, changed(old, ("    B,\n", "")))
    result, doubts = Versions(*({"a.py": File(encode(text))} for text in texts)).merged()
    assert (doubts, result.conflicts, result.removed) == ([], {}, {})
    assert result.tree["a.py"].text == changed(mine, ("from arm import B\n", ""))


@pytest.mark.parametrize("edit", [("A, B", "A, B"), ("A, B", "A, B, mine")])
def test_comment_of_the_model_behind_an_import_comes(edit):
    old = "from arm import A, B\n\nuse(A)\n"
    new = old.replace("A, B\n", "A, B, C  # noqa: F401\n")
    merges, found, _ = merge("arm/arm_impl.py", changed(old, edit), old, new)
    assert merges
    names = edit[1].replace("A, B", "A, B, C")
    assert found == f"from arm import {names}  # noqa: F401\n\nuse(A)\n"


@pytest.mark.parametrize(
    "own", ["import arm.reach_interface as ri", "from arm import reach_interface as ri"]
)
def test_new_names_are_imported_where_the_developer_imports_the_module(own):
    mine = LONG.replace(IN_LINES, f"{own}\n").replace("use(Load, Reach)", "use(ri.Load, ri.Reach)")
    new = changed(LONG, OF_THE_MODEL["between"]) + "\nuse(Move)\n"
    trees = [{"arm/reach_impl.py": File(encode(text))} for text in (mine, LONG, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    found = result.tree["arm/reach_impl.py"].text
    assert imported(found) == imported(f"{own}\n{IN_A_LINE}Move\n")
    assert found.endswith("use(ri.Load, ri.Reach)\n\nuse(Move)\n")


def imported(text):
    """Return the names that a text imports, and what it calls some of them."""
    nodes = (node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom))
    return sorted(ast.unparse(alias) for node in nodes for alias in node.names)


@pytest.mark.parametrize("end", ["...\n", "...\n# mine\n", "---\nmine: 1\n"])
def test_key_comes_before_the_end_of_its_document(end):
    mine, new = YAML_FILE + end, YAML_FILE + "    depth: 3\n"
    trees = [{"config/a.yaml": File(encode(text))} for text in (mine, YAML_FILE, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["config/a.yaml"].text == new + end


YAML_FILE = "/**:\n  ros__parameters:\n    rate: 1.0  # Hz\n    gain: 2.0\n"
ENDS = {
    "a.py": ('"""A."""\n\n\nclass A:\n    """A."""\n\n    b = 1\n', "    b = 1\n", "    c = 2\n"),
    "b.py": ("if True:\n    a = 1\n    b = 1\n", "    b = 1\n", "    c = 2\n"),
    "a.yaml": (YAML_FILE, "    gain: 2.0\n", "    limit: 3.0\n"),
    "a.hpp": (HPP, "  int mine_ = 0;\n", "  int other_ = 0;\n"),
    "package.xml": (
        "<package>\n  <name>arm</name>\n  <depend>a</depend>\n</package>\n",
        "  <depend>a</depend>\n",
        "  <depend>b</depend>\n",
    ),
    "CMakeLists.txt": (
        "project(arm)\nif(A)\n  find_package(b)\nendif()\n",
        "  find_package(b)\n",
        "  find_package(c)\n",
    ),
}


@pytest.mark.parametrize("path", ENDS)
@pytest.mark.parametrize("whose", ["mine", "new"])
@pytest.mark.parametrize("blank", ["\n", "\n\n", "   \n"])
@pytest.mark.parametrize("change", ["add", "replace", "add before"])
def test_blank_line_at_the_end_of_a_file_is_no_conflict(path, whose, blank, change):
    old, item, other = ENDS[path]
    after = {"add": item + other, "replace": other, "add before": other + item}[change]
    sides = {"mine": old, "new": old}
    sides[whose] += blank
    sides["new"] = changed(sides["new"], (item, after))
    merges, found, _ = merge(path, sides["mine"], old, sides["new"])
    assert merges
    assert found.rstrip() == changed(old, (item, after)).rstrip()


OWN = {"comment": "{}# mine\n\n", "two": "{}# mine\n{}# mine too\n\n", "blank": "\n{}# mine\n\n"}


@pytest.mark.parametrize("own", OWN.values(), ids=OWN)
@pytest.mark.parametrize("path", ["a.yaml", "CMakeLists.txt", "package.xml"])
@pytest.mark.parametrize("change", ["remove", "add", "replace", "add before"])
def test_own_comment_above_a_generated_item_is_no_conflict(path, own, change):
    old, item, other = ENDS[path]
    margin = item[: len(item) - len(item.lstrip())]
    words = own.replace("{}", margin)
    if path == "package.xml":
        words = words.replace("# mine", "<!-- mine").replace("\n\n", " -->\n\n")
        words = words.replace("<!-- mine\n ", "<!-- mine -->\n ")
    new = {"remove": "", "add": item + other, "replace": other, "add before": other + item}
    new = changed(old, (item, new[change]))
    merges, found, _ = merge(path, changed(old, (item, words + item)), old, new)
    assert merges
    assert found.replace(words.strip(), "", 1).split() == new.split()
    if change == "remove":
        assert found == changed(old, (item, words.rstrip() + "\n"))


def test_own_comment_and_what_follows_it_keep_one_empty_line_between_items():
    """Where a new function comes after the comment, as after one that was commented out."""
    old = "class A:\n    def a(self):\n        pass\n\n    def z(self):\n        pass\n"
    last = "    def z("
    mine = changed(old, (last, f"    # def b(self):\n    #     pass\n\n{last}"))
    new = changed(old, (last, f"    def c(self):\n        pass\n\n{last}"))
    is_merged, found, _ = merge("a.py", mine, old, new)
    assert is_merged
    assert found == changed(mine, (last, f"    def c(self):\n        pass\n\n{last}"))


def test_function_that_leaves_has_the_name_of_one_that_stays():
    """The comment above both is then above the other one, which is no sign of which has left."""
    words = "// Reads a number, and says whether the text is one that can be read.\n"
    first = "bool read(int & value)\n{\n  value = 1;\n  return true;\n}\n\n"
    second = "bool read(double & value)\n{\n  return std::isfinite(value);\n}\n"
    old, new = words + first + second, words + second
    mine = changed(old, (second, f"// own\n{second}"))
    is_merged, found, result = merge("a.cpp", mine, old, new)
    assert (is_merged, found) == (True, f"{words}// own\n{second}")
    assert result.removed == {}


@pytest.mark.parametrize(
    ("path", "old", "item", "own", "change"),
    [
        (
            "a.py",
            "import a\n\nfrom b import (\n    c,\n)\n",
            "from b",
            "from a import b\n",
            ("c", "d"),
        ),
        ("a.hpp", "#include <a>\n\nclass A : B\n{\n};\n", "class A", "class C;\n", ("B", "D")),
        ("CMakeLists.txt", "project(a)\n\nadd(b)\n", "add", "set(c 1)\n", ("(b)", "(b c)")),
        ("a.yaml", "a: 1\n\nb: 2\n", "b", "c: 3\n", ("2", "4")),
        ("a.xml", "<a>\n\n  <b>1</b>\n</a>\n", "  <b>", "  <c/>\n", ("1", "2")),
    ],
)
def test_item_that_changes_keeps_to_what_the_developer_has_put_above_it(
    path, old, item, own, change
):
    mine, new = old.replace(item, own + item, 1), old.replace(*change)
    merges, found, _ = merge(path, mine, old, new)
    assert merges
    assert found == new.replace(item, own + item, 1)


def test_section_that_changes_keeps_the_empty_line_below_it_to_one_of_the_developer():
    old, own = "# Arm\n\n- a\n", "\n## Ours\n\nBe kind.\n"
    new = old.replace("- a", "- b")
    assert merge("a.md", old + own, old, new)[:2] == (True, new + own)


def test_empty_line_above_the_first_include_stays_when_that_leaves():
    old = "#define A\n\n#include <a>\n#include <b>\n\nvoid f();\n"
    new = changed(old, ("#include <a>\n", ""))
    is_merged, found, _ = merge("a.hpp", f"{old}// own\n", old, new)
    assert (is_merged, found) == (True, f"{new}// own\n")


LIST = """publishers:
  - name: speed
    type: std_msgs/msg/Float64
    qos: {depth: 10}
  - name: state
    type: std_msgs/msg/String
    qos: {depth: 10}
"""


@pytest.mark.parametrize("text", ["a: &x 1\nb:\n  - 2\n  - *x\n", "- &x 1\n- *x\n- 2\n"])
def test_aliases_in_a_list_are_where_they_are_written(text):
    blocks = language("a.yaml", text).blocks(text)
    assert "".join(block.text for block in blocks) == text


PARTS = [
    ["\n---\na: 1\n", "---\nb: 2\n"],
    ['a: "x\n# y"\n', "b: |\n  1\n", "\n# c\nc: 2\n"],
    ["\na:\n", "  b: 1\n", "  # b\n", "# c\nc: 2\n", "...\n"],
    ["a:\n  {b: 1,\n  c: 2}\n", "d: &d\n", "  e: 1\n", "f: *d\n"],
    ["&x a:\n  - *x\n  - 2\n"],
    ["- &x a: 1\n- *x\n"],
    ["- - a\n", "  - b\n", "- c: 1\n", "  d: 2\n", "- ? e\n  : 3\n", "- f\n"],
]


@pytest.mark.parametrize("parts", PARTS)
def test_parts_of_yaml(parts):
    """Each key has the lines below it, and the comment above; what shares a line is one part."""
    blocks = language("a.yaml", "").blocks("".join(parts))
    assert ["".join(block.lines) for block in every(blocks)] == parts


NAMES = {
    "a: &x 1  # y\n? [b, c]\n: 2\n": ["a", "? [b, c] : 2"],
    "- &x a  # b\n- c\n  d\n- a\n- a\n": ["- &x a", "- c d", "- a", "- a #2"],
    "- a: 1\n  b: 2\n- c: {d: 1,\n      e: 2}\n": ["- a: 1", "- c: {d: 1, e: 2}"],
    "\n- - a  # b\n  - c\n-\n  d: 1\n": ["- - a", "d: 1"],
    "- &x a\n- b: *x  # b\n  c: 1\n- d: *x\n": ["- &x a", "- b: *x", "- d: *x"],
}


@pytest.mark.parametrize(("text", "names"), NAMES.items())
def test_names_of_parts_of_yaml(text, names):
    """A key by itself; a member of a list by its first line, but for a comment."""
    assert [block.key for block in language("a.yaml", "").blocks(text)] == names


def test_members_of_a_list_are_known_by_their_first_entries():
    """What a member says of itself changes within it, whichever is before it."""
    state = "  - name: state\n    type: std_msgs/msg/String\n"
    mine = changed(LIST, (state, f"{state}    description: mine\n"))
    new = changed(LIST, ("Float64\n    qos: {depth: 10}", "Float32\n    qos: {depth: 5}"))
    new = changed(new, ("String\n    qos: {depth: 10}", "String\n    qos: {depth: 1}"))
    other = "  - name: rate\n    type: std_msgs/msg/Int8\n"
    new = changed(new, ("  - name: state", f"{other}  - name: state"))
    merges, found, _ = merge("a.yaml", mine, LIST, new)
    assert merges
    assert found == changed(new, (state, f"{state}    description: mine\n"))


@pytest.mark.parametrize(
    "edit",
    [
        ("  - name: scan\n", "  - name: scan\n    # mine\n\n"),
        ("  - name: scan\n", "  - name: scan  # mine\n"),
        ("  - name: scan\n", "  - name: scan\n      # mine\n"),
        ("  - tool\n", "  - tool  # mine\n"),
    ],
)
@pytest.mark.parametrize("leaves", [True, False])
def test_a_comment_in_a_member_of_a_list_leaves_with_it_or_stays(edit, leaves):
    members = "  - name: scan\n    type: Scan\n  - name: map\n    type: Map\n"
    old = f"all:\n{members}used:\n  - tool\n  - arm\n"
    mine = changed(old, edit)
    gone = "  - name: scan\n    type: Scan\n" if "scan" in edit[0] else edit[0]
    base = changed(old, (gone, gone.replace("scan", "plan").replace("tool", "door")))
    new = base if leaves else changed(old, ("type: Map", "type: Grid"))
    merges, found, result = merge("a.yaml", mine, old, new)
    assert merges
    if leaves:
        assert found == new
        assert result.removed == {"a.yaml": ["- name: scan" if "scan" in gone else "- tool"]}
    else:
        assert found == changed(new, edit)


EMPTY_INSIDE = {
    "hpp": "  /* mine\n\n   * more\n   */\n",
    "cpp": "/* mine\n\n// mine, too\n\n*/\n",
    "package.xml": "  <!-- mine\n\n  <depend>c</depend> -->\n",
    "CMakeLists.txt": "  #[[ mine\n\n  find_package(d)\n  ]]\n",
}


@pytest.mark.parametrize("path", EMPTY_INSIDE)
@pytest.mark.parametrize("change", ["remove", "add before"])
@pytest.mark.parametrize("end", ["", "\n"])
def test_comment_with_empty_lines_stays_whole(path, change, end):
    """It is about the item below, or stands alone where an empty line parts it off."""
    if path in SOURCES:
        before, _ = NO_RESET[path]
        old, item, other = SOURCES[path], before, before.replace("reset", "other")
        name = f"arm/worker_impl.{path}"
    else:
        (old, item, other), name = ENDS[path], path
    own = EMPTY_INSIDE[path] + end
    mine = changed(old, (item, own + item))
    new = changed(old, (item, {"remove": "", "add before": other + item}[change]))
    merges, found, result = merge(name, mine, old, new)
    assert merges
    if change == "remove" and not end:
        assert (own in found, *result.removed) == (False, name)
    else:
        assert own.rstrip() in found
        assert found.replace(own.rstrip(), "").split() == new.split()


README = """# arm

Words.

## Use

```sh
# not a heading
ros2 run
```

## Interface

| name | type |
|---|---|
| load | Trigger |

## Licence

Apache
"""
LAST = ENDS | {
    "A.msg": ("float64 load\nfloat64 gain\n", "float64 gain\n", "float64 limit\n"),
    "A.srv": ("---\nfloat64 gain\n", "float64 gain\n", "float64 limit\n"),
    "B.msg": ("float64 gain\n", "float64 gain\n", "float64 limit\n"),
}


def test_parts_of_statements_in_python():
    """Each has a name of its own, that of the condition or the exception."""
    text = "if A:\n    a = 1\nelif B:\n    b = 1\nelif C:\n    c = 1\nelse:\n    d = 1\n"
    text += "try:\n    e = 1\nexcept E:\n    f = 1\nexcept:\n    g = 1\nelse:\n    h = 1\n"
    found = PYTHON.blocks(text + "finally:\n    i = 1\n")
    assert [(block.key, [part.key for part in block.children]) for block in found] == [
        ("if A", ["then", "elif B", "elif C", "else"]),
        ("try", ["then", "except E", "except", "else", "finally"]),
    ]


@pytest.mark.parametrize("path", LAST)
@pytest.mark.parametrize("change", ["remove", "add", "replace", "add before"])
def test_own_comment_below_a_generated_item_is_no_conflict(path, change):
    old, item, other = LAST[path]
    margin = item[: len(item) - len(item.lstrip())]
    sign = {"a.hpp": "// mine", "package.xml": "<!-- mine -->"}.get(path, "# mine")
    new = {"remove": "", "add": item + other, "replace": other, "add before": other + item}
    new = changed(old, (item, new[change]))
    mine = changed(old, (item, f"{item}{margin}{sign}\n"))
    merges, found, _ = merge(path, mine, old, new)
    assert merges
    assert found.replace(sign, "", 1).split() == new.split()


def test_own_comment_stays_with_the_field_that_changes_places():
    fields = [f"float64 {name}\n" for name in "abc"]
    old, new = "".join(fields), "".join(reversed(fields))
    merges, found, _ = merge("A.msg", old + "# mine\n", old, new)
    assert merges
    assert found == new.replace(fields[2], fields[2] + "# mine\n\n")


def test_own_field_of_a_response_stays_when_those_of_the_spec_leave():
    old, own = "float64 a\n---\nfloat64 b\nfloat64 c\n", "float64 mine\n"
    new = "float64 a\n---\n"
    for mine in (old + own, changed(old, ("float64 b\n", "float64 b\n" + own))):
        merges, found, _ = merge("A.srv", mine, old, new)
        assert merges
        assert found == new + own


FENCES = {
    "tildes": ("Words.\n", "Words.\n\n~~~sh\n## no heading\n```\n~~~\n"),
    "longer": ("Words.\n", "Words.\n\n````md\n```sh\n## no heading\n```\n## none\n````\n"),
    "indented": ("Words.\n", "Words.\n\n- a\n\n  ```sh\n  ## no heading\n  ```\n"),
    "in a line": ("Words.\n", "Words and ```code``` and\n``` more ``` words.\n"),
    "underlined": ("Words.\n", "Words.\n\nMine\n----\n\nMore words.\n"),
    "lines": ("Words.\n", "Words.\n\n---\n\n- a\n---\n\n| a |\n---\n\n```\nb\n---\n```\n---\n"),
    "own heading": ("## Interface\n", "## Interface\n\n### Notes\n\nMine.\n\n### Table\n"),
    "comment": ("Words.\n", "Words.\n\n<!--\n## no heading\n-->\n"),
    "changed heading": ("## Licence", "## Licence and thanks"),
}


@pytest.mark.parametrize("edit", FENCES.values(), ids=FENCES)
def test_markdown_of_the_developer_stays_whole(edit):
    row = ("| load | Trigger |\n", "| load | Trigger |\n| home | Trigger |\n")
    changes = (row, ("ros2 run\n", "ros2 launch\n"))
    merges, found, _ = merge("README.md", changed(README, edit), README, changed(README, *changes))
    assert merges
    assert found == changed(README, edit, *changes)


def test_line_that_looks_like_a_heading_in_a_comment_is_none():
    blocks = MARKDOWN.blocks("# A\n<!-- a\nb\n# B\n-->\n# C\n")
    assert [block.key for block in blocks] == ["# A", "# C"]


def test_heading_that_both_change_is_asked_once():
    mine, new = (changed(README, ("## Use", f"## {name}")) for name in ("How to", "Usage"))
    merges, found, _ = merge("README.md", mine, README, new)
    assert not merges
    assert found.count("ros2 run") == 1


BRACKETS = {
    "comment": "#[=[ if( ]=]\n",
    "comment of two lines": "#[[\nset(\n]]\n",
    "escaped": 'string(REGEX REPLACE a\\(b "" out ${in})\n',
    "argument": "set(MINE [=[ ) ]] ]=])\n",
    "quoted": 'set(MINE "a\\")")\n',
}


@pytest.mark.parametrize("own", BRACKETS.values(), ids=BRACKETS)
def test_brackets_of_cmake_are_read(own):
    old, item, other = ENDS["CMakeLists.txt"]
    mine = changed(old, ("project(arm)\n", "project(arm)\n" + own))
    new = changed(old, (item, item + other))
    merges, found, _ = merge("CMakeLists.txt", mine, old, new)
    assert merges
    assert found == changed(mine, (item, item + other))


LISTS = {
    "one line": ("ament_export_dependencies(\n  a\n  b\n)", "ament_export_dependencies(a b)"),
    "two lines": ("ament_export_dependencies(\n  a\n  b\n)", "ament_export_dependencies( a\n b )"),
    "options": ("  cfg/A.cfg\n)", "cfg/A.cfg)"),
}
PACKAGE = """project(arm)
generate_dynamic_reconfigure_options(
  cfg/A.cfg
)
catkin_package(
  INCLUDE_DIRS include
  CATKIN_DEPENDS
    a
)
ament_export_dependencies(
  a
  b
)
"""


@pytest.mark.parametrize("edit", LISTS.values(), ids=LISTS)
def test_list_of_cmake_that_was_laid_out_anew_gets_what_is_new(edit):
    changes = (("  a\n  b\n)", "  a\n  b\n  c\n)"), ("A.cfg\n", "A.cfg\n  cfg/B.cfg\n"))
    new = changed(PACKAGE, *changes)
    merges, found, result = merge("CMakeLists.txt", changed(PACKAGE, edit), PACKAGE, new)
    assert (merges, found, result.missing) == (True, new, {})


def test_commands_whose_arguments_have_lines_of_their_own_are_told_apart():
    """As gersemi lays them out: the name of a target is below that of the command."""
    parts = [f"add_library({n} SHARED\n  {n}.cpp\n)\nlink({n}\n  core\n)\n" for n in "abc"]
    old, new = "".join(parts[:2]), "".join(parts[1:])
    mine = re.sub(r"\((\w)( SHARED)?\n", "(\n  \\1\n \\2\n", old)
    merges, found, result = merge("CMakeLists.txt", mine, old, new)
    assert (merges, result.missing) == (True, {})
    assert found == mine[len(mine) // 2 :] + parts[2]


@pytest.mark.parametrize("own", ["CFG_EXTRAS arm.cmake", "LIBRARIES arm", "include_dirs mine"])
def test_keyword_that_the_developer_puts_first_hides_no_other(own):
    edit = ("catkin_package(\n", f"catkin_package(\n  {own}\n")
    new = changed(PACKAGE, ("    a\n", "    a\n    c\n"))
    merges, found, result = merge("CMakeLists.txt", changed(PACKAGE, edit), PACKAGE, new)
    assert (merges, found, result.missing) == (True, changed(new, edit), {})


@pytest.mark.parametrize("quoted", ['"a (b)"', "[[ (a) ]]"])
def test_blanks_in_an_argument_of_cmake_are_no_form(quoted):
    texts = (f"project(arm)\nmessage({text})\n" for text in (quoted, quoted.replace(" (", "(")))
    old, mine = (changed(PACKAGE, ("project(arm)\n", text)) for text in texts)
    new = changed(old, ("A.cfg\n", "A.cfg\n  cfg/B.cfg\n"))
    merges, found, _ = merge("CMakeLists.txt", mine, old, new)
    assert merges
    assert found == changed(mine, ("A.cfg\n", "A.cfg\n  cfg/B.cfg\n"))


def test_own_heading_stays_in_its_section_where_the_next_one_loses_its_table():
    edit = ("| Node |\n", "### Mine\n\n| Node |\n")
    new = changed(TABLES, ("| Topic |\n|---|\n| goal |\n| pose |\n", "It has none.\n"))
    trees = [{"README.md": File(encode(text))} for text in (changed(TABLES, edit), TABLES, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["README.md"].text == changed(new, edit)


def test_section_that_the_developer_deleted_stays_so_and_is_said():
    mine = TABLES[: TABLES.index("## Topics")]
    new = changed(TABLES, ("| pose |\n", "| pose |\n| joy |\n"), ("Moves.", "Turns."))
    trees = [{"README.md": File(encode(text))} for text in (mine, TABLES, new)]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["README.md"].text == changed(mine, ("Moves.", "Turns."))
    assert result.missing == {"README.md": ["## Topics"]}


HEADERS = Path("/usr/include")
MAX_HEADERS = 200


@pytest.mark.parametrize("library", ["boost", "eigen3", "gtest", "pcl", "ros", "tf2", "c++"])
def test_headers_of_others_can_be_read(library):
    """At most one in a hundred cannot; blocks are always the whole text."""
    files = sorted(
        file for file in (HEADERS / library).rglob("*.h*") if file.stat().st_size < 100_000
    )
    if not files:
        pytest.skip("not installed")
    files = random.Random(1).sample(files, min(len(files), MAX_HEADERS))
    unread = {}
    for file in files:
        text = file.read_text(errors="surrogateescape")
        try:
            CPP.blocks(text)
        except ValueError as error:
            unread[str(file)] = str(error)
    assert len(unread) <= len(files) / 100, unread


@pytest.mark.parametrize(
    ("path", "text", "why"),
    [
        ("a.cpp", "int a;\n#endif\n", "line 2: #endif, without its beginning"),
        ("a.cpp", "#if A\n", "line 1: #if A, without end"),
        ("a.hpp", "#ifndef A\n#define A\nint a;\n", "line 1: #ifndef A, without end"),
        ("a.cpp", "int a;\n}\n", "line 2: a brace that nothing opens"),
        ("a.cpp", "#if A\n}\n#endif\n", "line 1: a brace that nothing opens"),
        ("a.cpp", "namespace a\n{\n", "line 2: a brace that nothing closes"),
        ("a.cpp", "int f()\n{\n", "line 2: { that nothing closes"),
        ("CMakeLists.txt", "a()\nif(A)\n", "line 2: if(A), without end"),
        ("CMakeLists.txt", "a()\nendif()\n", "line 2: endif, without its beginning"),
        ("CMakeLists.txt", "if(A)\nendforeach()\n", "line 2: endforeach, without its beginning"),
        ("CMakeLists.txt", "a(\n", "a parenthesis that nothing closes"),
        ("CMakeLists.txt", "a())\n", "a parenthesis that nothing opens"),
        ("a.py", "def a(:\n", "invalid syntax (<unknown>, line 1)"),
        ("a.xml", "<a/></a>\n", "not well-formed (invalid token): line 1, column 5"),
        ("a.yaml", "a: 1\n b: 2\n", "mapping values are not allowed"),
    ],
)
def test_text_that_is_not_of_its_language(path, text, why):
    """It is merged by line, where it is the developer's."""
    with pytest.raises(ValueError, match="^" + re.escape(why)):
        language(path, text).blocks(text)


def test_elements_of_xml_that_an_entity_stands_for_are_no_blocks():
    text = '<!DOCTYPE a [\n  <!ENTITY e "<b>1</b>">\n]>\n<a>\n  <c/>\n</a>\n'
    (block,) = language("a.xml", text).blocks(text)
    assert (block.key, [inner.key for inner in block.children]) == ("a", ["c"])


def test_licence_with_a_file_is_the_licence():
    """Format 3 of package.xml has that attribute (REP 149)."""
    old = "<package>\n  <license>MIT</license>\n</package>\n"
    mine = old.replace("<license>", '<license file="LICENSE">')
    new = old.replace("</package>", "  <depend>rclpy</depend>\n</package>")
    files = [tree_of({"package.xml": text}) for text in (mine, old, new)]
    result, doubts = Versions(*files).merged()
    assert (doubts, result.missing) == ([], {})
    assert result.tree["package.xml"].text == new.replace("<license>", '<license file="LICENSE">')


def test_blocks_are_the_whole_text():
    for known, text in ((CPP, HPP), (PYTHON, PY), (MARKDOWN, README)):
        assert "".join(block.text for block in known.blocks(text)) == text
    assert language("a.hpp", "") is CPP


def test_guard_of_a_header_that_moves_is_one_guard():
    """What the developer has written below it stays below it."""
    old = HPP
    new = HPP.replace("ARM__WORKER_IMPL", "ARM__ROS__WORKER_IMPL")
    include = '#include "arm/worker_interface.hpp"\n'
    mine = changed(HPP, (include, f"#include <cmath>\n{include}"))
    is_merged, text, _ = merge("include/arm/worker_impl.hpp", mine, old, new)
    assert is_merged
    assert text == changed(new, (include, f"#include <cmath>\n{include}"))


def test_own_heading_before_a_table_does_not_part_its_section():
    old = "# Arm\n\n## Nodes\n\nAll.\n\n| Topic | |\n|---|---|\n| a | |\n| b | |\n"
    mine = changed(old, ("| Topic", "### Mine\n\n| Topic"))
    new = changed(old, ("| a | |", "| a | odd |"))
    is_merged, text, _ = merge("README.md", mine, old, new)
    assert is_merged
    assert text == changed(new, ("| Topic", "### Mine\n\n| Topic"))


@pytest.mark.parametrize(
    ("path", "text", "item"),
    [
        (
            "config/a.yaml",
            "/**:\n  a:\n    # Speed\n    b: 1\n    # Load\n    c: 2\n",
            "    b: 1\n",
        ),
        (
            "a.hpp",
            "struct A\n{\n  /// Speed\n  void f();\n\n  /// Load\n  int a;\n};\n",
            "  void f();\n",
        ),
        ("a.py", "class A:\n    # Speed\n    b = 1\n    # Load\n    c = 2\n", "    b = 1\n"),
    ],
)
@pytest.mark.parametrize("change", ["its comment", "it leaves"])
def test_own_comment_and_blank_line_between_an_item_and_its_comment(path, text, item, change):
    sign = {"hpp": "//"}.get(path[-3:], "#")
    own = f"    {sign} Mine\n\n"
    mine = changed(text, (item, own + item))
    start = text.index(text[text[: text.index(item) - 1].rindex("\n") + 1 : text.index(item)])
    comment = text[start : text.index(item)]
    new = changed(
        text, ("Speed", "The speed") if change == "its comment" else (comment + item, "")
    )
    is_merged, found, result = merge(path, mine, text, new)
    assert is_merged
    if change == "its comment":
        assert found == changed(new, (item, own + item))
    else:
        assert found.split() == new.split()
        assert result.removed


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("@skip('a', 'why')\nclass A(B):\n", '@skip(\n    "a", "why"\n)\nclass A(B):\n'),
        ("@skip('a', 'why')\n", '@skip(\n    "a", "why"\n)\n'),
        ("    if a('b'):\n", '    if a(\n        "b"\n    ):\n'),
    ],
)
def test_head_that_a_formatter_has_broken(one, other):
    """It is no code by itself; what it says counts, and not how it is written."""
    assert PYTHON.same(one, other)
    assert not PYTHON.same(one, other.replace('"', "'c", 1))
    assert not PYTHON.same(one, other.replace("(", "(c, ", 1))


TABLES = """# Arm

Moves.

## Nodes

```sh
run
```

| Node |
|---|
| reach |
| watch |

## Topics

```sh
echo
```

| Topic |
|---|
| goal |
| pose |
"""
HEADINGS = {
    "other words": ("## Topics\n", "## What it says\n"),
    "more words": ("## Nodes\n", "## Nodes (mine)\n"),
    "deeper": ("## Topics\n", "### Topics\n"),
    "of a section that changes": ("# Arm\n", "# My arm\n"),
    "words of another": ("## Topics\n", "## Nodes\n"),
    "underlined": ("## Topics\n", "Topics\n------\n"),
    "underlined, other words": ("## Topics\n", "What it says\n============\n"),
    "underlined title": ("# Arm\n", "Arm\n===\n"),
}


@pytest.mark.parametrize("edit", HEADINGS.values(), ids=HEADINGS)
@pytest.mark.parametrize("row", ["| reach |\n", "| watch |\n", "| goal |\n", "| pose |\n"])
def test_section_keeps_the_heading_that_the_developer_gave_it(edit, row):
    new = changed(TABLES, (row, ""), ("Moves.", "Turns."))
    merges, found, result = merge("README.md", changed(TABLES, edit), TABLES, new)
    assert merges
    assert found == changed(new, edit)
    assert not result.missing


def test_title_that_the_developer_gave_stays_and_what_is_below_it_changes():
    mine = changed(ARM, ("# Arm\n", "# My robot\n\n[![CI](ci.svg)](https://ci.example.org)\n"))
    words = ("Moves.", "Turns.")
    merges, found, result = merge("README.md", mine, ARM, changed(ARM, words))
    assert merges
    assert (found, result.missing) == (changed(mine, words), {})


ARM = "# Arm\n\nMoves.\n\n## Topics\n\n| a | |\n"


@pytest.mark.parametrize(
    ("row", "after"),
    [("| b | |\n", ""), ("| b | |\n", "| b | odd |\n"), ("| a | |\n", "| a | |\n| c | |\n")],
)
def test_table_that_a_formatter_has_aligned_changes_as_any_other(row, after):
    old = "# Arm\n\n| Topic | |\n|---|---|\n| a | |\n| b | |\n"
    new = changed(old, (row, after))
    aligned = {"| Topic | |": "| Topic |     |", "|---|---|": "| ----- | --- |"}
    aligned |= {f"| {name} | |": f"| {name}     |     |" for name in "ab"}
    sides = []
    for text in (old, new):
        lines = [aligned.get(line, line) for line in text.split("\n")]
        sides.append("\n".join(lines).replace("# Arm\n", "# Arm\n\nMine.\n"))
    trees = [{"README.md": File(encode(text))} for text in (sides[0], old, new)]
    result = Versions(*trees).merge({})
    assert (Versions(*trees).doubts(result), result.conflicts) == ([], {})
    assert result.tree["README.md"].text == sides[1]


ROWS = "# Arm\n\n| Topic | Type | |\n|---|---|---|\n| pose | a | |\n| goal | a | |\n"


@pytest.mark.parametrize(
    ("mine", "new", "wanted"),
    [
        ("| goal | a | mine |\n", "| goal | b | |\n", "| goal | b | mine |\n"),
        ("| goal | a | x \\| y |\n", "| goal | b | |\n", "| goal | b | x \\| y |\n"),
        (
            "| goal | a | mine |\n",
            "| goal | b | |\n| x | | |\n",
            "| goal | b | mine |\n| x | | |\n",
        ),
        ("| goal | a | mine |\n", "| goal | b | new |\n", None),
        ("| goal | a | mine | more |\n", "| goal | b | |\n", None),
    ],
)
def test_row_of_which_both_sides_have_changed_other_cells(mine, new, wanted):
    row = "| goal | a | |\n"
    texts = [ROWS.replace(row, mine), ROWS, ROWS.replace(row, new)]
    result, doubts = Versions(*({"a.md": File(encode(text))} for text in texts)).merged()
    assert (bool(result.conflicts), doubts) == (not wanted, [])
    assert not wanted or result.tree["a.md"].text == ROWS.replace(row, wanted)


def test_section_with_another_heading_leaves_and_is_said():
    new = TABLES[: TABLES.index("## Topics")]
    mine = changed(TABLES, ("## Topics", "## What it says"))
    merges, found, result = merge("README.md", mine, TABLES, new)
    assert merges
    assert found == new
    assert result.removed == {"README.md": ["## Topics"]}


def test_section_like_one_with_another_heading_that_leaves_stays_what_it_is():
    rows = "| goal |\n| pose |\n| joy |\n"
    old = f"# Arm\n\n## Inputs\n\n{rows}\n## Outputs\n\n{rows}| map |\n"
    new = old[: old.index("## Inputs")] + old[old.index("## Outputs") :]
    mine = changed(old, ("## Inputs", "## What it hears"), ("| map |", "| map (mine) |"))
    merges, found, result = merge("README.md", mine, old, new)
    assert merges
    assert found == changed(new, ("| map |", "| map (mine) |"))
    assert result.removed == {"README.md": ["## Inputs"]}
    new = old + old[old.index("## Inputs") : old.index("## Outputs")].replace("In", "Other in")
    merges, found, result = merge("README.md", mine, old, new)
    assert merges
    assert (
        found.split()
        == changed(new, ("## Inputs", "## What it hears"), ("map", "map (mine)")).split()
    )


PARAMETERS = "/**:\n  ros__parameters:\n    # Speed\n    speed: 1\n    gain: 2.0\n    rate: 3\n"


@pytest.mark.parametrize(
    "name",
    ["/robot/reach", "reach", "/**/reach", "# mine\n/**", "---\n/**", "%YAML 1.1\n---\n/**"],
)
@pytest.mark.parametrize("change", ["add", "remove", "describe"])
def test_parameters_change_below_the_name_that_the_developer_gave_them(name, change):
    edit = ("/**:", f"{name}:")
    changes = {
        "add": ("    rate: 3\n", "    rate: 3\n    limit: 4\n"),
        "remove": ("    # Speed\n    speed: 1\n", ""),
        "describe": ("# Speed", "# The speed"),
    }
    new = changed(PARAMETERS, changes[change])
    merges, found, _ = merge("config/reach.yaml", changed(PARAMETERS, edit), PARAMETERS, new)
    assert merges
    assert found == changed(new, edit)


def test_class_that_the_developer_calls_otherwise_gets_new_callbacks():
    edit, home = ("class WorkerImpl", "class MyWorker"), "\n    def serve_home(self):\n        1\n"
    merges, found, result = merge("arm/worker_impl.py", changed(PY, edit), PY, PY + home)
    assert merges
    assert found == changed(PY, edit) + home
    assert not result.missing


def test_function_in_cpp_that_names_its_namespace_is_what_it_was():
    mine = changed(CPP_FILE, ("WorkerImpl::serve_reset(", "arm::WorkerImpl::serve_reset("))
    words = ("// Service reset", "// The service reset")
    merges, found, result = merge("src/a.cpp", mine, CPP_FILE, changed(CPP_FILE, words))
    assert merges
    assert found == changed(mine, words)
    assert not result.missing
    gone = changed(CPP_FILE, NO_RESET["cpp"])
    merges, found, result = merge("src/a.cpp", mine, CPP_FILE, gone)
    assert merges
    assert found.split() == gone.split()
    assert result.removed == {"src/a.cpp": ["WorkerImpl::serve_reset"]}


SCOPES = {
    "named": ("", r"arm::\g<0>"),
    "used": ("using namespace arm;\n", r"\g<0>"),
}


@pytest.mark.parametrize(("line", "name"), SCOPES.values(), ids=SCOPES)
def test_functions_in_cpp_that_stand_in_no_namespace_are_what_they_were(line, name):
    """What is new comes in a namespace: the developer's functions may each name theirs."""

    def bare(text):
        text = changed(text, ("namespace arm\n{\n", line), ("}  // namespace arm\n", ""))
        return re.sub(r"WorkerImpl(?=::)", name, text)

    new = changed(CPP_FILE, HOME["cpp"])
    for text, gone in ((new, CPP_FILE), (CPP_FILE, changed(CPP_FILE, NO_RESET["cpp"]))):
        trees = [{"src/a.cpp": File(encode(one))} for one in (bare(text), text, gone)]
        result, doubts = Versions(*trees).merged()
        assert result.tree["src/a.cpp"].text.split() == bare(gone).split()
        assert (result.conflicts, result.missing, doubts) == ({}, {}, [])
    mine, old = bare(CPP_FILE), CPP_FILE
    for changes in ((HOME["cpp"],), (HOME["cpp"], NO_RESET["cpp"])):
        made = changed(CPP_FILE, *changes)
        trees = [{"src/a.cpp": File(encode(one))} for one in (mine, old, made)]
        result, doubts = Versions(*trees).merged()
        assert (result.conflicts, result.missing, doubts) == ({}, {}, [])
        mine, old = result.tree["src/a.cpp"].text, made
        assert re.search(r"(?s)namespace arm\s*\{.*WorkerImpl::serve_home", mine)
    assert "serve_reset" not in mine


ATTACHED = {
    "pragma": ("cpp", "#pragma omp parallel\n"),
    "two": ("cpp", "#pragma GCC push\n#pragma GCC ignored\n"),
    "condition": ("cpp", "#ifdef A\n[[gnu::hot]]\n#endif\n"),
    "macro": ("cpp", "#define LIMIT 1\n"),
    "statement": ("cpp", "int mine = 0;\n\n"),
    "member": ("hpp", "  int mine_ = 0;\n\n"),
    "variable": ("py", "    mine = 1\n\n"),
    "if": ("py", "    if DEBUG:\n        mine = 1\n\n"),
}
OWN_FUNCTIONS = {
    "function": ("cpp", "int mine()\n{\n  return 1;\n}\n\n"),
    "declaration": ("hpp", "  void mine();\n\n"),
    "method": ("py", "    def mine(self):\n        return 1\n\n"),
    "class": ("py", "    class Mine:\n        a = 1\n\n"),
}


def functions_of(suffix):
    """Return the generated functions `load` and `reset`, each with the comment above it."""
    text = SOURCES[suffix].rstrip("\n") + "\n\n"
    margin, sign = {"hpp": ("  ", "//"), "cpp": ("", "//"), "py": ("    ", "#")}[suffix]
    starts = [text.index(f"{margin}{sign} Service {name}") for name in ("load", "reset")]
    end = {"hpp": "private:", "cpp": "}  // namespace"}.get(suffix)
    starts.append(text.index(end) if end else len(text))
    return [text[start:until] for start, until in pairwise(starts)]


@pytest.mark.parametrize("change", ["remove", "add", "reorder"])
@pytest.mark.parametrize("name", [*ATTACHED, *OWN_FUNCTIONS])
def test_comment_stays_with_its_function_whatever_stands_between(name, change):
    """A function of the developer's is another thing, and stays; all else belongs to both."""
    suffix, own = (ATTACHED | OWN_FUNCTIONS)[name]
    load, reset = functions_of(suffix)
    comment, rest = reset.split("\n", 1)
    edited = f"{comment}\n{own}{rest}" if name in ATTACHED else f"{own}{reset}"
    new = {
        "remove": (load + reset, load),
        "add": (load + reset, load + load.replace("load", "home") + reset),
        "reorder": (load + reset, reset + load),
    }[change]
    old = SOURCES[suffix].rstrip("\n") + "\n\n"
    mine, new = changed(old, (reset, f"{comment}\n{own}{rest}")), changed(old, new)
    merges, found, result = merge(f"arm/a.{suffix}", mine, old, new)
    assert merges
    if change == "remove":
        wanted = new if name in ATTACHED else changed(new, (load, load + own))
        assert bool(result.removed) == (name in ATTACHED)
    elif name in ATTACHED or change == "add":
        wanted = changed(new, (reset, edited))
    else:
        wanted = changed(new, (load, load + own))
    assert sorted(found.split()) == sorted(wanted.split())
    assert found.split() == wanted.split() or name in OWN_FUNCTIONS


def test_function_that_the_developer_calls_otherwise_is_theirs():
    """What the new version says of the one that is no longer there is not looked for in it."""
    mine = changed(PY, ("def serve_load", "def fetch"))
    new = changed(PY, ('"""Load."""', '"""Load it."""'), ('"""Reset."""', '"""Reset it."""'))
    merges, found, result = merge("arm/a.py", mine, PY, new)
    assert merges
    assert found == changed(mine, ('"""Reset."""', '"""Reset it."""'))
    assert result.missing == {"arm/a.py": ["serve_load"]}
    trees = [{"arm/a.py": File(encode(text))} for text in (mine, PY, new)]
    assert recount(*trees, Renaming(), {""}.__contains__, result, result.tree, []) == []
