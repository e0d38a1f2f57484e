"""Message types from .lcm files: fingerprints, bytes, errors."""

from __future__ import annotations

import random
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import shoal
from conftest import ROOT, SCHEMA_TEST_TYPES, random_message
from shoal.message import Message

ALL_TYPES = shoal.Types([SCHEMA_TEST_TYPES])

# Run where the classes of lcm-gen are: prints each fingerprint, then decodes and encodes again.
AS_LCM_GEN = """
import importlib, sys
for line in sys.stdin:
    name, data = line.split()
    package, _, short = name.rpartition(".")
    made = getattr(importlib.import_module(name), short)
    data = bytes.fromhex(data)
    # Arrays of booleans are Python 2 in lcm-gen 1.3.1, and sizes like 0x3 are beyond it.
    may_decode = short not in ("comms_rules_t", "shapes_t")
    is_same = not may_decode or made.decode(data).encode() == data
    print(name, made._get_packed_fingerprint().hex(), is_same)
"""


def test_all_types_of_shoal_are_there() -> None:
    files = {f"shoal.{path.stem.removeprefix('shoal_')}" for path in ROOT.glob("lcmtypes/*.lcm")}
    assert set(shoal.types) == files


def test_fingerprints_and_bytes_are_those_of_lcm_gen(tmp_path: Path) -> None:
    generator = shutil.which("lcm-gen")
    if generator is None:
        pytest.skip("there is no lcm-gen; scripts/setup installs it")
    # lcm-gen's Python for its member `from` is none.
    files = [each for each in ROOT.glob("lcmtypes/*.lcm") if each.stem != "shoal_relay_t"]
    files.append(SCHEMA_TEST_TYPES)
    subprocess.run(
        [generator, "-p", "--ppath", tmp_path, *files], check=True, stdout=subprocess.DEVNULL
    )
    draw = random.Random(19)
    names = [each for each in ALL_TYPES if each != "shoal.relay_t"]
    messages = [random_message(ALL_TYPES[name], draw) for name in names for _ in range(5)]
    asked = "".join(f"{message.TYPE} {message.encode().hex()}\n" for message in messages)
    shown = subprocess.run(
        [sys.executable, "-c", AS_LCM_GEN],
        input=asked,
        cwd=tmp_path,  # Python looks there first.
        text=True,
        stdout=subprocess.PIPE,
        check=True,
    ).stdout
    assert shown.splitlines() == [
        f"{message.TYPE} {message.FINGERPRINT:016x} True" for message in messages
    ]


COLUMNS = ("shoal.comms_fate_columns_t", "shoal.comms_pulse_columns_t")


@pytest.mark.parametrize("name", list(ALL_TYPES))
def test_a_decoded_message_equals_what_was_encoded(name: str) -> None:
    draw = random.Random(name)
    for _ in range(20):
        message = random_message(ALL_TYPES[name], draw)
        data = message.encode()
        if name in COLUMNS:  # Types.decode makes a list of it.
            assert ALL_TYPES[name].decode(data) == message
            assert ALL_TYPES[name].decode(data).encode() == data
            continue
        assert ALL_TYPES.decode(data) == message
        assert ALL_TYPES.decode(data).encode() == data


def test_lengths_of_arrays_are_those_that_the_arrays_have() -> None:
    total = shoal.types.step_total_t(publisher="helm_alpha", channel="DESIRED_ALPHA", count=1)
    tick = shoal.types.tick_t(totals=[total], joined=["a", "b"], joined_pids=[4, 5])
    decoded = shoal.types.decode(tick.encode())
    assert (decoded.num_totals, decoded.num_joined) == (1, 2)
    with pytest.raises(ValueError, match="'joined_pids' has 1 elements where 2 belong"):
        shoal.types.tick_t(joined=["a", "b"], joined_pids=[4]).encode()


