"""Filters that turn the QoS of a topic in a spec into policies, and these into code.

A topic has the optional keys `qos`, a profile of rmw, and `reliability`, `durability`, `history`
and `depth`, the policies that differ from those of the profile; one that is published also has
`deadline`, `lifespan`, `liveliness` and `liveliness_lease_duration`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_WIDTH = 99
_DEFAULT: dict[str, Any] = {
    "reliability": "reliable",
    "durability": "volatile",
    "history": "keep_last",
    "depth": 10,
}
_OFFERED = ("deadline", "lifespan", "liveliness", "liveliness_lease_duration")
_KEEP_ALL = {"history": "keep_all", "depth": 0}
# As rmw/qos_profiles.h has them; there, too, a depth of 0 is the middleware's own.
_PROFILES: dict[str, dict[str, Any]] = {
    "default": _DEFAULT,
    "sensor_data": _DEFAULT | {"reliability": "best_effort", "depth": 5},
    "system_default": dict.fromkeys(_DEFAULT, "system_default") | {"depth": 0},
    "best_available": _DEFAULT | {"reliability": "best_available", "durability": "best_available"},
}
_RCLCPP = {
    ("reliability", "reliable"): ".reliable()",
    ("reliability", "best_effort"): ".best_effort()",
    ("reliability", "best_available"): ".reliability_best_available()",
    ("reliability", "system_default"): ".reliability(rclcpp::ReliabilityPolicy::SystemDefault)",
    ("durability", "volatile"): ".durability_volatile()",
    ("durability", "transient_local"): ".transient_local()",
    ("durability", "best_available"): ".durability_best_available()",
    ("durability", "system_default"): ".durability(rclcpp::DurabilityPolicy::SystemDefault)",
    ("history", "system_default"): ".history(rclcpp::HistoryPolicy::SystemDefault)",
}


def qos(topic: Mapping[str, Any]) -> dict[str, Any]:
    """Return the four policies of a topic: those of its profile, changed by its own.

    The depth is a number of messages, 0 where all are kept or the middleware chooses it.
    """
    given = {name: topic[name] for name in _DEFAULT if topic.get(name) is not None}
    policies = _PROFILES[topic.get("qos") or "default"] | given
    if policies["history"] == "keep_all":
        return policies | _KEEP_ALL
    if policies["history"] == "keep_last":
        policies["depth"] = policies["depth"] or _DEFAULT["depth"]
    return policies


def offered(topic: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a publisher offers besides: times in s, and the word of its liveliness.

    Nothing for what is the default: without end, and `automatic`.
    """
    given = {name: topic[name] for name in _OFFERED if topic.get(name) is not None}
    return {name: value for name, value in given.items() if value != "automatic"}


