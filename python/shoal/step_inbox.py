"""The messages of a participant that wait for their step. No socket, no clock."""

from __future__ import annotations

from typing import NamedTuple

from .seal import Seal

#: Messages from outside the step protocol that are kept in one step.
MOST_OUTSIDE = 2000
MOST_OUTSIDE_BYTES = 64 << 20


class _Waiting(NamedTuple):
    channel: bytes  # In the fixed order: channel, those from outside, publisher, sequence.
    is_sealed: bool
    publisher: bytes
    sequence: int
    data: bytes


class StepInbox:
    """Messages by step, each once.

    Attributes:
        num_outside: Messages from outside that were taken, since the start.
        num_refused: Messages from outside for which there was no room.
    """

    def __init__(self, own_name: bytes) -> None:
        self.num_outside = 0
        self.num_refused = 0
        self._own_name = own_name
        self._sealed: dict[int, dict[tuple[bytes, int], _Waiting]] = {}  # By step.
        self._counts: dict[tuple[int, str, bytes], int] = {}
        self._outside: list[_Waiting] = []
        self._outside_bytes = 0

    def add(self, channel: str, seal: Seal, data: bytes) -> None:
        """Takes a genuine message; a datagram that came twice counts once."""
        of_step = self._sealed.setdefault(seal.step, {})
        key = (seal.publisher, seal.sequence)
        if key in of_step:
            return
        of_step[key] = _Waiting(channel.encode(), True, seal.publisher, seal.sequence, data)
        counted = (seal.step, channel, seal.publisher)
        self._counts[counted] = self._counts.get(counted, 0) + 1

    def add_outside(self, channel: str, data: bytes) -> None:
        """Takes a message without a seal, for the next step."""
        if (
            len(self._outside) >= MOST_OUTSIDE
            or self._outside_bytes + len(data) > MOST_OUTSIDE_BYTES
        ):
            self.num_refused += 1
            return
        self.num_outside += 1
        self._outside_bytes += len(data)
        self._outside.append(_Waiting(channel.encode(), False, b"", len(self._outside), data))

    def count(self, channel: str, publisher: bytes, step: int) -> int:
        """Returns how many messages of a publisher are there."""
        return self._counts.get((step, channel, publisher), 0)

    def take(
        self, step: int, announced: set[tuple[str, bytes]], first: bool
    ) -> list[tuple[str, bytes]]:
        """Returns channel and message of all of `step`, in the fixed order, and forgets them.

        Args:
            step: The one before that which is taken.
            announced: Channel and publisher of the tick's totals: what is in none is dropped.
            first: The first step of this process: a former one of its name is gone.
        """
        waiting = self._outside
        for each in self._sealed.get(step, {}).values():
            is_former = first and each.publisher == self._own_name
            if not is_former and (each.channel.decode(), each.publisher) in announced:
                waiting.append(each)
        waiting.sort()
        self._outside = []
        self._outside_bytes = 0
        self.forget_before(step + 1)
        return [(each.channel.decode(), each.data) for each in waiting]

    def forget_before(self, step: int) -> None:
        """Drops sealed messages of earlier steps."""
        for each in [each for each in self._sealed if each < step]:
            del self._sealed[each]
        for key in [key for key in self._counts if key[0] < step]:
            del self._counts[key]