def test_a_member_that_is_a_keyword_of_python_ends_with_an_underscore() -> None:
    relay = shoal.types.relay_t(from_="alpha")
    assert shoal.types.decode(relay.encode()).from_ == "alpha"


def test_constants_are_attributes_of_the_class() -> None:
    tick: Any = shoal.types.tick_t
    shapes: Any = ALL_TYPES["shapes_t"]
    assert (tick.RUN, tick.END, shapes.SCALE) == (0, 1, -1.5e-3)


def test_what_a_member_cannot_hold_is_refused_with_the_type() -> None:
    with pytest.raises(ValueError, match=r"shoal\.tick_t"):
        shoal.types.tick_t(kind=128).encode()
    with pytest.raises(ValueError, match="NUL"):
        shoal.types.key_value_t(key="a\0b").encode()
    with pytest.raises(TypeError, match="has no member 'x'; it has utime, x_m"):
        shoal.types.nav_t(x=1)
    with pytest.raises(AttributeError):
        shoal.types.nav_t().x = 1


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("struct a_t { int64_t utime }", r"mine\.lcm:1:28: expected ';', found '}'"),
        ("struct a_t {\n  int32_t n;\n  double x[m];\n}", r"mine\.lcm:3:12: an array's length"),
        ("struct a_t { string n; double x[n]; }", "must be a single integer"),
        ("struct a_t { int8_t a, a; }", "'a' is there twice"),
        ("struct a_t { const double N = 3; int8_t b[N]; }", "1:43: the constant 'N' is an array's"),
        (
            "struct a_t { const int8_t N = 0; int8_t b[N]; }",
            "must be a whole number greater than 0",
        ),
        ("struct a_t { int8_t b[N]; const int8_t N = 1; }", "declares before it, found 'N'"),
        ("struct b_t { const int8_t N = 1; } struct a_t { int8_t b[N]; }", "that its struct"),
        ("struct a_t { a_t inner; }", "contains itself"),
        ("enum a_t { A }", "enums have no place"),
        ("struct a_t { const string X = 1; }", "a constant is an integer"),
        ("struct", "expected the name of a struct, found the end of the file"),
        ("package shoal; struct nav_t { int8_t x; }", "is there twice, with other members"),
    ],
)
def test_an_error_of_an_lcm_file_states_where_it_is(
    tmp_path: Path, text: str, error: str
) -> None:
    (tmp_path / "mine.lcm").write_text(text)
    with pytest.raises(shoal.LcmFileError, match=error):
        shoal.Types([tmp_path / "mine.lcm"])


