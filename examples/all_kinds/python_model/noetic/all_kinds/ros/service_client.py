# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Service calls with a timeout."""

from __future__ import annotations

from concurrent.futures import Future
import socket
from threading import Thread
from time import monotonic
from typing import Any, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.stop import Stop
import rosgraph
import rospy
from rospy.impl.tcpros_base import TCPROSTransport


class ServiceClient:
    """A client of a service, for use in any method of the logic."""

    def __init__(self, name: str, service_type: Any, stop: Stop) -> None:
        """Create the client."""
        self._name = rospy.resolve_name(name)
        self._service_type = service_type
        self._stop = stop

    def is_ready(self) -> bool:
        """Return whether a server is available."""
        return self._has_server(timeouts.CONNECT_TIMEOUT)

    def call(self, request: Any, timeout: float = 1.0) -> Optional[Any]:
        """Return the response, or None after `timeout` seconds or when the node stops."""
        end = monotonic() + timeout
        while not self._has_server(min(timeouts.CONNECT_TIMEOUT, max(end - monotonic(), 0.0))):
            self._stop.wait_for(lambda: False, min(timeouts.DISCOVERY_PERIOD, end - monotonic()))
            if self._stop.requested or monotonic() >= end:
                return None
        # Calls of rospy 1.15.15 have no time-out, but end when a persistent connection is closed.
        proxy = rospy.ServiceProxy(self._name, self._service_type, persistent=True)
        proxy.transport = TCPROSTransport(proxy.protocol, self._name)  # may be closed at any time
        answer: Future[Any] = Future()
        answer.add_done_callback(lambda _: self._stop.wake())
        arguments = (proxy, request, answer)
        Thread(target=self._call, args=arguments, name=self._name, daemon=True).start()
        if self._stop.wait_for(answer.done, end - monotonic()):
            return answer.result()
        answer.cancel()
        proxy.close()
        return None

    def _has_server(self, timeout: float) -> bool:
        """Return whether the server accepts connections; a dead one may still be registered."""
        name = rospy.get_name()
        master = rosgraph.Master(name)  # a new one, as it is not thread-safe
        probe = {'probe': '1', 'md5sum': '*', 'callerid': name, 'service': self._name}
        try:
            address = rospy.core.parse_rosrpc_uri(master.lookupService(self._name))
            with socket.create_connection(address, timeout) as connection:
                rosgraph.network.write_ros_handshake_header(connection, probe)
        except (rosgraph.MasterException, OSError):
            return False
        return True

    def _call(self, proxy: Any, request: Any, answer: Future[Any]) -> None:
        response = None
        try:
            uri = proxy._get_service_uri(request)
            proxy.transport.connect(*rospy.core.parse_rosrpc_uri(uri), uri)
            if not answer.cancelled():
                response = proxy(request)
        except Exception as error:  # of rospy, or of the socket that was closed
            if not answer.cancelled():
                rospy.logwarn_throttle(timeouts.WARNING_PERIOD, f'Service {self._name}: {error}')
        proxy.close()
        if answer.set_running_or_notify_cancel():
            answer.set_result(response)
