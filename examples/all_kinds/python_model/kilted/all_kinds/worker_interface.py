# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The interface between ROS and the logic of worker.

Generated from all_kinds.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Any, Callable, Sequence

from all_kinds.action_client import ActionClient
from all_kinds.service_client import ServiceClient
from all_kinds.transforms import TransformBroadcaster, TransformListener
import geometry_msgs.msg
import std_msgs.msg


@dataclass(frozen=True)
class WorkerConfig:
    """A snapshot of the node's parameters."""

    # What stands before a status, e.g. "a" < 'b' and so on
    prefix: str = 'it\'s "said" <so> & für immer'

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
    """

    def __init__(self) -> None:
        """Create empty messages."""
        # Wanted speed
        self.in_speed = geometry_msgs.msg.Twist()
        self.in_speed_updated = False
        # Its own counter, heard again
        self.in_counter = std_msgs.msg.Int64()
        self.in_counter_updated = False
        # Cycles since the start
        self.out_counter = std_msgs.msg.Int64()
        self.out_counter_active = True
        # What the worker does
        self.out_status = std_msgs.msg.String()
        self.out_status_active = True


@dataclass
class WorkerPassthrough:
    """Publishers, clients, transforms, clock and logger, for use in any method of the logic."""

    # The node's logger: log.debug(text), log.info, log.warning, log.error.
    log: Any

    # Returns the ROS time in seconds.
    now: Callable[[], float]

    # Returns the ROS time as a stamp for messages.
    stamp: Callable[[], Any]

    # What was said, said again
    # std_msgs.msg.String: pub_echo.publish(message)
    pub_echo: Any

    # Nothing, as a message
    # std_msgs.msg.Empty: pub_empty.publish(message)
    pub_empty: Any

    # Asks whether it may work
    # std_srvs.srv.Trigger
    client_permit: ServiceClient

    # Lets another compute
    # test_msgs.action.Fibonacci
    action_delegate: ActionClient

    # Finds the worker
    listener_frames: TransformListener

    # Says where the worker is
    broadcaster_pose: TransformBroadcaster
