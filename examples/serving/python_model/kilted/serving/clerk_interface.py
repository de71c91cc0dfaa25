# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of clerk.

Generated from serving.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable

import builtin_interfaces.msg
from serving.ros.log import Log
from serving.ros.protocols import (
    Goal,
)
import std_srvs.srv
import test_msgs.action

# Types of messages, services and actions, under the same names in ROS 1 and ROS 2.
GreetRequest = std_srvs.srv.Trigger.Request
GreetResponse = std_srvs.srv.Trigger.Response
OpenRequest = std_srvs.srv.SetBool.Request
OpenResponse = std_srvs.srv.SetBool.Response
CountGoalRequest = test_msgs.action.Fibonacci.Goal
CountFeedback = test_msgs.action.Fibonacci.Feedback
CountResult = test_msgs.action.Fibonacci.Result
CountGoal = Goal[
    CountGoalRequest,
    CountFeedback,
    CountResult,
]


@dataclass(frozen=True)
class ClerkConfig:
    """A snapshot of the node's parameters."""

    # What to say
    greeting: str = 'hello'

    # Time for a step, s
    patience: float = 0.5


@dataclass
class ClerkPassthrough:
    """What the logic can use of ROS, in any of its methods."""

    # The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
    # log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
    log: Log

    # Returns the ROS time in seconds.
    now: Callable[[], float]

    # Returns the ROS time as a stamp for messages.
    stamp: Callable[[], builtin_interfaces.msg.Time]

    # Waits that many seconds of ROS time; returns False at once when the node stops.
    sleep: Callable[[float], bool]

    # Stops the node with an error, as an exception would, from any thread; logs the reason.
    fail: Callable[[str], None]
