# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Service calls with a timeout."""

from queue import Empty, SimpleQueue
from threading import Thread
from time import monotonic

import rosgraph
import rospy


class ServiceClient:
    """A client of a service, for use in any callback."""

    def __init__(self, name, service_type):
        """Create the client."""
        self._name = rospy.resolve_name(name)
        self._service_type = service_type
        self._master = rosgraph.Master(rospy.get_name())
        self.Request = service_type._request_class

    def is_ready(self):
        """Return whether a server is available."""
        try:
            self._master.lookupService(self._name)
        except rosgraph.MasterException:
            return False
        return True

    def call(self, request, timeout=1.0):
        """Return the response, or None if none arrives within `timeout` seconds."""
        end = monotonic() + timeout
        try:
            rospy.wait_for_service(self._name, max(timeout, 0.001))  # 0 is not allowed
        except rospy.ROSException:
            return None
        answers = SimpleQueue()
        Thread(target=self._call, args=(request, answers), daemon=True).start()
        try:
            return answers.get(timeout=max(0.0, end - monotonic()))
        except Empty:
            return None

    def _call(self, request, answers):
        try:
            answers.put(rospy.ServiceProxy(self._name, self._service_type)(request))
        except rospy.ServiceException as error:
            rospy.logwarn('Service %s: %s', self._name, error)
            answers.put(None)
