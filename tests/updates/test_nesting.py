"""What a developer has put between `if` and `endif`, and what they have put these around."""

import ast
import re
import textwrap
from xml.etree import ElementTree

import pytest

from hooks.merge import outlines
from hooks.merge.merging import conflict
from hooks.merge.package import merge_package
from hooks.merge.proof import prove
from hooks.merge.renaming import Renaming
from hooks.merge.tree import File, encode
from hooks.merge.versions import Versions
from support.laboratory.judge import nesting

ARM, LEG, FOOT = ({"name": name, "frequency": 10, "items": []} for name in ("arm", "leg", "foot"))
PUBLISHER = {"kind": "publisher", "name": "pose", "type": 0, "text": ""}


@pytest.fixture(scope="module")
def renders(laboratory):
    """Render the two sides of an update, once."""
    found = {}

    def run(nodes, new_nodes, model="cpp_model", distro="kilted"):
        key = repr((nodes, new_nodes, model, distro))
        if key not in found:
            specs = ({"description": "Arms", "nodes": side} for side in (nodes, new_nodes))
            found[key] = laboratory.pair(*specs, model, (distro, distro), "1.0.0")
        return found[key]

    return run


@pytest.fixture
def update(renders):
    """Update a package of some nodes to others; return an edited file of it, and the result."""

    def run(path, edit, *sides):
        pair = renders(*sides)
        old, new = (
            {path: File(encode(text)) for path, text in texts.items()}
            for texts in (pair.old, pair.new)
        )
        text = edit(pair.old[path])
        assert text != pair.old[path]
        mine = old | {path: File(encode(text))}
        result = merge_package(mine, old, new, pair.renaming, pair.is_kept)
        assert not result.conflicts
        assert prove(mine, old, result, result.tree, pair.renaming).lost == []
        found = result.tree[pair.renaming.path(path)].text
        assert [*nesting(path, found)] == []
        return found, result

    return run


def put_after(line, *own):
    def edit(text):
        assert f"{line}\n" in text
        return text.replace(f"{line}\n", "\n".join([line, *own, ""]), 1)

    return edit


def put_around(first, last, head, tail):
    """Put lines around those from the one that begins with a text to another one."""

    def edit(text):
        start = text.index(f"\n{first}") + 1
        end = text.index(f"\n{last}", start) + len(last) + 1
        end = text.index("\n", end) + 1
        return text[:start] + f"{head}\n" + text[start:end] + f"{tail}\n" + text[end:]

    return edit


def taken_out_of(head, tail):
    """Take what is between two lines out of them, to the left."""

    def edit(text):
        before, _, rest = text.partition(f"{head}\n")
        inside, _, after = rest.rpartition(f"{tail}\n")
        margin = head[: -len(head.lstrip())]
        return before + textwrap.indent(textwrap.dedent(inside), margin) + after

    return edit


def without(text, *lines):
    """Return a text without some lines, each of which it has."""
    for line in lines:
        assert f"{line}\n" in text, text
        text = text.replace(f"{line}\n", "", 1)
    return text


TAKEN = {
    "tests": ("CMakeLists.txt", "cpp_model", "kilted", "if(BUILD_TESTING)", "endif()"),
    "tests, ROS 1": (
        "CMakeLists.txt",
        "cpp_model",
        "noetic",
        "if(CATKIN_ENABLE_TESTING)",
        "endif()",
    ),
    "group": (
        "launch/lab.launch",
        "python_model",
        "noetic",
        "  <group if=\"$(eval arg('namespace') == '')\">",
        "  </group>",
    ),
}


@pytest.mark.parametrize("new_nodes", [[ARM, LEG, FOOT], [ARM], [FOOT, LEG]])
@pytest.mark.parametrize(("path", "model", "distro", "head", "tail"), TAKEN.values(), ids=TAKEN)
def test_what_the_developer_has_taken_out_of_a_container_changes_there(
    renders, update, path, model, distro, head, tail, new_nodes
):
    """A node whose `<group>` they took away went on to start when it had left the spec."""
    sides = ([ARM, LEG], new_nodes, model, distro)
    edit = taken_out_of(head, tail)
    found, result = update(path, edit, *sides)
    assert found.split() == edit(renders(*sides).new[path]).split()
    assert not result.missing


