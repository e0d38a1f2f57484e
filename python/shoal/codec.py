"""Turns the bytes of LCM messages into rows (tuples in the order of the members), and back.

For each struct a function is written and compiled once: numbers that stand together are one call
of a compiled `struct` format, and what remains are the strings and the arrays. A row holds ints,
floats, bools and strs; bytes for `byte x[n]`; a list for other arrays, of rows where the elements
are structs; a row for a struct.
"""

from __future__ import annotations

import keyword
import struct
from collections.abc import Callable
from typing import Any

from .errors import DecodeError
from .faults import FORMATS, place_of_fault
from .lcm_file import PRIMITIVE_SIZES, Member, StructType
from .schema import Schema

Row = tuple[Any, ...]
#: (bytes, begin, end of the message) -> (row, end of the struct). It may read beyond the end of
#: the message, never beyond the bytes; the caller compares the two ends.
ReadRow = Callable[[bytes, int, int], tuple[Row, int]]
#: (bytes, begin, end, number of structs) -> (rows, end of the last).
ReadRows = Callable[[bytes, int, int, int], tuple[list[Row], int]]
#: (object with the members as attributes, function that takes a piece of the message).
WriteObject = Callable[[Any, Callable[[bytes], None]], None]

_LENGTH = struct.Struct(">i")
# Array elements that take no bytes would let a short message ask for 2^31 of them: a message may
# have this many, and one more for each byte.
_FREE_ELEMENTS = 4096
_MOST_TEXTS = 65536
_LONGEST_KEPT_TEXT = 64

_texts: dict[bytes, str] = {}  # Texts come again and again: names, causes, colors.
_free_elements = [0]  # What is left to the message that is being read.


def attribute_name(name: str) -> str:
    """Returns the attribute for a member: `from` is a keyword of Python and becomes `from_`."""
    return name + "_" if keyword.iskeyword(name) else name


def format_of(member: Member) -> str | None:
    """Returns the letter of `struct` for a single number or boolean; None for all other members."""
    return None if member.dimensions else FORMATS.get(member.type_name)


def flat_format(members: list[Member]) -> str | None:
    """Returns the letters for a struct of single numbers and booleans; None for any other."""
    letters = [format_of(member) for member in members]
    return None if None in letters else "".join(each for each in letters if each)


def _text(data: bytes) -> str:
    """Returns the text of a string that _texts has not yet."""
    if b"\0" in data:
        raise DecodeError("a string whose NUL is not at its end")
    text = data.decode("utf-8", "backslashreplace")
    if len(data) <= _LONGEST_KEPT_TEXT:
        if len(_texts) >= _MOST_TEXTS:
            _texts.clear()
        _texts[data] = text
    return text


def text_of(data: bytes) -> str:
    """Returns the text of a string's bytes, without the NUL at their end."""
    text = _texts.get(data)
    return _text(data) if text is None else text


def _read_string(data: bytes, begin: int, end: int) -> tuple[str, int]:
    (size,) = _LENGTH.unpack_from(data, begin)
    begin += 4
    stop = begin + size
    if size < 1 or stop > end or data[stop - 1]:
        raise DecodeError("a string without its end")
    return text_of(data[begin : stop - 1]), stop


def _bad_string() -> DecodeError:
    return DecodeError("a string without its end")


