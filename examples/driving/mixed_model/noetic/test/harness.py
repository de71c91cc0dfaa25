# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
A harness for tests of the logic without ROS: fakes that record, and a clock that one sets.

    ros = fake(DriverPassthrough)
    ros.clock.time = 12.0  # seconds
    impl = DriverImpl(ros)
    data = run_cycle(impl, in_speed=Twist())
    data.out_throttle, ros.log.lines
"""

from typing import get_origin, get_type_hints

from driving import protocols


class Clock:
    """A clock that moves only when the test sets it or the logic sleeps."""

    __slots__ = ('time', 'stopped')

    def __init__(self):
        """Start at 0 s, in a node that does not stop."""
        self.time = 0.0
        self.stopped = False

    def now(self):
        """Return the time in seconds."""
        return self.time

    def stamp(self):
        """Return the time as a stamp for messages."""
        seconds, fraction = divmod(self.time, 1.0)
        return protocols.Stamp(int(seconds), int(fraction * 1e9))

    def sleep(self, seconds):
        """Let the time pass at once, unless the node stops."""
        if not self.stopped:
            self.time += seconds
        return not self.stopped


class FakeLog:
    """Records lines of the log: pairs of a level and a text."""

    __slots__ = ('lines',)

    def __init__(self):
        """Start without lines."""
        self.lines = []

    def debug(self, text):
        """Record a line."""
        self.lines.append(('debug', text))

    def info(self, text):
        """Record a line."""
        self.lines.append(('info', text))

    def warning(self, text):
        """Record a line."""
        self.lines.append(('warning', text))

    def error(self, text):
        """Record a line."""
        self.lines.append(('error', text))


FAKES = {
    protocols.Log: FakeLog,
}


def fake(passthrough_type):
    """Return a passthrough of fakes, with the `clock` that they go by."""
    clock = Clock()
    members = {'now': clock.now, 'stamp': clock.stamp, 'sleep': clock.sleep}
    for name, type_ in get_type_hints(passthrough_type).items():
        if name not in members:
            members[name] = FAKES[get_origin(type_) or type_]()
    passthrough = passthrough_type(**members)
    passthrough.clock = clock
    return passthrough


def run_cycle(impl, data=None, config=None, **messages):
    """
    Run one cycle as the node does and return its data.

    messages: those received, as in in_speed=Twist(); names that the node lacks are refused.
    data: that of the cycle before, to go on from there. config: by default, that of the spec.
    """
    types = get_type_hints(impl.update)
    data = types['data']() if data is None else data
    config = types['config']() if config is None else config
    fields = dict(vars(data))
    for name, message in messages.items():
        if name not in fields or not isinstance(message, type(fields[name])):
            raise TypeError(f'{name} is not received, or not as a {type(message).__name__}.')
    for name, value in fields.items():
        if isinstance(value, bool):
            setattr(data, name, name.endswith('_active') or name[: -len('_updated')] in messages)
    vars(data).update(messages)
    impl.update(data, config)
    if vars(data).keys() != fields.keys():
        raise AttributeError(f'The data has no {vars(data).keys() - fields.keys()}.')
    return data
