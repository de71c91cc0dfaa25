"""The logic of clerk: it does what the test tells it."""

from contract.behaviour import Behaviour
from std_msgs.msg import String


class ClerkImpl:
    def __init__(self, passthrough):
        self.say = passthrough.pub_say
        self.sleep = passthrough.sleep
        self.node = passthrough.node
        self.door = None
        self.run = Behaviour(
            "clerk",
            {
                "publish": lambda text: self.say.publish(String(data=text)),
                "open": self.open,
                "fail": passthrough.fail,
                "sleep": lambda seconds: passthrough.sleep(float(seconds)),
            },
        ).run

    def open(self, text):
        """Publish by the client library, on a topic that the spec does not know."""
        if self.door is None and hasattr(self.node, "create_publisher"):
            self.door = self.node.create_publisher(String, "door", 1)
        elif self.door is None:
            self.door = self.node.Publisher("door", String, queue_size=1)
        self.door.publish(String(data=text))

    def configure(self, config):
        return self.run("configure")

    def reconfigure(self, config):
        return "" if self.run("reconfigure", config.pace) else "told to refuse"

    def activate(self):
        return self.run("activate")

    def serve_greet(self, request, response):
        self.run("serve")
        response.success = True
        response.message = "greeted"
        return response

    def read(self):
        self.run("read")
        self.sleep(0.02)

    def poll(self):
        self.run("poll")

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