BLOCKS = {
    "if": ("if(WITH_CUDA)", "  find_package(CUDA REQUIRED)", "endif()"),
    "if, else": (
        "if(A)",
        "  set(B 1)",
        "elseif(C)",
        "  set(B 2)",
        "else()",
        "  set(B 3)",
        "endif()",
    ),
    "nested": (
        "if(A)",
        "  foreach(i 1 2)",
        "    if(i)",
        "    endif()",
        "  endforeach()",
        "endif()",
    ),
    "function": ("function(mine a)", "  if(a)", "    set(b 1)", "  endif()", "endfunction()"),
    "if like theirs": ("if(UNIX AND NOT APPLE)", "  set(MINE 1)", "endif()"),
}
PLACES = {
    "kilted": (
        "find_package(ament_cmake REQUIRED)",
        "add_executable(arm src/arm_main.cpp)",
        '  target_link_options(${PROJECT_NAME}_arm PRIVATE "LINKER:-z,nodelete")',
        "if(BUILD_TESTING)",
    ),
    "noetic": ("project(lab)", "include_directories(include)", "if(CATKIN_ENABLE_TESTING)"),
}


@pytest.mark.parametrize("own", BLOCKS.values(), ids=BLOCKS)
@pytest.mark.parametrize(("distro", "line"), [(d, line) for d in PLACES for line in PLACES[d]])
@pytest.mark.parametrize(
    ("nodes", "new_nodes"),
    [
        ([ARM], [ARM, LEG]),
        ([ARM, LEG], [ARM]),
        ([ARM, LEG], [LEG, ARM]),
        ([ARM, LEG], [FOOT, ARM]),
        ([ARM, LEG], [LEG | {"name": "foot", "was": "leg"}, ARM]),
    ],
    ids=["add", "remove", "reorder", "replace", "rename"],
)
def test_conditions_of_the_developer_in_cmake_stay_whole(
    renders, update, distro, line, own, nodes, new_nodes
):
    """The file is that of the new version, and theirs stands after the line that it followed."""
    sides = (nodes, new_nodes, "cpp_model", distro)
    found, _ = update("CMakeLists.txt", put_after(line, *own), *sides)
    lines = "".join(f"{line}\n" for line in own)
    assert found.replace(f"{line}\n{lines}", f"{line}\n") == renders(*sides).new["CMakeLists.txt"]


@pytest.mark.parametrize(
    "new_nodes",
    [
        [ARM, LEG, FOOT],
        [FOOT, ARM, LEG],
        [LEG, ARM],
        [LEG, {**ARM, "name": "hand", "was": "arm"}],
        [ARM],
    ],
    ids=["add", "add before", "reorder", "rename and move", "remove"],
)
def test_condition_around_generated_cmake_holds_that_alone(renders, update, new_nodes):
    first, last = "add_library(${PROJECT_NAME}_leg", "  DESTINATION lib/${PROJECT_NAME}\n)"
    edit = put_around(first, last, "if(WITH_LEG)", "endif()  # WITH_LEG")
    found, result = update("CMakeLists.txt", edit, [ARM, LEG], new_nodes)
    inside = re.search(r"if\(WITH_LEG\)\n(.*?)endif\(\)  # WITH_LEG\n", found, re.DOTALL)[1]
    new = renders([ARM, LEG], new_nodes).new["CMakeLists.txt"]
    if LEG in new_nodes:
        wanted = new[new.index(f"\n{first}") + 1 :]
        wanted = wanted[: wanted.index(last) + len(last) + 1]
        assert inside.strip() == wanted.strip()
    else:
        assert inside.strip() == ""
    assert without(found, "if(WITH_LEG)", "endif()  # WITH_LEG").split() == new.split()
    assert result.missing == {}


