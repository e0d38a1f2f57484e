#!/usr/bin/env python3
"""Writes tests/fuzz/corpus/swarm_receiver from muNet's messages: whole, cut, flipped, framed.

    tests/fuzz/make_swarm_corpus.py

The same files each time. What libFuzzer has found lies beside them and stays.
"""

import json
import pathlib
import random
import struct
import zlib

TESTS = pathlib.Path(__file__).resolve().parent.parent
CORPUS = TESTS / "fuzz" / "corpus" / "swarm_receiver"
LONGEST = 255  # An input gives a message's length in one byte.


def framed(message, sequence):
    body = message + struct.pack("<H", sequence)
    return body + struct.pack("<I", zlib.crc32(body))


def flipped(message, bits):
    damaged = bytearray(message)
    for bit in bits:
        damaged[bit // 8] ^= 1 << (bit % 8)
    return bytes(damaged)


def without_number(message, offset):
    return message[:offset] + struct.pack("<f", float("nan")) + message[offset + 4:]


def write(name, choices, messages):
    chunks = b"".join(bytes([len(m)]) + m for m in messages)
    (CORPUS / name).write_bytes(bytes([choices]) + chunks)


def main():
    golden = TESTS / "golden" / "munet"
    rows = json.loads((golden / "receive_handlers.json").read_text())["cases"]
    handled = [m for m in (bytes.fromhex(row["hex"]) for row in rows) if len(m) <= LONGEST]
    for number, message in enumerate(handled):
        write(f"handled_{number:02}", 0, [message])

    dice = random.Random(6)
    kinds = {kind: next(m for m in handled if m.startswith(kind)) for kind in
             (b"RPRT", b"LRPT", b"BCRQ")}
    for kind, message in kinds.items():
        name = kind.decode().lower()
        write(f"{name}_cut", 0, [message[:n] for n in (4, 5, 36, 53, 57, 65, len(message) - 1)])
        write(f"{name}_framed", 1, [framed(message, n) for n in (7, 8, 8, 12, 0)])
        write(f"{name}_frame_damaged", 1, [flipped(framed(message, 7), [40]), message])
        for strategy in range(7):  # 0: muNet's plan.
            damaged = [flipped(message, dice.sample(range(8 * len(message)), 12)) for _ in range(2)]
            floats = range(9 if kind == b"RPRT" else 5, len(message) - 3, 12)
            damaged += [without_number(message, offset) for offset in floats]
            write(f"{name}_damaged_{strategy}", strategy << 2, damaged)
    write("to_the_leader", 2, list(kinds.values()))
    write("everything", 0, handled[:12])


if __name__ == "__main__":
    main()
