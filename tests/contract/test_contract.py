"""docs/nodes.md, line by line, held to running nodes: both languages, both ROS, faults injected.

Each scenario runs for each variant; -k "python_model-kilted and stop" selects. At the end of each,
`stage` stops the nodes that still run and sees that they end with 0, in silence, and that the
trace shows the order and the threads of the contract.
"""

import contextlib
import copy
import ctypes
import dataclasses
import itertools
import json
import math
import os
import random
import re
import signal
import socket
import statistics
import time
from xmlrpc.client import ServerProxy

import pytest

from support import ros
from support.contract import LATES, METHODS, wait_for

SIGNALS = int(os.environ.get("CONTRACT_SIGNALS", 4))
ROUNDS = int(os.environ.get("CONTRACT_ROUNDS", 150))
LIVES = int(os.environ.get("CONTRACT_LIVES", 15))
INT64 = "std_msgs/msg/Int64"
STRING = "std_msgs/msg/String"
LIFE = [*METHODS]
SOON = 15.0  # s; bounds of the contract plus what a busy machine needs, far less than the waits


def only_ros2(stage, why="ROS 1 has no lifecycle transitions"):
    if not stage.variant.is_ros2:
        pytest.skip(f"does not apply: {why}")


def only_ros1(stage, why):
    if stage.variant.is_ros2:
        pytest.skip(f"does not apply: {why}")


def only_python(stage, why):
    if not stage.variant.is_python:
        pytest.skip(f"does not apply: {why}")


def only_rclcpp(stage, why):
    if not stage.variant.is_ros2 or stage.variant.is_python:
        pytest.skip(f"does not apply: {why}")


def only_components(stage):
    only_rclcpp(stage, "only C++ in ROS 2 has components")


def needs_tf(stage):
    if not stage.variant.has_tf:
        pytest.skip("tf2_ros is not installed")


def joined(stage, method, told=(), **parameters):
    """Start joiner; return it, and what tells what a synchronizer has given so far."""
    if not stage.variant.has_filters:
        pytest.skip("message_filters is not installed")
    node = stage.start("joiner", *told, **parameters)
    node.wait("activate", "end")
    return node, lambda: [event["value"] for event in node.events(method, "begin")]


# The five methods, and the threads


def test_order_and_threads(stage):
    """All runs in order, in the thread `logic`; each callback in a thread named after it."""
    node = stage.active()
    stage.publish("hear", "hello")
    assert stage.call().result() == "served"
    for action in ("work", "line", "single"):
        goal = stage.goal(action, 5)
        assert stage.result(goal) == ["succeeded", [5]]
    node.wait("receive", "end")
    named = {name: node.wait(name)["thread"] for name in ("serve", "work", "line", "single")}
    named["hear"] = node.wait("receive")["thread"]
    assert all(name in thread for name, thread in named.items()), named
    assert "logic" in node.threads()
    assert node.stop() == 0
    assert node.methods() == LIFE


def test_messages_of_several_publishers(stage):
    """The callback is called for one after another, though each may have a connection."""
    node = stage.active()
    publishers = (stage.peer, stage.another_peer())
    message = {"topic": stage.name("hear"), "kind": "std_msgs/msg/String", "data": "hello"}
    for count, publisher in enumerate(publishers, 1):
        publisher.publish(**message)
        node.wait("receive", "end", count)
    node.tell("receive: sleep 1")
    for publisher in publishers:
        publisher.publish(**message)
    node.wait("receive", "end", 4)
    events = [event["event"] for event in node.events("receive")]
    assert [event for event in events if event in ("begin", "end")] == ["begin", "end"] * 4


def test_node_without_a_frequency(stage):
    node = stage.start("clerk", "deactivate: publish STOP")
    heard = stage.listen(node, ask=lambda: stage.call("greet").result() != "greeted")
    assert node.stop() == 0
    assert node.methods() == [name for name in LIFE if name != "update"]
    wait_for(lambda: heard() == ["STOP"], lambda: f"heard {heard()}")


def stop_by_transitions(stage, node):
    assert stage.transition("deactivate", "cleanup")
    assert stage.state() == "unconfigured"


def stop_by_shutdown(stage, node):
    assert stage.transition("shutdown")
    assert stage.state() == "finalized"


def test_node_of_the_client_library(stage):
    """What the logic makes of `passthrough.node` is there beside what the spec says."""
    node = stage.start("clerk", "serve: open opened")
    heard = stage.hear("door")
    wait_for(
        lambda: stage.call("greet").result() == "greeted" and "opened" in heard(),
        lambda: f"heard nothing: {node.story()}",
    )
    assert node.stop() == 0


STOPS = {
    "sigint": lambda stage, node: node.stop(signal.SIGINT),
    "sigterm": lambda stage, node: node.stop(signal.SIGTERM),
    "kill": lambda stage, node: (
        stage.peer.kill_node(node=stage.name("probe")),
        node.exit(),
    ),
    "transitions": stop_by_transitions,
    "shutdown": stop_by_shutdown,
}


@pytest.mark.parametrize("way", STOPS)
def test_last_word(stage, way):
    """What `deactivate` and `cleanup` publish leaves the node, however it stops."""
    if way == "kill":
        only_ros1(stage, "ROS 2 has no rosnode kill")
    if way in ("transitions", "shutdown"):
        only_ros2(stage)
    node = stage.active("deactivate: publish STOP", "cleanup: publish OFF")
    heard = stage.listen(node)
    STOPS[way](stage, node)
    wait_for(lambda: heard() == ["STOP", "OFF"], lambda: f"heard {heard()}: {node.story()}")
    if way in ("sigint", "sigterm", "kill"):
        assert node.exit() == 0


@pytest.mark.parametrize("way", ["sigint", "transitions"])
def test_long_last_word(stage, way):
    """A last message arrives whole that takes longer to send than the node would to end."""
    if way == "transitions":
        only_ros2(stage)
    node = stage.active("cleanup: shout 5000000")
    heard = stage.listen(node)
    STOPS[way](stage, node)
    wait_for(lambda: [len(text) for text in heard()] == [5000000], node.story)


@pytest.mark.parametrize("way", ["autostart", "transitions"])
def test_everything_works_in_all_five(stage, way):
    """Messages leave, calls and goals are answered, transforms are found, in all five."""
    stage.serve()
    served = stage.serve_action()
    heard = stage.hear("say")
    if stage.variant.has_tf:
        stage.peer.transform(parent="map", child="robot", x=7.0)
    lines = [f"once {method}: publish {method}" for method in LIFE]
    lines += [f"once {method}: call 10" for method in LIFE]
    lines += [f"once {method}: goal {number}" for number, method in enumerate(LIFE, 1)]
    if stage.variant.has_tf:
        lines += [f"once {method}: lookup map robot 10" for method in LIFE]
    # Both peers need a moment to find each other: as long as a message takes to be heard.
    lines.insert(0, "once configure: block 0.5")
    if way == "transitions":
        only_ros2(stage)
        node = stage.start("probe", *lines, autostart=False, stop_timeout=10.0)
        assert stage.transition("configure", "activate"), node.story()
        node.wait("update", "end")
        assert stage.transition("deactivate", "cleanup"), node.story()
    else:
        node = stage.start("probe", *lines, stop_timeout=10.0)
        node.wait("update", "end")
        assert node.stop() == 0, node.story()
    for method in LIFE:
        assert node.value(method, "call") == "yes", f"{method}: {node.story()}"
        assert node.value(method, "goal") == "succeeded", f"{method}: {node.story()}"
        if stage.variant.has_tf:
            assert node.value(method, "lookup") == 7.0, f"{method}: {node.story()}"
    assert [("goal", number) in served() for number in range(1, 6)] == [True] * 5, served()
    wait_for(lambda: set(heard()) >= {*LIFE[1:]}, lambda: f"heard {heard()}")


# Stops


WAITS = {
    "call": ("call 60", None),
    "call of a missing server": ("call 60", None),
    "lookup": ("lookup map nowhere 60", ...),
    "sleep": ("sleep 60", False),
    "goal": ("goal 1", "stopped"),
}


@pytest.mark.parametrize("wait", WAITS)
def test_stop_ends_wait(stage, wait):
    """A wait of `update` ends at once when the node stops; one in `deactivate` works again."""
    if wait == "lookup":
        needs_tf(stage)
    command, value = WAITS[wait]
    if wait == "call":
        stage.serve(seconds=60.0)
    if wait == "goal":
        served = stage.serve_action(seconds=60.0)
    node = stage.start("probe", f"once update: {command}", "deactivate: sleep 0.2")
    node.wait("update")
    if wait == "call":
        wait_for(lambda: stage.peer.served_log(name=stage.name("ask")), "not called")
    elif wait == "goal":
        wait_for(lambda: served(), "no goal")
    else:
        time.sleep(0.3)  # it waits by then, or stops as well if not
    assert node.stop() == 0
    if value is not ...:
        assert node.value("update", command.split()[0]) == value
    assert node.value("deactivate", "sleep") is True


@pytest.mark.parametrize("wait", ["call inf", "lookup map nowhere inf", "sleep inf"])
def test_stop_ends_endless_wait(stage, wait):
    if "lookup" in wait:
        needs_tf(stage)
    stage.serve(seconds=60.0)
    node = stage.active()
    node.tell("once update: block 0", f"once update: {wait}")
    node.wait("update", "block")
    if "call" in wait:
        wait_for(lambda: stage.peer.served_log(name=stage.name("ask")), node.story)
    time.sleep(0.3)  # it waits by then, or stops as well if not
    assert not node.events("update", wait.split()[0]), node.story()
    assert node.stop() == 0, node.story()
    node.wait("update", wait.split()[0])


def test_stop_ends_waits_of_callbacks(stage):
    """So do those of callbacks, all at the same time; the call that was served is answered."""
    node = stage.active("receive: sleep 60", "serve: call 60")
    stage.publish("hear", "wait")
    answer = stage.call()
    goal = stage.goal("work", 1000)
    for method in ("receive", "serve", "work"):
        node.wait(method)
    assert node.stop() == 0
    assert node.value("receive", "sleep") is False
    assert node.value("serve", "call") is None
    assert stage.result(goal)[0] == "aborted"
    assert node.value("work", "over") == 1000
    assert answer.exception() is None or not stage.variant.is_ros2


@pytest.mark.parametrize("where", ["deactivate", "cleanup"])
def test_stop_bounds_waits(stage, where):
    """`deactivate` and `cleanup` may wait, for stop_timeout and no longer."""
    node = stage.active(f"{where}: sleep 60", stop_timeout=0.5)
    node.send_signal()
    node.exit(SOON)
    assert node.value(where, "sleep") is False
    assert node.methods() == LIFE
    node.ended_well = False


@pytest.mark.parametrize("where", ["deactivate", "cleanup"])
def test_signal_cuts_no_last_wait(stage, where):
    """A signal that comes while `deactivate` or `cleanup` waits leaves them their time."""
    only_ros2(stage)
    stage.serve(seconds=1.0)
    node = stage.active(f"{where}: call 10", stop_timeout=10.0)
    names = ["deactivate", "cleanup"] if where == "cleanup" else ["deactivate"]
    stage.transition(*names[:-1])
    stage.peer.begin("change_state", node=stage.name("probe"), transition=names[-1])
    node.wait(where)
    time.sleep(0.3)
    node.send_signal()
    assert node.exit(SOON) == 0, node.story()
    assert node.value(where, "call") == "yes", node.story()
    assert node.methods() == LIFE


def test_signal_beside_a_transition(stage):
    """A transition that begins beside a signal is waited for, and what is left is cleaned up."""
    only_rclcpp(stage, "it is about a moment within rclcpp")
    told = ("deactivate: publish STOP", "cleanup: publish OFF")
    node = stage.active(*told)
    heard = stage.listen(node)
    node.tell(*told, "once transition: block 1")
    stage.peer.begin("change_state", node=stage.name("probe"), transition="deactivate")
    node.wait("transition")
    assert node.stop() == 0, node.story()
    assert node.methods() == LIFE, node.story()
    wait_for(lambda: heard() == ["STOP", "OFF"], lambda: f"heard {heard()}: {node.story()}")


def test_signal_to_another_thread(stage):
    """The system may give a signal to any thread of a process."""
    node = stage.active()
    *_, thread = node.thread_ids()
    assert ctypes.CDLL(None).tgkill(node.process.pid, thread, signal.SIGINT) == 0
    assert node.exit(SOON) == 0, node.story()


BLOCKS = {"receive": "hear", "serve": "serve", "work": "work"}


@pytest.mark.parametrize("where", ["update", "deactivate", "cleanup", *BLOCKS])
def test_stop_of_what_blocks(stage, where):
    """A node that is blocked ends all the same, with 1, and its log names the place."""
    node = stage.active(f"once {where}: block 60", stop_timeout=0.5)
    if where == "receive":
        stage.publish("hear", "block")
    elif where == "serve":
        stage.call()
    elif where == "work":
        goal = stage.goal("work", 5)
    if where not in ("deactivate", "cleanup"):
        wait_for(lambda: _told(node, where), lambda: f"not blocked: {node.story()}")
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    name = BLOCKS.get(where, where)
    assert re.search(rf"Still running when the node stops: .*{name}\b", node.log()), node.story()
    if where == "work":
        assert stage.result(goal)[0] == "aborted"
    node.ended_well = False


def test_stop_where_the_middleware_hangs(stage):
    """As Fast DDS 3.2 may when another participant leaves: the process ends all the same."""
    only_rclcpp(stage, "rclpy destroys a node with the interpreter locked")
    node = stage.active("once leave: block 60")
    node.send_signal()
    assert node.exit(SOON) == 0, node.story()


def _told(node, method):
    """Return whether a method has begun and not ended."""
    events = node.events(method)
    return events and events[-1]["event"] == "begin"


