"""Three versions of a package in memory, merged: without Copier and git, so quickly."""

import itertools
import posixpath
import re

import pytest

from hooks.merge.merging import conflict
from hooks.merge.package import merge_package
from hooks.merge.proof import prove
from hooks.merge.recount import recount
from hooks.merge.renaming import Renaming
from hooks.merge.tree import EXECUTABLE, LINK, PLAIN, File
from hooks.merge.versions import Versions
from support.arm import MINE, NEW, OLD, PATH
from support.packages import changed

MERGED = MINE.replace("Fill in", "Complete")


def merge(mine, old, new, renaming=None, kept=""):
    """Merge a file given as bytes or as a whole."""
    sides = (s if isinstance(s, File) or s is None else File(s) for s in (mine, old, new))
    trees = [{PATH: side} if side else {} for side in sides]
    return merge_package(*trees, renaming or Renaming(), {kept}.__contains__)


@pytest.mark.parametrize(
    ("mine", "old", "new", "wanted"),
    [
        (EXECUTABLE, PLAIN, PLAIN, EXECUTABLE),
        (PLAIN, EXECUTABLE, EXECUTABLE, PLAIN),
        (PLAIN, PLAIN, EXECUTABLE, EXECUTABLE),
        (EXECUTABLE, EXECUTABLE, PLAIN, PLAIN),
    ],
)
def test_mode_is_merged(mine, old, new, wanted):
    sides = zip((MINE, OLD, NEW), (mine, old, new), strict=True)
    result = merge(*(File(text.encode(), mode) for text, mode in sides))
    assert result.tree[PATH] == File(MERGED.encode(), wanted)


