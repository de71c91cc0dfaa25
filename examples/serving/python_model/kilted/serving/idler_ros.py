# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node idler: its lifecycle and its ROS interfaces.

Generated from serving.ros_package; the logic is in idler_impl.py.
"""

from __future__ import annotations

from typing import Any, Optional

from serving.idler_impl import IdlerImpl
from serving.idler_interface import (
    IdlerConfig,
    IdlerPassthrough,
)
from serving.ros.log import Log
from serving.ros.managed_node import ManagedNode
from serving.ros.process import run


class IdlerNode(ManagedNode):
    """A managed node that runs the callbacks of its logic while it is active."""

    def __init__(self, **options: Any) -> None:
        """Declare the parameters."""
        super().__init__('idler', **options)

    def _read_config(self) -> IdlerConfig:
        """Return the current parameters."""
        return IdlerConfig()

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = IdlerImpl(
            IdlerPassthrough(
                log=Log(self.get_logger()),
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
                fail=self.fail_because,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        # This node has none.


def main(args: Optional[list[str]] = None) -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run(IdlerNode, args)
