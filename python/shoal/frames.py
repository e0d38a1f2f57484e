"""Reads logs that are compressed with zstd, frame by frame (lib/bus/record/frame_table.h).

The frames can be read by themselves, so that a log is never in memory as a whole. libzstd does the
work: it is part of every Debian and Ubuntu.
"""

from __future__ import annotations

import bisect
import ctypes
import ctypes.util
import functools
import os
import struct
from typing import Any, NamedTuple

_FRAME = 0xFD2FB528
#: A skippable frame with which the files that shoal writes begin.
_OWN_MARK = b"\x50\x2a\x4d\x18\x08\0\0\0shoallog"
_SKIPPABLE = 0x184D2A50  #: The last four bits are free.
_LIST = 0x184D2A5E  #: The skippable frame with the list of frames.
_LIST_END = 0x8F92EAB1
_LIST_TAIL = struct.Struct("<IBI")
#: No frame holds more: it must fit into memory as a whole.
MOST_IN_FRAME = 64 << 20
_MOST_FRAMES = 4 << 20
_KEPT = 4  #: Frames that stay in memory.


class FrameError(Exception):
    """The file cannot be read; the text names the byte and what to do."""


class _Frame(NamedTuple):
    file_begin: int
    file_size: int
    begin: int  #: In the log.
    size: int
    is_torn: bool


class _Buffer(ctypes.Structure):
    """ZSTD_inBuffer and ZSTD_outBuffer."""

    _fields_ = (("data", ctypes.c_void_p), ("size", ctypes.c_size_t), ("place", ctypes.c_size_t))


@functools.cache
def _zstd() -> Any:
    try:
        library = ctypes.CDLL(ctypes.util.find_library("zstd") or "libzstd.so.1")
    except OSError as error:
        raise FrameError(f"compressed, and there is no libzstd to read it with: {error}") from None
    for name in ("ZSTD_decompress", "ZSTD_decompressStream", "ZSTD_initDStream"):
        getattr(library, name).restype = ctypes.c_size_t
    library.ZSTD_createDStream.restype = ctypes.c_void_p
    library.ZSTD_isError.argtypes = (ctypes.c_size_t,)
    return library


def is_compressed(first_bytes: bytes) -> bool:
    """Returns whether a file that begins so is a compressed one."""
    if len(first_bytes) < 4:
        return False
    magic = int.from_bytes(first_bytes[:4], "little")
    return magic == _FRAME or magic & ~0xF == _SKIPPABLE


