"""Finds the member of a message that cannot be encoded, for errors that name it."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Any

from .lcm_file import StructType

#: What one member of a primitive type is packed by: the letters of `struct`.
FORMATS = {
    "int8_t": "b",
    "int16_t": "h",
    "int32_t": "i",
    "int64_t": "q",
    "byte": "B",
    "float": "f",
    "double": "d",
    "boolean": "?",
}


def place_of_fault(type_: StructType, attributes: Sequence[str], message: Any) -> str:
    """Returns the struct's name, with the member that cannot be written where one is found."""
    for member, name in zip(type_.members, attributes, strict=True):
        value = getattr(message, name, None)
        what = ""
        if member.dimensions:
            what = "" if hasattr(value, "__len__") else "an array"
        elif not _fits(member.type_name, value):
            what = member.type_name
        if what:
            return f"{type_.full_name}: '{name}' is {value!r} where {what} belongs"
    return type_.full_name


def _fits(type_name: str, value: object) -> bool:
    """Returns whether a single member of this type can have the value; true for structs."""
    if type_name == "string":
        return isinstance(value, str)
    if type_name not in FORMATS:
        return True
    try:
        struct.pack(f">{FORMATS[type_name]}", value)
    except (struct.error, TypeError, AttributeError, OverflowError):
        return False
    return True
