"""Logs as records and as columns."""

from __future__ import annotations

import subprocess
import warnings
from pathlib import Path

import pytest
import shoal
from conftest import ROOT, SCHEMA_TEST_TYPES, event, log_bytes
from shoal.seal import Seal, append_seal

pytestmark = pytest.mark.usefixtures("each_kind_of_column")

T = shoal.types


def write(tmp_path: Path, data: bytes) -> Path:
    path = tmp_path / "mission.lcm"
    path.write_bytes(data)
    return path


def nav_log(count: int = 3) -> bytes:
    return log_bytes(
        (100_000 * i, "NAV_ALPHA", T.nav_t(utime=i, x_m=i / 2).encode()) for i in range(count)
    )


def fate(**members: object) -> shoal.Message:
    return T.fate_t(kind="report", source="alpha", destination="bravo", count=1, **members)


def fates_log() -> bytes:
    path = T.acoustic_path_t(air_s=1.0, travel_s=0.5, colliders=["bravo 1", "bravo 2"])
    messages = [
        T.comms_fates_t(utime=1, fates=[fate(cause="delivered", number=7, path=[path])]),
        T.comms_fates_t(utime=2),
        T.comms_fates_t(
            utime=3, fates=[fate(cause="out_of_range", range_m=300.0), fate(cause="damaged")]
        ),
    ]
    return log_bytes((i * 10**6, "COMMS_FATES", each.encode()) for i, each in enumerate(messages))


def test_columns_hold_the_members_of_all_messages(tmp_path: Path) -> None:
    nav = shoal.read(write(tmp_path, nav_log()))["NAV_ALPHA"]
    assert list(nav.x_m) == [0, 0.5, 1]
    assert list(nav.utime) == [0, 1, 2]
    assert list(nav.time_s) == [0, 0.1, 0.2]
    assert list(nav["event"]) == [0, 1, 2]
    assert (len(nav), nav.type, nav.columns[:2]) == (3, "shoal.nav_t", ("utime", "x_m"))
    assert [row.x_m for row in nav] == [0, 0.5, 1]
    assert (nav[-1].time_s, nav[-1]["x_m"]) == (0.2, 1)
    assert set(nav.as_dict()) == {"time_s", *nav.columns}


def test_a_table_is_a_data_frame_of_pandas(tmp_path: Path) -> None:
    why = "no pandas: scripts/setup --with-tests installs it"
    pandas = pytest.importorskip("pandas", reason=why)
    nav = shoal.read(write(tmp_path, nav_log()))["NAV_ALPHA"]
    frame = pandas.DataFrame(nav)
    assert list(frame.columns) == ["time_s", *nav.columns]
    assert list(frame.x_m) == [0, 0.5, 1]
    pandas.testing.assert_frame_equal(frame, pandas.DataFrame(nav.as_dict()))
    fates = shoal.read(write(tmp_path, fates_log()))["COMMS_FATES"]
    assert list(pandas.DataFrame(fates).utime) == list(fates.utime), "without the tables in it"


def test_a_row_is_taken_apart_as_a_named_tuple_is(tmp_path: Path) -> None:
    row = shoal.read(write(tmp_path, nav_log()))["NAV_ALPHA"][1]
    assert dict(zip(row._fields, row, strict=True))["x_m"] == 0.5
    assert (len(row), row[0]) == (len(row._fields), 0.1)
    assert not hasattr(row, "ndim")
    with pytest.raises(KeyError, match="no column 'no_such'"):
        row["no_such"]


def test_columns_of_numbers_are_numpys_where_it_is_there(
    tmp_path: Path, each_kind_of_column: str
) -> None:
    nav = shoal.read(write(tmp_path, nav_log()))["NAV_ALPHA"]
    if each_kind_of_column == "numpy":
        assert str(nav.x_m.dtype) == "float64" and nav.x_m.dtype.isnative
        assert (nav.x_m * 2).tolist() == [0, 1, 2]
        assert str(nav.time_s.dtype) == "float64"
    else:
        assert nav.x_m.typecode == "d"


def test_what_does_not_exist_is_named_with_what_does(tmp_path: Path) -> None:
    log = shoal.read(write(tmp_path, nav_log()))
    with pytest.raises(KeyError, match="no channel 'NAV_BRAVO'; it has NAV_ALPHA"):
        log["NAV_BRAVO"]
    with pytest.raises(AttributeError, match="NAV_ALPHA has no column 'x'; it has utime, x_m"):
        log["NAV_ALPHA"].x  # noqa: B018
    with pytest.raises(IndexError, match="3 rows; there is no row 3"):
        log["NAV_ALPHA"][3]
    assert "NAV_ALPHA" in log and "NAV_BRAVO" not in log
    assert "x_m" in log["NAV_ALPHA"] and "x" not in log["NAV_ALPHA"]


