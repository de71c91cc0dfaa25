# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Processes that run a node with the recorder as its logic."""

import json
import os
from subprocess import PIPE, Popen, STDOUT
from threading import Thread
from time import monotonic, sleep

LIFE = ['configure', 'activate', 'deactivate', 'cleanup']
TIMEOUT = float(os.environ.get('TEST_TIMEOUT', 60.0))  # seconds; long, for busy machines


class RunningNode:
    """A node in a process of its own; its log, and what its recorder reports in it."""

    def __init__(self, name, command, *orders):
        """Start a program; the orders come before its logic does anything."""
        self.name = name
        self.log = ''
        self.reports = []
        self._process = Popen(command, stdin=PIPE, stdout=PIPE, stderr=STDOUT)
        self._reader = Thread(target=self._read)
        self._reader.start()
        self._write(*orders, '')

    def _write(self, *lines):
        self._process.stdin.write(''.join(line + '\n' for line in lines).encode())
        self._process.stdin.flush()

    def _read(self):
        for line in self._process.stdout:
            self.log += line.decode(errors='replace')
            if line.startswith(b'report '):
                self.reports.append(json.loads(line[7:].decode(), strict=False))

    def got(self, name):
        """Return the values reported under a name, in order."""
        return [value for each, value in self.reports.copy() if each == name]

    def life(self):
        """Return the calls of configure, activate, deactivate and cleanup, all in one thread."""
        calls = [report for report in self.reports.copy() if report[0] in LIFE]
        assert all(thread == 'logic' for _, thread in calls), calls
        return [name for name, _ in calls]

    def order(self, method, *steps):
        """Say what a method does when it is called next; `now`: at once, and return its result."""
        report = steps[-1].partition('=')[0] if method == 'now' else 'order'
        report = 'begun' if report == 'fail' else report  # the process may end before it says more
        count = len(self.got(report))
        self._write(' '.join((method, *steps)))
        assert eventually(lambda: len(self.got(report)) > count), f'{method} {steps}:\n{self.log}'
        return self.got(report)[-1]

    def signal(self, number):
        """Send a signal to the process, which must run."""
        assert self._process.poll() is None, f'the node has ended by itself:\n{self.log}'
        self._process.send_signal(number)

    def eventually(self, condition):
        """Return whether a condition holds in time, at most a second after the process."""
        eventually(lambda: condition() or self._process.poll() is not None)
        return eventually(condition, 1.0)

    def exit_code(self):
        """Return the exit code of the process, which must end, when all that it wrote is read."""
        assert eventually(lambda: self._process.poll() is not None), f'runs on:\n{self.log}'
        self._reader.join()
        return self._process.poll()

    def kill(self):
        """End the process, if it still runs."""
        self._process.kill()
        self._reader.join()
        self._process.communicate()


def eventually(condition, timeout=TIMEOUT):
    """Return whether a condition holds before the timeout."""
    end = monotonic() + timeout
    while not condition():
        if monotonic() > end:
            return False
        sleep(0.01)
    return True
