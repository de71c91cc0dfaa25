#!/usr/bin/env python3
"""Ask nodes that run what they are, by ROS's own interfaces, and print a spec of them.

    python3 describe_node.py /arm/driver /arm/planner > arm.ros_package

It needs nothing but the ROS of the nodes, sourced: ROS 1 or ROS 2. What ROS does not tell is to be
added by hand: what things are for; in ROS 1 clients of services, and sizes of queues; in ROS 2
depth and history, where the middleware keeps them to itself. Comments tell what no spec can say
(decision 119).
"""

from __future__ import annotations

import argparse
import ast
import getpass
import io
import json
import math
import os
import re
import socket
import sys
import time
from collections.abc import Iterable, Iterator
from typing import Any
from xml.sax.saxutils import quoteattr
from xmlrpc.client import ServerProxy

Item = Any
"""A tag and its attributes, or the text of a comment."""

PATIENCE = 5.0  # s, for discovery, and for each answer
OWN_TOPICS = {
    "directPublisher": {"/parameter_events", "/rosout"},
    "directSubscriber": {"/clock", "/parameter_events"},
}
OWN_TYPES = r"(lifecycle_msgs|rcl_interfaces|type_description_interfaces|roscpp)/|.*/FrameGraph"
"""Those of the private names that ROS gives to every node, those with a lifecycle or with tf."""
OWN_PARAMETERS = {"autostart", "log_level", "stop_timeout", "use_sim_time"}
OWN_PARAMETERS |= {"start_type_description_service"}
"""Those of every node of a package, or of every node."""
LIMITS = (-(2**31), 2**31 - 1, -(2**63), 2**63 - 1, -sys.float_info.max, sys.float_info.max)
"""What a range says that has no limit."""
TYPES = {bool: "bool", int: "int", float: "double", str: "string"}


def main() -> None:
    """Print the spec of the nodes that the command line names."""
    parser = argparse.ArgumentParser(description="Print a spec of nodes that run.")
    parser.add_argument("nodes", nargs="+", metavar="NODE", help="the full name: /arm/driver")
    names = ["/" + name.strip("/") for name in parser.parse_args().nodes]
    printed = os.dup(1)
    os.dup2(2, 1)  # Fast DDS 3.2 logs its errors to standard output, where the spec goes
    try:
        import rclpy  # type: ignore[import-not-found]  # noqa: F401
    except ImportError:
        found = {name: list(items) for name, items in Ros1().describe(names)}
    else:
        found = {name: list(items) for name, items in Ros2().describe(names)}
    with open(printed, "wb") as file:
        file.write("\n".join([*spec(found), ""]).encode())


def spec(nodes: dict[str, list[Item]]) -> Iterator[str]:
    """Yield the lines of the spec of a package with the nodes."""
    package = re.sub(r"\W+", "_", next(iter(nodes)).rpartition("/")[2].lower())
    user = re.sub(r"\W", "", getpass.getuser()) or "user"
    about = {"name": package, "author": user, "author_email": f"{user}@todo.todo"}
    about.update(description="TODO: what the package is for", license="Apache-2.0")
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield element("package", about, ">")
    for name, items in nodes.items():
        own = {"name": name.rpartition("/")[2]}
        for tag, attributes in [item for item in items if not isinstance(item, str)]:
            own.update(attributes if tag == "node" else {})
        yield "  " + element("node", own, ">")
        for item in items:
            if isinstance(item, str):
                yield "    <!-- " + re.sub("-(?=-)", "- ", item) + " -->"
            elif item[0] != "node":
                yield "    " + element(item[0], item[1], "/>")
        yield "  </node>"
    yield "</package>"


def element(tag: str, attributes: dict[str, Any], end: str) -> str:
    """Return a tag with its attributes, but for those without a value."""
    given = {name: value for name, value in attributes.items() if value is not None}
    texts = {
        n: v if isinstance(v, str) else json.dumps(v, ensure_ascii=False) for n, v in given.items()
    }
    return " ".join(["<" + tag, *(f"{name}={quoteattr(v)}" for name, v in texts.items())]) + end


def relative(name: str, node: str) -> str:
    """Return a name as the node may have given it: private, or in its namespace."""
    if name.startswith(node + "/"):
        return "~" + name[len(node) :]
    namespace = node.rpartition("/")[0] + "/"
    return name[len(namespace) :] if name.startswith(namespace) else name


