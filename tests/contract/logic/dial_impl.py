"""The logic of dial: it does what the test tells it."""

from dataclasses import asdict

from contract.behaviour import Behaviour


class DialImpl:
    def __init__(self, passthrough):
        self.run = Behaviour("dial", {}).run

    def configure(self, config):
        return self.run("configure", asdict(config))

    def activate(self):
        return self.run("activate")

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
