#!/usr/bin/env python3
"""Writes tests/fuzz/corpus/micromodem: what a Goby host says, packets of each kind, and damage.

    tests/fuzz/make_micromodem_corpus.py

The same files each time. What libFuzzer has found lies beside them and stays.
"""

import json
import pathlib
import struct
import zlib

TESTS = pathlib.Path(__file__).resolve().parent.parent
CORPUS = TESTS / "fuzz" / "corpus" / "micromodem"
HOST, WATER, MENDED, TIME = range(4)


def piece(choice, content):
    parts = [content[i : i + 255] for i in range(0, len(content), 255)] or [b""]
    return b"".join(bytes([choice, len(part)]) + part for part in parts)


def wait(seconds):
    return piece(TIME, bytes(int(seconds * 10)))


def packet(kind, rate=0, source=2, destination=1, ack=True, frames=(), num_frames=0, value=0):
    num_frames = len(frames) or num_frames
    head = struct.pack(
        "<BBBBBH", 0x4D, kind << 4 | rate, source, destination, ack << 7 | num_frames, value
    )
    head += b"".join(struct.pack("<H", 0x8000 | len(frame)) for frame in frames)
    head += struct.pack("<H", zlib.crc32(head) & 0xFFFF)
    return head + b"".join(frame + struct.pack("<I", zlib.crc32(frame)) for frame in frames)


def main():
    CORPUS.mkdir(parents=True, exist_ok=True)
    recording = json.loads((TESTS / "golden" / "netsim" / "micromodem_mm1.json").read_text())
    said = [row["line"] + "\r\n" for row in recording["lines"] if row["dir"] == "host>modem"]
    host = [piece(HOST, line.encode()) for line in said]

    data = packet(2, rate=2, frames=(b"one", b"two", b"three"))
    fsk = packet(2, frames=(b"data",))
    inputs = {
        "dialogue": b"".join(line + wait(1) for line in host),
        "dialogue_at_once": b"".join(host),
        "dialogue_cut": b"".join(line[: len(line) // 2] for line in host),
        "early_data": piece(HOST, b"$CCTXD,1,2,0,aabb\r\n$CCCYC,0,1,2,0,0,1\r\n") + wait(20),
        "abandoned": piece(HOST, b"$CCCYC,0,1,2,5,1,8\r\n$CCTXD,1,2,0,00\r\n$CCCYC,0,1,3,1,0,1\r\n")
        + wait(5),
        "rebooted": piece(HOST, b"$CCCYC,0,1,2,0,1,1\r\n$CCMSC,1,1,0\r\n") + wait(3),
        "clocks": piece(HOST, b"$CCCLK,2200,12,31,23,59,60\r\n$CCTMQ,0\r\n$CCTMS,x,0\r\n"),
        "cycle_then_data": piece(WATER, packet(1, num_frames=1)) + piece(WATER, fsk) + wait(6),
        "cycle_without_data": piece(WATER, packet(1, num_frames=1)) + wait(20),
        "data": piece(WATER, data) + wait(6),
        "data_cut": piece(WATER, data[:-9]),
        "data_damaged": piece(WATER, data[:16] + b"\xff" + data[17:]),
        "acks": piece(WATER, packet(3, value=0xFF)),
        "pings": piece(WATER, packet(4)) * 12 + piece(WATER, packet(5)) + wait(20),
        "minis": piece(WATER, packet(6, value=0x1FFF)) + piece(WATER, packet(6, destination=0)),
        "mended": b"".join(piece(MENDED, bytes([0, kind << 4, 2, 1])) for kind in range(16)),
        "mended_data": piece(MENDED, bytes([0, 0x25, 2, 1, 0x88]) + bytes(2) + b"\x05\x80" * 12),
        "long_line": piece(HOST, b"x" * 2000 + b"\r\n$CCCFQ,ALL\r\n"),
    }
    for name, content in inputs.items():
        (CORPUS / name).write_bytes(content)


if __name__ == "__main__":
    main()