def server(name, **more):
    return {"kind": "serviceServer", "name": name, "type": 0, "text": "", **more}


LOAD, STORE, ESTOP = (server(name) for name in ("load", "store", "estop"))
CALLBACKS = {
    "reorder": [STORE, LOAD],
    "add before": [ESTOP, LOAD, STORE],
    "add between": [LOAD, ESTOP, STORE],
    "add after": [LOAD, STORE, ESTOP],
    "remove": [LOAD],
    "remove the other": [STORE],
    "remove both": [],
    "replace": [LOAD, ESTOP],
    "retype": [LOAD, {**STORE, "type": 1}],
    "rename": [LOAD, server("home", was="store")],
    "rename and move": [server("home", was="store"), LOAD],
    "swap": [server("store", was="load"), server("load", was="store")],
    "swap in place": [server("load", was="store"), server("store", was="load")],
    "circle": [server("estop", was="store"), server("store", was="load")],
}


def around_callback(path, name, head, tail, margin=""):
    """Put lines around a callback, which has a body, and the comment above it."""
    language = path.rpartition(".")[2]
    form = {
        "cpp": rf"// Service {name}\nvoid \w+::serve_{name}\(.*?\n}}\n",
        "py": rf"    # Service {name}\n    def serve_{name}\(.*?return response\n",
    }[language]
    body = {"cpp": "  // mine\n}\n", "py": "        return response  # mine\n"}[language]

    def edit(text):
        code = re.search(form, text, re.DOTALL)[0]
        mine = code.removesuffix("}\n" if language == "cpp" else "        return response\n")
        mine = re.sub("(?m)^(?=.)", margin, mine + body)
        return text.replace(code, f"{head}\n{mine}{tail}\n" if tail else f"{head}\n{mine}")

    return edit


def new_name(name, items):
    """Return the name that a callback, or a node, has in a new spec; None where it has left."""
    names = {item.get("was") or item["name"]: item["name"] for item in items}
    return names.get(name)


@pytest.mark.parametrize("wrapped", [["store"], ["load"], ["load", "store"]], ids="-".join)
@pytest.mark.parametrize("items", CALLBACKS.values(), ids=CALLBACKS)
def test_directives_around_a_callback_in_cpp_hold_that_alone(renders, update, items, wrapped):
    sides = ([{**ARM, "items": found}] for found in ([LOAD, STORE], items))
    path = "src/arm_impl.cpp"

    def edit(text):
        for name in wrapped:
            text = around_callback(path, name, "#ifdef WITH_IT", f"#endif  // of {name}")(text)
        return text

    found, result = update(path, edit, *sides)
    for name in wrapped:
        end = found.index(f"#endif  // of {name}")
        inside = found[found.rindex("#ifdef WITH_IT", 0, end) : end]
        after = new_name(name, items)
        assert re.findall(r"::serve_(\w+)", inside) == ([after] if after else [])
        assert inside.count("  // mine\n") == bool(after)
        assert found.count("  // mine\n") == sum(bool(new_name(n, items)) for n in wrapped)
    assert found.count("::serve_") == len(items)
    assert result.missing == {}


def test_directives_of_all_kinds_in_cpp_stay_whole(renders, update):
    """Those that hold several callbacks, others, includes, declarations; those in a body."""
    sides = ([{**ARM, "items": found}] for found in ([LOAD, STORE], [ESTOP, STORE, LOAD]))
    path = "src/arm_impl.cpp"
    own = "#if A\n#include <a>\n#else\n#include <b>\n#endif\n"

    def edit(text):
        text = around_callback(path, "store", "#if A\n#ifndef B", "#endif\n#endif  // A")(text)
        text = text.replace('#include "lab/arm_impl.hpp"\n', f'#include "lab/arm_impl.hpp"\n{own}')
        return text.replace("  return true;\n", "#ifdef C\n  run();\n#endif\n  return true;\n", 1)

    found, _ = update(path, edit, *sides)
    assert own in found
    assert "#ifdef C\n  run();\n#endif\n  return true;\n" in found
    inside = re.search(r"#if A\n#ifndef B\n(.*?)\n#endif\n#endif  // A", found, re.DOTALL)[1]
    assert re.findall(r"::serve_(\w+)", inside) == ["store"]