def test_structs_in_messages_are_rows_of_a_table_of_their_own(tmp_path: Path) -> None:
    fates = shoal.read(write(tmp_path, fates_log())).fates()
    assert list(fates.cause) == ["delivered", "out_of_range", "damaged"]
    assert list(fates.time_s) == [0, 2, 2]
    assert list(fates.event) == [0, 2, 2]
    assert list(fates.path.air_s) == [1.0]
    assert list(fates.path.event) == [0]
    assert list(fates.path.colliders[0]) == ["bravo 1", "bravo 2"]
    assert [len(row.path) for row in fates] == [1, 0, 0]
    assert fates[0].path[0].travel_s == 0.5


def test_rows_of_a_table_inside_belong_to_their_message(tmp_path: Path) -> None:
    messages = shoal.read(write(tmp_path, fates_log()))["COMMS_FATES"]
    assert [[fate.cause for fate in row.fates] for row in messages] == [
        ["delivered"],
        [],
        ["out_of_range", "damaged"],
    ]


def test_a_log_without_fates_has_an_empty_table_of_them(tmp_path: Path) -> None:
    log = shoal.read(write(tmp_path, nav_log()))
    assert len(log.fates()) == len(log.fates().cause) == len(log.media()) == 0
    assert log.links() == []


def test_fields_of_ones_own_are_found_by_their_key(tmp_path: Path) -> None:
    pair = T.key_value_t
    reports = [
        T.node_report_t(name="alpha", index=4, extra=[pair(key="battery", value="80")]),
        T.node_report_t(name="bravo", index=5),
    ]
    log = log_bytes((0, "NODE_REPORT_LOCAL", each.encode()) for each in reports)
    table = shoal.read(write(tmp_path, log))["NODE_REPORT_LOCAL"]
    assert list(table.extra.by_key("battery")) == ["80", None]
    assert list(table.index) == [4, 5]
    with pytest.raises(KeyError, match="has no columns 'key' and 'value'"):
        table.by_key("battery")


def test_booleans_bytes_and_lists_are_columns(tmp_path: Path) -> None:
    rules = T.comms_rules_t(vehicles=["a", "b"], acoustic_addresses=[3, 4], groups=True)
    rules.acoustic_leaders = [True, False]
    packet = T.acoustic_tx_t(payload=b"\x01\xff")
    path = write(tmp_path, event(0, 0, "R", rules.encode()) + event(1, 0, "P", packet.encode()))
    log = shoal.read(path)
    assert list(log["R"].groups) == [True] and list(log["R"].is_start) == [False]
    assert list(log["R"].acoustic_addresses[0]) == [3, 4]
    assert list(log["R"].acoustic_leaders[0]) == [True, False]
    assert list(log["P"].payload) == [b"\x01\xff"]


def test_records_come_in_file_order(tmp_path: Path) -> None:
    data = log_bytes(
        [
            (5, "B", T.nav_t(x_m=1).encode()),
            (6, "A", T.desired_t(depth_m=2).encode()),
            (7, "B", T.nav_t(x_m=3).encode()),
        ]
    )
    log = shoal.read(write(tmp_path, data))
    assert [(each.channel, each.utime) for each in log] == [("B", 5), ("A", 6), ("B", 7)]
    assert [each.message for each in log] == [
        T.nav_t(x_m=1),
        T.desired_t(depth_m=2),
        T.nav_t(x_m=3),
    ]
    assert len(log) == 3 and log.channels == ["A", "B"]


def test_seals_of_lcm_loggers_logs_are_taken_off(tmp_path: Path) -> None:
    seal = Seal(b"vehicle_sim_alpha", 1, 2, 3)
    sealed = [append_seal(T.nav_t(x_m=x).encode(), seal, b"s" * 32, "NAV_ALPHA") for x in (1, 2)]
    log = shoal.read(write(tmp_path, log_bytes((0, "NAV_ALPHA", each) for each in sealed)))
    assert list(log["NAV_ALPHA"].x_m) == [1, 2]
    assert [each.message.x_m for each in log] == [1, 2]
    assert next(iter(log)).data == T.nav_t(x_m=1).encode()


def test_types_of_ones_own_are_decoded(tmp_path: Path) -> None:
    types = shoal.Types([SCHEMA_TEST_TYPES])
    shapes = types.shapes_t(matrix=[[1.0, 2.0]], raw=b"ab", words=["one"], text="t")
    shapes.track = [types.point_t(x_m=3)]
    path = write(tmp_path, event(0, 0, "SHAPES", shapes.encode()))
    with pytest.raises(shoal.LogError, match=r"byte 34: channel SHAPES: its type is not known"):
        shoal.read(path)["SHAPES"]
    with pytest.raises(shoal.LogError, match=r"byte 34: channel SHAPES: no known type"):
        next(iter(shoal.read(path))).message  # noqa: B018
    table = shoal.read(path, types=[SCHEMA_TEST_TYPES])["SHAPES"]
    assert table[0].matrix == [[1.0, 2.0]] and table[0].text == "t"
    assert list(table.origin.x_m) == [0] and list(table.corners.event) == [0, 0]
    assert list(table.track.x_m) == [3]
    assert list(shoal.read(path, types=types)["SHAPES"].raw) == [b"ab"]


