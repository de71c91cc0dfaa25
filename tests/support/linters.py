"""What linters and mypy say of many packages at once: a process of each for all of them."""

import configparser
import re
import subprocess
import sys
import textwrap

RUFF = [sys.executable, "-m", "ruff"]
# Of a package without one: those in C++ have Python in their tests.
STYLE = 'line-length = 99\n[format]\nquote-style = "single"\n'
# Names that are not defined, imports that are not used: pyflakes' rules; and lines too long.
ANY = """
    def __init__(self, **fields: Any) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
"""
RULES = ["--isolated", "--no-cache", "--select=F,E501", "--line-length=99"]


def write(folder, files):
    """Write a package, given by the text of each of its files."""
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def ruff_faults(folder):
    """Return what `ruff format` would change in packages, and what it finds."""
    (folder / "ruff.toml").write_text(STYLE)
    commands = (["format", "--diff", "--no-cache"], ["check", "--output-format=concise", *RULES])
    return "".join(_faults([*RUFF, *command, "."], folder) for command in commands)


def python_faults(ros2, folder):
    """Return what the linters that packages in Python run find in packages."""
    flake8 = ros2.run("ament_flake8 .", folder, check=False)
    pep257 = ros2.run("ament_pep257 .", folder, check=False)
    return "".join(result.stdout for result in (flake8, pep257) if result.returncode)


def cpp_faults(ros2, folder):
    """Return what those of packages in C++ find, but cppcheck, to which names do not matter."""
    cpplint = ros2.run("ament_cpplint .", folder, check=False).stdout
    uncrustify = ros2.run("ament_uncrustify --language C++ .", folder, check=False).stdout
    quiet = ("Done", "DEBUG", "INFO: No files", "No code style", "No problems", "No files found")
    lines = (cpplint + uncrustify).splitlines()
    return "\n".join(line for line in lines if line and not line.startswith(quiet))


def leave_news(folder, longest):
    """Delete files that are like others but for a shorter name of the package: the runtime's.

    Its first letter decides on the order of imports. `longest` has the names that were there.
    """
    for package in sorted(folder.glob("*/package.xml")):
        name = re.search("<name>(.*)</name>", package.read_text())[1]
        for file in [*package.parent.rglob("*.py"), *package.parent.rglob("*.[ch]pp")]:
            text = re.sub(name, "", file.read_text(), flags=re.IGNORECASE)
            key = (file.name, name[0], hash(text))
            if len(name) <= longest.get(key, 0):
                file.unlink()
            longest[key] = max(len(name), longest.get(key, 0))


def type_faults(ros, folder, contexts):
    """Return what mypy finds in packages in Python, given with their contexts by their folders.

    Their names must differ. Their settings are taken together, and what is not there is stood in
    for: messages of other packages, and what dynamic_reconfigure makes of these.
    """
    settings = _settings(folder)
    with (folder / "mypy.ini").open("w") as file:
        settings.write(file)
    _write_messages(ros, folder / "stubs", contexts.values())
    for name, context in contexts.items():
        for node in context["nodes"]:
            if context["ros"] == 1 and node["dynParameters"]:
                files = ("__init__.py", f"{node['class_name']}Config.py")
                write(folder / name / context["name"] / "cfg", dict.fromkeys(files, ""))
    python = f"{sys.executable} -m mypy --python-executable $(command -v {ros.python})"
    printed = ros.run(f"{python} --cache-dir={folder.parent / 'mypy'}", folder, check=False).stdout
    assert "source files" in printed, printed
    return "" if "no issues" in printed else printed


def _settings(folder):
    """Return the settings of all packages for mypy as one."""
    merged = configparser.ConfigParser()
    files, excluded = [], []
    for file in sorted(folder.glob("*/mypy.ini")):
        own = configparser.ConfigParser()
        own.read_string(file.read_text())
        files.append(f"{file.parent.name}/{own['mypy'].pop('files')}")
        excluded.append(own["mypy"].pop("untyped_calls_exclude"))
        merged.read_dict(own)
    lists = {"files": ",".join(files), "untyped_calls_exclude": ",".join(excluded)}
    merged["mypy"].update(lists, mypy_path="stubs")
    return merged


def _write_messages(ros, stubs, contexts):
    """Write the types of contexts whose packages are not there."""
    items = [item for context in contexts for item in _interfaces(context)]
    types = {item["type"] for item in items if "/" in (item.get("type") or "")}
    packages = {type_.split("/")[0] for type_ in types}
    code = f"import importlib.util as u; print(*(p for p in {packages} if not u.find_spec(p)))"
    missing = ros.run(f'{ros.python} -c "{code}"', stubs.parent).stdout.split()
    texts = {}
    for type_ in sorted(types):
        package, folder, name = type_.split("/")
        if package in missing:
            in_ros1 = folder.replace("action", "msg")
            module = f"{package}/{in_ros1 if ros.distro == 'noetic' else folder}.pyi"
            text = texts.setdefault(module, ["from typing import Any\n"])
            text.append(_message(folder, name, ros.distro == "noetic"))
            texts[f"{package}/__init__.pyi"] = []
    write(stubs, {name: "".join(text) for name, text in texts.items()})


def _message(folder, name, is_ros1):
    parts = {"msg": [], "srv": ["Request", "Response"]}.get(folder, ["Goal", "Feedback", "Result"])
    if is_ros1:
        return "".join(f"class {name}{part}:{ANY}" for part in ("", "Action", *parts))
    inside = "".join(f"class {part}:{ANY}" for part in parts)
    return f"class {name}:{ANY}" + textwrap.indent(inside, "    ")


def _interfaces(context):
    """Return the interfaces of all nodes, with those inside of others."""
    found = [*context["nodes"]]
    for item in found:
        lists = [value for value in item.values() if isinstance(value, list)]
        found += [each for value in lists for each in value if isinstance(each, dict)]
    return found


def _faults(command, folder):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return result.stdout + result.stderr if result.returncode else ""