def interfaces(kind: str, found: dict[str, str], node: str, **more: Any) -> Iterator[Item]:
    """Yield those of a kind, without ROS's own; each of `more` gives an attribute of a name."""
    for name, type_ in sorted(found.items()):
        shown = relative(name, node)
        is_own = shown[0] == "~" and re.match(OWN_TYPES, type_)
        if is_own or name in OWN_TOPICS.get(kind, ()):
            continue
        if type_ in ("", "*", None):
            yield f"{kind} {shown}: of a type that ROS does not know now"
            continue
        attributes = {"name": shown, "type": type_}
        for each in more.values():
            attributes.update(each(name))
        yield kind, attributes


def transforms(kind: str, topics: dict[str, str]) -> Iterator[Item]:
    """Yield what uses both topics of transforms, and take them out."""
    if {"/tf", "/tf_static"} <= set(topics):
        del topics["/tf"], topics["/tf_static"]
        yield kind, {"name": "tf"}


def parameter(kind: str, name: str, value: Any, **more: Any) -> Item:
    """Return a parameter with its value, or why there is none."""
    values = value if isinstance(value, list) else [value]
    kinds = {type(each) for each in values}
    kinds = {float} if kinds == {int, float} else kinds
    if len(kinds) != 1 or not kinds <= set(TYPES) or (isinstance(value, str) and "\0" in value):
        return f"{kind} {name}: no spec can say {value!r}"
    (type_,) = kinds
    if type_ is float and not all(map(math.isfinite, values)):
        return f"{kind} {name}: no spec can say {value!r}"
    if not re.fullmatch(r"[A-Za-z]\w*(\.[A-Za-z]\w*)*", name, re.ASCII):
        return f"{kind} {name}: no spec has such a name"
    typed = [type_(each) for each in values]
    attributes = {"name": name, "type": TYPES[type_] + "[]" * isinstance(value, list)}
    for word in ("min", "max"):
        limit = more.pop(word, None)
        if type_ in (int, float) and limit not in (None, *LIMITS) and math.isfinite(limit):
            attributes[word] = limit
    return kind, {**attributes, **more, "value": typed if isinstance(value, list) else typed[0]}


