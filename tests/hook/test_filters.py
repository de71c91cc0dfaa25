"""What the filters of templates make of a value, as docs/designers.md has them."""

import jinja2
import pytest
from jinja2_ansible_filters.core_filters import to_yaml

from extensions import cpp, python, text
from extensions.layout import LayoutExtension, fold_python
from extensions.paths import PathsExtension, all_of, value_of
from hooks import names


@pytest.mark.parametrize(
    ("function", "arguments", "wanted"),
    [
        (names.identifier, ("~/arm/pose",), "arm_pose"),
        (names.member, ("axis.x",), "axis_x"),
        (names.member, ("lambda",), "lambda_"),
        (names.member, ("str",), "str_"),
        (names.member, ("EOF",), "EOF_"),
        (names.ros_type, ("a/msg/B", 1), "a/B"),
        (names.ros_type, ("a/msg/B", 2), "a/msg/B"),
        (python.python_type, ("double",), "float"),
        (python.python_type, ("string[]",), "Sequence[str]"),
        (python.python_type, ("std_msgs/msg/String",), "std_msgs.msg.String"),
        (python.rclpy_type, ("int",), "INTEGER"),
        (python.rclpy_type, ("double[]",), "DOUBLE_ARRAY"),
        (python.python_module, ("a/action/B",), "a.action"),
        (python.python_module, ("a/action/B", 1), "a.msg"),
        (python.python_part, ("a/srv/B", "Request", 2), "a.srv.B.Request"),
        (python.python_part, ("a/action/B", "Goal", 1), "a.msg.BGoal"),
        (python.ros1_action, ("a/action/B",), "a.msg.BAction"),
        (python.ros1_module, ("a/action/B",), "a.msg"),
        (python.rospy_name, ("~/pose",), "~pose"),
        (python.rospy_name, ("/a~/b~/c",), "/a~b~/c"),
        (python.python_value, (1e22, 4), "1e22"),
        (python.python_value, ([1], 4), "(1,)"),
        (python.python_value, (["a", "it's"], 4), "('a', \"it's\")"),
        (python.python_value, (["a" * 50, "b" * 37], 4), f"('{'a' * 50}', '{'b' * 37}')"),
        (
            python.python_value,
            (["a" * 50, "b" * 37], 5),
            f"(\n         '{'a' * 50}',\n         '{'b' * 37}',\n     )",
        ),
        (python.python_value, (["a" * 92, "b"], 0), f"(\n    '{'a' * 92}',\n    'b',\n)"),
        (python.zero_value, ("bool",), False),
        (python.zero_value, ("string",), ""),
        (python.zero_value, ("double",), 0.0),
        (python.zero_value, ("bool[]",), []),
        (python.cfg_value, (["a" * 50, "b" * 36],), f"('{'a' * 50}', '{'b' * 36}')"),
        (python.python_text, ("it's 'so' \"\\", 0), "\"it's 'so' \\\"\\\\\""),
        (python.python_text, ("a" * 96, 0, 1), f"'{'a' * 96}'"),
        (python.python_text, ("a" * 96, 0, 2), f"(\n    '{'a' * 93}'\n    '{'a' * 3}'\n)"),
        (
            python.python_text,
            ("bb " * 33, 1),
            "(\n     '" + "bb " * 30 + "bb'\n     ' bb bb '\n )",
        ),
        (
            python.sort_imports,
            ("import b\nimport os\nfrom b import A\nimport b\n",),
            "import os\n\nimport b\nfrom b import A\n",
        ),
        (cpp.cpp_type, ("string[]",), "std::vector<std::string>"),
        (cpp.cpp_type, ("int",), "std::int64_t"),
        (cpp.cpp_type, ("double",), "double"),
        (cpp.cpp_type, ("a/msg/B",), "a::msg::B"),
        (cpp.cpp_type, ("a/msg/B", 1), "a::B"),
        (cpp.cpp_header, ("a/msg/PoseXYStamped", 2), "a/msg/pose_xy_stamped.hpp"),
        (cpp.cpp_header, ("a/msg/PoseXY", 1), "a/PoseXY.h"),
        (cpp.cpp_header, ("a/action/Move", 1), "a/MoveAction.h"),
        (cpp.cpp_guard, ("all_kinds/goal.hpp",), "ALL_KINDS__GOAL_HPP_"),
        (cpp.cpp_comment, ("// a\\\n// TODO\n// b??/",), "// a\\.\n// todo\n// b??/."),
        (
            cpp.sort_includes,
            ('#include <b>\nx\n#include "z.hpp"\n#include <a>\n#include "y.hpp"\n#include <b>\n',),
            '#include <a>\n#include <b>\n\n#include "y.hpp"\n#include "z.hpp"\n',
        ),
        (cpp.sort_includes, ('#include "z.hpp"',), '#include "z.hpp"\n'),
        (text.wrap, ("a b  c", "# ", 6), "# a b\n# c"),
        (text.wrap, ("abcdefghi", "# ", 6), "# abcd\n# efgh\n# i"),
        (text.wrap, ("\u4e2d\u4e2d\u4e2d", "# ", 6), "# \u4e2d\u4e2d\n# \u4e2d"),
        (text.wrap, ("see https://example.org/a", "# ", 6), "# see\n# https://example.org/a"),
        (text.wrap, ("", "# ", 6), "#"),
        (text.xml, ("a < b & c",), "a &lt; b &amp; c"),
        (text.xml_attribute, ('a "b"',), "'a \"b\"'"),
        (text.markdown, ("a|b *c*\n d",), "a\\|b \\*c\\* d"),
        (text.mermaid, ('a "#" <b>\nc',), '"a #quot;#35;#quot; #lt;b#gt; c"'),
        (text.yaml, ([1e22, "a\x85", True, None],), '[1.0e+22, "a\\u0085", true, null]'),
        (text.yaml, ("1e5",), '"1e5"'),
        (text.yaml_key, ("Y",), "'Y'"),
        (text.yaml_key, ("yes",), "'yes'"),
        (text.yaml_key, ("x",), "x"),
        (text.plain, (10.0,), "10"),
        (text.plain, (0.5,), "0.5"),
        (text.is_spdx, ("Apache-2.0 OR MIT",), True),
        (text.is_spdx, ("All mine",), False),
    ],
)
def test_value_of_a_filter(function, arguments, wanted):
    assert function(*arguments) == wanted


