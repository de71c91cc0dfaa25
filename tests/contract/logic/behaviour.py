"""
What the logic does: as a file tells it, and each step written to another file.

The file of $CONTRACT_BEHAVIOUR has a line for each thing to do, `method: command argument ...`;
`once method: ...` is done once in the life of the process. It is read at each call, so that a test
can change it; "\\n" in an argument is a new line. The file of $CONTRACT_TRACE gets a line of JSON
for each event.
"""

import json
import os
import threading
import time

_done = set()
_number = 0
_lock = threading.Lock()


class Behaviour:
    """Does what one logic object is told."""

    def __init__(self, node, commands):
        global _number
        _number += 1
        self._node = node
        self._logic = _number
        self._commands = {"block": self._block, "hold": self._hold, "throw": self._throw}
        self._commands |= commands

    def run(self, method, seen=None):
        """Do what a method is told; return whether it accepts."""
        self.trace(method, "begin", seen)
        try:
            accepted = self._carry_out(method)
        except BaseException as error:
            self.trace(method, "raised", str(error))
            raise
        self.trace(method, "end", accepted)
        return accepted

    def at(self, place):
        """Do what a place in the node is told, which is mostly nothing and not traced then."""
        lines = self._all_told().splitlines()
        if {place, "once " + place} & {line.partition(": ")[0] for line in lines}:
            self.run(place)

    def _carry_out(self, method):
        accepted = True
        for command, *arguments in self._told(method):
            if command == "refuse":
                accepted = False
            elif command in self._commands:
                self.trace(method, command, self._commands[command](*arguments))
            else:
                raise ValueError(f"no command {command}")
        return accepted

    def trace(self, method, event, value=None):
        with open("/proc/thread-self/comm") as comm:
            thread = comm.read().strip()
        line = {
            "node": self._node,
            "logic": self._logic,
            "method": method,
            "event": event,
            "value": value,
            "thread": thread,
            "id": threading.get_native_id(),
            "time": time.monotonic(),
        }
        file = os.open(os.environ["CONTRACT_TRACE"], os.O_WRONLY | os.O_APPEND | os.O_CREAT)
        os.write(file, (json.dumps(line) + "\n").encode())
        os.close(file)

    def _all_told(self):
        with open(os.environ["CONTRACT_BEHAVIOUR"]) as file:
            return file.read()

    def _told(self, method):
        for line in self._all_told().splitlines():
            when, _, what = line.partition(": ")
            if when == "once " + method:
                with _lock:
                    if line in _done:
                        continue
                    _done.add(line)
                yield self._words(what)
            elif when == method:
                yield self._words(what)

    @staticmethod
    def _words(what):
        return [word.replace(r"\n", "\n") for word in what.split()]

    def _block(self, seconds):
        """Wait as nobody should: nothing ends it."""
        time.sleep(float(seconds))

    def _hold(self, what=""):
        """Wait until the test tells something else, or no longer to hold this."""
        before = self._all_told()
        while f"hold {what}" in self._all_told() if what else self._all_told() == before:
            time.sleep(0.01)

    def _throw(self, text="thrown on purpose"):
        raise RuntimeError(text)
