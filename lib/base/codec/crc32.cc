#include "lib/base/codec/crc32.h"

#include <array>

namespace shoal {

namespace {

constexpr uint32_t kReflectedPolynomial = 0xEDB88320;

/// What each byte does to the remainder.
constexpr std::array<uint32_t, 256> kTable = [] {
  std::array<uint32_t, 256> table = {};
  for (uint32_t byte = 0; byte < table.size(); ++byte) {
    uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? kReflectedPolynomial : 0);
    }
    table[byte] = remainder;
  }
  return table;
}();

}  // namespace

uint32_t Crc32(std::span<const uint8_t> bytes) {
  uint32_t remainder = 0xFFFFFFFF;
  for (const uint8_t byte : bytes) {
    remainder = (remainder >> 8) ^ kTable[(remainder ^ byte) & 0xFF];
  }
  return ~remainder;
}

}  // namespace shoal
