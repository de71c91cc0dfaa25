"""Parameter files get the depth that those of another ROS have, before they are merged."""

import pytest

from hooks.merge.depth import shifts
from hooks.merge.renaming import Renaming
from hooks.merge.tree import File, encode
from hooks.merge.versions import Versions

FLAT = "# Of reach\n\n# The rate\nrate: 10  # Hz\ngains: [1, 2]\n"
DEEP = """\
# Of reach

/**:
  ros__parameters:
    # The rate
    rate: 10  # Hz
    gains: [1, 2]
"""
MINE = """\
# Of reach

# Mine
# The rate
rate: 20  # Hz
gains:
- 3

- 4
own:
  text: |
    two
      lines
"""
MINE_DEEP = """\
# Of reach

/**:
  ros__parameters:
    # Mine
    # The rate
    rate: 20  # Hz
    gains:
    - 3

    - 4
    own:
      text: |
        two
          lines
"""


def shift(old, new, text, path="config/reach.yaml"):
    """Give a text the depth of a new version; nothing where that is as deep, or it cannot be."""
    return (shift_all(old, new, text, path) or [None])[0]


def shift_all(old, new, text, path="config/reach.yaml"):
    """Do so, with the numbers of the lines that stay behind."""
    trees = [{path: File(encode(side))} for side in (old, new)]
    found = shifts(*trees, lambda path: path)
    return found[path](text) if found else None


def test_what_is_put_below_keys():
    assert shift(FLAT, DEEP, FLAT) == DEEP
    assert shift(FLAT, DEEP, MINE) == MINE_DEEP


def test_comment_in_the_first_line_goes_with_its_key_unless_the_file_begins_so():
    above = "/**:\n  ros__parameters:\n"
    assert shift(FLAT, DEEP, "# Mine\nrate: 1\n") == f"{above}    # Mine\n    rate: 1\n"
    assert shift(FLAT, DEEP, "# Of reach\nrate: 1\n") == f"# Of reach\n{above}    rate: 1\n"


def test_comment_that_an_empty_line_parts_from_its_key_goes_with_it():
    mine, wanted = (text.replace("# Mine\n", "# Mine\n\n") for text in (MINE, MINE_DEEP))
    assert shift(FLAT, DEEP, mine) == wanted


def test_what_is_raised():
    assert shift(DEEP, FLAT, DEEP) == FLAT
    assert shift(DEEP, FLAT, MINE_DEEP) == MINE


@pytest.mark.parametrize("text", ["", "- a\n", "rate: [\n", "# Nothing\n"])
def test_what_has_no_keys_below_one_another_stays(text):
    assert shift(FLAT, DEEP, text) == text


@pytest.mark.parametrize("name", ["'/**'", "reach", "/reach", '"/reach"', "/**/reach"])
def test_keys_that_name_the_node(name):
    assert shift(DEEP, FLAT, MINE_DEEP.replace("/**", name)) == MINE


@pytest.mark.parametrize("head", ["/left/reach:", "each:", "/**:  # mine", "'reach':  # mine"])
def test_other_keys_above_are_said_to_stay_behind(head):
    mine = MINE_DEEP.replace("/**:", head)
    assert shift_all(DEEP, FLAT, mine) == (MINE, [3])
    mine = mine.replace("parameters:", "parameters:  # mine too")
    assert shift_all(DEEP, FLAT, mine) == (MINE, [3, 4])


def test_comment_between_the_keys_above_comes_along():
    mine = MINE_DEEP.replace("/**:\n", "/**:\n  # Of ROS\n")
    assert shift(DEEP, FLAT, mine) == MINE.replace("# Mine", "# Of ROS\n# Mine")


LEFT = "# Mine\n/left/reach:\n  ros__parameters:\n    rate: 30\n"

STUCK = {
    "of several nodes": (DEEP, FLAT, f"{LEFT}/right/reach:\n  ros__parameters:\n    rate: 40\n"),
    "in one line": (DEEP, FLAT, "/**: {ros__parameters: {rate: 20}}\n"),
    "of another namespace": (DEEP, FLAT, f"{DEEP}  other: 1\n"),
    "in one line of ROS 1": (FLAT, DEEP, "{rate: 20, gains: [3]}\n"),
}


@pytest.mark.parametrize("case", STUCK)
def test_file_that_cannot_have_the_other_depth_is_for_the_developer_to_move(case):
    path = "config/reach.yaml"
    old, new, mine = STUCK[case]
    trees = [{path: File(encode(text))} for text in (mine, old, new)]
    renaming = Renaming()
    renaming.move(*trees[1:])
    result, doubts = Versions(*trees, renaming, to_ros=1).merged()
    assert ([*result.conflicts], doubts) == ([path], [])
    assert result.tree[path].text.startswith(f"<<<<<<< before updating\n{mine}=======\n")


@pytest.mark.parametrize(
    ("text", "behind"),
    [
        (f"{MINE_DEEP}\n{LEFT}", [17, 18, 19, 20]),
        (MINE_DEEP.replace("/**", f"{LEFT[7:]}\n/**"), [3, 4, 5]),
        (f"{MINE_DEEP}\n{LEFT[7:].replace('/left/', '')}", [17, 18, 19]),
    ],
)
def test_what_is_of_other_nodes_stays_behind(text, behind):
    found, lines = shift_all(DEEP, FLAT, text)
    assert found.strip() == MINE.strip()
    assert lines == behind


def test_files_of_nodes_in_folders():
    path = "config/left/reach.yaml"
    assert shift(DEEP, FLAT, MINE_DEEP.replace("/**", "/left/reach"), path) == MINE


def test_what_stays_behind_is_said():
    path, own = "config/reach.yaml", f"{DEEP}{LEFT}"
    trees = [{path: File(encode(text))} for text in (own, DEEP, FLAT)]
    renaming = Renaming()
    renaming.move(*trees[1:])
    made = Versions(*trees, renaming, to_ros=1)
    result, doubts = made.merged()
    assert (result.tree[path].text, result.conflicts, doubts) == (FLAT, {}, [])
    proof = made.proof(result, result.tree)
    assert [number for _, number, _ in proof.left] == [8, 9, 10, 11]
    assert proof.sentence.startswith("0 of 4 of your lines")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (FLAT, FLAT),
        (DEEP, DEEP),
        (FLAT, ""),
        ("", DEEP),
        (FLAT, "/**: {a: {b: 1, c: 2}}\n"),
        (FLAT, "/**:\n\n  ros__parameters:\n    rate: 1\n    gain: 2\n"),
    ],
)
def test_versions_of_one_depth(old, new):
    assert shift(old, new, MINE) is None


def test_keys_of_groups_have_the_sign_of_the_other_ros():
    old, new = "/**:\n  ros__parameters:\n    axis.x: 1\n", "axis/x: 1\n"
    renaming = Renaming()
    renaming.move(*({"config/reach.yaml": File(encode(text))} for text in (old, new)))
    assert renaming.keys == {"config/reach.yaml": {"axis.x": "axis/x"}}


def test_other_languages():
    assert shift(FLAT, DEEP, MINE, path="config/reach.txt") is None
