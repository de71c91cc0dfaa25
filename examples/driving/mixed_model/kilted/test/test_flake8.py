"""Code style of ROS 2."""

from ament_flake8.main import main_with_errors
import pytest


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    """ament_flake8 reports no error."""
    code, errors = main_with_errors(argv=[])
    assert code == 0, '\n'.join(errors)