@pytest.mark.parametrize("start", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("end", [b"\n", b"\r\n"])
def test_line_ends_and_byte_order_mark_stay(start, end):
    form = MINE.encode().replace(b"\n", end)
    result = merge(start + form, OLD.encode(), NEW.encode())
    assert result.tree[PATH].data == start + MERGED.encode().replace(b"\n", end)


def test_kept_file_stays_as_it_is():
    result = merge(MINE.encode(), OLD.encode(), NEW.encode(), kept=PATH)
    assert result.tree[PATH].data == MINE.encode()
    assert merge(None, OLD.encode(), NEW.encode(), kept=PATH).tree[PATH].data == NEW.encode()


@pytest.mark.parametrize("way", [None, conflict])
def test_file_that_is_to_be_a_conflict_is_one_among_developers(way):
    sides = [{PATH: File(text.encode())} for text in (MINE, OLD, NEW)]
    ways = {PATH: way} if way else {}
    result = merge_package(*sides, Renaming(), {""}.__contains__, ways, of_people=True)
    assert [*result.conflicts] == [*ways]


def test_binary_data_is_never_merged():
    """It is in conflict where the new version has something else, and stays."""
    mine = File(b"\0mine")
    result = merge(mine, OLD.encode(), NEW.encode())
    assert result.tree == {PATH: mine}
    assert list(result.conflicts) == [PATH]
    assert merge(mine, OLD.encode(), OLD.encode()).conflicts == {}


@pytest.mark.parametrize("new", [OLD, NEW])
def test_link_in_the_place_of_a_file_stays(new):
    """There is no text that could have a conflict: the file is missing, and said to be."""
    mine = File(b"../other.py", LINK)
    result = merge(mine, OLD.encode(), new.encode())
    assert (result.tree, result.conflicts) == ({PATH: mine}, {})
    assert result.missing == {PATH: [""]}


@pytest.mark.parametrize("target", ["../docs/arm/reach.py", "mine/./reach.py", "reach.py"])
def test_file_that_a_link_leads_to_is_updated(target):
    """The developer has moved it, and left the link in its place."""
    place = posixpath.normpath(f"arm/{target}")
    link = File(target.encode(), LINK)
    mine = {PATH: link, place: File(MINE.encode())}
    old, new = {PATH: File(OLD.encode())}, {PATH: File(NEW.encode())}
    result = merge_package(mine, old, new, Renaming(), {""}.__contains__)
    assert (result.conflicts, result.missing) == ({}, {})
    assert result.tree == {PATH: link, place: File(MERGED.encode())}
    proof = prove(mine, old, result, result.tree, Renaming())
    assert (proof.total, proof.in_place, proof.lost) == (1, 1, [])


@pytest.mark.parametrize("place", ["tools", "deep/../tools"])
def test_files_below_a_folder_that_is_a_link_are_updated(place):
    """Empty ones, too, which are like no other."""
    paths = [PATH, "arm/__init__.py", "arm/a/b.py"]
    texts = [("", "", ""), ("a = 1\n", "", "")]
    sides = zip((MINE, OLD, NEW), *texts, strict=True)
    trees = [{p: File(t.encode()) for p, t in zip(paths, side, strict=True)} for side in sides]
    mine, old, new = trees
    mine = {path.replace("arm", "tools"): file for path, file in mine.items()}
    mine["arm"] = File(place.encode(), LINK)
    result = merge_package(mine, old, new, Renaming(), {""}.__contains__)
    assert (result.conflicts, result.missing, {*result.tree}) == ({}, {}, {*mine})
    assert result.tree[PATH.replace("arm", "tools")].text == MERGED


def test_file_that_both_have_made_has_what_both_have():
    """Of what has one name, the developer's counts; a text without names is a conflict."""
    result = merge(b"mine = 1\nboth = 1\n", None, b"theirs = 2\nboth = 2\n")
    assert sorted(result.tree[PATH].text.split("\n")) == ["", "both = 1", "mine = 1", "theirs = 2"]
    trees = [{"notes": File(text)} for text in (b"mine\n", b"theirs\n")]
    result = merge_package(trees[0], {}, trees[1], Renaming(), {""}.__contains__)
    assert list(result.conflicts) == ["notes"]
    assert "mine\n" in result.tree["notes"].text


OF_A_DEVELOPER = {
    "- 1 1": "- missing",
    "- 1 2": "- missing",
    "1 1 -": "-",
    "1! 1! -": "-",
    "2 1 -": "- left",
    "2! 1! -": "- left",
    "2! 1 -": "- left",
}
OF_TWO = {
    "- 1 1": "-",
    "- 1 2": "2 13",
    "1 1 -": "-",
    "2 1 -": "2 12",
    "2! 1! -": "2! 12",
}
OF_BOTH = {
    "- - 1": "1",
    "1 - -": "1",
    "1 1 2": "2",
    "2 1 1": "2",
    "2 1 3": "2|3 123",
    "2 1! 3": "2 123",
    "2 - 2": "2",
    "2 - 3": "2|3 23",
    "2 - 3!": "2 23",
    "2! 1! 3!": "2! 123",
    "2! 1! 1!": "2!",
    "1! 1! 2!": "2!",
    "2! 1! 2!": "2!",
}
"""A file of the developer, of before and of now, `!` if no text; what it is then: with the
versions that git has of a conflict, or what is said of it."""


@pytest.mark.parametrize(
    ("of_people", "sides", "wanted"),
    [
        *((False, *case) for case in (OF_A_DEVELOPER | OF_BOTH).items()),
        *((True, *case) for case in (OF_TWO | OF_BOTH).items()),
    ],
)
def test_file_that_is_made_or_deleted_or_no_text(of_people, sides, wanted):
    sides = [side.replace("!", "\0").encode() for side in sides.split()]
    trees = [{} if side == b"-" else {"a": File(side)} for side in sides]
    result = merge_package(*trees, Renaming(), {""}.__contains__, of_people=of_people)
    text = result.tree["a"].text if "a" in result.tree else "-"
    data = result.tree["a"].data.decode().replace("\0", "!") if text is None else text
    found = "|".join(re.findall(r"(?m)^[\d!-]+", data))
    said = [name for name in ("missing", "left") if getattr(result, name)]
    stages = result.conflicts.get("a", {})
    assert " ".join([found, *said, "".join(map(str, sorted(stages)))]).rstrip() == wanted
    assert stages.items() <= dict(zip((2, 1, 3), sides, strict=True)).items()
    ours, _, theirs = sides
    is_settled = "|" in found or (stages and b"-" in (ours, theirs))
    assert result.settled == ({"a": File(theirs if ours == b"-" else ours)} if is_settled else {})


def test_edited_file_that_leaves_is_said():
    assert merge(MINE.encode(), OLD.encode(), None).left == [PATH]
    assert merge(OLD.encode(), OLD.encode(), None).left == []
    assert merge(OLD.replace('"', "'").encode(), OLD.encode(), None).left == []


BESIDE = {
    "package.xml": "<package>\n  <name>arm</name>\n{}</package>\n",
    "config/arm.yaml": "arm:\n  ros__parameters:\n    rate: 1\n{}",
    "CMakeLists.txt": "project(arm)\n{}ament_package()\n",
    "README.md": "# arm\n\nAn arm.\n\n{}",
    "launch/arm.launch.xml": "<launch>\n{}</launch>\n",
}
ITEMS = {
    "package.xml": '  <depend version_gte="{1}">{0}</depend>\n',
    "config/arm.yaml": "    {0}: {1}\n",
    "CMakeLists.txt": "find_package({0}\n  {1} REQUIRED)\n",
    "README.md": "## {0}\n\nWords, {1}.\n\n",
    "launch/arm.launch.xml": '  <node pkg="arm" name="{0}"\n    exec="{1}"/>\n',
}


@pytest.mark.parametrize("path", BESIDE)
def test_items_that_only_one_side_touches_never_conflict(path):
    """One side tunes two items and puts one in; the other moves these and adds one."""

    def text(items):
        return BESIDE[path].format("".join(ITEMS[path].format(*item) for item in items))

    old = {"a": 1, "b": 1, "c": 1, "d": 1}
    mine = {"a": 9, "mine": 1, "b": 1, "c": 1, "d": 9}
    new = {"c": 1, "d": 1, "new": 1, "a": 1, "b": 1}
    wanted = new | mine
    trees = [{path: File(text(side.items()).encode())} for side in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert not result.conflicts
    found = result.tree[path].text
    assert sorted(found.split()) == sorted(text(wanted.items()).split())
    assert all(ITEMS[path].format(*item).strip() in found for item in wanted.items())


def test_change_of_form_alone_never_conflicts():
    """One side changes code that the other has but laid out in another way."""
    form = "def f(a, b):\n    {}\n    if a:\n        return {}\n    return {}\n".format
    plain, changed = "value = g(a, b)", "value = g(b, a)"
    laid_out = "value = g(\n        a,\n        b\n    )"
    for mine, new in ((changed, laid_out), (laid_out, changed)):
        sides = form(mine, 1, "b"), form(plain, 1, "a"), form(new, 2, "a")
        result = merge(*(side.encode() for side in sides))
        assert not result.conflicts
        assert result.tree[PATH].text == form(changed, 2, "b")


def test_arguments_below_an_import_are_no_names_that_it_imports():
    """The developer has put them below what the new version changes."""
    head, call, line = (
        b"if a:\n    from b import c\n",
        b"    f(\n        c,\n    )\n",
        b"    d = 1\n",
    )
    new = line.replace(b"1", b"2")
    result = merge(head + line + call, head + call + line, head + call + new)
    assert not result.conflicts
    assert result.tree[PATH].data == head + new + call


def test_key_that_looks_like_an_import_is_none():
    """The developer has deleted it, and the new version changes it."""
    texts = "b: 1\n", "from a: 1\nb: 1\n", "from a: 2\nb: 1\n"
    mine, old, new = ({"a.yaml": File(text.encode())} for text in texts)
    result = merge_package(mine, old, new, Renaming(), {""}.__contains__)
    assert (result.tree, result.reworded) == (mine, {"a.yaml": ["from a: 2\n"]})


def test_merge_that_could_not_be_read_is_a_conflict():
    """Each side leaves another method of a class; together they leave none."""
    one, other = "    def one(self):\n        return 1\n", "    def other(self):\n        pass\n"
    sides = (f"class A:\n{methods}" for methods in (one, one + other, other))
    assert list(merge(*(side.encode() for side in sides)).conflicts) == [PATH]


def test_callbacks_of_a_file_with_a_syntax_error_are_left_to_the_developer():
    """Its lines alone would give one callback the body of another."""
    broken = MINE + "    def half(self\n"
    replaced = OLD.replace("serve_load", "serve_estop")
    result = merge(broken.encode(), OLD.encode(), replaced.encode())
    assert list(result.conflicts) == [PATH]
    assert result.settled[PATH].text == broken
    start = "<<<<<<< before updating\nclass ReachImpl:\n    def serve_load("
    assert result.tree[PATH].text.startswith(start)
    result = merge(broken.encode(), OLD.encode(), NEW.encode())
    assert result.tree[PATH].text == broken.replace("Fill in", "Complete")
    assert not result.conflicts


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
    proof = prove(trees[0], old, result, result.tree, Renaming())
    assert (proof.total, proof.in_place, proof.lost) == (1, 1, [])


@pytest.mark.parametrize("place", ["arm/logic/watch_impl.py", "arm/mine.py"])
def test_moved_file_is_not_taken_for_one_like_it_that_is_deleted(place):
    watch = OLD.replace("Reach", "Watch").replace("reach", "watch")
    old = {PATH: File(OLD.encode()), "arm/watch_impl.py": File(watch.encode())}
    mine = {place: File(watch.encode())}
    result = merge_package(mine, old, old, Renaming(), {""}.__contains__)
    assert result.tree == mine
    assert result.missing == {PATH: [""]}


def test_own_section_above_a_text_of_the_model_that_changes():
    old = "# Arm\n\nAn arm\n\n## Use\n\nRun it.\n"
    own = "# Arm\n\n## Contents\n\n- [Use](#use)\n"
    texts = [old.replace("# Arm\n", own, 1), old, old.replace("An arm", "A hand")]
    trees = ({"README.md": File(text.encode())} for text in texts)
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree["README.md"].text == texts[0].replace("An arm", "A hand")


def test_command_that_the_developer_gives_arguments_is_not_missing():
    old = "project(arm)\n\nadd_library(core core.cpp)\n\nament_package()\n"
    texts = (old.replace("ge()", "ge(CONFIG_EXTRAS a.cmake)"), old, old.replace("core", "arm"))
    trees = ({"CMakeLists.txt": File(text.encode())} for text in texts)
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert (result.missing, result.conflicts) == ({}, {})
    assert result.tree["CMakeLists.txt"].text == texts[0].replace("core", "arm")


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


@pytest.mark.parametrize(("order", "expected"), [("bca", "bxca"), ("acb", "cbxa")])
def test_own_block_beside_one_that_both_sides_move(order, expected):
    """The developer has put `a` last, and `x` behind `b`; the model orders its blocks anew."""
    old, mine, new = (
        "".join(f"def {name}():\n    pass\n" for name in names) for names in ("abc", "bxca", order)
    )
    trees = [{"a.py": File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert re.findall(r"def (\w)", result.tree["a.py"].text) == [*expected]


def test_own_file_where_an_earlier_version_had_one_stays():
    """The package has the new name by now; what has the old one is the developer's."""
    generated, own = File(OLD.encode()), File(b"MINE = 1\n")
    mine = {"arm/callbacks.py": generated, "arm/worker.py": own}
    render = {"arm/callbacks.py": generated}
    renaming = Renaming()
    renaming.follow({"arm/worker.py": "arm/callbacks.py"}, render, render)
    assert merge_package(mine, render, render, renaming, {""}.__contains__).tree == mine


def test_own_file_where_only_other_packages_had_one_stays():
    own, new = File(b"MINE = 1\n"), {"arm/ros/worker.py": File(OLD.encode())}
    renaming = Renaming()
    renaming.follow({"arm/worker.py": "arm/ros/worker.py"}, {}, new)
    merged = merge_package({"arm/worker.py": own}, {}, new, renaming, {""}.__contains__)
    assert merged.tree == {"arm/worker.py": own, **new}


def test_moved_file_of_a_renamed_node_is_renamed():
    """The developer has moved it; a rename of its node exchanges what is in it."""
    new = OLD.replace("Reach", "Grasp")
    renaming = Renaming(
        paths={PATH: "arm/grasp_impl.py"},
        in_file={PATH: {"ReachImpl": "GraspImpl"}},
        vocabulary={PATH: {"ReachImpl"}},
        classes={"ReachImpl": {"ReachImpl"}},
    )
    trees = [{path: File(t.encode())} for path, t in (("arm/logic/mine.py", MINE), (PATH, OLD))]
    new_tree = {"arm/grasp_impl.py": File(new.encode())}
    result = merge_package(*trees, new_tree, renaming, {""}.__contains__)
    assert list(result.tree) == ["arm/logic/mine.py"]
    assert result.tree["arm/logic/mine.py"].text == MINE.replace("Reach", "Grasp")
    assert prove(*trees, result, result.tree, renaming).lost == []


def test_name_of_one_module_alone_is_renamed_where_others_name_that_module():
    names = {PATH: {"limit": "bound"}}
    renaming = Renaming(package="arm", paths={PATH: "arm/grasp_impl.py"}, in_file=names)
    text = "patch('arm.{}.{}', 1)\npatch('arm.other.limit', 1)\n"
    found = renaming.text("test/test_own.py", text.format("reach_impl", "limit"))
    assert found == text.format("grasp_impl", "bound")


def test_target_of_cmake_is_none_of_other_languages():
    renaming = Renaming(targets={"reach": "grasp"})
    text, path = "add_executable(reach)\n", "CMakeLists.txt"
    assert renaming.text(path, text) == text.replace("reach", "grasp")
    for path in ("src/own.cpp", "arm/own.py"):
        assert renaming.text(path, text) == text


def test_one_of_two_copies_is_the_moved_file():
    """That with the name of before; the other one is the developer's own."""
    mine = {path: File(MINE.encode()) for path in ("arm/z.py", "logic/reach_impl.py")}
    mine["arm/a.py"] = mine["arm/z.py"]
    trees = [{PATH: File(text.encode())} for text in (OLD, NEW)]
    result = merge_package(mine, *trees, Renaming(), {""}.__contains__)
    assert result.tree == mine | {"logic/reach_impl.py": File(MERGED.encode())}


@pytest.mark.parametrize("sign", ["#", "//"])
def test_bytes_of_another_encoding_do_not_make_a_merge_coarse(sign):
    """A callback comes, one leaves, and no body changes place."""
    path = {"#": "a.py", "//": "a.hpp"}[sign]
    form = {
        "#": "def serve_{0}(a):\n    return {1}\n\n\n",
        "//": "void serve_{0}()\n{{\n  run({1});\n}}\n\n",
    }[sign]
    before, after = ("load", "store", "home"), ("estop", "load", "home")
    first = f"{sign} Coffee\n{sign} caf\xe9\n\n\n".encode("latin-1")
    head = f"{sign} Coffee\n\n\n"
    mine = first + "".join(form.format(name, name + "_1") for name in before).encode()
    old, new = (
        (head + "".join(form.format(n, 0) for n in names)).encode() for names in (before, after)
    )
    trees = [{path: File(data)} for data in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert not result.conflicts
    assert result.removed == {path: ["serve_store"]}
    text = "".join(form.format(n, 0 if n == "estop" else f"{n}_1") for n in after)
    assert result.tree[path].data.split() == (first + text.encode()).split()


BUILD = "project(arm)\n\nament_package()\n"
CODE = "from arm.x import A\n\n\ndef run():\n    return A\n"


@pytest.mark.parametrize(
    ("path", "old", "place", "own", "generated"),
    [
        (
            "CMakeLists.txt",
            BUILD,
            "ament_package",
            "install(TARGETS core DESTINATION lib)\n\n",
            "install(TARGETS\n  reach\n  DESTINATION lib/arm\n)\n\n",
        ),
        (
            "arm/tools.py",
            CODE,
            "\n\ndef",
            "from std_srvs.srv import Empty\n",
            "from std_srvs.srv import Trigger\n",
        ),
    ],
)
def test_what_both_add_under_one_key_is_there_twice(path, old, place, own, generated):
    mine, new = (old.replace(place, text + place, 1) for text in (own, generated))
    trees = [{path: File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    text = result.tree[path].text
    assert not result.conflicts
    assert text.count(own.strip()) == text.count(generated.strip()) == 1
    assert result.own == {}


@pytest.mark.parametrize(
    ("path", "old", "own"),
    [
        ("arm/tools.py", CODE, "\n\ndef main():\n    return {}()\n"),
        ("src/tools.cpp", "int run()\n{\n  return 1;\n}\n", "\nint main()\n{{\n  {}();\n}}\n"),
        ("config/a.yaml", "a: 1\n", "\nmain: {}\n"),
    ],
)
def test_what_has_one_name_and_both_make_stays_the_developers_and_is_said(path, old, own):
    mine, new = (old + own.format(name) for name in ("mine", "run"))
    trees = [{path: File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert result.tree[path].text == mine
    assert result.own == {path: ["main"]}
    assert recount(*trees, Renaming(), {""}.__contains__, result, result.tree, []) == []


def test_new_keys_reach_the_parameters_of_a_node_that_is_named():
    old = "/**:\n  ros__parameters:\n    gain: 1.0\n    limit: 2\n"
    mine = old.replace("/**", "/robot/worker").replace("1.0", "7.0")
    trees = [{"config/a.yaml": File(t.encode())} for t in (mine, old, old + "    rate: 5\n")]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert result.tree["config/a.yaml"].text == mine + "    rate: 5\n"
    assert prove(*trees[:2], result, result.tree, Renaming()).lost == []
    assert recount(*trees, Renaming(), {""}.__contains__, result, result.tree, []) == []


@pytest.mark.parametrize(("left", "is_moved"), [(4, True), (3, False)])
def test_file_that_has_more_than_six_tenths_of_another_is_that_one_moved(left, is_moved):
    lines = [f"{number}\n" for number in range(5)]
    mine = {"own/a.txt": File("".join(lines[:left]).encode())}
    old, new = ({"a.txt": File("".join([*top, *lines]).encode())} for top in ([], ["new\n"]))
    result = merge_package(mine, old, new, Renaming(), {""}.__contains__)
    text = result.tree["own/a.txt"].text
    assert text == "new\n" * is_moved + "".join(lines[:left])


DEPENDS = "<package>\n  <name>arm</name>\n{}  <depend>tf2</depend>\n</package>\n"
DEPEND = "  <{0}>nav</{0}>\n"
SORTS = [*itertools.permutations(("depend", "exec_depend")), ("build_depend", "depend")]


@pytest.mark.parametrize(("own", "generated"), [*SORTS, ("build_export_depend", "depend")])
@pytest.mark.parametrize("way", ["own", "missing", "removed"])
def test_dependency_that_both_have_is_there_once(own, generated, way):
    """catkin_pkg, and so colcon, refuses a package with one in general and for some use."""
    mine, made, without = (
        DEPENDS.format(sort and DEPEND.format(sort)) for sort in (own, generated, "")
    )
    old, new = {"own": (without, made), "missing": (made, made), "removed": (made, without)}[way]
    trees = [{"package.xml": File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert result.tree["package.xml"].text == (without if way == "removed" else mine)
    parts = {"package.xml": [f"{generated} nav"]}
    assert getattr(result, way) == (parts if way != "missing" else {})
    proof = prove(*trees[:2], result, result.tree, Renaming(), trees[2])
    about = (Renaming(), {""}.__contains__, result, result.tree, proof.left)
    assert (proof.lost, recount(*trees, *about)) == ([], [])


@pytest.mark.parametrize(
    ("own", "generated"), [("test_depend", "depend"), ("build_depend", "exec_depend")]
)
def test_dependencies_that_ros_reads_beside_each_other_are_both_there(own, generated):
    mine, new = (DEPENDS.format(DEPEND.format(sort)) for sort in (own, generated))
    trees = [{"package.xml": File(t.encode())} for t in (mine, DEPENDS.format(""), new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    both = DEPENDS.format(DEPEND.format(own) + DEPEND.format(generated))
    assert (result.tree["package.xml"].text, result.own) == (both, {})


@pytest.mark.parametrize(
    ("path", "function", "body", "own"),
    [
        ("arm.py", "# Service {0}\ndef {0}():\n", "    return True\n", "    return own()\n"),
        ("arm.py", "# Service {0}\n@made\ndef {0}():\n", "    return\n", "    return own()\n"),
        (
            "arm.cpp",
            "// Service {0}\nbool {0}()\n",
            "{\n  return true;\n}\n",
            "try {\n} catch (...) {\n}\n",
        ),
        ("arm.cpp", "// Service {0}\nbool {0}()\n", "{\n  f(1);\n  f(2);\n}\n", "{\n  f(3);\n}\n"),
        (
            "arm.cmake",
            "# Service {0}\nfunction({0})\n",
            "  f(1)\nendfunction()\n",
            "  f(2)\nendfunction()\n",
        ),
    ],
)
def test_own_function_above_keeps_what_the_generated_one_has_no_longer(path, function, body, own):
    """Only the comment above that one is its own, wherever the developer has put it."""
    old, helper = (
        "".join(function.format(name) + body + "\n" for name in names)
        for names in (("load", "store"), ("own",))
    )
    helper = helper.split("\n", 1)[1]  # without comment
    load = function.format("load")
    mine = changed(old, (load + body, f"{helper}{load}{own}"))
    new = changed(old, (f"\n{function.format('store')}{body}", ""))
    sides = [{path: File(text.encode())} for text in (mine, old, new)]
    result, doubts = Versions(*sides).merged()
    assert (doubts, result.conflicts) == ([], {})
    wanted = changed(mine, (f"\n{function.format('store')}{body}", ""))
    assert result.tree[path].text.rstrip() == wanted.rstrip()


def test_function_whose_lines_do_not_go_together_is_a_conflict_by_itself():
    """Its docstring is the developer's no longer, and its body stands beside its name."""
    old = '# Timer poll\ndef poll():\n    """Do what is due."""\n'
    old += "\n\n# Service load\ndef load():\n    return 1\n"
    mine = changed(old, ('poll():\n    """Do what is due."""\n', "poll(): return count()\n"))
    new = changed(
        old,
        ("Timer", "Thread"),
        ('is due."""\n', 'is due, again."""\n    sleep(1.0)\n'),
        ("\n\n\n# Service load\ndef load():\n    return 1", ""),
    )
    sides = [{"arm.py": File(text.encode())} for text in (mine, old, new)]
    result, doubts = Versions(*sides).merged()
    assert doubts == []
    assert result.tree["arm.py"].text == (
        "# Thread poll\n<<<<<<< before updating\ndef poll(): return count()\n=======\n"
        'def poll():\n    """Do what is due, again."""\n    sleep(1.0)\n>>>>>>> after updating\n'
    )


@pytest.mark.parametrize("left", ["A", "C"])
@pytest.mark.parametrize(
    ("form", "wanted"),
    [
        ("(A, B,\n    C)  # skip", "(\n    {},\n    {},\n)  # skip"),
        ("(  # skip\n    A, B, C\n)", "(  # skip\n    {},\n    {},\n)"),
    ],
)
def test_comment_on_an_import_stays_where_it_is_when_a_name_leaves(form, wanted, left):
    """At its end, or beside its first line."""
    names = "(\n    A,\n    B,\n    C,\n)"
    old = f"from m import {names}\n\n\ndef a():\n    b()\n"
    mine = changed(old, (names, form), ("b()", "c()"))
    new = changed(old, (f"    {left},\n", ""))
    sides = [{"arm.py": File(text.encode())} for text in (mine, old, new)]
    result, doubts = Versions(*sides).merged()
    assert (doubts, result.conflicts) == ([], {})
    rest = [name for name in "ABC" if name != left]
    assert result.tree["arm.py"].text == changed(mine, (form, wanted.format(*rest)))
