# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Nodes in processes of their own."""

import os
import signal
import subprocess
from threading import Condition, Thread
from time import monotonic, sleep

TIMEOUT = float(os.environ.get('TEST_TIMEOUT', 20.0))  # seconds; long, for busy machines


class RunningNode:
    """A process that runs a node, and the calls that its recorder writes."""

    def __init__(self, command):
        """Start a program, given by its path and arguments."""
        self._calls = []
        self._changed = Condition()
        self._process = subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            universal_newlines=True,
        )
        self._reader = Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        for line in self._process.stdout:
            if line.startswith('called '):
                with self._changed:
                    self._calls.append(line.strip().partition(' ')[2].partition(' '))
                    self._changed.notify_all()

    def calls(self, *names):
        """Return the calls so far, in order: all of them, or those of some methods."""
        with self._changed:
            return [call[0] for call in self._calls if not names or call[0] in names]

    def words(self, *names):
        """Return what the recorder wrote with the calls of some methods, in order."""
        with self._changed:
            return [call[2] for call in self._calls if call[0] in names]

    def is_called(self, name, count=1, timeout=TIMEOUT):
        """Return whether a method is called that often before the timeout."""
        with self._changed:
            return self._changed.wait_for(
                lambda: [call[0] for call in self._calls].count(name) >= count,
                timeout,
            )

    def is_running(self):
        """Return whether the process lives."""
        return self._process.poll() is None

    def stop(self, number=signal.SIGINT):
        """Send a signal to the process, which must run; return its exit code."""
        assert self.is_running(), 'the node has ended by itself'
        self._process.send_signal(number)
        return self.exit_code()

    def exit_code(self):
        """Return the exit code of a process that ends."""
        try:
            return self._process.wait(TIMEOUT)
        finally:
            self.kill()

    def kill(self):
        """End the process, if it still runs."""
        if self.is_running():
            self._process.kill()
        self._process.wait()
        self._reader.join()
        self._process.stdout.close()


def eventually(condition, timeout=TIMEOUT):
    """Return whether a condition holds before the timeout."""
    end = monotonic() + timeout
    while not condition():
        if monotonic() > end:
            return False
        sleep(0.05)
    return True