def test_a_torn_log_is_read_up_to_its_last_whole_event(tmp_path: Path) -> None:
    whole = nav_log(3)
    for cut in range(len(nav_log(2)) + 1, len(whole)):
        with pytest.warns(shoal.LogWarning, match="byte 410: the log ends inside an event"):
            log = shoal.read(write(tmp_path, whole[:cut]))
        assert len(log) == 2 and log.is_torn
        assert list(log["NAV_ALPHA"].x_m) == [0, 0.5]


def test_a_whole_log_gives_no_warning(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        log = shoal.read(write(tmp_path, nav_log()))
        empty = shoal.read(write(tmp_path, b""))
    assert not log.is_torn and log.num_damages == 0
    assert len(empty) == 0 and empty.channels == []


def test_what_is_no_log_is_refused_with_file_and_byte(tmp_path: Path) -> None:
    path = write(tmp_path, b"GIF89a")
    with pytest.raises(shoal.LogError, match="not an LCM event log") as error:
        shoal.read(path)
    assert (error.value.path, error.value.offset) == (str(path), 0)
    with pytest.raises(shoal.LogError, match="No such file or directory"):
        shoal.read(tmp_path / "none.lcm")
    with pytest.raises(shoal.LogError, match="no regular file"):
        shoal.read("/dev/zero")


def test_damage_is_refused_with_its_byte_or_skipped(tmp_path: Path) -> None:
    one = len(nav_log(1))
    path = write(tmp_path, nav_log(2) + b"junk" + nav_log(2))
    with pytest.raises(shoal.LogError, match=f"byte {2 * one}: no event begins here"):
        shoal.read(path)
    with pytest.warns(shoal.LogWarning, match="no event begins here"):
        log = shoal.read(path, skip_damage=True)
    assert list(log["NAV_ALPHA"].x_m) == [0, 0.5, 0, 0.5]
    assert [each.offset for each in log.damages] == [2 * one]


def test_an_undecodable_message_is_refused_with_its_byte_or_left_out(tmp_path: Path) -> None:
    good, bad = T.helm_state_t(task="loiter").encode(), T.helm_state_t().encode()[:-1]
    path = write(tmp_path, log_bytes((i, "H", each) for i, each in enumerate([good, bad, good])))
    with pytest.raises(shoal.LogError, match="channel H: the message ends too early") as error:
        shoal.read(path)["H"]
    assert path.read_bytes()[error.value.offset :].startswith(bad)
    log = shoal.read(path, skip_damage=True)
    assert list(log["H"].task) == ["loiter", "loiter"] and list(log["H"].event) == [0, 2]
    assert log.num_damages == 1


def test_a_log_that_is_larger_than_memory_should_hold_is_read_in_parts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("shoal.log_file._WHOLE", 100)
    monkeypatch.setattr("shoal.log_file._WINDOW", 512)
    monkeypatch.setattr("shoal.log_file._LARGEST_GAP", 64)
    messages = []
    for i in range(50):
        messages.append((i, "NAV_ALPHA", T.nav_t(x_m=i).encode()))
        if i % 7 == 0:
            messages.append((i, "TEXT", T.key_value_t(key=str(i), value="x" * 40 * i).encode()))
    log = shoal.read(write(tmp_path, log_bytes(messages)))
    assert list(log["NAV_ALPHA"].x_m) == list(range(50))
    assert list(log["TEXT"].key) == [str(i) for i in range(0, 50, 7)]
    assert [each.data for each in log] == [data for _, _, data in messages]


def test_vehicles_are_those_of_the_rules_else_of_nav(tmp_path: Path) -> None:
    assert shoal.read(write(tmp_path, nav_log())).vehicles == ["ALPHA"]
    rules = T.comms_rules_t(
        vehicles=["zulu", "alpha"], acoustic_addresses=[0, 0], acoustic_leaders=[False, False]
    )
    path = write(tmp_path, nav_log() + event(9, 0, "COMMS_RULES", rules.encode()))
    assert shoal.read(path).vehicles == ["zulu", "alpha"]  # Of logs of 0.1 and 0.2.
    vehicle = T.broker_vehicle_t
    now = T.broker_rules_t(vehicles=[vehicle(name="zulu"), vehicle(name="bravo")])
    later = T.broker_rules_t(vehicles=[vehicle(name="late")])
    both = event(9, 0, "COMMS_RULES", now.encode()) + event(9, 0, "COMMS_RULES", later.encode())
    assert shoal.read(write(tmp_path, nav_log() + both)).vehicles == ["zulu", "bravo"]


@pytest.mark.parametrize("name", ["two_vessels_0.1", "two_media_0.2"])
def test_logs_of_older_versions_are_read(name: str) -> None:
    log = shoal.read(ROOT / "tests" / "golden" / "logs" / f"{name}.lcm")
    assert log.vehicles == ["alpha", "bravo"]
    assert log["COMMS_RULES"].type == "shoal.comms_rules_t"
    assert {link.kind for link in log.links()} == {"report", "message"}
    assert log.num_damages == 0


def test_links_count_what_was_delivered_and_lost(tmp_path: Path) -> None:
    (link,) = shoal.read(write(tmp_path, fates_log())).links()
    assert (link.kind, link.source, link.destination) == ("report", "alpha", "bravo")
    assert (link.sent, link.delivered, link.damaged, link.num_lost) == (3, 1, 1, 1)
    assert link.lost == {"out_of_range": 1} and link.delays_s == [1.5] and link.media == {}


def test_verdict_and_mission_are_those_beside_the_log(tmp_path: Path) -> None:
    path = write(tmp_path, nav_log())
    log = shoal.read(path)
    assert (log.verdict(), log.mission, log.run) == (None, None, None)
    (tmp_path / "mission.toml").write_text('[mission]\nname = "m"\n')
    (tmp_path / "run.txt").write_text("shoal_version 0.1.0\nseed 7\nwarp max\nset a.b=1\nset c=2\n")
    (tmp_path / "summary.txt").write_text(
        "600.0 s of mission\n\nExpectations\n    pass one: 5 [m.toml:3]\n"
        "    FAIL two: 0 [m.toml:9]\n\nFAIL: 1 of 2 expectations\n"
    )
    log = shoal.read(tmp_path)
    assert log.mission == {"mission": {"name": "m"}}
    assert log.run is not None and log.run.seed == 7 and log.run.overrides == ("a.b=1", "c=2")
    verdict = log.verdict()
    assert verdict is not None and not verdict.passed and verdict.line.startswith("FAIL: 1 of 2")
    assert [each.passed for each in verdict.expectations] == [True, False]
    (tmp_path / "mission.toml").write_text("[mission\n")
    with pytest.raises(shoal.Error, match="mission.toml"):
        log.mission  # noqa: B018


def csv_rows(program: Path, log: Path, folder: Path, name: str) -> list[dict[str, str]]:
    import csv

    subprocess.run([program, "log", "comms", log, "--csv", folder], check=True, stdout=-3)
    with open(folder / name, newline="") as file:
        return list(csv.DictReader(file))


def test_links_are_those_of_shoal_log_comms(
    shoal_program: Path, recorded_logs: dict[str, Path], tmp_path: Path
) -> None:
    for name, path in recorded_logs.items():
        links = shoal.read(path).links()
        shown = csv_rows(shoal_program, path, tmp_path / name, "links.csv")
        losses = csv_rows(shoal_program, path, tmp_path / name, "losses.csv")
        assert len(links) > 10
        assert sorted(
            (each.kind, each.source, each.destination, str(each.sent), str(each.delivered))
            + (str(each.damaged), str(each.num_lost))
            for each in links
        ) == sorted(
            (row["kind"], row["source"], row["destination"], row["sent"], row["delivered"])
            + (row["damaged"], row["lost"])
            for row in shown
        )
        assert sorted(
            (each.kind, each.source, each.destination, cause, str(count))
            for each in links
            for cause, count in each.lost.items()
        ) == sorted(tuple(row.values()) for row in losses)
    media = csv_rows(shoal_program, recorded_logs["search_gateway"], tmp_path / "m", "media.csv")
    links = shoal.read(recorded_logs["search_gateway"]).links()
    assert sorted(
        (each.kind, medium, str(hop), each.source, each.destination)
        + (str(count.sent), str(count.delivered))
        for each in links
        for (medium, hop), count in each.media.items()
    ) == sorted(tuple(row.values())[:7] for row in media)


def test_each_message_of_a_recorded_log_is_encoded_as_it_was(
    recorded_logs: dict[str, Path],
) -> None:
    log = shoal.read(recorded_logs["acoustic"])
    assert len(log) > 100_000
    by_own_type = {  # Otherwise they are read as lists.
        "COMMS_FATES": T.comms_fate_columns_t,
        "VIEW_COMMS_PULSE": T.comms_pulse_columns_t,
    }
    for each in log:
        own = by_own_type.get(each.channel)
        message = each.message if own is None else own.decode(each.data)
        assert message.encode() == each.data
