"""Packages of the original generator become packages of ours, and no line is lost."""

import ast
import re
import shutil
import subprocess
import sys
from collections import Counter
from contextlib import suppress

import pytest
import yaml

from scripts.adopt import NoPlaceError, Region, rule_for
from support.repository import ROOT, commit, git

RULES = yaml.safe_load((ROOT / "scripts/adopt.yaml").read_text(encoding="utf-8"))
LEGACY = ROOT / "tests/adoption/legacy"
needs_cpp = pytest.mark.skipif(not (ROOT / "cpp_model").exists(), reason="no cpp_model")


def run(collection, *arguments):
    command = [sys.executable, collection / "scripts/adopt.py", *arguments]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True)


@pytest.fixture
def legacy(tmp_path):
    """Return a function that gives a copy of a package of the original generator."""

    def copy(name="arm"):
        return shutil.copytree(LEGACY / name, tmp_path / "legacy" / name)

    return copy


@pytest.fixture
def adopt(collection, tmp_path):
    """Adopt a package, and return the new folder and what the command said."""

    def make(folder, *options):
        before = contents(folder)
        new = tmp_path / "new" / folder.name
        result = run(collection, folder, new, *options)
        assert result.returncode == 0, result.stderr
        assert contents(folder) == before, "the original was touched"
        assert not list(new.parent.glob(".*"))
        return new, result.stdout

    return make


