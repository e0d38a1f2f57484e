"""Bytes that mean harm: an error or a clean end, never a crash, never more memory than the file."""

from __future__ import annotations

import random
import tracemalloc
import warnings
from collections import Counter
from pathlib import Path

import pytest
import shoal
from conftest import log_bytes, random_message
from shoal.columns import StructColumn
from shoal.table import Table
from shoal.wire import Assembler, split_message

CHANNELS = {
    "NAV_ALPHA": "nav_t",
    "COMMS_FATES": "comms_fates_t",
    "COMMS_MEDIA": "comms_media_t",
    "COMMS_RULES": "broker_rules_t",
    "NODE_REPORT_LOCAL": "node_report_t",
    "SWARM_ALPHA": "swarm_t",
    "RELAY_TX": "relay_t",
}
NUM_MUTATIONS = 5000
MOST_BYTES = 4 << 20


def small_log(draw: random.Random) -> bytes:
    return log_bytes(
        (i, channel, random_message(shoal.types[name], draw).encode())
        for i in range(3)
        for channel, name in CHANNELS.items()
    )


def mutated(data: bytes, draw: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(draw.randint(1, 4)):
        place = draw.randrange(len(changed) + 1)
        kind = draw.randrange(5)
        if kind == 0:
            changed[place : place + 1] = draw.randbytes(1)
        elif kind == 1:
            changed[place : place + 4] = draw.choice(
                [b"\x7f\xff\xff\xff", b"\xff\xff\xff\xff", b"\0\0\0\0", b"\xed\xa1\xda\x01"]
            )
        elif kind == 2:
            del changed[place : place + draw.randint(1, 40)]
        elif kind == 3:
            changed[place:place] = draw.randbytes(draw.randint(1, 40))
        else:
            del changed[place:]
    return bytes(changed)


def use_all(table: Table) -> None:
    for name, column in table._rows.columns.items():
        if isinstance(column, StructColumn):
            use_all(table[name])
        else:
            assert len(table[name]) == len(table)


def read_all(path: Path, skip_damage: bool) -> str:
    """Returns what came of reading everything in the log."""
    try:
        log = shoal.read(path, skip_damage=skip_damage)
        for channel in log.channels:
            use_all(log[channel])
        log.links()
        for record in log:
            record.message  # noqa: B018
    except shoal.LogError as error:
        assert str(error).startswith(f"{path}: byte {error.offset}: ")
        return error.what.rpartition(": ")[2]
    return "read"


def read_mutated(tmp_path: Path, count: int) -> Counter[str]:
    """Returns how often what came of it."""
    draw = random.Random(20261123)
    data = small_log(draw)
    path = tmp_path / "mutated.lcm"
    ends: Counter[str] = Counter()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", shoal.LogWarning)
        for i in range(count):
            path.write_bytes(mutated(data, draw))
            ends[read_all(path, skip_damage=i % 2 == 0)] += 1
    return ends


def test_a_mutated_log_is_read_or_refused_with_the_byte(tmp_path: Path) -> None:
    ends = read_mutated(tmp_path, NUM_MUTATIONS)
    assert ends["read"] > 500 and len(ends) > 8, ends


def test_a_mutated_log_takes_little_memory(tmp_path: Path) -> None:
    tracemalloc.start()
    read_mutated(tmp_path, 200)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < MOST_BYTES


def test_a_mutated_message_is_decoded_or_refused() -> None:
    draw = random.Random(5)
    names = list(shoal.types)
    ends: Counter[str] = Counter()
    for _ in range(NUM_MUTATIONS):
        message = random_message(shoal.types[draw.choice(names)], draw)
        data = message.encode()
        try:
            shoal.types.decode(data[:8] + mutated(data[8:], draw))
            ends["decoded"] += 1
        except shoal.DecodeError as error:
            ends[str(error)] += 1
    assert len(ends) > 5, ends


def test_mutated_datagrams_raise_nothing_and_take_little_memory() -> None:
    draw = random.Random(6)
    assembler = Assembler()
    datagrams = list(split_message("NAV_ALPHA", draw.randbytes(300_000), 1))
    datagrams += split_message("SHORT", b"data", 2)
    for _ in range(NUM_MUTATIONS):
        sender = draw.randrange(100)
        datagram = draw.choice(datagrams)
        begin, rest = datagram[:40], datagram[40:]
        assembler.add(sender, mutated(begin, draw) + rest)
        assert assembler.pending_bytes <= 16 << 20 and assembler.num_pending <= 64
    assert assembler.num_malformed > 100
