"""The logic of guard: it does what the test tells it, and traces what it hears."""

from contract.behaviour import Behaviour


class GuardImpl:
    def __init__(self, passthrough):
        self.run = Behaviour(
            "guard",
            {
                "fail": passthrough.fail,
                "sleep": lambda seconds: passthrough.sleep(float(seconds)),
            },
        ).run

    def configure(self, config):
        return self.run("configure")

    def activate(self):
        return self.run("activate")

    def update(self, data, config):
        if data.in_speed_updated:
            self.run("update", data.in_speed.data)

    def late_speed(self):
        self.run("late_speed")

    def receive_order(self, message):
        self.run("order", message.data)

    def late_order(self):
        self.run("late_order")

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
