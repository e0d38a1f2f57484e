"""Reads the results of a campaign: DIR/results.csv, a line for each trial."""

from __future__ import annotations

import csv
import os
from array import array
from collections.abc import Iterator
from typing import Any

from .columns import as_column
from .errors import ResultsError

_LARGEST_CELL = 1 << 20  # Bytes.


class Results:
    """Columns by the names in the file's first line; results.seed is results["seed"].

    A column of whole numbers is of ints, one of numbers of floats, with nan for an empty cell; all
    others are texts, with None for an empty cell. Names such as "comms.comms_range" are no
    attributes: results["comms.comms_range"].
    """

    def __init__(self, path: str, columns: dict[str, list[str]], num_rows: int) -> None:
        self.path = path
        self._num_rows = num_rows
        self._cells = columns
        self._columns: dict[str, Any] = {}

    @property
    def columns(self) -> list[str]:
        """The names, in the order of the file."""
        return list(self._cells)

    def __len__(self) -> int:
        """The number of trials."""
        return self._num_rows

    def __contains__(self, name: object) -> bool:
        return name in self._cells

    def __getitem__(self, name: str) -> Any:
        if name not in self._cells:
            raise KeyError(f"{self.path} has no column '{name}'; it has {', '.join(self._cells)}")
        if name not in self._columns:
            self._columns[name] = as_column(_typed(self._cells[name]))
        return self._columns[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Returns each trial as a dict."""
        columns = {name: self[name] for name in self._cells}
        for i in range(len(self)):
            yield {name: column[i] for name, column in columns.items()}

    def as_dict(self) -> dict[str, Any]:
        """Returns all columns: pandas.DataFrame(results.as_dict())."""
        return {name: self[name] for name in self._cells}

    def __repr__(self) -> str:
        return f"<{self.path}: {len(self)} trials: {', '.join(self._cells)}>"


def _typed(cells: list[str]) -> Any:
    present = [cell for cell in cells if cell]
    try:
        if present and len(present) == len(cells):
            return array("q", map(int, cells))
    except (ValueError, OverflowError):
        pass
    try:
        if present:
            return array("d", [float(cell) if cell else float("nan") for cell in cells])
    except ValueError:
        pass
    return [cell or None for cell in cells]


def campaign(folder: str | os.PathLike[str]) -> Results:
    """Returns the results of the campaign in `folder`, or those of a results.csv itself.

    Raises:
        ResultsError: with the file, and the line where there is one.
    """
    path = os.fspath(folder)
    if os.path.isdir(path):
        path = os.path.join(path, "results.csv")
    if not os.path.isfile(path):
        raise ResultsError(f"{path}: there is no such file; a finished campaign has one")
    try:
        with open(path, encoding="utf-8-sig", errors="backslashreplace", newline="") as file:
            return _read(path, file)
    except OSError as error:
        raise ResultsError(f"{path}: cannot be read: {error.strerror}") from None


def _read(path: str, file: Any) -> Results:
    limit = csv.field_size_limit(_LARGEST_CELL)
    reader = csv.reader(file, strict=True)
    try:
        names: list[str] = next(reader, [])
        if not names or "" in names or len(set(names)) != len(names):
            raise ResultsError(f"{path}:1: the first line names each column, each once")
        columns: list[list[str]] = [[] for _ in names]
        count = 0
        for row in reader:
            if not row:
                continue
            if len(row) != len(names):
                raise ResultsError(
                    f"{path}:{reader.line_num}: {len(row)} cells, where the first line names "
                    f"{len(names)} columns"
                )
            count += 1
            for column, cell in zip(columns, row, strict=True):
                column.append(cell)
    except csv.Error as error:
        raise ResultsError(f"{path}:{reader.line_num}: {error}") from error
    finally:
        csv.field_size_limit(limit)
    return Results(path, dict(zip(names, columns, strict=True)), count)
