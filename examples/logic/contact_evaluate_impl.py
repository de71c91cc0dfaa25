# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The logic of contact_evaluate.

It learns where the center of pressure lies during a contact, and tells contacts apart by that.
"""

from __future__ import annotations

from collections import Counter, deque
from dataclasses import dataclass
import math
from pathlib import Path
from statistics import fmean, pstdev
import threading

from contact_analysis.contact_evaluate_interface import (
    ContactEvaluateConfig,
    ContactEvaluateData,
    ContactEvaluatePassthrough,
    EvaluateGoal,
    EvaluateGoalRequest,
    InCop,
    LearnGoal,
    LoadRequest,
    LoadResponse,
    PubPlotLearnCop,
    StoreRequest,
    StoreResponse,
)

FILE = 'contacts.txt'  # a contact a line: means, standard deviations, name
LIMIT = 3.0  # how far from the mean a contact reaches, in standard deviations
RESOLUTION = 0.001  # of the sensor, in m
PERIOD = 0.01  # in which goals look at what was measured, in s
BUFFER = 1000  # how many centers of pressure to keep for a goal


@dataclass(frozen=True)
class Contact:
    """Mean and standard deviation of the centers of pressure of a contact: x, y, z in m."""

    mean: tuple[float, ...]
    deviation: tuple[float, ...]

    @staticmethod
    def learn(cops: list[InCop]) -> Contact:
        """Learn a contact from one center of pressure or more."""
        axes = list(zip(*map(coordinates, cops)))
        deviation = tuple(max(pstdev(axis), RESOLUTION) for axis in axes)
        return Contact(tuple(map(fmean, axes)), deviation)

    def distance(self, cop: InCop) -> float:
        """Return how far from the mean a center of pressure is, in standard deviations."""
        values = zip(coordinates(cop), self.mean, self.deviation)
        return math.hypot(*((value - mean) / deviation for value, mean, deviation in values))


def coordinates(cop: InCop) -> tuple[float, float, float]:
    """Return x, y and z in m."""
    return cop.x, cop.y, cop.z


def read(line: str) -> tuple[str, Contact]:
    """Return the name and the contact of a line; raise ValueError if it has none."""
    *numbers, name = line.split(' ', 6)
    values = tuple(map(float, numbers))
    if len(values) != 6 or not name or not all(map(math.isfinite, values)) or min(values[3:]) <= 0:
        raise ValueError('six finite numbers and a name are expected')
    return name, Contact(values[:3], values[3:])


class ContactEvaluateImpl:
    """
    The logic of contact_evaluate.

    Callbacks run in threads of their own: protect shared state with a lock.
    """

    def __init__(self, passthrough: ContactEvaluatePassthrough) -> None:
        """Store the passthrough."""
        self.passthrough = passthrough
        self.lock = threading.Lock()  # protects what is below
        self.contacts: dict[str, Contact] = {}
        self.to_learn: deque[InCop] = deque(maxlen=BUFFER)
        self.to_evaluate: deque[InCop] = deque(maxlen=BUFFER)
        self.plots = True

    def configure(self, config: ContactEvaluateConfig) -> bool:
        """Prepare the logic; return False to reject the configuration."""
        self.samples = config.samples
        if self.samples < 1:
            self.passthrough.log.error('samples must be at least 1')
        return self.samples >= 1

    def activate(self) -> bool:
        """Start operating; return False to refuse activation."""
        return True

    def update(
        self,
        data: ContactEvaluateData,
        config: ContactEvaluateConfig,
    ) -> None:
        """Compute the outputs of one cycle from the latest inputs."""
        with self.lock:
            self.plots = config.pub_sample
            if data.in_cop_updated:
                self.to_learn.append(data.in_cop)
                self.to_evaluate.append(data.in_cop)

    # Service load
    def serve_load(
        self,
        request: LoadRequest,
        response: LoadResponse,
    ) -> LoadResponse:
        """Fill in the response and return it, in a thread of its own."""
        try:
            text = Path(request.data, FILE).read_text(encoding='utf-8')
            contacts = dict(map(read, text.split('\n')[:-1]))
        except (OSError, ValueError) as error:
            response.message = f'{FILE} cannot be loaded: {error}'
            return response
        with self.lock:
            self.contacts = contacts
        response.success = True
        return response

    # Service store
    def serve_store(
        self,
        request: StoreRequest,
        response: StoreResponse,
    ) -> StoreResponse:
        """Fill in the response and return it, in a thread of its own."""
        with self.lock:
            contacts = dict(self.contacts)
        lines = [
            ' '.join([*map(repr, contact.mean + contact.deviation), name])
            for name, contact in contacts.items()
        ]
        try:
            file = Path(request.data, FILE)
            file.write_text(''.join(f'{line}\n' for line in lines), encoding='utf-8')
        except OSError as error:
            response.message = f'{FILE} cannot be stored: {error}'
            return response
        response.success = True
        return response

    # Action learn
    def execute_learn(
        self,
        goal: LearnGoal,
    ) -> None:
        """Execute a goal until it succeeds, is aborted, or a cancel is requested."""
        name = goal.request.contact
        if not name or '\n' in name:
            self.passthrough.log.error('a contact needs a name, in one line')
            goal.abort()
            return
        cops: list[InCop] = []
        self.take(self.to_learn)  # leaves out what was measured before
        while len(cops) < self.samples:
            self.passthrough.sleep(PERIOD)
            if goal.cancel_requested:
                goal.canceled()
                return
            cops = (cops + self.take(self.to_learn))[: self.samples]
            goal.feedback.progress = len(cops) / self.samples
            goal.publish_feedback()
        with self.lock:
            self.contacts[name] = Contact.learn(cops)
            plots = self.plots
        if plots:
            self.passthrough.pub_plot_learn_cop.publish(PubPlotLearnCop(points=cops))
        goal.result.samples = len(cops)
        goal.succeed()

    # Action evaluate
    def execute_evaluate(
        self,
        goal: EvaluateGoal,
    ) -> None:
        """Execute a goal until it succeeds, is aborted, or a cancel is requested."""
        end = math.inf
        if goal.request.duration != EvaluateGoalRequest.UNTIL_CANCELED:
            end = self.passthrough.now() + goal.request.duration
        found: Counter[str] = Counter()
        self.take(self.to_evaluate)  # leaves out what was measured before
        while self.passthrough.now() < end and not goal.cancel_requested:
            self.passthrough.sleep(PERIOD)
            cops = self.take(self.to_evaluate)
            found.update(map(self.contact_of, cops))
            if cops:
                goal.feedback.cop = cops[-1]
                goal.publish_feedback()
        goal.result.contact = max(found, key=lambda name: found[name], default='')
        if goal.cancel_requested:
            goal.canceled()
        else:
            goal.succeed()

    def deactivate(self) -> None:
        """Stop everything that moves; publishers, service calls and goals still work here."""

    def cleanup(self) -> None:
        """Release everything created in configure."""

    def take(self, cops: deque[InCop]) -> list[InCop]:
        """Empty a buffer and return what it held."""
        with self.lock:
            taken = list(cops)
            cops.clear()
        return taken

    def contact_of(self, cop: InCop) -> str:
        """Return the name of the nearest contact that reaches a center of pressure, or none."""
        with self.lock:
            distances = {name: item.distance(cop) for name, item in self.contacts.items()}
        nearest = min(distances, key=lambda name: distances[name], default='')
        return nearest if nearest and distances[nearest] <= LIMIT else ''