def test_a_constant_of_the_struct_is_the_size_of_an_array(tmp_path: Path) -> None:
    # lcm-gen from 1.4 on makes the hash of the constant's value as written, so a type with the
    # number itself has the same fingerprint.
    (tmp_path / "mine.lcm").write_text(
        "struct named_t { const int32_t DIM = 3, HEX = 0x2; double p[DIM][HEX]; }\n"
        "struct number_t { double p[3][0x2]; }\n"
        "struct other_t { double p[3][2]; }\n"
    )
    types = shoal.Types([tmp_path / "mine.lcm"])
    assert types.named_t.FINGERPRINT == types.number_t.FINGERPRINT != types.other_t.FINGERPRINT
    message = types.named_t(p=[[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
    assert len(message.encode()) == 8 + 6 * 8
    assert types.named_t.decode(message.encode()).p == message.p


def test_a_type_with_an_unknown_member_is_left_out_and_the_others_stay(tmp_path: Path) -> None:
    (tmp_path / "mine.lcm").write_text(
        "struct outer_t { inner_t i; } struct inner_t { u_t x; } struct good_t { int8_t a; }"
    )
    with pytest.warns(UserWarning, match="'x' has the unknown type u_t; give the .lcm file"):
        types = shoal.Types([tmp_path / "mine.lcm"])
    assert types.good_t(a=3).a == 3 and "inner_t" not in types
    with pytest.raises(KeyError, match="outer_t is left out: its member 'i' has the unknown type"):
        types["outer_t"]


@pytest.mark.parametrize(
    ("message", "error"),
    [
        (shoal.types.nav_t(x_m="a"), "shoal.nav_t: 'x_m' is 'a' where double belongs"),
        (shoal.types.nav_t(utime=1.5), "'utime' is 1.5 where int64_t belongs"),
        (shoal.types.key_value_t(key=3), "'key' is 3 where string belongs"),
        (shoal.types.helm_command_t(values=3), "'values' is 3 where an array belongs"),
    ],
)
def test_a_member_of_the_wrong_type_names_itself(message: Message, error: str) -> None:
    with pytest.raises(ValueError, match=error):
        message.encode()


def test_a_missing_lcm_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(shoal.LcmFileError, match=r"none\.lcm: cannot be read: No such file"):
        shoal.Types([tmp_path / "none.lcm"])


def decode_error(data: bytes) -> str:
    with pytest.raises(shoal.DecodeError) as error:
        ALL_TYPES.decode(data)
    return str(error.value)


def test_bytes_that_are_no_message_are_refused() -> None:
    nav = shoal.types.nav_t().encode()
    assert decode_error(nav[:-1]) == "the message ends too early"
    assert decode_error(nav + b"x") == "bytes behind the message's end"
    assert decode_error(b"12345678") == "no known type: fingerprint 0x3132333435363738"
    assert decode_error(b"1") == "no known type: no fingerprint"


def changed(message: Message, old: bytes, new: bytes) -> bytes:
    data = message.encode()
    assert data.count(old) == 1
    return data.replace(old, new)


def test_lengths_that_no_bytes_follow_are_refused_before_memory_is_taken() -> None:
    fates = shoal.types.comms_fates_t(utime=1)
    count = b"\0\0\0\0"
    data = fates.encode()
    assert data.endswith(count)
    assert "greater than the bytes that are left" in decode_error(data[:-4] + b"\x7f\xff\xff\xff")
    assert decode_error(data[:-4] + b"\xff\xff\xff\xff") == "a negative array length"
    pair = shoal.types.key_value_t(key="key", value="value")
    assert "string" in decode_error(changed(pair, b"\0\0\0\4key", b"\x7f\xff\xff\xffkey"))
    assert "string" in decode_error(changed(pair, b"\0\0\0\4key", b"\0\0\0\0key"))
    assert "NUL" in decode_error(changed(pair, b"key", b"k\0y"))


def test_elements_without_bytes_are_limited(tmp_path: Path) -> None:
    (tmp_path / "empty.lcm").write_text(
        "struct empty_t { } struct many_t { int32_t n; int32_t m; empty_t e[n]; double x[n][m]; }"
    )
    types = shoal.Types([tmp_path / "empty.lcm"])
    data = types.many_t().encode()
    for count in (3000, 10**9):
        message = data[:8] + count.to_bytes(4, "big") + bytes(4)
        with pytest.raises(shoal.DecodeError, match="too many array elements without bytes"):
            types.decode(message)


def test_structs_inside_one_another_without_end_are_refused() -> None:
    tree = ALL_TYPES["tree_t"]
    begin = b"\0\0\0\1\0\0\0\0\1"  # An empty name, and one child.
    data = tree._codec.fingerprint_bytes + begin * 100_000
    assert decode_error(data) == "structs inside one another without end"


def test_what_a_program_draws_has_a_type_for_each_kind() -> None:
    box = shoal.types.view_polygon_t(owner="me", label="box", x_m=[0.0, 1.0], y_m=[2.0, 3.0])
    read = shoal.types.decode(box.encode())
    assert (read.num_points, read.x_m, read.y_m) == (2, [0.0, 1.0], [2.0, 3.0])
    for kind in ("point", "seglist", "circle", "text"):
        assert hasattr(getattr(shoal.types, f"view_{kind}_t")(), "life_s")