class Ros1:
    """What the master of ROS 1, its parameters and the nodes themselves say."""

    def __init__(self) -> None:
        import rosgraph  # type: ignore[import-not-found]
        import rosgraph.network  # type: ignore[import-not-found]
        import rosservice  # type: ignore[import-not-found]

        self.network, self.service_type = rosgraph.network, rosservice.get_service_type
        self.master = rosgraph.Master("/describe_node")

    def describe(self, names: list[str]) -> Iterator[tuple[str, Iterable[Item]]]:
        """Yield the nodes with their interfaces."""
        state = self.master.getSystemState()
        for node in names:
            published, subscribed, served = (
                [name for name, nodes in part if node in nodes] for part in state
            )
            if not [*published, *subscribed, *served]:
                what = f"{node}: no such node; rosnode list says which there are"
                raise SystemExit(f"{what} [no-such-node]")
            yield node, self.items(node, published, subscribed, served)

    def items(
        self, node: str, published: list[str], subscribed: list[str], served: list[str]
    ) -> Iterator[Item]:
        """Yield the interfaces of a node."""
        types = dict(self.master.getTopicTypes())
        outgoing = {name: types.get(name, "") for name in published}
        incoming = {name: types.get(name, "") for name in subscribed}
        services = {name: self.service_type(name) or "" for name in served}
        actions = [
            *self.actions("actionServer", incoming, outgoing, node),
            *self.actions("actionClient", outgoing, incoming, node),
        ]
        known: set[str] = set()
        if services.get(f"{node}/set_parameters") == "dynamic_reconfigure/Reconfigure":
            del services[f"{node}/set_parameters"]
            for topic in ("parameter_descriptions", "parameter_updates"):
                outgoing.pop(f"{node}/{topic}", None)
            yield "node", {"frequency": 10.0}
            for name, item in self.dynamic_parameters(node):
                known.add(name)
                yield item
        for name in sorted(self.master.getParamNames()):
            shown = name[len(node) + 1 :].replace("/", ".")
            if not name.startswith(node + "/") or shown in known | OWN_PARAMETERS:
                continue
            value = self.master.getParam(name)
            if shown == "frequency":
                yield "node", {"frequency": value}
            else:
                yield parameter("parameter", shown, value)
        yield from transforms("broadcaster", outgoing)
        yield from transforms("listener", incoming)
        yield from interfaces(
            "directPublisher", outgoing, node, latched=lambda name: self.latched(node, name)
        )
        yield from interfaces("directSubscriber", incoming, node)
        yield from interfaces("serviceServer", services, node)
        yield from actions

    def actions(
        self, kind: str, to: dict[str, str], back: dict[str, str], node: str
    ) -> Iterator[Item]:
        """Yield what has the five topics of an action, and take them out."""
        for goal, type_ in sorted(to.items()):
            name = goal[: -len("/goal")]
            there, here = {goal, f"{name}/cancel"}, {f"{name}/{w}" for w in FROM_SERVER}
            if type_.endswith("ActionGoal") and there <= set(to) and here <= set(back):
                for topic in there:
                    del to[topic]
                for topic in here:
                    del back[topic]
                yield from interfaces(kind, {name: type_[: -len("ActionGoal")]}, node)

    def dynamic_parameters(self, node: str) -> Iterator[tuple[str, Item]]:
        """Yield the parameters of dynamic_reconfigure, by their names."""
        import rospy  # type: ignore[import-not-found]
        from dynamic_reconfigure.msg import ConfigDescription  # type: ignore[import-not-found]

        rospy.init_node("describe_node", anonymous=True, disable_signals=True)
        topic = f"{node}/parameter_descriptions"
        said = rospy.wait_for_message(topic, ConfigDescription, PATIENCE)
        lowest, highest, first = (
            {each.name: each.value for part in parts for each in part}
            for parts in (
                (config.bools, config.ints, config.strs, config.doubles)
                for config in (said.min, said.max, said.dflt)
            )
        )
        for each in [each for group in said.groups for each in group.parameters]:
            enum = ast.literal_eval(each.edit_method)["enum"] if each.edit_method else []
            choices = [option["value"] for option in enum] or None
            is_free = each.type in ("int", "double") and not choices
            yield (
                each.name,
                parameter(
                    "dynParameter",
                    each.name,
                    self.master.getParam(f"{node}/{each.name}")
                    if self.master.hasParam(f"{node}/{each.name}")
                    else first[each.name],
                    min=lowest[each.name] if is_free else None,
                    max=highest[each.name] if is_free else None,
                    choices=choices,
                    description=each.description or None,
                ),
            )

    def latched(self, node: str, topic: str) -> dict[str, str]:
        """Ask the node for a connection, whose header says whether it keeps the last message."""
        slave: Any = ServerProxy(self.master.lookupNode(node))
        _, _, (_, host, port) = slave.requestTopic("/describe_node", topic, [["TCPROS"]])
        asked = {"topic": topic, "callerid": "/describe_node", "md5sum": "*", "type": "*"}
        with socket.create_connection((host, port), PATIENCE) as connection:
            self.network.write_ros_handshake_header(connection, asked)
            header = self.network.read_ros_handshake_header(connection, io.BytesIO(), 65536)
        return {"durability": "transient_local"} if header.get("latching") == "1" else {}


FROM_SERVER = ("status", "feedback", "result")


