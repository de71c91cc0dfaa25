"""
Places in the package where a test can hold a thread: before and after some of its functions.

A moment between two threads becomes as long as the test likes.
"""

import contextlib
from functools import wraps
from threading import current_thread

from contract.behaviour import Behaviour
from contract.ros.action_client import SentGoal
from contract.ros.action_server import Goal
from contract.ros.managed_node import ManagedNode
from contract.ros.stop import Stop

_places = Behaviour("places", {})


def add(owner, name, label):
    """Have a method do what the places before and after it are told."""
    method = getattr(owner, name)

    @wraps(method)
    def between_places(*arguments, **options):
        place = label()
        _places.at(f"before {place}")
        result = method(*arguments, **options)
        _places.at(f"after {place}")
        return result

    setattr(owner, name, between_places)


def thread():
    """Return the name of a thread of the package; "ros" for those that call it back."""
    name = current_thread().name
    return (
        name if name in ("MainThread", "logic", "transitions", "work", "line", "single") else "ros"
    )


add(ManagedNode, "__init__", lambda: "creating the node")
add(SentGoal, "is_under_way", lambda: f"looking at the goal in {thread()}")
add(SentGoal, "_end", lambda: "the end of the goal")
add(Goal, "replace", lambda: "replacing")
if hasattr(Goal, "end"):
    add(Goal, "end", lambda: "telling the outcome")
Stop.asks = Stop.requested.fget
add(Stop, "asks", lambda: f"asking for the stop in {thread()}")
Stop.requested = property(Stop.asks)

with contextlib.suppress(KeyboardInterrupt):
    _places.at("importing")