class Codec:
    """Reads and writes one struct of a schema."""

    def __init__(self, codecs: dict[str, Codec], schema: Schema, made: StructType) -> None:
        """`codecs` is filled with those of all structs of the schema before the first use."""
        self._codecs = codecs
        self._schema = schema
        self.struct = made
        self.fingerprint = schema.fingerprint(made.full_name)
        self.fingerprint_bytes = self.fingerprint.to_bytes(8, "big")
        letters = flat_format(made.members)
        #: With it each message, fingerprint included, is read at once; None where there are
        #: strings, arrays or structs.
        self.flat = None if letters is None else struct.Struct(">8x" + letters)
        self.attributes = tuple(attribute_name(each.name) for each in made.members)
        lengths = {each.text for member in made.members for each in member.dimensions}
        #: The attributes that are not the length of an array.
        self.content = tuple(
            attribute_name(each.name) for each in made.members if each.name not in lengths
        )
        self._read: ReadRow | None = None
        self._read_many: ReadRows | None = None
        self._write: WriteObject | None = None

    @property
    def read(self) -> ReadRow:
        """Reads the struct without fingerprint."""
        if self._read is None:
            self._read, self._read_many = self._compiled()
        return self._read

    @property
    def read_many(self) -> ReadRows:
        """Reads a number of structs behind one another."""
        if self._read_many is None:
            self._read, self._read_many = self._compiled()
        return self._read_many

    def _compiled(self) -> tuple[ReadRow, ReadRows]:
        return _Reader(self.struct, self._schema, self._codecs).compile()

    def read_message(self, data: bytes, begin: int, end: int) -> Row:
        """Returns the row of the message that takes data[begin:end].

        Raises:
            DecodeError: what is wrong with the bytes.
        """
        if data[begin : begin + 8] != self.fingerprint_bytes or end - begin < 8:
            raise DecodeError("the fingerprint of another type")
        _free_elements[0] = _FREE_ELEMENTS + end - begin
        try:
            row, stop = self.read(data, begin + 8, end)
        except struct.error:
            raise DecodeError("the message ends too early") from None
        except RecursionError:
            raise DecodeError("structs inside one another without end") from None
        if stop != end:
            raise DecodeError(
                "bytes behind the message's end" if stop < end else "the message ends too early"
            )
        return row

    def write_message(self, message: Any) -> bytes:
        """Returns the message's bytes. Lengths of arrays are those that the arrays have.

        Raises:
            ValueError: a member that its type cannot hold.
        """
        if self._write is None:
            self._write = _Writer(self.struct, self._codecs).compile()
        pieces = [self.fingerprint_bytes]
        try:
            self._write(message, pieces.append)
        except (struct.error, TypeError, AttributeError, IndexError) as error:
            where = place_of_fault(self.struct, self.attributes, message)
            raise ValueError(f"{where}: {error}") from error
        return b"".join(pieces)

    def write_members(self, message: Any, take: Callable[[bytes], None]) -> None:
        """Hands the members' bytes, without fingerprint, to `take`."""
        if self._write is None:
            self._write = _Writer(self.struct, self._codecs).compile()
        self._write(message, take)


def _check_count(count: int, element_size: int, bytes_left: int) -> None:
    """Refuses more elements than the bytes that are left can hold."""
    if count < 0:
        raise DecodeError("a negative array length")
    if element_size == 0:
        _free_elements[0] -= count
        if _free_elements[0] < 0:
            raise DecodeError("too many array elements without bytes")
    elif count * element_size > bytes_left:
        raise DecodeError("an array length greater than the bytes that are left")


def _compile(source: list[str], names: dict[str, Any], function: str) -> Any:
    exec(compile("\n".join(source), f"<{function}>", "exec"), names)  # Made of parsed names alone.
    return names[function]


