"""Which differences are of form alone: blanks around words are, those of a value are not."""

import pytest

from hooks.merge.languages import language
from hooks.merge.package import merge_package
from hooks.merge.proof import prove
from hooks.merge.renaming import Renaming
from hooks.merge.tree import File


def merge(path, mine, old, new):
    """Merge a file; return its text, and the numbers of the proof."""
    trees = [{path: File(text.encode())} for text in (mine, old, new)]
    result = merge_package(*trees, Renaming(), {""}.__contains__)
    assert not result.conflicts
    proof = prove(*trees[:2], result, result.tree, Renaming())
    assert proof.lost == []
    return result.tree[path].text, (proof.total, proof.in_place)


VALUES = {
    "config/n.yaml": "n:\n  # {1}\n  indent: {0}\n  rate: {2}\n",
    "CMakeLists.txt": "project(n)\n\n# {1}\nset(INDENT {0})\nset(RATE {2})\n",
    "launch/n.launch.xml": (
        '<launch>\n  <!-- {1} -->\n  <arg name="indent" default={0}/>\n'
        '  <arg name="rate" default="{2}"/>\n</launch>\n'
    ),
    "setup.py": "# {1}\nINDENT = {0}\nRATE = {2}\n",
    "n.hpp": "// {1}\nconst auto indent = {0};\nconst auto rate = {2};\n",
}


@pytest.mark.parametrize("path", VALUES)
@pytest.mark.parametrize(
    ("old", "mine"), [('"  "', '"    "'), ('"a b"', '"a  b"'), ('"a=b"', '"a = b"')]
)
def test_value_that_differs_in_blanks_alone_stays(path, old, mine):
    form = VALUES[path].format
    found = merge(path, form(mine, "d", 1), form(old, "d", 1), form(old, "e", 1))
    assert found == (form(mine, "e", 1), (1, 1))


@pytest.mark.parametrize("path", VALUES)
@pytest.mark.parametrize(
    ("old", "new"), [('"  "', '"    "'), ('"a b"', '"a  b"'), ('"a > b"', '"a>b"')]
)
def test_default_that_changes_in_blanks_alone_comes(path, old, new):
    form = VALUES[path].format
    found = merge(path, form(old, "d", 2), form(old, "d", 1), form(new, "d", 1))
    assert found == (form(new, "d", 2), (1, 1))


@pytest.mark.parametrize("mine", ["a:\n  b: |\n    x  y\n", "a:\n  b: |\n    x y\n  c:\n"])
def test_text_of_several_lines_counts_with_its_blanks(mine):
    assert not language("a.yaml", "").same("a:\n  b: |\n    x y\n", mine)
    assert not language("a.yaml", "").same("a:\n  b:\n    c: 1\n", "a:\n  b:\n  c: 1\n")
    assert not language("a.md", "").same("```\na:\n  b\n```\n", "```\na:\n    b\n```\n")
    assert not language("a.cmake", "").same("set(A [[x y]])\n", "set(A [[x  y]])\n")


@pytest.mark.parametrize(
    ("path", "one", "other"),
    [
        ("a.yaml", "a: 'x  y'  # don't\nb: 'z'\n", 'a:   "x  y" # don\'t\nb: "z"\n'),
        ("a.yaml", "a:\n- 1\n- b:  x y\n", "a:\n  - 1\n  - b: x y\n"),
        ("a.yaml", "a: x y\n", "a: 'x y'\n"),
        ("a.yaml", "    a: 'it''s'\n", '    a: "it\'s"\n'),
        ("a.yaml", "\ta:  'x'\n", '\ta: "x"\n'),
        ("CMakeLists.txt", 'set(A\n  "x  y")  # a "\n', 'set(A "x  y") # a "\n'),
        (
            "CMakeLists.txt",
            'IF(A)\n  SET (a "SET (a)")\nENDIF()\n',
            'if(A)\nset(a "SET (a)")\nendif()\n',
        ),
        ("a.xml", "<a  b = 'x  y' />\n", '<a b="x  y"/>\n'),
        ("a.xml", "<a>it's  so</a>\n<b c='d'/>", '<a>it\'s so</a>\n<b c="d" />'),
        ("a.xml", '<a b="1"\n   c="2">', '<a b="1" c="2">'),
        ("a.md", "A text\nof two  lines.\n", "A text of\ntwo lines.\n"),
        ("a.py", "a = 'x\\n'\n", 'a = "x\\n"\n'),
        ("a.py", "use(\n    one,\n", "use(one,\n"),
    ],
)
def test_form_does_not_count(path, one, other):
    assert language(path, one).same(one, other)


