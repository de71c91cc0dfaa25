"""Talk to the node of test_configuration.py: station.py PEER PART, with ros1 or ros2 as PEER."""

import importlib
import sys
import time

TEXT = "std_msgs/msg/String"
LATCHED = {"durability": "transient_local"}
peer = importlib.import_module(sys.argv[1]).Peer()


def wait(what, holds, then=lambda: None):
    end = time.monotonic() + 15
    while not holds():
        assert time.monotonic() < end, what
        then()
        time.sleep(0.1)


def send(topic, text, heard, **qos):
    """Publish a text until it is heard, and return what was heard of it."""
    publisher = peer.publisher(topic, TEXT, **qos)
    message = peer.message(TEXT, data=text)

    def answers():
        return [message.data for message in heard if message.data.startswith(text)]

    wait(f"{topic}: {text} is not heard", answers, lambda: publisher.publish(message))
    return answers()[-1]


def qos():
    seen, ranges = peer.hear("seen", TEXT), peer.hear("range", TEXT)
    assert send("order", "drawn", seen) == "drawn 3"
    send("camera", "photo", seen, reliability="best_effort")
    send("lidar", "echo", ranges, reliability="best_effort")
    time.sleep(1.0)  # for the last order to be drawn
    late = peer.hear("map", TEXT, **LATCHED)
    wait("a late subscriber hears nothing", lambda: late)
    assert [message.data for message in late] == ["drawn 3"], late
    if hasattr(peer, "offered"):
        assert peer.offered("/map") == [("RELIABLE", "TRANSIENT_LOCAL")]
        assert peer.offered("/seen") == [("RELIABLE", "VOLATILE")]


def overridden():
    peer.wait_until_active("station")
    peer.hear("map", TEXT, **LATCHED)
    publisher = peer.publisher("camera", TEXT, reliability="best_effort")
    wait("the topic is not there", lambda: peer.offered("/map"))
    assert peer.offered("/map") == [("RELIABLE", "VOLATILE")]
    assert peer.get_parameter("station", "qos_overrides./map.publisher.history") == "keep_all"
    assert peer.get_parameter("station", "qos_overrides./map.publisher.depth") == 1
    assert peer.get_parameter("station", "qos_overrides./camera.subscription.depth") == 7
    name = "qos_overrides./camera.subscription.durability"
    assert peer.get_parameter("station", name) == "volatile"
    time.sleep(1.0)  # for the node to see this peer
    assert not publisher.connected()


def parameters():
    """A parameter changes while the node is unconfigured; `configure` reads it."""

    def refused(name, value):
        before = peer.get_parameter("station", name)
        reason = peer.refusal("station", name, value)
        assert "limit" in reason, reason
        assert "unconfigured" in reason, reason
        assert peer.get_parameter("station", name) == before

    seen = peer.hear("seen", TEXT)
    assert peer.state("station") == "unconfigured"
    for limit in (4, 5):
        assert peer.set_parameter("station", "limit", limit)
        assert not peer.set_parameter("station", "limit", "text")
        assert not peer.set_parameter("station", "autostart", True)
        assert peer.change_state("station", "configure")
        refused("limit", 7)
        assert peer.set_parameter("station", "gain", limit * 0.1)
        assert peer.change_state("station", "activate")
        refused("limit", 7)
        assert send("order", f"round {limit}", seen) == f"round {limit} {limit}"
        assert peer.change_state("station", "deactivate")
        refused("limit", 7)
        assert peer.change_state("station", "cleanup")


{"qos": qos, "overridden": overridden, "parameters": parameters}[sys.argv[2]]()
peer.close()