def offering(topics: list[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return those of some publishers that offer something besides."""
    return [topic for topic in topics if offered(topic)]


def qos_words(topic: Mapping[str, Any], ros: int = 2, publishes: bool = True) -> str:
    """Return in words what is not the default QoS: `best_effort, depth 5`, or nothing.

    For ROS 1, what a publisher or a subscriber makes of it: `latched, queue 1`. The deadline of
    a subscriber, which the node watches itself, is in the words of both.
    """
    late = [f"deadline {topic['deadline']:g} s"] if topic.get("deadline") else []
    if ros == 1:
        return ", ".join([*_ros1_words(topic, publishes), *([] if publishes else late)])
    changed = _changed(qos(topic), _DEFAULT)
    words = [
        f"{name} {value}" if name == "depth" or value in _PROFILES else value
        for name, value in changed.items()
        if value
    ]
    if not publishes:
        return ", ".join([*words, *late])
    names = {"liveliness_lease_duration": "lease"}
    words += [
        value if isinstance(value, str) else f"{names.get(name, name)} {value:g} s"
        for name, value in offered(topic).items()
    ]
    return ", ".join(words)


def _ros1_words(topic: Mapping[str, Any], publishes: bool) -> list[str]:
    policies, size = qos(topic), queue_size(topic)
    words = []
    if publishes and policies["durability"] == "transient_local":
        words.append("latched")
    if size != _DEFAULT["depth"]:
        words.append(f"queue {size}" if size else "queue without limit")
    if not publishes and policies["reliability"] == "best_effort":
        words.append("TCP_NODELAY")
    return words


def rclpy_qos(topic: Mapping[str, Any], indent: int, publishes: bool = False) -> str:
    """Return the QoSProfile of a topic in Python, split where it is too long after `indent`.

    Nothing where the QoS is the default one. No profile of rclpy is named, for rclpy writes
    overrides into the object that it is given (decision 37).
    """
    policies = qos(topic)
    changed = _changed(policies, _DEFAULT | {"depth": policies["depth"]})
    more = offered(topic) if publishes else {}
    if policies == _DEFAULT and not more:
        return ""
    arguments = [
        f"{name}={name.capitalize()}Policy.{value.upper()}" for name, value in changed.items()
    ]
    if policies["history"] != "keep_all":
        arguments.append(f"depth={policies['depth']}")
    arguments += [
        f"{name}=LivelinessPolicy.{value.upper()}"
        if isinstance(value, str)
        else f"{name}=Duration(seconds={value:.12g})"
        for name, value in more.items()
    ]
    line = f"QoSProfile({', '.join(arguments)})"
    if indent + len(line) < _WIDTH:
        return line
    margin = "\n" + " " * indent
    return "QoSProfile(" + "".join(f"{margin}    {item}," for item in arguments) + margin + ")"


def rclpy_qos_names(
    topics: list[Mapping[str, Any]], published: list[Mapping[str, Any]] | None = None
) -> list[str]:
    """Return the names that the profiles of topics need from `rclpy.qos`."""
    changed = {name for topic in topics for name in _changed(qos(topic), _DEFAULT)}
    more = {name for topic in published or () for name in offered(topic)}
    words = changed - {"depth"} | more & {"liveliness"}
    policies = [f"{name.capitalize()}Policy" for name in words]
    return [*policies, "QoSProfile"] if changed or more else []


def offers_times(topics: list[Mapping[str, Any]]) -> bool:
    """Return whether the profiles of publishers have times."""
    return any(set(offered(topic)) - {"liveliness"} for topic in topics)


def rclcpp_qos(topic: Mapping[str, Any], indent: int, publishes: bool = False) -> str:
    """Return the rclcpp::QoS of a topic, split where it is too long after `indent`.

    Nothing where the QoS is the default one.
    """
    policies = qos(topic)
    more = offered(topic) if publishes else {}
    if policies == _DEFAULT and not more:
        return ""
    if policies == _PROFILES["sensor_data"]:
        base, known = "rclcpp::SensorDataQoS()", policies
    elif policies["depth"]:
        base, known = f"rclcpp::QoS({policies['depth']})", _DEFAULT | {"depth": policies["depth"]}
    elif policies["history"] == "keep_all":
        base, known = "rclcpp::QoS(rclcpp::KeepAll())", _DEFAULT | _KEEP_ALL
    else:
        base, known = "rclcpp::SystemDefaultsQoS()", _PROFILES["system_default"]
    calls = [_RCLCPP[item] for item in _changed(policies, known).items()]
    calls += [
        f".{name}(rclcpp::LivelinessPolicy::ManualByTopic)"
        if isinstance(value, str)
        else f".{name}(rclcpp::Duration::from_seconds({value:.12g}))"
        for name, value in more.items()
    ]
    line = base + "".join(calls)
    return line if indent + len(line) < _WIDTH else ("\n" + " " * indent).join([base, *calls])


def queue_size(topic: Mapping[str, Any]) -> int:
    """Return how many messages ROS 1 keeps for a topic; 0 is without limit."""
    policies = qos(topic)
    unlimited = policies["history"] == "keep_all"
    return 0 if unlimited else int(policies["depth"] or _DEFAULT["depth"])


def _changed(policies: dict[str, Any], others: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in policies.items() if value != others[name]}
