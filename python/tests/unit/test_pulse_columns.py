"""VIEW_COMMS_PULSE, whose messages have pulses as columns."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import shoal
from conftest import log_bytes
from shoal import pulse_columns as pulse_columns_module

pytestmark = pytest.mark.usefixtures("each_kind_of_column")

T = shoal.types


def write(folder: Path, data: bytes) -> Path:
    path = folder / "a.lcm"
    path.write_bytes(data)
    return path


def pulse_columns(**changed: Any) -> shoal.Message:
    """A report from alpha to bravo, and a message back."""
    members: dict[str, Any] = {
        "utime": 3,
        "ends": [
            T.pulse_end_t(vehicle="ALPHA", x_m=1.0, y_m=2.0),
            T.pulse_end_t(vehicle="BRAVO", x_m=3.0, y_m=4.0),
        ],
        "styles": [
            T.pulse_style_t(duration_s=10.0, fill=0.35, ptype="nrep", fill_color="red"),
            T.pulse_style_t(label_end="_MSG", ptype="msg", edge_color="green", edge_size=1.0),
        ],
        "source": [0, 1],
        "destination": [1, 0],
        "style": [0, 1],
        "beam_width_m": [12.5, 5.0],
    }
    return T.comms_pulse_columns_t(**(members | changed))


def test_pulses_in_columns_are_read_as_lists_of_them(tmp_path: Path) -> None:
    columns = pulse_columns().encode()
    old = T.comms_pulses_t(utime=2, pulses=[T.comms_pulse_t(label="X2Y")]).encode()
    both = log_bytes([(0, "VIEW_COMMS_PULSE", columns), (1, "VIEW_COMMS_PULSE", old)])
    log = shoal.read(write(tmp_path, both))
    assert log["VIEW_COMMS_PULSE"].type == "shoal.comms_pulses_t"
    first, last = (each.message for each in log)
    assert [pulse.label for pulse in first.pulses] == ["ALPHA2BRAVO", "BRAVO2ALPHA_MSG"]
    assert [pulse.label for pulse in last.pulses] == ["X2Y"]
    report = first.pulses[0]
    assert (report.sx_m, report.sy_m, report.tx_m, report.ty_m) == (1, 2, 3, 4)
    assert (report.beam_width_m, report.duration_s, report.fill) == (12.5, 10, 0.35)
    assert (report.ptype, report.fill_color, report.edge_color) == ("nrep", "red", "")
    assert (first.pulses[1].edge_color, first.pulses[1].edge_size) == ("green", 1)
    assert T.comms_pulse_columns_t.decode(columns).style == [0, 1], "by its own type"


@pytest.mark.parametrize("column", ["source", "destination", "style"])
@pytest.mark.parametrize("index", [-1, 2])
def test_pulses_whose_columns_do_not_fit_one_another_are_an_error(
    tmp_path: Path, column: str, index: int
) -> None:
    columns = pulse_columns(**{column: [0, index]})
    log = log_bytes([(0, "VIEW_COMMS_PULSE", columns.encode())])
    with pytest.raises(shoal.LogError):
        _ = shoal.read(write(tmp_path, log))["VIEW_COMMS_PULSE"].utime


def test_pulses_whose_texts_would_fill_the_memory_are_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write(tmp_path, log_bytes([(0, "VIEW_COMMS_PULSE", pulse_columns().encode())]))
    texts = len("ALPHA2BRAVO" "nrep" "red" "BRAVO2ALPHA_MSG" "msg" "green")
    monkeypatch.setattr(pulse_columns_module, "_MAX_TEXT_OF_PULSE", 0)
    monkeypatch.setattr(pulse_columns_module, "_MAX_TEXTS", texts)
    assert len(shoal.read(path)["VIEW_COMMS_PULSE"].utime) == 1
    monkeypatch.setattr(pulse_columns_module, "_MAX_TEXTS", texts - 1)
    with pytest.raises(shoal.LogError):
        _ = shoal.read(path)["VIEW_COMMS_PULSE"].utime
