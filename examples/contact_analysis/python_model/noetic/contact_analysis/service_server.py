# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""A service server whose callback fills in a given response."""

from __future__ import annotations

from typing import Any

from contact_analysis.callbacks import CallbackThread
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
