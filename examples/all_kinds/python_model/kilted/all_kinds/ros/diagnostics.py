# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""The messages of a node on /diagnostics."""

from __future__ import annotations

from time import monotonic
from typing import Any, Optional, Protocol, Sequence

from all_kinds.ros import timeouts
from all_kinds.ros.deadline import Deadline
from all_kinds.ros.logic_status import LogicStatus
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

LEVELS = ['OK', 'WARN', 'ERROR']


class Cycles(Protocol):
    """How often a loop has run, how many cycles took too long, and how many it has missed."""

    cycles: int
    late: int
    missed: int


class Diagnostics:
    """Reports the state, rate, late and missed cycles of a node, and what its logic says."""

    def __init__(
        self,
        name: str,
        loop: Optional[Cycles],
        deadlines: Sequence[Deadline] = (),
    ) -> None:
        """Prepare the reports of the node `name`, which may have no loop."""
        self._deadlines = deadlines
        self._name = name
        self._loop = loop
        self._logic = LogicStatus()
        self._time = monotonic()
        self._cycles = 0
        self._late = 0
        self._late_until = 0.0

    def renew(self) -> LogicStatus:
        """Drop the status of the logic; return that of the next one."""
        self._logic = LogicStatus()
        return self._logic

    def report(self, state: str, failure: str, stamp: Any) -> DiagnosticArray:
        """Return a report of the time since the one before; `failure`: why the logic failed."""
        level, text, values = 'OK', state, {'state': state}
        if self._loop is not None:
            now = monotonic()
            rate = (self._loop.cycles - self._cycles) / (now - self._time)
            values['rate (Hz)'] = f'{rate:.3g}'
            values['late cycles'] = str(self._loop.late)
            values['missed cycles'] = str(self._loop.missed)
            if self._loop.late > self._late:
                self._late_until = now + timeouts.LATE_PERIOD
            if now < self._late_until:
                level, text = 'WARN', 'late cycles'
            self._time = now
            self._cycles = self._loop.cycles
            self._late = self._loop.late
        late = [complaint for each in self._deadlines if (complaint := each.complaint())]
        if late:
            level, text = 'WARN', '; '.join([text] * (level == 'WARN') + late)
        if failure:
            level, text = 'ERROR', failure
        said = self._logic.read()
        both = [(level, text), (said.level, said.text)]
        worst = max((each for each, _ in both), key=LEVELS.index)
        status = DiagnosticStatus(name=self._name, hardware_id=said.hardware_id)
        status.level = getattr(DiagnosticStatus, worst)
        status.message = '; '.join(each for level, each in both if level == worst and each)
        for key, value in [*values.items(), *sorted(said.values.items())]:
            status.values.append(KeyValue(key=key, value=value))
        report = DiagnosticArray(status=[status])
        report.header.stamp = stamp
        return report
