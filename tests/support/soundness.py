"""What must be true of the files of any rendered package."""

import ast
import subprocess
import sys
import xml.etree.ElementTree as ET

import yaml

from support.packages import files


def check_sound(package):
    """Check that files can be parsed, that ruff format leaves them, and that names are there."""
    for file in files(package, "*.py") + files(package, "*.cfg"):
        if file.name == "setup.cfg":
            continue
        ast.parse(file.read_text())
        assert "\n\n\n\n" not in file.read_text(), file
    for file in files(package, "*.xml") + files(package, "*.launch") + files(package, "*.test"):
        ET.parse(file)
    for file in files(package, "*.yaml"):
        yaml.safe_load(file.read_text())
    ruff = [sys.executable, "-m", "ruff"]
    format_ = subprocess.run(
        [*ruff, "format", "--diff", "--no-cache", "."], cwd=package, capture_output=True, text=True
    )
    assert format_.returncode == 0, format_.stdout
    # Names that are not defined, imports that are not used: pyflakes' rules; and lines too long.
    rules = ["--select=F,E501", "--line-length=99"]
    check = [*ruff, "check", "--isolated", "--no-cache", *rules, "."]
    assert subprocess.run(check, cwd=package).returncode == 0


def check_imports(package, distro):
    """Check that package.xml declares what code and tests import, and nothing for tests twice."""
    tree = ET.parse(package / "package.xml")
    declared = [(e.tag, e.text) for e in tree.getroot() if e.tag.endswith("depend")]
    depends = {name for _, name in declared}
    twice = {name for tag, name in declared if (tag, name) != ("test_depend", name)}
    twice &= {name for tag, name in declared if tag == "test_depend"}
    assert not twice, f"package.xml: for tests again: {twice}"
    provided = {
        "pytest": "python3-pytest",
        "yaml": "python3-yaml",
        "tf2_ros": "tf2_ros" if distro == "noetic" else "tf2_ros_py",
    }
    own = {tree.findtext("name"), "support"}
    for file in files(package, "*.py"):
        if file.name == "setup.py":  # what it imports comes with the build type
            continue
        for node in ast.walk(ast.parse(file.read_text())):
            names = [node.module] if isinstance(node, ast.ImportFrom) else []
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else names
            for module in {name.split(".")[0] for name in names} - own:
                if module not in sys.stdlib_module_names:
                    assert provided.get(module, module) in depends, f"{file.name}: {module}"
