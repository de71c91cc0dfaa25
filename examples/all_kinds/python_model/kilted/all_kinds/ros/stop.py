# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""One stop for every wait of the logic."""

from __future__ import annotations

from threading import Condition, current_thread, Thread, TIMEOUT_MAX
from typing import Callable, Optional, TypeVar

T = TypeVar('T')


class Stop:
    """
    Ends the waits of the logic when the node stops: calls, lookups, sleeps and goals.

    Whoever brings what a wait is for, such as a response, calls `wake`.
    """

    def __init__(self) -> None:
        """Let waits wait."""
        self._changed = Condition()
        self._requested = False
        self._final = False
        self._spared: Optional[Thread] = None

    @property
    def requested(self) -> bool:
        """Whether waits of this thread end at once."""
        return self._requested and current_thread() is not self._spared

    def request(self, spare: Optional[Thread] = None) -> None:
        """End every wait but those of the thread `spare`."""
        with self._changed:
            self._requested = True
            self._spared = spare
            self._changed.notify_all()

    def finish(self) -> None:
        """End every wait for good, but those of the thread that is spared."""
        with self._changed:
            self._requested = self._final = True
            self._changed.notify_all()

    def clear(self) -> None:
        """Let waits wait again, unless `finish` was called."""
        with self._changed:
            self._requested = self._final
            self._spared = None

    def admit(self, begin: Callable[[], T]) -> Optional[T]:
        """
        Begin what is to be waited for after `request`, unless that has come before.

        Return what `begin` returns, which must not wait.
        """
        with self._changed:
            return None if self.requested else begin()

    def wake(self) -> None:
        """Let every wait look again whether it has come to its end."""
        with self._changed:
            self._changed.notify_all()

    def wait_for(self, condition: Callable[[], bool], timeout: float) -> bool:
        """
        Wait until the condition holds, `timeout` seconds of wall time at most, which may be inf.

        Return whether it holds; at once when the node stops.
        """
        with self._changed:
            self._changed.wait_for(
                lambda: condition() or self.requested,
                min(timeout, TIMEOUT_MAX),
            )
            return condition()
