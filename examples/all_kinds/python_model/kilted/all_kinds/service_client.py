# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Service calls with a timeout."""

from threading import Event
from time import monotonic


class ServiceClient:
    """A client of a service, for use in any callback."""

    def __init__(self, client) -> None:
        """Wrap an rclpy client."""
        self._client = client
        self.Request = client.srv_type.Request

    def is_ready(self) -> bool:
        """Return whether a server is available."""
        return self._client.service_is_ready()

    def call(self, request, timeout: float = 1.0):
        """Return the response, or None if none arrives within `timeout` seconds."""
        end = monotonic() + timeout
        if not self.is_ready() and not self._client.wait_for_service(timeout):
            return None
        answered = Event()
        future = self._client.call_async(request)
        future.add_done_callback(lambda _: answered.set())
        if answered.wait(max(0.0, end - monotonic())):
            return future.result()
        self._client.remove_pending_request(future)
        return None
