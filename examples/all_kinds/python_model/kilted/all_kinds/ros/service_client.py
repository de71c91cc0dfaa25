# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Service calls with a timeout."""

from __future__ import annotations

from time import monotonic
from typing import Any, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.stop import Stop
from rclpy.client import Client


class ServiceClient:
    """A client of a service, for use in any method of the logic."""

    def __init__(self, client: Client[Any, Any], stop: Stop) -> None:
        """Wrap an rclpy client."""
        self._client = client
        self._stop = stop

    def is_ready(self) -> bool:
        """Return whether a server is available."""
        return self._client.service_is_ready()

    def call(self, request: Any, timeout: float = 1.0) -> Optional[Any]:
        """Return the response, or None after `timeout` seconds or when the node stops."""
        end = monotonic() + timeout
        while not self.is_ready():
            self._stop.wait_for(lambda: False, min(timeouts.DISCOVERY_PERIOD, end - monotonic()))
            if self._stop.requested or monotonic() >= end:
                return None
        future = self._client.call_async(request)
        future.add_done_callback(lambda _: self._stop.wake())
        if self._stop.wait_for(future.done, end - monotonic()):
            return future.result()
        self._client.remove_pending_request(future)
        return None