LAUNCHES = [
    ("python_model", "kilted", "launch/lab.launch.xml"),
    ("cpp_model", "kilted", "launch/lab.launch.xml"),
    ("python_model", "noetic", "launch/lab.launch"),
]


@pytest.mark.parametrize(("model", "distro", "path"), LAUNCHES)
@pytest.mark.parametrize("depth", [1, 2])
@pytest.mark.parametrize(
    "new_nodes",
    [
        [ARM, {**LEG, "name": "foot", "was": "leg"}],
        [{**LEG, "name": "foot", "was": "leg"}, ARM],
        [ARM],
        [ARM, {**LEG, "items": [LOAD]}],
        [ARM, LEG, FOOT],
        [FOOT, LEG, ARM],
        [ARM, FOOT],
    ],
    ids=["rename", "rename and move", "remove", "edit", "add", "add and move", "replace"],
)
def test_group_around_a_node_in_a_launch_file_holds_that_alone(
    renders, update, model, distro, path, depth, new_nodes
):
    sides = ([ARM, LEG], new_nodes, model, distro)

    def edit(text):
        node = re.search(r' *<node pkg="lab" \w+="leg".*?</node>\n', text, re.DOTALL)[0]
        mine = re.sub("(?m)^(?=.)", "  " * depth, node)
        for n in range(depth):
            mine = f"<group>  <!-- {n} -->\n{mine}</group>\n"
        return text.replace(node, mine)

    found, result = update(path, edit, *sides)
    ElementTree.fromstring(found)
    assert found.count("  <!-- ") - renders(*sides).new[path].count("  <!-- ") == depth
    name = new_name("leg", new_nodes)
    inside = found[
        found.index("  <!-- 0 -->") : found.index("</group>", found.index("<!-- 0 -->"))
    ]
    assert re.findall(r'<node .*?name="(\w+)"', inside) == ([name] if name else [])
    if name:
        margin = re.search("\n( *)<node", renders(*sides).new[path])[1]
        assert f"\n{margin}{'  ' * depth}<node" in inside
    assert result.missing == {}
    assert "-->\n\n" not in inside
    own = re.compile("( *<group>)?  <!-- [01] -->|</group>")
    assert own.sub("", found).split() == own.sub("", renders(*sides).new[path]).split() or (
        new_nodes[0] is not ARM
    )


@pytest.mark.parametrize("items", CALLBACKS.values(), ids=CALLBACKS)
def test_condition_around_a_method_in_python_holds_that_alone(update, items):
    sides = ([{**ARM, "items": found}] for found in ([LOAD, STORE], items))
    path = "lab/arm_impl.py"
    edit = around_callback(path, "store", "    if HAVE_DISK:  # own", "", "    ")
    found, result = update(path, edit, *sides, "python_model")
    name = new_name("store", items)
    assert result.missing == {}
    for item in items:
        margin = "    " * (1 + (item["name"] == name))
        assert f"\n{margin}def serve_{item['name']}(\n{margin}    self,\n" in found
    ast.parse(found)
    if name:
        inside = found[found.index("    if HAVE_DISK:") : found.index("# mine") + 6]
        assert re.findall(r"def (\w+)", inside) == [f"serve_{name}"]
    else:
        assert "serve_store" in str(result.removed)