def test_transitions_while_blocked(stage):
    """No second logic runs beside the first; the node can be activated when it has returned."""
    only_ros2(stage)
    node = stage.active("once update: hold", stop_timeout=0.5)
    wait_for(lambda: _told(node, "update"), "not blocked")
    assert stage.transition("deactivate"), node.story()
    assert not node.events("update", "hold"), "it waited for update"
    assert re.search(r"\bupdate\b", node.log()), node.story()
    assert not stage.transition("activate"), node.story()
    assert re.search(r"Cannot activate: .*update.* has not returned\.", node.log()), node.story()
    assert stage.state() == "inactive"
    node.tell()
    node.wait("update", "hold")
    node.wait("deactivate", "end")
    wait_for(lambda: stage.transition("activate"), lambda: f"not activated: {node.story()}")
    count = len(node.events("update"))
    node.wait("update", count=count // 2 + 3)
    node.expect("[ERROR]")


def test_late_update_is_the_last(stage):
    """One that returns just after `stop_timeout` is followed by `deactivate`, not by another."""
    node = stage.active(stop_timeout=0.5)
    node.tell("update: hold")
    node.wait("update", "begin", count=len(node.events("update", "begin")) + 1)
    held = len(node.events("update", "begin"))
    if stage.variant.is_ros2:
        stage.peer.begin("change_state", node=stage.name("probe"), transition="deactivate")
    else:
        node.send_signal()
    node.wait_log("Still running.*update")
    node.tell("deactivate: sleep 0.2")
    node.wait("deactivate", "end")
    assert len(node.events("update", "begin")) == held, node.story()
    node.expect("[ERROR]")
    node.ended_well = False


@pytest.mark.parametrize("second", [signal.SIGINT, signal.SIGTERM])
def test_second_signal_ends_at_once(stage, second):
    node = stage.active("deactivate: block 60", stop_timeout=60.0)
    node.send_signal()
    node.wait("deactivate")
    node.send_signal(second)
    assert node.exit(SOON) != 0
    node.ended_well = False


def test_stop_while_configuring(stage):
    """What has been configured is cleaned up, without being activated before."""
    node = stage.start("probe", "configure: block 1", "activate: throw")
    node.wait("configure")
    assert node.stop() == 0, node.story()
    assert node.methods() == ["configure", "cleanup"], node.story()


@pytest.mark.parametrize("place", ["before creating the node", "constructor"])
def test_stop_before_configure(stage, place):
    """Nothing is configured then, and nothing needs to be cleaned up."""
    only_python(stage, "in C++ no place is before `configure`")
    node = stage.start("probe", f"{place}: block 1")
    node.wait(place)
    assert node.stop() == 0, node.story()
    assert node.methods() == [], node.story()


@pytest.mark.parametrize("where", ["receive", "serve"])
def test_callback_beside_the_stop(stage, where):
    """One that the node has begun to call when it is told to stop ends before `deactivate`."""
    only_python(stage, "it is about a moment within the package")
    place = "after asking for the stop in ros"
    node = stage.active(stop_timeout=10.0)
    node.tell(f"{place}: hold")
    if where == "receive":
        stage.publish("hear", "beside")
    else:
        stage.call()
    node.wait(place)
    node.send_signal()
    end = time.monotonic() + 1.0  # what waits for nothing has ended by then
    while not node.events("deactivate", "end") and time.monotonic() < end:
        time.sleep(0.01)
    node.tell()
    assert node.exit(SOON) == 0, node.story()


def test_random_signals(stage):
    """At any moment of its life, busy, a node ends with 0, in silence and in order."""
    stage.serve()
    stage.serve_action(seconds=0.02)
    for _ in range(SIGNALS):
        node = stage.start("probe", "update: call 1", "update: goal 1", "serve: sleep 0.05")
        node.wait("configure")
        calls = [stage.call(timeout=5.0) for _ in range(3)]
        time.sleep(random.uniform(0.0, 0.8))
        assert node.stop(random.choice((signal.SIGINT, signal.SIGTERM))) == 0, node.story()
        node.check()
        del calls


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_at_its_start(stage, number):
    """A node ends with 0 from the moment on at which it handles signals."""
    stops = []
    for _ in range(SIGNALS):
        node = stage.start("probe")
        wait_for(node.handles_signals, node.story)
        time.sleep(random.uniform(0.0, 0.05))
        stops.append(node.stop(number))
        if not stage.variant.is_ros2:
            node.expect("[ERROR]")  # of roscpp, whose request to the master the signal interrupts
        node.check()
    assert stops == [0] * SIGNALS


def test_signal_while_importing(stage):
    """One SIGINT ends the process, though an import swallows what Python makes of it."""
    only_python(stage, "C++ imports nothing")
    only_ros1(stage, "in ROS 2 the start script is not of the package")
    node = stage.start("probe", "importing: block 1")
    node.wait("importing")
    node.stop()
    assert node.methods() == []
    node.ended_well = False


def test_stop_without_a_master(stage):
    only_ros1(stage, "ROS 2 has no master")
    if stage.variant.is_python:
        pytest.skip("does not apply: rospy waits for its master before there is a node")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        use_master(stage, f"http://127.0.0.1:{free.getsockname()[1]}")
        node = stage.start("probe")
        node.wait_log("Failed to contact master")
        begin = time.monotonic()
        assert node.stop() == 0, node.story()
    assert time.monotonic() - begin < 5.0
    assert node.methods() == []
    node.expect("[ERROR]")


def test_kill_at_its_start(stage):
    """A node that `rosnode kill` finds while it starts ends with 0, in order."""
    only_ros1(stage, "ROS 2 has no rosnode kill")
    nodes = []
    for number in range(SIGNALS):
        name = f"probe{number}"
        nodes.append(stage.start("probe", remap={"__name": name}))
        stage.peer.kill_when_known(node=stage.name(name))
    for node in nodes:
        assert node.exit(SOON) == 0, node.story()
        node.expect("Traceback", "Exception")  # of rospy, whose server is closed at its start
        node.check()


def test_request_to_the_node_that_had_its_port(stage):
    """The master sends it to a node that was killed; the port may be another node's by now."""
    only_ros1(stage, "ROS 2 has no master")
    node = stage.active("")
    stage.peer.request_at_data_port(node=stage.name("probe"), topic="/rosout")
    node.wait("update", count=len(node.events("update")) + 10)
    assert node.stop() == 0, node.story()


def use_master(stage, address):
    """Let the nodes and the peers that a test starts from now on have another master."""
    its = {"ROS_MASTER_URI": address}
    stage.variant = variant = copy.copy(stage.variant)
    variant.environment = variant.environment | its
    return dataclasses.replace(variant.ros, environment=variant.ros.environment | its)


@contextlib.contextmanager
def master_of_its_own(stage):
    """Run a master for the nodes of a test, and give the number of its process."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"http://127.0.0.1:{free.getsockname()[1]}"
    with ros.master(use_master(stage, address), "rosmaster"):
        yield ServerProxy(address).getPid("/test")[2]


@contextlib.contextmanager
def relayed_master(stage):
    """Run a relay between the nodes of a test and their master, which can hold requests back."""
    with ros.Relay(stage.variant.environment["ROS_MASTER_URI"]).running() as relay:
        use_master(stage, relay.address)
        yield relay


@pytest.mark.parametrize("when", ["active", "starting"])
def test_stop_with_a_frozen_master(stage, when):
    """The end waits for a master that does not answer no longer than for the logic."""
    only_ros1(stage, "ROS 2 has no master")
    if when == "starting":
        only_python(stage, "in C++ the thread that connects is that of the logic")
    with master_of_its_own(stage) as master:
        told = ["deactivate: publish STOP", "configure: block 1"]
        node = stage.start("probe", *told, stop_timeout=0.5)
        node.wait("update" if when == "active" else "configure")
        os.kill(master, signal.SIGSTOP)
        node.wait("activate", "end")
        time.sleep(0.5)
        code = node.stop()
    if when == "active":
        assert node.methods() == LIFE, node.story()
        assert code == (0 if stage.variant.is_python else 1), node.story()
        node.ended_well = stage.variant.is_python
    else:
        assert code == 1, node.story()
        assert re.search("Still running.* start", node.log()), node.story()
        assert node.methods() == [name for name in LIFE if name != "update"]
        node.ended_well = False


@pytest.mark.parametrize("parameter", ["log_level", "stop_timeout", "gain"])
def test_stop_while_the_master_is_asked(stage, parameter):
    """One signal ends a node that waits for its parameters, of a master that has frozen."""
    only_ros1(stage, "ROS 2 has no master")
    with relayed_master(stage) as master:
        method = "getParam" if stage.variant.is_python else "hasParam"
        asked = master.hold(method, stage.name(f"probe/{parameter}"))
        node = stage.start("probe")
        asked.wait()
        master.hold()
        code = node.stop(timeout=60.0)
    if stage.variant.is_python:
        assert code == 0, node.story()
    else:  # roscpp does not come back from its request
        assert code == 1, node.story()
        assert "its process is killed" in node.log(), node.story()
        node.ended_well = False
    assert node.methods() == []


def test_call_with_a_frozen_master(stage):
    """It ends in time, answered where the server is known; the node stops as ever."""
    only_ros1(stage, "ROS 2 has no master")
    stage.serve()
    with relayed_master(stage) as master:
        node = stage.active()
        node.tell("once update: call 5")
        assert node.value("update", "call") == "yes", node.story()
        master.hold()
        node.tell("once update: call 4")
        node.wait("update", "call", count=2)
        assert node.events("update", "call")[-1]["value"] == "yes", node.story()
        node.tell("deactivate: publish STOP")
        assert node.stop() == (0 if stage.variant.is_python else 1), node.story()
        assert node.methods() == LIFE, node.story()
        node.ended_well = stage.variant.is_python


def test_calls_while_the_master_does_not_answer(stage):
    """They end in time and leave nothing."""
    only_ros1(stage, "ROS 2 has no master")
    only_python(stage, "a caller of C++ has one thread")
    with relayed_master(stage) as master:
        node = stage.active()
        asked = master.hold("lookupService", stage.name("ask"))
        asked.wait()
        node.tell("once update: call 0.1")
        node.wait("update", "call")
        before = measure(node)
        node.tell(*[f"once update: call 0.1{number}" for number in range(6)])
        wait_for(lambda: len(node.events("update", "call")) == 7, node.story)
        time.sleep(0.5)
        assert_no_growth(before, measure(node), node)
        asked.release()
        assert node.stop() == 0, node.story()


# Exceptions


@pytest.mark.parametrize("where", [*LIFE, "receive", "serve", "work"])
def test_exception(stage, where):
    """It is logged with its place; the node stops in order, cleans up, and ends with 1."""
    node = stage.start("probe", f"{where}: throw", "deactivate: publish STOP")
    if where in ("deactivate", "cleanup"):
        node.wait("update")
        node.send_signal()
    elif where not in LIFE:
        heard = stage.listen(node)
        if where == "receive":
            stage.publish("hear", "throw")
        elif where == "serve":
            stage.call()
        else:
            assert stage.result(stage.goal("work", 5))[0] == "aborted"
    assert node.exit(SOON) == 1, node.story()
    assert "thrown on purpose" in node.log(), node.story()
    place = BLOCKS.get(where, where)
    assert re.search(rf"{place}", node.log()), node.story()
    expected = {"configure": LIFE[:1], "activate": [*LIFE[:2], "cleanup"]}.get(where, LIFE)
    assert node.methods() == expected, node.story()
    if where not in LIFE:
        wait_for(lambda: heard() == ["STOP"], lambda: f"heard {heard()}: {node.story()}")
    node.expect("Traceback", "[ERROR]", "[FATAL]", "Exception")


FAILURES = [*LIFE, "receive", "serve", "work", "thread"]


@pytest.mark.parametrize("where", FAILURES)
def test_failure(stage, where):
    """`passthrough.fail` ends the node as an exception does, from whichever thread."""
    told = "activate: later 1.0 lost" if where == "thread" else f"{where}: fail lost"
    node = stage.start("probe", told, "deactivate: publish STOP")
    if where not in ("configure", "activate"):
        node.wait("update")
    if where in ("deactivate", "cleanup"):
        node.send_signal()
    elif where == "receive":
        stage.publish("hear", "fail")
    elif where == "serve":
        stage.call()
    elif where == "work":
        stage.goal("work", 5)
    assert node.exit(SOON) == 1, node.story()
    assert "The logic failed: lost" in node.log(), node.story()
    assert len(re.findall("The logic failed", node.log())) == 1 or where == "update", node.story()
    skipped = {"configure": LIFE[1:4], "activate": ["update"]}.get(where, [])
    assert node.methods() == [name for name in LIFE if name not in skipped], node.story()
    node.expect("[ERROR]")


@pytest.mark.parametrize("how", ["throw", "fail lost"])
def test_failure_in_a_synchronizer(stage, how):
    """It goes through error processing, as that of any callback."""
    node, _ = joined(stage, "exact", [f"exact: {how}"])
    stage.points(1.0, 1.0, "left", "joiner/right")
    assert node.exit(SOON) == 1, node.story()
    assert re.search("thrown on purpose|The logic failed: lost", node.log()), node.story()
    assert node.methods() == [name for name in LIFE if name != "update"], node.story()
    node.expect("Traceback", "[ERROR]", "[FATAL]", "Exception")


def test_failure_while_inactive(stage):
    """The node cleans up, and ends with 1."""
    only_ros2(stage)
    node = stage.start("probe", "configure: later 0.5 lost", autostart=False)
    assert stage.transition("configure")
    assert node.exit(SOON) == 1, node.story()
    assert node.methods() == ["configure", "cleanup"], node.story()
    node.expect("[ERROR]")


def test_exception_in_the_constructor(stage):
    """No method of the logic is called; the process ends with 1 and says why."""
    node = stage.start("probe", "constructor: throw")
    assert node.exit(SOON) == 1, node.story()
    assert "thrown on purpose" in node.log(), node.story()
    assert node.methods() == [], node.story()
    node.expect("Traceback", "[ERROR]", "[FATAL]", "Exception")


def test_exception_while_connecting(stage):
    """What ROS refuses to subscribe or to serve after `activate` ends the node in order."""
    if stage.variant.is_ros2:
        only_python(stage, "what rclcpp refuses differs")
        setting = f"qos_overrides.{stage.name('number')}.subscription.reliability"
        node = stage.start("probe", **{setting: "best-effort"})
    elif stage.variant.is_python:
        taken = stage.name("probe/get_loggers")
        node = stage.start("probe", remap={stage.name("serve"): taken})
    else:  # a topic of one type, subscribed with another
        node = stage.start("probe", remap={stage.name("hear"): stage.name("number")})
    assert node.exit(SOON) == 1, node.story()
    assert "connect_receivers" in node.log(), node.story()
    assert node.methods() == [name for name in LIFE if name != "update"], node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_result_of_a_wrong_type(stage):
    """It counts as an exception of the callback: the goal is aborted, the node ends with 1."""
    only_python(stage, "C++ has types")
    node = stage.active("work: spoil")
    assert stage.result(stage.goal("work", 5))[0] == "aborted"
    assert node.exit(SOON) == 1, node.story()
    assert "Traceback" in node.log(), node.story()
    assert node.methods() == LIFE, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_service_without_a_response(stage):
    """It counts as an exception of the callback, too; the client is not left without an answer."""
    only_python(stage, "the compiler of C++ sees it")
    node = stage.active("serve: spoil")
    stage.call()
    assert node.exit(SOON) == 1, node.story()
    assert "serve_serve returned no response" in node.log(), node.story()
    assert node.methods() == LIFE, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_arguments_that_ros_refuses(stage):
    """The process ends with 1 and says why."""
    only_ros2(stage, "ROS 1 takes any")
    node = stage.start("probe", remap={"no rule": ""})
    assert node.exit() == 1, node.story()
    assert "no rule" in node.log(), node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_parameter_of_a_wrong_type(stage):
    """It is not rounded: the process ends with 1 and names it."""
    node = stage.start("probe", limit=3.7)
    assert node.exit() == 1, node.story()
    assert "limit" in node.log(), node.story()
    assert node.methods() == []
    node.expect("[ERROR]", "[FATAL]")


def _yaml(value):
    return json.dumps(value).replace("NaN", ".nan").replace("Infinity", ".inf")


def start_dial(stage, **parameters):
    """Start the node dial with parameters of any type, and return it."""
    parameters = {"device": "/dev/dial", **parameters}
    if stage.variant.is_ros2:
        parameters = {n: _yaml(v) for n, v in parameters.items()}
        return stage.start("dial", **parameters)
    for name, value in parameters.items():
        stage.peer.set_global(name=stage.name(f"dial/{name}"), value=value)
    return stage.start("dial")


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("speed", -0.1),
        ("speed", 10.5),
        ("speed", float("nan")),
        ("turns", 0),
        ("turns", True),
        ("mode", "medium"),
        ("mode", 1),
        ("sizes", ["a", "b"]),
        ("sizes", [True]),
        ("sizes", 1.5),
        ("flags", [1]),
    ],
)
def test_fixed_parameter_that_is_refused(stage, name, value):
    """One that is out of its range, none of its choices or of another type ends the node."""
    node = start_dial(stage, **{name: value})
    assert node.exit() == 1, node.story()
    assert re.search(rf"(?m)^.*\[(ERROR|FATAL)\].*\b{name}\b", node.log()), node.story()
    assert node.methods() == [], node.story()
    node.expect("[ERROR]", "[FATAL]")


def test_parameters_within_their_limits(stage):
    """They reach the logic, those at the limits and empty lists too; else their defaults do."""
    default = {
        "speed": 1,
        "axis_linear_x": 4,
        "turns": 2,
        "mode": "slow",
        "sizes": [],
        "flags": [True],
    }
    node = start_dial(stage)
    assert node.wait("configure")["value"] == {"device": "/dev/dial", **default}
    node.wait("activate", "end")
    assert node.stop() == 0
    given = {"speed": 10.0, "turns": 1, "mode": "fast", "sizes": [2.5, math.inf], "flags": []}
    if stage.variant.is_ros2 and not stage.variant.is_python:
        given["flags"] = [False, True]  # rclcpp 29.3 takes no empty list from YAML
    node = start_dial(stage, **given)
    seen = node.wait("configure")["value"]
    assert seen == {"device": "/dev/dial", "axis_linear_x": 4, **given}


def test_parameter_in_a_group(stage, tmp_path):
    """Files have it below its group: `axis_linear: {x: 5}`."""
    if stage.variant.is_ros2:
        file = tmp_path / "dial.yaml"
        file.write_text("/**: {ros__parameters: {device: here, axis_linear: {x: 5}}}")
        node = stage.start("dial", files=[file])
    else:  # as rosparam does
        stage.peer.set_global(name=stage.name("dial/axis_linear"), value={"x": 5})
        node = start_dial(stage)
    assert node.wait("configure")["value"]["axis_linear_x"] == 5
    assert node.stop() == 0
    node = start_dial(
        stage, **{"axis_linear.x" if stage.variant.is_ros2 else "axis_linear/x": "a"}
    )
    assert node.exit() == 1, node.story()
    assert re.search(r"axis_linear[./]x", node.log()), node.story()
    node.expect("[ERROR]", "[FATAL]")


def test_topics_named_by_parameters(stage):
    """Of every kind; relative, absolute and private. The logic knows them by their own names."""
    group = "hear.topic" if stage.variant.is_ros2 else "hear/topic"
    names = {
        "count_topic": stage.name("x/count"),
        "number_topic": "a/number",
        "kept_topic": "~/kept",
    }
    node = stage.active("receive: keep heard", **names, **{group: "ear"})
    counted = stage.hear("x/count", INT64)
    kept = stage.hear("probe/kept", durability="transient_local")
    wait_for(counted, node.story)
    stage.publish("a/number", 7, INT64)
    wait_for(lambda: 7 in numbers(node), node.story)
    stage.publish("ear", "x")
    wait_for(lambda: kept() == ["heard"], node.story)
    assert node.stop() == 0
    if stage.variant.is_ros2:  # another name in the next configuration
        node = stage.start("probe", "receive: keep heard", autostart=False)
        assert stage.transition("configure", "cleanup")
        assert stage.peer.set_parameter(node=stage.name("probe"), name=group, value="ear")
        assert stage.transition("configure", "activate")
        stage.publish("ear", "x")
        node.wait("receive")


@pytest.mark.parametrize("name", ["a b", "1a"])
def test_parameter_that_names_no_topic(stage, name):
    """The node refuses to configure, and says why."""
    node = stage.start("probe", kept_topic=name)
    assert node.exit() == 1, node.story()
    line = rf"Parameter kept_topic must be the name of a topic, not '{name}'\."
    assert re.search(line, node.log()), node.story()
    assert node.methods() == []
    node.expect("[ERROR]", "[FATAL]")


def router(stage, *told, **topics):
    """Start router with lists of topics, and wait until it is active."""
    group = "take.topics" if stage.variant.is_ros2 else "take/topics"
    node = with_lists(
        stage, "router", *told, **{group: topics.get("take"), "give_topics": topics.get("give")}
    )
    node.wait("activate", "end")
    return node


def with_lists(stage, node, *told, **given):
    """Start a node with parameters that are lists, of which roscpp takes none as arguments."""
    given = {name: value for name, value in given.items() if value is not None}
    if not stage.variant.is_ros2:
        for name, value in given.items():
            stage.peer.set_global(name=stage.name(f"{node}/{name}"), value=value)
        return stage.start(node, *told)
    return stage.start(node, *told, **{name: json.dumps(value) for name, value in given.items()})


def taken(node):
    return [tuple(event["value"]) for event in node.events("take", "begin")]


def test_topics_of_a_list(stage):
    """Relative, absolute and private; the logic knows each by the text in the list."""
    topics = ["a/take", stage.name("b/take"), "~/take"]
    names = ["a/take", "b/take", "router/take"]
    node = router(
        stage, "take: topics", "take: give ~/given heard", take=topics, give=["a/given", "~/given"]
    )
    given = stage.hear("router/given", durability="transient_local")
    for name in names:
        stage.publish(name, f"to {name}")
        wait_for(lambda name=name: f"to {name}" in [text for _, text in taken(node)], node.story)
    assert taken(node) == [
        (topic, f"to {name}") for topic, name in zip(topics, names, strict=True)
    ]
    wait_for(lambda: given() == ["heard"] * 3, node.story)
    assert node.wait("take", "topics")["value"] == ["a/given", "~/given"]
    assert stage.hear("a/given", durability="transient_local")() == []
    threads = {(event["thread"], event["id"]) for event in node.events("take")}
    assert {name for name, _ in threads} == {"take"}
    is_rospy = stage.variant.is_python and not stage.variant.is_ros2
    assert len(threads) == (3 if is_rospy else 1)  # one for each connection


def test_list_without_topics(stage):
    """It is a list as any other: the node has none of these topics."""
    node = router(stage, "deactivate: topics")
    assert node.stop() == 0
    assert node.wait("deactivate", "topics")["value"] == []


def test_topics_of_a_list_read_anew(stage):
    """The next configuration reads the list as it then is; while configured it does not change."""
    only_ros2(stage)
    node = router(stage)
    stage.publish("left/take", "one")
    node.wait("take")
    change = {"node": stage.name("router"), "name": "take.topics", "value": ["other"]}
    assert not stage.peer.set_parameter(**change)
    assert stage.transition("deactivate", "cleanup", node="router")
    assert stage.peer.set_parameter(**change)
    assert stage.transition("configure", "activate", node="router")
    stage.publish("other", "two")
    wait_for(lambda: ("other", "two") in taken(node), node.story)


def test_callback_of_a_list_that_blocks(stage):
    """It delays the other topics of its list, whose messages wait; a stop names it."""
    node = router(stage, "once take: hold first")
    stage.publish("left/take", "first")
    node.wait("take")
    for topic in ("left", "right", "right"):
        stage.publish(f"{topic}/take", f"{topic} waits")
    node.tell("once take: block 60")
    waiting = [("left/take", "left waits")] + [("right/take", "right waits")] * 2
    wait_for(lambda: len(taken(node)) > 1, node.story)
    assert taken(node)[1] in waiting
    node.tell("")
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert re.search(r"Still running when the node stops: .*\btake\b", node.log()), node.story()
    node.ended_well = False


@pytest.mark.parametrize("kind", ["take", "give"])
@pytest.mark.parametrize(
    ("wrong", "what"), [("a b", "'a b'"), ("", "''"), ("left", "'left' twice")]
)
def test_list_that_names_no_topics(stage, kind, wrong, what):
    """The node refuses to configure, and says why."""
    name = {
        "take": "take.topics" if stage.variant.is_ros2 else "take/topics",
        "give": "give_topics",
    }
    node = with_lists(stage, "router", **{name[kind]: ["left", wrong]})
    assert node.exit() == 1, node.story()
    line = f"Parameter {name[kind]} must have names of topics, each once, not {what}."
    assert line in node.log(), node.story()
    assert node.methods() == []
    node.expect("[ERROR]", "[FATAL]")


def test_parameter_without_a_default(stage):
    """Unless it is set, the node refuses to configure, and names it."""
    node = stage.start("dial")
    assert node.exit() == 1, node.story()
    assert re.search(r"Parameter \S*device must be set", node.log()), node.story()
    assert node.methods() == []
    node.expect("[ERROR]", "[FATAL]")
    if stage.variant.is_ros2:
        node = stage.start("dial", autostart=False)
        assert not stage.transition("configure", node="dial")
        assert stage.state("dial") == "unconfigured"
        assert not stage.peer.set_parameter(node=stage.name("dial"), name="mode", value="other")
        assert stage.peer.set_parameter(node=stage.name("dial"), name="mode", value="fast")
        assert stage.peer.set_parameter(node=stage.name("dial"), name="device", value="here")
        assert stage.transition("configure", node="dial")
        seen = node.wait("configure")["value"]
        assert (seen["device"], seen["mode"]) == ("here", "fast")
        assert not stage.peer.set_parameter(node=stage.name("dial"), name="device", value="there")
        node.expect("[ERROR]", "[FATAL]")


@pytest.mark.parametrize("value", ["-1", ".nan", ".inf"])
def test_stop_timeout_out_of_range(stage, value):
    """The process ends with 1 and names it."""
    node = stage.start("probe", stop_timeout=value)
    assert node.exit() == 1, node.story()
    assert "stop_timeout" in node.log(), node.story()
    assert node.methods() == []
    node.expect("[ERROR]", "[FATAL]")


def test_frequency_when_starting(stage):
    """The default is that of the spec; it does not change later."""
    for given, frequency in (({}, 10.0), ({"frequency": 40.0}, 40.0)):
        node = stage.start("gauge", **given)
        node.wait("update", count=12)
        times = [event["time"] for event in node.events("update", "begin")]
        period = statistics.median(end - start for start, end in itertools.pairwise(times))
        assert 0.8 < period * frequency < 1.25, (frequency, period)
        if stage.variant.is_ros2:
            name = stage.name("gauge")
            assert not stage.peer.set_parameter(node=name, name="frequency", value=20.0)
        assert node.stop() == 0


@pytest.mark.parametrize("value", ["0.0", "-1.0", "2e5", ".nan", ".inf"])
def test_frequency_out_of_range(stage, value):
    """The process ends with 1 and names it."""
    node = stage.start("gauge", frequency=value)
    assert node.exit() == 1, node.story()
    assert "frequency" in node.log(), node.story()
    assert node.methods() == []
    node.expect("[ERROR]", "[FATAL]")


def test_unknown_log_level(stage):
    only_ros1(stage, "in ROS 2 a log level is an argument")
    node = stage.active(log_level="loud")
    node.wait_log("log_level must be debug, info, warn, error or fatal")


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf"), 101.0])
def test_parameter_that_is_out_of_range(stage, value):
    """It is refused, when the node is started with it and later on."""
    only_ros2(stage, "in ROS 1 dynamic_reconfigure brings it into the range")
    node = stage.start("gauge")
    node.wait("update")
    assert not stage.peer.set_parameter(node=stage.name("gauge"), name="gain", value=value)
    assert node.stop() == 0
    node = stage.start("gauge", gain=str(value).replace("nan", ".nan").replace("inf", ".inf"))
    assert node.exit() == 1, node.story()
    assert "gain" in node.log(), node.story()
    node.expect("[ERROR]", "[FATAL]")


def test_dynamic_parameter_that_is_no_number(stage):
    """dynamic_reconfigure does not clamp it: in place of one in a range comes the default."""
    only_ros1(stage, "ROS 2 refuses it")
    stage.peer.set_global(name=stage.name("gauge/gain"), value=math.nan)
    node = stage.start("gauge")
    assert node.wait("update")["value"]["gain"] == 1.0
    assert stage.peer.set_parameter(node=stage.name("gauge"), name="gain", value=2.0)
    assert not stage.peer.set_parameter(node=stage.name("gauge"), name="gain", value=math.nan)
    node.wait("update", count=len(node.events("update", "begin")) + 3)
    assert node.events("update", "begin")[-1]["value"]["gain"] == 1.0


def test_parameter_of_an_unknown_type(stage):
    """What rclpy cannot read does not end the node."""
    only_ros2(stage, "ROS 1 takes any")
    only_python(stage, "rclcpp ends the process")
    node = stage.active()
    stage.peer.set_unknown_parameter(node=stage.name("probe"), name="gain")
    count = len(node.events("update", "begin"))
    node.wait("update", count=count + 5)
    node.expect("Traceback", "[ERROR]", "Exception")


def test_exception_by_transition(stage):
    """The transition fails, and a node alone in its process ends with 1 then, too."""
    only_ros2(stage)
    node = stage.start("probe", "configure: throw", autostart=False)
    assert not stage.transition("configure")
    assert node.exit(SOON) == 1, node.story()
    assert node.methods() == LIFE[:1]
    node.expect("Traceback", "[ERROR]", "[FATAL]", "Exception")


@pytest.mark.parametrize("where", ["serve", "update"])
def test_exception_while_stopping(stage, where):
    """One that comes as the stop ends a wait counts as any other."""
    node = stage.active(f"{where}: sleep 60", f"{where}: throw")
    if where == "serve":
        stage.call()
    node.wait(where)
    if stage.variant.is_ros2:
        assert not stage.transition("deactivate")
    else:
        node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert node.methods() == LIFE, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_exception_while_shutting_down(stage):
    """The shutdown transition fails and goes through error processing, too."""
    only_ros2(stage)
    node = stage.active("deactivate: throw")
    assert not stage.transition("shutdown")
    assert node.exit(SOON) == 1, node.story()
    assert node.methods() == LIFE, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_exception_with_a_frozen_master(stage):
    """The node ends, though roscpp and rospy ask the master for a parameter before they log."""
    only_ros1(stage, "ROS 2 has no master")
    with master_of_its_own(stage) as master:
        node = stage.active()
        os.kill(master, signal.SIGSTOP)
        node.tell("update: throw")
        assert node.exit(60.0) == 1, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")
    node.ended_well = False


# Threads and timers

WITHOUT_UPDATE = [name for name in LIFE if name != "update"]


def test_thread_and_timer(stage):
    """Between `activate` and `deactivate`; a thread on and on, a timer at its rate; both alone."""
    node = stage.start("clerk", "serve: block 0.5")
    stage.call("greet")
    node.wait("read", count=10)
    node.wait("poll", count=11)
    threads = {name: node.wait(name) for name in ("read", "poll")}
    assert all(event["thread"] == name for name, event in threads.items()), threads
    times = [event["time"] for event in node.events("poll", "begin")]
    periods = [end - begin for begin, end in itertools.pairwise(times)]
    assert 0.17 < statistics.median(periods) < 0.23, periods
    assert node.stop() == 0
    assert node.methods() == WITHOUT_UPDATE
    called = [event["method"] for event in node.events(event="begin")]
    assert called.index("activate") < called.index("read"), node.story()
    assert {"read", "poll"}.isdisjoint(called[called.index("deactivate") :]), node.story()


@pytest.mark.parametrize("how", ["throw", "fail lost"])
@pytest.mark.parametrize("where", ["read", "poll"])
def test_failure_of_a_thread(stage, where, how):
    """It goes the way of an exception; diagnostics say why, and never OK after it."""
    stage.peer.hear(topic="/diagnostics", kind="diagnostic_msgs/msg/DiagnosticArray")
    node = stage.start("clerk")
    wait_for(lambda: statuses(stage, "clerk"), node.story)
    node.tell(f"{where}: {how}")
    assert node.exit(SOON) == 1, node.story()
    word = how.replace("throw", "thrown on purpose").split()[-1]
    assert word in node.log(), node.story()
    assert node.methods() == WITHOUT_UPDATE, node.story()
    wait_for(lambda: statuses(stage, "clerk")[-1][0] == 2, lambda: statuses(stage, "clerk"))
    assert word in statuses(stage, "clerk")[-1][1]
    node.expect("Traceback", "[ERROR]", "Exception")


@pytest.mark.parametrize("where", ["read", "poll"])
def test_stop_ends_wait_of_a_thread(stage, where):
    node = stage.start("clerk", f"{where}: sleep 60")
    node.wait(where)
    assert node.stop(timeout=SOON) == 0, node.story()
    assert node.value(where, "sleep") is False


@pytest.mark.parametrize("where", ["read", "poll"])
def test_turn_that_a_stop_ends_is_the_last(stage, where):
    """In many rounds, as it depends on what the stop and the thread do first."""
    for _ in range(10):
        node = stage.start("clerk", f"{where}: sleep 60")
        node.wait(where)
        assert node.stop(timeout=SOON) == 0, node.story()
        assert len(node.events(where, "begin")) == 1, node.story()


@pytest.mark.parametrize("where", ["read", "poll"])
def test_stop_of_a_thread_that_blocks(stage, where):
    """The node ends with 1, and its log names the method."""
    node = stage.start("clerk", f"{where}: block 60", stop_timeout=0.5)
    wait_for(lambda: _told(node, where), lambda: f"not blocked: {node.story()}")
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert re.search(rf"Still running when the node stops: .*{where}\b", node.log()), node.story()
    assert node.methods() == WITHOUT_UPDATE, node.story()
    node.ended_well = False


@pytest.mark.parametrize("where", ["read", "poll"])
def test_late_turn_of_a_thread_is_the_last(stage, where):
    """One that returns while `deactivate` runs is followed by none; the node may start again."""
    only_ros2(stage)
    node = stage.start("clerk", stop_timeout=0.5)
    node.wait("poll")
    node.tell(f"{where}: hold", "deactivate: sleep 1")
    wait_for(lambda: _told(node, where), lambda: f"not blocked: {node.story()}")
    turns = len(node.events(where, "begin"))
    change = stage.peer.begin("change_state", node=stage.name("clerk"), transition="deactivate")
    node.wait("deactivate")
    node.tell("deactivate: sleep 1")
    assert change.result(30), node.story()
    assert len(node.events(where, "begin")) == turns, node.story()
    wait_for(lambda: stage.transition("activate", node="clerk"), node.story)
    node.wait(where, count=turns + 3)
    node.expect("[ERROR]")
    node.ended_well = False


def test_timer_that_takes_too_long(stage):
    node = stage.start("clerk", "once poll: block 1")
    line = node.wait_log("missed")
    assert re.search(r"Missed \d cycles of 5 Hz: poll takes too long\.", line), line


def test_timer_in_simulated_time(stage, simulated):
    """It waits for the first /clock, and goes with it; a thread does not."""
    node = start_simulated(stage, name="clerk")
    node.wait("read", count=1)
    time.sleep(0.5)
    assert not node.events("poll"), node.story()

    def has_polled(step):
        simulated(10.0 + 0.21 * step)  # a little more than a period; the first may find no node
        return len(node.events("poll", "begin")) > step

    for step in range(10):
        wait_for(lambda: has_polled(step), node.story)  # noqa: B023
    time.sleep(0.5)
    assert len(node.events("poll", "begin")) <= 12, node.story()


# Topics that are late


def reaches(stage, node, topic, kind, method):
    """Publish to a topic until the logic of guard has it; return when it began to."""
    count = len(node.events(method, "begin"))

    def is_there():
        stage.publish(topic, {INT64: 7}.get(kind, "on"), kind)
        return len(node.events(method, "begin")) > count

    wait_for(is_there, node.story)
    return node.events(method, "begin")[count]["time"]


def test_late_topics(stage):
    """Once when no message has come for so long, again after the next; each in its own thread."""
    node = stage.start("guard", "once late_order: block 2")
    begin = node.wait("activate", "end")["time"]
    for late in LATES:
        event = node.wait(late)
        assert event["thread"] == late
        assert event["time"] - begin > 0.39, node.story()
    time.sleep(1.5)
    assert [len(node.events(late, "begin")) for late in LATES] == [1, 1], node.story()
    heard = reaches(stage, node, "speed", INT64, "update")
    assert node.wait("late_speed", count=2)["time"] - heard > 0.35, node.story()
    assert len(node.events("late_order", "begin")) == 1, node.story()
    heard = reaches(stage, node, "orders", STRING, "order")
    assert node.wait("late_order", count=2)["time"] - heard > 0.39, node.story()
    assert node.stop() == 0


def test_topic_is_not_late_while_it_is_heard(stage):
    """As long as the logic is at work with a message, the node takes no other."""
    node = stage.start("guard", "once order: block 1.5")
    node.wait("late_order")
    reaches(stage, node, "orders", STRING, "order")
    late = node.wait("late_order", count=2)
    assert late["time"] - node.wait("order", "end")["time"] > 0.39, node.story()


def test_late_topic_while_inactive(stage):
    """Nothing is late then; an activation counts anew."""
    only_ros2(stage)
    node = stage.start("guard")
    node.wait("late_speed")
    assert stage.transition("deactivate", node="guard")
    time.sleep(1.0)
    assert len(node.events("late_speed", "begin")) == 1, node.story()
    assert stage.transition("activate", node="guard")
    begin = node.wait("activate", "end", count=2)["time"]
    assert node.wait("late_speed", count=2)["time"] - begin > 0.39, node.story()


def test_late_topic_in_simulated_time(stage, simulated):
    """It waits for the first /clock, goes with it, and stands still with it."""
    node = start_simulated(stage, name="guard")
    node.wait("activate", "end")
    time.sleep(1.0)
    now, lates = 10.0, lambda: len(node.events("late_speed", "begin"))

    def becomes_late(count):
        nonlocal now
        now += 0.01
        simulated(now)
        time.sleep(0.01)
        return lates() > count

    assert lates() == 0, node.story()
    wait_for(lambda: becomes_late(0), node.story)
    assert now > 10.39
    time.sleep(1.0)
    assert lates() == 1, node.story()
    for start in (now, 5.0):  # the clock is set back

        def is_heard():
            simulated(start)  # noqa: B023
            stage.publish("speed", 7, INT64)
            simulated(start + 0.05)  # noqa: B023
            return len(node.events("update", "begin")) > heard  # noqa: B023

        count, heard = lates(), len(node.events("update", "begin"))
        wait_for(is_heard, node.story)
        time.sleep(0.6)
        assert lates() == count, node.story()
        now = start + 0.05
        wait_for(lambda: becomes_late(count), node.story)  # noqa: B023
        assert now - start > 0.39


@pytest.mark.parametrize("how", ["throw", "fail lost"])
def test_failure_where_a_topic_is_late(stage, how):
    node = stage.start("guard", f"late_speed: {how}")
    assert node.exit(SOON) == 1, node.story()
    assert how.replace("throw", "thrown on purpose").split()[-1] in node.log(), node.story()
    assert node.methods() == WITHOUT_UPDATE, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


@pytest.mark.parametrize("late", LATES)
def test_stop_where_a_topic_is_late(stage, late):
    """It ends waits; of what blocks the log has the name, and the node ends with 1."""
    node = stage.start("guard", f"{late}: sleep 60")
    node.wait(late)
    assert node.stop(timeout=SOON) == 0, node.story()
    assert node.value(late, "sleep") is False
    node = stage.start("guard", f"{late}: block 60", stop_timeout=0.5)
    wait_for(lambda: _told(node, late), lambda: f"not blocked: {node.story()}")
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert re.search(rf"Still running when the node stops: .*{late}\b", node.log()), node.story()
    node.ended_well = False


def test_diagnostics_of_late_topics(stage):
    """A warning that names the topic and says for how long, until a message comes."""
    node = reporting(stage, name="guard")

    def last():
        return statuses(stage, "guard")[-1]

    late = r"no message on speed for \d+\.\d s; no message on orders for \d+\.\d s"
    wait_for(lambda: last()[0] == 1 and re.search(late, last()[1]), last)

    def is_heard():
        stage.publish("speed", 7, INT64)
        stage.publish("orders", "on")
        return (last()[0], last()[1]) == (0, "active") or last()[1] == "late cycles"

    wait_for(is_heard, last)
    wait_for(lambda: re.search(late, last()[1]), last)
    assert node.stop() == 0


# Refusals


@pytest.mark.parametrize("where", ["configure", "activate"])
def test_refusal(stage, where):
    """A node alone that refuses ends with 1, and says that it refused."""
    node = stage.start("probe", f"{where}: refuse")
    assert node.exit() == 1, node.story()
    expected = {"configure": LIFE[:1], "activate": [*LIFE[:2], "cleanup"]}[where]
    assert node.methods() == expected
    assert f"The logic refused to {where}." in node.log(), node.story()
    node.expect("[ERROR]", "[FATAL]")


@pytest.mark.parametrize("where", ["configure", "activate"])
def test_refusal_when_the_node_stops(stage, where):
    """A method that gives up since the node stops has refused nothing."""
    node = stage.start("probe", f"{where}: sleep 60", f"{where}: refuse")
    node.wait(where)
    assert node.stop() == 0, node.story()
    expected = {"configure": LIFE[:1], "activate": [*LIFE[:2], "cleanup"]}[where]
    assert node.methods() == expected, node.story()
    assert "refused" not in node.log(), node.story()


def test_refusal_by_transition(stage):
    """It may be configured again with other parameters, and activated once it accepts."""
    only_ros2(stage)
    node = stage.start("probe", autostart=False, accept=False)
    assert not stage.transition("configure")
    assert stage.state() == "unconfigured"
    assert stage.peer.set_parameter(node=stage.name("probe"), name="accept", value=True)
    node.tell("activate: refuse")
    assert stage.transition("configure"), node.story()
    assert not stage.transition("activate")
    assert stage.state() == "inactive"
    node.tell()
    assert stage.transition("activate"), node.story()
    node.wait("update")
    assert not stage.peer.set_parameter(node=stage.name("probe"), name="accept", value=False)
    assert stage.peer.set_parameter(node=stage.name("probe"), name="gain", value=2.0)
    wait_for(lambda: node.events("update", "begin")[-1]["value"]["gain"] == 2.0, "no new gain")
    node.expect("[ERROR]", "[FATAL]")


@pytest.mark.parametrize("distro", ["of this ROS", "humble"])
def test_parameters_set_with_a_refused_one(stage, request, distro):
    """All remain as they were, in what `update` sees as well."""
    only_ros2(stage, "ROS 1 refuses no parameter")
    if distro == "humble":
        only_python(stage, "rclcpp is the same in all of them")
        stage.variant = request.getfixturevalue("humble")
    node = stage.active()
    values = {"gain": 2.0, "accept": False}
    assert not stage.peer.set_parameters_atomically(node=stage.name("probe"), values=values)
    node.wait("update", count=len(node.events("update", "begin")) + 3)
    assert node.events("update", "begin")[-1]["value"]["gain"] == 1.0
    del values["accept"]
    assert stage.peer.set_parameters_atomically(node=stage.name("probe"), values=values)
    wait_for(lambda: node.events("update", "begin")[-1]["value"]["gain"] == 2.0, "no new gain")


def test_parameter_set_while_configuring(stage):
    """A dynamic parameter set while the node configures itself holds from the first update.

    The node has no topics: their QoS overrides, declared later, would have parameters read anew.
    """
    node = stage.start("gauge", "configure: hold", "life_cycle reads gain: hold")
    wait_for(lambda: node.events(event="begin"), "not configuring")
    assert stage.peer.set_parameter(node=stage.name("gauge"), name="gain", value=2.0)
    node.tell()
    assert node.wait("update")["value"]["gain"] == 2.0


def set_pace(stage, value):
    return stage.peer.set_parameter(node=stage.name("clerk"), name="pace", value=value)


def test_logic_gets_changed_parameters(stage):
    """Before they are so, and as it likes them; it may refuse them."""
    node = stage.start("clerk")
    node.wait("activate", "end")
    assert set_pace(stage, 2.0)
    node.tell("reconfigure: refuse")
    assert not set_pace(stage, 3.0)
    node.tell()
    assert set_pace(stage, 4.0)
    if stage.variant.is_ros2:
        stage.peer.set_parameter(node=stage.name("clerk"), name="stop_timeout", value=3.0)
    seen = [event["value"] for event in node.events("reconfigure", "begin")]
    assert seen == [2.0, 3.0, 4.0]
    assert node.stop() == 0


def test_no_reconfigure_without_a_configured_logic(stage):
    only_ros2(stage)
    node = stage.start("clerk", autostart=False)
    assert set_pace(stage, 2.0)
    assert stage.transition("configure", "activate", "deactivate", node="clerk")
    assert set_pace(stage, 3.0)
    assert stage.transition("cleanup", node="clerk")
    assert set_pace(stage, 4.0)
    assert [event["value"] for event in node.events("reconfigure", "begin")] == [3.0]
    assert node.stop() == 0


def test_exception_in_reconfigure(stage):
    """The change is refused, and the node ends as after any other exception."""
    node = stage.start("clerk", "reconfigure: throw")
    node.wait("activate", "end")
    with contextlib.suppress(Exception):  # the node may end before it answers
        assert not set_pace(stage, 2.0)
    assert node.exit() == 1, node.story()
    assert node.methods()[-2:] == ["deactivate", "cleanup"]
    node.expect("[ERROR]", "[FATAL]", "Traceback", "Exception")


def test_reconfigure_that_does_not_return(stage):
    """The change is refused in time, but by roscpp, and the node ends."""
    node = stage.start("clerk", "reconfigure: block 60", stop_timeout=0.5)
    node.wait("activate", "end")
    if stage.variant.is_ros2:
        assert not set_pace(stage, 2.0)
    else:
        name = stage.name("clerk")
        stage.peer.set_parameter(node=name, name="pace", value=2.0, waits=False)
        node.wait("reconfigure")
    assert node.stop() == 1
    node.expect("[ERROR]", "[FATAL]", "reconfigure")


def test_refusals_in_a_row(stage):
    """What a refused configuration leaves to clean up blocks nothing, however often.

    Each one hears of a static transform at once, in a thread that may still use it afterwards.
    """
    only_ros2(stage)
    if stage.variant.has_tf:
        stage.peer.transform(parent="map", child="robot", x=7.0)
    node = stage.start("probe", autostart=False, accept=False)
    for _ in range(ROUNDS):
        assert not stage.transition("configure")
    assert stage.state() == "unconfigured"
    node.expect("[ERROR]", "[FATAL]")


# Messages


def numbers(node):
    """Return the numbers that were new in a cycle."""
    seen = [event["value"]["number"] for event in node.events("update", "begin")]
    return [number for number in seen if number is not None]


def test_message_is_new_once(stage):
    node = stage.active()
    stage.publish("number", 7, INT64)
    wait_for(lambda: numbers(node), "no number")
    count = len(node.events("update", "begin"))
    node.wait("update", count=count + 5)
    assert numbers(node) == [7]


def test_subscribers_are_counted(stage):
    """Those of an output and of a directPublisher, as they come and go."""
    node = stage.active("update: listeners")
    node.wait("update", "listeners")

    def counts(*expected):
        def seen():
            return node.events("update", "listeners")[-1]["value"]

        wait_for(lambda: seen() == [*expected], lambda: f"{seen()}, not {expected}")

    counts(0, 0)
    stage.hear("count", INT64)
    counts(1, 0)
    stage.hear("say")
    counts(1, 1)
    # rospy notices that a subscriber has gone when it publishes.
    node.tell("update: listeners", "update: publish word")
    stage.peer.deafen(topic=stage.name("say"))
    counts(1, 0)
    stage.peer.deafen(topic=stage.name("count"))
    counts(0, 0)


def test_log_once_and_seldom(stage):
    node = stage.active("update: note")
    begin = time.monotonic()
    node.wait("update", "note", count=80)
    node.tell()
    cycles = len(node.events("update", "note"))
    seconds = time.monotonic() - begin
    assert node.stop() == 0
    assert node.log().count("noted each time") >= cycles
    assert node.log().count("noted once") == 2  # at two levels
    assert 2 <= node.log().count("noted seldom") <= seconds + 2


def test_loop_allocates_nothing(stage):
    """Neither to wait nor to take messages of fixed size; the middleware allocates to publish."""
    if stage.variant.is_python:
        pytest.skip("does not apply: Python allocates")
    node = stage.active("once update: mute")
    node.wait("update", "mute")
    muted = len(node.events("update", "begin")) + 1
    for number in range(5):
        stage.publish("number", number, INT64)
        wait_for(lambda number=number: number in numbers(node), "no number")
    node.wait("update", count=muted + 20)
    cycles = [event["value"]["allocations"] for event in node.events("update", "begin")]
    assert any(cycles[:muted]), "nothing is counted"
    warnings = node.log().count("Missed ")  # of a busy machine, which allocate
    assert sum(map(bool, cycles[muted:])) <= warnings, cycles


def test_nothing_old_is_new(stage):
    """What came before an activation is not new after it: neither while inactive, nor before."""
    only_ros2(stage, "a node of ROS 1 is activated once, at its start")
    node = stage.active(stop_timeout=10.0)
    stage.publish("number", 1, INT64)
    wait_for(lambda: 1 in numbers(node), "no number")
    node.tell("once update: block 4")
    wait_for(lambda: _told(node, "update"), "not blocked")
    time.sleep(0.1)
    stage.publish("number", 2, INT64)  # comes in, and no cycle takes it
    assert stage.transition("deactivate")
    stage.publish("number", 3, INT64, wait=False)
    assert stage.transition("activate")
    count = len(node.events("update", "begin"))
    node.wait("update", count=count + 5)
    stage.publish("number", 4, INT64)
    wait_for(lambda: 4 in numbers(node), lambda: f"{numbers(node)}: {node.story()}")
    assert numbers(node) == [1, 4]
    stage.publish("number", 5, INT64)
    wait_for(lambda: 5 in numbers(node), "no number")
    assert stage.transition("deactivate", "cleanup", "configure", "activate")
    count = len(node.events("update", "begin"))
    node.wait("update", count=count + 5)
    assert numbers(node) == [1, 4, 5]


def test_silence_while_inactive(stage):
    """The outputs of update are published while the node is active, and not else."""
    only_ros2(stage)
    node = stage.active()
    heard = stage.hear("count", INT64)
    wait_for(heard, "no output")
    assert stage.transition("deactivate")
    time.sleep(0.2)
    count = len(heard())
    time.sleep(0.3)
    assert len(heard()) == count
    assert stage.transition("activate")
    wait_for(lambda: len(heard()) > count + 2, node.story)


EXACT = ("left", "joiner/right")
NEAR = ("left", "other", "elsewhere")


def meet(stage, node, found, topics):
    """Publish until all topics are heard; return the stamps of then and later, in s."""
    stamps = itertools.count(1.0)
    wait_for(lambda: stage.points(next(stamps), 0.0, *topics) or found(), node.story)
    return stamps


def test_exact_synchronizer(stage):
    """It gives messages of equal stamps, in whichever order they come, and each once."""
    node, found = joined(stage, "exact")
    start = next(meet(stage, node, found, EXACT))
    left, right = EXACT
    stage.points(start, 1.0, *EXACT)
    stage.points(start + 1.0, 2.0, left)
    stage.points(start + 1.01, 3.0, right)
    stage.points(start + 2.0, 4.0, right)
    stage.points(start + 2.0, 5.0, left)
    wait_for(lambda: [5.0, 4.0] in found(), node.story)
    assert [each for each in found() if any(each)] == [[1.0, 1.0], [5.0, 4.0]]
    assert node.wait("exact")["thread"] == "exact"
    begins = itertools.count(6, 7)

    def oldest_go():
        """Send more than wait, where the node is not so busy that it takes both topics in turn."""
        begin = next(begins)
        numbers = [float(number) for number in range(begin, begin + 7)]
        for topic in EXACT:
            for number in numbers:
                stage.points(start + number, number, topic)
        wait_for(lambda: [numbers[-1]] * 2 in found(), node.story)
        given = [first for first, _ in found() if first >= begin]
        assert len(given) >= 5
        assert given == numbers[-len(given) :]
        return len(given) == 5

    wait_for(oldest_go, node.story)


def test_approximate_synchronizer(stage):
    """It gives messages whose stamps are near each other, as soon as none can be nearer."""
    node, found = joined(stage, "near", third_topic="elsewhere")
    start = next(meet(stage, node, found, NEAR))
    for value, topic in enumerate(NEAR, 1):
        stage.points(start + 0.05 * value, float(value), topic)
    stage.points(start + 10.0, 4.0, *NEAR[:2])
    stage.points(start + 10.5, 5.0, NEAR[2])
    stage.points(start + 20.0, 6.0, *NEAR)
    wait_for(lambda: [6.0] * 3 in found(), node.story)
    assert [each for each in found() if any(each)] == [[1.0, 2.0, 3.0], [6.0] * 3]
    assert node.wait("near")["thread"] == "near"


def test_synchronizer_while_inactive(stage):
    """What came before an activation is joined with nothing after it."""
    only_ros2(stage)
    node, found = joined(stage, "exact")
    stamps = meet(stage, node, found, EXACT)
    left, right = EXACT
    stage.points(1e6, 1.0, left)
    stage.points(next(stamps), 2.0, *EXACT)
    wait_for(lambda: [2.0, 2.0] in found(), node.story)  # so the first one has come, too
    assert stage.transition("deactivate", node="joiner")
    stage.points(next(stamps), 3.0, *EXACT, wait=False)
    assert stage.transition("activate", node="joiner")
    wait_for(lambda: stage.points(next(stamps), 4.0, *EXACT) or [4.0, 4.0] in found(), node.story)
    stage.points(1e6, 5.0, right)
    stage.points(1e6 + 1.0, 6.0, *EXACT)
    wait_for(lambda: [6.0, 6.0] in found(), node.story)
    assert not {(1.0, 5.0), (3.0, 3.0)} & {tuple(each) for each in found()}, node.story()


def test_synchronizer_that_blocks(stage):
    """It delays no other, and the log names it when the node stops."""
    node, found = joined(
        stage, "near", ["once exact: block 60"], stop_timeout=0.5, third_topic="elsewhere"
    )
    exact = itertools.count(1.0)
    wait_for(lambda: stage.points(next(exact), 0.0, *EXACT) or node.events("exact"), node.story)
    meet(stage, node, found, NEAR)
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert re.search(r"Still running when the node stops: .*exact\b", node.log()), node.story()
    node.ended_well = False


# Actions


def test_cancel_before_acceptance(stage):
    """A cancel straight after the goal is kept and sent with the answer."""
    served = stage.serve_action(seconds=30.0, answer_after=0.5)
    lines = ["send 200", "cancel", "wait pending", "wait active"]
    node = stage.start("probe", *[f"once update: {line}" for line in lines])
    wait_for(lambda: len(node.events("update", "wait")) == 2, node.story)
    assert node.events("update", "wait")[-1]["value"] == "canceled", node.story()
    assert ("canceled", 200) in served() or not served()


def test_cancel_beside_the_end_of_the_goal(stage):
    """A goal that ends while it is being cancelled has ended."""
    only_python(stage, "it is about a moment within the package")
    stage.serve_action(seconds=60.0)
    node = stage.start("probe", "once update: send 7", "once update: wait pending")
    assert node.value("update", "wait") == "active", node.story()
    node.tell(
        "once update: cancel",
        "once after looking at the goal in logic: hold it",
        "once after the end of the goal: block 0",
    )
    node.wait("after looking at the goal in logic")
    stage.peer.leave(namespace=stage.namespace)
    node.wait("after the end of the goal")
    node.tell()
    node.wait("update", "cancel")
    assert node.stop() == 0, node.story()


@pytest.mark.parametrize("way", ["sigint", "transitions"])
def test_own_goals_are_cancelled(stage, way):
    """The goals that a node has sent do not outlive its activation."""
    if way == "transitions":
        only_ros2(stage)
    served = stage.serve_action(seconds=30.0)
    node = stage.start("probe", "once update: send 300", "once update: wait pending")
    wait_for(lambda: ("goal", 300) in served(), lambda: f"no goal: {node.story()}")
    node.wait("update", "wait")
    if way == "transitions":
        assert stage.transition("deactivate")
    else:
        assert node.stop() == 0
    wait_for(lambda: ("canceled", 300) in served(), lambda: f"{served()} {node.story()}")


def test_dead_server_is_lost(stage, tmp_path):
    """A goal whose server was killed is lost, within what the middleware needs to notice."""
    lease = tmp_path / "lease.xml"
    lease.write_text(SHORT_LEASE)
    doomed = stage.another_peer(FASTDDS_DEFAULT_PROFILES_FILE=str(lease))
    name = stage.name("delegate")
    doomed.serve_action(action=name, seconds=60.0)
    node = stage.start("probe", "once update: send 400", "once update: wait pending")
    wait_for(lambda: doomed.served_log(name=name), lambda: f"no goal: {node.story()}")
    assert node.value("update", "wait") == "active", node.story()
    doomed.kill()
    node.tell("once update: wait active")
    wait_for(lambda: len(node.events("update", "wait")) == 2, node.story, 40.0)
    assert node.events("update", "wait")[-1]["value"] == "lost", node.story()
    node.expect("[ERROR]")


# The doomed peer asks to be given up after 2 s; the default of Fast DDS is 20 s.
SHORT_LEASE = """<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns="http://www.eprosima.com"><profiles>
  <participant profile_name="short" is_default_profile="true"><rtps><builtin><discovery_config>
    <leaseDuration><sec>2</sec></leaseDuration>
    <leaseAnnouncement><sec>0</sec><nanosec>500000000</nanosec></leaseAnnouncement>
  </discovery_config></builtin></rtps></participant>
</profiles></dds>
"""


def test_result_beside_the_loss(stage):
    """A goal ends once: what comes while it is given up does not change its end."""
    only_ros1(stage, "goals come and end in one thread in ROS 2")
    only_python(stage, "it is about a moment within the package")
    doomed = stage.another_peer()
    doomed.serve_action(action=stage.name("delegate"), seconds=1.0)
    hold = "once before the end of the goal: hold result"
    node = stage.start("probe", "once update: send 1", hold)
    node.wait("before the end of the goal")  # with a result
    doomed.kill()
    node.tell("once update: wait active", hold)
    assert node.value("update", "wait") == "lost", node.story()
    node.tell("update: state")
    node.wait("before the end of the goal", "end", count=2)
    node.wait("update", "state", count=10)
    assert {event["value"] for event in node.events("update", "state")} == {"lost"}, node.story()
    node.expect("[ERROR]")


def test_call_of_a_server_that_is_killed(stage):
    """It ends without a response, and the next one finds the next server."""
    doomed = stage.another_peer()
    name = stage.name("ask")
    doomed.serve(service=name, seconds=60.0)
    node = stage.start("probe", "update: call 1")
    wait_for(lambda: doomed.served_log(name=name), lambda: f"not called: {node.story()}")
    ended = len(node.events("update", "call"))  # before the server was found
    doomed.kill()
    assert node.wait("update", "call", count=ended + 1)["value"] is None
    stage.serve()
    node.tell("update: call 1")
    wait_for(lambda: "yes" in [e["value"] for e in node.events("update", "call")], node.story)
    node.tell()
    node.expect("[ERROR]")


@pytest.mark.parametrize("seconds", [0.2, 60.0])
def test_calls_of_many_threads(stage, seconds):
    """Each has its answer, and none when the node stops, however many there are at once."""
    stage.serve(seconds=seconds)
    count = 8 if stage.variant.is_ros2 else 40  # a server in ROS 2 keeps ten requests
    node = stage.active(f"once update: calls {count} 30")
    if seconds == 60.0:
        wait_for(lambda: stage.peer.served_log(name=stage.name("ask")), node.story)
        assert node.stop() == 0, node.story()
    assert node.value("update", "calls") == (count if seconds < 1.0 else 0), node.story()


def test_call_after_the_end_of_a_server(stage):
    """A dead server counts as none, though its address is known: the call waits for the next."""
    only_ros1(stage, "ROS 2 sends a request without a connection")
    doomed = stage.another_peer()
    doomed.serve(service=stage.name("ask"))
    doomed.kill()  # the master keeps its address
    node = stage.start("probe", *["update: call 0.02"] * 5)
    node.wait("update", "call", count=50)
    node.tell("once update: call 15")
    time.sleep(1.0)
    stage.serve()
    wait_for(lambda: "yes" in [e["value"] for e in node.events("update", "call")], node.story)
    node.expect("[ERROR]")


def test_call_of_a_server_that_is_frozen(stage):
    """It ends in time and leaves nothing, and the server is not asked when it thaws."""
    only_ros1(stage, "ROS 2 sends a request without a connection")
    only_python(stage, "it is about the threads of rospy")
    frozen = stage.another_peer()
    name = stage.name("ask")
    frozen.serve(service=name)
    node = stage.active()
    os.kill(frozen.process.pid, signal.SIGSTOP)
    node.tell("once update: call 0.5")
    node.wait("update", "call")
    before = measure(node)
    node.tell(*[f"once update: call 0.3{number}" for number in range(6)])
    wait_for(lambda: len(node.events("update", "call")) == 7, node.story)
    assert {event["value"] for event in node.events("update", "call")} == {None}
    time.sleep(0.5)
    assert_no_growth(before, measure(node), node)
    os.kill(frozen.process.pid, signal.SIGCONT)
    time.sleep(1.0)
    assert not frozen.served_log(name=name)


def test_missing_server_is_named(stage):
    """It is never waited for, and a warning names it, once in 10 s, in whichever activation."""
    node = stage.active()
    line = node.wait_log("ask")
    assert "delegate" in line, line
    if stage.variant.is_ros2:  # a node of ROS 1 has one life
        assert stage.transition("deactivate", "cleanup", "configure", "activate"), node.story()
    time.sleep(2.5)
    assert len(re.findall(".*Waiting for.*", node.log())) == 1, node.log()


def test_missing_server_of_a_slow_master(stage):
    """It is named though the first look for it is under way when another client is created."""
    only_ros1(stage, "ROS 2 has no master")
    only_python(stage, "in C++ a look begins when there are all clients")
    with relayed_master(stage) as master:
        created = master.hold("registerPublisher", stage.name("delegate/goal"))
        looked_up = master.hold("lookupService", stage.name("ask"))
        node = stage.start("probe")
        created.wait()
        looked_up.wait()
        created.release()
        node.wait("update")
        looked_up.release()
        node.wait_log("Waiting for.* ask")
        assert node.stop() == 0


@pytest.mark.parametrize("way", ["sigint", "sigterm", "transitions"])
def test_served_goals_end_with_a_result(stage, way):
    """Also those that wait for their turn, when the node stops."""
    if way == "transitions":
        only_ros2(stage)
    node = stage.active()
    goals = [stage.goal("line", 500), stage.goal("line", 1), stage.goal("single", 600)]
    node.wait("line")
    node.wait("single")
    if way == "transitions":
        assert stage.transition("deactivate")
    else:
        assert node.stop(getattr(signal, way.upper())) == 0
    results = [stage.result(goal)[0] for goal in goals]
    assert results == ["aborted"] * 3, node.story()
    assert [event["value"] for event in node.events("line", "begin")] == [500]


def test_goal_whose_method_raises_is_aborted(stage):
    """Also where it has succeeded before."""
    node = stage.active()
    assert stage.result(stage.goal("work", 66))[0] == "aborted"
    assert node.exit() == 1, node.story()
    node.expect("Traceback", "[ERROR]", "Exception")


def test_goal_is_cancelled_by_its_client(stage):
    node = stage.active()
    goal = stage.goal("work", 700)
    node.wait("work")
    stage.peer.cancel(number=goal)
    assert stage.result(goal) == ["canceled", [700]]


def test_goal_replace(stage):
    """A new goal is executed once the current one, asked to end, has returned."""
    node = stage.active()
    first = stage.goal("work", 800)
    node.wait("work")
    second = stage.goal("work", 8)
    assert stage.result(second) == ["succeeded", [8]]
    # A goal of ROS 2 cannot be canceled if no client has asked for it.
    assert stage.result(first)[0] == ("aborted" if stage.variant.is_ros2 else "canceled")
    events = [(event["event"], event["value"]) for event in node.events("work")]
    assert events.index(("over", 800)) < events.index(("begin", 8)), events


def test_goal_beside_the_end_of_another(stage):
    """A new goal replaces all that wait, also while the current one comes to its end."""
    only_ros1(stage, "goals come and end in one thread in ROS 2")
    only_python(stage, "it is about a moment within the package")
    node = stage.active("once work: hold first")
    stage.goal("work", 5)
    node.wait("work")
    stage.goal("work", 900)
    node.tell("work: hold first", "once after replacing: hold third")
    third = stage.peer.begin("goal", action=stage.name("work"), order=6)
    node.wait("after replacing")
    node.tell("once after replacing: hold third", "once before telling the outcome: block 0")
    node.wait("before telling the outcome")
    node.tell()
    assert stage.result(third.result(60)) == ["succeeded", [6]], node.story()


def test_goal_queue(stage):
    """Goals are executed one after the other; one that waits can be cancelled."""
    node = stage.active()
    goals = [stage.goal("line", number) for number in (500, 2, 3, 4)]
    stage.peer.cancel(number=goals[2])
    stage.peer.cancel(number=goals[0])  # which lets the others have their turn
    results = [stage.result(goal)[0] for goal in goals]
    assert results == ["canceled", "succeeded", "canceled", "succeeded"], node.story()
    assert [event["value"] for event in node.events("line", "begin")] == [500, 2, 4]


def test_goal_that_waits_is_accepted(stage):
    node = stage.active()
    first = stage.goal("line", 500)
    node.wait("line")
    second = stage.goal("line", 5)
    assert stage.peer.is_accepted(number=second)
    assert [event["value"] for event in node.events("line", "begin")] == [500]
    stage.peer.cancel(number=first)
    assert stage.result(second) == ["succeeded", [5]]


def test_goal_reject(stage):
    """While one goal is executed, others are rejected; after it, not."""
    node = stage.active()
    first = stage.goal("single", 900)
    node.wait("single")
    assert stage.goal("single", 1) is None
    stage.peer.cancel(number=first)
    assert stage.result(first)[0] == "canceled"
    second = stage.goal("single", 2)
    assert stage.result(second) == ["succeeded", [2]]


def start_crowd(stage, *orders):
    """Start goals that are executed in parallel, each until it is to end."""
    goals = [stage.goal("crowd", order) for order in orders]
    assert None not in goals
    return goals


def test_goals_in_parallel(stage):
    """Each is executed at once in a thread of its own, with its own request, cancel and result."""
    node = stage.active()
    first, second, third = start_crowd(stage, 500, 600, 700)
    node.wait("crowd", count=3)
    begun = node.events("crowd", "begin")
    assert {event["value"] for event in begun} == {500, 600, 700}
    assert len({event["id"] for event in begun}) == 3
    assert {event["thread"] for event in begun} == {begun[0]["thread"]}
    assert "crowd" in begun[0]["thread"]
    stage.peer.cancel(number=second)
    assert stage.result(second) == ["canceled", [600]]
    assert stage.result(stage.goal("crowd", 5)) == ["succeeded", [5]]
    stage.peer.cancel(number=third)
    assert stage.result(third) == ["canceled", [700]]
    assert [event["value"] for event in node.events("crowd", "over")] == [600, 5, 700]
    stage.peer.cancel(number=first)
    assert stage.result(first) == ["canceled", [500]]


def test_goals_in_parallel_have_a_bound(stage):
    """A burst of them starts no more than max_goals; the others are rejected."""
    node = stage.active()
    name = stage.name("crowd")
    assert stage.result(stage.goal("crowd", 5))[0] == "succeeded"  # it is found by now
    burst = [stage.peer.begin("goal", action=name, order=500 + n) for n in range(9)]
    goals = [goal for goal in (future.result(60) for future in burst) if goal is not None]
    assert len(goals) == 3, node.story()
    assert stage.goal("crowd", 1) is None
    for goal in goals:
        stage.peer.cancel(number=goal)
    assert [stage.result(goal)[0] for goal in goals] == ["canceled"] * 3
    assert len(node.events("crowd", "begin")) == 1 + 3


@pytest.mark.parametrize("way", ["sigint", "transitions"])
def test_stop_ends_goals_in_parallel(stage, way):
    if way == "transitions":
        only_ros2(stage)
    node = stage.active()
    goals = start_crowd(stage, 500, 600, 700)
    node.wait("crowd", count=3)
    if way == "transitions":
        assert stage.transition("deactivate")
    else:
        assert node.stop() == 0
    assert [stage.result(goal)[0] for goal in goals] == ["aborted"] * 3, node.story()
    assert sorted(event["value"] for event in node.events("crowd", "over")) == [500, 600, 700]
    if way == "transitions":
        assert stage.goal("crowd", 1) is None
        assert stage.transition("activate")
        again = start_crowd(stage, 800, 900, 901)
        node.wait("crowd", count=6)
        for goal in again:
            stage.peer.cancel(number=goal)
        assert [stage.result(goal)[0] for goal in again] == ["canceled"] * 3


def test_stop_of_goals_in_parallel_that_block(stage):
    """They have stop_timeout together; those that have not returned are aborted and named."""
    node = stage.active("crowd: block 60", stop_timeout=0.5)
    goals = start_crowd(stage, 1, 2)
    node.wait("crowd", count=2)
    node.tell()
    goals += start_crowd(stage, 500)
    node.wait("crowd", count=3)
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert re.search(r"Still running when the node stops: .*crowd\b", node.log()), node.story()
    assert [stage.result(goal)[0] for goal in goals] == ["aborted"] * 3
    node.ended_well = False


def test_exception_of_a_goal_in_parallel(stage):
    """It takes the node, and so the other goals, along as that of any goal does."""
    node = stage.active("deactivate: publish STOP")
    heard = stage.listen(node)
    goals = start_crowd(stage, 500, 600)
    node.wait("crowd", count=2)
    node.tell("crowd: throw", "deactivate: publish STOP")
    goals += start_crowd(stage, 5)
    assert node.exit(SOON) == 1, node.story()
    assert [stage.result(goal)[0] for goal in goals] == ["aborted"] * 3
    assert "thrown on purpose" in node.log(), node.story()
    assert node.methods() == LIFE
    wait_for(lambda: heard() == ["STOP"], lambda: f"heard {heard()}: {node.story()}")
    node.expect("Traceback", "[ERROR]", "[FATAL]", "Exception")


def test_goal_that_the_logic_refuses(stage):
    """It is rejected, before it replaces another; the logic judges in a thread of its own."""
    node = stage.active("accept: refuse")
    assert stage.goal("choice", 1) is None
    node.tell()
    first = stage.goal("choice", 900)
    node.wait("choice")
    node.tell("accept: refuse")
    assert stage.goal("choice", 2) is None
    node.tell()
    time.sleep(0.1)
    assert [event["event"] for event in node.events("choice")][-1] == "end", node.story()
    assert stage.result(stage.goal("choice", 3)) == ["succeeded", [3]]
    assert stage.result(first)[0] == ("aborted" if stage.variant.is_ros2 else "canceled")
    judged = node.events("accept", "begin")
    assert [event["value"] for event in judged] == [1, 900, 2, 3]
    assert {event["thread"] for event in judged} == {node.wait("choice")["thread"]}
    assert {event["id"] for event in judged}.isdisjoint(e["id"] for e in node.events("choice"))


def test_exception_while_accepting(stage):
    """The goal is rejected, and the node ends as by any exception."""
    node = stage.active("accept: throw")
    assert stage.goal("choice", 1) is None
    assert node.exit(SOON) == 1, node.story()
    assert "thrown on purpose" in node.log()
    assert node.methods() == LIFE
    node.expect("Traceback", "[ERROR]", "Exception")


def test_stop_while_accepting(stage):
    """A logic that does not say whether it accepts a goal delays the stop by stop_timeout."""
    node = stage.active("once accept: block 60", stop_timeout=0.5)
    goal = stage.peer.begin("goal", action=stage.name("choice"), order=1)
    wait_for(lambda: _told(node, "accept"), lambda: f"not blocked: {node.story()}")
    node.send_signal()
    assert node.exit(SOON) == 1, node.story()
    assert re.search(r"Still running when the node stops: .*choice\b", node.log()), node.story()
    with contextlib.suppress(Exception):
        assert goal.result(0.0) is None
    node.ended_well = False


def test_goal_with_an_id_that_is_known(stage):
    """What a client does wrong harms nobody else."""
    only_ros2(stage, "a goal of ROS 1 is told apart by its client's name as well")
    node = stage.active()
    assert stage.result(stage.goal("work", 5)) == ["succeeded", [5]]
    stage.peer.repeat_goal(action=stage.name("work"), order=6)
    assert stage.result(stage.goal("work", 7)) == ["succeeded", [7]]
    node.expect("[ERROR]")


def test_goal_while_its_server_goes(stage):
    """It finds either the whole server or none."""
    only_ros1(stage, "ROS 2 takes goals with the lock that destroys a server")
    if stage.variant.is_python:
        pytest.skip("does not apply: rospy takes all servers down at once")
    goal = "test_msgs/msg/FibonacciActionGoal"
    with relayed_master(stage) as master:
        # The publishers have gone by then, and goals still come.
        going = master.hold("unregisterSubscriber", stage.name("work/cancel"))
        node = stage.active(stop_timeout=30.0)
        stage.publish("work/cancel", {"id": "cancelled before"}, "actionlib_msgs/msg/GoalID")
        stage.publish("work/goal", {}, goal)
        node.wait("work", "over")
        node.send_signal()
        going.wait()
        stage.publish("work/goal", {}, goal)
        stage.publish("work/goal", {"goal_id": {"id": "cancelled before"}}, goal)
        time.sleep(0.5)
        going.release()
        assert node.exit() == 0, node.story()
        assert len(node.events("work", "begin")) == 1


def test_goal_without_an_outcome(stage):
    """It is aborted, and the log says why, unless the goal was to end."""
    node = stage.active()
    assert stage.result(stage.goal("work", -1))[0] == "aborted"
    assert "work returned without an outcome: the goal is aborted" in node.log()


# Services


def test_service_served_while_deactivating(stage):
    """The client gets its answer, and the node lives on."""
    only_ros2(stage)
    node = stage.active("serve: block 0.5")
    for _ in range(3):
        answers = [stage.call() for _ in range(2)]
        before = len(node.events("serve", "end"))
        wait_for(lambda: _told(node, "serve"), node.story)
        assert stage.transition("deactivate"), node.story()
        assert len(node.events("serve", "end")) > before, "deactivated before it was served"
        assert stage.transition("activate"), node.story()
        wait_for(lambda answers=answers: any(answer.done() for answer in answers), node.story)
        time.sleep(0.6)
    assert node.process.poll() is None
    assert stage.call().result() == "served"


# Transitions


def test_transitions_in_every_order(stage):
    """Random transitions, with work under way and in flight at once, leave a sound node."""
    only_ros2(stage)
    stage.serve()
    stage.serve_action(seconds=0.01)
    node = stage.active("update: call 1", "update: goal 1", "receive: sleep 0.01")
    for _ in range(LIVES):
        names = random.choices(["deactivate", "activate", "cleanup", "configure"], k=4)
        flights = [
            stage.peer.begin("change_state", node=stage.name("probe"), transition=name)
            for name in names
        ]
        call = stage.call(timeout=2.0)
        for flight in flights:
            flight.result(60)
        assert node.process.poll() is None, node.story()
        del call
    if stage.state() == "unconfigured":
        assert stage.transition("configure")
    if stage.state() == "inactive":
        assert stage.transition("activate")
    assert stage.state() == "active", node.story()
    node.wait("update", count=len(node.events("update", "begin")) + 1)
    node.expect("[ERROR]", "[FATAL]")  # of transitions that there are not


# Growth


def measure(node, settle=True):
    return {"memory": node.memory(), "threads": len(node.threads()), "files": node.files()}


def assert_no_growth(before, after, node):
    assert after["memory"] - before["memory"] < 8.0, f"{before} {after}"  # MB
    assert after["threads"] <= before["threads"] + 1, f"{before} {after} {node.threads()}"
    assert after["files"] <= before["files"] + 3, f"{before} {after}"


def settled_graph(stage):
    """Return the size of the ROS graph, once there is one and two seconds bring nothing new.

    The peer hears of the node's topics and services one by one, after its transition.
    """
    sizes = []

    def is_settled():
        sizes.append(stage.peer.graph(namespace=stage.namespace))
        return sizes[-1] and len(sizes) > 20 and len({*sizes[-20:]}) == 1

    wait_for(lambda: time.sleep(0.1) or is_settled(), "the graph does not settle")
    return sizes[-1]


def test_no_growth_by_goals_calls_and_lookups(stage):
    stage.serve()
    stage.serve_action(feedback=20000)  # 80 kB
    node = stage.active("once update: rounds 40", stop_timeout=30.0)
    assert node.value("update", "rounds") == [40, 40]
    before = measure(node)
    node.tell(f"once update: rounds {ROUNDS}")
    wait_for(lambda: len(node.events("update", "rounds")) == 2, node.story, 60 + ROUNDS / 5)
    assert node.events("update", "rounds")[-1]["value"] == [ROUNDS, ROUNDS]
    assert_no_growth(before, measure(node), node)


def test_no_growth_by_calls_without_an_answer(stage):
    """Neither threads nor memory are left by calls that time out, and by goals without server."""
    stage.serve(seconds=600.0)
    node = stage.active("once update: call 1")
    node.wait("update", "call")
    before = measure(node)
    lines = [f"once update: call 0.02{number:03}" for number in range(min(ROUNDS, 50))]
    node.tell(*lines)
    wait_for(lambda: len(node.events("update", "call")) == 1 + len(lines), node.story, 60.0)
    time.sleep(0.5)
    assert_no_growth(before, measure(node), node)


def test_no_growth_by_lives(stage):
    """Lifecycle rounds leave no memory, threads, files, and nothing in the ROS graph."""
    only_ros2(stage)
    stage.serve()
    node = stage.active("update: call 1")
    life = ("deactivate", "cleanup", "configure", "activate")
    for _ in range(4):
        assert stage.transition(*life), node.story()
    before, graph = measure(node), settled_graph(stage)
    for _ in range(LIVES):
        assert stage.transition(*life), node.story()
    assert_no_growth(before, measure(node), node)
    wait_for(lambda: stage.peer.graph(namespace=stage.namespace) <= graph, "the graph has grown")


# Time


@pytest.fixture
def simulated(stage):
    """Simulated time, which the test sets with the function."""
    if not stage.variant.is_ros2:
        stage.peer.set_global(name="/use_sim_time", value=True)
    yield lambda seconds: stage.peer.clock(seconds=seconds)
    if not stage.variant.is_ros2:
        stage.peer.delete_global(name="/use_sim_time")
        stage.peer.end_clock()  # its last time is latched


def start_simulated(stage, *told, name="probe"):
    parameters = {"use_sim_time": True} if stage.variant.is_ros2 else {}
    return stage.start(name, *told, **parameters)


def advance(clock, start, node, cycles, step=0.01):
    """Let simulated time go on until the node has done so many more cycles."""
    now, before = start, len(node.events("update", "begin"))
    end = time.monotonic() + 20.0
    while len(node.events("update", "begin")) < before + cycles:
        assert time.monotonic() < end, f"the loop stands still: {node.story()}"
        now += step
        clock(now)
        time.sleep(step)
    return now


def test_paused_time(stage, simulated):
    """The loop stands still, without polling; calls, goals and the stop do not."""
    stage.serve()
    node = start_simulated(stage, "serve: call 5", "deactivate: publish STOP")
    now = advance(simulated, 10.0, node, 3)
    time.sleep(0.2)
    simulated(now)
    time.sleep(0.1)
    count = len(node.events("update", "begin"))
    used = node.processor_time()
    time.sleep(1.0)
    assert len(node.events("update", "begin")) <= count + 1
    assert node.processor_time() - used < 0.3, "it polls"
    assert stage.call().result() == "served"
    assert node.value("serve", "call") == "yes", node.story()
    assert stage.result(stage.goal("work", 5)) == ["succeeded", [5]]
    assert node.stop() == 0


def test_time_limits_are_of_wall_time(stage, simulated):
    """A call without an answer, in simulated time that stands still, ends all the same."""
    node = start_simulated(stage, "once update: call 0.3", "once update: send 1")
    simulated(10.0)
    end = time.monotonic() + 20.0
    while not node.events("update", "call"):
        assert time.monotonic() < end, node.story()
        simulated(10.0)
        time.sleep(0.1)
    assert node.value("update", "call") is None


def test_time_jumps_back(stage, simulated):
    """The loop goes on within a period."""
    node = start_simulated(stage)
    now = advance(simulated, 100.0, node, 5)
    assert now > 100.0
    simulated(5.0)
    assert advance(simulated, 5.0, node, 5) < 7.0, "it made up for time or waited for the old"
    node.expect("[ERROR]")


def test_time_jumps_back_during_update(stage, simulated):
    """It goes on within a period of the new time, however far ahead the old one was."""
    node = start_simulated(stage)
    advance(simulated, 100.0, node, 5)
    node.tell("once update: block 1.0")
    wait_for(lambda: advance(simulated, 101.0, node, 1) and _told(node, "update"), node.story)
    simulated(5.0)
    node.wait("update", "block")
    assert advance(simulated, 5.0, node, 5) < 7.0, "it waited for the old time"
    node.expect("[ERROR]")


def test_time_in_steps(stage, simulated):
    """Samples of /clock that do not meet the cycles leave the frequency as it is."""
    node = start_simulated(stage)
    now = advance(simulated, 1e9, node, 5)
    cycles = lambda: len(node.events("update", "begin")) - before  # noqa: E731
    before, lost = len(node.events("update", "begin")), 0
    for samples in range(1, 201):  # 3 s, as fast as the node goes along
        now += 0.015
        simulated(now)
        end = time.monotonic() + 0.3
        while cycles() + lost < int(0.75 * samples):
            lost += time.monotonic() > end
            time.sleep(0.002)
    # None is lost, but for a few on a busy machine; 50 are if each sample begins a new grid.
    assert lost < 30
    assert cycles() <= 151


def test_sleep_when_time_jumps_back(stage, simulated):
    """It lasts that long from the new time on."""
    node = start_simulated(stage)
    times = itertools.count(advance(simulated, 100.0, node, 3), 0.01)
    node.tell("once update: block 0", "once update: sleep 5")
    wait_for(lambda: simulated(next(times)) or node.events("update", "block"), node.story)
    simulated(50.0)
    time.sleep(0.5)
    for seconds in range(51, 55):
        simulated(float(seconds))
        time.sleep(0.1)
    assert not node.events("update", "sleep"), node.story()
    simulated(56.0)
    assert node.value("update", "sleep") is True, node.story()


def test_missed_cycles(stage):
    """A cycle that takes too long is not made up for; warnings say how many were missed."""
    node = stage.active()
    node.tell("once update: block 2")
    node.wait("update", "block")
    line = node.wait_log("missed")
    assert re.search(r"Missed \d+ cycles of 50 Hz: update takes too long\.", line), line
    blocked = node.wait("update", "block")["time"]
    after = [e["time"] for e in node.events("update", "begin") if e["time"] > blocked]
    assert sum(moment < blocked + 0.1 for moment in after) < 12, "it makes up for missed cycles"
    node.tell("once update: block 0.3")
    wait_for(lambda: len(node.events("update", "block")) == 2, node.story)
    time.sleep(0.3)
    told = lambda: re.findall(r"Missed (\d+) cycles", node.log())  # noqa: E731
    assert len(told()) == 1, node.log()
    wait_for(lambda: told()[1:], node.story)  # after 10 s, though none was missed since
    first, later = map(int, told())
    assert later < first, node.log()


def test_missed_cycles_of_several_lives(stage):
    """The next warning may come 10 s after the last one, in whichever activation."""
    only_ros2(stage, "a node of ROS 1 has one life")
    node = stage.active("update: block 0.1")
    node.wait_log("missed")
    for life in range(2, 5):
        assert stage.transition("deactivate", "cleanup", "configure", "activate"), node.story()
        wait_for(lambda: len(node.events("activate", "end")) == life, node.story)  # noqa: B023
        node.wait("update", "end", count=len(node.events("update", "end")) + 3)
    assert len(re.findall("(?i)missed", node.log())) == 1, node.story()


def test_no_cycle_before_the_clock(stage, simulated):
    node = start_simulated(stage)
    node.wait("activate", "end")
    time.sleep(0.5)
    assert not node.events("update"), node.story()
    advance(simulated, 10.0, node, 3)
    assert node.stop() == 0


@pytest.mark.parametrize("seconds", [0.0, 0.01])
def test_steps_of_the_clock_miss_no_cycles(stage, simulated, seconds):
    """However long they are, and whether or not one comes while `update` runs."""
    node = start_simulated(stage, f"update: block {seconds}", name="gauge")
    node.wait("activate", "end")
    times = itertools.count(100.0, 0.5)
    cycles = lambda: len(node.events("update", "begin"))  # noqa: E731
    wait_for(lambda: simulated(next(times)) or cycles() > 50, node.story)
    assert "Missed" not in node.log(), node.story()


def test_late_cycle_starts_at_once(stage):
    """An update a little longer than a period runs at its own pace, not at half of it."""
    node = stage.active("update: block 0.022")
    node.wait("update", "block", 40)
    begins = [e["time"] for e in node.events("update", "begin")]
    ends = [e["time"] for e in node.events("update", "end")]
    pauses = [begin - end for end, begin in zip(ends, begins[1:], strict=False)]
    assert statistics.median(pauses) < 0.25 / 50, node.story()


# QoS


def test_latched_topics(stage):
    """With durability transient_local what was published before is heard, both ways."""
    latched = {"durability": "transient_local"}
    stage.publish("map", "of old", wait=False, qos=latched)
    node = stage.active("configure: keep first")
    heard = stage.hear("kept", **latched)
    seen = lambda: [event["value"]["map"] for event in node.events("update", "begin")]  # noqa: E731
    wait_for(lambda: "of old" in seen(), lambda: f"not heard: {node.story()}")
    wait_for(lambda: heard() == ["first"], lambda: f"heard {heard()}: {node.story()}")


def test_incompatible_qos(stage):
    """A warning names the topic and the policy; an override mends it."""
    only_ros2(stage, "ROS 1 has no QoS")
    sensor = {"reliability": "best_effort"}
    stage.publish("number", 1, INT64, wait=False, qos=sensor)
    node = stage.active()
    line = node.wait_log("reliability")
    assert "number" in line, line
    assert node.stop() == 0
    eager = f"qos_overrides.{stage.name('number')}.subscription.reliability"
    late = f"qos_overrides.{stage.name('kept')}.publisher.durability"
    overrides = {eager: "best_effort", late: "volatile"}
    node = stage.active("configure: keep first", **overrides)
    wait_for(lambda: _sent(stage, node, 2, sensor), node.story)
    heard = stage.hear("kept", durability="transient_local")
    node.wait_log("durability")
    assert heard() == []


def test_requests_that_wait(stage):
    """As many as the depth of the server says, and each is answered."""
    only_ros2(stage, "in ROS 1 each call has a connection of its own")
    stage.start("clerk", "once serve: block 1")
    stage.peer.burst(service=stage.name("greet"), count=60)


def _sent(stage, node, number, qos):
    stage.publish("number", number, INT64, wait=False, qos=qos)
    time.sleep(0.05)
    return number in numbers(node)


# Diagnostics


def statuses(stage, name):
    """Return level and message of each status of a node so far."""
    return [(each["level"], each["message"]) for each in all_statuses(stage, name)]


def all_statuses(stage, name):
    heard = stage.peer.heard(topic="/diagnostics")
    found = [status for _, message in heard for status in message["status"]]
    return [each for each in found if each["name"] == stage.name(name)]


def reporting(stage, *told, name="gauge"):
    """Start a node with diagnostics; return it when it has reported."""
    stage.peer.hear(topic="/diagnostics", kind="diagnostic_msgs/msg/DiagnosticArray")
    node = stage.start(name, *told)
    wait_for(lambda: statuses(stage, name), node.story)
    return node


def wait_for_status(stage, is_wanted):
    """Return the values of the next status of the gauge that is as wanted."""
    begin = len(all_statuses(stage, "gauge"))

    def found():
        for status in all_statuses(stage, "gauge")[begin:]:
            values = {item["key"]: item["value"] for item in status["values"]}
            if is_wanted(status["level"], status["message"], status["hardware_id"], values):
                return values
        return None

    return wait_for(found, lambda: all_statuses(stage, "gauge")[begin:])


def test_diagnostics(stage):
    """State, rate, late and missed cycles, once a second, where the spec asks for them."""
    reporting(stage)
    values = wait_for_status(
        stage,
        lambda level, message, hardware, values: (
            (level, message, hardware) == (0, "active", "none")
            and 8.0 < float(values["rate (Hz)"]) < 12.0
        ),
    )
    assert values.keys() == {"state", "rate (Hz)", "late cycles", "missed cycles"}
    assert values["state"] == "active"


LEVELS = {"ok": 0, "warning": 1, "error": 2}


def test_diagnostics_of_the_logic(stage):
    """Its values, level and hardware id are there until it says others."""
    node = reporting(stage)
    for number, (word, level) in enumerate(LEVELS.items()):
        node.tell(f"update: diagnose {word} said{number} {number}")
        values = wait_for_status(
            stage,
            lambda *status, wanted=(level, f"said{number}"): (
                status[0] == wanted[0] and wanted[1] in status[1] and status[2] == wanted[1]
            ),
        )
        assert (values["number"], values["is_said"]) == (str(number), "True")
    node.tell("update: diagnose ok well 7")
    wait_for_status(stage, lambda level, message, *_: (level, message) == (0, "active; well"))


def test_the_logic_is_dropped_after_cleanup(stage):
    """The logic of a node that lives on gives back what it holds."""
    only_rclcpp(stage, "objects of Python end when its collector gets to them")
    node = stage.start("probe", "destructor: block 0")
    node.wait("update", "end")
    assert stage.transition("deactivate", "cleanup"), node.story()
    node.wait("destructor", "block")


def test_diagnostics_of_a_new_logic(stage):
    """What a logic has said goes with it."""
    only_ros2(stage)
    reporting(stage, "activate: diagnose error lost 7")
    wait_for_status(stage, lambda level, message, *_: (level, message) == (2, "lost"))

    def is_empty(level, _, hardware, values):
        return (level, hardware) == (0, "none") and "number" not in values

    stage.transition("deactivate", "cleanup", node="gauge")
    wait_for_status(stage, lambda *status: is_empty(*status) and status[1] == "unconfigured")
    stage.transition("configure", node="gauge")
    wait_for_status(stage, lambda *status: is_empty(*status) and status[1] == "inactive")


@pytest.mark.parametrize("transition", ["configure", "activate"])
def test_diagnostics_of_a_refusal(stage, transition):
    """A node whose logic refuses says so as an error, until it is asked again."""
    stage.peer.hear(topic="/diagnostics", kind="diagnostic_msgs/msg/DiagnosticArray")
    refused = f"The logic refused to {transition}."
    if not stage.variant.is_ros2:
        node = stage.start("gauge", f"{transition}: refuse", f"{transition}: block 3")
        wait_for(lambda: statuses(stage, "gauge"), node.story)
        assert node.exit(SOON) == 1, node.story()
        last = lambda: statuses(stage, "gauge")[-1]  # noqa: E731
        wait_for(lambda: last() == (2, refused), lambda: statuses(stage, "gauge"))
        node.expect("[ERROR]", "[FATAL]")
        return
    node = stage.start("gauge", f"once {transition}: refuse", autostart=False)
    assert not stage.transition("configure", "activate", node="gauge")
    wait_for_status(stage, lambda level, message, *_: (level, message) == (2, refused))
    rest = ["activate"] if transition == "activate" else ["configure", "activate"]
    assert stage.transition(*rest, node="gauge")
    wait_for_status(stage, lambda level, *_: level == 0)
    node.expect("[ERROR]")


@pytest.mark.parametrize(
    ("name", "parameter", "refused"),
    [
        ("guard", "order_topic", "order_topic must be the name of a topic, not 'a b'."),
        ("dial", "device", "device must be set."),
    ],
)
def test_diagnostics_of_refused_parameters(stage, name, parameter, refused):
    """A node that does not configure for a parameter says so as an error, until it does."""
    only_ros2(stage, "a node of ROS 1 reads its parameters before it reports")
    given = {"order_topic": "a b"} if name == "guard" else {}
    stage.peer.hear(topic="/diagnostics", kind="diagnostic_msgs/msg/DiagnosticArray")
    node = stage.start(name, autostart=False, **given)
    assert not stage.transition("configure", node=name)
    said = lambda: statuses(stage, name)[-1:]  # noqa: E731
    wait_for(lambda: said() == [(2, f"Parameter {refused}")], said)
    assert stage.peer.set_parameter(node=stage.name(name), name=parameter, value="good")
    assert stage.transition("configure", node=name)
    wait_for(lambda: said() == [(0, "inactive")], said)
    node.expect("[ERROR]")


@pytest.mark.parametrize("periods", [1.6, 5.0])
def test_diagnostics_of_late_cycles(stage, periods):
    """Cycles that take too long are counted, and make the status a warning, for a while."""
    node = reporting(stage)
    wait_for_status(stage, lambda level, *_: level == 0)
    node.tell(f"once update: block {periods / 10}")
    values = wait_for_status(stage, lambda level, text, *_: (level, text) == (1, "late cycles"))
    assert int(values["late cycles"]) > 0
    assert (int(values["missed cycles"]) > 0) or periods < 2.0
    after = wait_for_status(stage, lambda level, *_: level == 1)
    if after["late cycles"] == values["late cycles"]:  # else the machine is busy
        wait_for_status(stage, lambda level, *_: level == 1)
    wait_for_status(stage, lambda level, text, *_: (level, text) == (0, "active"))
    node.tell("update: diagnose warning tired 1", "update: block 0.16")
    wait_for_status(stage, lambda level, text, *_: (level, text) == (1, "late cycles; tired"))
    node.tell("update: diagnose error lost 1", "update: block 0.16")
    wait_for_status(stage, lambda level, text, *_: (level, text) == (2, "lost"))


@pytest.mark.parametrize("how", ["throw", "fail"])
@pytest.mark.parametrize("word", LEVELS)
def test_diagnostics_of_a_failure(stage, how, word):
    """A node that has failed says why in a line, never OK after it, whatever the logic says."""
    node = reporting(stage)
    fails = rf"update: {how} first\nsecond\n"
    node.tell(f"update: diagnose {word} said 7", fails, f"cleanup: diagnose {word} said 8")
    assert node.exit(SOON) == 1, node.story()
    last = lambda: statuses(stage, "gauge")[-1]  # noqa: E731
    is_said = lambda: last()[0] == 2 and "first second" in last()[1]  # noqa: E731
    wait_for(is_said, lambda: statuses(stage, "gauge"))
    is_ok = [level < 2 for level, _ in statuses(stage, "gauge")]
    assert is_ok == sorted(is_ok, reverse=True), statuses(stage, "gauge")
    node.expect("Traceback", "[ERROR]", "Exception")


# Transforms


def test_lookup_says_why_not(stage):
    needs_tf(stage)
    node = stage.active("once update: lookup nowhere map 0.1")
    assert "nowhere" in str(node.value("update", "lookup")), node.story()


# Component containers


def fill(stage, container, *names, **parameters):
    """Load nodes of the package, each by its class; return their numbers."""
    return [
        stage.peer.load_node(
            container=stage.name("ComponentManager"),
            package="contract",
            plugin=f"contract::{name.capitalize()}Node",
            namespace=stage.namespace,
            parameters=parameters,
        )
        for name in names
    ]


def test_unloading(stage):
    """The last words of a node that is unloaded are heard, and its neighbour lives."""
    only_components(stage)
    container = stage.container("deactivate: publish STOP", "cleanup: publish OFF")
    probe, _ = fill(stage, container, "probe", "clerk")
    heard = stage.listen(container)
    assert stage.peer.unload_node(container=stage.name("ComponentManager"), number=probe)
    wait_for(lambda: heard() == ["STOP", "OFF"], lambda: f"{heard()}: {container.story()}")
    assert container.methods("probe") == LIFE
    assert stage.call("greet").result() == "greeted"


@pytest.mark.parametrize("late", ["configure", "activate"])
def test_unloading_while_starting(stage, late):
    """What has begun when `configure` or `activate` returns too late is undone."""
    only_components(stage)
    container = stage.container(f"{late}: hold")
    (number,) = fill(stage, container, "probe", stop_timeout=0.5)
    container.wait(late)
    assert stage.peer.unload_node(container=stage.name("ComponentManager"), number=number)
    assert container.methods()[-1] == late, container.story()
    container.tell()
    container.wait("cleanup", "end")
    container.expect("[ERROR]")


def test_unloading_while_reporting(stage):
    """A node stops before its members end, which wait for diagnostics that are being published."""
    only_components(stage)
    container = stage.container("stamp: hold", program="component_container_mt")
    (number,) = fill(stage, container, "clerk")
    container.wait("stamp")
    unloading = stage.peer.begin(
        "unload_node", container=stage.name("ComponentManager"), number=number
    )
    container.wait("cleanup", "end")
    time.sleep(1.0)  # what waits for nothing has ended by then
    assert not unloading.done(), container.story()
    container.tell()
    assert unloading.result(60)
    fill(stage, container, "probe")
    container.wait("update")


@pytest.mark.parametrize("way", ["sigint", "sigterm"])
def test_signal_to_container(stage, way):
    """All of its nodes stop in order, and are heard."""
    only_components(stage)
    container = stage.container("deactivate: publish STOP", "cleanup: publish OFF")
    fill(stage, container, "probe", "clerk")
    heard = stage.listen(container)
    assert stage.call("greet").result() == "greeted"
    assert container.stop(getattr(signal, way.upper())) == 0, container.story()
    wait_for(lambda: sorted(heard()) == ["OFF", "OFF", "STOP", "STOP"], lambda: f"{heard()}")


@pytest.mark.parametrize("where", ["configure", "activate", "update", "thread"])
def test_failure_in_container(stage, where):
    """The node is unconfigured after it, may start again, and fail again."""
    only_components(stage)
    told = "activate: later 0.5 lost" if where == "thread" else f"{where}: fail lost"
    container = stage.container(told)
    fill(stage, container, "probe")
    container.wait("cleanup", "end")
    wait_for(lambda: stage.state() == "unconfigured", container.story)
    container.tell()
    assert stage.transition("configure", "activate"), container.story()
    container.tell("update: fail again")
    container.wait("cleanup", "end", count=2)
    wait_for(lambda: stage.state() == "unconfigured", container.story)
    assert "The logic failed: again" in container.log()
    container.expect("[ERROR]")
    container.ended_well = False


@pytest.mark.parametrize("where", [*LIFE[:3], "receive", "serve", "work"])
def test_exception_in_container(stage, where):
    """The node is unconfigured after it; its neighbour and the container live on."""
    only_components(stage)
    container = stage.container()
    fill(stage, container, "clerk")
    assert stage.call("greet").result() == "greeted"
    container.tell(f"{where}: throw")
    fill(stage, container, "probe")
    if where not in LIFE[:3]:
        container.wait("update")
    if where == "receive":
        stage.publish("hear", "throw")
    elif where == "serve":
        stage.call()
    elif where == "work":
        stage.result(stage.goal("work", 5))
    container.wait(where, "raised")
    container.tell()
    wait_for(lambda: stage.state() == "unconfigured", container.story)
    assert "thrown on purpose" in container.log()
    assert stage.call("greet").result() == "greeted"
    assert stage.transition("configure", "activate"), container.story()
    container.expect("[ERROR]", "[FATAL]", "Exception")


def test_deactivating_in_container(stage):
    """A node with a goal, a call and a lookup under way blocks nothing of the container."""
    only_components(stage)
    stage.serve_action(seconds=60.0)
    container = stage.container("once update: send 1", "update: call 30", "receive: sleep 30")
    fill(stage, container, "probe", "clerk")
    container.wait("update", "send")
    goal = stage.goal("work", 1000)
    stage.publish("hear", "wait")
    container.wait("receive")
    assert stage.transition("deactivate", "cleanup", "configure", "activate"), container.story()
    assert stage.result(goal)[0] == "aborted"
    assert stage.call("greet").result() == "greeted"
