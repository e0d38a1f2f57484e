// The wire format of Protocol Buffers (protobuf.dev/programming-guides/encoding), as far as writing
// needs it. Values of 0 and empty texts are left out, as proto3 has it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace shoal {

enum class ProtoWireType : uint32_t { kVarint = 0, kFixed64 = 1, kLength = 2, kFixed32 = 5 };

inline void AppendVarint(uint64_t value, std::string* out) {
  char bytes[10];
  size_t size = 0;
  for (; value >= 0x80; value >>= 7) bytes[size++] = static_cast<char>(value | 0x80);
  bytes[size++] = static_cast<char>(value);
  out->append(bytes, size);
}

inline void AppendProtoTag(uint32_t field, ProtoWireType type, std::string* out) {
  AppendVarint(uint64_t{field} << 3 | static_cast<uint32_t>(type), out);
}

/// Appends the bytes of a number as little-endian machines have them.
template <class T>
void AppendLittleEndian(T value, std::string* out) {
  static_assert(std::endian::native == std::endian::little);
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out->append(bytes, sizeof value);
}

/// Returns small numbers for small negative ones: sint32 and sint64.
inline uint64_t ZigZag(int64_t value) {
  return static_cast<uint64_t>(value) << 1 ^ static_cast<uint64_t>(value >> 63);
}

inline void AppendProtoVarint(uint32_t field, uint64_t value, std::string* out) {
  if (value == 0) return;
  AppendProtoTag(field, ProtoWireType::kVarint, out);
  AppendVarint(value, out);
}

/// -0.0 is written: it is not the value that is left out.
inline void AppendProtoDouble(uint32_t field, double value, std::string* out) {
  if (std::bit_cast<uint64_t>(value) == 0) return;
  AppendProtoTag(field, ProtoWireType::kFixed64, out);
  AppendLittleEndian(value, out);
}

/// Appends text or bytes, empty ones too.
inline void AppendProtoBytes(uint32_t field, std::string_view bytes, std::string* out) {
  AppendProtoTag(field, ProtoWireType::kLength, out);
  AppendVarint(bytes.size(), out);
  out->append(bytes);
}

inline void AppendProtoText(uint32_t field, std::string_view text, std::string* out) {
  if (!text.empty()) AppendProtoBytes(field, text, out);
}

/// Leaves room for the length of what follows, and returns where; EndProtoLength writes it.
inline size_t BeginProtoLength(std::string* out) {
  out->push_back(0);
  return out->size();
}

/// @pre BeginProtoLength returned `begin`, and nothing before it has changed.
inline void EndProtoLength(size_t begin, std::string* out) {
  const size_t size = out->size() - begin;
  if (size < 0x80) {
    (*out)[begin - 1] = static_cast<char>(size);
    return;
  }
  std::string length;
  AppendVarint(size, &length);
  out->replace(begin - 1, 1, length);
}

/// Appends a message whose members `write()` appends to `out`.
template <class Write>
void AppendProtoMessage(uint32_t field, std::string* out, const Write& write) {
  AppendProtoTag(field, ProtoWireType::kLength, out);
  const size_t begin = BeginProtoLength(out);
  write();
  EndProtoLength(begin, out);
}

}  // namespace shoal
