"""Results of campaigns."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import shoal

pytestmark = pytest.mark.usefixtures("each_kind_of_column")

RESULTS = (
    "case,comms.comms_range,policy,repetition,seed,outcome,why,closest_m,age_s\r\n"
    '0a1b2c3d4e,100,near,1,7,pass,,54.5,\r\n'
    '0a1b2c3d4e,"nolimit",near,2,8,fail,"missed ""two"",\r\nand more",12,3.5\r\n'
)


def write(tmp_path: Path, text: str) -> Path:
    (tmp_path / "results.csv").write_bytes(text.encode())
    return tmp_path


def test_columns_have_the_types_of_their_cells(tmp_path: Path) -> None:
    results = shoal.campaign(write(tmp_path, RESULTS))
    assert len(results) == 2
    assert list(results.repetition) == [1, 2]
    assert list(results.closest_m) == [54.5, 12]
    assert math.isnan(results.age_s[0]) and results.age_s[1] == 3.5
    assert list(results["comms.comms_range"]) == ["100", "nolimit"]
    assert list(results.why) == [None, 'missed "two",\r\nand more']
    assert [trial["seed"] for trial in results] == [7, 8]
    assert results.columns[:3] == ["case", "comms.comms_range", "policy"]


def test_a_column_without_values_and_a_table_without_trials_are_read(tmp_path: Path) -> None:
    assert list(shoal.campaign(write(tmp_path, "a,b\n1,\n2,\n")).b) == [None, None]
    empty = shoal.campaign(write(tmp_path, "a,b\n"))
    assert len(empty) == 0 and list(empty.a) == []


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("", ":1: the first line names each column"),
        ("a,a\n", ":1: the first line names each column, each once"),
        ("a,b\n1,2\n3\n", ":3: 1 cells, where the first line names 2"),
        ('a,b\n1,"2\n', ":2: unexpected end of data"),
        ("a\n" + "x" * (2 << 20), "field larger than field limit"),
    ],
)
def test_what_is_wrong_is_stated_with_its_line(tmp_path: Path, text: str, error: str) -> None:
    with pytest.raises(shoal.ResultsError, match=error):
        shoal.campaign(write(tmp_path, text))


def test_a_missing_file_or_column_is_named(tmp_path: Path) -> None:
    with pytest.raises(shoal.ResultsError, match=r"results\.csv: there is no such file"):
        shoal.campaign(tmp_path)
    with pytest.raises(KeyError, match="no column 'z'; it has a, b"):
        shoal.campaign(write(tmp_path, "a,b\n"))["z"]
