"""The logic of the node relay."""

from bench.record import Record
from bench.relay_interface import RelayConfig, RelayData, RelayPassthrough


class RelayImpl:
    """Records its cycles and the messages that they see."""

    def __init__(self, passthrough: RelayPassthrough) -> None:
        """Start the record."""
        self.record = Record()

    def configure(self, config: RelayConfig) -> bool:
        """Accept."""
        return True

    def activate(self) -> bool:
        """Accept."""
        return True

    def update(self, data: RelayData, config: RelayConfig) -> None:
        """Run one cycle."""
        if data.in_values_updated:
            self.record.message(data.in_values.data[0])
        data.out_tick.data = self.record.cycle()

    def deactivate(self) -> None:
        """Save the record."""
        self.record.save()

    def cleanup(self) -> None:
        """Nothing to clean up."""
