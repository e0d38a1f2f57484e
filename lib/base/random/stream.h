// Random numbers that depend on what they are for, and on nothing else.
//
//   Stream stream(mission.seed, "blackout", "alpha", report_number);
//   const double delay_s = 2 * stream.Uniform();
//
// A stream is named by the mission's seed, a purpose and ids: a link's two ends, a packet's number.
// Streams of different names are independent, so that one more vehicle, receiver or draw changes no
// other numbers. Where many streams share the front of their names, hash that once:
//
//   const StreamKey link = StreamKey(seed, "loss").With("alpha").With("bravo");
//   for (int64_t number ...) Stream(link.With(number)).Uniform();
//
// The distributions are our own (those that are discrete: lib/base/random/discrete.h): those of the
// standard library differ between libraries.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "lib/base/random/philox.h"

namespace shoal {

/// A stream's name as 128 bits. The hash, part of the contract because recorded missions depend on
/// it: the state starts at zero; each part is cut into 64-bit words w_1 .. w_n; for each the state
/// becomes Philox4x32(state xor (w_i, tag)) under the fixed key of stream.cc. An integer is one
/// word with tag 1. A text of n bytes is max(1, ceil(n / 8)) words, bytes little-endian and padded
/// with zeros, with tag 2 + 256 n. Tags mark where a part ends, so ("ab", "c") is not ("a", "bc").
class StreamKey {
 public:
  StreamKey(uint64_t seed, std::string_view purpose);

  [[nodiscard]] StreamKey With(std::string_view id) const;
  [[nodiscard]] StreamKey With(std::integral auto id) const {
    return WithWord(static_cast<uint64_t>(id));
  }

  uint64_t low() const { return low_; }
  uint64_t high() const { return high_; }

 private:
  [[nodiscard]] StreamKey WithWord(uint64_t word) const;
  void Absorb(uint64_t word, uint64_t tag);

  uint64_t low_ = 0;
  uint64_t high_ = 0;
};

class Stream {
 public:
  /// Starts the stream of this name at its first number.
  explicit Stream(const StreamKey& key) : key_(key) {}
  template <class... Ids>
  Stream(uint64_t seed, std::string_view purpose, const Ids&... ids)
      : Stream(Extend(StreamKey(seed, purpose), ids...)) {}

  /// Returns 64 random bits.
  uint64_t Bits();
  /// Returns a multiple of 2^-53 in [0, 1).
  double Uniform();
  /// Returns an integer in [0, count). @pre count > 0
  uint64_t UniformInt(uint64_t count);
  /// Returns a draw from the normal distribution of mean 0 and variance 1.
  double Normal();

 private:
  static StreamKey Extend(const StreamKey& key) { return key; }
  template <class First, class... Others>
  static StreamKey Extend(const StreamKey& key, const First& first, const Others&... others) {
    return Extend(key.With(first), others...);
  }

  StreamKey key_;
  uint64_t block_ = 0;       ///< Number of the next block of 128 bits.
  uint64_t spare_bits_ = 0;  ///< Second half of the last block.
  bool has_spare_ = false;
};

}  // namespace shoal
