"""Reads COMMS_FATES, whose messages have fates as columns, as lists of fates.

Logs of 0.1 and 0.2 have lists (comms_fates_t); what reads fates sees lists of either.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from .codec import Codec, Row
from .errors import DecodeError

LIST_TYPE = "shoal.comms_fates_t"
COLUMNS_TYPE = "shoal.comms_fate_columns_t"
_MAX_TEXTS = 64 << 20  # Bytes of text of one message: one long name could stand for many ...
_MAX_TEXT_OF_FATE = 256  # ... and this more for each fate.


def list_of(columns: Row) -> Row:
    """Returns the row of the comms_fates_t that the row of a comms_fate_columns_t stands for.

    Raises:
        DecodeError: the columns do not fit one another.
    """
    (utime, _, senders, _, cases, _, names, num_fates, destinations, which) = columns[:10]
    own = [iter(each) for each in (columns[11], columns[13], columns[15], columns[17])]
    try:
        fates = list(_fates(senders, cases, names, destinations, which, own))
    except (IndexError, StopIteration, RuntimeError):
        raise DecodeError("fates whose columns do not fit one another") from None
    left = sum(1 for each in own for _ in each)
    is_last_empty = bool(senders) and senders[-1][3] <= 0
    if left or is_last_empty or len(fates) != num_fates or _is_too_long(fates):
        raise DecodeError("fates whose columns do not fit one another")
    return (utime, num_fates, fates)


def _is_too_long(fates: list[Row]) -> bool:
    total = sum(len(fate[text]) for fate in fates for text in (0, 1, 2, 5, 6))
    return total > _MAX_TEXTS + _MAX_TEXT_OF_FATE * len(fates)


def _fates(
    senders: list[Row],
    cases: list[Row],
    names: list[str],
    destinations: list[int],
    which: list[int],
    own: list[Iterator[Any]],
) -> Iterator[Row]:
    if min(destinations, default=0) < 0 or min(which, default=0) < 0:
        raise IndexError
    ranges, waits, counts, paths = own
    place = 0
    for kind, source, number, num_fates in senders:
        for i in range(place, place + max(num_fates, 0)):
            (cause, override, limit_m, age_s, age_limit_s, loss_pct, length, length_limit,
             has_range, has_wait, has_count, has_path) = cases[which[i]]  # fmt: skip
            yield (
                kind,
                source,
                names[destinations[i]],
                next(counts) if has_count else 1,
                number,
                cause,
                override,
                next(ranges) if has_range else -1.0,
                limit_m,
                age_s,
                age_limit_s,
                next(waits) if has_wait else -1.0,
                loss_pct,
                length,
                length_limit,
                1 if has_path else 0,
                [next(paths)] if has_path else [],
            )
        place += max(num_fates, 0)


class FatesCodec(Codec):
    """Reads a comms_fates_t, or a comms_fate_columns_t as one."""

    def read_message(self, data: bytes, begin: int, end: int) -> Row:
        columns = self._codecs[COLUMNS_TYPE]
        if data[begin : begin + 8] == columns.fingerprint_bytes:
            return list_of(columns.read_message(data, begin, end))
        return super().read_message(data, begin, end)
