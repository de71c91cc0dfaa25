"""The logic of gauge: it does what the test tells it."""

import threading

from contract.behaviour import Behaviour


class GaugeImpl:
    def __init__(self, passthrough):
        self.status = passthrough.diagnostics
        self.run = Behaviour("gauge", {"fail": passthrough.fail, "diagnose": self.diagnose}).run

    def diagnose(self, level, text, number):
        """Say all that can be said, beside the thread of the logic."""
        other = threading.Thread(target=self.status.set, args=("number", int(number)))
        other.start()
        other.join()
        self.status.set("is_said", True)
        self.status.set_hardware_id(text)
        getattr(self.status, level)(text)

    def configure(self, config):
        return self.run("configure")

    def activate(self):
        return self.run("activate")

    def update(self, data, config):
        self.run("update", {"gain": config.gain})

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
