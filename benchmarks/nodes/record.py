"""What a measured node does with its time, for the program that measures it."""

import os
from array import array
from time import monotonic


class Record:
    """Keeps when cycles ran, and when messages were sent and came, until they are saved."""

    def __init__(self):
        """Start empty."""
        self.cycles = array("d")
        self.messages = array("d")

    def cycle(self):
        """Record a cycle; return the time."""
        now = monotonic()
        self.cycles.append(now)
        return now

    def message(self, sent):
        """Record a message."""
        self.messages.extend((sent, monotonic()))

    def save(self):
        """Write all times, one a line: of cycles, then of messages."""
        with open(os.environ["BENCH_RECORD"], "w") as file:
            for name, times in (("cycle", self.cycles), ("message", self.messages)):
                file.write("".join(f"{name} {time:.9f}\n" for time in times))
