# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A service server whose callback fills in a given response."""

from __future__ import annotations

from typing import Any

from all_kinds.ros.callbacks import Callback
import rospy


class ServiceServer:
    """A server that passes the request and an empty response to its callback."""

    def __init__(self, name: str, service_type: Any, callback: Callback) -> None:
        """Advertise the service, which the callback serves."""
        self._service = rospy.Service(
            name,
            service_type,
            lambda request: callback.serve(request, service_type._response_class()),
        )
