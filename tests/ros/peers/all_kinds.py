"""Talk to the running nodes of examples/all_kinds, whose logic is tests/data/logic, through ROS.

Run by the Python of a ROS: all_kinds.py PEER TOPIC..., where PEER is ros1 or ros2. A topic is
`tf` where transforms can be tested, `volume` where the subscriber of that name was added.
Exits with 1 at the first thing that does not hold.
"""

import importlib
import itertools
import os
import sys
import time
import traceback


def wait_for(condition, what, timeout=20.0):
    """Return the first true value of a condition; fail after `timeout` seconds."""
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError(what)


class Scenario:
    """The checks, one method for each interface kind."""

    def __init__(self, peer, has_tf):
        self.peer = peer
        self.has_tf = has_tf
        self.echo = peer.hear("echo", "std_msgs/msg/String")
        self.status = peer.hear("/status", "std_msgs/msg/String")
        self.counter = peer.hear("counter", "std_msgs/msg/Int64")
        self.say = peer.publisher("say", "std_msgs/msg/String")
        self.speed = peer.publisher("speed", "geometry_msgs/msg/Twist")
        self.transforms = None

    def said(self, text):
        return [message.data for message in self.echo if message.data.startswith(text)]

    def spoken(self, text):
        """Say a text, as often as it takes the node to hear it, and wait for the echo."""
        before = len(self.said(text))

        def echoed():
            self.say.publish(self.peer.message("std_msgs/msg/String", data=text))
            time.sleep(0.1)
            return len(self.said(text)) > before

        wait_for(echoed, f"{text} was not echoed")

    def check_publisher(self):
        """A topic goes out at the frequency, once the machine lets it for two seconds."""
        wait_for(lambda: self.counter, "nothing on counter")
        rates = []
        while not (rates and 18 < rates[-1] < 22):
            assert len(rates) < 20, f"counter runs at {rates} Hz, not at 20 Hz"
            start, count = time.monotonic(), len(self.counter)
            wait_for(lambda known=count: len(self.counter) >= known + 40, "counter is too slow")
            rates.append(round(40 / (time.monotonic() - start), 1))

    def check_subscriber(self):
        """Update gets the latest message once as new; an output not active is not sent."""
        assert not self.status, "status was sent though it was not active"
        wait_for(lambda: self.speed.connected(), "no subscriber of speed")
        self.say_speed(2.0)
        wait_for(lambda: self.status, "no status")
        assert self.status[-1].data == "worker 3 False", self.status[-1].data
        seen = len(self.counter)
        wait_for(lambda: len(self.counter) > seen + 5, "the loop stopped")
        assert len(self.status) == 1, "one speed gave more than one status"

    def say_speed(self, value):
        message = self.peer.message("geometry_msgs/msg/Twist")
        message.linear.x = value
        self.speed.publish(message)

    def check_own_topic(self):
        """A node hears the topic it publishes."""
        wait_for(lambda: self.said("heard "), "the worker does not hear its own counter")

    def check_direct(self):
        """Direct topics do not wait for the cycle, which each echo would take all of."""
        wait_for(lambda: self.say.connected(), "no subscriber of say")
        self.spoken("hello")
        times = []
        for number in range(20):
            start = time.monotonic()
            self.say.publish(self.peer.message("std_msgs/msg/String", data=f"quick {number}"))
            wait_for(lambda number=number: self.said(f"quick {number}"), "no direct echo")
            times.append(time.monotonic() - start)
        assert min(times) < 0.025, f"the quickest of 20 echoes took {min(times)} of 0.05 s"

    def check_missing_server(self):
        """A service that is not there costs no more than the time limit."""
        start = time.monotonic()
        answer = self.peer.call("enable", "std_srvs/srv/SetBool", "best_effort", data=True)
        assert (answer.success, answer.message) == (False, "no answer"), answer
        assert time.monotonic() - start < 3.0, "the time limit did not hold"

    def check_services(self):
        """The worker serves, and calls a service that we serve."""
        self.peer.serve("permit", "std_srvs/srv/Trigger", success=True, message="you may")

        def permitted():
            answer = self.peer.call("enable", "std_srvs/srv/SetBool", "best_effort", data=False)
            return answer.success and answer.message == "you may"

        wait_for(permitted, "no permission came through")
        time.sleep(0.2)
        stopped = self.counter[-1].data
        seen = len(self.counter)
        wait_for(lambda: len(self.counter) > seen + 3, "the loop stopped")
        assert self.counter[-1].data == stopped, "the request's data were not used"
        wait_for(lambda: self.enable(True), "no permission came through")
        self.peer.call("reset", "std_srvs/srv/Empty")
        wait_for(lambda: self.counter[-1].data < stopped, "the counter was not reset")

    def enable(self, value):
        return self.peer.call("enable", "std_srvs/srv/SetBool", "best_effort", data=value).success

    def check_action_server(self):
        """A goal gives feedback and a result; a goal can be cancelled, and replaced."""
        goal = self.peer.goal("compute", "test_msgs/action/Fibonacci", order=6)
        assert goal.result() == ("succeeded", [0, 1, 1, 2, 3, 5, 8]), goal.result()
        parts = [list(feedback.sequence) for feedback in goal.feedback]  # the first may be missed
        assert parts, "no feedback"
        assert parts == [[0, 1, 1, 2, 3, 5, 8][: len(part)] for part in parts], parts
        assert [len(part) for part in parts] == list(range(8 - len(parts), 8)), parts
        goal = self.peer.goal("compute", "test_msgs/action/Fibonacci", order=40)
        wait_for(lambda: goal.feedback, "no feedback")
        goal.cancel()
        assert goal.result()[0] == "canceled", goal.result()
        first = self.peer.goal("compute", "test_msgs/action/Fibonacci", order=40)
        wait_for(lambda: first.feedback, "no feedback")
        second = self.peer.goal("compute", "test_msgs/action/Fibonacci", order=3)
        assert second.result() == ("succeeded", [0, 1, 1, 2]), second.result()
        assert first.result()[0] in ("aborted", "canceled"), first.result()

    def check_action_client(self):
        """The worker sends a goal to a server of ours, once there is one."""
        self.spoken("delegate")
        wait_for(lambda: self.said("delegate lost"), "a missing action server was not noticed")
        self.peer.serve_action("delegate", "test_msgs/action/Fibonacci", sequence=[3, 1, 4])

        def delegated():
            self.spoken("delegate")
            return self.said("delegate succeeded [3, 1, 4]")

        wait_for(delegated, "no result of the delegated goal")

    def check_parameters(self):
        """Parameters are read, set and refused."""
        self.spoken("greet")
        assert self.said('it\'s "said" <so> & für immer [0.5, 1.0, 2000.0]'), self.said("it")
        assert self.peer.get_parameter("worker", "gain") == 1.5
        assert self.peer.set_parameter("worker", "gain", 4.0)
        assert self.peer.set_parameter("worker", "label", "boss")
        assert self.peer.set_parameter("worker", "verbose", True)
        self.peer.refuses("worker", "gain", 11.0, limit=10.0)
        self.peer.refuses("worker", "step", 0, limit=1)
        assert self.peer.set_parameter("worker", "gain", 4.0)

        def applied():
            self.say_speed(2.0)
            time.sleep(0.1)
            return self.status and self.status[-1].data == "boss 8 True"

        wait_for(applied, "the new parameters do not reach the logic")

    def check_blocking(self):
        """A callback that blocks stops neither the loop nor the other callbacks."""
        seen = len(self.counter)
        self.say.publish(self.peer.message("std_msgs/msg/String", data="block"))
        time.sleep(0.3)
        start = time.monotonic()
        self.peer.call("reset", "std_srvs/srv/Empty")
        goal = self.peer.goal("compute", "test_msgs/action/Fibonacci", order=3)
        assert goal.result()[0] == "succeeded"
        wait_for(lambda: len(self.counter) > seen + 15, "the loop stopped")
        assert time.monotonic() - start < 2.0, "other callbacks waited for the one that blocks"
        assert not self.said("block"), "the callback did not block"
        wait_for(lambda: self.said("block"), "the blocked callback never ended")

    def check_transforms(self):
        """The worker sends a transform, and finds ours."""
        if self.has_tf:
            x, y, z = wait_for(lambda: self.peer.lookup("map", "worker"), "no transform")
            assert (x, y, z) == (1.0, 2.0, 3.0), (x, y, z)

            def found():
                self.peer.send_transform("map", "target", (4.5, 0.0, 0.0))
                time.sleep(0.1)
                return self.said("target 4.5")

            wait_for(found, "the worker does not find a transform")

    def check_life_cycle(self):
        """A managed node obeys the standard services."""
        if not hasattr(self.peer, "change_state"):
            return
        assert self.peer.state("worker") == "active"
        assert self.peer.change_state("worker", "deactivate")
        time.sleep(0.3)
        seen = len(self.counter)
        time.sleep(0.5)
        assert len(self.counter) == seen, "an inactive node runs its loop"
        assert self.peer.state("worker") == "inactive"
        for transition, state in (
            ("cleanup", "unconfigured"),
            ("configure", "inactive"),
            ("activate", "active"),
        ):
            assert self.peer.change_state("worker", transition), transition
            assert self.peer.state("worker") == state
        wait_for(lambda: len(self.counter) > seen + 10, "the loop did not start again")
        wait_for(lambda: self.said("heard "), "the topics did not come back")
        self.spoken("again")

    def check_volume(self):
        """The subscriber that was added to the spec works with the logic that was there."""
        volume = self.peer.publisher("volume", "std_msgs/msg/Float64")
        wait_for(lambda: volume.connected(), "no subscriber of volume")
        volume.publish(self.peer.message("std_msgs/msg/Float64", data=7.5))
        wait_for(lambda: self.said("volume 7.5"), "volume does not reach the logic")


def main(ros, *options):
    peer = importlib.import_module(ros).Peer()
    scenario = Scenario(peer, "tf" in options)
    checks = [name for name in vars(Scenario) if name.startswith("check_")]
    if "volume" not in options:
        checks.remove("check_volume")
    for number, name in zip(itertools.count(1), checks):
        getattr(scenario, name)()
        print(f"{number}/{len(checks)} {name}", flush=True)
    peer.close()


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)  # whatever threads of ROS still run
