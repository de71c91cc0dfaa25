"""The tests are as tidy as what they test."""

import ast
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
MODULES = sorted(TESTS.rglob("*.py"))


def imports(file):
    """Return the names that the imports of a file name."""
    names = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names |= {node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)}
    return names


@pytest.mark.parametrize("file", MODULES, ids=lambda file: str(file.relative_to(TESTS)))
def test_no_module_imports_tests(file):
    parts = {part for name in imports(file) for part in name.split(".")}
    tests = {path.stem for path in MODULES if path.stem.startswith("test_")}
    assert not parts & {*tests, "conftest"}


def test_readme_names_every_folder():
    readme = (TESTS / "README.md").read_text()
    folders = [path.name for path in TESTS.iterdir() if path.is_dir() and path.name[0] != "_"]
    assert folders
    for folder in folders:
        assert f"\n{folder}/ " in readme, folder