LONG = "a" * 60


def test_python_that_is_too_long_is_folded_where_it_is_code():
    assert fold_python("def (\n") == "def (\n"  # what is no Python stays
    assert fold_python(f"x = {LONG}({LONG})\n") == f"x = {LONG}(\n    {LONG}\n)\n"
    assert fold_python(f"{LONG} = [\n    1,\n]\n") == f"{LONG} = [\n    1,\n]\n"
    items = ["f(1, 2)", LONG, f"g({LONG}, b)"]
    folded = "".join(f"    {item},\n" for item in items)
    assert fold_python(f"x = [{', '.join(items)}]\n") == f"x = [\n{folded}]\n"
    value = f"{LONG}(\n    1,\n)"
    assert fold_python(f"{LONG} = {value}\n") == (
        f"{LONG} = (\n    {LONG}(\n        1,\n    )\n)\n"
    )
    inside = f"    {LONG}={value}".replace("\n", "\n    ")
    folded = f"    {LONG}=(\n        {LONG}(\n            1,\n        )\n    )"
    for end in ("", ",", ",\n    c=2,"):
        assert fold_python(f"f(\n{inside}{end}\n)\n") == f"f(\n{folded}{end}\n)\n"


@pytest.mark.parametrize(
    "text",
    [
        f"x = = f({LONG}, {LONG})\n",
        f'x = """\nf({LONG}, {LONG})\n"""\n',
        f'x = """\nf({LONG}, {LONG})\n""", 1\n',
    ],
)
def test_what_folding_would_change_stays(text):
    assert fold_python(text) == text