class FrameReader:
    """Gives parts of the log that a compressed file holds.

    Attributes:
        size: Bytes of the log.
        lost: Why its end cannot be read, with the byte; empty: it can.
    """

    def __init__(self, file: int, file_size: int) -> None:
        """Takes an open file. Raises FrameError."""
        self._file = file
        self._file_size = file_size
        self._frames: list[_Frame] = []
        self._kept: dict[int, bytes] = {}
        self.size = 0
        self.lost = ""
        if not self._take_list():
            self._frames, self.size = [], 0
            self._take_heads()
        self._begins = [frame.begin for frame in self._frames]

    def read(self, offset: int, size: int) -> tuple[bytes, str]:
        """Returns the bytes of the log there, fewer at its end, and what is wrong with them.

        The bytes of damaged frames are zeros.
        """
        pieces = []
        wrong = ""
        end = min(offset + size, self.size)
        while offset < end:
            number = bisect.bisect_right(self._begins, offset) - 1
            frame = self._frames[number]
            data, damage = self._decode(number)
            wrong = wrong or damage
            place = offset - frame.begin
            piece = data[place : place + end - offset]
            pieces.append(piece)
            offset += len(piece)
        return (pieces[0] if len(pieces) == 1 else b"".join(pieces)), wrong

    def damage_at(self, offset: int) -> str:
        """Returns what is wrong with the frame in which that byte of the log is."""
        if offset >= self.size:
            return ""
        return self._decode(bisect.bisect_right(self._begins, offset) - 1)[1]

    def _decode(self, number: int) -> tuple[bytes, str]:
        frame = self._frames[number]
        data = self._kept.pop(number, None)
        if data is None:
            data = self._whole(frame)
        while len(self._kept) >= _KEPT:
            del self._kept[next(iter(self._kept))]
        self._kept[number] = data
        if len(data) == frame.size:
            return data, ""
        return bytes(frame.size), (
            f"the frame that begins at byte {frame.file_begin} of the compressed file is damaged"
        )

    def _whole(self, frame: _Frame) -> bytes:
        """Returns what the frame holds; other bytes than it has where it is damaged."""
        if frame.is_torn:
            return self._stream(frame.file_begin, frame.file_size)[: frame.size]
        if frame.file_size > 2 * frame.size + (1 << 16):
            return b""
        compressed = os.pread(self._file, frame.file_size, frame.file_begin)
        data = ctypes.create_string_buffer(frame.size)
        library = _zstd()
        size = library.ZSTD_decompress(
            data, ctypes.c_size_t(frame.size), compressed, ctypes.c_size_t(len(compressed))
        )
        return b"" if library.ZSTD_isError(size) else data.raw[:size]

    def _stream(self, begin: int, size: int) -> bytes:
        """Returns what comes out of a frame before its data end or are damaged."""
        library = _zstd()
        stream = ctypes.c_void_p(library.ZSTD_createDStream())
        try:
            library.ZSTD_initDStream(stream)
            compressed = os.pread(self._file, min(size, MOST_IN_FRAME), begin)
            source = ctypes.create_string_buffer(compressed, max(len(compressed), 1))
            into = ctypes.create_string_buffer(1 << 17)
            given = _Buffer(ctypes.addressof(source), len(compressed), 0)
            result = bytearray()
            while len(result) <= MOST_IN_FRAME:
                taken = _Buffer(ctypes.addressof(into), len(into), 0)
                before = given.place
                left = library.ZSTD_decompressStream(
                    stream, ctypes.byref(taken), ctypes.byref(given)
                )
                if library.ZSTD_isError(left):
                    break
                result += into.raw[: taken.place]
                if left == 0 or (taken.place == 0 and given.place == before):
                    break
            return bytes(result)
        finally:
            library.ZSTD_freeDStream(stream)

    def _add(self, file_begin: int, file_size: int, size: int, is_torn: bool = False) -> None:
        if size > 0:
            self._frames.append(_Frame(file_begin, file_size, self.size, size, is_torn))
            self.size += size

    def _take_list(self) -> bool:
        """Takes the frames from the list at the end of the file; false: there is none."""
        if self._file_size < 8 + _LIST_TAIL.size:
            return False
        tail = os.pread(self._file, _LIST_TAIL.size, self._file_size - _LIST_TAIL.size)
        count, descriptor, magic = _LIST_TAIL.unpack(tail)
        row = 12 if descriptor & 0x80 else 8
        size = count * row + _LIST_TAIL.size
        begin = self._file_size - 8 - size
        if magic != _LIST_END or descriptor & 0x7C or count > _MOST_FRAMES or begin < 0:
            return False
        rows = os.pread(self._file, 8 + size, begin)
        if struct.unpack_from("<II", rows) != (_LIST, size):
            return False
        place = 0
        for i in range(count):
            compressed, held = struct.unpack_from("<II", rows, 8 + i * row)
            if held > MOST_IN_FRAME:
                return False
            self._add(place, compressed, held)
            place += compressed
        return bool(place == begin)

    def _take_heads(self) -> None:
        """Takes the frames from their heads, as of a file whose writer was killed."""
        place = 0
        is_own = os.pread(self._file, len(_OWN_MARK), 0) == _OWN_MARK
        while place < self._file_size:
            if len(self._frames) == _MOST_FRAMES:
                raise FrameError(f"more than {_MOST_FRAMES} frames; `zstd -d` makes a log of it")
            head = os.pread(self._file, 18, place)
            magic = int.from_bytes(head[:4], "little")
            if len(head) >= 8 and magic & ~0xF == _SKIPPABLE:
                is_own = is_own and magic != _LIST
                place += 8 + int.from_bytes(head[4:8], "little")
                continue
            if len(head) >= 4 and magic != _FRAME:
                self.lost = f"no frame begins at byte {place} of the compressed file"
                return
            end, held = self._measure(place, head)
            size = held
            if end is None or size is None:
                size = len(self._stream(place, (end or self._file_size) - place))
            if size > MOST_IN_FRAME:
                raise FrameError(
                    f"the frame that begins at byte {place} holds more than "
                    f"{MOST_IN_FRAME >> 20} MiB, which must fit into memory: make a log of it by "
                    "`zstd -d`"
                )
            self._add(place, (end or self._file_size) - place, size, end is None)
            if end is None:
                self.lost = (
                    f"the compressed file ends inside the frame that begins at its byte {place}"
                )
                return
            place = end
        if is_own:
            self.lost = (
                "the list of frames that ends the compressed file is missing: what wrote it was "
                "ended before it closed the log"
            )

    def _measure(self, place: int, head: bytes) -> tuple[int | None, int | None]:
        """Returns where a frame ends and the size of its content; None where the file lacks it."""
        if len(head) < 6:
            return None, None
        descriptor = head[4]
        is_single = bool(descriptor & 0x20)
        flag = descriptor >> 6
        size_bytes = int(is_single) if flag == 0 else 1 << flag
        begin = 5 + (not is_single) + (0, 1, 2, 4)[descriptor & 3]
        if begin + size_bytes > len(head):
            return None, None
        held = None
        if size_bytes:
            held = int.from_bytes(head[begin : begin + size_bytes], "little")
            held += 256 if size_bytes == 2 else 0
        at = place + begin + size_bytes
        is_last = False
        while not is_last:
            block = os.pread(self._file, 3, at)
            if len(block) < 3:
                return None, held
            word = int.from_bytes(block, "little")
            is_last = bool(word & 1)
            at += 3 + (1 if word >> 1 & 3 == 1 else word >> 3)
        at += 4 if descriptor & 4 else 0
        return (at, held) if at <= self._file_size else (None, held)