def test_renamed_node_whose_line_the_developer_has_changed(renders):
    """It has both; in a conflict, the developer's side still has the name of before."""
    pair = renders([ARM, LEG], [ARM, {**LEG, "name": "foot", "was": "leg"}], "python_model")
    path = "launch/lab.launch.xml"
    mine, old, new = ({path: File(text[path].encode())} for text in (pair.old, pair.old, pair.new))
    line = 'name="leg" namespace="$(var namespace)"'
    assert line in pair.old[path]
    mine[path] = File(pair.old[path].replace(line, 'name="leg" namespace="mine"').encode())
    both = pair.new[path].replace(line.replace("leg", "foot"), 'name="foot" namespace="mine"')
    for way in (None, conflict):
        ways = {path: way} if way else {}
        result = merge_package(mine, old, new, pair.renaming, pair.is_kept, ways)
        assert [*result.conflicts] == [*ways]
        assert way or result.tree[path].text == both
        assert prove(mine, old, result, result.tree, pair.renaming).lost == []


@pytest.mark.parametrize(
    ("distro", "before", "after"),
    [
        ("kilted", "if(BUILD_TESTING)", "if(BUILD_TESTING AND NOT MINE)"),
        ("kilted", "if(UNIX AND NOT APPLE)", "if(UNIX)"),
        ("noetic", "if(CATKIN_ENABLE_TESTING)", "if(CATKIN_ENABLE_TESTING AND MINE)"),
    ],
)
@pytest.mark.parametrize("new_nodes", [[ARM, LEG, FOOT], [LEG, ARM], [LEG], [FOOT, ARM]])
def test_condition_that_the_developer_has_changed_is_the_same_one(
    renders, update, distro, before, after, new_nodes
):
    sides = ([ARM, LEG], new_nodes, "cpp_model", distro)
    found, result = update("CMakeLists.txt", lambda text: text.replace(before, after), *sides)
    assert result.missing == {}
    assert found.replace(after, before) == renders(*sides).new["CMakeLists.txt"]
    kept = sum(node in (ARM, LEG) for node in new_nodes) if "UNIX" in before else 1
    assert found.count(after) == kept


def test_condition_around_a_generated_condition_holds_that(renders, update):
    edit = put_around("if(BUILD_TESTING)", "endif()", "if(MINE)", "endif()  # MINE")
    sides = ([ARM, LEG], [LEG, FOOT, ARM])
    found, result = update("CMakeLists.txt", edit, *sides)
    wanted = renders(*sides).new["CMakeLists.txt"]
    assert result.missing == {}
    assert without(found, "if(MINE)", "endif()  # MINE").split() == wanted.split()
    assert "if(MINE)\nif(BUILD_TESTING)\n" in found
    assert "endif()\nendif()  # MINE\n" in found


@pytest.mark.parametrize("distro", ["kilted", "noetic"])
def test_alternative_to_a_generated_condition_in_cmake_stays_the_last(update, distro):
    before = "if(NOT CMAKE_CXX_STANDARD)\n  set(CMAKE_CXX_STANDARD 17)\n"
    own = "else()\n  set(MINE 1)\nendif()\n"

    def edit(text):
        start = text.index("endif()\n", text.index(before))
        return text[:start] + own + text[start:].partition("endif()\n")[2]

    found, _ = update("CMakeLists.txt", edit, [ARM], [ARM, LEG], "cpp_model", distro)
    assert own in found[found.index(before) :]


@pytest.mark.parametrize("first", ["", "\n  set(D)\n  "])
def test_condition_whose_commands_share_a_line_of_cmake_is_one_block(first):
    text = f"if(A) {first}set(B 1) else() set(B 2) endif()\nset(C)\n"
    blocks = outlines.cmake_blocks(text)
    assert [(block.key, block.children) for block in blocks] == [("if(A)", []), ("set C", [])]


def test_target_of_a_renamed_node_has_its_new_name(update):
    """A word like it has not."""
    new_nodes = [{**ARM, "name": "hip"}, {**LEG, "name": "foot", "was": "leg"}]
    own = ["target_compile_definitions(leg PRIVATE leg)", "find_package(leg)"]
    edit = put_after("add_executable(leg src/leg_main.cpp)", *own)
    found, _ = update("CMakeLists.txt", edit, [ARM, LEG], new_nodes)
    own[0] = own[0].replace("(leg", "(foot")
    assert "\n".join(["add_executable(foot src/foot_main.cpp)", *own, ""]) in found


