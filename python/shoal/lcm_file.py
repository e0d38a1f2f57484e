"""Reads .lcm files as lcm-gen does: packages, structs, members, constants. No enums."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from .errors import LcmFileError

PRIMITIVE_SIZES = {
    "int8_t": 1,
    "int16_t": 2,
    "int32_t": 4,
    "int64_t": 8,
    "byte": 1,
    "float": 4,
    "double": 8,
    "string": 5,  # The length and the terminating NUL.
    "boolean": 1,
}
_LENGTH_TYPES = ("int8_t", "int16_t", "int32_t", "int64_t")
_CONSTANT_TYPES = (*_LENGTH_TYPES, "float", "double")
_TOKEN = re.compile(r"\s+|//[^\n]*|/\*.*?(?:\*/|\Z)|([\w.]+|.)", re.DOTALL | re.ASCII)
_INTEGER = re.compile(r"-?(0[xX][0-9a-fA-F]+|[0-9]+)\Z")
_NAME = re.compile(r"[A-Za-z_]")


@dataclass(frozen=True)
class Dimension:
    """One `[...]` of a member."""

    text: str  #: As written: a number, a constant's value, or the name of the length member.
    size: int  #: 0: variable.


@dataclass(frozen=True)
class Member:
    """One member of a struct."""

    name: str
    type_name: str  #: A primitive's, or a struct's with its package.
    dimensions: tuple[Dimension, ...] = ()

    @property
    def is_primitive(self) -> bool:
        return self.type_name in PRIMITIVE_SIZES


@dataclass
class StructType:
    """A struct as an .lcm file declares it."""

    package: str  #: May be empty, may have dots.
    name: str  #: Without the package.
    members: list[Member] = field(default_factory=list)
    constants: dict[str, float] = field(default_factory=dict)

    @property
    def full_name(self) -> str:
        return f"{self.package}.{self.name}" if self.package else self.name


def parse_integer(text: str) -> int | None:
    """Returns the number that C reads in `text`: decimal, 0x hexadecimal or 0 octal."""
    if not _INTEGER.match(text):
        return None
    digits = text.lstrip("-")
    try:
        if digits[:2] in ("0x", "0X"):
            value = int(digits, 16)
        else:
            value = int(digits, 8 if len(digits) > 1 and digits[0] == "0" else 10)
    except ValueError:  # 08, or thousands of digits
        return None
    value = -value if text.startswith("-") else value
    return value if -(2**63) <= value < 2**63 else None


def parse(text: str, file: str) -> list[StructType]:
    """Returns the structs that `text` declares; `file` is for error messages.

    Raises:
        LcmFileError: with file, line and column.
    """
    return _Parser(text, file).parse()


class _Parser:
    def __init__(self, text: str, file: str) -> None:
        self._text = text
        self._file = file
        self._tokens = [
            (match.group(1), match.start(1)) for match in _TOKEN.finditer(text) if match.group(1)
        ]
        self._tokens.append(("", len(text)))  # The end of the file.
        self._next = 0
        self._package = ""

    def parse(self) -> list[StructType]:
        types = []
        while self._peek():
            if self._take_if("package"):
                self._package = self._name("a package", dots=True)
                self._expect(";")
            elif self._take_if("struct"):
                types.append(self._struct())
            elif self._peek() == "enum":
                self._fail("enums have no place in LCM's C++; use constants of int8_t")
            elif not self._take_if(";"):
                self._fail("expected 'package' or 'struct'" + self._found())
        return types

    def _peek(self) -> str:
        return self._tokens[self._next][0]

    def _take(self) -> str:
        token = self._peek()
        self._next = min(self._next + 1, len(self._tokens) - 1)
        return token

    def _take_if(self, text: str) -> bool:
        if self._peek() != text:
            return False
        self._take()
        return True

    def _found(self) -> str:
        token = self._peek()
        return f", found '{token[:40]}'" if token else ", found the end of the file"

    def _fail(self, what: str) -> None:
        position = self._tokens[self._next][1]
        line = self._text.count("\n", 0, position) + 1
        column = position - self._text.rfind("\n", 0, position)
        raise LcmFileError(f"{self._file}:{line}:{column}: {what}")

    def _expect(self, mark: str) -> None:
        if not self._take_if(mark):
            self._fail(f"expected '{mark}'" + self._found())

    def _name(self, of_what: str, dots: bool = False) -> str:
        token = self._peek()
        if not _NAME.match(token) or ("." in token and not dots):
            self._fail(f"expected the name of {of_what}" + self._found())
        return self._take()

    def _struct(self) -> StructType:
        package, dot, name = self._name("a struct", dots=True).rpartition(".")
        made = StructType(package if dot else self._package, name)
        self._sizes: dict[str, tuple[str, int | None]] = {}  # Text and value of its constants.
        self._expect("{")
        while not self._take_if("}"):
            if self._take_if("const"):
                self._constants(made)
            else:
                self._members(made)
        return made

    def _new_name(self, made: StructType, of_what: str) -> str:
        name = self._peek()
        if name in made.constants or any(each.name == name for each in made.members):
            self._fail(f"'{name}' is there twice")
        return self._name(of_what)

    def _constants(self, made: StructType) -> None:
        if self._peek() not in _CONSTANT_TYPES:
            self._fail("a constant is an integer, a float or a double")
        type_name = self._take()
        while True:
            name = self._new_name(made, "a constant")
            self._expect("=")
            begin, text = self._next, ""
            while self._peek() not in ("", ",", ";"):
                text += self._take()  # "-1.5e-3" is cut at its signs
            value: float | None = parse_integer(text)
            if value is None and type_name in ("float", "double"):
                try:
                    value = float(text)
                except ValueError:
                    value = None
            if value is None:
                self._next = begin
                self._fail(f"expected a number of type {type_name}" + self._found())
            else:
                made.constants[name] = value
                is_size = type_name in _LENGTH_TYPES
                self._sizes[name] = (text, parse_integer(text) if is_size else None)
            if not self._take_if(","):
                break
        self._expect(";")

    def _members(self, made: StructType) -> None:
        type_name = self._name("a member's type", dots=True)
        if type_name not in PRIMITIVE_SIZES and "." not in type_name and self._package:
            type_name = f"{self._package}.{type_name}"
        while True:
            name = self._new_name(made, "a member")
            dimensions = []
            while self._take_if("["):
                dimensions.append(self._dimension(made))
                self._expect("]")
            made.members.append(Member(name, type_name, tuple(dimensions)))
            if not self._take_if(","):
                break
        self._expect(";")

    def _dimension(self, made: StructType) -> Dimension:
        text = self._peek()
        size = parse_integer(text)
        if text in self._sizes:  # Of this struct alone: lcm-gen knows no others.
            name = text
            text, size = self._sizes[name]  # lcm-gen from 1.4 on has the value in its hash.
            if size is None or size <= 0:
                self._fail(
                    f"the constant '{name}' is an array's size: it must be a whole number "
                    "greater than 0, of type int8_t to int64_t"
                )
        elif size is not None:
            if size <= 0:
                self._fail("an array's size is a whole number greater than 0")
        else:
            length = next((each for each in made.members if each.name == text), None)
            if length is None:
                self._fail(
                    "an array's length is a number, or a constant or a member that its struct "
                    "declares before it" + self._found()
                )
            elif length.type_name not in _LENGTH_TYPES or length.dimensions:
                self._fail("an array's length must be a single integer")
        self._take()
        return Dimension(text, size or 0)
