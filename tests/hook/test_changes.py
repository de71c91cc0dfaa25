"""What has changed from one spec to the next, and where a render shows what a rename exchanges."""

import itertools

import pytest

from hooks.changes import Mark, as_parted, changed_answers, changes, left, marked
from hooks.dictionary import load

DICTIONARY = """
package_attributes: [name, description]
node_attributes:
  - name: {format: component_name, unique: true}
  - executable: {format: file_name, same_as: name}
  - rate: {format: number, optional: true}
node_interface:
  topic: [name, type]
"""


@pytest.fixture
def dictionary(tmp_path):
    (tmp_path / "dictionary.yaml").write_text(DICTIONARY)
    return load(tmp_path / "dictionary.yaml", tmp_path)


def node(name, *topics, executable=None, rate=None, was=None):
    found = {"name": name, "executable": executable or name, "rate": rate, "class_name": "X"}
    found["topics"] = [dict(zip(("name", "type", "was"), topic, strict=False)) for topic in topics]
    return {**found, "was": was} if was else found


def spec(*nodes, name="arm", description="An arm", **others):
    return {"name": name, "description": description, "nodes": [*nodes], **others}


A, B = ("a", "T"), ("b", "T")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (spec(node("n", A)), spec(node("n", A)), []),
        (spec(node("n", A)), spec(node("n", A, B)), ["+ topic b on n"]),
        (spec(node("n", A)), spec(node("n")), ["- topic a on n"]),
        (spec(node("n", A)), spec(), ["- node n"]),
        (spec(), spec(node("n", A)), ["+ node n"]),
        (spec(node("n", A)), spec(node("n", ("a", "S"))), ["~ topic a on n: type T -> S"]),
        (spec(node("n", A)), spec(node("n", ("b", "T", "a"))), ["> topic b on n, was a"]),
        (  # of two that have swapped their names, one is renamed by another developer
            spec(node("n", ("a", "T", "b"), ("b", "T", "a"))),
            spec(node("n", ("c", "T", "b"), ("b", "T", "a"))),
            ["> topic c on n, was a"],
        ),
        (spec(node("n")), spec(node("m", was="n")), ["> node m, was n"]),
        (
            spec(node("n")),
            spec(node("m", was="n", executable="n")),
            ["> node m, was n", "~ node m: executable n -> n"][:1],
        ),
        (
            spec(node("n")),
            spec(node("n", executable="m")),
            ["~ node n: executable n -> m"],
        ),
        (spec(node("n")), spec(node("n", rate=2)), ["~ node n: rate None -> 2"]),
        (spec(name="arm"), spec(name="leg", was="arm"), ["> package, was arm"]),
        (spec(name="arm"), spec(name="leg"), []),
        (
            spec(),
            spec(description="x" * 41),
            [f'~ package: description An arm -> "{"x" * 37}..."'],
        ),
        (spec(), spec(description="x" * 40), [f"~ package: description An arm -> {'x' * 40}"]),
        (spec(), spec(description=""), ['~ package: description An arm -> ""']),
    ],
)
def test_what_is_said_of_a_change(dictionary, old, new, said):
    assert [*changes(old, new, dictionary)] == said


TO_B, TO_C = ("b", "T", "a"), ("c", "T", "b")


