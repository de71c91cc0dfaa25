"""Wait for discovery, of which ROS 2 tells a client only half: that it knows the server."""

import contextlib
import time

from rcl_interfaces.srv import GetParameters
from rclpy.node import NodeNameNonExistentError

PATIENCE = 5.0  # s; a server that answers nobody, as a test may want it, has its time
REPEAT = 0.5  # s


def be_discovered(node, service):
    """Wait until the server of a service knows all clients of a node: it answers to a newer one.

    Fast DDS learns of clients in their order, and drops a response if it does not know, 0.1 s
    later, where it goes.
    """
    end = time.monotonic() + PATIENCE
    while not (found := servers(node, service)) and time.monotonic() < end:
        time.sleep(0.002)
    for name in found:
        client = node.create_client(GetParameters, f"{name}/get_parameters")
        while time.monotonic() < end and not is_answered(client):
            pass
        node.destroy_client(client)


def is_answered(client):
    future = client.call_async(GetParameters.Request())
    end = time.monotonic() + REPEAT
    while not future.done() and time.monotonic() < end:
        time.sleep(0.002)
    return future.done()


def servers(node, service):
    """Return the full names of the nodes that serve it; ROS learns of them after the service."""
    found, service = [], node.resolve_service_name(service)
    for name, namespace in node.get_node_names_and_namespaces():
        with contextlib.suppress(NodeNameNonExistentError):  # it has just ended
            if service in dict(node.get_service_names_and_types_by_node(name, namespace)):
                found.append(f"{namespace.rstrip('/')}/{name}")
    return found