def contents(folder):
    return {path: path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def code_of_regions(folder):
    """Yield file, region and line of all that stands inside of protected regions."""
    for path in filter(lambda path: path.is_file(), folder.rglob("*")):
        region = ""
        for line in path.read_text(encoding="utf-8").splitlines():
            if mark := re.search(r"protected region (.*) (begin|end) ", line):
                region = mark[1] if mark[2] == "begin" else ""
            elif region and line.strip():
                yield path.relative_to(folder), region, line


def method(file, name):
    """Return the source of a function or a class, wherever it is in a file."""
    source = file.read_text(encoding="utf-8")
    (found,) = (node for node in ast.walk(ast.parse(source)) if getattr(node, "name", "") == name)
    return ast.get_source_segment(source, found)


packages = pytest.mark.parametrize("name", ["arm", pytest.param("arm_cpp", marks=needs_cpp)])


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@packages
def test_no_line_is_lost(legacy, adopt, name, distro):
    folder = legacy(name)
    new, said = adopt(folder, "--ros-distro", distro)
    lines = Counter(line for _, _, line in code_of_regions(folder))
    assert lines.total() > 15
    spec = (folder / f"model/{name}.ros_package").read_text()
    written = Counter(b"\n".join(contents(new).values()).decode().splitlines())
    lost = lines - written
    assert [line for line in lost if f'"{line}"' not in spec] == []
    for file, region in {(file, region) for file, region, _ in code_of_regions(folder)}:
        told = rf'^(placed      |NOT PLACED  ){re.escape(str(file))}:[\d-]+ "{re.escape(region)}"'
        assert len(re.findall(told, said, re.MULTILINE)) == 1, f"{file}: {region}"


@needs_cpp
def test_every_rule_is_tried(legacy, adopt):
    """Each row of adopt.yaml has a region in the packages here, in each language."""
    tried = set()
    for name, model in (("arm", "python_model"), ("arm_cpp", "cpp_model")):
        _, said = adopt(legacy(name))
        for file, region in re.findall(r'^(?:placed|NOT PLACED) +(\S+):\S+ "(.*?)"', said, re.M):
            with suppress(NoPlaceError):
                rule, _ = rule_for(Region(file, region, 1, ()))
                tried |= {(str(rule["region"]), model), (str(rule["region"]), "any")}
    for rule in RULES["regions"]:
        for model in rule["to"] or ["any"]:
            assert (str(rule["region"]), model) in tried


def table():
    """Return the table of docs/developers.md that the rules make."""
    rows = ["| Protected region | Python | C++ |", "|---|---|---|"]
    for rule in RULES["regions"]:
        regions = [rule["region"]] if isinstance(rule["region"], str) else rule["region"]
        cells = [", ".join(f"`{region}`" for region in regions if region != "imports")]
        for model in ("python_model", "cpp_model"):
            place = rule["to"].get(model) or rule["to"].get("any")
            cell = re.sub(r"(\w+(?: of)?) (.*) in (.*)", r"\1 `\2` in `\3`", place or "")
            cells.append(cell + (", in ROS 1" if place and "ros" in rule else ""))
        if not rule["to"]:
            cells[1:] = ["`NOT_PLACED.md`"] * 2
        rows.append("| " + " | ".join(cells) + " |")
    return "\n".join(re.sub(" +", " ", row) for row in rows)


def test_docs_show_the_rules():
    assert table() in (ROOT / "docs/developers.md").read_text(encoding="utf-8")


def reworded(file, text, kept=()):
    """Return a text whose comments, docstrings and prose all say something else.

    The lines in `kept` stay as they are.
    """
    if ".py" in file:
        text = re.sub(
            r'""".*?"""', '"""\nOther words.\n\nMore of them.\n"""', text, flags=re.DOTALL
        )
    prose = {
        "README": r"[A-Z].*",
        ".py": r"\s*# .*",
        "CMakeLists": r"\s*# .*",
        ".cpp": r"\s*//.*",
        ".hpp": r"\s*//.*",
    }
    patterns = [pattern for name, pattern in prose.items() if name in file]
    lines = text.split("\n")
    for number, line in enumerate(lines):
        if line not in kept and any(re.fullmatch(pattern, line) for pattern in patterns):
            indent = line[: len(line) - len(line.lstrip(" "))]
            lines[number] = indent + line.strip()[:2].rstrip() * (patterns != [prose["README"]])
            lines[number] += " Other words."
    return "\n".join(lines)


@packages
def test_rules_need_no_wording(legacy, adopt, own_collection, name, tmp_path):
    """Code finds its place whatever the comments, docstrings and texts of a template say."""
    folder = legacy(name)
    kept = {line for _, _, line in code_of_regions(folder)}
    new, _ = adopt(folder)
    changed = 0
    for file in own_collection.glob("*/**/*.jinja"):
        if file.relative_to(own_collection).parts[0] in ("shared", "python_model", "cpp_model"):
            text = file.read_text(encoding="utf-8")
            file.write_text(reworded(str(file.name), text), encoding="utf-8")
            changed += text != file.read_text(encoding="utf-8")
    assert changed > 20
    commit(own_collection, "Reword", tag="2.0.0")
    other = tmp_path / "other" / name
    assert run(own_collection, folder, other).returncode == 0
    both = [
        {
            path.relative_to(top).as_posix(): reworded(path.name, path.read_text("utf-8"), kept)
            for path in contents(top)
            if path.name != ".copier-answers.yml"
        }
        for top in (new, other)
    ]
    assert both[0] == both[1]
    assert contents(new).values() != contents(other).values()


def test_python_code_is_in_its_place(legacy, adopt):
    new, said = adopt(legacy())
    impl = new / "arm/reach_impl.py"
    text = impl.read_text()
    imports = text[: text.index("class ReachImpl:")]
    for line in ("import rospy", "from std_msgs.msg import Float64", "from threading import Lock"):
        assert f"\n{line}\n" in imports
    assert "Empty" not in imports  # not used
    for name, line in {
        "__init__": "self.filter = Filter()",
        "configure": "return self.filter.gain > 0",
        "update": "self.filter.step(data.in_wanted.data)",
        "serve_load": 'result.message = "loaded"\n        return response',
        "execute_learn": "self.passthrough.as_learn.set_succeeded(result)",
        "receive_stop": "self.stopped(msg)",
        "stopped": "self.passthrough.frames.waitForTransform(",
    }.items():
        assert line in method(impl, name)
    assert "return True" not in method(impl, "configure")
    assert "goal.succeed()" not in text
    assert "def stopped" in method(impl, "ReachImpl")
    place = said.split('"user update" in arm/reach_impl.py:')[1].split()[0]
    assert text.splitlines()[int(place) - 1] == "        if data.in_wanted_updated:"


@needs_cpp
def test_cpp_code_is_in_its_place(legacy, adopt):
    new, _ = adopt(legacy("arm_cpp"))
    header = (new / "include/arm_cpp/reach_impl.hpp").read_text()
    assert '\n#include <mutex>\n#include "filter.hpp"\n\nnamespace' in header
    public, private = header.split("private:")
    assert "    void stop()\n    {\n" in public
    assert "    Filter filter_;\n" in private
    source = (new / "src/reach_impl.cpp").read_text()
    for name, line in {
        "ReachImpl": "moving_ = true;",
        "configure": "filter_.gain = config.gain;\n  return true;",
        "update": "data.out_pose.data = filter_.step(moving_ ? 1.0 : 0.0);",
        "receive_stop": "stop();",
        "serve_load": "res.success = moving_;",
        "execute_learn": "as_->setSucceeded();",
        "cleanup": "moving_ = false;",
    }.items():
        body = re.search(rf"ReachImpl::{name}\(.*?\n\{{\n(.*?)\n\}}\n", source, re.DOTALL)[1]
        assert line in body
    assert (new / "include/arm_cpp/filter.hpp").exists()
    assert "<build_depend>eigen</build_depend>" in (new / "package.xml").read_text()
    cmake = (new / "CMakeLists.txt").read_text()
    assert re.search(r"target_link_libraries\(\S+_reach\n[^)]*\n  Eigen3::Eigen\n\)", cmake)
    assert cmake.index("find_package(Eigen3") < cmake.index("catkin_package(")
    assert cmake.index("add_definitions(") < cmake.index("install(")


def test_build_files_and_readme_take_their_regions(legacy, adopt):
    new, _ = adopt(legacy())
    cmake = (new / "CMakeLists.txt").read_text()
    assert cmake.index("(catkin ") < cmake.index("Eigen3") < cmake.index("catkin_python_setup()")
    assert cmake.endswith(
        "install(DIRECTORY data DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})\n"
    )
    head, reach, watch = re.split("## Node .*", (new / "README.md").read_text())
    assert "It has been tried on a table only." in head
    assert "It reaches for what is wanted.\n" in reach
    assert "`pose`:\n\nThe angle of the first joint" in reach
    assert "0 1 9" in watch


def test_what_has_no_place_is_listed(legacy, adopt):
    new, said = adopt(legacy())
    rest = (new / "NOT_PLACED.md").read_text()
    for region, code in {
        'src/arm/watch_impl.py:29 "user implementation of service callback for forgotten"': (
            "\n        self.forgotten = req\n"
        ),
        'README.md:41 "subscriber old"': "\n````\nNot there any more, see ```old```.\n````\n",
        'package.xml:6-7 "additional package statements"': "  <run_depend>eigen</run_depend>\n",
    }.items():
        assert f"NOT PLACED  {region}: " in said
        assert f"## {region}\n" in rest
        assert code in rest
    assert said.count("NOT PLACED") == rest.count("\n## ") - 1  # and the files


def test_ros2_has_no_place_for_catkin(legacy, adopt):
    _, said = adopt(legacy(), "--ros-distro", "kilted")
    assert 'NOT PLACED  CMakeLists.txt:9 "additional user defined REQUIREMENTS"' in said
    assert '"imports"' not in said


def test_kept_files_come_along(legacy, adopt):
    folder = legacy()
    (folder.parent / "secret").write_text("not in the package")
    new, said = adopt(folder)
    for old, file in {
        "launch/both.launch": "launch/both.launch",
        "data/moves.csv": "data/moves.csv",
        "src/arm/helper.py": "arm/helper.py",
    }.items():
        assert (new / file).read_bytes() == (folder / old).read_bytes()
    assert ".gen_maintain: gone.txt is not there" in said
    assert ".gen_maintain: ../secret is outside of the package" in said
    assert "LEFT        NOTES" in said
    assert "- NOTES: " in (new / "NOT_PLACED.md").read_text()


def test_new_names_are_told(legacy, adopt):
    new, said = adopt(legacy())
    lines = (new / "arm/reach_impl.py").read_text().splitlines()
    for change, code in {
        "passthrough.as_NAME -> goal, the callback's argument": "as_learn",
        "msg -> message": "self.stopped(msg)",
        "client_NAME(request) -> client_NAME.call(request, timeout), None without an answer": (
            "client_permit("
        ),
    }.items():
        places = re.search(rf"  {re.escape(change)}: (.*)", said)[1].split(", ")
        for place in places:
            assert code in lines[int(place.partition(":")[2]) - 1]


def test_adopted_package_updates(legacy, adopt, update):
    new, _ = adopt(legacy())
    commit(new, "Adopt")
    assert update(new) == ""
    spec = new / "arm.ros_package"
    extra = '<serviceServer name="store" type="std_srvs::Trigger"/>\n    <serviceClient'
    spec.write_text(spec.read_text().replace("<serviceClient", extra, 1))
    commit(new, "Add a service")
    before = (new / "arm/reach_impl.py").read_text().splitlines()
    update(new)
    impl = new / "arm/reach_impl.py"
    assert "def serve_store" in method(impl, "ReachImpl")
    assert set(before) <= set(impl.read_text().splitlines())
    assert "<<<<<<<" not in git(new, "diff")


@pytest.mark.parametrize("distro", ["noetic", "kilted"])
@pytest.mark.parametrize("name", ["tool", pytest.param("tool_cpp", marks=needs_cpp)])
def test_a_service_server_gets_no_loop(legacy, adopt, name, distro):
    folder = legacy(name)
    new, said = adopt(folder, "--ros-distro", distro)
    spec = f"{name}.ros_package"
    assert (new / spec).read_bytes() == (folder / "model" / spec).read_bytes()
    logic = "".join(path.read_text() for path in new.rglob("hold_impl.*"))
    assert "update" not in logic
    assert "HoldData" not in logic
    assert said.count("placed      ") == 4
    generated = '"""Start operating; return False to refuse activation."""\n        return True\n'
    for _, _, line in code_of_regions(folder):
        assert logic.replace(generated, "").count(line) == 1
    assert not (new / "NOT_PLACED.md").exists()


def test_a_service_server_has_static_parameters(legacy, adopt, collection, tmp_path):
    folder = legacy("tool")
    spec = folder / "model/tool.ros_package"
    spec.write_text(spec.read_text().replace("<parameter ", "<dynParameter "))
    new, said = adopt(folder)
    assert "it is a parameter now" in said
    made = (new / "tool.ros_package").read_text()
    assert made == spec.read_text().replace("<dynParameter ", "<parameter ")
    spec.write_text(spec.read_text().replace('"double"', '"triple"'))
    assert run(collection, folder, tmp_path / "bad").stderr.startswith(f"{spec}:7: ")


def test_windows_and_latin_1_files_are_read(legacy, adopt):
    folder = legacy()
    impl = folder / "src/arm/reach_impl.py"
    text = impl.read_text().replace('"loaded"', '"größer"').replace("\n", "\r\n")
    impl.write_bytes(text.encode("latin-1"))
    new, _ = adopt(folder)
    written = (new / "arm/reach_impl.py").read_bytes()
    assert 'result.message = "größer"\n' in written.decode()
    assert b"\r" not in written


def _bad_folder(folder):
    shutil.rmtree(folder / "model")


def _bad_xml(folder):
    (folder / "model/arm.ros_package").write_text("<package>\n<node></package>")


def _bad_spec(folder):
    spec = folder / "model/arm.ros_package"
    spec.write_text(spec.read_text().replace("<publisher ", "<publishr "))


def _two_specs(folder):
    (folder / "model/other.ros_package").write_text("<package/>")


def _no_language(folder):
    spec = folder / "model/arm.ros_package"
    spec.write_text(spec.read_text().replace("python_node_update", "of_our_own"))
    shutil.rmtree(folder / "src")


def _no_end(folder):
    impl = folder / "src/arm/reach_impl.py"
    impl.write_text(impl.read_text().replace("# protected region user update end #\n", ""))


def _only_an_end(folder):
    impl = folder / "src/arm/reach_impl.py"
    impl.write_text(impl.read_text().replace("# protected region user update begin #\n", ""))


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (shutil.rmtree, "no such folder"),
        (_bad_folder, "has no model/*.ros_package"),
        (_bad_xml, "arm.ros_package:2: not well-formed XML"),
        (_bad_spec, '<publishr> is not known here; did you mean "publisher"?'),
        (_two_specs, "one spec is needed, found model/arm.ros_package, model/other.ros_package"),
        (_no_language, "say with --model which it is; allowed: "),
        (_no_language, " [unknown-language]"),
        (_no_end, ':43: protected region "user update" has no end [open-region]'),
        (_only_an_end, '"user update" has no beginning [open-region]'),
    ],
)
def test_bad_folder_gives_one_message(collection, legacy, tmp_path, spoil, message):
    folder = legacy()
    spoil(folder)
    new = tmp_path / "new" / "arm"
    result = run(collection, folder, new)
    assert result.returncode == 1
    assert len(result.stderr.splitlines()) == 1
    assert message in result.stderr
    assert result.stdout == ""
    assert not new.parent.exists() or not list(new.parent.iterdir())


def test_nothing_is_written_over(collection, legacy, tmp_path):
    folder = legacy()
    (tmp_path / "new").mkdir()
    for new, message in (
        (tmp_path / "new", "is there already"),
        (folder / "new", "which must stay as it is"),
    ):
        result = run(collection, folder, new)
        assert result.returncode == 1
        assert message in result.stderr
    assert not list((tmp_path / "new").iterdir())


def test_unknown_ros_is_refused(collection, legacy, tmp_path):
    result = run(collection, legacy(), tmp_path / "new", "--ros-distro", "foxy")
    assert result.returncode == 1
    assert 'unknown "foxy"; allowed: noetic, ' in result.stderr
    assert "Traceback" not in result.stderr
