"""Parameter files get the depth that those of another ROS have, before they are merged."""

import pytest

from hooks.merge.depth import shifts
from hooks.merge.tree import File, encode

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
    """Give a text the depth of a new version; nothing where that is as deep as the old one."""
    trees = [{path: File(encode(side))} for side in (old, new)]
    found = shifts(*trees, lambda path: path)
    return found[path](text) if found else None


def test_what_is_put_below_keys():
    assert shift(FLAT, DEEP, FLAT) == DEEP
    assert shift(FLAT, DEEP, MINE) == MINE_DEEP


def test_what_is_raised():
    assert shift(DEEP, FLAT, DEEP) == FLAT
    assert shift(DEEP, FLAT, MINE_DEEP) == MINE


@pytest.mark.parametrize("text", ["", "- a\n", "{rate: 10}\n", "rate: [\n", "# Nothing\n"])
def test_what_has_no_keys_below_one_another_stays(text):
    assert shift(FLAT, DEEP, text) == text


@pytest.mark.parametrize("old", ["/**:", "reach:", "/**:  # mine"])
def test_other_keys_above_stay(old):
    """As it came, or it would lose what the developer wrote there."""
    mine = MINE_DEEP.replace("/**:", old)
    assert shift(DEEP, FLAT, mine) == (MINE if old == "/**:" else mine)


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


def test_other_languages():
    assert shift(FLAT, DEEP, MINE, path="config/reach.txt") is None
