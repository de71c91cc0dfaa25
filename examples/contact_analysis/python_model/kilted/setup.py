# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

from glob import glob

from setuptools import find_packages, setup

package_name = 'contact_analysis'

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
    maintainer='Double Bind',
    maintainer_email='double.bind@icinco.com',
    description='Analysis of the Center of Pressure related to contact points',
    license='GPL-3.0-only',
    entry_points={
        'console_scripts': [
            'contact_evaluate = contact_analysis.contact_evaluate_ros:main',
        ],
    },
)
