# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The interface between ROS and the logic of contact_evaluate.

Generated from contact_analysis.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Callable

import builtin_interfaces.msg
from contact_analysis.ros.log import Log
from contact_analysis.ros.protocols import (
    Goal,
    Publisher,
)
import contact_msgs.action
import contact_msgs.msg
import contact_msgs.srv
import geometry_msgs.msg

# Types of messages, services and actions, under the same names in ROS 1 and ROS 2.
InCop = geometry_msgs.msg.Point
PubPlotLearnCop = contact_msgs.msg.PointArray
LoadRequest = contact_msgs.srv.SetString.Request
LoadResponse = contact_msgs.srv.SetString.Response
StoreRequest = contact_msgs.srv.SetString.Request
StoreResponse = contact_msgs.srv.SetString.Response
LearnGoalRequest = contact_msgs.action.LearnContact.Goal
LearnFeedback = contact_msgs.action.LearnContact.Feedback
LearnResult = contact_msgs.action.LearnContact.Result
LearnGoal = Goal[
    LearnGoalRequest,
    LearnFeedback,
    LearnResult,
]
EvaluateGoalRequest = contact_msgs.action.EvaluateContact.Goal
EvaluateFeedback = contact_msgs.action.EvaluateContact.Feedback
EvaluateResult = contact_msgs.action.EvaluateContact.Result
EvaluateGoal = Goal[
    EvaluateGoalRequest,
    EvaluateFeedback,
    EvaluateResult,
]


@dataclass(frozen=True)
class ContactEvaluateConfig:
    """A snapshot of the node's parameters."""

    # number of samples accumulated for learning
    samples: int = 200

    # Whether cop sampled should be published
    pub_sample: bool = True


class ContactEvaluateData:
    """
    The input and output messages of one cycle.

    in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
    """

    def __init__(self) -> None:
        """Create empty messages."""
        # Center of Pressure measured
        self.in_cop = InCop()
        self.in_cop_updated = False


@dataclass
class ContactEvaluatePassthrough:
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

    # Cops defining the latest contact
    pub_plot_learn_cop: Publisher[PubPlotLearnCop]
