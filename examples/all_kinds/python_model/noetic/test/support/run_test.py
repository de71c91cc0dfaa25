#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Runs the tests of a module of the folder above for rostest: run_test.py MODULE."""

import os.path
import sys

import rostest

if __name__ == '__main__':
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    rostest.rosrun('all_kinds', sys.argv[1], sys.argv[1])
