# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""Services whose callbacks get the response to fill in."""

import rospy


class ServiceServer:
    """A server that hands its callback the request and an empty response."""

    def __init__(self, name, service_type, serve):
        """Serve with serve(request, response), which returns the response."""
        self._service = rospy.Service(
            name,
            service_type,
            lambda request: serve(request, service_type._response_class()),
        )
