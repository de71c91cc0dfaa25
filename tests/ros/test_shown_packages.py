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
    for spec in EXAMPLES.glob("*.ros_package"):
        made_by = MADE_BY.get(spec.stem, model)
        for distro in ("noetic", "kilted"):
            put(spec, made_by, distro, tmp_path / distro)
            package = tmp_path / distro / "src" / spec.stem
            shown = EXAMPLES / spec.stem / made_by / distro
            assert contents(package) == contents(shown)