@pytest.mark.parametrize(
    ("ours", "theirs", "new", "said"),
    [
        ([A], [TO_B, TO_C], TO_C, ["> topic c on n, was a"]),
        ([A], [TO_B, B], B, ["> topic b on n, was a"]),
        ([TO_B, TO_C], [A], TO_C, []),
        (
            [TO_B, TO_C],
            [("x", "T", "a"), ("y", "T", "x")],
            ("y", "T", "x"),
            ["> topic y on n, was c"],
        ),
        ([A], [TO_B, ("a", "T", "b")], ("a", "T", "b"), []),
        ([("x", "T", "a")], [TO_B, ("a", "T", "b")], ("a", "T", "b"), ["> topic a on n, was x"]),
        ([], [A, TO_B], TO_B, ["+ topic b on n"]),
        ([A], [TO_B], ("z", "T", "b"), ["> topic z on n, was a"]),
        ([TO_B, TO_C], [A], ("z", "T", "b"), ["> topic z on n, was c"]),
        ([A], [TO_B, TO_C], ("z", "T", "b"), ["> topic z on n, was a"]),
        ([("b", "T", "a")], [("c", "T", "a")], ("z", "T", "c"), ["> topic z on n, was b"]),
        ([B, ("p", "T", "b")], [B, ("q", "T", "b")], ("q", "T", "b"), ["> topic q on n, was p"]),
        ([A], [None, A, TO_B, TO_C], TO_C, ["> topic c on n, was a"]),
        (
            [A],
            [None, ("x", "T"), ("y", "T", "x")],
            ("y", "T", "x"),
            ["+ topic y on n", "- topic a on n"],
        ),
    ],
)
def test_what_branches_have_renamed_more_than_once(dictionary, ours, theirs, new, said):
    """Each changes a topic step by step; what one has renamed is that which the other has."""
    base = spec(node("n", *([A] if ours else [])))
    histories = [
        [base, *(spec(node("n", *filter(None, [step]))) for step in steps)]
        for steps in (ours, theirs)
    ]
    contexts = as_parted(histories, spec(node("n", new)), dictionary)
    assert [*changes(*contexts, dictionary)] == said


def test_names_that_were_swapped_and_no_longer_say_so(dictionary):
    """The branch that swapped them has dropped `was`; a third history knows of no swap."""
    base, swapped = spec(node("n", A, B)), spec(node("n", TO_B, ("a", "T", "b")))
    histories = [[base, base], [base, swapped, base], [base]]
    for order in itertools.permutations(histories):
        said = sorted(changes(*as_parted(order, base, dictionary), dictionary))
        is_theirs = order[0] is histories[1]
        assert said == ([] if is_theirs else ["> topic a on n, was b", "> topic b on n, was a"])


def test_names_of_what_left(dictionary):
    old = spec(node("n", A, B), node("m", A))
    assert [*left(old, spec(node("n", B)), dictionary)] == [("n", "a"), ("m", "m")]


def test_answers_that_changed():
    old = {"spec": 1, "_commit": "1", "license": "MIT", "distro": "", "gone": 1}
    new = {"spec": 2, "_commit": "2", "license": "BSD", "distro": "", "more": 1}
    assert [*changed_answers(old, new)] == ["~ license: MIT -> BSD"]


def test_marks_of_what_was_renamed(dictionary):
    """Of an interface, its component has one, too; and what is the same as the name has its."""
    old = spec(node("n", A, B, rate="n"), node("o", A, executable="a"), node("p", A))
    new = spec(
        node("n", ("c", "T", "a"), B, rate="n"),
        node("q", A, executable="a", was="o"),
        node("p", A),
    )
    context, marks = marked(old, new, dictionary)
    assert marks == [
        Mark("n", "n", "component"),
        Mark("a", "c", "interface", 0),
        Mark("o", "q", "component"),
    ]
    first, second, third = context["nodes"]
    assert (first["name"], first["executable"], first["class_name"]) == ("zq0x", "zq0x", "Zq0x")
    assert first["rate"] == "n"
    assert [topic["name"] for topic in first["topics"]] == ["zq1x", "b"]
    assert (second["name"], second["executable"]) == ("zq2x", "a")
    assert second["topics"][0]["name"] == "a"
    assert third == old["nodes"][2]
    assert old["nodes"][0]["name"] == "n"


def test_attribute_of_an_interface_that_is_called_as_a_component_names_none(dictionary):
    """Only what components share is named by its tag."""
    old, new = spec(node("n", A)), spec(node("m", A, was="n"))
    old["nodes"][0]["topics"][0]["node"] = "n"
    context, _ = marked(old, new, dictionary)
    assert context["nodes"][0]["name"] == "zq0x"
    assert context["nodes"][0]["topics"][0]["node"] == "n"


def test_marks_of_what_left_and_whose_name_is_taken(dictionary):
    old = spec(node("n", ("~/a", "T"), B))
    context, marks = marked(old, spec(node("n", ("b", "T", "~/a"))), dictionary)
    assert [(mark.before, mark.after, mark.is_gone) for mark in marks] == [
        ("n", "n", False),
        ("~/a", "b", False),
        ("b", "b__gone", True),
    ]
    assert [topic["name"] for topic in context["nodes"][0]["topics"]] == ["~/zq1x", "zq2x"]
    assert marked(old, old, dictionary) == (old, [])
