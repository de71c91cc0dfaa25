"""What the peers of both ROS share."""

import importlib
import threading
import time

TIMEOUT = 10.0


def load(type_name, suffix=""):
    package, folder, name = type_name.split("/")
    return getattr(importlib.import_module(f"{package}.{folder}"), name + suffix)


def wait_for(condition, what, timeout=TIMEOUT):
    end = time.monotonic() + timeout
    while True:
        value = condition()
        if value:
            return value
        assert time.monotonic() < end, what
        time.sleep(0.005)


def later(seconds, callback):
    """Return a callback that takes that long to begin."""

    def late(*arguments):
        time.sleep(seconds)
        return callback(*arguments)

    return late


class Heard:
    """The messages of a topic, with the times they came; a value for a message of one field."""

    def __init__(self):
        self.messages = []

    def take(self, message):
        data = message.data if hasattr(message, "data") else plain(message)
        self.messages.append([time.monotonic(), data])


def plain(message):
    """Return a message as JSON has it."""
    if isinstance(message, (list, tuple)):
        return [plain(item) for item in message]
    if isinstance(message, (bytes, bytearray)):
        return message[0] if len(message) == 1 else list(message)
    if hasattr(message, "__slots__"):
        names = [name.lstrip("_") for name in message.__slots__ if "check_fields" not in name]
        return {name: plain(getattr(message, name)) for name in names}
    return message if isinstance(message, (int, float, str)) else str(message)


class Served:
    """A service or action: what came, and how long an answer takes."""

    def __init__(self, seconds, feedback=0):
        self.seconds = seconds
        self.feedback = feedback
        self.log = []
        self.ended = threading.Event()

    def note(self, *event):
        self.log.append(event)

    def work(self, is_cancelled):
        """Work for that long; return whether it came to its end."""
        end = time.monotonic() + self.seconds
        while time.monotonic() < end:
            if is_cancelled():
                return False
            time.sleep(0.005)
        return True
