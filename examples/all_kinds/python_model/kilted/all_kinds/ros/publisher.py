# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A publisher of the logic."""

from typing import Any


class Publisher:
    """Publishes messages to a topic."""

    def __init__(self, publisher: Any) -> None:
        """Wrap a publisher of rclpy."""
        self._publisher = publisher

    def publish(self, message: Any, /) -> None:
        """Publish a message."""
        self._publisher.publish(message)

    def subscriber_count(self) -> int:
        """Return how many subscribe to the topic."""
        return int(self._publisher.get_subscription_count())