@pytest.mark.parametrize(
    ("path", "one", "other"),
    [
        ("a.yaml", 'a: "don\'t  1"\n', 'a: "don\'t 1"\n'),
        ("a.yaml", "a: '\\n'\n", 'a: "\\n"\n'),
        ("a.yaml", "a: 1  # mine\n", "a: 1\n"),
        ("a.yaml", "a: 1\n", "a: '1'\n"),
        ("a.yaml", "%YAML 1.1\n---\na: 1\n", "---\na: 1\n"),
        ("a.yaml", "---\na: 1\n", "a: 1\n"),
        ("a.yaml", "a: &b 1\n", "a: 1\n"),
        ("a.yaml", "a: !!str 1\n", "a: 1\n"),
        ("a.yaml", "a: |  # mine\n  x\n", "a: |\n  x\n"),
        ("CMakeLists.txt", 'set(a "SET (a)")\n', 'set(a "set (a)")\n'),
        ("CMakeLists.txt", "set(a B)\n", "set(a b)\n"),
        ("CMakeLists.txt", '# it\'s "\nset(A "x  y")\n', '# it\'s "\nset(A "x y")\n'),
        ("a.py", "use(one,\n", "use(two,\n"),
        ("a.xml", "<!-- = \" -->\n<a b='x  y'/>\n", "<!-- = \" -->\n<a b='x y'/>\n"),
    ],
)
def test_content_counts(path, one, other):
    assert not language(path, one).same(one, other)


SEP = "  sep: |\n    a: b\n    # not a comment\n"
KEYS = {"sep": SEP, "k": "  k: 1\n", "z": "  # of z\n  z: 2\n"}


def parameters(order, **others):
    return "n:\n" + "".join((KEYS | others)[name] for name in order.split())


@pytest.mark.parametrize("sign", ["|", ">", "|-", "|+", "|2", ">2-", "| # mine", "!!str |"])
@pytest.mark.parametrize("order", ["sep z", "z k sep", "k z sep", "sep new k z"])
@pytest.mark.parametrize(
    "text", ["a: b\n    # not", "# not\n    a: b", "a:\n\n    # not\n      # this", "- a\n    #"]
)
def test_text_of_several_lines_keeps_what_looks_like_a_comment(sign, order, text):
    new = {"new": "  new: 3\n"}
    sep = f"  sep: {sign}\n    {text}\n"
    mine = parameters("sep k z", sep=sep)
    before = {"sep": "  sep: a\n"}
    found, _ = merge(
        "config/n.yaml", mine, parameters("sep k z", **before), parameters(order, **before, **new)
    )
    assert found == parameters(order, sep=sep, **new)


def test_comment_below_a_text_of_several_lines_is_one():
    own = "  sep: |\n\n      a\n    # mine\n"
    before = {"sep": "  sep: a\n"}
    mine = parameters("k sep z", sep=own)
    sides = (parameters(order, **before) for order in ("k sep z", "sep z k"))
    found, numbers = merge("config/n.yaml", mine, *sides)
    assert "  sep: |\n\n      a\n" in found
    assert found.count("    # mine\n") == 1
    assert numbers[0] == numbers[1]


def test_line_of_a_quoted_text_is_no_comment():
    own = '  sep: "a\n    # not\n\n    k: b"\n'
    before = {"sep": "  sep: a\n"}
    mine = parameters("sep k z", sep=own)
    sides = (parameters(order, **before) for order in ("sep k z", "z sep"))
    assert merge("config/n.yaml", mine, *sides)[0] == parameters("z sep", sep=own)
