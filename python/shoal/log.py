"""Reads recordings: `mission.lcm`, and logs of lcm-logger.

    log = shoal.read("mission.lcm")
    log["NAV_ALPHA"].x_m                            a column
    for record in log: record.channel, record.message
    log.fates(), log.links(), log.vehicles, log.verdict()
"""

from __future__ import annotations

import os
import warnings
from array import array
from collections.abc import Iterable, Iterator
from typing import Any

from . import links, recording
from .codec import Codec, Row
from .columns import StructColumns, may_be_flat
from .errors import DecodeError, LogError, LogWarning
from .log_file import TORN, ChannelEvents, LogFile
from .message import Message
from .table import Table
from .type_set import Types, own_types
from .uniform import may_be_uniform, take_uniform


class Record:
    """One message of a log.

    Attributes:
        channel: Its channel.
        utime: Its time in microseconds: mission time in mission.lcm.
        data: Its bytes, without a seal.
    """

    __slots__ = ("_place", "_types", "channel", "data", "utime")

    def __init__(
        self, channel: str, utime: int, data: bytes, types: Types, place: tuple[str, int]
    ) -> None:
        self.channel = channel
        self.utime = utime
        self.data = data
        self._types = types
        self._place = place

    @property
    def time_s(self) -> float:
        return self.utime / 1e6

    @property
    def message(self) -> Message:
        """The decoded message. Raises LogError where it cannot be decoded."""
        try:
            return self._types.decode(self.data)
        except DecodeError as error:
            raise LogError(*self._place, f"channel {self.channel}: {error}") from error

    def __repr__(self) -> str:
        return f"Record({self.channel!r}, utime={self.utime}, {len(self.data)} bytes)"


