# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Service calls with a timeout."""

from __future__ import annotations

from concurrent.futures import Future
import socket
from threading import Lock, Thread
from time import monotonic, sleep
from typing import Any, Optional

from all_kinds.ros import timeouts
from all_kinds.ros.stop import Stop
import rosgraph
import rospy
from rospy.impl.tcpros_base import TCPROSTransport


class Call:
    """A call in a thread of its own, as rospy 1.15.15 has no time-outs."""

    def __init__(self, request: Any) -> None:
        """Start without a connection."""
        self.request = request
        self.response: Future[Any] = Future()
        self.proxy: Any = None  # a rospy.ServiceProxy, which has no types

    def give_up(self) -> None:
        """End the call by closing its connection."""
        self.response.cancel()
        self.close()

    def close(self) -> None:
        """Close the connection, if there is one."""
        if self.proxy:
            self.proxy.close()


class ServiceClient:
    """A client of a service, for use in any method of the logic; connections are kept."""

    def __init__(self, name: str, service_type: Any, stop: Stop) -> None:
        """Create the client."""
        self._name = rospy.resolve_name(name)
        self._service_type = service_type
        self._stop = stop
        self._idle: list[Any] = []
        self._lock = Lock()
        self._lookup_lock = Lock()

    def is_ready(self) -> bool:
        """Return whether a server is available."""
        proxy = self._idle_proxy()
        if proxy:
            self._idle.append(proxy)
        return bool(proxy or self._look_up(timeouts.CONNECT_TIMEOUT))

    def call(self, request: Any, timeout: float = 1.0) -> Optional[Any]:
        """Return the response, or None after `timeout` seconds or when the node stops."""
        call = Call(request)
        call.response.add_done_callback(lambda _: self._stop.wake())
        arguments = (call, monotonic() + timeout)
        Thread(target=self._carry_out, args=arguments, name=self._name, daemon=True).start()
        if self._stop.wait_for(call.response.done, timeout):
            return call.response.result()
        call.give_up()
        return None

    def _carry_out(self, call: Call, end: float) -> None:
        """Set the response to a call; None if the server gives none."""
        response = None
        call.proxy = self._idle_proxy()
        try:
            while not call.proxy and not call.response.cancelled():
                self._connect(call, end)
            if not call.response.cancelled():
                response = call.proxy(call.request)
                self._idle.append(call.proxy)
        except Exception as error:  # of rospy, or of the socket that was closed
            if not call.response.cancelled():
                rospy.logwarn_throttle(timeouts.WARNING_PERIOD, f'Service {self._name}: {error}')
            call.close()
        if call.response.set_running_or_notify_cancel():
            call.response.set_result(response)

    def _connect(self, call: Call, end: float) -> None:
        """Connect a call to the server; without one, wait a moment."""
        uri = self._look_up(end - monotonic())
        if not uri:
            sleep(timeouts.DISCOVERY_PERIOD)
            return
        proxy: Any = rospy.ServiceProxy(self._name, self._service_type, persistent=True)
        proxy.transport = TCPROSTransport(proxy.protocol, self._name)
        call.proxy = proxy  # may be closed from now on
        if not call.response.cancelled():
            proxy.transport.connect(*rospy.core.parse_rosrpc_uri(uri), uri)

    def _idle_proxy(self) -> Any:
        """Return a proxy that is not in use and that the server has not closed, or None."""
        with self._lock:
            while self._idle:
                proxy = self._idle.pop()
                if is_open(proxy.transport.socket):
                    return proxy
                proxy.close()
        return None

    def _look_up(self, timeout: float) -> Optional[str]:
        """Return the URI of a server that accepts connections; a dead one may be registered."""
        timeout = min(max(timeout, 0.0), timeouts.CONNECT_TIMEOUT)
        if not self._lookup_lock.acquire(timeout=timeout):
            return None  # the master does not answer
        try:
            name = rospy.get_name()
            master = rosgraph.Master(name)  # a new one, as it is not thread-safe
            uri: str = master.lookupService(self._name)
            probe = {'probe': '1', 'md5sum': '*', 'callerid': name, 'service': self._name}
            address = rospy.core.parse_rosrpc_uri(uri)
            with socket.create_connection(address, timeouts.CONNECT_TIMEOUT) as connection:
                rosgraph.network.write_ros_handshake_header(connection, probe)
            return uri
        except (rosgraph.MasterException, OSError):
            return None
        finally:
            self._lookup_lock.release()


def is_open(connection: socket.socket) -> bool:
    """Return whether the other side, which sends nothing unasked, has not closed a connection."""
    try:
        connection.recv(1, socket.MSG_PEEK | socket.MSG_DONTWAIT)
    except BlockingIOError:
        return True
    except OSError:
        pass
    return False
