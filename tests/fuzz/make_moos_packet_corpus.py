#!/usr/bin/env python3
"""Writes the corpus of moos_packet_fuzz: small recorded conversations, with and without greeting."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests/golden/moos"
CORPUS = ROOT / "tests/fuzz/corpus/moos_packet"
NAMES = ["join", "name-taken", "register", "wildcard", "notify", "held-mail", "requests", "delay"]


def main() -> None:
    CORPUS.mkdir(parents=True, exist_ok=True)
    for name in NAMES:
        for side in ("client", "server"):
            data = (GOLDEN / f"{name}.{side}.bin").read_bytes()
            (CORPUS / f"{name}_{side}").write_bytes(b"\0" + data)
            (CORPUS / f"{name}_{side}_pieces").write_bytes(b"\x0e" + data[:600])
        packets = (GOLDEN / f"{name}.client.bin").read_bytes()[32:]
        (CORPUS / f"{name}_packets").write_bytes(b"\x10" + packets)
    (CORPUS / "two_gigabytes").write_bytes(b"\0" + b"\xff\xff\xff\x7f\1\0\0\0\0")
    (CORPUS / "empty_packet").write_bytes(b"\0" + b"\x09\0\0\0\0\0\0\0\0")


if __name__ == "__main__":
    main()
