// Names the arithmetic of a program: a digest of results that every build of shoal must agree on.
//
// Two builds with the same id and the same version give the same log, whatever their compilers and
// processors. What differs where the id does: the sources of vendor/musl, or how a compiler or a
// processor rounds (multiplications fused with additions, higher precision between).
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace shoal {

/// FNV-1a, 64 bits, of the bits of numbers.
class BitsDigest {
 public:
  void Add(double x) {
    constexpr uint64_t kPrime = 1099511628211U;
    const auto bits = std::bit_cast<uint64_t>(x);
    for (int shift = 0; shift < 64; shift += 8) {
      state_ = (state_ ^ ((bits >> shift) & 0xffU)) * kPrime;
    }
  }
  [[nodiscard]] uint64_t value() const { return state_; }

 private:
  uint64_t state_ = 14695981039346656037U;
};

/// A fixed sequence of numbers in [0, 1), of 53 bits each (SplitMix64: Steele, Lea and Flood,
/// OOPSLA 2014).
class FixedSequence {
 public:
  explicit FixedSequence(uint64_t start) : state_(start) {}
  double Next() {
    state_ += 0x9e3779b97f4a7c15U;
    uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }

 private:
  uint64_t state_;
};

/// Returns 16 hexadecimal digits. The work is done at the first call: well under a millisecond.
[[nodiscard]] std::string ArithmeticId();

}  // namespace shoal
