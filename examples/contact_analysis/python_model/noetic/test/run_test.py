#!/usr/bin/env python3
# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Runs the tests of a module of this folder for rostest: run_test.py MODULE."""

import sys

import rostest

if __name__ == '__main__':
    rostest.rosrun('contact_analysis', sys.argv[1], sys.argv[1])
