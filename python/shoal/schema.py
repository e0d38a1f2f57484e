"""The structure of LCM messages: structs that know one another, their fingerprints and sizes."""

from __future__ import annotations

from collections.abc import Iterable

from .errors import LcmFileError
from .lcm_file import PRIMITIVE_SIZES, Member, StructType

MAX_DEPTH = 64  #: Structs that are nested deeper are refused.
_MASK = 2**64 - 1
_HUGE = 2**61  #: Sizes stop here; no message is that long.
_MOST_VISITS = 1_000_000  #: Types that nest without end stop here.


def _mix(hash_: int, value: int) -> int:
    """LCM's hash (lcm-gen 1.3.1); `value` is a signed char."""
    shifted = hash_ >> 55
    if hash_ >> 63:
        shifted |= _MASK & ~(2**9 - 1)  # The shift is arithmetic.
    return ((((hash_ << 8) & _MASK) ^ shifted) + value) & _MASK


def _signed_char(value: int) -> int:
    value &= 0xFF
    return value - 256 if value > 127 else value


def _mix_text(hash_: int, text: str) -> int:
    data = text.encode()
    hash_ = _mix(hash_, _signed_char(len(data)))
    for byte in data:
        hash_ = _mix(hash_, _signed_char(byte))
    return hash_


def _own_hash(struct: StructType) -> int:
    """Returns LCM's hash of a struct's members, without those of nested structs."""
    hash_ = 0x12345678
    for member in struct.members:
        hash_ = _mix_text(hash_, member.name)
        if member.is_primitive:
            hash_ = _mix_text(hash_, member.type_name)
        hash_ = _mix(hash_, _signed_char(len(member.dimensions)))
        for dimension in member.dimensions:
            hash_ = _mix(hash_, 0 if dimension.size else 1)
            hash_ = _mix_text(hash_, dimension.text)
    return hash_


class Schema:
    """Structs by name, with what follows from knowing them all."""

    def __init__(self, structs: Iterable[StructType]) -> None:
        """Leaves out structs with a member of a struct that is not there, and those that hold them.

        Raises LcmFileError where two structs of one name differ.
        """
        self.structs: dict[str, StructType] = {}
        for struct in structs:
            known = self.structs.setdefault(struct.full_name, struct)
            if known is not struct and known.members != struct.members:
                raise LcmFileError(f"struct {struct.full_name} is there twice, with other members")
        #: Those left out, by full name, each with a sentence: the reason and the remedy.
        self.left_out: dict[str, str] = {}
        while self._leave_out_incomplete():
            pass  # Each pass finds the structs that hold one of the pass before.
        self._own_hashes = {name: _own_hash(each) for name, each in self.structs.items()}
        self._min_sizes: dict[str, int] = {}
        for name in self.structs:
            self._measure(name, 0)

    def _leave_out_incomplete(self) -> bool:
        """Returns whether there was one."""
        count = len(self.left_out)
        for name, struct in list(self.structs.items()):
            for member in struct.members:
                if member.is_primitive or member.type_name in self.structs:
                    continue
                self.left_out[name] = (
                    f"struct {name} is left out: its member '{member.name}' has the unknown type "
                    f"{member.type_name}; give the .lcm file that declares it, too"
                )
                del self.structs[name]
                break
        return len(self.left_out) > count

    def fingerprint(self, name: str) -> int:
        """Returns the first eight bytes of each message of the struct, as an unsigned number."""
        self._visits_left = _MOST_VISITS
        return self._fingerprint(name, ())

    def _fingerprint(self, name: str, parents: tuple[str, ...]) -> int:
        if name in parents:
            return 0
        self._visits_left -= 1
        if self._visits_left < 0 or len(parents) > 4 * MAX_DEPTH:
            raise LcmFileError(f"struct {name} nests too many structs")
        hash_ = self._own_hashes[name]
        for member in self.structs[name].members:
            if not member.is_primitive:
                hash_ += self._fingerprint(member.type_name, (*parents, name))
        hash_ &= _MASK
        return ((hash_ << 1) + (hash_ >> 63)) & _MASK

    def min_size(self, type_name: str) -> int:
        """Returns the least number of bytes of a primitive or a struct, without fingerprint."""
        if type_name in PRIMITIVE_SIZES:
            return PRIMITIVE_SIZES[type_name]
        return self._min_sizes.get(type_name, 0)

    def min_member_size(self, member: Member) -> int:
        """Returns the least number of bytes of a member; 0 where it is a variable array."""
        size = self.min_size(member.type_name)
        for dimension in member.dimensions:
            size = min(size * dimension.size, _HUGE)
        return size

    def _measure(self, name: str, depth: int) -> int:
        if name in self._min_sizes:
            return self._min_sizes[name]
        if depth > MAX_DEPTH:
            raise LcmFileError(
                f"struct {name} contains itself, or nests deeper than {MAX_DEPTH} structs; let a "
                "variable array end it"
            )
        size = 0
        for member in self.structs[name].members:
            if any(dimension.size == 0 for dimension in member.dimensions):
                continue
            if not member.is_primitive:
                self._measure(member.type_name, depth + 1)
            size = min(size + self.min_member_size(member), _HUGE)
        self._min_sizes[name] = size
        return size
