"""What was delivered and lost between vehicles, from COMMS_FATES and COMMS_MEDIA of a log."""

from __future__ import annotations

from dataclasses import dataclass, field

from .table import Table

_LONGEST_DELAY_S = 86_400  # Acoustic; of other media two days.


@dataclass
class MediumCount:
    """What became of a link's transmissions over one medium and hop."""

    sent: int = 0
    delivered: int = 0  #: Damaged ones, too.
    lost: dict[str, int] = field(default_factory=dict)  #: By cause.
    delays_s: list[float] = field(default_factory=list)  #: Of what was delivered.


@dataclass
class Link:
    """What became of what one vehicle sent to another: sent = delivered + damaged + all lost."""

    kind: str  #: report, message, ack or packet.
    source: str
    destination: str  #: Empty: refused before it had any; *: count others.
    sent: int = 0  #: With a fate: not what was in transit when the log ended.
    delivered: int = 0  #: As it was sent.
    damaged: int = 0  #: Handed over with wrong bits.
    lost: dict[str, int] = field(default_factory=dict)  #: By cause: docs/reference/fates.md.
    #: From the first byte sent to the last received, of acoustic traffic that was handed over.
    delays_s: list[float] = field(default_factory=list)
    #: By medium and hop, in missions with [[medium]] blocks; hop 0 is from the maker.
    media: dict[tuple[str, int], MediumCount] = field(default_factory=dict)

    @property
    def num_lost(self) -> int:
        return sum(self.lost.values())


def links_of(fates: Table, media: Table) -> list[Link]:
    """Returns all links, in the order of kind, source and destination.

    `fates` and `media` are those of Log.fates() and Log.media().
    """
    links: dict[tuple[str, str, str], Link] = {}
    delays = _delays_s(fates)
    columns = (fates["kind"], fates["source"], fates["destination"], fates["cause"])
    for i, (kind, source, destination, cause) in enumerate(zip(*columns, strict=True)):
        count = int(fates["count"][i])
        if count < 1:
            continue
        link = links.setdefault((kind, source, destination), Link(kind, source, destination))
        link.sent += count
        if cause == "delivered":
            link.delivered += count
        elif cause == "damaged":
            link.damaged += count
        else:
            link.lost[cause] = link.lost.get(cause, 0) + count
            continue
        link.delays_s += delays.get(i, [])
    _add_media(media, links)
    return [links[key] for key in sorted(links)]


def _delays_s(fates: Table) -> dict[int, list[float]]:
    """Returns the delays of each fate that has a path."""
    delays: dict[int, list[float]] = {}
    paths = fates["path"]
    columns = (paths.event, paths["air_s"], paths["travel_s"], paths["jitter_s"])
    for fate, air_s, travel_s, jitter_s in zip(*columns, strict=True):
        delay_s = float(air_s + travel_s + jitter_s)
        if 0 <= delay_s <= _LONGEST_DELAY_S:
            delays.setdefault(int(fate), []).append(delay_s)
    return delays


def _add_media(media: Table, links: dict[tuple[str, str, str], Link]) -> None:
    for row in zip(
        *(media[name] for name in ("kind", "source", "destination", "cause", "medium")),
        media["hop"],
        media["delay_s"],
        strict=True,
    ):
        kind, source, destination, cause, medium, hop, delay_s = row
        link = links.setdefault((kind, source, destination), Link(kind, source, destination))
        count = link.media.setdefault((medium, int(hop)), MediumCount())
        count.sent += 1
        if cause not in ("delivered", "damaged"):
            count.lost[cause] = count.lost.get(cause, 0) + 1
            continue
        count.delivered += 1
        if 0 <= delay_s <= 2 * _LONGEST_DELAY_S:
            count.delays_s.append(float(delay_s))
