#!/usr/bin/env python3
"""Writes the corpora of netsim's fuzz targets from recorded bytes: whole, cut, flipped.

    tests/fuzz/make_netsim_corpus.py

The same files each time. What libFuzzer has found lies beside them and stays.
"""

import base64
import json
import pathlib
import random

TESTS = pathlib.Path(__file__).resolve().parent.parent
CORPUS = TESTS / "fuzz" / "corpus"
REQUEST = b"NETSIM|netsim.protobuf.NetSimManagerRequest|"


def write(target, name, content):
    folder = CORPUS / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content)


def flipped(message, bits):
    damaged = bytearray(message)
    for bit in bits:
        damaged[bit // 8] ^= 1 << (bit % 8)
    return bytes(damaged)


def payload(line):
    """The bytes behind the second pipe, where they are base64."""
    try:
        return base64.b64decode(line[len(REQUEST):], validate=True)
    except ValueError:
        return None


def main():
    dice = random.Random(7)
    vectors = json.loads((TESTS / "golden" / "netsim" / "vectors.json").read_text())["vectors"]
    payloads = {}
    for vector in vectors:
        sent = b"".join(bytes.fromhex(step["send_hex"]) for connection in vector["connections"]
                        for step in connection["steps"] if "send_hex" in step)
        if not sent:
            continue
        write("netsim_lines", vector["name"], bytes([dice.choice([0, 1, 7, 100])]) + sent)
        for line in sent.split(b"\n"):
            if line.startswith(REQUEST) and payload(line) is not None:
                payloads[payload(line)] = vector["name"]
    for number, (message, name) in enumerate(payloads.items()):
        write("netsim_protobuf", f"{number:02}_{name}", message)
        if len(message) > 40 and number % 4 == 0:
            write("netsim_protobuf", f"{number:02}_cut", message[:dice.randrange(len(message))])
            bits = dice.sample(range(8 * len(message)), 5)
            write("netsim_protobuf", f"{number:02}_flipped", flipped(message, bits))
    write("netsim_lines", "too_long", b"\0" + b"x" * 5000 + b"\n" + REQUEST + b"CAo=\n")

    for name, text in {"empty": b"", "whole": b"Zm9vYmFy", "padded": b"Zm8=", "bare": b"Zm8",
                       "bits_left": b"Zm9=", "too_much": b"Zm8==", "inside": b"Zm=9v",
                       "url_safe": b"Zm-_", "high": b"Zm9\xff", "one": b"Z"}.items():
        write("base64", name, text)

    gps = json.loads((TESTS / "golden" / "netsim" / "gps.json").read_text())["cases"]
    sentences = {"cycle": "$CACYC,0,1,2,0,1,3*5A\r\n", "bare": "$CCCFG,SRC,1\r", "empty": "$*00",
                 "fields": "$CARDP,1,,2,", "wrong": "$CACYC,0*00", "short": "$CACYC*5",
                 "two": "$CA$CB*00", "no_dollar": "CACYC,1"}
    for name, text in sentences.items():
        write("nmea_sentence", name, text.encode())
    for number, case in enumerate(gps):
        text = (case["gps_62000"] or case["gps_62002"]).encode()
        if text:
            write("nmea_sentence", f"gps_{number}", text)
            write("nmea_sentence", f"gps_{number}_flipped",
                  flipped(text, dice.sample(range(8 * len(text)), 1)))


if __name__ == "__main__":
    main()
