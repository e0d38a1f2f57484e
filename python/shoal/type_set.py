"""Message types by name and by fingerprint: shoal's own, and those of .lcm files of your own."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

from . import fate_columns, lcm_file, pulse_columns
from .codec import Codec, make_codecs
from .errors import DecodeError, LcmFileError
from .message import Message, make_class
from .schema import Schema
from .seal import split_seal

_LARGEST_FILE = 1 << 20  #: Bytes.
_LISTS = {  #: Types whose messages may be columns.
    fate_columns.LIST_TYPE: fate_columns.FatesCodec,
    pulse_columns.LIST_TYPE: pulse_columns.PulsesCodec,
}


def _read_lcm(path: str | os.PathLike[str]) -> list[lcm_file.StructType]:
    name = os.fspath(path)
    try:
        with open(name, "rb") as file:
            data = file.read(_LARGEST_FILE + 1)
    except OSError as error:
        raise LcmFileError(f"{name}: cannot be read: {error.strerror}") from None
    if len(data) > _LARGEST_FILE:
        raise LcmFileError(f"{name}: too long for an .lcm file")
    return lcm_file.parse(data.decode("utf-8", "replace"), name)


def lcm_folder() -> Path:
    """Returns the folder of shoal's .lcm files: installed with the package, or the checkout's."""
    here = Path(__file__).resolve().parent
    for folder in (here / "lcmtypes", here.parent.parent / "lcmtypes"):
        if (folder / "shoal_nav_t.lcm").is_file():
            return folder
    raise LcmFileError(
        f"no .lcm files in {here / 'lcmtypes'}: install the package with `pip install ./python`"
    )


class Types:
    """A set of message types.

    types = shoal.Types(["my_pose_t.lcm"])      shoal's, and yours
    types.nav_t(x_m=3.0)                        a class, by its name without the package
    types["mine.pose_t"]                        by its full name
    types.decode(data)                          by the fingerprint
    """

    def __init__(self, lcm_files: Iterable[str | os.PathLike[str]] = ()) -> None:
        """Raises LcmFileError, with the file and the line where there is one.

        A type with a member of a type that no file declares is left out, with a warning.
        """
        structs = [each for path in sorted(lcm_folder().glob("*.lcm")) for each in _read_lcm(path)]
        structs += [each for path in lcm_files for each in _read_lcm(path)]
        schema = Schema(structs)
        self._left_out = schema.left_out
        for note in self._left_out.values():
            warnings.warn(note, stacklevel=2)
        self._codecs = make_codecs(schema, _LISTS)
        self._classes: dict[str, type[Message]] = {}
        self._by_name: dict[str, type[Message]] = {}
        self._by_fingerprint: dict[bytes, type[Message]] = {}
        for full_name, codec in self._codecs.items():
            made = make_class(codec, self._classes)
            self._classes[full_name] = made
            # Shoal's own names come first, and so do their fingerprints.
            self._by_name.setdefault(codec.struct.name, made)
            self._by_fingerprint.setdefault(codec.fingerprint_bytes, made)
        for columns in (fate_columns, pulse_columns):  # Both are read as lists.
            fingerprint = self._codecs[columns.COLUMNS_TYPE].fingerprint_bytes
            self._by_fingerprint[fingerprint] = self._classes[columns.LIST_TYPE]

    def __getitem__(self, name: str) -> type[Message]:
        found = self._classes.get(name) or self._by_name.get(name)
        if found is None:
            for full_name, note in self._left_out.items():
                if name in (full_name, full_name.rpartition(".")[2]):
                    raise KeyError(note)
            raise KeyError(f"no message type '{name}'; give its .lcm file to shoal.Types")
        return found

    def __getattr__(self, name: str) -> type[Message]:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __contains__(self, name: object) -> bool:
        return name in self._classes or name in self._by_name

    def __iter__(self) -> Iterator[str]:
        """The full names."""
        return iter(self._classes)

    def __len__(self) -> int:
        return len(self._classes)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._by_name]

    def of(self, data: bytes) -> type[Message] | None:
        """Returns the class of an encoded message; None where its type is not known."""
        return self._by_fingerprint.get(data[:8])

    def codec_of(self, fingerprint: bytes) -> Codec | None:
        """Returns what reads messages that begin with these eight bytes."""
        found = self._by_fingerprint.get(fingerprint)
        return None if found is None else found._codec

    def decode(self, data: bytes) -> Message:
        """Returns the message of these bytes, with or without a seal behind it.

        Raises:
            DecodeError: the type is not known, or the bytes are not a message of it.
        """
        data = bytes(data)
        found = self.of(data)
        if found is None:
            shown = f"fingerprint 0x{data[:8].hex()}" if len(data) >= 8 else "no fingerprint"
            raise DecodeError(f"no known type: {shown}")
        message, seal = split_seal(data)
        if seal is None:
            return found.decode(data)
        try:
            return found.decode(message)
        except DecodeError:
            return found.decode(data)  # What looks like a seal may be the message's own bytes.


@cache
def own_types() -> Types:
    """Returns shoal's own types."""
    return Types()
