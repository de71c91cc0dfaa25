# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Topics whose messages a callback of the logic gets together, joined by their stamps."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, Callable, Optional

from all_kinds.ros.callbacks import Callback
from message_filters import ApproximateTimeSynchronizer, SimpleFilter, TimeSynchronizer


class Synchronizer:
    """Joins messages by the policies of message_filters."""

    def __init__(
        self,
        callback: Callback,
        messages: Any,
        queue_size: int,
        slop: Optional[float] = None,
    ) -> None:
        """
        Join messages into objects of a dataclass, whose fields are the inputs.

        Their stamps are equal or, with a slop, less than that many seconds apart.
        """
        for field in fields(messages):
            if not hasattr(field.type, 'header'):
                raise TypeError(f'{field.name}: its messages have no header, so no stamp')
        self._inputs = {field.name: SimpleFilter() for field in fields(messages)}
        inputs = list(self._inputs.values())
        if slop is None:
            joined = TimeSynchronizer(inputs, queue_size)
        else:
            joined = ApproximateTimeSynchronizer(inputs, queue_size, slop)
        joined.registerCallback(lambda *each: callback.receive(messages(*each)))

    def receiver(self, name: str) -> Callable[[Any], None]:
        """Return the callback of the subscription of an input."""
        return self._inputs[name].signalMessage
