# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
What the logic of contact_evaluate sees of ROS.

Generated from contact_analysis.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Any, Callable

import geometry_msgs.msg


@dataclass(frozen=True)
class ContactEvaluateConfig:
    """The parameters, as they are at one moment."""

    # number of samples accumulated for learning
    samples: int = 200

    # Whether cop sampled should be published
    pub_sample: bool = True


class ContactEvaluateData:
    """
    The messages of one cycle.

    in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
    out_<topic>: the message to send; out_<topic>_active: whether to send it in this cycle.
    """

    def __init__(self) -> None:
        """Start with empty messages."""
        # Center of Pressure measured
        self.in_cop = geometry_msgs.msg.Point()
        self.in_cop_updated = False


@dataclass
class ContactEvaluatePassthrough:
    """What the logic may use at any time, from any of its methods."""

    # Writes to the log of ROS: log.debug(text), info, warning, error.
    log: Any

    # Returns the time of ROS in seconds.
    now: Callable[[], float]

    # Returns the time of ROS as messages carry it.
    stamp: Callable[[], Any]

    # Cops defining the latest contact
    # contact_msgs.msg.PointArray: pub_plot_learn_cop.publish(message)
    pub_plot_learn_cop: Any
