"""Render the packages of examples/ anew, to see what a change of a template does to them.

    python scripts/accept.py            # writes examples/<spec>/<model>/<ROS>
    python scripts/accept.py --check    # changes nothing; shows what would change, and fails

The packages of two specs are shown whole, for both ROS. The other specs would repeat most of
their files, so of their packages only what all_kinds lacks is shown, for ROS 2 and without tests
(decision 19).
A package is made as from the published model, but for the version, which its answers leave out.
"""

from __future__ import annotations

import argparse
import difflib
import re
import shutil
import sys
import tempfile
from pathlib import Path

import copier

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "examples"
PACKAGES = "*/*_model/*"
REFERENCE = "all_kinds"
WHOLE = (REFERENCE, "contact_msgs")
# A package in two languages has the files of a package in either, but builds them in its own way.
LANGUAGES = {"mixed_model": ("python_model", "cpp_model")}
BUILD = {"mixed_model": "CMakeLists.txt"}


def models(spec: Path) -> tuple[str, ...]:
    """Return the models that a spec is for: by ROS's custom, *_msgs has interfaces alone."""
    if spec.stem.endswith("_msgs"):
        return ("interfaces_model",)
    is_mixed = ' language="' in spec.read_text(encoding="utf-8")
    return ("mixed_model",) if is_mixed else ("python_model", "cpp_model")


def distros(spec: Path) -> tuple[str, ...]:
    """Return the ROS that the packages of a spec are shown for."""
    return ("noetic", "kilted") if spec.stem in WHOLE else ("kilted",)


def is_shown(name: Path, made: Path) -> bool:
    """Tell whether a file, named from the folder of all packages `made`, is to be in examples/."""
    spec, model, distro, *parts = name.parts
    path = "/".join(parts)
    if spec in WHOLE or path == BUILD.get(model):
        return True
    same = path.replace(spec, REFERENCE)
    languages = LANGUAGES.get(model, (model,))
    known = any((made / REFERENCE / each / distro / same).exists() for each in languages)
    return parts[0] != "test" and not known


def render(target: Path) -> None:
    """Make every package below `target`, whole."""
    with tempfile.TemporaryDirectory() as folder:
        for spec in sorted(EXAMPLES.glob("*.ros_package")):
            for model in models(spec):
                source = Path(folder) / model
                if not source.exists():
                    publish(model, source)
                for distro in distros(spec):
                    make(source, spec, distro, target / spec.stem / model / distro)


def publish(model: str, source: Path) -> None:
    """Put a model into a folder, with all that it has as a repository of its own."""
    shutil.copytree(ROOT / model, source)
    for shared in ("hooks", "extensions", "shared"):
        shutil.copytree(ROOT / shared, source / shared)


def make(source: Path, spec: Path, distro: str, package: Path) -> None:
    """Make one package, whose answers name the published model and no path of this machine."""
    copier.run_copy(
        str(source),
        package,
        data={"spec_file": str(spec), "ros_distro": distro},
        defaults=True,
        unsafe=True,
        quiet=True,
    )
    answers = package / ".copier-answers.yml"
    text = answers.read_text(encoding="utf-8")
    address = f"_src_path: gh:org/{source.name}"
    answers.write_text(re.sub(r"^_src_path: .*$", address, text, flags=re.M), encoding="utf-8")


def show(made: Path, target: Path) -> None:
    """Copy what is shown of the packages below `made`."""
    for file in made.rglob("*"):
        name = file.relative_to(made)
        if file.is_file() and is_shown(name, made):
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, target / name)


def accept(shown: Path) -> None:
    """Put the packages below `shown` in the place of those in examples/."""
    for old in EXAMPLES.glob(PACKAGES):
        shutil.rmtree(old)
    shutil.copytree(shown, EXAMPLES, dirs_exist_ok=True)


def differences(shown: Path) -> list[str]:
    """Return the lines of a diff from examples/ to the packages below `shown`."""
    lines: list[str] = []
    old, new = files(EXAMPLES), files(shown)
    for name in sorted({*old, *new}):
        before, after = old.get(name), new.get(name)
        if before != after:
            lines += difflib.unified_diff(
                before[1].splitlines() if before else [],
                after[1].splitlines() if after else [],
                f"examples/{name}" if before else "/dev/null",
                f"made anew/{name}" if after else "/dev/null",
                lineterm="",
            )
            if before and after and before[0] != after[0]:
                lines.append(f"{name}: executable before: {before[0]}, after: {after[0]}")
    return lines


def files(folder: Path) -> dict[str, tuple[bool, str]]:
    """Return the files of packages, each with whether it is executable and its text."""
    return {
        str(path.relative_to(folder)): (bool(path.stat().st_mode & 0o100), path.read_text("utf-8"))
        for package in folder.glob(PACKAGES)
        for path in package.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and ".ruff_cache" not in path.parts
    }


def main() -> int:
    """Accept or check, as the command line says."""
    parser = argparse.ArgumentParser(description="Render the packages of examples/ anew.")
    parser.add_argument("--check", action="store_true", help="show what would change, and fail")
    check = parser.parse_args().check
    with tempfile.TemporaryDirectory() as folder:
        made, shown = Path(folder, "made"), Path(folder, "shown")
        render(made)
        show(made, shown)
        lines = differences(shown)
        if not check:
            accept(shown)
    print("\n".join(lines[:2000]))
    print(f"{len(lines)} lines of differences" if lines else "examples/ is current")
    return 1 if check and lines else 0


if __name__ == "__main__":
    sys.exit(main())