@pytest.mark.parametrize(
    ("first", "last"),
    [
        ("install(\n  TARGETS leg\n", "  DESTINATION lib/${PROJECT_NAME}\n)"),
        ("add_executable(leg src/leg_main.cpp)", "  DESTINATION lib/${PROJECT_NAME}\n)"),
        ("ament_export_dependencies(", ")"),
    ],
)
def test_condition_around_generated_cmake_holds_that_after_a_rename(update, first, last):
    """Also where the first of a list has left, and another one is the first now."""
    nodes = [{**LEG, "items": [PUBLISHER]}, {**ARM, "items": []}]
    retyped = PUBLISHER | {"type": 1}
    new_nodes = [{**LEG, "name": "foot", "was": "leg", "items": [retyped]}, nodes[1]]
    edit = put_around(first, last, "if(MINE)", "endif()  # MINE")
    found, _ = update("CMakeLists.txt", edit, nodes, new_nodes)
    inside = found.partition("if(MINE)\n")[2].partition("endif()  # MINE")[0]
    first = first.replace("leg", "foot")
    assert inside.startswith(first), found
    assert inside.rstrip().endswith(last)
    assert found.count(first) == 1


def test_callback_that_has_an_alternative_keeps_both(update):
    sides = ([{**ARM, "items": found}] for found in ([LOAD, STORE], [ESTOP, STORE, LOAD]))
    other = "#else\nvoid ArmImpl::serve_load()\n{\n}\n#endif"
    edit = around_callback("src/arm_impl.cpp", "load", "#ifdef A", other)
    found, _ = update("src/arm_impl.cpp", edit, *sides)
    inside = re.search("#ifdef A\n(.*?)#endif", found, re.DOTALL)[1]
    assert re.findall(r"::serve_(\w+)|(#else)", inside) == [
        ("load", ""),
        ("", "#else"),
        ("load", ""),
    ]


BROKEN = {
    "CMakeLists.txt": ("if(A)\n  set(B 1)\nendif()\n", "endif()\n"),
    "a.cpp": ("#ifdef A\nint a;\n#endif\n", "#endif\n"),
    "b.cpp": ("int a()\n{\n#ifdef A\n  return 1;\n#endif\n}\n", "#endif\n"),
}


@pytest.mark.parametrize("path", BROKEN)
def test_proof_sees_what_does_not_nest(path):
    """It did before the update, so the update is at fault."""
    text, end = (part.encode() for part in BROKEN[path])
    trees = [{path: File(data)} for data in (text + b"\n" + text, text)]
    result = merge_package(*trees, {path: File(text)}, Renaming(), {""}.__contains__)
    assert prove(*trees, result, result.tree, Renaming()).lost == []
    found = {path: File(text + text.replace(end, b""))}
    assert (path, "cannot be read any more") in prove(*trees, result, found, Renaming()).lost


OF_THE_MODEL = {
    "CMakeLists.txt": (
        "project(arm)\n\n{}\nament_package()\n",
        "add_library(arm)\ntarget_link_libraries(arm\n  m\n)\n",
        ("  m\n", "  m\n  mine\n"),
        "if(UNIX)\n{}endif()\n",
        "",
    ),
    "launch/arm.launch": (
        "<launch>\n{}</launch>\n",
        '  <node name="arm">\n    <param name="a"/>\n  </node>\n',
        ('    <param name="a"/>\n', '    <param name="a"/>\n    <param name="mine"/>\n'),
        '  <group if="a">\n{}  </group>\n',
        "  ",
    ),
    "arm/arm_impl.py": (
        "import a\n\n\nclass Arm:\n{}\n    def two(self):\n        pass\n",
        "    def one(self):\n        pass\n",
        ("        pass\n", "        mine()\n        pass\n"),
        "    if a:\n{}",
        "    ",
    ),
    "src/arm_impl.cpp": (
        '#include "arm.hpp"\n\n{}\nvoid Arm::two()\n{{\n}}\n',
        "void Arm::one()\n{\n}\n",
        ("{\n", "{\n  mine();\n"),
        "#ifdef A\n{}#endif\n",
        "",
    ),
}
"""A file, a thing in it, an edit of it, and what the new version puts around it, how deep."""


