"""The docstrings of the package keep to the style of ROS 2."""

from ament_pep257.main import main
import pytest


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    """No fault is found by ament_pep257."""
    assert main(argv=['.', 'test']) == 0
