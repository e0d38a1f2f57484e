"""COMMS_FATES, whose messages have fates as columns."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import shoal
from conftest import log_bytes
from shoal import fate_columns as fate_columns_module

pytestmark = pytest.mark.usefixtures("each_kind_of_column")

T = shoal.types


def write(folder: Path, data: bytes) -> Path:
    path = folder / "a.lcm"
    path.write_bytes(data)
    return path


def fate(**members: object) -> shoal.Message:
    return T.fate_t(kind="report", source="alpha", destination="bravo", count=1, **members)


def fate_columns(**changed: Any) -> shoal.Message:
    """Two fates of one report: delivered at 12.5 m, and five others without a range."""
    members: dict[str, Any] = {
        "utime": 3,
        "senders": [T.fate_sender_t(kind="report", source="alpha", number=7, num_fates=2)],
        "cases": [
            T.fate_case_t(cause="delivered", age_s=0.5, has_range=True),
            T.fate_case_t(cause="out_of_range", has_count=True, has_path=True),
        ],
        "names": ["bravo", "*"],
        "destination": [0, 1],
        "which_case": [0, 1],
        "range_m": [12.5],
        "count": [5],
        "path": [T.acoustic_path_t(air_s=1.0)],
    }
    return T.comms_fate_columns_t(**(members | changed))


def test_fates_in_columns_are_read_as_lists_of_them(tmp_path: Path) -> None:
    columns = fate_columns().encode()
    old = T.comms_fates_t(utime=2, fates=[fate(cause="damaged")]).encode()
    both = log_bytes([(0, "COMMS_FATES", columns), (1, "COMMS_FATES", old)])
    log = shoal.read(write(tmp_path, both))
    fates = log.fates()
    assert list(fates.cause) == ["delivered", "out_of_range", "damaged"]
    assert list(fates.destination) == ["bravo", "*", "bravo"]
    assert list(fates.count) == [1, 5, 1]
    assert list(fates.number[:2]) == [7, 7]
    assert list(fates.range_m[:2]) == [12.5, -1]
    assert list(fates.age_s[:2]) == [0.5, 0]
    assert list(fates.path.air_s) == [1.0]
    assert log["COMMS_FATES"].type == "shoal.comms_fates_t"
    first = next(iter(log)).message
    assert (first.TYPE, first.fates[0].range_m) == ("shoal.comms_fates_t", 12.5)
    assert T.comms_fate_columns_t.decode(columns).names == ["bravo", "*"], "by its own type"


@pytest.mark.parametrize(
    "changed",
    [
        {"destination": [0, 2]},
        {"destination": [0, -1]},
        {"which_case": [0, 2]},
        {"range_m": []},
        {"range_m": [1.0, 2.0]},
        {"path": []},
        {"senders": []},
        {"destination": [0], "which_case": [0]},
        {
            "destination": [0, 1, 0],
            "which_case": [0, 0, 0],
            "cases": [T.fate_case_t(cause="delivered")],
            "range_m": [],
            "count": [],
            "path": [],
        },
        {"senders": [T.fate_sender_t(num_fates=2), T.fate_sender_t()]},
    ],
)
def test_fates_whose_columns_do_not_fit_one_another_are_an_error(
    tmp_path: Path, changed: dict[str, Any]
) -> None:
    log = log_bytes([(0, "COMMS_FATES", fate_columns(**changed).encode())])
    with pytest.raises(shoal.LogError):
        shoal.read(write(tmp_path, log)).fates()


def test_fates_are_read_up_to_a_number_of_bytes_of_text(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cases = [T.fate_case_t(cause="delivered", override_rule="critical_range")] * 2
    columns = fate_columns(cases=cases, range_m=[], count=[], path=[])
    path = write(tmp_path, log_bytes([(0, "COMMS_FATES", columns.encode())]))
    texts = 2 * len("report" + "alpha" + "delivered" + "critical_range") + len("bravo" + "*")
    monkeypatch.setattr(fate_columns_module, "_MAX_TEXT_OF_FATE", 1)
    monkeypatch.setattr(fate_columns_module, "_MAX_TEXTS", texts - 2)
    assert len(shoal.read(path).fates()) == 2
    monkeypatch.setattr(fate_columns_module, "_MAX_TEXTS", texts - 3)
    with pytest.raises(shoal.LogError):
        shoal.read(path).fates()