@pytest.mark.parametrize("path", OF_THE_MODEL)
def test_what_the_model_puts_something_around_keeps_what_the_developer_has_in_it(path):
    """It has not left."""
    whole, thing, edit, container, margin = OF_THE_MODEL[path]
    mine = thing.replace(*edit)
    new, wanted = (container.format(textwrap.indent(text, margin)) for text in (thing, mine))
    texts = [whole.format(text) for text in (mine, thing, new)]
    result, doubts = Versions(*({path: File(encode(text))} for text in texts)).merged()
    assert (doubts, result.conflicts, result.removed) == ([], {}, {})
    assert result.tree[path].text == whole.format(wanted)


@pytest.mark.parametrize(
    ("path", "form", "own"),
    [
        ("arm/arm_impl.py", "class Arm:\n{}", "def load(path):\n    return path\n\n\n"),
        ("config/arm.yaml", "/**:\n{}", "load: 7\n"),
    ],
)
def test_what_the_developer_has_beside_a_class_or_a_key_is_nothing_that_it_held(path, form, own):
    """They have deleted that, and theirs has its name."""
    is_yaml = path.endswith(".yaml")
    held = "  {}: {}\n" if is_yaml else "    def {}(self):\n        return {}\n"
    stop = held.format("stop", 1)
    old, new = (form.format(held.format("load", value) + stop) for value in (1, 2))
    mine = own + form.format(stop)
    result, doubts = Versions(*({path: File(encode(text))} for text in (mine, old, new))).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert (result.tree[path].text, result.missing) == (mine, {path: ["load"]})


def test_which_of_several_the_model_puts_something_around():
    """Of one name, where another one of it has come, too."""
    one, two, came = (
        f"install(TARGETS {name}\n  DESTINATION lib\n)\n" for name in ("a", "b", "c")
    )
    mine = one.replace("lib\n", "lib\n  OPTIONAL\n")
    around = "if(UNIX)\n{}endif()\n"
    sides = (mine + two, one + two, came + around.format(one) + two)
    trees = ({"CMakeLists.txt": File(encode(text))} for text in sides)
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts, result.removed) == ([], {}, {})
    assert result.tree["CMakeLists.txt"].text == came + around.format(mine) + two


def test_what_the_developer_has_between_two_things_is_in_what_the_model_puts_around_both():
    one, own, other, two = (f'<node name="{name}"/>\n' for name in ("one", "own", "other", "two"))
    form, path = '<launch>\n  <node name="outside"/>\n{}</launch>\n', "arm.launch"
    around = form.format('  <group if="x">\n{}  </group>\n')
    texts = (one + own + other + two, one + two)
    mine, old = (form.format(textwrap.indent(text, "  ")) for text in texts)
    wanted, new = (around.format(textwrap.indent(text, "    ")) for text in texts)
    result, doubts = Versions(*({path: File(encode(text))} for text in (mine, old, new))).merged()
    assert (doubts, result.conflicts) == ([], {})
    assert result.tree[path].text == wanted


def test_what_the_developer_has_beside_what_the_model_puts_things_into_is_in_none_of_it():
    one, own, two, last = (f'  <node name="{name}"/>\n' for name in ("one", "own", "two", "last"))
    first, second = (
        f'  <group if="{n}">\n  {node}  </group>\n' for n, node in ((1, one), (2, two))
    )
    sides = (one + own + two + last, one + two, first + second)
    trees = [{"arm.launch": File(encode(f"<launch>\n{text}</launch>\n"))} for text in sides]
    result, doubts = Versions(*trees).merged()
    assert (doubts, result.conflicts) == ([], {})
    wanted = f"<launch>\n{first}{own}{second}{last}</launch>\n"
    assert result.tree["arm.launch"].text == wanted


