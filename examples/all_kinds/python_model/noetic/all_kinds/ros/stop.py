# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A request to stop that ends every wait of the logic."""

from __future__ import annotations

from threading import Condition, current_thread, Thread, TIMEOUT_MAX
from typing import Callable, Optional, TypeVar

T = TypeVar('T')


class Stop:
    """Ends the waits of the logic when the node stops: calls, lookups, sleeps and goals."""

    def __init__(self) -> None:
        """Start without a request."""
        self._changed = Condition()
        self._requested = False
        self._final = False
        self._exempt: Optional[Thread] = None

    @property
    def requested(self) -> bool:
        """Whether the waits of the calling thread end at once."""
        return self._requested and current_thread() is not self._exempt

    def request(self, exempt: Optional[Thread] = None) -> None:
        """End the waits of every thread except `exempt`."""
        with self._changed:
            self._requested = True
            self._exempt = exempt
            self._changed.notify_all()

    def finish(self) -> None:
        """Request the stop for good: `clear` does not withdraw it any more."""
        with self._changed:
            self._requested = self._final = True
            self._changed.notify_all()

    def clear(self) -> None:
        """Withdraw the request, unless `finish` was called."""
        with self._changed:
            self._requested = self._final
            self._exempt = None

    def admit(self, begin: Callable[[], T]) -> Optional[T]:
        """Return begin(), which must not wait, or None if the stop has been requested."""
        with self._changed:
            return None if self.requested else begin()

    def wake(self) -> None:
        """Have every wait check its condition again."""
        with self._changed:
            self._changed.notify_all()

    def wait_for(self, condition: Callable[[], bool], timeout: float) -> bool:
        """
        Wait until the condition holds or the node stops; return whether the condition holds.

        timeout: the longest wait, in seconds of wall time; may be inf.
        """
        with self._changed:
            self._changed.wait_for(
                lambda: condition() or self.requested,
                min(timeout, TIMEOUT_MAX),
            )
            return condition()
