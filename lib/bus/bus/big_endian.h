// Numbers on the wire: the most significant byte comes first, as in LCM's own messages.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace shoal {

/// Returns the number that up to eight bytes make.
inline uint64_t ReadBigEndian(std::span<const uint8_t> bytes) {
  uint64_t value = 0;
  for (const uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

/// Appends the lowest `num_bytes` bytes of a number.
inline void AppendBigEndian(uint64_t value, int num_bytes, std::vector<uint8_t>* out) {
  for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) {
    out->push_back(static_cast<uint8_t>(value >> shift));
  }
}

}  // namespace shoal
