"""Columns of a table: arrays that grow by rows, and what they become with and without numpy."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, repeat
from typing import TYPE_CHECKING, Any, TypeAlias

from .codec import Codec, Row, flat_format, is_bytes
from .errors import DecodeError
from .lcm_file import Member

try:
    import numpy as numpy  # Also columns.numpy, for others.
except ImportError:  # Lists and arrays of the standard library serve then.
    numpy = None  # type: ignore[assignment]

if TYPE_CHECKING:
    import numpy.typing

#: What a user is given: numpy's arrays, or, if numpy is not installed, arrays and lists, which have
#: len(), [] and iteration in common with these.
Floats: TypeAlias = "numpy.typing.NDArray[numpy.float64]"
Integers: TypeAlias = "numpy.typing.NDArray[numpy.int64]"
Vector: TypeAlias = "numpy.typing.NDArray[numpy.float32]"

_TYPE_CODES = {
    "int8_t": "b",
    "int16_t": "h",
    "int32_t": "i",
    "int64_t": "q",
    "byte": "B",
    "float": "f",
    "double": "d",
    "boolean": "B",
}
_NUMPY_TYPES = {"b": "i1", "h": ">i2", "i": ">i4", "q": ">i8", "B": "u1", "f": ">f4", "d": ">f8"}
#: The types of LCM as numpy reads them from a message.
NUMPY_TYPES = {name: _NUMPY_TYPES[code] for name, code in _TYPE_CODES.items()}
_BATCH = 4096  #: Rows that are taken apart at once.


def as_column(values: Any) -> Any:
    """Returns an array of numpy where that is there: of numbers, or of objects; else `values`."""
    if numpy is None:
        return values
    if isinstance(values, numpy.ndarray):
        return values
    if isinstance(values, array):
        return numpy.frombuffer(values, dtype=values.typecode) if values else numpy.array(values)
    made = numpy.empty(len(values), dtype=object)
    made[:] = values
    return made


def seconds_of(utimes: Sequence[int]) -> Floats:
    """Returns microseconds as seconds."""
    if numpy is not None:
        return numpy.asarray(as_column(utimes), dtype=float) / 1e6
    seconds: Any = array("d", [utime / 1e6 for utime in utimes])
    return seconds


class Column:
    """A member of all rows."""

    def __init__(self) -> None:
        self._final: Any = None

    def extend(self, values: Iterable[Any]) -> None:
        raise NotImplementedError

    def _finish(self) -> Any:
        raise NotImplementedError

    @property
    def values(self) -> Any:
        """What a user is given; no rows come after it."""
        if self._final is None:
            self._final = self._finish()
        return self._final


class NumberColumn(Column):
    """One number or boolean per row."""

    def __init__(self, type_name: str) -> None:
        super().__init__()
        self._is_boolean = type_name == "boolean"
        self.typecode = _TYPE_CODES[type_name]
        self._numbers: Any = array(self.typecode)

    def extend(self, values: Iterable[Any]) -> None:
        self._numbers.extend(values)

    def take(self, numbers: Any) -> None:
        """Takes an array of numpy as the whole column, in any byte order."""
        self._numbers = numbers.astype(numbers.dtype.newbyteorder("="))

    def _finish(self) -> Any:
        if self._is_boolean:
            if numpy is None:
                return [number != 0 for number in self._numbers]
            return numpy.asarray(as_column(self._numbers)) != 0
        return as_column(self._numbers)


class ObjectColumn(Column):
    """One text, bytes or list per row."""

    def __init__(self) -> None:
        super().__init__()
        self._objects: Any = []

    def extend(self, values: Iterable[Any]) -> None:
        self._objects.extend(values)

    def take(self, objects: Any) -> None:
        """Takes an array of numpy as the whole column."""
        self._objects = objects

    def _finish(self) -> Any:
        return as_column(self._objects)


class StructColumn(Column):
    """Any number of structs per row: rows of a table of their own."""

    def __init__(self, num_dimensions: int, codec: Codec, codecs: dict[str, Codec]) -> None:
        super().__init__()
        self._num_dimensions = num_dimensions
        self.codec = codec
        self._codecs = codecs
        self._rows: StructColumns | None = None  # A struct may hold itself.
        self.counts = array("q")  #: For each row of the table, those here.

    @property
    def rows(self) -> StructColumns:
        if self._rows is None:
            self._rows = StructColumns(self.codec, self._codecs)
        return self._rows

    def extend(self, values: Iterable[Any]) -> None:
        if self._num_dimensions == 0:
            flat = list(values)
            self.counts.extend(repeat(1, len(flat)))
        else:
            lists = list(values)
            for _ in range(self._num_dimensions - 1):
                lists = [list(chain.from_iterable(each)) for each in lists]
            self.counts.extend(map(len, lists))
            flat = list(chain.from_iterable(lists))
        if flat:
            self.rows.extend(flat)

    def _finish(self) -> Any:
        return None


class StructColumns:
    """The columns of a struct, by member."""

    def __init__(self, codec: Codec, codecs: dict[str, Codec]) -> None:
        self.codec = codec
        self.columns: dict[str, Column] = {
            each.name: self._column(each, codecs) for each in codec.struct.members
        }
        self.num_rows = 0

    @staticmethod
    def _column(member: Member, codecs: dict[str, Codec]) -> Column:
        if not member.is_primitive:
            return StructColumn(len(member.dimensions), codecs[member.type_name], codecs)
        if member.dimensions or member.type_name == "string":
            return ObjectColumn()
        return NumberColumn(member.type_name)

    def extend(self, rows: Sequence[Row]) -> None:
        """Takes a batch of rows."""
        self.num_rows += len(rows)
        for column, values in zip(self.columns.values(), zip(*rows, strict=True), strict=False):
            column.extend(values)

    def extend_all(self, rows: Iterator[Row]) -> None:
        """Takes rows as they come, in batches."""
        batch = []
        for row in rows:
            batch.append(row)
            if len(batch) == _BATCH:
                self.extend(batch)
                batch = []
        if batch:
            self.extend(batch)

    def take_flat(self, messages: list[bytes]) -> None:
        """Takes whole messages of a struct of single numbers, all rows of it."""
        flat = self.codec.flat
        assert flat is not None
        prefix = self.codec.fingerprint_bytes
        for i, message in enumerate(messages):
            if not message.startswith(prefix):
                raise DecodeError(f"message {i} has the fingerprint of another type")
        if numpy is None:
            for begin in range(0, len(messages), _BATCH):
                part = b"".join(messages[begin : begin + _BATCH])
                self.extend(list(flat.iter_unpack(part)))
            return
        self.num_rows = len(messages)
        if not self.columns:
            return
        formats = [_NUMPY_TYPES[_code(each)] for each in self.columns.values()]
        layout = numpy.dtype([("", "V8"), *((f"c{i}", each) for i, each in enumerate(formats))])
        read = numpy.frombuffer(b"".join(messages), dtype=layout)
        for i, column in enumerate(self.columns.values()):
            assert isinstance(column, NumberColumn)
            column.take(read[f"c{i}"])


def _code(column: Column) -> str:
    assert isinstance(column, NumberColumn)
    return column.typecode


def may_be_flat(codec: Codec) -> bool:
    """Returns true where take_flat serves for messages of this struct."""
    return flat_format(codec.struct.members) is not None


__all__ = ["StructColumn", "StructColumns", "as_column", "is_bytes", "may_be_flat", "seconds_of"]
