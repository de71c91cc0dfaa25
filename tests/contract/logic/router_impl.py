"""The logic of router: it does what the test tells it, and traces what it gets, and from where."""

from contract.behaviour import Behaviour
from std_msgs.msg import String


class RouterImpl:
    def __init__(self, passthrough):
        self.passthrough = passthrough
        commands = {"give": self.give, "topics": self.topics}
        self.run = Behaviour("router", commands).run

    def give(self, topic, text):
        self.passthrough.pub_give[topic].publish(String(data=text))

    def topics(self):
        return sorted(self.passthrough.pub_give)

    def configure(self, config):
        return self.run("configure", [*config.take_topics])

    def activate(self):
        return self.run("activate")

    def receive_take(self, topic, message):
        self.run("take", [topic, message.data])

    def deactivate(self):
        self.run("deactivate")

    def cleanup(self):
        self.run("cleanup")
