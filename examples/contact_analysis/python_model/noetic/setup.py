# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Read by catkin_python_setup(); not for use by hand."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(
    **generate_distutils_setup(
        packages=['contact_analysis'],
        package_dir={'': '.'},
        package_data={'contact_analysis': ['py.typed']},
    )
)
