# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Read by catkin_python_setup(); not for use by hand."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import find_packages, setup

setup(
    **generate_distutils_setup(
        packages=find_packages(exclude=['test']),
        package_data={'all_kinds': ['py.typed']},
    )
)
