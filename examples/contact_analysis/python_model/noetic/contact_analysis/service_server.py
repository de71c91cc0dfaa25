# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""A service server whose callback fills in a given response."""

import rospy


class ServiceServer:
    """A server that passes the request and an empty response to its callback."""

    def __init__(self, name, service_type, serve):
        """Advertise the service; serve(request, response) returns the response."""
        self._service = rospy.Service(
            name,
            service_type,
            lambda request: serve(request, service_type._response_class()),
        )
