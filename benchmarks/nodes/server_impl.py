"""The logic of the node server."""

from bench.record import Record
from bench.server_interface import (
    ComputeGoal,
    ServerConfig,
    ServerPassthrough,
    SetRequest,
    SetResponse,
    ValuesMessage,
)


class ServerImpl:
    """Records the messages that it receives, and serves."""

    def __init__(self, passthrough: ServerPassthrough) -> None:
        """Start the record."""
        self.record = Record()

    def configure(self, config: ServerConfig) -> bool:
        """Accept."""
        return True

    def activate(self) -> bool:
        """Accept."""
        return True

    def receive_values(self, message: ValuesMessage) -> None:
        """Record a message."""
        self.record.message(message.data[0])

    def serve_set(self, request: SetRequest, response: SetResponse) -> SetResponse:
        """Succeed."""
        response.success = request.data
        return response

    def execute_compute(self, goal: ComputeGoal) -> None:
        """Succeed."""
        goal.result.sequence = [goal.request.order]
        goal.succeed()

    def deactivate(self) -> None:
        """Save the record."""
        self.record.save()

    def cleanup(self) -> None:
        """Nothing to clean up."""
