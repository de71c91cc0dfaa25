"""The logic of joiner: it does what the test tells it, and traces what it gets."""

from contract.behaviour import Behaviour


class JoinerImpl:
    def __init__(self, passthrough):
        self.run = Behaviour("joiner", {"fail": passthrough.fail}).run

    def configure(self, config):
        return self.run("configure")

    def activate(self):
        return self.run("activate")

    def receive_exact(self, messages):
        self.run("exact", [messages.left.point.x, messages.right.point.x])

    def receive_near(self, messages):
        self.run("near", [messages.left.point.x, messages.other.point.x, messages.third.point.x])

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
