"""Messages as objects: one class for each struct, with the members as attributes.

    nav = shoal.types.nav_t(utime=5, x_m=1.5)
    data = nav.encode()
    shoal.types.decode(data).x_m
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from .codec import Codec, Row
from .lcm_file import Member

_M = TypeVar("_M", bound="Message")


class Message:
    """The base of all message classes.

    A class takes its members by keyword, all others are 0, empty, or such structs. Lengths of
    arrays need not be set: encode() takes those that the arrays have.
    """

    __slots__ = ()
    _codec: ClassVar[Codec]
    _classes: ClassVar[dict[str, type[Message]]]  # Of all structs of its types.

    #: The full name, such as "shoal.nav_t".
    TYPE: ClassVar[str]
    #: The first eight bytes of each message, as an unsigned number.
    FINGERPRINT: ClassVar[int]

    def __init__(self, **members: Any) -> None:
        for member, name in zip(self._codec.struct.members, self._codec.attributes, strict=True):
            value = members.pop(name) if name in members else self._default(member, 0)
            setattr(self, name, value)
        if members:
            known = ", ".join(self._codec.attributes)
            raise TypeError(f"{self.TYPE} has no member '{next(iter(members))}'; it has {known}")

    @classmethod
    def _default(cls, member: Member, dimension: int) -> Any:
        if dimension < len(member.dimensions):
            size = member.dimensions[dimension].size
            if member.type_name == "byte" and dimension == len(member.dimensions) - 1:
                return bytes(size)
            return [cls._default(member, dimension + 1) for _ in range(size)]
        if not member.is_primitive:
            return cls._classes[member.type_name]()
        if member.type_name == "string":
            return ""
        if member.type_name in ("float", "double"):
            return 0.0
        return False if member.type_name == "boolean" else 0

    @classmethod
    def decode(cls: type[_M], data: bytes) -> _M:
        """Returns the message of these bytes. Raises DecodeError."""
        data = bytes(data)
        return cls._from_row(cls._codec.read_message(data, 0, len(data)))

    def encode(self) -> bytes:
        """Returns the bytes of the message. Raises ValueError for what a member cannot hold."""
        return self._codec.write_message(self)

    @classmethod
    def _from_row(cls: type[_M], row: Row) -> _M:
        made = cls.__new__(cls)
        for member, name, value in zip(
            cls._codec.struct.members, cls._codec.attributes, row, strict=True
        ):
            if not member.is_primitive:
                value = cls._nested(cls._classes[member.type_name], value, len(member.dimensions))
            setattr(made, name, value)
        return made

    @classmethod
    def _nested(cls, nested: type[Message], value: Any, num_dimensions: int) -> Any:
        if num_dimensions == 0:
            return nested._from_row(value)
        return [cls._nested(nested, each, num_dimensions - 1) for each in value]

    def __eq__(self, other: object) -> bool:
        """Compares all members but the lengths of arrays, which the arrays have themselves."""
        if not isinstance(other, Message) or other.TYPE != self.TYPE:
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self._codec.content)

    __hash__ = None  # type: ignore[assignment]  # Members change.

    def __repr__(self) -> str:
        members = ", ".join(f"{name}={getattr(self, name)!r}" for name in self._codec.attributes)
        return f"{type(self).__name__}({members})"

    if TYPE_CHECKING:  # The members.

        def __getattr__(self, name: str) -> Any: ...

        def __setattr__(self, name: str, value: Any) -> None: ...


def make_class(codec: Codec, classes: dict[str, type[Message]]) -> type[Message]:
    """Returns the class of one struct; `classes` is filled with all before the first use."""
    struct = codec.struct
    body: dict[str, Any] = {
        "__slots__": codec.attributes,
        "__doc__": f"The message {struct.full_name}: {', '.join(codec.attributes)}.",
        "__module__": "shoal.types",
        "_codec": codec,
        "_classes": classes,
        "TYPE": struct.full_name,
        "FINGERPRINT": codec.fingerprint,
    }
    for name, value in struct.constants.items():
        body.setdefault(name, value)
    return type(struct.name, (Message,), body)
