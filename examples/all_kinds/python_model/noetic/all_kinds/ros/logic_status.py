# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""What the logic says of itself on /diagnostics."""

from __future__ import annotations

from threading import Lock
from typing import Dict, NamedTuple


class Said(NamedTuple):
    """A snapshot: level (OK, WARN or ERROR), text, hardware id and values."""

    level: str
    text: str
    hardware_id: str
    values: Dict[str, str]


class LogicStatus:
    """
    What the logic says of itself; thread-safe.

    level: OK, WARN or ERROR; text: its sentence; values: texts by their keys.
    """

    def __init__(self) -> None:
        """Start well, and with nothing to say."""
        self.level = 'OK'
        self.text = ''
        self.hardware_id = 'none'
        self.values: Dict[str, str] = {}
        self._lock = Lock()

    def set(self, key: str, value: object) -> None:  # noqa: A003
        """Set a value, which is published as text."""
        with self._lock:
            self.values[key] = str(value)

    def ok(self, text: str = '') -> None:
        """Say that all is well, until something else is said."""
        self._say('OK', text)

    def warning(self, text: str) -> None:
        """Say what is not as it should be, until something else is said."""
        self._say('WARN', text)

    def error(self, text: str) -> None:
        """Say what does not work, until something else is said."""
        self._say('ERROR', text)

    def set_hardware_id(self, hardware_id: str) -> None:
        """Say which hardware it is, such as by its serial number."""
        with self._lock:
            self.hardware_id = hardware_id

    def read(self) -> Said:
        """Return all that is said, at one time."""
        with self._lock:
            return Said(self.level, self.text, self.hardware_id, dict(self.values))

    def _say(self, level: str, text: str) -> None:
        with self._lock:
            self.level, self.text = level, text
