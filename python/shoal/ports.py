"""Which LCM port carries which channel of a mission.

docs/inside/design.md and lib/bus/bus/layout.h have the rules.
"""

from __future__ import annotations

from dataclasses import dataclass

GROUP = "239.255.76.67"  #: All of shoal's ports are of LCM's own multicast group.
_MAX_COMMUNITIES = 128

TICK_PORT_CHANNELS = frozenset({"TICK", "RESEND", "APPCAST_REQ", "COMMS_RULES_REQ", "CLOCK_STATE"})
DONE_PORT_CHANNELS = frozenset({"STEP_DONE", "STEP_DONES", "CLOCK_COMMAND"})
#: Of channels at the shore, those that a vehicle's name could end.
SHORE_CHANNELS = frozenset(
    {
        "HELM_COMMAND",
        "NODE_REPORT",
        "NODE_REPORT_LOCAL",
        "NODE_REPORT_UNC",
        "NODE_MESSAGE",
        "NODE_MESSAGE_LOCAL",
        "ACK_MESSAGE",
        "ACOUSTIC_TX",
        "ACOUSTIC_TX_ON",
        "MODEM_TX",
        "MODEM_STATS",
        "RELAY_TX",
        "COMMS_FATES",
        "COMMS_MEDIA",
        "COMMS_RULES",
        "COMMS_RULES_NOW",
        "VIEW_COMMS_PULSE",
        "VIEW_POINT",
        "VIEW_POLYGON",
        "VIEW_SEGLIST",
        "VIEW_CIRCLE",
        "VIEW_TEXT",
    }
)


@dataclass(frozen=True)
class PortPlan:
    """The block of ports of one mission."""

    base: int
    has_communities: bool  #: A port per vehicle; else one for all.
    vehicles: tuple[str, ...]  #: In the mission's order.

    @property
    def tick_port(self) -> int:
        return self.base

    @property
    def done_port(self) -> int:
        return self.base + 1

    @property
    def shore_port(self) -> int:
        return self.base + 2

    @property
    def data_ports(self) -> range:
        """The shore's and all communities'."""
        count = min(len(self.vehicles), _MAX_COMMUNITIES) if self.has_communities else 0
        return range(self.shore_port, self.shore_port + 1 + count)

    def port_of(self, channel: str) -> int:
        """Returns the port that carries a channel."""
        if channel in TICK_PORT_CHANNELS:
            return self.tick_port
        if channel in DONE_PORT_CHANNELS:
            return self.done_port
        if not self.has_communities or channel in SHORE_CHANNELS or channel.startswith("UNC_"):
            return self.shore_port
        places = {name.upper(): i for i, name in enumerate(self.vehicles)}
        # Names may hold '_': the longest that ends the channel's wins.
        parts = channel.split("_")
        for begin in range(1, len(parts)):
            place = places.get("_".join(parts[begin:]))
            if place is not None:
                return self.shore_port + 1 + place % _MAX_COMMUNITIES
        return self.shore_port
