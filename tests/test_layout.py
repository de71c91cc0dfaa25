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
PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob("*/README.md")]


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


def body(function):
    """Return what a function does, with its variables named by their order."""
    own = {each.arg for each in ast.walk(function) if isinstance(each, ast.arg)}
    names = [each for each in ast.walk(function) if isinstance(each, ast.Name)]
    own |= {each.id for each in names if isinstance(each.ctx, ast.Store)}
    text = "\n".join(map(ast.unparse, function.body[ast.get_docstring(function) is not None :]))
    found = dict.fromkeys(word for word in re.findall(r"\w+", text) if word in own)
    numbers = {word: f"_{number}" for number, word in enumerate(found)}
    return re.sub(r"\w+", lambda match: numbers.get(match[0], match[0]), text)


def test_no_function_is_there_twice():
    patterns = ("hooks/**/*.py", "extensions/*.py", "*/functions.py", "scripts/*.py")
    places = {}
    for file in [file for pattern in patterns for file in ROOT.glob(pattern)]:
        for each in ast.walk(ast.parse(file.read_text())):
            if isinstance(each, ast.FunctionDef) and len(text := body(each)) > 45:
                place = f"{file.relative_to(ROOT).as_posix()}: {each.name}"
                places.setdefault(text, []).append(place)
    # What a literal of each language is wide; files of extensions import none of each other.
    own = ["cpp_model/functions.py: _columns", "extensions/python.py: _columns"]
    twins = [sorted(found) for found in places.values() if len(found) > 1]
    assert [found for found in twins if found != own] == []


def test_one_function_of_the_hooks_runs_git():
    files = [file for file in ROOT.glob("hooks/**/*.py") if "subprocess.run" in file.read_text()]
    assert [file.relative_to(ROOT).as_posix() for file in files] == ["hooks/git.py"]


def test_changelog_has_the_version():
    """What a user gets, in a few lines; a person tags it, as docs/releasing.md says."""
    version = re.search(r'^version = "(.+)"$', (ROOT / "pyproject.toml").read_text(), re.M)[1]
    first, *versions = re.split(r"^## ", (ROOT / "CHANGELOG.md").read_text(), flags=re.M)[1:]
    assert first.startswith("Unreleased\n")
    (text,) = [each for each in versions if each.startswith(f"{version}\n")]
    assert 5 < len(re.findall("^- ", text, re.M)) < 13


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


def test_distributions_are_named_in_one_place():
    """What one of them lacks is in the table of `hooks/ros.yaml`."""
    names = "|".join(distro for distro in ros.DISTROS if ros.DISTROS[distro] > 1)
    files = [
        file
        for pattern in ("hooks/**/*.py", "extensions/*.py", "shared/**/*", "[!s]*_model/**/*")
        for file in ROOT.glob(pattern)
        if file.suffix in (".py", ".jinja", ".yaml", ".yml")
    ]
    assert len(files) > 300
    for file in files:
        assert not re.findall(rf"""['"](?:{names})['"]""", file.read_text()), file


DECISIONS = sorted(ROOT.glob("docs/decisions/[0-9]*.md"))
STATUS = re.compile(
    r"\n\nStatus: (accepted|superseded by \[\d+\]\(\d{4}-[\w-]+\.md\))"
    r" \((20\d\d-\d\d-\d\d)(, changed 20\d\d-\d\d-\d\d)*\)\n\n"
)
CITATION = re.compile(r"\b[Dd]ecisions? (\d+)(?: and (\d+))?\b")
CODE = ("hooks", "extensions", "scripts", "shared", "tests", "docs", "*_model")
CITING = sorted(
    file
    for folder in CODE
    for file in ROOT.glob(f"{folder}/**/*")
    if file.suffix in (".py", ".yaml", ".yml", ".md", ".jinja", ".hpp") and file.is_file()
    if not file.is_relative_to(ROOT / "docs/decisions")
)


def cited(text):
    """Return the numbers of the decisions that a text cites."""
    return {int(number) for each in CITATION.findall(text) for number in each if number}


@pytest.mark.parametrize("file", DECISIONS, ids=lambda file: file.stem)
def test_decisions_have_a_number_and_a_status(file):
    text = file.read_text()
    assert text.startswith(f"# {int(file.name[:4])}. ")
    assert len(STATUS.findall(text)) == 1


def test_table_of_decisions_is_theirs():
    """All of them, in order within a section, where a new decision comes last."""
    table = (ROOT / "docs/decisions/README.md").read_text()
    rows = []
    for section in table.split("\n## "):
        found = re.findall(r"^\| \[(\d+)\]\((.+?)\) \| (.+) \| (.+) \|$", section, re.MULTILINE)
        assert found == sorted(found, key=lambda row: int(row[0]))
        rows += found
    known = []
    for file in DECISIONS:
        number, title = re.match(r"# (\d+)\. (.+)", file.read_text()).groups()
        known.append((number, file.name, title, STATUS.search(file.read_text())[1]))
    assert sorted(rows) == sorted(known)


def test_decisions_are_cited_where_they_explain_something():
    known = {int(file.name[:4]): STATUS.search(file.read_text())[1] for file in DECISIONS}
    numbers = {number for file in CITING for number in cited(file.read_text())}
    assert numbers <= {*known}
    assert {number for number in known if known[number] == "accepted"} <= numbers


def test_packages_cite_no_decisions():
    """A template has them in comments of Jinja."""
    templates = [file for file in CITING if file.suffix == ".jinja" or "template" in file.parts]
    assert templates
    for file in templates:
        assert not cited(re.sub(r"\{#.*?#\}", "", file.read_text(), flags=re.DOTALL)), file


def test_pythons_and_copiers_of_the_workflow():
    """The oldest and the newest Copier that a package may be made with."""
    workflow = yaml.safe_load((ROOT / ".github/workflows/test.yml").read_text())
    project = (ROOT / "pyproject.toml").read_text()
    matrix = workflow["jobs"]["without-ros"]["strategy"]["matrix"]
    oldest = re.search(r'requires-python = ">=([\d.]+)"', project)[1]
    assert matrix["python"][0] == oldest
    low, high = re.search(r'"copier>=([\d.]+),<([\d.]+)"', project).groups()
    newest = high.rpartition(".")[0] + f".{int(high.rpartition('.')[2]) - 1}"
    assert matrix["copier"] == [low, f"{newest}.*"]
    others = workflow["jobs"]["other-systems"]["strategy"]["matrix"]["include"]
    assert {each["os"].partition("-")[0] for each in others} == {"windows", "macos"}


def test_make_lab_runs_what_counts_by_its_numbers():
    """Whatever the name of such a test, it has the mark."""
    assert "-m lab" in re.search(r"(?m)^lab:.*\n(?:\t.*\n)+", (ROOT / "Makefile").read_text())[0]
    marked = set()
    for file in (ROOT / "tests").rglob("test_*.py"):
        text = file.read_text(encoding="utf-8")
        numbers = {"LAB_KILLS", *re.findall(r"(?m)^(\w+) = .*\"LAB_", text)}
        for node in ast.parse(text).body if "LAB_" in text and file != Path(__file__) else ():
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                source = ast.get_source_segment(text, node)
                is_marked = "pytest.mark.lab" in [ast.unparse(d) for d in node.decorator_list]
                assert is_marked == bool(numbers & set(re.findall(r"\w+", source))), node.name
                marked |= {node.name} if is_marked else set()
    assert {"test_no_line_is_lost", "test_two_branches_become_one"} <= marked