class Log:
    """A recording. Made by `shoal.read`."""

    def __init__(self, path: str, types: Types, skip_damage: bool) -> None:
        self.path = path
        self.types = types
        self._skip = skip_damage
        self._file = LogFile(path, skip_damage)
        self._tables: dict[str, Table] = {}
        if self._file.damages:
            first = self._file.damages[0]
            more = self._file.num_damages - 1
            text = f"{first}; {more} more" if more else str(first)
            warnings.warn(f"{text}; the rest is read", LogWarning, stacklevel=3)

    @property
    def channels(self) -> list[str]:
        """The names of all channels, sorted."""
        return sorted(self._file.channels)

    def __len__(self) -> int:
        """The number of messages."""
        return self._file.num_events

    def __contains__(self, channel: object) -> bool:
        return channel in self._file.channels

    def __getitem__(self, channel: str) -> Table:
        """Returns a channel's messages as a table, decoded at the first use.

        Raises:
            KeyError: the log has no such channel.
            LogError: a message cannot be decoded, unless the log was read with `skip_damage`.
        """
        table = self._tables.get(channel)
        if table is None:
            events = self._file.channels.get(channel)
            if events is None:
                known = ", ".join(self.channels)
                raise KeyError(f"{self.path} has no channel '{channel}'; it has {known}")
            table = self._tables[channel] = self._read_table(events)
        return table

    def __iter__(self) -> Iterator[Record]:
        """Returns all messages in file order."""
        channels = list(self._file.channels.values())
        next_of = [0] * len(channels)
        for place in self._file.order:
            channel = channels[place]
            i = next_of[place]
            next_of[place] = i + 1
            data = self._without_seal(*self._file.message_at(channel, i))
            place_in_file = (self.path, channel.begins[i])
            yield Record(channel.name, channel.utimes[i], data, self.types, place_in_file)

    def _without_seal(self, data: bytes, seal: int) -> bytes:
        if seal == 0:
            return data
        try:
            self.types.decode(data[:-seal])
        except DecodeError:
            return data  # What looks like a seal may be the message's own bytes.
        return data[:-seal]

    def __repr__(self) -> str:
        return f"<Log {self.path}: {len(self)} messages on {len(self.channels)} channels>"

    @property
    def damages(self) -> list[LogError]:
        """What could not be read and was left out, the first thousand, in the order of reading."""
        return self._file.damages

    @property
    def num_damages(self) -> int:
        """How often something could not be read and was left out."""
        return self._file.num_damages

    @property
    def is_torn(self) -> bool:
        """True where the log ends inside an event: what is whole before it was read."""
        return any(each.what == TORN for each in self._file.damages)

    @property
    def vehicles(self) -> list[str]:
        """The vehicles: as COMMS_RULES names them, else by NAV_<V>, in upper case."""
        if "COMMS_RULES" in self:
            rules = self["COMMS_RULES"]
            if rules.type == "shoal.broker_rules_t" and len(rules):
                return [vehicle.name for vehicle in rules[0].vehicles]
            if rules.type == "shoal.comms_rules_t" and len(rules):  # Logs of 0.1 and 0.2.
                return list(rules["vehicles"][0])
        return [name.removeprefix("NAV_") for name in self.channels if name.startswith("NAV_")]

    def fates(self) -> Table:
        """Returns all fates of COMMS_FATES with their numbers; maybe no rows.

        docs/reference/fates.md explains them.
        """
        return self._table_in("COMMS_FATES", "fates", "shoal.comms_fates_t")

    def media(self) -> Table:
        """Returns medium and hop of fates, from COMMS_MEDIA; maybe no rows.

        docs/communication/media.md explains them.
        """
        return self._table_in("COMMS_MEDIA", "media", "shoal.comms_media_t")

    def links(self) -> list[links.Link]:
        """Returns what was delivered and lost by link, as `shoal log comms` counts it."""
        return links.links_of(self.fates(), self.media())

    @property
    def mission(self) -> dict[str, Any] | None:
        """The mission.toml beside the log, as it was; None where there is none."""
        return recording.mission_beside(self.path)

    @property
    def run(self) -> recording.Run | None:
        """What run.txt beside the log states: seed, overrides, ...; None where there is none."""
        return recording.run_beside(self.path)

    def verdict(self) -> recording.Verdict | None:
        """Returns how the mission ended, by summary.txt beside the log; None: there is none."""
        return recording.verdict_beside(self.path)

    def _table_in(self, channel: str, member: str, type_name: str) -> Table:
        if channel in self:
            outer = self[channel]
            if outer.type == type_name:
                table = outer[member]
                assert isinstance(table, Table)
                return table
        codec = self.types[type_name]._codec
        table = Table(channel, self._columns(codec), [], [])[member]
        assert isinstance(table, Table)
        return table

    def _columns(self, codec: Codec) -> StructColumns:
        return StructColumns(codec, self.types._codecs)

    def _codec_of(self, channel: ChannelEvents) -> Codec:
        """Returns the type of the first message whose type is known."""
        shown = "none has a fingerprint"
        for buffer, begin, _, _ in self._file.messages(channel):
            fingerprint = buffer[begin : begin + 8]
            codec = self.types.codec_of(fingerprint)
            if codec is not None:
                return codec
            shown = f"fingerprint 0x{fingerprint.hex()}"
            if not self._skip:
                break
        raise LogError(
            self.path,
            channel.begins[0],
            f"channel {channel.name}: its type is not known ({shown}); "
            "give its .lcm file to shoal.read as types=[...]",
        )

    def _read_table(self, channel: ChannelEvents) -> Table:
        codec = self._codec_of(channel)
        columns = self._columns(codec)
        if codec.flat is not None and may_be_flat(codec):
            messages = self._file.flat_messages(channel, codec.flat.size)
            if messages is not None:
                try:
                    columns.take_flat(messages)
                    return Table(channel.name, columns, channel.utimes, channel.numbers)
                except DecodeError:
                    columns = self._columns(codec)  # Some is of another type: one by one.
        elif may_be_uniform(codec):
            whole = self._file.whole_messages(channel)
            if whole is not None and take_uniform(columns, whole, channel.sizes):
                return Table(channel.name, columns, channel.utimes, channel.numbers)
        bad: list[int] = []
        columns.extend_all(self._rows(channel, codec, bad))
        utimes, numbers = channel.utimes, channel.numbers
        if bad:
            left_out = set(bad)
            good = [i for i in range(len(utimes)) if i not in left_out]
            utimes = array("q", [utimes[i] for i in good])
            numbers = array("q", [numbers[i] for i in good])
        return Table(channel.name, columns, utimes, numbers)

    def _rows(self, channel: ChannelEvents, codec: Codec, bad: list[int]) -> Iterator[Row]:
        read = codec.read_message
        for i, (buffer, begin, end, seal) in enumerate(self._file.messages(channel)):
            try:
                if seal:
                    try:
                        yield read(buffer, begin, end - seal)
                        continue
                    except DecodeError:
                        pass  # What looks like a seal may be the message's own bytes.
                yield read(buffer, begin, end)
            except DecodeError as error:
                damage = LogError(
                    self.path, channel.begins[i], f"channel {channel.name}: {error}"
                )
                if not self._skip:
                    raise damage from None
                self._file.add_damage(damage)
                bad.append(i)


def read(
    path: str | os.PathLike[str],
    types: Types | Iterable[str | os.PathLike[str]] = (),
    skip_damage: bool = False,
) -> Log:
    """Opens a log.

    A log that ends inside an event is read up to there, with a LogWarning.

    Args:
        path: The log, compressed or not, or the folder of a recording, which has it as mission.lcm
            or mission.lcm.zst.
        types: .lcm files of your own types, or a shoal.Types.
        skip_damage: Leave out what cannot be read, and list it in `damages`, instead of raising.

    Raises:
        LogError: with the file, the byte and what is wrong there.
    """
    if not isinstance(types, Types):
        files = list(types)
        types = Types(files) if files else own_types()
    name = os.fspath(path)
    if os.path.isdir(name):
        plain = os.path.join(name, "mission.lcm")
        compressed = plain + ".zst"
        name = compressed if os.path.exists(compressed) and not os.path.exists(plain) else plain
    return Log(name, types, skip_damage)