def merged(path, *sides):
    """Merge three texts of a file; return what became of it, once no proof doubts it."""
    result, doubts = Versions(*({path: File(encode(text))} for text in sides)).merged()
    assert (doubts, result.conflicts) == ([], {})
    return result.tree[path].text


def test_what_the_developer_has_in_a_container_before_the_model_makes_it_stays_there():
    own, begin, end = "if(UNIX)\n  find_package(foo)\nendif()\n", "project(a)\n", "package()\n"
    sides = (begin + own + end, begin + end, f"{begin}find_package(foo REQUIRED)\n{end}")
    assert merged("CMakeLists.txt", *sides) == sides[0]


@pytest.mark.parametrize(
    ("path", "mine", "old", "new", "wanted"),
    [
        # What stood above it they have deleted, and so it stays
        (
            "CMakeLists.txt",
            "b(x)",
            "if(X)|  a(x)|  b(x)|endif()",
            "if(X)|  a(x 1)|  b(x 1)|endif()",
            "b(x 1)",
        ),
        # Not all of it
        (
            "CMakeLists.txt",
            "a(x)|if(X)|  b(x)|endif()",
            "if(X)|  a(x)|  b(x)|endif()",
            "if(X)|  a(x 1)|  b(x 1)|endif()",
            "a(x 1)|if(X)|  b(x 1)|endif()",
        ),
        (
            "CMakeLists.txt",
            "a(x)|b(x)",
            "if(X)|  a(x)|  b(x)|endif()",
            "if(X)|  b(x 1)|endif()",
            "b(x 1)",
        ),
        (
            "CMakeLists.txt",
            "a(x)|# One|if(X)|  b(x)|endif()",
            "# One|if(X)|  a(x)|  b(x)|endif()",
            "# Two|if(X)|  a(x 1)|  b(x 1)|  c(x)|endif()",
            "a(x 1)|# Two|if(X)|  b(x 1)|  c(x)|endif()",
        ),
        # An empty line above
        (
            "CMakeLists.txt",
            "c(x)||a(x)",
            "c(x)||if(X)|  a(x)|endif()",
            "c(x)||if(X)|  a(x 1)|endif()",
            "c(x)||a(x 1)",
        ),
        # Of a condition with an alternative, which stays
        (
            "CMakeLists.txt",
            "a(x)|if(X)|else()|  b(x)|endif()",
            "if(X)|  a(x)|else()|  b(x)|endif()",
            "if(X)|  a(x 1)|else()|  b(x 1)|endif()",
            "a(x)|if(X)|else()|  b(x 1)|endif()",
        ),
        # Of a namespace, in which something comes
        (
            "arm.cpp",
            "void f()|{|}",
            "namespace x {|void f()|{|}||void g()|{|}|}",
            "namespace x {|void f()|{|  a();|}||void g()|{|  b();|}||void h()|{|}|}",
            "void f()|{|  a();|}|namespace x {||void h()|{|}|}",
        ),
    ],
)
def test_what_the_developer_has_taken_out_of_a_container(path, mine, old, new, wanted):
    sides = (text.replace("|", "\n") + "\n" for text in (mine, old, new))
    assert merged(path, *sides).replace("\n", "|") == wanted + "|"


def test_only_the_comment_of_what_leaves_leaves_what_the_developer_has_above_it():
    old = "class A:\n    a = 1\n\n    # About f\n    def f(self):\n        return 1\n"
    own = "    def own(self):\n        return 1\n"
    around = "    if X:\n        def f(self):\n            return 1\n"
    mine = old.replace("    def f(self):\n        return 1\n", f"\n{own}\n{around}")
    new = "class A:\n    a = 1\n"
    assert merged("arm/arm_impl.py", mine, old, new) == f"{new}\n\n{own}"
