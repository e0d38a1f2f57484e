"""Reads VIEW_COMMS_PULSE, whose messages have pulses as columns, as lists of pulses.

Logs of 0.1 and 0.2 have lists (comms_pulses_t); what reads pulses sees lists of either.
"""

from __future__ import annotations

from .codec import Codec, Row
from .errors import DecodeError

LIST_TYPE = "shoal.comms_pulses_t"
COLUMNS_TYPE = "shoal.comms_pulse_columns_t"
_MAX_TEXTS = 64 << 20  # Bytes of text of one message: one long name could stand for many ...
_MAX_TEXT_OF_PULSE = 256  # ... and this more for each pulse.


def list_of(columns: Row) -> Row:
    """Returns the row of the comms_pulses_t that the row of a comms_pulse_columns_t stands for.

    Raises:
        DecodeError: the columns do not fit one another.
    """
    utime, _, ends, _, styles, num_pulses, sources, destinations, which, widths_m = columns
    if min((*sources, *destinations, *which), default=0) < 0:
        raise DecodeError("pulses whose columns do not fit one another")
    pulses: list[Row] = []
    left = _MAX_TEXTS + _MAX_TEXT_OF_PULSE * num_pulses
    try:
        for source, destination, style, width_m in zip(sources, destinations, which, widths_m):
            from_name, sx_m, sy_m = ends[source]
            to_name, tx_m, ty_m = ends[destination]
            duration_s, fill, label_end, ptype, fill_color, edge_color, edge_size = styles[style]
            label = f"{from_name}2{to_name}{label_end}"
            left -= len(label) + len(ptype) + len(fill_color) + len(edge_color)
            if left < 0:
                raise DecodeError("pulses whose texts would fill the memory")
            pulses.append(
                (sx_m, sy_m, tx_m, ty_m, width_m, duration_s, fill, label, ptype, fill_color,
                 edge_color, edge_size)  # fmt: skip
            )
    except IndexError:
        raise DecodeError("pulses whose columns do not fit one another") from None
    return (utime, num_pulses, pulses)


class PulsesCodec(Codec):
    """Reads a comms_pulses_t, or a comms_pulse_columns_t as one."""

    def read_message(self, data: bytes, begin: int, end: int) -> Row:
        columns = self._codecs[COLUMNS_TYPE]
        if data[begin : begin + 8] == columns.fingerprint_bytes:
            return list_of(columns.read_message(data, begin, end))
        return super().read_message(data, begin, end)
