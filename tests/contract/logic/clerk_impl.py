"""The logic of clerk: it does what the test tells it."""

from contract.behaviour import Behaviour
from std_msgs.msg import String


class ClerkImpl:
    def __init__(self, passthrough):
        self.say = passthrough.pub_say
        self.run = Behaviour(
            "clerk",
            {
                "publish": lambda text: self.say.publish(String(data=text)),
                "sleep": lambda seconds: passthrough.sleep(float(seconds)),
            },
        ).run

    def configure(self, config):
        return self.run("configure")

    def activate(self):
        return self.run("activate")

    def serve_greet(self, request, response):
        self.run("serve")
        response.success = True
        response.message = "greeted"
        return response

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