class _Reader:
    """Writes the functions that read a struct."""

    def __init__(self, made: StructType, schema: Schema, codecs: dict[str, Codec]) -> None:
        self._struct = made
        self._schema = schema
        self._codecs = codecs
        self._lines: list[str] = []
        self._names: dict[str, Any] = {
            "texts": _texts.get,
            "text": _text,
            "bad_string": _bad_string,
        }
        self._letters = ""  # Of the numbers whose line is not written yet, and their variables.
        self._targets: list[str] = []

    def compile(self) -> tuple[ReadRow, ReadRows]:
        """Returns what reads one struct, and what reads several behind one another."""
        variables = {each.name: f"v{i}" for i, each in enumerate(self._struct.members)}
        for member in self._struct.members:
            self._add(member, variables)
        self._flush()
        values = "".join(each + ", " for each in variables.values())
        body = self._lines
        one = ["def read(b, p, e):", *body, f"  return ({values}), p"]
        many = ["def read_many(b, p, e, n_rows):", "  rows = []", "  add = rows.append"]
        many += ["  for _ in range(n_rows):", *("  " + line for line in body)]
        many += [f"    add(({values}))", "  return rows, p"]
        return _compile(one, self._names, "read"), _compile(many, self._names, "read_many")

    def _flush(self) -> None:
        if not self._targets:
            return
        compiled = struct.Struct(">" + self._letters)
        name = f"unpack{len(self._lines)}"
        self._names[name] = compiled.unpack_from
        self._lines.append(f"  {', '.join(self._targets)}, = {name}(b, p)")
        self._lines.append(f"  p += {compiled.size}")
        self._letters, self._targets = "", []

    def _add(self, member: Member, variables: dict[str, str]) -> None:
        variable = variables[member.name]
        letter = format_of(member)
        if letter is not None:
            self._letters += letter
            self._targets.append(variable)
        elif member.dimensions:
            self._flush()
            sizes = "".join(
                f"{each.size or variables[each.text]}, " for each in member.dimensions
            )
            self._names[f"array_{variable}"] = self._array_reader(member)
            call = f"  {variable}, p = array_{variable}(b, p, e, ({sizes}), 0)"
            if len(member.dimensions) == 1 and member.dimensions[0].size == 0:
                empty = 'b""' if is_bytes(member) else "[]"
                count = variables[member.dimensions[0].text]
                self._lines.append(f"  if {count} == 0: {variable} = {empty}")
                call = "  else:" + call
            self._lines.append(call)
        elif member.type_name == "string":
            self._letters += "i"
            self._targets.append("n")
            self._flush()
            self._lines += [
                "  q = p + n",
                "  if n < 1 or q > e or b[q - 1]: raise bad_string()",
                "  s = b[p:q - 1]",
                "  p = q",
                f"  {variable} = texts(s)",
                f"  if {variable} is None: {variable} = text(s)",
            ]
        else:
            self._flush()
            self._names[f"struct_{variable}"] = self._codecs[member.type_name]
            self._lines.append(f"  {variable}, p = struct_{variable}.read(b, p, e)")

    def _array_reader(self, member: Member) -> Callable[..., tuple[Any, int]]:
        """Returns a function of (bytes, begin, end, sizes, dimension) that reads from there in."""
        last = len(member.dimensions) - 1
        element_size = self._schema.min_size(member.type_name)
        letter = FORMATS.get(member.type_name)
        codec = self._codecs.get(member.type_name)

        def read_innermost(data: bytes, begin: int, end: int, count: int) -> tuple[Any, int]:
            if letter is not None:
                stop = begin + count * element_size
                if letter == "B":
                    return data[begin:stop], stop
                return list(struct.unpack_from(f">{count}{letter}", data, begin)), stop
            if codec is not None:
                return codec.read_many(data, begin, end, count)
            values = []
            for _ in range(count):
                value, begin = _read_string(data, begin, end)
                values.append(value)
            return values, begin

        def read_array(
            data: bytes, begin: int, end: int, sizes: tuple[int, ...], dimension: int
        ) -> tuple[Any, int]:
            count = sizes[dimension]
            size = element_size
            for inner in sizes[dimension + 1 :]:
                size *= max(inner, 0)
            _check_count(count, size, end - begin)
            if dimension == last:
                return read_innermost(data, begin, end, count)
            values = []
            for _ in range(count):
                value, begin = read_array(data, begin, end, sizes, dimension + 1)
                values.append(value)
            return values, begin

        return read_array


