# Copyright 2019 My Company
# SPDX-License-Identifier: GPL-3.0-only

"""
The interface between ROS and the logic of contact_evaluate.

Generated from contact_analysis.ros_package; change the interface there.
"""

from dataclasses import dataclass
from typing import Any, Callable

import geometry_msgs.msg


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
    out_<topic>: the message to publish; out_<topic>_active: whether this cycle publishes it.
    """

    def __init__(self) -> None:
        """Create empty messages."""
        # Center of Pressure measured
        self.in_cop = geometry_msgs.msg.Point()
        self.in_cop_updated = False


@dataclass
class ContactEvaluatePassthrough:
    """Publishers, clients, transforms, clock and logger, for use in any method of the logic."""

    # The node's logger: log.debug(text), log.info, log.warning, log.error.
    log: Any

    # Returns the ROS time in seconds.
    now: Callable[[], float]

    # Returns the ROS time as a stamp for messages.
    stamp: Callable[[], Any]

    # Cops defining the latest contact
    # contact_msgs.msg.PointArray: pub_plot_learn_cop.publish(message)
    pub_plot_learn_cop: Any
