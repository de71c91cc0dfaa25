# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The log of the logic, whose lines may be written once, or at most once in a time."""

from __future__ import annotations

from math import inf
import sys
from threading import Lock
from time import monotonic
from typing import Any, Callable, Dict, Tuple


class Log:
    """Writes to the ROS log; `_once` and `_throttle` are for each line that calls."""

    def __init__(self, logger: Any) -> None:
        """Write with a logger of ROS."""
        self.debug: Callable[[str], object] = logger.debug
        self.info: Callable[[str], object] = logger.info
        self.warning: Callable[[str], object] = logger.warning
        self.error: Callable[[str], object] = logger.error
        self._written: Dict[Tuple[str, int], float] = {}
        self._lock = Lock()

    def debug_once(self, text: str, /) -> None:
        """Write a debug message, once."""
        if self._is_due(inf):
            self.debug(text)

    def debug_throttle(self, seconds: float, text: str, /) -> None:
        """Write a debug message, at most once in that many seconds of wall time."""
        if self._is_due(seconds):
            self.debug(text)

    def info_once(self, text: str, /) -> None:
        """Write a message, once."""
        if self._is_due(inf):
            self.info(text)

    def info_throttle(self, seconds: float, text: str, /) -> None:
        """Write a message, at most once in that many seconds of wall time."""
        if self._is_due(seconds):
            self.info(text)

    def warning_once(self, text: str, /) -> None:
        """Write a warning, once."""
        if self._is_due(inf):
            self.warning(text)

    def warning_throttle(self, seconds: float, text: str, /) -> None:
        """Write a warning, at most once in that many seconds of wall time."""
        if self._is_due(seconds):
            self.warning(text)

    def error_once(self, text: str, /) -> None:
        """Write an error, once."""
        if self._is_due(inf):
            self.error(text)

    def error_throttle(self, seconds: float, text: str, /) -> None:
        """Write an error, at most once in that many seconds of wall time."""
        if self._is_due(seconds):
            self.error(text)

    def _is_due(self, pause: float) -> bool:
        """Return whether the calling line of the logic has written nothing for that long."""
        caller = sys._getframe(2)
        place = caller.f_code.co_filename, caller.f_lineno
        now = monotonic()
        with self._lock:
            is_due = now - self._written.get(place, -inf) >= pause
            if is_due:
                self._written[place] = now
        return is_due
