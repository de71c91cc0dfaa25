# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The loop that calls a method at a rate."""

from __future__ import annotations

from time import monotonic
from typing import Callable

from all_kinds.ros import timeouts
from all_kinds.ros.ros_time import RosTime
from all_kinds.ros.stop import Stop


class Loop:
    """
    Calls a method at a fixed frequency; skips the cycles that begin while it still runs.

    cycles: how many were run; missed: how many were skipped.
    late: how many took longer than a period, or too long for the next to begin in time.
    """

    def __init__(
        self,
        update: Callable[[], None],
        frequency: float,
        time: RosTime,
        warn: Callable[[str], object],
        name: str = 'update',
    ) -> None:
        """Prepare a loop of `frequency` Hz."""
        self.cycles = 0
        self.missed = 0
        self.late = 0
        self._update = update
        self._frequency = frequency
        self._time = time
        self._warn = warn
        self._name = name
        self._unreported = 0
        self._report_due = monotonic()

    def run(self, stop: Stop) -> None:
        """Loop until the node stops."""
        period = 1.0 / self._frequency
        self._time.wait_for_start()
        due = self._now()
        while not stop.requested:
            if self._time.simulated:
                due += self._periods_since(due) * period  # /clock may step by several periods
            begin = monotonic()
            self._update()
            taken = monotonic() - begin
            self.cycles += 1
            due = min(due, self._now()) + period  # the clock may have been set back
            missed = self._periods_since(due)
            due += missed * period
            if self._time.simulated:  # only a slow update misses cycles, not a step of /clock
                missed = min(missed, int((monotonic() - begin) / period))
            if (missed or taken > period) and not stop.requested:
                self.late += 1
            if not stop.requested:
                self._report(missed)
            self._time.sleep(due - self._now())

    def _periods_since(self, due: float) -> int:
        return max(0, int((self._now() - due) * self._frequency))

    def _now(self) -> float:
        return self._time.now() if self._time.simulated else monotonic()

    def _report(self, missed: int) -> None:
        self.missed += missed
        self._unreported += missed
        if self._unreported and monotonic() >= self._report_due:
            cycles = f'{self._unreported} cycles of {self._frequency:g} Hz'
            self._warn(f'Missed {cycles}: {self._name} takes too long.')
            self._unreported = 0
            self._report_due = monotonic() + timeouts.WARNING_PERIOD
