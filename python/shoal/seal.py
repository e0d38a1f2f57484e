"""The seal behind each message that a participant publishes: docs/extending/step_protocol.md."""

from __future__ import annotations

import hashlib
import hmac
import struct
from dataclasses import dataclass

SEAL_MAGIC = b"SHO2"
_NUMBERS = struct.Struct(">BqqI")
_TAG_SIZE = 16
_LONGEST_NAME = 100
_FIXED_SIZE = _NUMBERS.size + _TAG_SIZE + len(SEAL_MAGIC)


@dataclass(frozen=True)
class Seal:
    """What a seal states. It is proved by the tag alone, and that by the mission's secret."""

    publisher: bytes
    mission_id: int
    step: int
    sequence: int


def _tag(secret: bytes, channel: str, before: bytes) -> bytes:
    return hashlib.blake2b(
        channel.encode() + b"\0" + before, key=secret, digest_size=_TAG_SIZE
    ).digest()


def append_seal(data: bytes, seal: Seal, secret: bytes, channel: str) -> bytes:
    """Returns the message with its seal."""
    size = len(seal.publisher)
    if not 1 <= size <= _LONGEST_NAME:
        raise ValueError("a publisher's name has 1 to 100 bytes")
    before = (
        data + seal.publisher + _NUMBERS.pack(size, seal.mission_id, seal.step, seal.sequence)
    )
    return before + _tag(secret, channel, before) + SEAL_MAGIC


def sealed_size(data: bytes, begin: int, end: int) -> int:
    """Returns the size of the seal that data[begin:end] ends with; 0 where there is none."""
    numbers = end - _FIXED_SIZE
    if data[end - 4 : end] != SEAL_MAGIC or numbers < begin:
        return 0
    name_size = data[numbers]
    if not 1 <= name_size <= _LONGEST_NAME or numbers - name_size < begin:
        return 0
    return _FIXED_SIZE + name_size


def split_seal(data: bytes) -> tuple[bytes, Seal | None]:
    """Returns the message without its seal, and the seal; the tag is not looked at."""
    size = sealed_size(data, 0, len(data))
    if size == 0:
        return data, None
    begin = len(data) - size
    numbers = len(data) - _FIXED_SIZE
    _, mission_id, step, sequence = _NUMBERS.unpack_from(data, numbers)
    return data[:begin], Seal(data[begin:numbers], mission_id, step, sequence)


def is_genuine(data: bytes, secret: bytes, channel: str) -> bool:
    """Returns true where a sealed message was sealed with `secret`, for this channel."""
    tag_begin = len(data) - _TAG_SIZE - len(SEAL_MAGIC)
    expected = _tag(secret, channel, data[:tag_begin])
    return hmac.compare_digest(expected, data[tag_begin : tag_begin + _TAG_SIZE])
