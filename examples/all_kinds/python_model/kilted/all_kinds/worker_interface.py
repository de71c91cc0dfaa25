# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of worker.

Generated from all_kinds.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable, Mapping, Sequence

from all_kinds.ros.log import Log
from all_kinds.ros.logic_status import LogicStatus
from all_kinds.ros.protocols import (
    ActionClient,
    Goal,
    Publisher,
    ServiceClient,
    TransformBroadcaster,
    TransformListener,
)
import builtin_interfaces.msg
import geometry_msgs.msg
import std_msgs.msg
import std_srvs.srv
import test_msgs.action

# Types of messages, services and actions, under the same names in ROS 1 and ROS 2.
InSpeed = geometry_msgs.msg.Twist
InCounter = std_msgs.msg.Int64
OutCounter = std_msgs.msg.Int64
OutStatus = std_msgs.msg.String
PubEcho = std_msgs.msg.String
PubEmpty = std_msgs.msg.Empty
PubAnswer = std_msgs.msg.String
SayMessage = std_msgs.msg.String
CallMessage = std_msgs.msg.String
SightingPoint = geometry_msgs.msg.PointStamped
SightingMotion = geometry_msgs.msg.TwistStamped
ClientPermitRequest = std_srvs.srv.Trigger.Request
ClientPermitResponse = std_srvs.srv.Trigger.Response
ResetRequest = std_srvs.srv.Empty.Request
ResetResponse = std_srvs.srv.Empty.Response
EnableRequest = std_srvs.srv.SetBool.Request
EnableResponse = std_srvs.srv.SetBool.Response
ActionDelegateGoal = test_msgs.action.Fibonacci.Goal
ActionDelegateFeedback = test_msgs.action.Fibonacci.Feedback
ActionDelegateResult = test_msgs.action.Fibonacci.Result
ComputeGoalRequest = test_msgs.action.Fibonacci.Goal
ComputeFeedback = test_msgs.action.Fibonacci.Feedback
ComputeResult = test_msgs.action.Fibonacci.Result
ComputeGoal = Goal[
    ComputeGoalRequest,
    ComputeFeedback,
    ComputeResult,
]
MeasureGoalRequest = test_msgs.action.Fibonacci.Goal
MeasureFeedback = test_msgs.action.Fibonacci.Feedback
MeasureResult = test_msgs.action.Fibonacci.Result
MeasureGoal = Goal[
    MeasureGoalRequest,
    MeasureFeedback,
    MeasureResult,
]


@dataclass(frozen=True)
class WorkerConfig:
    """A snapshot of the node's parameters."""

    # What stands before a status, e.g. "a" < 'b' and so on
    prefix: str = 'it\'s "said" <so> & für immer'

    # Where things are said again
    echo_topic: str = 'echo'

    # Where to listen for calls
    call_topics: Sequence[str] = ('hall/call', '~/call')

    # Where to answer
    answer_topics: Sequence[str] = ('hall/answer', '/answer')

    # Weights of the inputs
    weights: Sequence[float] = (0.5, 1.0, 2000.0)

    # Gain of the output
    gain: float = 1.5

    # How far to count in a cycle
    step: int = 1

    # Whether to say more
    verbose: bool = False

    # Name in the status
    label: str = 'worker'


class WorkerData:
    """
    The input and output messages of one cycle.

    in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
    out_<topic>: the message to publish; out_<topic>_active: whether this cycle publishes it.
    out_<topic>_subscribers: how many subscribe to it.
    """

    def __init__(self) -> None:
        """Create empty messages."""
        # Wanted speed
        self.in_speed = InSpeed()
        self.in_speed_updated = False
        # Its own counter, heard again
        self.in_counter = InCounter()
        self.in_counter_updated = False
        # Cycles since the start
        self.out_counter = OutCounter()
        self.out_counter_active = True
        self.out_counter_subscribers = 0
        # What the worker does
        self.out_status = OutStatus()
        self.out_status_active = True
        self.out_status_subscribers = 0


@dataclass(frozen=True)
class SightingMessages:
    """Messages whose stamps belong together, for receive_sighting."""

    # What is seen
    point: SightingPoint

    # How the worker moves
    motion: SightingMotion


@dataclass
class WorkerPassthrough:
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

    # What the logic says of itself on /diagnostics, from any thread.
    diagnostics: LogicStatus

    # What was said, said again
    pub_echo: Publisher[PubEcho]

    # Nothing, as a message
    pub_empty: Publisher[PubEmpty]

    # What is answered in each room
    # A publisher for each name in config.answer_topics.
    pub_answer: Mapping[str, Publisher[PubAnswer]]

    # Asks whether it may work
    client_permit: ServiceClient[
        ClientPermitRequest,
        ClientPermitResponse,
    ]

    # Lets another compute
    action_delegate: ActionClient[
        ActionDelegateGoal,
        ActionDelegateFeedback,
        ActionDelegateResult,
    ]

    # Finds the worker
    listener_frames: TransformListener

    # Says where the worker is
    broadcaster_pose: TransformBroadcaster