class Ros2:
    """What the graph of ROS 2 and the parameter services of the nodes say."""

    def __init__(self) -> None:
        import rclpy
        import rclpy.action  # type: ignore[import-not-found]

        rclpy.init()
        self.rclpy = rclpy
        self.node = rclpy.create_node("describe_node", start_parameter_services=False)

    def describe(self, names: list[str]) -> Iterator[tuple[str, Iterable[Item]]]:
        """Yield the nodes with their interfaces."""
        end, before = time.monotonic() + PATIENCE, None
        while (now := self.graph()) != before or not set(names) <= set(now):
            if time.monotonic() > end:
                missing = [name for name in names if name not in now] or names
                what = f"{missing[0]}: no such node; ros2 node list says which there are"
                raise SystemExit(f"{what} [no-such-node]")
            before = now
            time.sleep(1.0)
        for name in names:
            yield name, self.items(name, *now[name])

    def graph(self) -> dict[str, list[dict[str, str]]]:
        """Return topics, services and actions of all nodes, with their types."""
        node, action = self.node, self.rclpy.action
        return {
            f"{space.rstrip('/')}/{name}": [
                {topic: types[0] for topic, types in found if "/_" not in topic}
                for found in (
                    node.get_publisher_names_and_types_by_node(name, space),
                    node.get_subscriber_names_and_types_by_node(name, space),
                    node.get_service_names_and_types_by_node(name, space),
                    node.get_client_names_and_types_by_node(name, space),
                    action.get_action_server_names_and_types_by_node(node, name, space),
                    action.get_action_client_names_and_types_by_node(node, name, space),
                )
            ]
            for name, space in node.get_node_names_and_namespaces()
        }

    def items(self, node: str, *found: dict[str, str]) -> Iterator[Item]:
        """Yield the interfaces of a node."""
        outgoing, incoming, services, clients, servers, senders = map(dict, found)
        yield from self.parameters(node)
        yield from transforms("broadcaster", outgoing)
        yield from transforms("listener", incoming)
        of = self.node
        yield from interfaces(
            "directPublisher",
            outgoing,
            node,
            qos=lambda name: self.qos(node, of.get_publishers_info_by_topic(name), OFFERED),
        )
        yield from interfaces(
            "directSubscriber",
            incoming,
            node,
            qos=lambda name: self.qos(
                node, of.get_subscriptions_info_by_topic(name), ("deadline",)
            ),
        )
        yield from interfaces("serviceServer", services, node)
        yield from interfaces("serviceClient", clients, node)
        yield from interfaces("actionServer", servers, node)
        yield from interfaces("actionClient", senders, node)

    def qos(self, node: str, infos: Iterable[Any], more: tuple[str, ...]) -> dict[str, Any]:
        """Return the policies of a node's topic that are not the default ones."""
        given: dict[str, Any] = {}
        for info in infos:
            if f"{info.node_namespace.rstrip('/')}/{info.node_name}" == node:
                for word, default in QOS.items():
                    policy = getattr(info.qos_profile, word).name.lower()
                    given.update({word: policy} if policy not in (default, "unknown") else {})
                depth = info.qos_profile.depth
                if depth not in (0, 10) and given.get("history") != "keep_all":
                    given["depth"] = depth
                for word in more:
                    policy = getattr(info.qos_profile, word)
                    if word == "liveliness":
                        policy = policy.name.lower()
                        given.update({word: policy} if policy == "manual_by_topic" else {})
                    elif 0.0 < policy.nanoseconds <= LONGEST:
                        given[word] = policy.nanoseconds / 1e9
        return given

    def parameters(self, node: str) -> Iterator[Item]:
        """Yield the parameters of a node."""
        from rcl_interfaces import srv  # type: ignore[import-not-found]
        from rclpy.parameter import parameter_value_to_python  # type: ignore[import-not-found]

        listed = self.call(srv.ListParameters, f"{node}/list_parameters")
        if listed is None:
            yield "parameters: the node does not answer"
            return
        left = [name for name in sorted(listed.result.names) if name not in OWN_PARAMETERS]
        names = [name for name in left if not name.startswith("qos_overrides.")]
        described = self.call(srv.DescribeParameters, f"{node}/describe_parameters", names=names)
        values = self.call(srv.GetParameters, f"{node}/get_parameters", names=names)
        for name, about, each in zip(names, described.descriptors, values.values, strict=True):
            value = parameter_value_to_python(each)
            value = list(value) if hasattr(value, "tolist") else value
            if name == "frequency":
                yield "node", {"frequency": value}
                continue
            span = [*about.integer_range, *about.floating_point_range]
            bounds = {"min": span[0].from_value, "max": span[0].to_value} if span else {}
            yield parameter(
                "parameter", name, value, **bounds, description=about.description or None
            )

    def call(self, type_: Any, name: str, **fields: Any) -> Any:
        """Return the response of a service, or nothing where none comes."""
        client = self.node.create_client(type_, name)
        if not client.wait_for_service(PATIENCE):
            return None
        future = client.call_async(type_.Request(**fields))
        self.rclpy.spin_until_future_complete(self.node, future, timeout_sec=PATIENCE)
        return future.result()


OFFERED = ("deadline", "lifespan", "liveliness", "liveliness_lease_duration")
LONGEST = 86400 * 10**9  # ns, of a time that a spec can say
QOS = {"reliability": "reliable", "durability": "volatile", "history": "keep_last"}


if __name__ == "__main__":
    main()
