# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
Runs a node with a logic that obeys the test: recorder MODULE CLASS THREADS ARGUMENTS.

The node is in MODULE, CLASS is its logic; THREADS are the names of its threads, as in a,b.

A line of stdin, METHOD STEP=VALUE STEP..., says what to do when a method is called next; `now`, at
once. Calls and the results of steps are reported to stdout: name and value, in JSON. Messages are
serialized, in hexadecimal. Without an order nothing is published.
"""

from collections import defaultdict, deque
from dataclasses import is_dataclass
from functools import partial
from importlib import import_module
import json
from pathlib import Path
import sys
from threading import Event, Thread
from time import monotonic, sleep
from typing import get_args, get_type_hints

from builtin_interfaces.msg import Time
from rclpy.serialization import deserialize_message, serialize_message

LINES = open(0)  # not sys.stdin, which Python closes at its end while a thread reads it
ORDERS = defaultdict(deque)
TURNS = defaultdict(lambda: (0, 0.0, 0.0))  # how often; wall and ROS time of the last


def report(name, value=None):
    """Write a line for the test, in one call, as other threads write too."""
    sys.stdout.write(f'report {json.dumps([name, value])}\n')
    sys.stdout.flush()


def encode(message):
    """Return a message in hexadecimal, or None."""
    return None if message is None else serialize_message(message).hex()


def decode(text, message_type):
    """Return a message from hexadecimal."""
    return deserialize_message(bytes.fromhex(text), message_type)


class _Recorder:
    _current = None

    def __init__(self, passthrough):
        self.passthrough = passthrough
        self._config = None
        self._released = Event()
        self._taken = {}
        report('made')
        is_first = not _Recorder._current
        _Recorder._current = self
        if is_first:
            _Recorder._listen(until='\n')
            Thread(target=self._listen, daemon=True).start()

    @staticmethod
    def _listen(until=''):
        for method, *steps in map(str.split, iter(LINES.readline, until)):
            if method == 'now':
                _Recorder._current._do(steps)
            else:
                ORDERS[method].append(steps)
                report('order')

    def _called(self, method):
        return self._obey(method, self._thread())

    def _obey(self, method, call, item=None):
        steps = self._next(method)  # before the report, after which the test may order more
        report(method, call)
        return self._do(steps, item)

    @staticmethod
    def _thread():
        return Path('/proc/thread-self/comm').read_text().strip()

    @staticmethod
    def _next(method):
        return ORDERS[method].popleft() if ORDERS[method] else ()

    def _do(self, steps, item=None):
        for name, _, value in (step.partition('=') for step in steps):
            if name == 'refuse':
                return False
            report('begun', name)
            report(name, getattr(self, '_do_' + name.partition('_')[0])(name, value, item))
        return True

    def configure(self, config):
        self._record(config)
        return self._called('configure')

    def _record(self, config):
        self._config = config
        report('config', vars(config))

    def reconfigure(self, config):
        report('reconfigure', vars(config))
        if not self._do(self._next('reconfigure')):
            return 'told to refuse'
        self._record(config)
        return ''

    def activate(self):
        return self._called('activate')

    def deactivate(self):
        self._called('deactivate')

    def cleanup(self):
        self._called('cleanup')

    def update(self, data, config):
        self._count('update')
        steps = self._next('update')
        if config != self._config:
            self._record(config)
        for name, value in list(vars(data).items()):
            member, _, kind = name.rpartition('_')
            if kind == 'updated':  # new, or not the message of the cycle before
                text = encode(getattr(data, member))
                if value or text != self._taken.get(member, text):
                    report(member, text)
                self._taken[member] = text
            if kind == 'active' and f'{member}=' not in ' '.join(steps) and value is True:
                setattr(data, name, False)
        self._do(steps, data)

    def __getattr__(self, method):
        if method.startswith('late_'):
            return partial(self._called, method)
        is_called = method.startswith(('receive_', 'serve_', 'execute_', 'accept_'))
        return partial(self._call_back if is_called else self._take_turn, method)

    def _take_turn(self, method):
        self._count(method)
        if ORDERS[method]:
            self._called(method)
        if method in self.threads:
            self.passthrough.sleep(0.01)

    def _call_back(self, method, item, *response):
        if isinstance(item, str):  # a topic of several
            return self._call_back(f'{method}.{item}', *response)
        if is_dataclass(item):  # messages that belong together
            return self._obey(method, [encode(each) for each in vars(item).values()])
        call = encode(item.request if method.startswith('execute_') else item)
        responses = list(response)
        is_accepted = self._obey(method, call, responses or item)
        if not responses:
            return is_accepted
        return responses[0] if is_accepted else None

    def _do_raise(self, *_):
        raise SystemExit('told to raise')  # as sys.exit does, which is a failure like others

    def _do_block(self, *_):
        self._released.wait()
        return self._thread()

    def _do_release(self, *_):
        self._released.set()
        self._released = Event()

    def _do_wait(self, _, seconds, *__):
        sleep(float(seconds))

    def _do_sleep(self, _, seconds, *__):
        return self.passthrough.sleep(float(seconds))

    def _do_log(self, *_):
        log = self.passthrough.log
        log.debug('said as debug')
        log.info('said as info')
        log.warning('said as warning')
        log.error('said as error')
        log.debug_once('said once')
        log.info_once('said once')
        log.error_once('said once')
        log.warning_throttle(1e3, 'said once')

    def _do_fail(self, _, reason, *__):
        self.passthrough.fail(f'{reason}\nfor good')

    def _do_diagnose(self, _, value, *__):
        level, text = value.split(',')
        self.passthrough.diagnostics.set_hardware_id(text)
        self.passthrough.diagnostics.set('said', text)
        getattr(self.passthrough.diagnostics, level)(text)

    def _do_broadcaster(self, name, value, _, send='broadcast'):
        parent, child, x = value.split(',')
        member = getattr(self.passthrough, name)
        getattr(member, send)(parent, child, (float(x), 1.0, 2.0), (0.0, 0.6, 0.8, 0.0))

    def _do_static(self, name, *value):
        self._do_broadcaster(name.partition('_')[2], *value, 'broadcast_static')

    def _do_listener(self, name, value, _):
        target, source, *rest = value.split(',')
        listener = getattr(self.passthrough, name)
        times = [Time(sec=int(seconds)) for seconds in rest[1:]]
        found = listener.lookup(target, source, *map(float, rest[:1]), *times)
        return listener.reason or found.transform.translation.x

    def _count(self, method):
        stamp = self.passthrough.stamp()
        time = (self.passthrough.now() + stamp.sec + stamp.nanosec * 1e-9) / 2  # of both clocks
        TURNS[method] = TURNS[method][0] + 1, monotonic(), time

    def _do_turns(self, _, method, *__):
        return TURNS[method]

    def _do_subscribers(self, name, _, data):
        member = name.partition('_')[2]
        if data:
            return getattr(data, member + '_subscribers')
        return self._member(member)[0].subscriber_count()

    def _do_out(self, name, message, data):
        setattr(data, name, decode(message, type(getattr(data, name))))

    def _member(self, name):
        name, _, topic = name.partition('.')
        member = getattr(self.passthrough, name)
        hint = get_type_hints(type(self.passthrough))[name]
        if topic:
            return member[topic], get_args(get_args(hint)[1])[0]
        return member, get_args(hint)[0]

    def _do_pub(self, name, message, _):
        publisher, type_ = self._member(name)
        publisher.publish(decode(message, type_))

    def _do_response(self, _, message, responses):
        responses[0] = decode(message, type(responses[0]))

    def _do_client(self, name, value, _):
        client, type_ = self._member(name)
        request, *timeout = value.split(',')
        return encode(client.call(decode(request, type_), *map(float, timeout)))

    def _do_feedback(self, _, message, goal):
        goal.feedback = decode(message, type(goal.feedback))
        goal.publish_feedback()

    def _do_result(self, _, message, goal):
        goal.result = decode(message, type(goal.result))

    def _do_end(self, _, outcome, goal):
        getattr(goal, outcome)()

    def _do_await(self, _, __, goal):
        while not goal.cancel_requested:
            sleep(0.01)

    def _do_action(self, name, goal, _):
        client, type_ = self._member(name)
        return client.send_goal(decode(goal, type_)) if goal else client.cancel()

    def _do_state(self, name, *_):
        client, _ = self._member(name.partition('_')[2])
        return client.state, encode(client.feedback), encode(client.result)


if __name__ == '__main__':
    node = import_module(sys.argv.pop(1))
    setattr(node, sys.argv.pop(1), _Recorder)
    _Recorder.threads = sys.argv.pop(1).split(',')
    sys.exit(node.main())
