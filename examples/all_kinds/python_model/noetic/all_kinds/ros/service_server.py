# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A service server whose callback fills in a given response."""

from __future__ import annotations

from typing import Any

from all_kinds.ros.callbacks import CallbackThread
import rospy


class ServiceServer:
    """A server that passes the request and an empty response to its callback."""

    def __init__(self, name: str, service_type: Any, thread: CallbackThread) -> None:
        """Advertise the service, which the thread serves."""
        self._service = rospy.Service(
            name,
            service_type,
            lambda request: thread.serve(request, service_type._response_class()),
        )
