"""Reads all messages of a channel at once where they have few layouts.

Two messages have the same layout if their strings have the same lengths and their arrays are
empty: each member is then at the same place in both. All messages of one layout become one numpy
array, and each member becomes a column of it. The codec reads the other messages one by one, and
reports errors.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Any

from . import columns
from .codec import Codec, is_bytes, text_of
from .columns import NUMPY_TYPES, NumberColumn, ObjectColumn, StructColumn, StructColumns
from .errors import DecodeError
from .lcm_file import PRIMITIVE_SIZES

numpy = columns.numpy
_FEWEST = 64  #: Messages for which it is worth the while.
_MOST_LAYOUTS = 64  #: A channel with more is left to the codec.
_LENGTH = struct.Struct(">i")


def may_be_uniform(codec: Codec) -> bool:
    """Returns true for structs of single numbers, strings, and arrays that may be empty."""
    return all(
        len(each.dimensions) == 1 and each.dimensions[0].size == 0
        if each.dimensions
        else each.is_primitive
        for each in codec.struct.members
    )


class _Layout:
    """Where the members are in messages like one."""

    def __init__(self, codec: Codec, message: bytes) -> None:
        """Raises DecodeError where the message does not fit, or has an array that is not empty."""
        if not message.startswith(codec.fingerprint_bytes):
            raise DecodeError("the fingerprint of another type")
        self.offsets: dict[str, tuple[int, str]] = {}  # Of members with bytes: place, numpy's type.
        self._fixed = list(range(8))  # Bytes that are the same in all messages of this layout.
        offset = 8
        for member in codec.struct.members:
            if member.dimensions:
                length_at, length_type = self.offsets[member.dimensions[0].text]
                size = numpy.dtype(length_type).itemsize
                if any(message[length_at : length_at + size]):
                    raise DecodeError("an array that is not empty")
                self._fixed += range(length_at, length_at + size)
            elif member.type_name == "string":
                if offset + 4 > len(message):
                    raise DecodeError("the message ends too early")
                (size,) = _LENGTH.unpack_from(message, offset)
                end = offset + 4 + size
                if size < 1 or end > len(message) or message[end - 1]:
                    raise DecodeError("a string without its end")
                self._fixed += [*range(offset, offset + 4), end - 1]
                self.offsets[member.name] = (offset + 4, f"S{size - 1}")
                offset = end
            else:
                self.offsets[member.name] = (offset, NUMPY_TYPES[member.type_name])
                offset += PRIMITIVE_SIZES[member.type_name]
        if offset != len(message):
            raise DecodeError("a message of another length")
        self._like = numpy.frombuffer(message, dtype="u1")[self._fixed]
        present = {each: at for each, at in self.offsets.items() if at[1] != "S0"}
        self._dtype = numpy.dtype(
            {
                "names": list(present),
                "formats": [each for _, each in present.values()],
                "offsets": [at for at, _ in present.values()],
                "itemsize": len(message),
            }
        )

    def fits(self, messages: Any) -> Any:
        """Returns one bool per row of bytes: True if the row has this layout."""
        return (messages[:, self._fixed] == self._like).all(axis=1)

    def column(self, name: str, messages: Any) -> Any:
        """Returns a number or string of each row of bytes."""
        at, type_name = self.offsets[name]
        if not type_name.startswith("S"):
            return messages.view(self._dtype)[name][:, 0]
        size = int(type_name[1:])
        texts = numpy.empty(len(messages), dtype=object)
        if size == 0:
            texts[:] = ""
            return texts
        if not messages[:, at : at + size].all():
            raise DecodeError("a string whose NUL is not at its end")
        texts[:] = [text_of(each) for each in messages.view(self._dtype)[name][:, 0].tolist()]
        return texts


def take_uniform(taker: StructColumns, messages: Sequence[bytes], sizes: Any) -> bool:
    """Fills the columns with all messages, or returns false and leaves them as they are.

    Args:
        taker: Of a struct for which may_be_uniform, without rows.
        messages: Without seals.
        sizes: An array of their sizes.
    """
    if columns.numpy is None or len(messages) < _FEWEST:
        return False
    try:
        parts = _parts(taker.codec, messages, numpy.asarray(sizes))
        if parts is None:
            return False
        made = {
            name: _joined([(rows, layout.column(name, part)) for layout, rows, part in parts])
            for name in parts[0][0].offsets
        }
    except DecodeError:
        return False
    for member, column in zip(taker.codec.struct.members, taker.columns.values(), strict=True):
        if isinstance(column, StructColumn):
            column.extend([()] * len(messages))
        elif member.dimensions:
            column.extend(b"" if is_bytes(member) else [] for _ in messages)
        else:
            assert isinstance(column, NumberColumn | ObjectColumn)
            column.take(made[member.name])
    taker.num_rows = len(messages)
    return True


def _parts(
    codec: Codec, messages: Sequence[bytes], sizes: Any
) -> list[tuple[_Layout, Any, Any]] | None:
    """Returns the messages by layout: which they are, and their bytes; None: there are too many."""
    parts: list[tuple[_Layout, Any, Any]] = []
    _Layout(codec, messages[0])  # Where this does not fit, the others hardly do.
    for size in numpy.unique(sizes):
        rows = numpy.flatnonzero(sizes == size)
        chosen = messages if len(rows) == len(messages) else [messages[i] for i in rows.tolist()]
        rest = numpy.frombuffer(b"".join(chosen), dtype="u1").reshape(len(rows), int(size))
        while len(rows):
            if len(parts) == _MOST_LAYOUTS:
                return None
            layout = _Layout(codec, rest[0].tobytes())
            fits = layout.fits(rest)
            if fits.all():
                parts.append((layout, rows, rest))
                break
            parts.append((layout, rows[fits], rest[fits]))
            rows, rest = rows[~fits], rest[~fits]
    return parts


def _joined(parts: list[tuple[Any, Any]]) -> Any:
    """Returns one column of those of the parts, whose rows are stated."""
    if len(parts) == 1:
        return parts[0][1]
    column = numpy.empty(sum(len(rows) for rows, _ in parts), dtype=parts[0][1].dtype)
    for rows, values in parts:
        column[rows] = values
    return column
