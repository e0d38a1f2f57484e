#include "lib/base/schema/walk.h"

#include <bit>
#include <cstring>
#include <type_traits>
#include <vector>

namespace shoal {

namespace {

constexpr size_t kFingerprintSize = 8;
// Array elements that take no bytes (those of `x[n][m]` with m = 0, and empty structs) would let a
// short message ask for 2^31 of them. A message may have this many, and one more for each byte.
constexpr int64_t kFreeEmptyElements = 4096;

template <class T>
T ReadBigEndian(const uint8_t* bytes) {
  T value = 0;
  std::memcpy(&value, bytes, sizeof value);
  if constexpr (std::endian::native == std::endian::big) return value;
  if constexpr (sizeof value == 2) return __builtin_bswap16(value);
  if constexpr (sizeof value == 4) return __builtin_bswap32(value);
  return static_cast<T>(__builtin_bswap64(value));
}

uint64_t ReadBigEndian(const uint8_t* bytes, int64_t num_bytes) {
  switch (num_bytes) {
    case 1:
      return bytes[0];
    case 2:
      return ReadBigEndian<uint16_t>(bytes);
    case 4:
      return ReadBigEndian<uint32_t>(bytes);
    default:
      return ReadBigEndian<uint64_t>(bytes);
  }
}

/// Takes the place of a Visitor where there is none.
struct NoListener {
  void StructBegin(const StructType&) {}
  void StructEnd() {}
  void MemberBegin(const Member&) {}
  void ArrayBegin(int64_t) {}
  void ArrayEnd() {}
  void Value(const Scalar&) {}
};

template <class Listener>
class Walker {
 public:
  Walker(const Schema& schema, std::span<const uint8_t> message, Listener* listener)
      : types_(schema.types()),
        bytes_(message),
        listener_(*listener),
        empty_elements_left_(kFreeEmptyElements + static_cast<int64_t>(message.size())) {}

  std::optional<WireFault> Run(const StructType& type) {
    const auto fingerprint = FingerprintOf(bytes_);
    if (!fingerprint) return WireFault{bytes_.size(), "too short for a fingerprint"};
    if (*fingerprint != type.fingerprint) return WireFault{0, "the fingerprint of another type"};
    position_ = kFingerprintSize;
    if (WalkStruct(type, 0) && position_ != bytes_.size()) Fail("bytes behind the message's end");
    return fault_;
  }

 private:
  static constexpr bool kHasListener = !std::is_same_v<Listener, NoListener>;

  int64_t BytesLeft() const { return static_cast<int64_t>(bytes_.size() - position_); }

  bool Fail(std::string_view what) {
    fault_ = WireFault{position_, what};
    return false;
  }

  bool WalkStruct(const StructType& type, int depth) {
    if (depth > kMaxStructDepth) return Fail("structs inside one another without end");
    if (type.min_wire_size > BytesLeft()) return Fail("the message ends too early");
    if constexpr (!kHasListener) {
      if (type.has_fixed_size) {
        position_ += static_cast<size_t>(type.min_wire_size);
        return true;
      }
    }
    const size_t lengths_begin = lengths_.size();
    lengths_.resize(lengths_begin + type.num_lengths);
    listener_.StructBegin(type);
    for (size_t i = 0; i < type.members.size(); ++i) {
      const Member& member = type.members[i];
      if (!kHasListener && member.num_fixed_run > 0) {
        if (member.fixed_run_size > BytesLeft()) return Fail("the message ends too early");
        position_ += static_cast<size_t>(member.fixed_run_size);
        i += member.num_fixed_run - 1;
        continue;
      }
      listener_.MemberBegin(member);
      if (!WalkArray(member, 0, lengths_begin, depth)) return false;
    }
    listener_.StructEnd();
    lengths_.resize(lengths_begin);
    return true;
  }

  int64_t SizeOf(const Dimension& dimension, size_t lengths_begin) const {
    return dimension.is_variable() ? lengths_[lengths_begin + dimension.length_slot]
                                   : dimension.fixed_size;
  }

  /// Returns the least number of bytes of one element of dimension `d`, or more than are left.
  int64_t MinSizeInside(const Member& member, size_t d, size_t lengths_begin) const {
    int64_t size = member.min_wire_size;
    for (size_t inner = d + 1; inner < member.dimensions.size(); ++inner) {
      const int64_t count = SizeOf(member.dimensions[inner], lengths_begin);
      if (count <= 0) return 0;
      if (__builtin_mul_overflow(size, count, &size)) return BytesLeft() + 1;
    }
    return size;
  }

