"""LCM's UDP datagrams, checked and put together to messages. No socket, no clock.

    LC02: magic | sequence 4 | channel name, 0 | the message
    LC03: magic | sequence 4 | message size 4 | offset 4 | fragment 2 | number of fragments 2 |
          in fragment 0 the channel name, 0 | a part of the message

All numbers are big-endian.
"""

from __future__ import annotations

import struct
from collections.abc import Hashable, Iterator
from dataclasses import dataclass, field

LONGEST_CHANNEL = 63  #: Bytes; LCM's own limit.
#: Fragments that wait for others of their message take at most this; LCM's own limit.
MOST_PENDING_BYTES = 16 << 20
MOST_PENDING = 64  #: Messages that wait for fragments.
MOST_OF_SENDER = 4  #: Of these, of one sender: threads that share a socket interleave theirs.

_WHOLE_MAGIC = b"LC02"
_FRAGMENT_MAGIC = b"LC03"
_WHOLE = struct.Struct(">4sI")
_FRAGMENT = struct.Struct(">4sIIIHH")
_LARGEST_WHOLE = 65499  # Channel, NUL and message, as liblcm has it.
_LARGEST_PART = 65487
_PIECE_COST = 200  # What a piece takes beside its bytes.


def split_message(channel: str, data: bytes, sequence: int) -> Iterator[bytes]:
    """Returns the datagrams of a message. Raises ValueError for what LCM cannot send."""
    name = channel.encode()
    if not 1 <= len(name) <= LONGEST_CHANNEL or b"\0" in name:
        raise ValueError(f"'{channel}': a channel's name has 1 to {LONGEST_CHANNEL} bytes")
    begin = name + b"\0"
    if len(begin) + len(data) <= _LARGEST_WHOLE:
        yield _WHOLE.pack(_WHOLE_MAGIC, sequence) + begin + data
        return
    if len(data) > MOST_PENDING_BYTES:
        raise ValueError(f"a message of {len(data)} bytes; LCM sends at most {MOST_PENDING_BYTES}")
    count = -(-(len(begin) + len(data)) // _LARGEST_PART)
    offset = 0
    for number in range(count):
        size = _LARGEST_PART - len(begin)
        header = _FRAGMENT.pack(_FRAGMENT_MAGIC, sequence, len(data), offset, number, count)
        yield header + begin + data[offset : offset + size]
        offset += size
        begin = b""


def _split_channel(data: bytes) -> tuple[bytes, bytes]:
    """Returns the channel name that `data` begins with and what follows; no name: it has none."""
    end = data.find(b"\0", 0, LONGEST_CHANNEL + 1)
    return (data[:end], data[end + 1 :]) if end > 0 else (b"", b"")


@dataclass
class _Pending:
    size: int
    num_fragments: int
    channel: bytes = b""
    pieces: dict[int, tuple[int, bytes]] = field(default_factory=dict)  # Offset, part.
    num_bytes: int = 0


class Assembler:
    """Puts datagrams together.

    Attributes:
        num_malformed: Datagrams that LCM cannot have sent.
        num_abandoned: Messages given up: a fragment did not come, or too many waited for theirs.
    """

    def __init__(self) -> None:
        self.num_malformed = 0
        self.num_abandoned = 0
        self.pending_bytes = 0
        # By sender and sequence, the oldest first.
        self._pending: dict[tuple[Hashable, int], _Pending] = {}

    @property
    def num_pending(self) -> int:
        return len(self._pending)

    def add(self, sender: Hashable, datagram: bytes) -> tuple[str, bytes] | None:
        """Returns channel and message where `datagram` completes one. It never raises."""
        if datagram[:4] == _FRAGMENT_MAGIC:
            return self._add_fragment(sender, datagram)
        name, data = b"", b""
        if datagram[:4] == _WHOLE_MAGIC and len(datagram) >= _WHOLE.size:
            name, data = _split_channel(datagram[_WHOLE.size :])
        if not name:
            return self._refuse()
        return name.decode("utf-8", "backslashreplace"), data

    def _refuse(self) -> tuple[str, bytes] | None:
        self.num_malformed += 1
        return None

    def _add_fragment(self, sender: Hashable, datagram: bytes) -> tuple[str, bytes] | None:
        if len(datagram) <= _FRAGMENT.size:
            return self._refuse()
        _, sequence, size, offset, number, count = _FRAGMENT.unpack_from(datagram)
        part = datagram[_FRAGMENT.size :]
        name = b""
        if number == 0:
            name, part = _split_channel(part)
            if not name or offset != 0:
                return self._refuse()
        # No fragment is empty, so there are no more of them than bytes.
        if not part or size > MOST_PENDING_BYTES or offset + len(part) > size:
            return self._refuse()
        if number >= count or count > size:
            return self._refuse()
        pending = self._await(sender, sequence, size, count)
        if (pending.size, pending.num_fragments) != (size, count):
            return self._refuse()
        if number in pending.pieces:
            return None  # Sent twice.
        pending.pieces[number] = (offset, part)
        self._count(pending, len(part) + _PIECE_COST)
        pending.channel = name or pending.channel
        if len(pending.pieces) < count:
            self._make_room((sender, sequence))
            return None
        self._forget((sender, sequence))
        end = 0
        for i in range(count):  # They must be the message, without gaps or overlaps.
            offset, part = pending.pieces[i]
            if offset != end:
                return self._refuse()
            end += len(part)
        if end != size:
            return self._refuse()
        data = b"".join(pending.pieces[i][1] for i in range(count))
        return pending.channel.decode("utf-8", "backslashreplace"), data

    def _await(self, sender: Hashable, sequence: int, size: int, count: int) -> _Pending:
        key = (sender, sequence)
        pending = self._pending.get(key)
        if pending is not None:
            return pending
        of_sender = [each for each in self._pending if each[0] == sender]
        if len(of_sender) >= MOST_OF_SENDER:
            self.num_abandoned += 1
            self._forget(of_sender[0])
        pending = self._pending[key] = _Pending(size, count)
        self._count(pending, _PIECE_COST)
        self._make_room(key)
        return pending

    def _count(self, pending: _Pending, num_bytes: int) -> None:
        pending.num_bytes += num_bytes
        self.pending_bytes += num_bytes

    def _forget(self, key: tuple[Hashable, int]) -> None:
        self.pending_bytes -= self._pending.pop(key).num_bytes

    def _make_room(self, kept: tuple[Hashable, int]) -> None:
        """Gives up the oldest messages until the rest is within the limits; `kept` stays."""
        while self.pending_bytes > MOST_PENDING_BYTES or len(self._pending) > MOST_PENDING:
            oldest = next((each for each in self._pending if each != kept), None)
            if oldest is None:
                return
            self.num_abandoned += 1
            self._forget(oldest)
