"""Docstring style of ROS 2."""

from ament_pep257.main import main
import pytest


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    """ament_pep257 reports no error."""
    assert main(argv=['.', 'test']) == 0
