# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Read by catkin_python_setup(); not for use by hand."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(
    **generate_distutils_setup(
        packages=['all_kinds', 'all_kinds.ros'],
        package_dir={'': '.'},
        package_data={'all_kinds': ['py.typed']},
    )
)
