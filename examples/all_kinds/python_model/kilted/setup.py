# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

from glob import glob

from setuptools import find_packages, setup

package_name = 'all_kinds'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    package_data={package_name: ['py.typed']},
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/config', glob('config/*')),
        ('share/' + package_name + '/launch', glob('launch/*')),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='Ada Lovelace',
    maintainer_email='ada@example.org',
    description='Every interface kind at once, in two nodes',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'worker = all_kinds.worker_ros:main',
            'observer = all_kinds.observer_ros:main',
        ],
    },
)
