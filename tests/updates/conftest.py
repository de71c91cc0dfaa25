"""The laboratory, and a package whose logic is filled in with its updates."""

import pytest

from support.arm import EDITS, SPEC
from support.laboratory.trials import Laboratory
from support.repository import commit


@pytest.fixture(scope="session")
def laboratory(tmp_path_factory):
    return Laboratory(tmp_path_factory.mktemp("lab"))


@pytest.fixture
def arm(render):
    """Return a package whose logic is filled in."""
    package = render(SPEC, name="arm")
    impl = package / "arm/reach_impl.py"
    text = impl.read_text()
    for line, code in EDITS.items():
        text = text.replace(line, f"{line}\n        {code}", 1)
    text = text.replace(
        "return response", "response.message = 'loaded'\n        return response", 1
    )
    impl.write_text(text)
    (package / "arm/helper.py").write_text("from arm.reach_interface import ReachData\n")
    commit(package, "Write the logic")
    return package


@pytest.fixture
def update_with(arm, copier_command):
    """Change the spec by (old, new) texts, update, and return what the update said."""

    def run(*changes):
        spec = arm / "arm.ros_package"
        text = spec.read_text()
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        spec.write_text(text)
        commit(arm, "Change the spec")
        result = copier_command("update", "--trust", "--defaults", cwd=arm)
        assert result.returncode == 0, result.stderr
        return result.stderr

    return run
