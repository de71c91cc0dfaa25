"""Every message has an id, and the page of messages says cause and cure of each."""

import ast
import re

import pytest

from scripts import messages
from support.repository import ROOT

ENTRIES = messages.entries()


def test_each_id_has_its_entry_on_the_page_and_no_entry_is_of_none():
    assert sorted(messages.texts()) == sorted(ENTRIES)


def test_no_message_is_without_an_id():
    """Other exceptions than these demand one (decision 143)."""
    for pattern in messages.CODE:
        for file in ROOT.glob(pattern):
            for node in ast.walk(ast.parse(file.read_text())):
                if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
                    told = ast.unparse(node.exc)
                    if file.name == "functions.py" and told.startswith("ValueError"):
                        assert len(node.exc.args) == 2, told
                    if file.name == "describe_node.py" and told.startswith("SystemExit"):
                        assert re.search(rf"\[{messages.ID}\]", told), told


@pytest.mark.parametrize("id_", [id_ for id_, entry in ENTRIES.items() if "test" not in entry])
def test_example_ends_with_its_id(id_, tmp_path):
    lines = messages.example(ENTRIES[id_], tmp_path).splitlines()
    assert lines
    assert all(line.endswith(f" [{id_}]") for line in lines), lines


@pytest.mark.parametrize("id_", [id_ for id_, entry in ENTRIES.items() if "test" in entry])
def test_another_test_shows_it(id_):
    file, _, name = ENTRIES[id_]["test"].partition("::")
    text = (ROOT / file).read_text()
    (test,) = (x for x in ast.parse(text).body if getattr(x, "name", "") == name)
    first = min(each.lineno for each in [test, *test.decorator_list])
    assert id_ in "\n".join(text.splitlines()[first - 1 : test.end_lineno])


def test_page_is_current():
    assert messages.PAGE.read_text() == messages.page()
