#!/usr/bin/env python3
# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Runs the tests of a module of this folder for rostest: run_test.py MODULE."""

import sys

import rostest

if __name__ == '__main__':
    rostest.rosrun('serving', sys.argv[1], sys.argv[1])
