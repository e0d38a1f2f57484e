"""Finds the events of an LCM event log, and reads their bytes (lib/bus/record/log_format.h).

Nothing is taken from memory that the file does not hold: lengths that reach beyond its end are
damage. A log is read in windows, so that its size does not matter.
"""

from __future__ import annotations

import os
import struct
import weakref
from array import array
from collections.abc import Iterator
from typing import Any

from . import columns
from .errors import LogError
from .frames import FrameError, FrameReader, is_compressed
from .seal import SEAL_MAGIC, sealed_size

MAGIC = b"\xed\xa1\xda\x01"
HEADER = struct.Struct(">4sqqII")
_SIZES = struct.Struct(">4s16xII")  # Of the header, without its numbers.
_LONGEST_CHANNEL = 999
_MOST_DATA = 0x7FFFFFFF
#: A longer message is accepted only where another event, or the file's end, follows.
_MOST_UNCONFIRMED = 16 << 20
_MOST_LISTED = 1000
_WINDOW = 16 << 20  #: Bytes.
_WHOLE = 128 << 20  #: A log of at most this is kept in memory.
_BATCH = 1 << 16  #: Events that are looked at at once.
_LARGEST_GAP = 16 << 10  #: Bytes that are read with what is wanted, rather than left out.

NOT_A_LOG = "not an LCM event log: it does not begin with eda1da01"
NO_EVENT = "no event begins here, though one ended here"
TORN = "the log ends inside an event"
IMPOSSIBLE_DATA = "an event's data has an impossible length"


class FileWindow:
    """Gives parts of a file; reads it in large pieces."""

    def __init__(self, path: str) -> None:
        """Raises LogError where the file cannot be opened."""
        self._path = path
        try:
            # A pipe would be waited for.
            self._file = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)
            self._closed = weakref.finalize(self, os.close, self._file)
            status = os.fstat(self._file)
        except OSError as error:
            raise LogError(path, 0, f"cannot be read: {error.strerror}") from None
        self._buffer = b""
        self._begin = 0
        self.size = status.st_size
        self._frames: FrameReader | None = None
        if not os.path.isfile(path):
            raise LogError(path, 0, "no regular file; name the log itself")
        if is_compressed(os.pread(self._file, 4, 0)):
            try:
                self._frames = FrameReader(self._file, self.size)
            except FrameError as error:
                raise LogError(path, 0, str(error)) from None
            self.size = self._frames.size

    def at(self, offset: int, size: int) -> tuple[bytes, int]:
        """Returns bytes that hold [offset, offset + size), and where in them that begins.

        Fewer bytes follow there where the file ends before. Raises LogError.
        """
        place = offset - self._begin
        if place < 0 or place + size > len(self._buffer):
            is_small = self.size <= _WHOLE
            self._begin = 0 if is_small else offset
            self._buffer = self._read(self._begin, self.size if is_small else max(size, _WINDOW))
            place = offset - self._begin
        return self._buffer, place

    def run(self, begins: array[int], sizes: array[int], i: int) -> tuple[bytes, int]:
        """Returns bytes that hold the part `i` and those near behind it, and where it begins."""
        offset = begins[i]
        end = offset + sizes[i]
        if self.size <= _WHOLE:
            return self.at(offset, sizes[i])
        for j in range(i + 1, len(begins)):
            if begins[j] - end > _LARGEST_GAP or end - offset > _WINDOW:
                break
            end = begins[j] + sizes[j]
        return self._read(offset, end - offset), 0

    @property
    def lost(self) -> str:
        """Why the end of a compressed log cannot be read; empty: it can."""
        return self._frames.lost if self._frames else ""

    def damage_at(self, offset: int) -> str:
        """Returns what is wrong with the frame of a compressed log that has this byte."""
        return self._frames.damage_at(offset) if self._frames else ""

    def peek(self, offset: int, size: int) -> bytes:
        """Returns [offset, offset + size), and leaves what `at` gave where it is."""
        return self._read(offset, size)

    def _read(self, offset: int, size: int) -> bytes:
        """Returns the bytes there; fewer at the file's end. A read gives at most 2 GiB."""
        if self._frames:
            return self._frames.read(offset, size)[0]
        pieces = []
        try:
            while size > 0 and (piece := os.pread(self._file, size, offset)):
                pieces.append(piece)
                size -= len(piece)
                offset += len(piece)
        except OSError as error:
            raise LogError(self._path, offset, f"cannot be read: {error.strerror}") from None
        return pieces[0] if len(pieces) == 1 else b"".join(pieces)


class ChannelEvents:
    """Where the events of one channel are, in file order."""

    def __init__(self, name: str, place: int) -> None:
        self.name = name
        self.place = place  #: Counts the channels of the log from 0.
        self.numbers = array("q")  #: Counts the events of the log from 0, in file order.
        self.utimes = array("q")
        self.begins = array("q")  #: Of the data in the file.
        self.sizes = array("l")  #: Of the data, with a seal where it has one.

    def __len__(self) -> int:
        return len(self.utimes)


