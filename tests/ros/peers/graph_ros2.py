"""Prints what ROS knows of a node that runs, as JSON: the entries of NoDL, by the lists it has."""

import json
import runpy
import sys
from pathlib import Path

from rcl_interfaces import srv
from ros2 import Peer

SCRIPT = Path(__file__).parents[3] / "scripts/describe_node.py"
LISTS = ("publishers", "subscriptions", "service_servers", "service_clients")
LISTS += ("action_servers", "action_clients")
POLICIES = ("history", "depth", "reliability", "durability")


def policies(infos, node):
    """Return each policy of a node's topic that the middleware tells."""
    known = {}
    for info in infos:
        if f"{info.node_namespace.rstrip('/')}/{info.node_name}" == node:
            found = {name: getattr(info.qos_profile, name) for name in POLICIES}
            words = {name: getattr(value, "name", value) for name, value in found.items()}
            known |= {name: word for name, word in words.items() if word not in ("UNKNOWN", 0)}
    return known


def main():
    node = sys.argv[1]
    peer = Peer()
    peer.wait_until_active(node)
    peer.close()
    ros = runpy.run_path(str(SCRIPT))["Ros2"]()
    dict(ros.describe([node]))  # waits until the graph is whole
    found = dict(zip(LISTS, ros.graph()[node], strict=True))
    asked = (ros.node.get_publishers_info_by_topic, ros.node.get_subscriptions_info_by_topic)
    qos = {
        list_: {name: policies(ask(name), node) for name in found[list_]}
        for list_, ask in zip(LISTS, asked, strict=False)
    }
    names = ros.call(srv.ListParameters, f"{node}/list_parameters").result.names
    types = ros.call(srv.GetParameterTypes, f"{node}/get_parameter_types", names=names).types
    found["parameters"] = dict(zip(names, types, strict=True))
    print(json.dumps({**found, "qos": qos}))


if __name__ == "__main__":
    main()
