"""The logic of probe: it does what the test tells it."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import contract.places  # noqa: F401
from contract.behaviour import Behaviour
from contract.probe_interface import ActionDelegateGoal, ClientAskRequest
from std_msgs.msg import String


class ProbeImpl:
    def __init__(self, passthrough):
        self.passthrough = passthrough
        self.delegate = passthrough.action_delegate
        self.cycles = 0
        self.listeners = 0
        self.is_spoilt = False
        self.behaviour = Behaviour(
            "probe",
            {
                "publish": self.publish,
                "shout": lambda length: self.publish("x" * int(length)),
                "keep": self.keep,
                "call": self.call,
                "calls": self.calls,
                "send": self.send,
                "cancel": self.delegate.cancel,
                "state": lambda: self.delegate.state,
                "wait": self.wait,
                "goal": self.goal,
                "sleep": lambda seconds: self.passthrough.sleep(float(seconds)),
                "lookup": self.lookup,
                "rounds": self.rounds,
                "spoil": self.spoil,
                "fail": self.passthrough.fail,
                "later": self.later,
                "note": self.note,
                "listeners": lambda: [
                    self.listeners,
                    self.passthrough.pub_say.subscriber_count(),
                ],
            },
        )
        self.run = self.behaviour.run
        self.behaviour.at("constructor")

    def publish(self, text):
        self.passthrough.pub_say.publish(String(data=text))

    def keep(self, text):
        self.passthrough.pub_kept.publish(String(data=text))

    def note(self):
        """Log from the same lines each time."""
        self.passthrough.log.info("noted each time")
        self.passthrough.log.info_once("noted once")
        self.passthrough.log.warning_throttle(1.0, "noted seldom")
        self.passthrough.log.warning_once("noted once")

    def call(self, seconds):
        answer = self.passthrough.client_ask.call(ClientAskRequest(), timeout=float(seconds))
        return answer.message if answer else None

    def calls(self, count, seconds):
        """Call in as many threads at the same time; return how many have an answer."""
        with ThreadPoolExecutor(int(count)) as pool:
            answers = pool.map(self.call, [seconds] * int(count))
        return sum(answer is not None for answer in answers)

    def send(self, order):
        """Send a goal once there is a server, without waiting for its end."""
        end = time.monotonic() + 10.0
        while not self.delegate.is_ready() and time.monotonic() < end:
            if not self.passthrough.sleep(0.01):
                return False
        return self.delegate.send_goal(ActionDelegateGoal(order=int(order)))

    def wait(self, state):
        """Wait until the goal has left a state, as the logic should: until the node stops."""
        while self.delegate.state == state:
            if not self.passthrough.sleep(0.01):
                return "stopped"
        return self.delegate.state

    def goal(self, order):
        self.send(order)
        state = self.wait("pending")
        return self.wait("active") if state == "active" else state

    def lookup(self, target, source, seconds):
        listener = self.passthrough.listener_frames
        found = listener.lookup(target, source, float(seconds))
        return found.transform.translation.x if found else listener.reason

    def rounds(self, count):
        """Call, look up and send a goal, many times; return how many of each went well."""
        calls = goals = 0
        for _ in range(int(count)):
            calls += self.call(5.0) is not None
            goals += self.goal(1) == "succeeded"
            if hasattr(self.passthrough, "listener_frames"):
                self.passthrough.listener_frames.lookup("nowhere", "no_frame", 0.001)
        return [calls, goals]

    def spoil(self):
        """Have the results of goals be of a wrong type from now on, and services without any."""
        self.is_spoilt = True

    def later(self, seconds, reason):
        """Fail in another thread."""
        timer = threading.Timer(float(seconds), self.passthrough.fail, [reason])
        timer.daemon = True
        timer.start()

    def configure(self, config):
        if not config.accept:
            self.behaviour.trace("configure", "begin", config.accept)
            self.behaviour.trace("configure", "end", False)
        return config.accept and self.run("configure", config.accept)

    def activate(self):
        return self.run("activate")

    def update(self, data, config):
        self.cycles += 1
        data.out_count.data = self.cycles
        self.listeners = data.out_count_subscribers
        seen = {
            "number": data.in_number.data if data.in_number_updated else None,
            "map": data.in_map.data if data.in_map_updated else None,
            "gain": config.gain,
        }
        self.run("update", seen)

    def receive_hear(self, message):
        self.run("receive", message.data)

    def serve_serve(self, request, response):
        self.run("serve")
        response.success = True
        response.message = "served"
        return None if self.is_spoilt else response

    def execute_work(self, goal):
        self.execute("work", goal)

    def execute_line(self, goal):
        self.execute("line", goal)

    def execute_single(self, goal):
        self.execute("single", goal)

    def execute_choice(self, goal):
        self.execute("choice", goal)

    def execute_crowd(self, goal):
        self.execute("crowd", goal)

    def accept_choice(self, request):
        return self.run("accept", request.order)

    def execute(self, name, goal):
        """Succeed at once, or, if the order is above 100, when a cancel is asked for.

        Of order 66, raise then.
        """
        order = goal.request.order
        goal.feedback.sequence = [order]
        goal.publish_feedback()
        self.run(name, order)
        while order > 100 and not goal.cancel_requested:
            time.sleep(0.01)
        self.behaviour.trace(name, "over", order)
        goal.result.sequence = ["spoilt"] if self.is_spoilt else [order]
        if order > 100:
            goal.canceled()
        elif order > 0:
            goal.succeed()
        if order == 66:
            raise RuntimeError("told to raise")

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
