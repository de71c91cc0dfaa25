# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""
The node idler: its lifecycle and its ROS interfaces.

Generated from serving.ros_package; the logic is in idler_impl.py.
"""

from __future__ import annotations

from serving.idler_impl import IdlerImpl
from serving.idler_interface import (
    IdlerConfig,
    IdlerPassthrough,
)
from serving.managed_node import ManagedNode
from serving.process import run


class IdlerNode(ManagedNode):
    """A node that calls its logic back."""

    def __init__(self) -> None:
        """Read the parameters; everything else is created in configure."""
        super().__init__()
        self._config = IdlerConfig()

    def _configure(self) -> bool:
        """Configure the logic with the parameters."""
        return bool(self._impl.configure(self._config))

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        self._impl = IdlerImpl(
            IdlerPassthrough(
                log=self._log,
                now=self._time.now,
                stamp=self._time.stamp,
                sleep=self._time.sleep,
            ),
        )

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        # Nothing of this node receives.


def main() -> int:
    """Run the node until it is told to stop; return the exit code of the process."""
    return run('idler', IdlerNode)
