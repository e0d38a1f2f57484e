#include "lib/base/random/stream.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr uint64_t kIntegerTag = 1;
constexpr uint64_t kTextTag = 2;

/// "shoalkey" in ASCII: sets the hash apart from every other use of Philox.
constexpr PhiloxKey kHashKey = {0x73686f61, 0x6c6b6579};

uint32_t LowHalf(uint64_t word) { return static_cast<uint32_t>(word); }
uint32_t HighHalf(uint64_t word) { return static_cast<uint32_t>(word >> 32); }
uint64_t Join(uint32_t low, uint32_t high) { return uint64_t{high} << 32 | low; }

}  // namespace

StreamKey::StreamKey(uint64_t seed, std::string_view purpose) {
  Absorb(seed, kIntegerTag);
  *this = With(purpose);
}

StreamKey StreamKey::With(std::string_view id) const {
  StreamKey key = *this;
  const uint64_t tag = kTextTag + (static_cast<uint64_t>(id.size()) << 8);
  size_t begin = 0;
  do {
    uint64_t word = 0;
    const size_t end = std::min(id.size(), begin + 8);
    for (size_t i = end; i > begin; --i) word = word << 8 | static_cast<uint8_t>(id[i - 1]);
    key.Absorb(word, tag);
    begin += 8;
  } while (begin < id.size());
  return key;
}

StreamKey StreamKey::WithWord(uint64_t word) const {
  StreamKey key = *this;
  key.Absorb(word, kIntegerTag);
  return key;
}

void StreamKey::Absorb(uint64_t word, uint64_t tag) {
  low_ ^= word;
  high_ ^= tag;
  const PhiloxCounter mixed =
      Philox4x32({LowHalf(low_), HighHalf(low_), LowHalf(high_), HighHalf(high_)}, kHashKey);
  low_ = Join(mixed[0], mixed[1]);
  high_ = Join(mixed[2], mixed[3]);
}

// Half of the stream's name is Philox's key, the other half the upper part of its counter; the
// lower part counts blocks.
uint64_t Stream::Bits() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_bits_;
  }
  const PhiloxCounter bits =
      Philox4x32({LowHalf(block_), HighHalf(block_), LowHalf(key_.high()), HighHalf(key_.high())},
                 {LowHalf(key_.low()), HighHalf(key_.low())});
  ++block_;
  spare_bits_ = Join(bits[2], bits[3]);
  has_spare_ = true;
  return Join(bits[0], bits[1]);
}

double Stream::Uniform() { return static_cast<double>(Bits() >> 11) * 0x1p-53; }

uint64_t Stream::UniformInt(uint64_t count) {
  SHOAL_CHECK(count > 0, "count > 0");
  if (count == 1) return 0;
  const int unused_bits = std::countl_zero(count - 1);
  for (;;) {  // At least every second try succeeds.
    const uint64_t candidate = Bits() >> unused_bits;
    if (candidate < count) return candidate;
  }
}

// Box and Muller (1958), one branch: every draw takes two uniforms, whatever came before.
double Stream::Normal() {
  const double radius = std::sqrt(-2 * Log(1 - Uniform()));
  return radius * Cos(2 * std::numbers::pi * Uniform());
}

}  // namespace shoal