def test_python_that_just_fits_is_not_folded():
    for letters, inside in ((88, "f({})"), (89, "f(\n        {}\n    )")):
        name = "b" * letters
        folded = f"g(\n    {LONG}\n    or {inside.format(name)},\n)\n"
        assert fold_python(f"g(\n    {LONG} or f({name}),\n)\n") == folded
    for letters, inside in ((95, "(\n    {}\n)"), (96, "{}  # noqa: E501")):
        name = "b" * letters
        assert fold_python(f"value = {name}\n") == f"value = {inside.format(name)}\n"
    fits = f"{'a' * 50} = {'b' * 45}(\n    1,\n)\n"
    assert fold_python(f"{fits}{LONG}({LONG})\n") == f"{fits}{LONG}(\n    {LONG}\n)\n"
    head, folded = f"{LONG}: A[{LONG}] = [\n", f"{LONG}: A[\n    {LONG}\n] = ["
    for letters, inside in ((93, "{}"), (94, "\n    {}\n")):
        name = "b" * letters
        assert fold_python(f"{head}    {name}\n]\n") == folded + inside.format(name) + "]\n"
    text = f'x: A[{LONG}] = [\n    """{LONG}""",\n]\n'
    assert fold_python(text.replace("x", LONG)) == text.replace("x", LONG).replace(
        f"A[{LONG}]", f"A[\n    {LONG}\n]"
    )


@pytest.mark.parametrize("form", ["x = (%s, %s\n", "x = = f(%s, %s)\n"])
def test_text_that_is_no_python_is_not_folded(form):
    text = form % ("a" * 60, "b" * 60)
    assert fold_python(text) == text


@pytest.mark.parametrize(
    "said",
    ["plain", "it's", "a: b", "ü", "😀", "a\\b", "a\tb", "two\nlines", "", "no", "long " * 40],
)
def test_answers_are_written_as_copier_writes_them(said):
    values = {"_commit": "1.0.0", "spec": {"name": said, "nodes": [{"tag": said, "more": [said]}]}}
    assert text.answers(values) == to_yaml(values, width=100)


def test_only_python_without_a_frame_is_folded():
    layout = LayoutExtension(jinja2.Environment())
    assert layout.preprocess("x", "a.py.jinja") == "{% filter fold_python %}x{% endfilter %}"
    for source, name in (("x", "a.cpp.jinja"), ("x", None), ("{% extends 'a' %}", "a.py.jinja")):
        assert layout.preprocess(source, name) == source


def test_name_of_a_file_stands_for_those_of_each_component():
    paths = PathsExtension(jinja2.Environment())
    assert paths.preprocess("[spec.arm]", None) == (
        "{% yield part from spec | parts('arm', ros_distro) %}.{% endyield %}"
    )
    assert paths.preprocess("[node.name]_a.py", None).endswith(
        "%}{{ node | value_of('name', 'node') }}_a.py{% endyield %}"
    )
    for source, name in (("[node.name] a", None), ("[node.name]", "a.md"), ("a.py", None)):
        assert paths.preprocess(source, name) == source


def test_what_a_name_of_a_file_is_made_of():
    spec = {
        "name": "arm",
        "nodes": [{"tag": "node", "name": "n", "topics": [{"name": "t"}]}, {"tag": "node"}],
        "texts": ["a"],
        "shared": [{"topics": [{"name": "of no component"}]}],
    }
    assert all_of(spec, "node", ["node", "topic"]) == spec["nodes"]
    assert all_of(spec, "topic") == [{"name": "t", "node": spec["nodes"][0]}]
    assert all_of(spec, "leg") == []
    with pytest.raises(jinja2.TemplateRuntimeError) as caught:
        all_of(spec, "leg", ["node", "topic"])
    assert str(caught.value) == 'unknown tag "leg"; allowed: node, topic'
    assert all_of(spec, "node", ["node"], {"name": "of the folder"}) == [{"name": "of the folder"}]
    with pytest.raises(jinja2.TemplateRuntimeError) as caught:
        all_of(spec, "node", ["node"], "an answer")
    assert str(caught.value) == '"node" is an answer, too; give the tag another name'
    assert value_of("n", "name", "node") == value_of({"name": "n"}, "name", "node") == "n"
    with pytest.raises(jinja2.TemplateRuntimeError) as caught:
        value_of({"name": "n", "label": "l", "topics": []}, "lable", "node")
    assert str(caught.value) == 'node has no attribute "lable"; allowed: label, name'
