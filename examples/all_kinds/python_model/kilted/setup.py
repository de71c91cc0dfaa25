# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

from glob import glob
import os
import shutil
import tempfile

from setuptools import find_packages, setup

package_name = 'all_kinds'


def installed(folder):
    """Return where the files of a folder and its subfolders are installed."""
    return [
        (os.path.join('share', package_name, path), [os.path.join(path, file) for file in files])
        for path, _, files in os.walk(folder)
        if not path.endswith('__pycache__')
    ]


def registered():
    """Return copies of the files in nodl, named as the ament index wants: PACKAGE__NODE."""
    folder = os.path.join('build', 'nodl') if os.access('.', os.W_OK) else tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    names = [os.path.basename(path).partition('.')[0] for path in sorted(glob('nodl/*'))]
    return [
        shutil.copy(f'nodl/{name}.nodl.yaml', f'{folder}/{package_name}__{name}') for name in names
    ]


setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    package_data={package_name: ['py.typed']},
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        *installed('config'),
        *installed('launch'),
        *installed('nodl'),
        ('share/ament_index/resource_index/nodl', registered()),
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