class _Writer:
    """Writes the function that writes one struct."""

    def __init__(self, made: StructType, codecs: dict[str, Codec]) -> None:
        self._struct = made
        self._codecs = codecs
        self._lines = ["def write(o, take):"]
        self._names: dict[str, Any] = {"take_text": _take_text, "inner_length": _inner_length}
        self._letters = ""
        self._values: list[str] = []

    def compile(self) -> WriteObject:
        lengths = {
            dimension.text
            for member in self._struct.members
            for dimension in member.dimensions
            if dimension.size == 0
        }
        for i, member in enumerate(self._struct.members):
            if member.name in lengths:
                self._lines.append(f"  n_{member.name} = {self._length_of(member.name)}")
                self._letters += format_of(member) or ""
                self._values.append(f"n_{member.name}")
            else:
                self._add(member, f"o.{attribute_name(member.name)}", i)
        self._flush()
        self._lines.append("  return None")
        made: WriteObject = _compile(self._lines, self._names, "write")
        return made

    def _flush(self) -> None:
        if not self._values:
            return
        name = f"pack{len(self._lines)}"
        self._names[name] = struct.Struct(">" + self._letters).pack
        self._lines.append(f"  take({name}({', '.join(self._values)}))")
        self._letters, self._values = "", []

    def _length_of(self, name: str) -> str:
        """Returns the expression for a length: of the array whose outermost dimension it is."""
        own = f"o.{attribute_name(name)}"
        inner = own
        for member in self._struct.members:
            value = f"o.{attribute_name(member.name)}"
            for depth, dimension in enumerate(member.dimensions):
                if dimension.text == name and depth == 0:
                    return f"len({value})"
                if dimension.text == name and inner == own:
                    inner = f"inner_length({value}, {depth}, {own})"
        return inner

    def _add(self, member: Member, value: str, number: int) -> None:
        letter = format_of(member)
        if letter is not None:
            self._letters += letter
            self._values.append(value)
            return
        self._flush()
        if member.dimensions:
            sizes = "".join(f"{each.size or 'n_' + each.text}, " for each in member.dimensions)
            self._names[f"array{number}"] = self._array_writer(member)
            self._lines.append(f"  array{number}({value}, ({sizes}), 0, take)")
        elif member.type_name == "string":
            self._lines.append(f"  take_text({value}, take)")
        else:
            self._names[f"struct{number}"] = self._codecs[member.type_name]
            self._lines.append(f"  struct{number}.write_members({value}, take)")

    def _array_writer(self, member: Member) -> Callable[..., None]:
        last = len(member.dimensions) - 1
        letter = FORMATS.get(member.type_name)
        codec = self._codecs.get(member.type_name)

        def write_array(
            values: Any, sizes: tuple[int, ...], dimension: int, take: Callable[[bytes], None]
        ) -> None:
            if len(values) != sizes[dimension]:
                raise ValueError(
                    f"{self._struct.full_name}: '{member.name}' has {len(values)} elements where "
                    f"{sizes[dimension]} belong"
                )
            if dimension < last:
                for each in values:
                    write_array(each, sizes, dimension + 1, take)
            elif letter == "B":
                take(bytes(values))
            elif letter is not None:
                take(struct.pack(f">{len(values)}{letter}", *values))
            else:
                for each in values:
                    if codec is None:
                        _take_text(each, take)
                    else:
                        codec.write_members(each, take)

        return write_array


def _take_text(text: str, take: Callable[[bytes], None]) -> None:
    data = text.encode()
    if b"\0" in data:
        raise ValueError("a text with a NUL inside")
    take(_LENGTH.pack(len(data) + 1) + data + b"\0")


def _inner_length(values: Any, depth: int, otherwise: int) -> int:
    """Returns the length of a dimension further in; `otherwise` where an outer one is empty."""
    for _ in range(depth):
        if len(values) == 0:
            return otherwise
        values = values[0]
    return len(values)


def make_codecs(schema: Schema, special: dict[str, type[Codec]]) -> dict[str, Codec]:
    """Returns the codecs of all structs of a schema, by full name; `special`: their classes."""
    codecs: dict[str, Codec] = {}
    for name, made in schema.structs.items():
        codecs[name] = special.get(name, Codec)(codecs, schema, made)
    return codecs


def is_bytes(member: Member) -> bool:
    """Returns true for `byte x[n]`."""
    return member.type_name == "byte" and len(member.dimensions) == 1


assert set(FORMATS) | {"string"} == set(PRIMITIVE_SIZES)
