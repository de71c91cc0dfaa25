"""What is built and run is what examples/ shows."""

from support.packages import MADE_BY
from support.repository import EXAMPLES


def contents(folder):
    return {
        path.relative_to(folder): (path.stat().st_mode, path.read_bytes())
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_packages_are_those_shown(put, model, tmp_path):
    """All of a package that is shown whole; of another, the files that are shown."""
    for spec in EXAMPLES.glob("*.ros_package"):
        for shown in (EXAMPLES / spec.stem / MADE_BY.get(spec.stem, model)).iterdir():
            put(spec, shown.parent.name, shown.name, tmp_path / shown.name)
            package = contents(tmp_path / shown.name / "src" / spec.stem)
            if (shown / ".copier-answers.yml").exists():
                assert package == contents(shown)
            else:
                assert package.items() >= contents(shown).items()