  /// Walks a member's value from its dimension `d` inwards.
  bool WalkArray(const Member& member, size_t d, size_t lengths_begin, int depth) {
    if (d == member.dimensions.size()) return WalkElement(member, lengths_begin, depth);
    const int64_t count = SizeOf(member.dimensions[d], lengths_begin);
    if (count < 0) return Fail("a negative array length");
    const int64_t min_size = MinSizeInside(member, d, lengths_begin);
    if (min_size == 0) {
      if (count > empty_elements_left_) return Fail("too many array elements without bytes");
      empty_elements_left_ -= count;
    } else if (count > BytesLeft() / min_size) {
      return Fail("an array length greater than the bytes that are left");
    }
    if (JumpOver(member, d, count, min_size)) return true;
    listener_.ArrayBegin(count);
    for (int64_t i = 0; i < count; ++i) {
      if (!WalkArray(member, d + 1, lengths_begin, depth)) return false;
    }
    listener_.ArrayEnd();
    return true;
  }

  /// Passes the innermost dimension at once where there is no visitor and the elements have one
  /// size.
  bool JumpOver(const Member& member, size_t d, int64_t count, int64_t element_size) {
    if (kHasListener || d + 1 != member.dimensions.size()) return false;
    if (!member.has_fixed_size) return false;
    position_ += static_cast<size_t>(count * element_size);
    return true;
  }

  bool WalkElement(const Member& member, size_t lengths_begin, int depth) {
    if (!member.primitive) return WalkStruct(types_[member.struct_index], depth + 1);
    const int64_t size = member.min_wire_size;
    if (size > BytesLeft()) return Fail("the message ends too early");
    if (*member.primitive == Primitive::kString) return WalkString();
    const uint64_t bits = ReadBigEndian(bytes_.data() + position_, size);
    position_ += static_cast<size_t>(size);
    if (!kHasListener && !member.length_slot) return true;
    const Scalar value = ScalarOf(*member.primitive, bits);
    if (member.length_slot)
      lengths_[lengths_begin + *member.length_slot] = std::get<int64_t>(value);
    listener_.Value(value);
    return true;
  }

  static Scalar ScalarOf(Primitive primitive, uint64_t bits) {
    switch (primitive) {
      case Primitive::kInt8:
        return int64_t{static_cast<int8_t>(bits)};
      case Primitive::kInt16:
        return int64_t{static_cast<int16_t>(bits)};
      case Primitive::kInt32:
        return int64_t{static_cast<int32_t>(bits)};
      case Primitive::kInt64:
      case Primitive::kByte:
        return static_cast<int64_t>(bits);
      case Primitive::kFloat:
        return std::bit_cast<float>(static_cast<uint32_t>(bits));
      case Primitive::kDouble:
        return std::bit_cast<double>(bits);
      case Primitive::kBoolean:
        return bits != 0;
      case Primitive::kString:
        break;
    }
    SHOAL_CHECK(false, "every type but a string has a fixed number of bits");
  }

  /// @pre at least five bytes are left.
  bool WalkString() {
    const auto size = static_cast<int32_t>(ReadBigEndian<uint32_t>(bytes_.data() + position_));
    if (size < 1) return Fail("a string without its NUL");
    if (size > BytesLeft() - 4) return Fail("a string longer than the bytes that are left");
    const auto* text = reinterpret_cast<const char*>(bytes_.data() + position_ + 4);
    const auto length = static_cast<size_t>(size) - 1;
    // LCM encodes a string up to its first NUL but reserves room for all of it: one with a NUL
    // inside could be decoded, and never be encoded again.
    if (std::memchr(text, 0, length + 1) != text + length) {
      return Fail("a string whose NUL is not at its end");
    }
    position_ += 4 + length + 1;
    listener_.Value(std::string_view(text, length));
    return true;
  }

  const std::vector<StructType>& types_;
  const std::span<const uint8_t> bytes_;
  Listener& listener_;
  int64_t empty_elements_left_;
  size_t position_ = 0;
  std::vector<int64_t> lengths_;  ///< Of the structs that are open, outermost first.
  std::optional<WireFault> fault_;
};

}  // namespace

std::optional<int64_t> FingerprintOf(std::span<const uint8_t> message) {
  if (message.size() < kFingerprintSize) return std::nullopt;
  return static_cast<int64_t>(ReadBigEndian<uint64_t>(message.data()));
}

std::optional<WireFault> Walk(const Schema& schema, const StructType& type,
                              std::span<const uint8_t> message, Visitor* visitor) {
  return Walker<Visitor>(schema, message, visitor).Run(type);
}

std::optional<WireFault> FindWireFault(const Schema& schema, const StructType& type,
                                       std::span<const uint8_t> message) {
  NoListener none;
  return Walker<NoListener>(schema, message, &none).Run(type);
}

}  // namespace shoal
