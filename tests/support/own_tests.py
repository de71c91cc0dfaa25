"""How a node may differ from the one that the tests of its package are for, by the dictionary."""

UNTESTED = {
    "accept": "the logic decides; tests/data/mutants has its faults",
    "broadcaster name": "the logic alone knows it",
    "client_library": "tests/ros/test_driver.py",
    "description": "for people",
    "executable": "of the build files",
    "serviceClient depth": "a middleware does not tell it",
    "serviceClient history": "a middleware does not tell it",
    "serviceServer depth": "tests/contract",
    "serviceServer history": "a middleware does not tell it",
    "instance": "of the launch file",
    "instance name": "of the launch file",
    "queue_size": "tests/contract",
    "reconfigure": "it needs a dynamic parameter; tests/data/mutants has its faults",
    "listener name": "the logic alone knows it",
    "use": "a node has the elements of a group as its own",
    "topic_parameter": "it needs a parameter; tests/data/mutants has its faults",
}
"""Interface kinds and attributes without a test in a package, and why."""
UNTESTED_IN_ROS1 = UNTESTED | {
    "directPublisher deadline": "ROS 1 has none",
    "directPublisher depth": "a publisher does not tell its queue",
    "directPublisher qos": "as its depth",
    "directSubscriber durability": "publishers alone are latched",
    "input depth": "a message of it alone calls nothing",
    "input durability": "publishers alone are latched",
    "input qos": "as its depth",
    "history": "as the depth",
    "lifespan": "ROS 1 has none",
    "liveliness": "ROS 1 has none",
    "liveliness_lease_duration": "ROS 1 has none",
    "publisher deadline": "ROS 1 has none",
    "publisher depth": "a publisher does not tell its queue",
    "publisher qos": "as its depth",
    "reliability": "ROS 1 has TCP_NODELAY for it, which nobody tells",
    "subscriber depth": "one message is taken in a cycle",
    "subscriber durability": "publishers alone are latched",
    "subscriber qos": "as its depth",
}


FREE = {"system_default", "best_available"}
"""QoS that the middleware chooses, which may be what the other spec says."""
LONGEST = 5.0
"""Seconds: for a longer deadline of a subscriber the tests of a package do not wait."""
TIMES = ("deadline", "lifespan", "liveliness", "liveliness_lease_duration")
"""What the tests of a package look for where it is given alone."""


def differences(model, untested):
    """Yield each kind and attribute of a node, and the elements of two specs that differ in it."""
    node = next(owner for owner in model.owners if owner.path == ("node",))
    for owner in model.owners:
        if owner.component != "node":
            continue
        if owner.kind and owner.kind not in untested:
            yield owner.kind, [(owner, model.base(owner))], [(node, model.base(node))]
        is_watched = owner.kind in ("subscriber", "directSubscriber")
        for name, base, values in model.variants(owner):
            full = f"{owner.kind} {name}".strip()
            is_long = is_watched and float(values.get("deadline") or 0.0) > LONGEST
            if FREE.isdisjoint(values.values()) and not is_long and not {name, full} & {*untested}:
                pair = [(owner, base)], [(owner, values)]
                yield full, *(reversed(pair) if name in TIMES else pair)
