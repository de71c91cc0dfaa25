# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
Tests of the logic without ROS: fakes that record, and a clock that the test sets.

    ros = fake(DriverPassthrough)
    ros.clock.time = 12.0  # seconds
    ros.client_permit.response = ClientPermitResponse(success=True)
    impl = DriverImpl(ros)
    data = run_cycle(impl, in_speed=Twist())
    data.out_throttle, ros.pub_echo.published, ros.client_permit.requests, ros.log.lines

    goal = FakeGoal(MoveGoal, distance=1.0)
    impl.execute_move(goal)
    goal.outcome, goal.result, goal.published
"""

from collections import defaultdict
from collections.abc import Mapping
from copy import deepcopy
from functools import partial
from types import SimpleNamespace
from typing import get_args, get_origin, get_type_hints

from all_kinds.ros.log import Log
from all_kinds.ros.logic_status import LogicStatus
import all_kinds.ros.protocols as protocols
import rospy


class Clock:
    """A clock that moves only when the test sets it or the logic sleeps."""

    __slots__ = ('time', 'stopped')  # a misspelt name is refused

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
        return rospy.Time(int(seconds), int(fraction * 1e9))

    def sleep(self, seconds):
        """Advance the clock without waiting, unless the node stops."""
        if not self.stopped:
            self.time += seconds
        return not self.stopped


class FakeLog(Log):
    """Records lines of the log: pairs of a level and a text."""

    def __init__(self):
        """Start without lines."""
        self.lines = []
        levels = ('debug', 'info', 'warning', 'error')
        super().__init__(SimpleNamespace(**{each: partial(self._record, each) for each in levels}))

    def _record(self, level, text):
        self.lines.append((level, text))


class FakePublisher:
    """Records messages; the test sets how many `subscribers` there are."""

    __slots__ = ('published', 'subscribers')

    def __init__(self):
        """Start without messages and subscribers."""
        self.published = []
        self.subscribers = 0

    def publish(self, message):
        """Record a message as it is now."""
        self.published.append(deepcopy(message))

    def subscriber_count(self):
        """Return how many subscribers the test has set."""
        return self.subscribers


class FakeServiceClient:
    """Records requests, and answers each with `response`; with None there is no server."""

    __slots__ = ('requests', 'response')

    def __init__(self):
        """Start without a server."""
        self.requests = []
        self.response = None

    def is_ready(self):
        """Return whether there is a response to give."""
        return self.response is not None

    def call(self, request, timeout=1.0):
        """Record a request and return the response."""
        self.requests.append(deepcopy(request))
        return self.response


class FakeActionClient:
    """Records goals; the test sets `ready`, and `state`, `feedback` and `result` of the goal."""

    __slots__ = ('goals', 'cancels', 'ready', 'state', 'feedback', 'result')

    def __init__(self):
        """Start with a server and without a goal."""
        self.goals = []
        self.cancels = 0
        self.ready = True
        self.state = 'idle'
        self.feedback = None
        self.result = None

    def is_ready(self):
        """Return whether a server is available."""
        return self.ready

    def send_goal(self, goal):
        """Record a goal and make it pending."""
        self.goals.append(deepcopy(goal))
        self.feedback = None
        self.result = None
        self.state = 'pending' if self.ready else 'lost'
        return self.ready

    def cancel(self):
        """Count a cancel."""
        self.cancels += 1


class FakeGoal:
    """A goal for execute_<action>: FakeGoal(MoveGoal, distance=1.0); `published` is feedback."""

    __slots__ = ('request', 'feedback', 'result', 'published', 'outcome', 'cancel_requested')

    def __init__(self, goal_type, **fields):
        """Create a goal of a type of the interface, with fields of its request."""
        request, feedback, result = get_args(goal_type)
        self.request = request()
        for name, value in fields.items():
            setattr(self.request, name, value)
        self.feedback = feedback()
        self.result = result()
        self.published = []
        self.outcome = None
        self.cancel_requested = False

    def publish_feedback(self):
        """Record the feedback as it is now."""
        self.published.append(deepcopy(self.feedback))

    def succeed(self):
        """Record the outcome."""
        self.outcome = 'succeeded'

    def abort(self):
        """Record the outcome."""
        self.outcome = 'aborted'

    def canceled(self):
        """Record the outcome."""
        self.outcome = 'canceled'


class FakeTransformListener:
    """Finds what the test puts into `transforms`, by pairs of target and source."""

    __slots__ = ('transforms', 'reason')

    def __init__(self):
        """Start without transforms."""
        self.transforms = {}
        self.reason = ''

    def lookup(self, target, source, timeout=0.0, stamp=None):
        """Return the transform of two frames, or None."""
        found = self.transforms.get((target, source))
        self.reason = '' if found else f'There is no transform from {source} to {target}.'
        return found


class FakeTransformBroadcaster:
    """Records transforms: (parent, child, translation, rotation), or messages."""

    __slots__ = ('sent', 'sent_static')

    def __init__(self):
        """Start without transforms."""
        self.sent = []
        self.sent_static = []

    def broadcast(self, parent, child, translation, rotation):
        """Record a pose."""
        self.sent.append((parent, child, translation, rotation))

    def broadcast_static(self, parent, child, translation, rotation):
        """Record a pose that never changes."""
        self.sent_static.append((parent, child, translation, rotation))

    def send(self, transform):
        """Record a transform."""
        self.sent.append(deepcopy(transform))

    def send_static(self, transform):
        """Record a static transform."""
        self.sent_static.append(deepcopy(transform))


FAKES = {
    LogicStatus: LogicStatus,
    protocols.Publisher: FakePublisher,
    protocols.ServiceClient: FakeServiceClient,
    protocols.ActionClient: FakeActionClient,
    protocols.TransformListener: FakeTransformListener,
    protocols.TransformBroadcaster: FakeTransformBroadcaster,
}


def fake(passthrough_type):
    """Return a passthrough of fakes; `clock` gives the time, `failures` has those reported."""
    clock, failures = Clock(), []
    members = {'log': FakeLog(), 'now': clock.now, 'stamp': clock.stamp, 'sleep': clock.sleep}
    members['fail'] = failures.append
    for name, type_ in get_type_hints(passthrough_type).items():
        if get_origin(type_) is Mapping:  # each is made when the test or the logic asks
            members[name] = defaultdict(FakePublisher)
        if name not in members:
            members[name] = FAKES[get_origin(type_) or type_]()
    passthrough = passthrough_type(**members)
    passthrough.clock = clock
    passthrough.failures = failures
    return passthrough


def run_cycle(impl, data=None, config=None, **messages):
    """
    Run one cycle as the node does and return its data.

    messages: the messages received, such as in_speed=Twist(); unknown names are refused.
    data: that of the cycle before, or new data. config: by default, that of the spec.
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
