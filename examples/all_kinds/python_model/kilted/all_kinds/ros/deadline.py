# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Topics that are late when no message comes for too long."""

from __future__ import annotations

from threading import Lock
from time import monotonic
from typing import Any, Callable

from all_kinds.ros.ros_time import RosTime

SHORTEST = 0.001  # s, between two looks


class Deadline:
    """Watches a topic, in simulated time or by the monotonic clock."""

    def __init__(self, seconds: float, time: RosTime) -> None:
        """Prepare: the topic will be late when no message has come for so long."""
        self._seconds = seconds
        self._time = time
        self._lock = Lock()
        self._last = 0.0
        self._at_work = 0
        self._is_late = False
        self._topic = ''
        self._is_watched = False

    def heard(self, at_work: int = 0) -> None:
        """Note that a message has come; at_work: 1 where its callback begins, -1 where it ends."""
        with self._lock:
            self._at_work += at_work
            self._last = self._now()
            self._is_late = False

    def receiver(self, receive: Callable[[Any], Any]) -> Callable[[Any], Any]:
        """Return a callback of a subscription; while it is at work the topic is not late."""

        async def receive_in_time(message: Any) -> None:
            self.heard(1)
            await receive(message)
            self.heard(-1)

        return receive_in_time

    def watch(self, late: Callable[[], object], topic: str = '') -> None:
        """Call `late` once whenever the topic becomes late, until the node stops."""
        self._time.wait_for_start()
        self.heard()
        self._topic = topic
        self._is_watched = True
        try:
            while self._time.sleep(self._left()):
                if self._becomes_late():
                    late()
        finally:
            self._is_watched = False

    def complaint(self) -> str:
        """Return that the topic is late, and for how long no message has come, or ''."""
        with self._lock:
            silence = self._silence()
        is_late = self._is_watched and silence >= self._seconds
        return f'no message on {self._topic} for {silence:.1f} s' if is_late else ''

    def _left(self) -> float:
        """Return how long to sleep: until the topic is late, or for a deadline if it is."""
        with self._lock:
            left = self._seconds - self._silence()
        return max(left, SHORTEST) if left > 0.0 else self._seconds

    def _becomes_late(self) -> bool:
        with self._lock:
            if self._is_late or self._silence() < self._seconds:
                return False
            self._is_late = True
            return True

    def _silence(self) -> float:
        now = self._now()
        self._last = min(self._last, now)  # the clock may have been set back
        return 0.0 if self._at_work else now - self._last

    def _now(self) -> float:
        return self._time.now() if self._time.simulated else monotonic()
