"""The tests are as tidy as what they test."""

import ast
import re
from pathlib import Path

import pytest
import yaml

from hooks import ros

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


ROOT = TESTS.parent
PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("*/README.md")]


def test_make_targets_of_the_documentation():
    makefile = (ROOT / "Makefile").read_text()
    targets = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)[1].split()
    texts = [re.sub(r"\s+", " ", page.read_text()) for page in PAGES]
    told = {name for text in texts for name in re.findall(r"[`(]make ([a-z]+)", text)}
    assert {"demo", "test", "accept", "lab"} <= told <= {*targets}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_of_the_documentation(page):
    for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text()):
        assert (page.parent / link).exists(), link


def test_paths_of_the_guide_for_contributors():
    guide = (ROOT / "CONTRIBUTING.md").read_text()
    paths = [
        path for path in re.findall(r"`([\w./*-]+)`", guide) if re.search(r"[/*]|\.\w+$", path)
    ]
    assert len(paths) > 20
    for path in paths:
        assert [*ROOT.glob(path), *ROOT.glob(f"*_model/{path}")], path


def test_linters_before_a_commit_are_those_of_the_tests():
    hooks = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text())["repos"][0]["hooks"]
    makefile = (ROOT / "Makefile").read_text()
    for hook in hooks:
        assert f"\n\t{hook['entry'].replace('.venv/tools', '$(TOOLS)')}" in makefile, hook["entry"]
    assert len(hooks) == len(re.findall(r"^\t\$\(TOOLS\)/bin/(?:ruff|mypy)", makefile, re.M)) / 2


LISTS = {
    "README.md": r"chooses the ROS \(([\w, ]+)\)",
    ".github/workflows/test.yml": r"distro: \[([\w, ]+)\]",
    "starter_model/template/copier.yml.starter": r"choices: \[([\w, ]+)\]",
}


@pytest.mark.parametrize("path", LISTS)
def test_distributions_that_are_listed(path):
    listed = re.search(LISTS[path], (ROOT / path).read_text())[1].split(", ")
    assert listed == [
        distro for distro in ros.DISTROS if distro == listed[0] or ros.DISTROS[distro] > 1
    ]
