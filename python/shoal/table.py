"""A table: the messages of a channel, or the structs in them, by columns and by rows.

    nav = log["NAV_ALPHA"]
    nav.time_s, nav.x_m                  columns; numpy's arrays where numpy is there
    for row in nav: print(row.time_s, row.x_m)
    log["COMMS_FATES"].fates.cause       of each fate of each message
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from itertools import accumulate, chain, repeat
from typing import Any, overload

from .codec import attribute_name
from .columns import Floats, Integers, StructColumn, StructColumns, as_column, seconds_of


class Row:
    """One row of a table; its members are attributes. Structs in it are a list of rows.

    It can be taken apart as a named tuple can, without the tables in it: tuple(row), row._fields,
    pandas.DataFrame(table).
    """

    __slots__ = ("_index", "_table")

    def __init__(self, table: Table, index: int) -> None:
        self._table = table
        self._index = index

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __getitem__(self, which: str | int) -> Any:
        name = which if isinstance(which, str) else self._fields[which]
        return self._table._cell(name, self._index)

    @property
    def _fields(self) -> tuple[str, ...]:
        return self._table._plain_names

    def __iter__(self) -> Iterator[Any]:
        return (self[name] for name in self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    def __repr__(self) -> str:
        cells = ", ".join(f"{name}={self[name]!r}" for name in ("time_s", *self._table.columns))
        return f"Row({cells})"


# Not a subclass: its methods would hide members of messages that are called count or index.
Sequence.register(Row)


class Table:
    """Columns of equal length, as attributes and by name: table.x_m is table["x_m"].

    Attributes:
        name: The channel, with the member of a table in it: "COMMS_FATES.fates".
        columns: The names of the columns, beside time_s and event.
    """

    def __init__(
        self, name: str, rows: StructColumns, utimes: Sequence[int], events: Sequence[int]
    ) -> None:
        self.name = name
        self._rows = rows
        self._utimes = utimes
        self._events = events
        self.columns = tuple(rows.columns)
        self._by_attribute = {attribute_name(each): each for each in self.columns}
        self._tables: dict[str, Table] = {}
        self._starts: dict[str, list[int]] = {}

    @property
    def type(self) -> str:
        """The struct of a row, such as "shoal.nav_t"."""
        return self._rows.codec.struct.full_name

    @property
    def time_s(self) -> Floats:
        """The time of each row: of its message in the log; mission time in mission.lcm."""
        return seconds_of(self._utimes)

    @property
    def event(self) -> Integers:
        """For each row the number of its event in the log; in a table inside, of its outer row."""
        events: Integers = as_column(self._events)
        return events

    def __len__(self) -> int:
        return self._rows.num_rows

    def __iter__(self) -> Iterator[Row]:
        return (Row(self, i) for i in range(len(self)))

    @overload
    def __getitem__(self, which: int) -> Row: ...

    @overload
    def __getitem__(self, which: str) -> Any: ...

    def __getitem__(self, which: str | int) -> Any:
        """Returns a column by its name, or a row by its number."""
        if isinstance(which, str):
            return self._column(which)
        number = which + len(self) if which < 0 else which
        if not 0 <= number < len(self):
            raise IndexError(f"{self.name} has {len(self)} rows; there is no row {which}")
        return Row(self, number)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        try:
            return self._column(name)
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __contains__(self, name: object) -> bool:
        return name in self.columns

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._by_attribute]

    def __repr__(self) -> str:
        return f"<{self.name}: {len(self)} rows of {self.type}: {', '.join(self.columns)}>"

    def as_dict(self) -> dict[str, Any]:
        """Returns time_s and all columns but tables.

        pandas.DataFrame(table.as_dict()) equals pandas.DataFrame(table), and is faster.
        """
        columns = self._rows.columns
        return {
            "time_s": self.time_s,
            **{name: columns[name].values for name in self._plain_names[1:]},
        }

    def by_key(self, key: str) -> Any:
        """Returns the values of a key in a table of pairs, one for each row that this table is in.

        Of node reports' own fields: log["NODE_REPORT_LOCAL"].extra.by_key("battery"). None where a
        row has no such key; the last where it has several.
        """
        if "key" not in self.columns or "value" not in self.columns:
            raise KeyError(f"{self.name} has no columns 'key' and 'value'")
        values: list[str | None] = [None] * self._num_outer
        events, keys, texts = self._events, self.key, self.value
        for event, each, text in zip(events, keys, texts, strict=True):
            if each == key:
                values[event] = text
        return as_column(values)

    @property
    def _plain_names(self) -> tuple[str, ...]:
        """time_s and all columns but tables."""
        columns = self._rows.columns.items()
        return ("time_s", *(k for k, each in columns if not isinstance(each, StructColumn)))

    _num_outer = 0  # Rows of the table that this is in.

    def _column(self, name: str) -> Any:
        if name in ("time_s", "event") and name not in self._rows.columns:
            return getattr(self, name)
        known = name if name in self._rows.columns else self._by_attribute.get(name)
        if known is None:
            raise KeyError(f"{self.name} has no column '{name}'; it has {', '.join(self.columns)}")
        column = self._rows.columns[known]
        return self._table(known, column) if isinstance(column, StructColumn) else column.values

    def _table(self, name: str, column: StructColumn) -> Table:
        made = self._tables.get(name)
        if made is None:
            utimes = _repeated(self._utimes, column.counts)
            events = _repeated(range(len(self)), column.counts)
            made = Table(f"{self.name}.{name}", column.rows, utimes, events)
            made._num_outer = len(self)
            self._tables[name] = made
            self._starts[name] = list(accumulate(column.counts, initial=0))
        return made

    def _cell(self, name: str, index: int) -> Any:
        if name == "time_s" and name not in self._rows.columns:
            return self._utimes[index] / 1e6
        column = self._column(name)
        if not isinstance(column, Table):
            return column[index]
        name = name if name in self._tables else self._by_attribute[name]
        starts = self._starts[name]
        return [column[i] for i in range(starts[index], starts[index + 1])]


def _repeated(values: Sequence[int], counts: Sequence[int]) -> array[int]:
    """Returns each value as often as its count states."""
    pairs = zip(values, counts, strict=True)
    return array("q", chain.from_iterable(repeat(value, count) for value, count in pairs))
