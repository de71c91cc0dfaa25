"""A package that the developer has indented otherwise stays so; what comes is indented alike."""

import re

import pytest

from hooks.merge.indentation import indented
from hooks.merge.tree import File
from support.packages import changed
from support.repository import commit, git

SPEC = """\
<package name="arm" description="An arm" author="A" author_email="a@example.org" license="MIT">
  <node name="reach" frequency="10">
    <subscriber name="goal" type="std_msgs::Float64"/>
    <parameter name="gains" type="double[]" value="[1.0, 2.0]" description="Both"/>
    <parameter name="frame" type="string" value="map"/>
    <serviceServer name="load" type="std_srvs::Trigger"/>
    <serviceServer name="store" type="std_srvs::Trigger"/>
  </node>
</package>
"""
CHANGES = [
    ('name="goal"', 'name="target" was="goal"'),
    ('    <parameter name="frame" type="string" value="map"/>\n', ""),
    ('    <serviceServer name="load" type="std_srvs::Trigger"/>\n', ""),
    (
        "  </node>",
        '    <serviceServer name="reset" type="std_srvs::Empty"/>\n'
        '    <parameter name="limit" type="double" value="2.0" description="Highest"/>\n  </node>',
    ),
]
FILES = re.compile(r"(arm/.*|test/[^/]*|setup)\.py|config/.*\.yaml|(src|include)/.*\.[ch]pp")


def indent(text, step, unit):
    return re.sub(rf"(?m)^(?:{step})+", lambda m: unit * (len(m[0]) // len(step)), text)


@pytest.mark.parametrize(
    ("model", "units"),
    [
        ("python_model", {".py": "  ", ".yaml": " " * 4}),
        ("python_model", {".py": "\t", ".yaml": " " * 6}),
        ("cpp_model", {".cpp": " " * 4, ".hpp": "\t", ".py": " " * 8, ".yaml": " " * 3}),
    ],
)
def test_package_stays_indented_as_it_is(render, update, model, units):
    """It becomes what it would be if it were indented after the update."""
    packages = [render(SPEC, model=model, name=f"{name}/arm") for name in ("before", "after")]

    def reformat(package):
        for path in git(package, "ls-files").splitlines():
            file = package / path
            if FILES.fullmatch(path) and file.suffix in units:
                step = " " * (4 if file.suffix == ".py" else 2)
                file.write_text(indent(file.read_text(), step, units[file.suffix]))

    for package in packages:
        logic = package / ("arm/reach_impl.py" if "python" in model else "src/reach_impl.cpp")
        text = logic.read_text()
        logic.write_text(re.sub("return [Tt]rue", "return use(config)", text, count=1))
        tuned = package / "config/reach.yaml"
        tuned.write_text(changed(tuned.read_text(), ("1.0", "1.5")))
    reformat(packages[0])
    for package in packages:
        spec = package / "arm.ros_package"
        spec.write_text(changed(spec.read_text(), *CHANGES))
        commit(package, "Edit")
        update(package)
    reformat(packages[1])
    for path in git(packages[1], "ls-files").splitlines():
        if FILES.fullmatch(path) or path.endswith(".md"):
            texts = [(package / path).read_text() for package in packages]
            assert texts[0] == texts[1], path
            assert "<<<<<<<" not in texts[0]


BLOCK = "class A:\n    def f(self):\n        return 1\n\n    def g(self):\n        return 2\n"
DEEPER = BLOCK.replace("\n    ", "\n        ").replace("class", "    class")


@pytest.mark.parametrize(
    ("path", "old", "mine", "wanted"),
    [
        ("a.py", "x = 1\n" + BLOCK, f"x = 1\nif x:\n{DEEPER}", None),
        ("a.py", BLOCK, BLOCK.replace("    return 1", "    if self:\n            return 1"), None),
        ("a.py", BLOCK, indent(BLOCK, "    ", " ").replace("2", "3"), " "),
        ("a.py", BLOCK, indent(BLOCK, "    ", " ") + "if a:\n    b\n", " "),
        ("a.py", BLOCK, indent(BLOCK, "    ", "\t").replace("\n", "\r\n"), "\t"),
        ("a.yaml", "a:\n  b: 1\n  c: 2\n", "own:\n  a:\n    b: 1\n    c: 2\n", None),
        ("a.xml", "<a>\n    <b/>\n</a>\n", "<a>\n  <b/>\n</a>\n", None),
    ],
)
def test_what_is_wrapped_is_not_indented_otherwise(path, old, mine, wanted):
    trees = [{path: File(text.encode())} for text in (mine, old, old)]
    found = indented(*trees, str)
    text = indent(old, "    ", wanted) if wanted else old
    assert [tree[path].text for tree in found] == [text, text]
