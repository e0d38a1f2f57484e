#!/usr/bin/env python3
"""Writes tests/fuzz/corpus/lcm_assembler: LCM's datagrams, whole, in fragments, and wrong ones.

    tests/fuzz/make_lcm_corpus.py

The same files each time. What libFuzzer has found lies beside them and stays.
"""

import pathlib
import struct

CORPUS = pathlib.Path(__file__).resolve().parent / "corpus" / "lcm_assembler"


def piece(datagram, sender=0):
    return struct.pack(">BH", sender, len(datagram)) + datagram


def whole(channel, data):
    return b"LC02" + struct.pack(">I", 1) + channel + b"\0" + data


def fragment(size, offset, number, count, part, sequence=1, channel=b"BIG\0"):
    header = struct.pack(">IIIHH", sequence, size, offset, number, count)
    return b"LC03" + header + (channel if number == 0 else b"") + part


INPUTS = {
    "whole": [whole(b"NAV_ALPHA", bytes(range(60)))],
    "empty_message": [whole(b"NAV_ALPHA", b"")],
    "empty_channel": [whole(b"", b"12345678")],
    "longest_channel": [whole(b"C" * 63, b"1"), whole(b"C" * 64, b"1")],
    "no_end_of_channel": [b"LC02\0\0\0\1NAV_ALPHA"],
    "no_channel": [b"LC02\0\0\0\1"],
    "other_magic": [b"LC01\0\0\0\1NAV\0", b"", b"LC0"],
    "two_fragments": [fragment(100, 0, 0, 2, b"a" * 60), fragment(100, 60, 1, 2, b"b" * 40)],
    "turned_round": [fragment(100, 60, 1, 2, b"b" * 40), fragment(100, 0, 0, 2, b"a" * 60)],
    "wraps": [fragment(1000, 2**32 - 50, 0, 2, b"a" * 100)],
    "wraps_later": [fragment(1000, 0, 0, 2, b"a" * 60), fragment(1000, 2**32 - 50, 1, 2, b"a" * 100)],
    "beyond_the_end": [fragment(100, 0, 0, 2, b"a" * 60), fragment(100, 60, 1, 2, b"b" * 41)],
    "gap": [fragment(100, 0, 0, 2, b"a" * 50), fragment(100, 60, 1, 2, b"b" * 40)],
    "overlap": [fragment(100, 0, 0, 2, b"a" * 60), fragment(100, 50, 1, 2, b"b" * 40)],
    "huge": [fragment(2**32 - 1, 0, 0, 2, b"a" * 60)],
    "other_size": [fragment(100, 0, 0, 2, b"a" * 60), fragment(101, 60, 1, 2, b"b" * 41)],
    "twice": [fragment(100, 0, 0, 2, b"a" * 60)] * 2 + [fragment(100, 60, 1, 2, b"b" * 40)] * 2,
    "next_sequence": [
        fragment(100, 0, 0, 2, b"a" * 60),
        fragment(100, 0, 0, 2, b"a" * 60, sequence=2),
        fragment(100, 60, 1, 2, b"b" * 40, sequence=2),
    ],
    "no_fragments": [fragment(100, 0, 0, 0, b"a" * 60), fragment(0, 0, 0, 1, b"")],
}

CORPUS.mkdir(parents=True, exist_ok=True)
for name, datagrams in INPUTS.items():
    (CORPUS / name).write_bytes(b"".join(piece(each, i % 2 if name == "whole" else 0)
                                         for i, each in enumerate(datagrams)))