class LogFile:
    """The events of a log by channel."""

    def __init__(self, path: str, skip_damage: bool) -> None:
        """Reads where each event is.

        Args:
            path: The log.
            skip_damage: Read what can be read behind damage, too.

        Raises:
            LogError: the file cannot be read or is damaged, and `skip_damage` is false. A log that
                ends inside an event is read up to there: `damages` has the place.
        """
        self.path = path
        self.damages: list[LogError] = []  #: What cannot be read, the first thousand.
        self.num_damages = 0
        self.order = array("I")  #: Of each event its channel, as a number in `channels`.
        self.channels: dict[str, ChannelEvents] = {}
        self.num_events = 0
        self._window = FileWindow(path)
        self._by_bytes: dict[bytes, ChannelEvents] = {}
        self._skip = skip_damage
        self._find_events()

    @property
    def size(self) -> int:
        return self._window.size

    def _find_events(self) -> None:
        size = self._window.size
        offset = 0
        needed = 0  # Of an event that reaches beyond the window.
        while offset < size:
            buffer, place = self._window.at(offset, min(max(_WINDOW, needed), size - offset))
            offset, needed, wrong = self._take_events(buffer, place, offset)
            if wrong:
                damage = LogError(self.path, offset, self._window.damage_at(offset) or wrong)
                if not self._skip and wrong != TORN:
                    raise damage
                self.add_damage(damage)
                if not self._skip:
                    return
                offset = self._next_event(offset + 1)
        if self._window.lost:
            end = f"{self._window.lost}: what came after {self.num_events} events is lost"
            self.add_damage(LogError(self.path, size, end))

    def add_damage(self, damage: LogError) -> None:
        """Lists what cannot be read, the first thousand."""
        self.num_damages += 1
        if len(self.damages) < _MOST_LISTED:
            self.damages.append(damage)

    def _take_events(self, buffer: bytes, place: int, offset: int) -> tuple[int, int, str]:
        """Takes events from buffer[place:], which begins at `offset` of the file.

        Returns where the first that was not taken begins, how many bytes it has if it reaches
        beyond the buffer, and what is wrong with it.
        """
        unpack = _SIZES.unpack_from
        known = self._by_bytes.get
        places, order = array("q"), array("I")
        add_place, add_to_order = places.append, order.append
        base = offset - place  # Of the buffer in the file.
        stop = len(buffer)
        last = stop - HEADER.size
        needed, wrong = 0, ""
        while place <= last:
            magic, channel_size, data_size = unpack(buffer, place)
            begin = place + 28 + channel_size
            end = begin + data_size
            if end > stop or magic != MAGIC or not 0 < channel_size <= _LONGEST_CHANNEL:
                wrong = self._misfit(base + place, buffer[place : place + 28])
                needed = end - place
                break
            if data_size > _MOST_UNCONFIRMED and not self._may_begin_at(base + end):
                wrong = IMPOSSIBLE_DATA
                break
            name = buffer[place + 28 : begin]
            channel = known(name)
            if channel is None:
                channel = self._new_channel(name)
            add_place(place)
            add_to_order(channel.place)
            place = end
        for i in range(0, len(places), _BATCH):
            self._add_events(buffer, base, places[i : i + _BATCH], order[i : i + _BATCH])
        if last < place < len(buffer) and base + len(buffer) >= self._window.size:
            wrong = self._misfit(base + place, buffer[place:])  # Less than a header is left.
        return base + place, needed, wrong

    def _add_events(
        self, buffer: bytes, base: int, places: array[int], order: array[int]
    ) -> None:
        """Gives events to their channels.

        Args:
            buffer: Bytes of the file, from `base` on.
            places: Where in them the events begin.
            order: Of each event its channel.
        """
        channels = list(self.channels.values())
        first = self.num_events
        self.num_events += len(places)
        self.order.extend(order)
        numpy = columns.numpy
        if numpy is None:
            for number, (place, each) in enumerate(zip(places, order, strict=True), first):
                _, _, utime, channel_size, data_size = HEADER.unpack_from(buffer, place)
                channel = channels[each]
                channel.numbers.append(number)
                channel.utimes.append(utime)
                channel.begins.append(base + place + 28 + channel_size)
                channel.sizes.append(data_size)
            return
        headers = numpy.frombuffer(places, dtype="q")
        of_channel = numpy.frombuffer(order, dtype="I")
        in_turn = numpy.argsort(of_channel, kind="stable")
        all_bytes = numpy.frombuffer(buffer, dtype="u1")

        def member(begin: int, type_name: str) -> Any:
            size = numpy.dtype(type_name).itemsize
            found = all_bytes[headers[:, None] + numpy.arange(begin, begin + size)]
            return found.view(type_name)[:, 0].astype("q")[in_turn]

        utimes, sizes = member(12, ">i8"), member(24, ">i4").astype("l")
        begins = base + headers[in_turn] + 28 + member(20, ">i4")
        ends = numpy.cumsum(numpy.bincount(of_channel, minlength=len(channels))).tolist()
        for channel, begin, end in zip(channels, [0, *ends], ends, strict=False):
            if begin < end:
                channel.numbers.frombytes((first + in_turn[begin:end]).astype("q").tobytes())
                channel.utimes.frombytes(utimes[begin:end].tobytes())
                channel.begins.frombytes(begins[begin:end].tobytes())
                channel.sizes.frombytes(sizes[begin:end].tobytes())

    def _misfit(self, offset: int, header: bytes) -> str:
        """Returns why no event is at `offset`; empty where its bytes are all in the file."""
        if len(header) >= 4 and header[:4] != MAGIC:
            return NO_EVENT if offset > 0 else NOT_A_LOG
        if len(header) < HEADER.size:
            return TORN
        _, _, _, channel_size, data_size = HEADER.unpack(header)
        if not 0 < channel_size <= _LONGEST_CHANNEL:
            return "an event's channel has an impossible length"
        end = offset + HEADER.size + channel_size + data_size
        if data_size > _MOST_DATA:
            return IMPOSSIBLE_DATA
        if end > self._window.size:
            return TORN
        if data_size > _MOST_UNCONFIRMED and not self._may_begin_at(end):
            return IMPOSSIBLE_DATA
        return ""

    def _new_channel(self, name: bytes) -> ChannelEvents:
        text = name.decode("utf-8", "backslashreplace")
        channel = self.channels.setdefault(text, ChannelEvents(text, len(self.channels)))
        self._by_bytes[name] = channel
        return channel

    def _may_begin_at(self, offset: int) -> bool:
        return offset == self._window.size or self._window.peek(offset, 4) == MAGIC

    def _next_event(self, offset: int) -> int:
        """Returns where the next event with a printable channel begins; else the file's size."""
        size = self._window.size
        while offset + HEADER.size <= size:
            buffer, place = self._window.at(offset, min(_WINDOW, size - offset))
            found = buffer.find(MAGIC, place)
            if found < 0:
                offset += max(len(buffer) - place - 3, 1)
                continue
            offset += found - place
            header, place = self._window.at(offset, min(28 + _LONGEST_CHANNEL, size - offset))
            if len(header) - place < HEADER.size:
                break
            _, _, _, channel_size, data_size = HEADER.unpack_from(header, place)
            name = header[place + 28 : place + 28 + channel_size]
            if (
                0 < channel_size <= _LONGEST_CHANNEL
                and offset + 28 + channel_size + data_size <= size
                and all(0x20 < byte < 0x7F for byte in name)
            ):
                return offset
            offset += 1
        return size

    def message_at(self, channel: ChannelEvents, i: int) -> tuple[bytes, int]:
        """Returns a message with its seal, and the size of that; quickest in file order."""
        buffer, begin = self._window.at(channel.begins[i], channel.sizes[i])
        message = self._cut(buffer, begin, channel, i)
        return message, sealed_size(message, 0, len(message))

    def messages(self, channel: ChannelEvents) -> Iterator[tuple[bytes, int, int, int]]:
        """Returns (bytes, begin, end, size of the seal) of the messages of a channel.

        The bytes hold the message at [begin, end), with its seal.
        """
        begins, sizes = channel.begins, channel.sizes
        buffer, base, stop = b"", 0, 0  # Bytes of the file, [base, stop).
        for i, offset in enumerate(begins):
            size = sizes[i]
            if offset + size > stop:
                buffer, place = self._window.run(begins, sizes, i)
                base, stop = offset - place, offset - place + len(buffer)
                self._cut(buffer, place, channel, i)
            begin = offset - base
            end = begin + size
            seal = sealed_size(buffer, begin, end) if buffer[end - 4 : end] == SEAL_MAGIC else 0
            yield buffer, begin, end, seal

    def flat_messages(self, channel: ChannelEvents, size: int) -> list[bytes] | None:
        """Returns all messages of a channel where each has this size; None otherwise."""
        if not len(channel) or min(channel.sizes) != size or max(channel.sizes) != size:
            return None
        return [buffer[begin:end] for buffer, begin, end, _ in self.messages(channel)]

    def whole_messages(self, channel: ChannelEvents) -> list[bytes] | None:
        """Returns all messages of a channel; None where one of them has a seal."""
        messages = []
        for buffer, begin, end, seal in self.messages(channel):
            if seal:
                return None
            messages.append(buffer[begin:end])
        return messages

    def _cut(self, buffer: bytes, begin: int, channel: ChannelEvents, i: int) -> bytes:
        """Returns the message at `begin`. Raises LogError where it is not all there."""
        message = buffer[begin : begin + channel.sizes[i]]
        if len(message) < channel.sizes[i]:
            raise LogError(self.path, channel.begins[i], "the file became shorter")
        return message
