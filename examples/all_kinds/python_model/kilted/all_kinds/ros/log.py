# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The log of the logic, whose lines may be written once, or at most once in a time."""

from __future__ import annotations

from math import inf
import sys
from threading import Lock
from time import monotonic
from typing import Any, Callable, Dict, Tuple

Write = Callable[[str], object]


class Log:
    """
    Writes to the ROS log.

    info_once(text): writes once for each line that calls it, and so do the other levels.
    info_throttle(seconds, text): at most once in that many seconds of wall time.
    """

    def __init__(self, logger: Any) -> None:
        """Write with a logger of ROS."""
        self._written: Dict[Tuple[str, int], float] = {}
        self._lock = Lock()
        self.debug: Write = logger.debug
        self.info: Write = logger.info
        self.warning: Write = logger.warning
        self.error: Write = logger.error
        # By a lambda each: rclpy 9.1.2 raises where one line of code logs at two levels.
        self.debug_once, self.debug_throttle = self._limited(lambda text: logger.debug(text))
        self.info_once, self.info_throttle = self._limited(lambda text: logger.info(text))
        self.warning_once, self.warning_throttle = self._limited(lambda text: logger.warning(text))
        self.error_once, self.error_throttle = self._limited(lambda text: logger.error(text))

    def _limited(self, write: Write) -> Tuple[Write, Callable[[float, str], object]]:
        """Return functions that write once, and at most once in some time."""

        def throttle(seconds: float, text: str, /) -> None:
            if self._is_due(seconds):
                write(text)

        def once(text: str, /) -> None:
            if self._is_due(inf):
                write(text)

        return once, throttle

    def _is_due(self, pause: float) -> bool:
        """Return whether the line of the logic that calls has written nothing for that long."""
        caller = sys._getframe(2)
        place = caller.f_code.co_filename, caller.f_lineno
        now = monotonic()
        with self._lock:
            is_due = now - self._written.get(place, -inf) >= pause
            if is_due:
                self._written[place] = now
        return is_due
